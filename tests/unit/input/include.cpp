// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/tree/load.h"

#include "../temporary_folder.h"

#include <catch2/catch.hpp>
#include <fstream>

using namespace sphinx;
using namespace sphinx::input;

namespace {

/// A file in a folder of its own, and what a case that includes it resolves to.
class Included {
 public:
    explicit Included(const std::string& text) { std::ofstream(folder_ / "base.yaml") << text; }

    Node by(const std::string& text) const {
        Diagnostics diagnostics;
        LoadedCase loaded = loadText((folder_ / "case.yaml").string(),
                                     "include: [base.yaml]\n" + text, {}, {}, diagnostics);
        INFO(diagnostics.text());
        REQUIRE(!diagnostics.hasErrors());
        return std::move(loaded.root);
    }

 private:
    test::TemporaryFolder folder_;
};

const Node& at(const Node& node, const char* first, const char* second) {
    return *node.find(first)->find(second);
}

}  // namespace

TEST_CASE("maps of an included file merge by key") {
    const Included base(
        "geometry: {liquid: {box: {lower: [0, 0], upper: [1, 1]}}}\n"
        "materials: {water: {type: fluid, density: 1000, sound_speed: 20}}\n");
    const Node root = base.by(
        "geometry: {liquid: {box: {upper: [2, 1]}}}\n"
        "materials: {water: {density: 998}}\n");
    CHECK(at(root, "geometry", "liquid").find("box")->entries.size() == 2);
    CHECK(at(root, "materials", "water").entries.size() == 3);
    CHECK(at(root, "materials", "water").find("density")->text == "998");
}

TEST_CASE(
    "another shape, and a component of another type, stand in for those of an included file") {
    const Included base(
        "geometry: {liquid: {box: {lower: [0, 0], upper: [1, 1]}}}\n"
        "materials: {water: {type: fluid, density: 1000, sound_speed: 20}}\n");
    const Node root = base.by(
        "geometry: {liquid: {difference: [a, b]}}\n"
        "materials: {water: {type: rigid, density: 7}}\n");
    CHECK(at(root, "geometry", "liquid").entries.size() == 1);
    CHECK(at(root, "geometry", "liquid").find("difference"));
    CHECK(at(root, "materials", "water").entries.size() == 2);
    CHECK(!at(root, "materials", "water").find("sound_speed"));
}
