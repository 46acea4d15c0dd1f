// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/file/number_text.h"

#include <bit>
#include <charconv>
#include <cmath>

namespace sphinx::io {
namespace {

constexpr std::uint64_t plain_nan = 0x7ff8000000000000;
constexpr std::size_t longest_number = 32;  // shortest round-trip decimals need at most 24

template <class T, class... Format>
void append(std::string& text, T value, Format... format) {
    char buffer[longest_number];
    const auto result = std::to_chars(buffer, buffer + sizeof buffer, value, format...);
    text.append(buffer, result.ptr);
}

void appendHex(std::string& text, std::uint64_t value, int digits) {
    for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4)
        text += "0123456789abcdef"[(value >> shift) & 15];
}

template <class T, class... Format>
std::optional<T> parse(std::string_view text, Format... format) {
    T value{};
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value, format...);
    if (result.ec != std::errc() || result.ptr != text.data() + text.size()) return {};
    return value;
}

}  // namespace

void appendNumber(std::string& text, double value) {
    if (std::isnan(value))
        text += "nan";
    else
        append(text, value);
}

std::string numberText(double value) {
    std::string text;
    appendNumber(text, value);
    return text;
}

void appendExactNumber(std::string& text, double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    if (bits == plain_nan) {
        text += "NaN";
    } else if (std::isnan(value)) {
        text += "0x";
        appendHex(text, bits, 16);
    } else if (std::isinf(value)) {
        text += value > 0 ? "INF" : "-INF";
    } else {
        append(text, value);
    }
}

std::optional<double> parseExactNumber(std::string_view text) {
    if (text == "NaN") return std::bit_cast<double>(plain_nan);
    if (text == "INF") return HUGE_VAL;
    if (text == "-INF") return -HUGE_VAL;
    if (text.starts_with("0x")) {
        if (text.size() != 18) return {};
        const auto bits = parse<std::uint64_t>(text.substr(2), 16);
        return bits ? std::optional(std::bit_cast<double>(*bits)) : std::nullopt;
    }
    // from_chars would take "nan" and "inf" in other spellings.
    if (text.find_first_of("nN") != text.npos) return {};
    return parse<double>(text);
}

void appendInteger(std::string& text, std::int64_t value) { append(text, value); }

std::optional<std::int64_t> parseInteger(std::string_view text) {
    return parse<std::int64_t>(text);
}

namespace {

template <class T, class Append>
void appendEach(std::string& text, std::span<const T> values, Append append_one) {
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (k > 0) text += ' ';
        append_one(text, values[k]);
    }
}

template <class T, class Parse>
bool parseEach(std::string_view text, std::span<T> values, Parse parse_one) {
    for (std::size_t k = 0; k < values.size(); ++k) {
        const std::size_t end = std::min(text.find(' '), text.size());
        const std::optional<T> value = parse_one(text.substr(0, end));
        if (!value) return false;
        values[k] = *value;
        if (end == text.size()) return k + 1 == values.size();
        text.remove_prefix(end + 1);
    }
    return values.empty() && text.empty();
}

}  // namespace

void appendList(std::string& text, std::span<const double> values) {
    appendEach(text, values, appendExactNumber);
}

void appendList(std::string& text, std::span<const std::int64_t> values) {
    appendEach(text, values, appendInteger);
}

bool parseList(std::string_view text, std::span<double> values) {
    return parseEach(text, values, parseExactNumber);
}

bool parseList(std::string_view text, std::span<std::int64_t> values) {
    return parseEach(text, values, parseInteger);
}

std::string hexText(std::uint32_t value) {
    std::string text;
    appendHex(text, value, 8);
    return text;
}

}  // namespace sphinx::io
