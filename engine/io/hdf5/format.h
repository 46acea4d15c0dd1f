// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/file/number_type.h"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

/// Encoders for the few structures of the HDF5 file format that result files need: superblock 2,
/// object headers 2, contiguous and chunked layouts 3 (readable since HDF5 1.8). Pure functions
/// from values to bytes. Why not by the HDF5 library: see hdf5/file.h. "HDF5 File Format
/// Specification Version 3.0", The HDF Group; section numbers in format.cpp.
namespace sphinx::io::hdf5 {

using Address = std::uint64_t;
inline constexpr Address undefined_address = ~Address{0};
inline constexpr std::size_t superblock_size = 48;

using Dimensions = std::vector<std::uint64_t>;  ///< slowest first

inline constexpr std::size_t max_message = 65535;  ///< bytes of an attribute with its name

struct Attribute {
    std::string name;
    std::variant<std::string, double, std::int64_t, std::vector<std::int64_t>,
                 std::vector<std::string>>
        value;
};
using Attributes = std::vector<Attribute>;

struct Link {
    std::string name;
    Address address = undefined_address;
};

struct Chunk {
    Address address = undefined_address;
    std::uint32_t bytes = 0;  ///< as stored
};

/// Where and how the values of a dataset lie.
struct Storage {
    bool chunked = false;
    Address address = undefined_address;  ///< of the values, or of the index of chunks
    std::uint64_t bytes = 0;              ///< contiguous only
    std::uint32_t chunk_rows = 0;         ///< a chunk holds whole rows (all other dimensions)
    bool filtered = false;                ///< bytes shuffled, then deflated
};

enum class Number { float64, float32, int64, uint8 };
std::size_t bytesOf(Number type);
Number numberOf(NumberType type);

std::string superblock(Address end_of_file, Address root);
/// Reads back what superblock() made; false if the bytes are anything else.
bool parseSuperblock(std::string_view bytes, Address& end_of_file, Address& root);

std::string groupObject(const std::vector<Link>& links, const Attributes& attributes);
std::string datasetObject(Number type, const Dimensions& dimensions, const Storage& storage,
                          const Attributes& attributes);

/// B-tree that finds the chunks of a dataset with `rank` dimensions; it is to be stored at `at`.
/// The root is the last `chunkIndexNodeSize(rank)` bytes.
std::string chunkIndex(const std::vector<Chunk>& chunks, std::uint32_t chunk_rows, std::size_t rank,
                       Address at);
std::size_t chunkIndexSize(std::size_t chunks, std::size_t rank);
std::size_t chunkIndexNodeSize(std::size_t rank);

/// Regroups values by significance of their bytes, so that they deflate well.
std::string shuffle(std::string_view values, std::size_t value_size);

}  // namespace sphinx::io::hdf5
