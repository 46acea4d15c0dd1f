// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/hdf5/format.h"

#include "core/errors.h"
#include "io/file/little_endian.h"
#include "io/hdf5/checksum.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace sphinx::io::hdf5 {
namespace {

constexpr std::string_view signature("\211HDF\r\n\032\n", 8);
constexpr Address end_offset = 28, root_offset = 36, checksum_offset = 44;  // in the superblock
constexpr std::size_t node_capacity = 64;  // children of a B-tree node: twice the default K of 32

/// Datatype message (IV.A.2.d).
std::string datatype(Number type) {
    LittleEndian out;
    switch (type) {
        case Number::float64:  // sign 63, exponent 52..62 biased by 1023, implied leading one
            out.bytes({0x11, 0x20, 0x3f, 0}).u32(8).u16(0).u16(64).bytes({52, 11, 0, 52}).u32(1023);
            break;
        case Number::float32:
            out.bytes({0x11, 0x20, 0x1f, 0}).u32(4).u16(0).u16(32).bytes({23, 8, 0, 23}).u32(127);
            break;
        case Number::int64: out.bytes({0x10, 0x08, 0, 0}).u32(8).u16(0).u16(64); break;
        case Number::uint8: out.bytes({0x10, 0, 0, 0}).u32(1).u16(0).u16(8); break;
    }
    return out.take();
}

/// Fixed-length text, padded with zeros. ASCII where it is (VTK insists), else UTF-8.
std::string textDatatype(std::size_t size, bool ascii) {
    LittleEndian out;
    out.bytes({0x13, static_cast<std::uint8_t>(ascii ? 0x01 : 0x11), 0, 0});
    return out.u32(static_cast<std::uint32_t>(size)).take();
}

/// Dataspace message (IV.A.2.b), the first dimension unlimited if wanted.
std::string dataspace(const Dimensions& dimensions, bool unlimited) {
    LittleEndian out;
    out.u8(2).u8(static_cast<std::uint8_t>(dimensions.size())).u8(unlimited ? 1 : 0);
    out.u8(dimensions.empty() ? 0 : 1);
    for (const std::uint64_t n : dimensions) out.u64(n);
    if (unlimited)
        for (std::size_t d = 0; d < dimensions.size(); ++d)
            out.u64(d == 0 ? ~std::uint64_t{0} : dimensions[d]);
    return out.take();
}

struct EncodedAttribute {
    std::string type, space, data;
};

EncodedAttribute encodeTexts(const std::vector<std::string>& texts, Dimensions dimensions) {
    std::size_t longest = 1;
    bool ascii = true;
    for (const std::string& text : texts) {
        longest = std::max(longest, text.size());
        for (const char c : text) ascii = ascii && static_cast<unsigned char>(c) < 0x80;
    }
    EncodedAttribute result{textDatatype(longest, ascii), dataspace(dimensions, false), ""};
    for (const std::string& text : texts)
        result.data += text + std::string(longest - text.size(), '\0');
    return result;
}

EncodedAttribute encodeValue(const std::string& text) { return encodeTexts({text}, {}); }
EncodedAttribute encodeValue(const std::vector<std::string>& texts) {
    return encodeTexts(texts, {texts.size()});
}
EncodedAttribute encodeValue(double value) {
    return {datatype(Number::float64), dataspace({}, false),
            LittleEndian().u64(std::bit_cast<std::uint64_t>(value)).take()};
}
EncodedAttribute encodeValue(std::int64_t value) {
    return {datatype(Number::int64), dataspace({}, false),
            LittleEndian().u64(static_cast<std::uint64_t>(value)).take()};
}
EncodedAttribute encodeValue(const std::vector<std::int64_t>& values) {
    LittleEndian data;
    for (const std::int64_t value : values) data.u64(static_cast<std::uint64_t>(value));
    return {datatype(Number::int64), dataspace({values.size()}, false), data.take()};
}

/// Attribute message (IV.A.2.m).
std::string attributeMessage(const Attribute& attribute) {
    const EncodedAttribute value =
        std::visit([](const auto& v) { return encodeValue(v); }, attribute.value);
    LittleEndian out;
    out.u8(3).u8(0).u16(static_cast<std::uint16_t>(attribute.name.size() + 1));
    out.u16(static_cast<std::uint16_t>(value.type.size()));
    out.u16(static_cast<std::uint16_t>(value.space.size())).u8(1);
    out.text(attribute.name).u8(0).text(value.type).text(value.space).text(value.data);
    return out.take();
}

/// Object header (IV.A.1.b) from its messages.
class ObjectHeader {
 public:
    void message(std::uint8_t type, const std::string& body) {
        if (body.size() > max_message)
            throw FileError("an attribute of a result file is longer than 64 kB");
        messages_.u8(type).u16(static_cast<std::uint16_t>(body.size())).u8(0).text(body);
    }
    void attributes(const Attributes& list) {
        for (const Attribute& attribute : list) message(0x0c, attributeMessage(attribute));
    }
    std::string take() {
        const std::string messages = messages_.take();
        LittleEndian out;  // flag 2: the size has four bytes
        out.text("OHDR").u8(2).u8(2).u32(static_cast<std::uint32_t>(messages.size()));
        out.text(messages);
        std::string object = out.take();
        return object + LittleEndian().u32(metadataChecksum(object)).take();
    }

 private:
    LittleEndian messages_;
};

/// Data layout message (IV.A.2.i).
std::string layoutMessage(const Storage& storage, const Dimensions& dimensions,
                          std::size_t value_size) {
    LittleEndian out;
    if (!storage.chunked) return out.u8(3).u8(1).u64(storage.address).u64(storage.bytes).take();
    out.u8(3).u8(2).u8(static_cast<std::uint8_t>(dimensions.size() + 1)).u64(storage.address);
    for (std::size_t d = 0; d < dimensions.size(); ++d)
        out.u32(d == 0 ? storage.chunk_rows : static_cast<std::uint32_t>(dimensions[d]));
    return out.u32(static_cast<std::uint32_t>(value_size)).take();
}

/// Filter pipeline message (IV.A.2.l): shuffle (2) by value size, deflate (1).
std::string filterMessage(std::size_t value_size) {
    LittleEndian out;
    out.u8(2).u8(2);
    out.u16(2).u16(1).u16(1).u32(static_cast<std::uint32_t>(value_size));
    return out.u16(1).u16(0).u16(1).u32(1).take();
}

}  // namespace

std::size_t bytesOf(Number type) {
    return type == Number::uint8 ? 1 : type == Number::float32 ? 4 : 8;
}

Number numberOf(NumberType type) {
    switch (type) {
        case NumberType::float64: return Number::float64;
        case NumberType::float32: return Number::float32;
        case NumberType::int64: break;
    }
    return Number::int64;
}

std::string superblock(Address end_of_file, Address root) {
    LittleEndian out;
    out.text(signature).bytes({2, 8, 8, 0}).u64(0).u64(undefined_address);
    std::string block = out.u64(end_of_file).u64(root).take();
    return block + LittleEndian().u32(metadataChecksum(block)).take();
}

bool parseSuperblock(std::string_view bytes, Address& end_of_file, Address& root) {
    if (bytes.size() < superblock_size) return false;
    std::memcpy(&end_of_file, bytes.data() + end_offset, 8);
    std::memcpy(&root, bytes.data() + root_offset, 8);
    static_assert(checksum_offset + 4 == superblock_size);
    return bytes.substr(0, superblock_size) == superblock(end_of_file, root);
}

std::string groupObject(const std::vector<Link>& links, const Attributes& attributes) {
    ObjectHeader header;
    LittleEndian info;  // link info (IV.A.2.c): links stand in this header
    header.message(0x02, info.u8(0).u8(0).u64(undefined_address).u64(undefined_address).take());
    header.message(0x0a, std::string(2, '\0'));  // group info: nothing unusual
    for (const Link& link : links) {
        LittleEndian out;  // link message (IV.A.2.g): hard link, name length in two bytes, UTF-8
        out.u8(1).u8(0x11).u8(1).u16(static_cast<std::uint16_t>(link.name.size()));
        header.message(0x06, out.text(link.name).u64(link.address).take());
    }
    header.attributes(attributes);
    return header.take();
}

std::string datasetObject(Number type, const Dimensions& dimensions, const Storage& storage,
                          const Attributes& attributes) {
    ObjectHeader header;
    header.message(0x01, dataspace(dimensions, storage.chunked));
    header.message(0x03, datatype(type));
    // Fill value (IV.A.2.f): zero; space allocated late or chunk by chunk, written if set.
    header.message(0x05, {3, storage.chunked ? '\x0b' : '\x0a'});
    header.message(0x08, layoutMessage(storage, dimensions, bytesOf(type)));
    if (storage.filtered) header.message(0x0b, filterMessage(bytesOf(type)));
    header.attributes(attributes);
    return header.take();
}

std::size_t chunkIndexNodeSize(std::size_t rank) {
    return 24 + (node_capacity + 1) * (8 + 8 * (rank + 1)) + node_capacity * 8;
}

std::size_t chunkIndexSize(std::size_t chunks, std::size_t rank) {
    std::size_t nodes = 0;
    for (std::size_t count = chunks; count > 0; count = count > 1 ? count : 0) {
        count = (count + node_capacity - 1) / node_capacity;
        nodes += count;
    }
    return nodes * chunkIndexNodeSize(rank);
}

std::string chunkIndex(const std::vector<Chunk>& chunks, std::uint32_t chunk_rows, std::size_t rank,
                       Address at) {
    struct Child {
        Address address;
        std::size_t first;  // chunk
    };
    std::vector<Child> children;
    for (std::size_t k = 0; k < chunks.size(); ++k) children.push_back({chunks[k].address, k});
    const std::size_t node_size = chunkIndexNodeSize(rank);
    std::string result;
    // Level by level from the leaves (III.A.1).
    for (std::uint8_t level = 0; level == 0 || children.size() > 1; ++level) {
        std::vector<Child> nodes;
        const Address first_node = at + result.size();
        const std::size_t count = (children.size() + node_capacity - 1) / node_capacity;
        for (std::size_t n = 0; n < count; ++n) {
            const std::size_t begin = n * node_capacity;
            const std::size_t end = std::min(begin + node_capacity, children.size());
            const Address here = first_node + n * node_size;
            LittleEndian out;
            out.text("TREE").u8(1).u8(level).u16(static_cast<std::uint16_t>(end - begin));
            out.u64(n > 0 ? here - node_size : undefined_address);
            out.u64(n + 1 < count ? here + node_size : undefined_address);
            const auto key = [&](std::size_t chunk) {
                out.u32(chunk < chunks.size() ? chunks[chunk].bytes : 0).u32(0);
                out.u64(std::uint64_t{chunk} * chunk_rows);
                for (std::size_t d = 0; d < rank; ++d) out.u64(0);  // others, value size
            };
            for (std::size_t c = begin; c < end; ++c) {
                key(children[c].first);
                out.u64(children[c].address);
            }
            key(end < children.size() ? children[end].first : chunks.size());
            std::string node = out.take();
            node.resize(node_size);
            result += node;
            nodes.push_back({here, children[begin].first});
        }
        children = std::move(nodes);
    }
    return result;
}

std::string shuffle(std::string_view values, std::size_t value_size) {
    const std::size_t count = values.size() / value_size;
    std::string result(values.size(), '\0');
    for (std::size_t b = 0; b < value_size; ++b) {
        char* to = result.data() + b * count;
        const char* from = values.data() + b;
        for (std::size_t k = 0; k < count; ++k) to[k] = from[k * value_size];
    }
    return result;
}

}  // namespace sphinx::io::hdf5
