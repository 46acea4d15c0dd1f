// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "../temporary_folder.h"
#include "random_shapes.h"

#include <catch2/catch.hpp>
#include <fstream>

using namespace sphinx;
using namespace sphinx::geometry;

namespace {

/// A file in a folder of its own.
class Folder {
 public:
    std::string write(const std::string& text) const {
        std::ofstream(folder_ / "shape.txt", std::ios::binary) << text;
        return file();
    }
    std::string file() const { return (folder_ / "shape.txt").string(); }
    std::string folder() const { return folder_.path().string(); }

    ShapePointer<2> read(const std::string& text) const { return readPolygon(write(text)); }
    /// The message without the file's name, which it must start with.
    std::string error(const std::string& text) const {
        const std::string message = messageOf([&] { read(text); });
        return message.rfind(file(), 0) == 0 ? message.substr(file().size())
                                             : "no name: " + message;
    }

 private:
    test::TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("points one a line") {
    const Folder folder;
    CHECK(folder.read("0 0\n2 0\n2 1\n0 1\n")->measure() == 2);
    CHECK(folder.read("0,0\n2, 0\n2 ,1\n0\t1")->measure() == 2);
    CHECK(folder.read("# a coast\r\n\r\nx,y\r\n 0 0 \r\n2e0 0\r\n2 1.0\r\n-0 1\r\n0 0\r\n")
              ->measure() == 2);
    CHECK(folder.read("-1 0\n.5 0\n0 1")->measure() == 0.75);
}

TEST_CASE("tables of points that are wrong") {
    const Folder folder;
    const std::string expected = "expected two numbers \"x y\" or \"x,y\" but found ";
    CHECK(folder.error("0 0\n1 0\n1 one\n") == ":3: " + expected + "'1 one'");
    CHECK(folder.error("x y\nx y\n0 0\n") == ":2: " + expected + "'x y'");
    CHECK(folder.error("# three columns\n0 0 0\n") == ":2: " + expected + "'0 0 0'");
    CHECK(folder.error("0 0\n\n1\n") == ":3: " + expected + "'1'");
    CHECK(folder.error("1,,2\n") == ":1: " + expected + "'1,,2'");
    CHECK(folder.error("1.2.3\n") == ":1: " + expected + "'1.2.3'");
    CHECK(folder.error("0 0\n1 0\nnan 1\n") ==
          ": point 3 is (nan, 1); coordinates must be finite numbers");
    CHECK(folder.error("0 0\n1 1\n") == ": a polygon needs at least 3 points, this one has 2");
    CHECK(folder.error("") == ": a polygon needs at least 3 points, this one has 0");
    CHECK(
        folder.error("0 0\n1 1\n1 0\n0 1") ==
        ": edge 1 from (0, 0) to (1, 1) crosses edge 3 from (1, 0) to (0, 1); edges may meet only "
        "where one ends and the next begins");
    CHECK(folder.error("O 0\n1 0\n1 1\n0 1\n") == ":1: " + expected + "'O 0'");
    CHECK(folder.error("0 1e999\n") == ":1: " + expected + "'0 1e999'");
}

TEST_CASE("files that cannot be read") {
    const Folder folder;
    CHECK(messageOf([&] { readPolygon(folder.file()); }) ==
          "cannot read " + folder.file() + ": No such file or directory");
    CHECK(messageOf([&] { readPolygon(folder.folder()); }) ==
          "cannot read " + folder.folder() + ": it is a folder");
}

TEST_CASE("well-known text") {
    const Folder folder;
    CHECK(folder.read("POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0))")->measure() == 2);
    // Any case, orientation and blanks; holes.
    const auto holes = folder.read(
        "polygon((0 0,0 4,4 4,4 0,0 0),\n (1 1, 2 1, 2 2, 1 2, 1 1), (3 3,3 3.5,3.5 3.5,3 3))\n");
    CHECK(holes->measure() == 16 - 1 - 0.125);
    CHECK_FALSE(holes->contains({1.5, 1.5}));
    CHECK(holes->contains({2.5, 2.5}));
    const auto two = folder.read(
        "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 0)), ((5 5, 9 5, 9 9, 5 9, 5 5), (6 6, 7 6, 7 7, 6 7, 6 "
        "6)))");
    CHECK(two->measure() == 0.5 + 15);
    // An island in the hole of another polygon, and neighbors that share an edge.
    CHECK(folder
              .read("MULTIPOLYGON (((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 8 1, 8 8, 1 8, 1 1)),"
                    "((2 2, 3 2, 3 3, 2 3, 2 2)))")
              ->measure() == 81 - 49 + 1);
    const auto joined =
        folder.read("MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)), ((1 0, 2 0, 2 1, 1 1, 1 0)))");
    CHECK(joined->signedDistance({1, 0.5}) == -0.5);
    // As other programs write it: with a byte-order mark, a reference system, heights and measures.
    for (const char* text : {"\xef\xbb\xbfPOLYGON ((0 0, 2 0, 2 1, 0 1, 0 0))",
                             "SRID=25832; POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0))",
                             "POLYGON Z ((0 0 5, 2 0 5, 2 1 5, 0 1 7, 0 0 5))",
                             "POLYGON ZM((0 0 5 1, 2 0 5 2, 2 1 5 3, 0 1 5 4, 0 0 5 5))",
                             "\xef\xbb\xbf"
                             "0 0\n2 0\n2 1\n0 1\n"})
        CHECK(folder.read(text)->measure() == 2);
    CHECK(messageOf([&] {
              folder.read(
                  std::string("\xff\xfe"
                              "0\0 \0",
                              6));
          }) == folder.file() + " is text in UTF-16: save it in UTF-8");
    // A hole that touches the outer ring in a corner is allowed.
    CHECK(folder.read("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (0 0, 2 1, 1 2, 0 0))")->measure() ==
          14.5);
}

TEST_CASE("well-known text that is wrong") {
    const Folder folder;
    const std::vector<std::pair<std::string, std::string>> wrong{
        {"POINT (1 2)", ":1: expected POLYGON or MULTIPOLYGON but found POINT"},
        {"POLYGON EMPTY", ":1: expected '(' but found 'EMPTY'"},
        {"POLYGON Z ((0 0, 1 0))", ":1: expected a number but found ','"},
        {"POLYGON ((0 0,\n1 0,\n1 b, 0 0))", ":3: expected a number but found 'b'"},
        {"POLYGON ((0 0 1, 1 0 1, 1 1 1, 0 0 1))",
         ":1: expected ',' or ')' after two coordinates but found '1'"},
        {"POLYGON ((0 0, 1 0, 1 1, 0 0)", ":1: expected ')' but found the end of the file"},
        {"POLYGON ((0 0, 1 0, 1 1, 0 0)) 7", ":1: expected the end of the file but found '7'"},
        {"POLYGON ((0 0, 1 0, 1 1))", ":1: the last point of a WKT ring must repeat the first"},
        {"POLYGON ((0 0, 1 0, 0 0))", ":1: a polygon needs at least 3 points, this one has 2"},
        {"POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0),\n (1 1, 5 1, 2 2, 1 1))",
         ":2: hole 1: edge 1 from (1, 1) to (5, 1) crosses edge 2 from (4, 0) to (4, 4) of the "
         "outer ring; a hole must lie inside"},
        {"POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (5 5, 6 5, 6 6, 5 5))",
         ":1: hole 1: point 1 at (5, 5) lies outside the outer ring"},
        {"MULTIPOLYGON (((0 0, 1 0, 1 1, 0 0)),\n((0 0, 1 1, 1 0, 0 1, 0 0)))",
         ":2: polygon 2: edge 1 from (0, 0) to (1, 1) crosses edge 3 from (1, 0) to (0, 1); edges "
         "may meet only where one ends and the next begins"}};
    for (const auto& [text, message] : wrong) CHECK(folder.error(text) == message);
}
