// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/declaration/sources.h"

#include "case/language/register.h"
#include "input/declaration/describe.h"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace sphinx;
using namespace sphinx::input;

TEST_CASE("publications stand in the order of their keys, each once") {
    const auto all = publications();
    const auto not_before = [](const Publication& a, const Publication& b) {
        return a.key >= b.key;
    };
    CHECK(std::adjacent_find(all.begin(), all.end(), not_before) == all.end());
    CHECK(findPublication("guide")->key == "guide");
    CHECK(findPublication("nobody 1900") == nullptr);
    for (const Publication& one : all) CHECK((one.doi.empty() || one.doi.starts_with("10.")));
}

TEST_CASE("every publication is cited, and the reference page ends with the list") {
    Registry registry;
    language::registerAll(registry);
    const std::string page = referencePage(registry);
    const std::size_t list = page.find("\n## Sources\n");
    REQUIRE(list != page.npos);
    for (const Publication& one : publications()) {
        INFO(one.key);
        CHECK(page.find(std::string(one.key)) < list);
        CHECK(page.find("- " + std::string(one.key) + ": " + fullCitation(one)) > list);
    }
    CHECK_THAT(describeText(registry, "wendland_c2"),
               Catch::Contains("source    Wendland 1995: H. Wendland"));
}
