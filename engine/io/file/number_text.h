// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace sphinx::io {

/// Shortest decimal that reads back as the same double; nan, inf, -inf. Independent of the locale.
void appendNumber(std::string& text, double value);
std::string numberText(double value);

/// The same for files that must keep every bit: what decimals cannot say (a NaN other than the
/// plain one) is written as its 16 hexadecimal digits after "0x". NaN and INF as in XML Schema.
void appendExactNumber(std::string& text, double value);
/// Nothing if the text is not exactly one such number.
std::optional<double> parseExactNumber(std::string_view text);

void appendInteger(std::string& text, std::int64_t value);
/// Nothing if the text is not exactly one decimal integer that fits.
std::optional<std::int64_t> parseInteger(std::string_view text);

/// Exact numbers with a blank between two.
void appendList(std::string& text, std::span<const double> values);
void appendList(std::string& text, std::span<const std::int64_t> values);
/// False if the text is not exactly as many such numbers.
bool parseList(std::string_view text, std::span<double> values);
bool parseList(std::string_view text, std::span<std::int64_t> values);

/// Eight hexadecimal digits, as for checksums.
std::string hexText(std::uint32_t value);

}  // namespace sphinx::io
