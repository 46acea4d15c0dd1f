// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/hdf5/file.h"

#include "core/errors.h"

namespace sphinx::io::hdf5 {

SafeFile SafeFile::create(const Path& path) {
    if (isThere(path)) throw FileError("cannot write " + path.string() + ": it exists already");
    SafeFile result(path);
    result.file_ = File::create(temporaryName(path));
    result.visible_ = false;
    return result;
}

SafeFile SafeFile::open(const Path& path) {
    SafeFile result(path);
    result.file_ = File::openUpdate(path);
    char block[superblock_size];
    const std::size_t count = result.file_->read(block, sizeof block);
    Address root = 0;
    if (!parseSuperblock({block, count}, result.end_, root) || result.end_ > result.file_->size())
        throw FileError("cannot continue " + path.string() + ": sphinx did not write it");
    return result;
}

Address SafeFile::reserve(std::uint64_t size) {
    for (auto hole = free_.begin(); hole != free_.end(); ++hole) {
        const auto [address, available] = *hole;
        if (available < size) continue;
        free_.erase(hole);
        if (available > size) free_.emplace(address + size, available - size);
        return address;
    }
    const Address address = end_;
    end_ += size;
    return address;
}

Address SafeFile::store(std::string_view bytes) {
    const Address address = reserve(bytes.size());
    file_->writeAt(address, bytes);
    return address;
}

void SafeFile::release(Address address, std::uint64_t size) {
    if (size > 0) released_.emplace_back(address, size);
}

void SafeFile::commit(Address root, bool durable) {
    // Readers want the file to be as long as the superblock says, also where space was only
    // reserved.
    if (file_->size() < end_) file_->truncate(end_);
    if (durable) file_->sync();
    file_->writeAt(0, superblock(end_, root));
    if (!visible_) {
        file_->sync();
        renameFile(temporaryName(path_), path_);
        visible_ = true;
    }
    for (auto [address, size] : released_) {
        const auto after = free_.lower_bound(address);
        if (after != free_.end() && after->first == address + size) {
            size += after->second;
            free_.erase(after);
        }
        const auto next = free_.lower_bound(address);
        if (next != free_.begin()) {
            const auto before = std::prev(next);
            if (before->first + before->second == address) {
                before->second += size;
                continue;
            }
        }
        free_.emplace(address, size);
    }
    released_.clear();
}

}  // namespace sphinx::io::hdf5
