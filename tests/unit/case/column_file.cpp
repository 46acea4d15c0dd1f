// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/language/column_file.h"

#include <catch2/catch.hpp>

using namespace sphinx::language;

namespace {

using Numbers = std::vector<std::array<double, 2>>;

Numbers numbersOf(const std::string& text, const FileColumn& a, const FileColumn& b) {
    std::optional<ColumnFileError> error;
    const TwoColumns columns = readTwoColumns(text, {a, b}, error);
    INFO((error ? error->message : ""));
    REQUIRE(!error);
    Numbers numbers;
    for (const TwoColumns::Row& row : columns.rows) numbers.push_back(row.numbers);
    return numbers;
}

std::string errorOf(const std::string& text, const FileColumn& a, const FileColumn& b) {
    std::optional<ColumnFileError> error;
    readTwoColumns(text, {a, b}, error);
    REQUIRE(error);
    return std::to_string(error->line) + ": " + error->message;
}

const FileColumn first{"", 1}, second{"", 2}, third{"", 3};
const Numbers expected{{0, 1}, {0.5, -2}};

}  // namespace

TEST_CASE("Columns by number, with any separator") {
    CHECK(numbersOf("0 1\n0.5 -2\n", first, second) == expected);
    CHECK(numbersOf("  0\t1 \n0.5\t-2", first, second) == expected);
    CHECK(numbersOf("0;1\r\n0.5;-2\r\n\r\n", first, second) == expected);
    CHECK(numbersOf("\xEF\xBB\xBF"
                    "0,1\n\n# so far\n0.5, -2 # there\n",
                    first, second) == expected);
    CHECK(numbersOf("1,left,0\n-2,,5e-1\n", third, first) == expected);
    CHECK(numbersOf("t, x\n0, 1\n0.5, -2\n", first, second) == expected);
    CHECK(numbersOf("", first, second).empty());
}

TEST_CASE("Columns by the names above them") {
    CHECK(numbersOf("x [m];t\n1;0\n-2;0.5\n", {"t", 0}, {"x [m]", 0}) == expected);
    CHECK(numbersOf("\"t\",\"x, along\"\n", {"t", 0}, {"t", 0}).empty());
    CHECK(numbersOf("# made by hand\n# t x\n0 1\n0.5 -2\n", {"t", 0}, {"x", 0}) == expected);
    CHECK(numbersOf("t,x\n0,1\n0.5,-2\n", {"t", 0}, second) == expected);
}

TEST_CASE("What is wrong with a file of columns, and in which line") {
    CHECK(errorOf("t,x\n0,1\n0.5\n", first, second) == "3: column 2 has no value");
    CHECK(errorOf("t,x\n0,1\n,2\n", {"t", 0}, second) == "3: 't' has no value");
    CHECK(errorOf("0;1\n0,5;-2\n", first, second) == "2: column 1 is '0,5', not a number");
    CHECK(errorOf("t x\n0 1\n", {"time", 0}, {"x", 0}) ==
          "1: there is no column 'time'; known: t, x");
    CHECK(errorOf("0 1\n", {"t", 0}, {"x", 0}).starts_with("1: no line of names"));
    CHECK(errorOf("0 1\nt x\n", first, second) == "2: column 1 is 't', not a number");
}
