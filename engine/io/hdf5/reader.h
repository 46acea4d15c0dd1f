// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/file/file.h"
#include "io/hdf5/format.h"

#include <cstdint>
#include <string>
#include <vector>

namespace sphinx::io::hdf5 {

/// A dataset of a file, as far as a resumed run needs it to go on in it.
struct StoredArray {
    Number type = Number::float64;
    Dimensions row_shape;
    std::uint64_t rows = 0;
    std::uint32_t chunk_rows = 0;
    bool filtered = false;
    std::vector<Chunk> chunks;
};

/// Reads result files by the HDF5 library. Anything missing or different from what it should be is
/// a FileError.
class Reader {
 public:
    explicit Reader(const Path& path);
    ~Reader();
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    bool has(const std::string& object) const;
    /// Members of a group with the addresses of their object headers; by name.
    std::vector<Link> members(const std::string& group) const;
    /// Whole content of a dataset of 64-bit values.
    std::vector<double> numbers(const std::string& dataset) const;
    std::vector<std::int64_t> integers(const std::string& dataset) const;
    StoredArray array(const std::string& dataset) const;

 private:
    [[noreturn]] void fail(const std::string& object) const;
    template <class T>
    std::vector<T> values(const std::string& dataset, std::int64_t type) const;

    Path path_;
    std::int64_t file_ = -1;  // hid_t
};

}  // namespace sphinx::io::hdf5
