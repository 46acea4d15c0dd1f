// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/expressions/units.h"

#include <catch2/catch.hpp>

using namespace sphinx;
using namespace sphinx::input;

TEST_CASE("Units are products, quotients and powers of names") {
    const auto unit = [](const char* text) { return parseUnit(text).value(); };
    CHECK(unit("m/s^2").dimension == unit::acceleration);
    CHECK(unit("kg/m^3").dimension == unit::density);
    CHECK(unit("kg/m/m/m").dimension == unit::density);
    CHECK(unit("Pa*s").dimension == unit::dynamic_viscosity);
    CHECK(unit("kg/(m*s)").dimension == unit::dynamic_viscosity);
    CHECK(unit("1/s").dimension == unit::frequency);
    CHECK(unit("s^-1").dimension == unit::frequency);
    CHECK(unit("W").dimension == unit::energy / unit::time);
    for (const char* wrong : {"", "1", "x", "m/", "/s", "m^", "m^0", "m^99", "(m)", "m s",
                              "kg/(m*s", "m**2", "1/", "kg/(m/s)", "m^2.5"}) {
        INFO(wrong);
        CHECK(!parseUnit(wrong));
    }
}

TEST_CASE("Powers of ten scale exactly") {
    const UnitSystem si;
    const auto convert = [&](const UnitSystem& system, double value, const char* unit) {
        return system.convert(value, *parseUnit(unit));
    };
    CHECK(convert(si, 2, "cm") == 0.02);
    CHECK(convert(si, 30, "min") == 1800);
    CHECK(convert(si, 7.8, "MPa") == 7.8e6);
    CHECK(convert(si, 7.8, "mPa") == 7.8e-3);
    CHECK(convert(si, 1.002, "mPa*s") == 1.002e-3);
    const UnitSystem small{false, "mm", "ms", "mg"};
    CHECK(convert(small, 7.8, "MPa") == 7.8e3);  // 1 mg/(mm ms^2) is 1 kPa
    CHECK(convert(small, 9.8, "m/s^2") == 9.8e-3);
    CHECK(convert(small, 1000, "kg/m^3") == 1);
    CHECK(small.text(unit::density) == "mg/mm^3");
    CHECK(small.text(unit::pressure) == "mg/(mm*ms^2)");
    CHECK(si.text(unit::none).empty());
    CHECK(si.suffix(unit::none).empty());
    CHECK(si.suffix(unit::pressure) == " Pa");
}

TEST_CASE("A wrong unit is named by its wrong factor") {
    CHECK(suggestUnit("kg/mn").find("did you mean 'm") != std::string::npos);
    CHECK(suggestUnit("m/sekunde").starts_with("; known: m, km"));
}
