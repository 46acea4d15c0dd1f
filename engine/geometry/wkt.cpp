// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "geometry/wkt.h"

#include "geometry/overlay.h"
#include "geometry/shape.h"

#include <fmt/core.h>
#include <algorithm>
#include <cctype>
#include <charconv>
#include <system_error>

namespace sphinx::geometry {
namespace {

bool blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }
bool letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// Reads the text from left to right; errors carry file and line.
class Scanner {
 public:
    Scanner(std::string_view path, std::string_view text) : path_(path), text_(text) {}

    [[noreturn]] void fail(const std::string& message) const {
        const std::string_view read = text_.substr(0, at_);
        throw ShapeError(fmt::format("{}:{}: {}", path_,
                                     1 + std::count(read.begin(), read.end(), '\n'), message));
    }
    [[noreturn]] void failExpected(const std::string& what) {
        const std::string found = next();  // moves to its line
        fail(fmt::format("expected {} but found {}", what, found));
    }
    bool atEnd() {
        while (at_ < text_.size() && blank(text_[at_])) ++at_;
        return at_ == text_.size();
    }
    /// Word in capitals, perhaps empty.
    std::string word() {
        std::string result;
        for (atEnd(); at_ < text_.size() && letter(text_[at_]); ++at_) {
            result += static_cast<char>(std::toupper(static_cast<unsigned char>(text_[at_])));
        }
        return result;
    }
    /// "SRID=4326;" of extended well-known text.
    void skipReferenceSystem() {
        const std::size_t begin = at_;
        if (word() == "SRID" && accept('=')) {
            number();
            if (accept(';')) return;
        }
        at_ = begin;
    }
    /// How many numbers a point has besides two: Z, M or ZM behind the type.
    std::size_t furtherNumbers() {
        const std::size_t begin = at_;
        const std::string tag = word();
        if (tag == "Z" || tag == "M" || tag == "ZM") return tag.size();
        at_ = begin;
        return 0;
    }
    bool accept(char c) {
        if (atEnd() || text_[at_] != c) return false;
        ++at_;
        return true;
    }
    void expect(char c) {
        if (!accept(c)) failExpected(fmt::format("'{}'", c));
    }
    double number() {
        atEnd();
        double value = 0;
        const char* const end = text_.data() + text_.size();
        const auto [stop, error] = std::from_chars(text_.data() + at_, end, value);
        if (error != std::errc{}) failExpected("a number");
        at_ = static_cast<std::size_t>(stop - text_.data());
        return value;
    }

 private:
    /// What comes next, for messages.
    std::string next() {
        if (atEnd()) return "the end of the file";
        std::size_t end = at_ + 1;
        if (text_[at_] != '(' && text_[at_] != ')' && text_[at_] != ',') {
            end = std::min(text_.find_first_of(" \t\r\n(),", end), text_.size());
        }
        return fmt::format("'{}'", text_.substr(at_, end - at_));
    }

    std::string_view path_;
    std::string_view text_;
    std::size_t at_ = 0;
};

/// (x y, x y, ...), the last point equal to the first; it is dropped. `more`: numbers of a point
/// that follow, a height or a measure, which a plane figure has no use for.
Ring readRing(Scanner& in, std::size_t more) {
    in.expect('(');
    Ring ring;
    do {
        const double x = in.number();
        const double y = in.number();
        for (std::size_t k = 0; k < more; ++k) in.number();
        ring.emplace_back(x, y);
    } while (in.accept(','));
    if (!in.accept(')')) in.failExpected("',' or ')' after two coordinates");
    if (ring.size() < 2 || ring.front() != ring.back()) {
        in.fail("the last point of a WKT ring must repeat the first");
    }
    ring.pop_back();
    return ring;
}

/// ((outer), (hole), ...); `name` stands before the messages.
Rings readPolygon(Scanner& in, std::size_t more, const std::string& name) {
    Rings rings;
    in.expect('(');
    do {
        const Ring ring = readRing(in, more);
        try {
            if (rings.empty()) {
                rings.push_back(simpleRing(ring, name));
                continue;
            }
            const std::string hole_name = fmt::format("{}hole {}: ", name, rings.size());
            Ring hole = simpleRing(ring, hole_name);
            checkHole(rings.front(), hole, hole_name);
            std::reverse(hole.begin(), hole.end());
            rings.push_back(std::move(hole));
        } catch (const ShapeError& error) {
            in.fail(error.what());
        }
    } while (in.accept(','));
    in.expect(')');
    return rings;
}

}  // namespace

bool looksLikeWkt(std::string_view text) {
    // Column names of a table are followed by a comma or a blank and another name.
    Scanner in("", text);
    in.skipReferenceSystem();
    const std::string word = in.word();
    return word.find("POLYGON") != std::string::npos || (!word.empty() && in.accept('('));
}

Rings readWkt(const std::string& path, std::string_view text) {
    Scanner in(path, text);
    in.skipReferenceSystem();
    const std::string type = in.word();
    if (type != "POLYGON" && type != "MULTIPOLYGON") {
        in.fail(fmt::format("expected POLYGON or MULTIPOLYGON but found {}", type));
    }
    const std::size_t more = in.furtherNumbers();
    std::vector<Rings> polygons;
    if (type == "POLYGON") {
        polygons.push_back(readPolygon(in, more, ""));
    } else {
        in.expect('(');
        do {
            polygons.push_back(
                readPolygon(in, more, fmt::format("polygon {}: ", polygons.size() + 1)));
        } while (in.accept(','));
        in.expect(')');
    }
    if (!in.atEnd()) in.failExpected("the end of the file");
    return overlay(polygons, Rule::any);
}

}  // namespace sphinx::geometry
