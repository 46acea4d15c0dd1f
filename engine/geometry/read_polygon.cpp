// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/characters.h"
#include "core/errors.h"
#include "core/read_file.h"
#include "geometry/polygon.h"
#include "geometry/shape.h"
#include "geometry/wkt.h"

#include <fmt/core.h>
#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>

namespace sphinx::geometry {
namespace {

constexpr std::string_view blanks = " \t\r";

std::string_view trimmed(std::string_view line) {
    const std::size_t begin = line.find_first_not_of(blanks);
    if (begin == std::string_view::npos) return {};
    return line.substr(begin, line.find_last_not_of(blanks) + 1 - begin);
}

/// Takes a number off the front of `text`.
bool takeNumber(std::string_view& text, double& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{}) return false;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return true;
}

/// "x y" or "x,y", blanks around the comma allowed; nothing for any other line.
std::optional<Vec<2>> point(std::string_view line) {
    double x = 0, y = 0;
    if (!takeNumber(line, x)) return std::nullopt;
    const std::size_t width = line.size();
    line = trimmed(line);
    bool apart = line.size() < width;
    if (!line.empty() && line.front() == ',') {
        line = trimmed(line.substr(1));
        apart = true;
    }
    if (!apart || !takeNumber(line, y) || !line.empty()) return std::nullopt;
    return Vec<2>(x, y);
}

/// Whether a line names columns: none of its words is a number.
bool isHeader(std::string_view line) {
    constexpr std::string_view between = " \t,;";
    while (!line.empty()) {
        const std::size_t begin = std::min(line.find_first_not_of(between), line.size());
        line.remove_prefix(begin);
        double value = 0;
        if (takeNumber(line, value)) return false;
        line.remove_prefix(std::min(line.find_first_of(between), line.size()));
    }
    return true;
}

Ring readPoints(const std::string& path, const std::string& text) {
    Ring ring;
    std::istringstream lines(text);
    std::string raw;
    bool first = true;
    for (int number = 1; std::getline(lines, raw); ++number) {
        const std::string_view line = trimmed(raw);
        if (line.empty() || line.front() == '#') continue;
        const bool names = first && isHeader(line);
        first = false;
        if (const std::optional<Vec<2>> p = point(line)) {
            ring.push_back(*p);
        } else if (!names) {
            throw ShapeError(
                fmt::format("{}:{}: expected two numbers \"x y\" or \"x,y\" but found '{}'", path,
                            number, line));
        }
    }
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    return ring;
}

}  // namespace

ShapePointer<2> readPolygon(const std::string& path) {
    std::string text;
    try {
        text = readFile(path);
    } catch (const FileError& error) {
        throw ShapeError(error.what());
    }
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
        throw ShapeError(fmt::format("{} is text in UTF-16: save it in UTF-8", path));
    if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
    if (looksLikeWkt(text)) return std::make_shared<Polygon>(readWkt(path, text));
    Ring ring = readPoints(path, text);
    try {
        return std::make_shared<Polygon>(Rings{simpleRing(std::move(ring), "")});
    } catch (const ShapeError& error) {
        throw ShapeError(fmt::format("{}: {}", path, error.what()));
    }
}

}  // namespace sphinx::geometry
