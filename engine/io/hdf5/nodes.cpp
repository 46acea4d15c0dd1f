// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/hdf5/nodes.h"

#include "core/parallel.h"
#include "io/file/compress.h"

#include <algorithm>
#include <cassert>

namespace sphinx::io::hdf5 {
namespace {

std::size_t product(const Dimensions& shape) {
    std::size_t result = 1;
    for (const std::uint64_t n : shape) result *= n;
    return result;
}

Dimensions withRows(std::uint64_t rows, const Dimensions& row_shape) {
    Dimensions shape{rows};
    shape.insert(shape.end(), row_shape.begin(), row_shape.end());
    return shape;
}

}  // namespace

Address ObjectNode::storeHeader(SafeFile& file, const std::string& header) {
    if (address_ != undefined_address) file.release(address_, size_);
    size_ = header.size();
    address_ = file.store(header);
    changed_ = false;
    return address_;
}

Address Group::store(SafeFile& file) {
    for (auto& [name, member] : members_) {
        const Address address = member.node->store(file);
        changed_ = changed_ || address != member.address;
        member.address = address;
    }
    if (!changed_) return address_;
    std::vector<Link> links;
    for (const auto& [name, member] : members_) links.push_back({name, member.address});
    return storeHeader(file, groupObject(links, attributes_));
}

Address SmallArray::store(SafeFile& file) {
    if (!changed_) return address_;
    if (stored_bytes_ > 0) file.release(data_, stored_bytes_);
    stored_bytes_ = bytes_.size();
    Storage storage;
    storage.bytes = stored_bytes_;
    storage.address = data_ = bytes_.empty() ? undefined_address : file.store(bytes_);
    const std::uint64_t rows = bytes_.size() / (bytesOf(type_) * product(row_shape_));
    return storeHeader(file,
                       datasetObject(type_, withRows(rows, row_shape_), storage, attributes_));
}

ChunkedArray::ChunkedArray(Number type, Dimensions row_shape, std::uint32_t chunk_rows,
                           bool filtered)
    : type_(type),
      row_shape_(std::move(row_shape)),
      chunk_rows_(chunk_rows),
      filtered_(filtered),
      row_bytes_(bytesOf(type) * product(row_shape_)) {}

std::uint64_t ChunkedArray::appendChunks(SafeFile& file, std::string_view rows) {
    assert(filtered_);
    const std::uint64_t first_row = std::uint64_t{chunk_rows_} * chunks_.size();
    const std::size_t chunk_bytes = chunk_rows_ * row_bytes_;
    const std::size_t count = (rows.size() + chunk_bytes - 1) / chunk_bytes;
    std::vector<std::string> stored(count);
    parallelFor(
        count,
        [&](std::size_t c) {
            std::string chunk(rows.substr(c * chunk_bytes, chunk_bytes));
            chunk.resize(chunk_bytes);
            stored[c] = compress(shuffle(chunk, bytesOf(type_)));
        },
        1);
    for (const std::string& chunk : stored)
        chunks_.push_back({file.store(chunk), static_cast<std::uint32_t>(chunk.size())});
    rows_ = first_row + rows.size() / row_bytes_;
    changed_ = chunks_changed_ = true;
    return first_row;
}

void ChunkedArray::appendRow(SafeFile& file, std::string_view row) {
    assert(!filtered_ && row.size() == row_bytes_);
    if (rows_ == std::uint64_t{chunk_rows_} * chunks_.size()) {
        const std::uint64_t chunk_bytes = chunk_rows_ * row_bytes_;
        chunks_.push_back({file.reserve(chunk_bytes), static_cast<std::uint32_t>(chunk_bytes)});
        chunks_changed_ = true;
    }
    file.writeAt(chunks_.back().address + rows_ % chunk_rows_ * row_bytes_, row);
    ++rows_;
    changed_ = true;
}

void ChunkedArray::adopt(std::vector<Chunk> chunks, std::uint32_t chunk_rows, std::uint64_t rows) {
    chunks_ = std::move(chunks);
    chunks_.resize((rows + chunk_rows - 1) / chunk_rows);
    chunk_rows_ = chunk_rows;
    rows_ = rows;
    changed_ = chunks_changed_ = true;
}

Address ChunkedArray::store(SafeFile& file) {
    if (!changed_) return address_;
    const Dimensions shape = withRows(rows_, row_shape_);
    if (chunks_changed_) {
        file.release(index_, index_bytes_);
        index_bytes_ = chunkIndexSize(chunks_.size(), shape.size());
        index_ = file.reserve(index_bytes_);
        file.writeAt(index_, chunkIndex(chunks_, chunk_rows_, shape.size(), index_));
        chunks_changed_ = false;
    }
    Storage storage;
    storage.chunked = true;
    storage.chunk_rows = chunk_rows_;
    storage.filtered = filtered_;
    if (!chunks_.empty())
        storage.address = index_ + index_bytes_ - chunkIndexNodeSize(shape.size());
    return storeHeader(file, datasetObject(type_, shape, storage, attributes_));
}

std::uint32_t chunkRowsFor(std::uint64_t rows) {
    constexpr std::uint64_t most = 65536;
    const std::uint64_t chunks = std::max<std::uint64_t>((rows + most - 1) / most, 1);
    return static_cast<std::uint32_t>(std::max<std::uint64_t>((rows + chunks - 1) / chunks, 1));
}

void commit(SafeFile& file, Group& root, bool durable) { file.commit(root.store(file), durable); }

}  // namespace sphinx::io::hdf5
