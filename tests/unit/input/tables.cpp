// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/errors.h"
#include "input/expressions/scope.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <thread>

using namespace sphinx;
using namespace sphinx::input;

namespace {

using Numbers = std::vector<double>;

TabulatedFunction function(Numbers x, Numbers y, Interpolation interpolation,
                           Outside outside = Outside::error) {
    return {"f", {std::move(x), {}}, {std::move(y), {}}, interpolation, outside, {}};
}

/// The scope of a case with a table `paddle` of angles by time.
struct Fixture {
    Scope scope;
    Diagnostics diagnostics;
    UnitSystem units;
    Node tables = Node::map();

    explicit Fixture(Outside outside = Outside::error,
                     std::initializer_list<std::pair<const char*, const char*>> variables = {}) {
        tables.set("paddle", Node::map());
        const auto read = [outside](const Node::Entry& entry) {
            return std::make_shared<const TabulatedFunction>(
                entry.key, TabulatedFunction::Column{{0, 1, 3}, unit::time},
                TabulatedFunction::Column{{0, 2, 0}, unit::length}, Interpolation::linear, outside,
                UnitSystem{});
        };
        scope.declareTables(tables, read, diagnostics);
        Node map = Node::map();
        for (const auto& [name, text] : variables) map.set(name, Node::plain(text));
        scope.define(map, units, diagnostics);
    }
    std::string error(const std::string& text, Dimension dimension = unit::length) {
        Diagnostics own;
        CHECK(!scope.field(Node::plain(text), dimension, "value", units, 2, own));
        return own.text();
    }
    FieldExpression field(const std::string& text, Dimension dimension = unit::length) {
        const auto field =
            scope.field(Node::plain(text), dimension, "value", units, 2, diagnostics);
        INFO(diagnostics.text());
        REQUIRE(field);
        return *field;
    }
};

const Vec<2> here(0.5, 2);

}  // namespace

TEST_CASE("A table is straight between its rows and has their values there") {
    const TabulatedFunction f = function({-1, 0, 0.3, 2}, {5, 1, 1, -3}, Interpolation::linear);
    CHECK(f(-1) == 5);
    CHECK(f(0) == 1);
    CHECK(f(0.3) == 1);
    CHECK(f(2) == -3);
    CHECK(f(-0.25) == 2);
    CHECK(f(1.15) == Approx(-1).epsilon(1e-15));
    CHECK(std::isnan(f(nan_value)));
}

TEST_CASE("A cubic table is the natural spline") {
    // By hand: M_1 = 6 (s_1 - s_0)/(2 (h_0 + h_1)) = 6 (-1 - 2)/(2*3) = -3, and in the middle of
    // the first piece 1 + ((1/8 - 1/2) M_1) h^2/6 = 1 + 0.1875.
    const TabulatedFunction three = function({0, 1, 3}, {0, 2, 0}, Interpolation::cubic);
    CHECK(three(0.5) == Approx(1 + 0.1875).epsilon(1e-15));
    CHECK(three(1) == 2);
    CHECK(three(3) == 0);

    // A line stays one; where the function has no curvature at the ends the error falls with h^4.
    const TabulatedFunction line = function({0, 1, 4, 5}, {1, 3, 9, 11}, Interpolation::cubic);
    CHECK(line(2.5) == Approx(6).epsilon(1e-15));
    const auto largestError = [](int pieces) {
        Numbers x, y;
        for (int k = 0; k <= pieces; ++k) {
            x.push_back(2 * std::numbers::pi * k / pieces);
            y.push_back(std::sin(x.back()));
        }
        const TabulatedFunction f = function(x, y, Interpolation::cubic);
        double largest = 0;
        for (double t = 0; t < 6.28; t += 0.001)
            largest = std::max(largest, std::abs(f(t) - std::sin(t)));
        return largest;
    };
    CHECK(largestError(20) < 1e-4);
    CHECK(largestError(20) / largestError(40) == Approx(16).epsilon(0.1));
}

TEST_CASE("The natural spline bends smoothly from piece to piece") {
    const TabulatedFunction f =
        function({0, 0.5, 2, 2.4, 4}, {0, 1, -1, 3, 2}, Interpolation::cubic);
    const double h = 1e-4;
    const auto bend = [&](double x) { return (f(x - h) - 2 * f(x) + f(x + h)) / (h * h); };
    for (const double knot : {0.5, 2.0, 2.4}) {
        CHECK((f(knot + h) - f(knot)) / h == Approx((f(knot) - f(knot - h)) / h).margin(0.01));
        CHECK(bend(knot - 2 * h) == Approx(bend(knot + 2 * h)).margin(0.05));
    }
    CHECK(bend(2 * h) == Approx(0).margin(0.05));
    CHECK(bend(4 - 2 * h) == Approx(0).margin(0.05));
}

TEST_CASE("Outside of its rows a table is held or is an error") {
    const TabulatedFunction held = function({0, 1}, {3, 4}, Interpolation::linear, Outside::hold);
    CHECK(held(-1) == 3);
    CHECK(held(9) == 4);
    CHECK(held.continued(9) == 4);
    const TabulatedFunction strict = function({0, 1}, {3, 4}, Interpolation::linear);
    CHECK_THROWS_AS(strict(1.001), OutsideTable);
    CHECK_THROWS_AS(strict(-0.001), OutsideTable);
    CHECK(strict.continued(3) == 6);
}

TEST_CASE("Tables in expressions") {
    Fixture f;
    CHECK(f.field("paddle(t)")(here, 0.5) == 1);
    CHECK(f.field("paddle(t)").dependsOnTime());
    CHECK(!f.field("paddle(t)").dependsOnPlace());
    CHECK(f.field("2*paddle(2*x) + y")(here, 7) == 6);
    CHECK(f.field("paddle(0.5)").constant());
    CHECK(f.field("paddle(0.5)").value() == 1);
    CHECK(f.error("paddel(t)")
              .starts_with("error: there is no function 'paddel'; did you mean 'paddle'?"));
    CHECK(f.error("paddle + 1") == "error: paddle is a table: paddle(...)\n");
    CHECK(f.error("paddle(t, 1)") == "error: value: too many arguments for paddle\n");
    CHECK(f.error("paddle()") == "error: value: too few arguments for paddle\n");
    CHECK(f.error("paddle(4)") ==
          "error: value: the table 'paddle' has values from 0 s to 3 s, but none at 4 s\n");
}

TEST_CASE("The dimensions of a table are checked where they are known") {
    Fixture f(Outside::error, {{"T", "2 s"}, {"L", "1 m"}, {"n", "2"}});
    CHECK(f.field("paddle(T)").value() == 1);
    CHECK(f.field("paddle(n)").value() == 1);
    CHECK(f.field("L + paddle(t/n)")(here, 1) == 2);
    CHECK(f.error("paddle(L)") ==
          "error: value: the argument of paddle is length but must be time\n");
    CHECK(f.error("paddle( x )") ==
          "error: value: the argument of paddle is length but must be time\n");
    CHECK(f.error("T + paddle(t)") == "error: value: time and length do not go together\n");
    CHECK(f.error("paddle(t)", unit::time) ==
          "error: value needs a unit like s, but 'paddle(t)' is length\n");
}

TEST_CASE("Asked for what it does not have a table stops the run with place and time") {
    Fixture f;
    CHECK(f.field("paddle(2*x)")(here, 0) == 2);
    CHECK_THROWS_WITH(f.field("paddle(2*x)")(Vec<2>(2, 0.5), 7),
                      "the table 'paddle' has values from 0 s to 3 s, but 'paddle(2*x)' asks it "
                      "for 4 s at (2, 0.5) m and at time 7 s");
    CHECK_THROWS_WITH(f.field("paddle(t + 1)")(here, 2.5),
                      "the table 'paddle' has values from 0 s to 3 s, but 'paddle(t + 1)' asks it "
                      "for 3.5 s at time 2.5 s");
    // Of the time alone it is known before the run; the last step may end later.
    CHECK(f.field("paddle(t)")(here, 4) == -1);
    CHECK(f.scope.timedCalls().size() == 1);
    CHECK_THROWS_AS(f.field("t < 9 ? paddle(t) : 0")(here, 4), PhysicsError);
    CHECK(f.field("t < 3 ? paddle(t) : 0")(here, 4) == 0);
    CHECK(f.scope.timedCalls().size() == 1);
    CHECK(Fixture(Outside::hold).field("paddle(t + 1)")(here, 9) == 0);
}

TEST_CASE("Tables in variables") {
    Fixture f(Outside::error, {{"angle", "paddle(t)/2"},
                               {"late", "paddle(t - 1)"},
                               {"top", "paddle(1)"},
                               {"unused", "paddle(t)"}});
    CHECK(f.field("top").constant());
    CHECK(f.field("angle + top")(here, 0.5) == 2.5);
    CHECK(f.scope.timedCalls().size() == 1);
    CHECK(f.field("angle")(here, 4) == -0.5);
    CHECK(f.field("t < 1 ? 0 : late")(here, 0) == 0);
    CHECK(f.field("t < 1 ? 0 : late")(here, 2) == 2);
    CHECK_THROWS_AS(f.field("late")(here, 0), PhysicsError);
    CHECK_THROWS_AS(f.field("t < 9 ? angle : 0")(here, 4), PhysicsError);
    CHECK(f.scope.isUsedByFields("paddle"));
}

TEST_CASE("Names of tables and variables are one another's") {
    Fixture f(Outside::error, {{"paddle", "1"}});
    CHECK(f.diagnostics.text() == "error: 'paddle' is a table already\n");
    Scope scope;
    Diagnostics diagnostics;
    Node tables = Node::map();
    for (const char* name : {"sin", "t", "pi"}) tables.set(name, Node::map());
    scope.declareTables(tables, {}, diagnostics);
    CHECK(diagnostics.errors() == 3);
    CHECK(diagnostics.text().find("'sin' is reserved for expressions") != std::string::npos);
    CHECK(!scope.hasTable("sin"));
}

TEST_CASE("Many threads ask one table") {
    Fixture f;
    const FieldExpression field = f.field("paddle(1*x)*y");
    std::vector<int> wrong(4, 0);
    std::vector<std::thread> threads;
    for (int k = 0; k < 4; ++k)
        threads.emplace_back([&, k] {
            for (int n = 0; n < 2000; ++n)
                if (field(Vec<2>(n / 2048.0, k), 0) != 2 * (n / 2048.0) * k) ++wrong[k];
        });
    for (std::thread& thread : threads) thread.join();
    CHECK(wrong == std::vector<int>(4, 0));
}
