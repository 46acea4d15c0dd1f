// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/file/file.h"
#include "io/hdf5/format.h"

#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace sphinx::io::hdf5 {

/// An HDF5 file that is complete and valid after every single write: it opens in every reader
/// whenever its writer is killed. New data and new versions of what describes them go to space that
/// the present superblock does not reach; then one write of 48 bytes puts the new superblock in
/// place. Space of outdated descriptions is used again, so that the file holds little besides data.
///
/// The HDF5 library cannot do this: it changes its structures in place, with several writes for
/// one frame, and its single-writer mode leaves a mark in the file that other readers refuse after
/// a crash. A copy of the file for each frame costs time that grows with the square of the frames;
/// two files used in turn cost twice the space; a file a frame is not one file.
class SafeFile {
 public:
    /// A new file; throws FileError if there is one already. It appears with the first commit.
    static SafeFile create(const Path& path);
    /// An existing file that this class wrote. Throws FileError.
    static SafeFile open(const Path& path);

    const Path& path() const { return path_; }

    /// Writes bytes to unused space. They belong to the file from the next commit on.
    Address store(std::string_view bytes);
    /// Unused space for later writes to it by writeAt.
    Address reserve(std::uint64_t size);
    /// For space that the file does not describe yet (rows beyond the extent of a dataset).
    void writeAt(Address address, std::string_view bytes) { file_->writeAt(address, bytes); }
    /// The file does not need these bytes any more once the next commit is done.
    void release(Address address, std::uint64_t size);
    /// Makes the object at `root` the root group. `durable`: what was stored is on the disk first.
    void commit(Address root, bool durable);

 private:
    explicit SafeFile(const Path& path) : path_(path) {}

    Path path_;
    std::optional<File> file_;
    bool visible_ = true;  // false: written under its temporary name
    Address end_ = superblock_size;
    std::map<Address, std::uint64_t> free_;
    std::vector<std::pair<Address, std::uint64_t>> released_;
};

}  // namespace sphinx::io::hdf5
