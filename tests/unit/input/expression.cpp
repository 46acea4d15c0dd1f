// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/expressions/scope.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <thread>

using namespace sphinx;
using namespace sphinx::input;

namespace {

struct Fixture {
    Scope scope;
    Diagnostics diagnostics;
    UnitSystem units;

    explicit Fixture(std::initializer_list<std::pair<const char*, const char*>> variables = {}) {
        Node map = Node::map();
        for (const auto& [name, text] : variables) map.set(name, Node::plain(text));
        scope.define(map, units, diagnostics);
    }
    double value(const std::string& text, Dimension dimension = unit::none) {
        const auto value = scope.number(Node::plain(text), dimension, "value", units, diagnostics);
        INFO(diagnostics.text());
        REQUIRE(value);
        return *value;
    }
    std::string error(const std::string& text, Dimension dimension = unit::none) {
        Diagnostics own;
        CHECK(!scope.number(Node::plain(text), dimension, "value", units, own));
        return own.text();
    }
    FieldExpression field(const std::string& text) {
        const auto field =
            scope.field(Node::plain(text), unit::none, "value", units, 3, diagnostics);
        INFO(diagnostics.text());
        REQUIRE(field);
        return *field;
    }
};

}  // namespace

TEST_CASE("Numbers are decimal") {
    Fixture f;
    CHECK(f.value("010") == 10);
    CHECK(f.value("-.5") == -0.5);
    CHECK(f.value("+3") == 3);
    CHECK(f.value("1e-3") == 1e-3);
    CHECK(f.value("2.") == 2);
    CHECK(f.error("1e999") ==
          "error: value: '1e999' is beyond the range of numbers, 1e-307 to 1e308\n");
    CHECK(f.error("0x1F") == "error: value: '0x1F' is not a number\n");
    CHECK(f.error("1_000") == "error: value: '1_000' is not a number\n");
    CHECK(f.error("nan") == "error: there is no variable 'nan'; the case defines no variables\n");
    CHECK(f.error("  ") == "error: value has no value\n");
}

TEST_CASE("Expressions follow the usual rules of precedence") {
    Fixture f({{"a", "2"}, {"b", "a + 1"}});
    CHECK(f.value("-a^2") == -4);
    CHECK(f.value("2^3^2") == 512);
    CHECK(f.value("a*-b") == -6);
    CHECK(f.value("10 - 4 - 3") == 3);
    CHECK(f.value("b > a ? 7 : 8") == 7);
    CHECK(f.value("a < 1 || b == 3 && a != 3") == 1);
    CHECK(f.value("max(1, b, a) + min(4, 5)") == 7);
    CHECK(f.value("atan2(1, 1)") == std::atan2(1.0, 1.0));
    CHECK(f.value("ln(e) + log10(1000) + sqrt(16) + abs(-1)") == 9);
    CHECK(f.value("sin(pi/2)") == 1);
    CHECK(f.value("2*sqrt(9.81*0.5)") == 2 * std::sqrt(9.81 * 0.5));
}

TEST_CASE("Wrong expressions are explained") {
    Fixture f({{"a", "2"}});
    CHECK(f.error("a = 3") == "error: value: '=' does not belong here; equality is written ==\n");
    CHECK(f.error("2 a") == "error: value: an operator is missing before 'a'\n");
    CHECK(f.error("a a") == "error: value: an operator is missing before 'a'\n");
    CHECK(f.error("(a") == "error: value: '(' is never closed\n");
    CHECK(f.error("a)") == "error: value: ')' without '('\n");
    CHECK(f.error("a ? 1") == "error: value: '?' without ':'\n");
    CHECK(f.error("max()") == "error: value: too few arguments for max\n");
    CHECK(f.error("sin(1, 2)") == "error: value: too many arguments for sin\n");
    CHECK(f.error("sin") == "error: sin is a function: sin(...)\n");
    CHECK(f.error("a(1)").starts_with("error: there is no function 'a'"));
    CHECK(f.error("1/0") == "error: value is inf, not a finite number\n");
    CHECK(f.error("ln(-1)").find("not a finite number") != std::string::npos);
    for (const char* text :
         {"+",    "*",      "a+",      "()",   ",",     "1,2", "?:",   ":",  "a ? : 2", "!a",
          "a &&", "max(,)", "max(1,)", "((((", "a ! b", "..",  "1..2", "1e", "\"",      "#"}) {
        INFO(text);
        CHECK(!f.error(text).empty());
    }
}

TEST_CASE("A quantity is number, blank, unit") {
    Fixture f({{"depth", "50 cm"}});
    CHECK(f.value("depth", unit::length) == 0.5);
    CHECK(f.value("2 cm", unit::length) == 0.02);
    CHECK(f.value("1e3 kg/m^3", unit::density) == 1000);
    CHECK(f.value("30 deg") == Approx(std::numbers::pi / 6));
    CHECK(f.error("2 s", unit::length) == "error: value needs a unit like m, but s is time\n");
    CHECK(f.error("2cm", unit::length) ==
          "error: a blank is missing between number and unit: '2 cm'\n");
    f.units.none = true;
    CHECK(f.error("2 cm", unit::length).find("units: none") != std::string::npos);
    CHECK(f.value("90 deg") == Approx(std::numbers::pi / 2));
}

TEST_CASE("What was given with a unit keeps its dimension") {
    Fixture f({{"L", "2 m"}, {"T", "4 s"}, {"g", "9.81 m/s^2"}, {"h", "0.3"}, {"v", "sqrt(g*L)"}});
    CHECK(f.diagnostics.text().empty());
    CHECK(f.value("L", unit::length) == 2);
    CHECK(f.value("-(L + h)", unit::length) == -2.3);
    CHECK(f.value("L/T", unit::velocity) == 0.5);
    CHECK(f.value("L^2", unit::area) == 4);
    CHECK(f.value("max(L, h) + v*T", unit::length) > 2);
    // Bare numbers, and what is made of them, fit anything.
    CHECK(f.value("h", unit::time) == 0.3);
    CHECK(f.value("10*L", unit::velocity) == 20);
    CHECK(f.value("sqrt(g*h)", unit::velocity) > 0);
    CHECK(f.value("L > h ? 1 : 2", unit::time) == 1);

    CHECK(f.error("L", unit::time) == "error: value needs a unit like s, but 'L' is length\n");
    CHECK(f.error("-g", unit::velocity) ==
          "error: value needs a unit like m/s, but '-g' is length/time^2\n");
    CHECK(f.error("L/T") == "error: value is a plain number, but 'L/T' is length/time\n");
    CHECK(f.error("h*(L + T)", unit::length) ==
          "error: value: length and time do not go together\n");
    CHECK(f.error("min(L, h, T)", unit::length) ==
          "error: value: length and time do not go together\n");
}

TEST_CASE("Expressions of place and time") {
    Fixture f({{"wave", "0.05"}});
    const FieldExpression field = f.field("wave*cos(2*x) + y*z - t");
    CHECK(!field.constant());
    CHECK(field.dependsOnTime());
    CHECK(field(Vec<3>(1, 2, 3), 4) == 0.05 * std::cos(2.0) + 2 * 3 - 4);
    CHECK(f.field("2*wave").constant());
    CHECK(f.field("2*wave").value() == 0.1);
    CHECK(field.dependsOnPlace());
    CHECK(!f.field("x").dependsOnTime());
    CHECK(f.field("x").dependsOnPlace());
    CHECK(!f.field("wave*t").dependsOnPlace());
    CHECK(!f.field("2*wave").dependsOnPlace());
    CHECK(f.field("x")(Vec<2>(7, 8), 0) == 7);
    CHECK(f.scope.usedByFields().find("wave")->text == "0.05");
    CHECK(f.error("x + 1").find("initial values and profiles only") != std::string::npos);
}

TEST_CASE("Variables of place and time") {
    Fixture f({{"T", "2 s"},
               {"phase", "2*pi*t/T"},
               {"ramp", "min(t/T, 1)"},
               {"wave", "ramp*sin(phase - k*x)"},
               {"k", "3"},
               {"unused", "x*y"}});
    REQUIRE(f.diagnostics.text().empty());
    const FieldExpression field = f.field("2*wave + ramp");
    CHECK(field.dependsOnTime());
    CHECK(field.dependsOnPlace());
    CHECK(!f.field("cos(phase)").dependsOnPlace());
    CHECK(field.text() == "2*wave + ramp");
    for (const double t : {0.0, 0.3, 5.0}) {
        const double ramp = std::min(t / 2, 1.0);
        const double wave = ramp * std::sin(2 * std::numbers::pi * t / 2 - 3 * 0.7);
        CHECK(field(Vec<2>(0.7, 0), t) == 2 * wave + ramp);
    }
    // The resolved case needs them, and what they need.
    const Node used = f.scope.usedByFields();
    REQUIRE(used.entries.size() == 5);
    CHECK(used.find("phase")->text == "2*pi*t/T");
    CHECK(used.find("T")->text == "2");
    CHECK(used.find("k")->text == "3");
    CHECK(!used.find("unused"));

    CHECK(f.error("phase") ==
          "error: the variable 'phase' depends on t: it may be used in initial values and profiles "
          "only\n");
    CHECK(f.error("1 + 2*wave") ==
          "error: the variable 'wave' depends on t and x (through 'phase'): it may be used in "
          "initial values and profiles only\n");
    Diagnostics own;
    CHECK(!f.scope.field(Node::plain("k)*phase"), unit::none, "value", {}, 2, own));
    CHECK(
        !f.scope.field(Node::plain("phase + wave + phase phase"), unit::none, "value", {}, 2, own));
    CHECK(!f.scope.field(Node::plain("phase + sin(wave, phase)"), unit::none, "value", {}, 2, own));
    CHECK(own.errors() == 3);
}

TEST_CASE("Variables of place and time keep their dimension, and depend on no one's order") {
    Fixture f({{"a", "b + L"}, {"b", "L*sin(t)"}, {"L", "2 m"}, {"c", "d*t"}, {"d", "c + 1"}});
    CHECK(f.diagnostics.text().find("the variables depend on each other: c -> d -> c") !=
          std::string::npos);
    Diagnostics own;
    CHECK(f.scope.field(Node::plain("a"), unit::length, "value", {}, 2, own));
    CHECK(own.text().empty());
    CHECK(!f.scope.field(Node::plain("L + a/t"), unit::length, "value", {}, 2, own) ==
          own.errors());
}

TEST_CASE("A variable is worked out once, and only where the condition wants it") {
    // Each doubles the one before: by copies of its text 2^60 terms.
    std::vector<std::string> names, texts;
    for (int k = 0; k < 60; ++k) {
        names.push_back("v" + std::to_string(k));
        texts.push_back(k == 0 ? "t" : names[k - 1] + "/2 + " + names[k - 1] + "/2");
    }
    Node map = Node::map();
    for (int k = 0; k < 60; ++k) map.set(names[k], Node::plain(texts[k]));
    map.set("root", Node::plain("1/(t - 1)"));
    Scope scope;
    Diagnostics diagnostics;
    scope.define(map, {}, diagnostics, 2);
    const auto last = scope.field(Node::plain("v59"), unit::none, "value", {}, 2, diagnostics);
    REQUIRE(last);
    CHECK((*last)(Vec<2>(0, 0), 0.75) == 0.75);
    CHECK((*last)(Vec<2>(0, 0), 2) == 2);
    const auto chosen =
        scope.field(Node::plain("t == 1 ? 7 : root"), unit::none, "value", {}, 2, diagnostics);
    CHECK((*chosen)(Vec<2>(0, 0), 1) == 7);
    CHECK((*chosen)(Vec<2>(0, 0), 3) == 0.5);
}

TEST_CASE("Many threads evaluate one expression") {
    Fixture f({{"ten", "10*y"}});
    const FieldExpression field = f.field("x + ten");
    std::vector<int> wrong(4, 0);
    std::vector<std::thread> threads;
    for (int k = 0; k < 4; ++k)
        threads.emplace_back([&, k] {
            for (int n = 0; n < 2000; ++n)
                if (field(Vec<2>(n, k), 0) != n + 10 * k) ++wrong[k];
        });
    for (std::thread& thread : threads) thread.join();
    CHECK(wrong == std::vector<int>(4, 0));
}

TEST_CASE("Variables nobody uses are warned of") {
    Node map = Node::map();
    auto source = std::make_shared<Source>();
    source->name = "case.yaml";
    source->text = "a: 1\nb: 2\n";
    map.set("a", Node::plain("1").at({source, 1, 1}));
    map.set("b", Node::plain("2").at({source, 2, 1}));
    Scope scope;
    Diagnostics diagnostics;
    scope.define(map, {}, diagnostics);
    scope.number(Node::plain("a"), unit::none, "value", {}, diagnostics);
    scope.warnUnused(diagnostics);
    CHECK(diagnostics.text() ==
          "case.yaml:2:1: warning: the variable 'b' is never used\n  b: 2\n  ^\n");
}
