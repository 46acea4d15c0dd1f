// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/errors.h"
#include "input/expressions/decimal.h"
#include "input/tree/diagnostics.h"
#include "input/tree/suggest.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace sphinx;
using namespace sphinx::input;

TEST_CASE("Edit distance counts exchanged neighbors once") {
    CHECK(editDistance("water", "water") == 0);
    CHECK(editDistance("watre", "water") == 1);
    CHECK(editDistance("wter", "water") == 1);
    CHECK(editDistance("", "abc") == 3);
    CHECK(editDistance("kitten", "sitting") == 3);
}

TEST_CASE("A suggestion is near, else all names are listed") {
    const std::vector<std::string> known{"wall", "water", "gate"};
    CHECK(didYouMean("watr", known) == "; did you mean 'water'?");
    CHECK(didYouMean("ocean", known) == "; known: wall, water, gate");
    CHECK(didYouMean("x", {"y"}) == "; known: y");
    CHECK(didYouMean("sort", {"particles.sort"}) == "; did you mean 'particles.sort'?");
    CHECK(didYouMean("sort", {}).empty());
    CHECK(alternatives({"a", "b", "c"}) == "a, b or c");
    CHECK(withArticle("elastic body") == "an elastic body");
    CHECK(withArticle("unit") == "a unit");
}

TEST_CASE("Decimal numbers are read strictly") {
    CHECK(parseDecimal<double>("0.1") == 0.1);
    CHECK(parseDecimal<std::int64_t>("010") == 10);
    CHECK(parseDecimal<std::int64_t>("-7") == -7);
    CHECK(parseDecimal<double>("+.5") == 0.5);
    for (const char* wrong :
         {"", "-", "+-1", "+", "inf", "nan", "-inf", "0x10", "1 ", " 1", "1,5"}) {
        INFO(wrong);
        CHECK(!parseDecimal<double>(wrong));
    }
    CHECK(!parseDecimal<std::int64_t>("99999999999999999999"));
    CHECK(!parseDecimal<std::int64_t>("1.5"));
}

TEST_CASE("Messages are sorted by place, carets stand under characters") {
    auto source = std::make_shared<Source>();
    source->name = "case.yaml";
    source->text =
        "first: 1\n\tgr\xC3\xB6\xC3\x9F"
        "e: 2\r\n";
    Diagnostics diagnostics;
    diagnostics.error({source, 2, 11}, "second");
    diagnostics.warning({source, 1, 8}, "first");
    diagnostics.error({source, 2, 11}, "second");  // an alias repeats it
    CHECK(diagnostics.text() ==
          "case.yaml:1:8: warning: first\n  first: 1\n         ^\n"
          "case.yaml:2:9: error: second\n  \tgr\xC3\xB6\xC3\x9F"
          "e: 2\n  \t       ^\n");
    CHECK_THROWS_AS(diagnostics.throwIfErrors(), CaseError);
}

TEST_CASE("Of a long line the part around the column is shown") {
    auto source = std::make_shared<Source>();
    source->name = "case.yaml";
    source->text = std::string(10001, 'a');
    source->text[5000] = 'b';
    std::fill(source->text.begin() + 5001, source->text.end(), 'c');
    Diagnostics diagnostics;
    diagnostics.error({source, 1, 5001}, "here");
    const std::string text = diagnostics.text();
    CHECK(text.size() < 600);
    const auto shown = text.find('\n') + 1;
    const auto caret = text.find('^') - (text.find('\n', shown) + 1);
    CHECK(text[shown + caret] == 'b');
}
