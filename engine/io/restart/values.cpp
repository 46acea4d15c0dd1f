// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/restart/values.h"

#include "io/file/base64.h"
#include "io/file/compress.h"
#include "io/file/number_text.h"

#include <cstring>
#include <span>
#include <vector>

namespace sphinx::io {
namespace {

// The longest text of a piece: decimals of 24 characters and a blank.
constexpr std::size_t longest_piece = 32 * values_in_piece;

std::string decimals(const char* values, std::size_t count, bool integers) {
    std::string text;
    if (integers)
        appendList(text, {reinterpret_cast<const std::int64_t*>(values), count});
    else
        appendList(text, {reinterpret_cast<const double*>(values), count});
    return text;
}

/// False if the text does not hold exactly as many numbers.
bool parseDecimals(std::string_view text, bool integers, std::span<std::int64_t> bits) {
    if (integers) return parseList(text, bits);
    std::vector<double> numbers(bits.size());
    if (!parseList(text, numbers)) return false;
    std::memcpy(bits.data(), numbers.data(), 8 * numbers.size());
    return true;
}

}  // namespace

std::string encodePiece(const char* values, std::size_t count, bool integers,
                        RestartEncoding encoding) {
    const std::string_view bytes(values, 8 * count);
    const bool packed = encoding == RestartEncoding::zlib;
    const std::string tag = packed ? "zlib" : "text";
    return "<" + tag + " values=\"" + std::to_string(count) + "\" crc32=\"" +
           hexText(checksum(bytes)) + "\">" +
           (packed ? encodeBase64(compress(bytes)) : decimals(values, count, integers)) + "</" +
           tag + ">\n";
}

void appendPiece(XmlReader& reader, const XmlElement& element, bool integers,
                 AlignedVector<std::int64_t>& bits) {
    const bool packed = element.name == "zlib";
    if (!packed && element.name != "text") reader.fail("unknown element '" + element.name + "'");
    const auto count = static_cast<std::size_t>(reader.count(element, "values", values_in_piece));
    const std::string expected = reader.attribute(element, "crc32");
    const std::string text = reader.text(longest_piece);
    const std::size_t before = bits.size();
    bits.resize(before + count);
    std::int64_t* target = bits.data() + before;
    bool sound = false;
    if (packed) {
        const auto stream = decodeBase64(text);
        sound = stream && decompress(*stream, reinterpret_cast<char*>(target), 8 * count);
    } else {
        sound = parseDecimals(text, integers, {target, count});
    }
    if (!sound || hexText(checksum({reinterpret_cast<const char*>(target), 8 * count})) != expected)
        reader.fail("these values are damaged");
}

}  // namespace sphinx::io
