// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/hdf5/file.h"

#include <map>
#include <memory>
#include <string>

namespace sphinx::io::hdf5 {

/// Something in the file that has a name. Changes stay in memory until store().
class Node {
 public:
    virtual ~Node() = default;
    /// Writes what changed since the last call; returns where the object now stands.
    virtual Address store(SafeFile& file) = 0;
};

/// An object that will not change any more; all that is left in memory is its address.
class StoredNode final : public Node {
 public:
    explicit StoredNode(Address address) : address_(address) {}
    Address store(SafeFile&) override { return address_; }

 private:
    Address address_;
};

/// A node with an object header of its own, rewritten at another place when it changes.
class ObjectNode : public Node {
 public:
    void setAttributes(Attributes attributes) {
        attributes_ = std::move(attributes);
        changed_ = true;
    }

 protected:
    Address storeHeader(SafeFile& file, const std::string& header);

    Attributes attributes_;
    bool changed_ = true;
    Address address_ = undefined_address;

 private:
    std::uint64_t size_ = 0;
};

class Group final : public ObjectNode {
 public:
    /// Adds or replaces a member.
    template <class T>
    std::shared_ptr<T> put(const std::string& name, std::shared_ptr<T> node) {
        members_[name] = {node, undefined_address};
        changed_ = true;
        return node;
    }
    Address store(SafeFile& file) override;

 private:
    struct Member {
        std::shared_ptr<Node> node;
        Address address;  // as linked in the stored group
    };
    std::map<std::string, Member> members_;
};

/// A small dataset kept in memory and rewritten as a whole. Rows of `row_shape` values.
class SmallArray final : public ObjectNode {
 public:
    SmallArray(Number type, Dimensions row_shape) : type_(type), row_shape_(std::move(row_shape)) {}
    template <class T>
    void append(std::initializer_list<T> row) {
        for (const T& value : row) bytes_.append(reinterpret_cast<const char*>(&value), sizeof(T));
        changed_ = true;
    }
    void appendBytes(std::string_view bytes) {
        bytes_ += bytes;
        changed_ = true;
    }
    Address store(SafeFile& file) override;

 private:
    Number type_;
    Dimensions row_shape_;
    std::string bytes_;
    Address data_ = undefined_address;
    std::uint64_t stored_bytes_ = 0;
};

/// A dataset that grows by rows, in chunks of `chunk_rows`.
class ChunkedArray final : public ObjectNode {
 public:
    /// Filtered arrays (shuffled and deflated) grow by whole chunks only.
    ChunkedArray(Number type, Dimensions row_shape, std::uint32_t chunk_rows, bool filtered);

    const Dimensions& rowShape() const { return row_shape_; }

    /// Filtered: appends rows as new chunks, the last one filled up with zeros. Returns the row
    /// where they begin.
    std::uint64_t appendChunks(SafeFile& file, std::string_view rows);
    /// Unfiltered: appends one row behind the last. It is written at once, to space that readers
    /// see from the next commit on.
    void appendRow(SafeFile& file, std::string_view row);
    /// Goes on with chunks of `chunk_rows` that are in the file already.
    void adopt(std::vector<Chunk> chunks, std::uint32_t chunk_rows, std::uint64_t rows);

    Address store(SafeFile& file) override;

 private:
    Number type_;
    Dimensions row_shape_;
    std::uint32_t chunk_rows_;
    bool filtered_;
    std::size_t row_bytes_;
    std::uint64_t rows_ = 0;
    std::vector<Chunk> chunks_;
    bool chunks_changed_ = false;
    Address index_ = undefined_address;  // space of the B-tree
    std::uint64_t index_bytes_ = 0;
};

/// Rows of a chunk for arrays of `rows` rows: one chunk up to 65536 rows, else equal parts.
std::uint32_t chunkRowsFor(std::uint64_t rows);

/// Stores everything below `root` that changed, then commits.
void commit(SafeFile& file, Group& root, bool durable);

}  // namespace sphinx::io::hdf5
