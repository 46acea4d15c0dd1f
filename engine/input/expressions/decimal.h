// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace sphinx::input {

/// The number that the whole text is, in decimal notation: 12, -0.5, 1e-3, 010 (ten). No inf, nan
/// or hexadecimal.
template <class T>
std::optional<T> parseDecimal(std::string_view text) {
    const bool plus = text.starts_with('+');
    if (plus) text.remove_prefix(1);
    const std::string_view digits = text.substr(text.starts_with('-') && !plus ? 1 : 0);
    if (digits.empty() || digits.find_first_of("0123456789") == std::string_view::npos ||
        (digits[0] != '.' && (digits[0] < '0' || digits[0] > '9')))
        return std::nullopt;
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// Digits of a number that no double is near to: 1e-400.
inline bool isBeyondRange(std::string_view text) {
    double value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc::result_out_of_range && end == text.data() + text.size();
}

}  // namespace sphinx::input
