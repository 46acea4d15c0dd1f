// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
// The terms of fluids on two particles, by hand and for every type of number.
#include "dynamics/fluid/terms/interface.h"
#include "dynamics/fluid/terms/pressure.h"
#include "dynamics/fluid/terms/viscosity.h"
#include "dynamics/fluid/terms/wall.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <type_traits>

using namespace sphinx;
using namespace sphinx::dynamics;
using namespace sphinx::dynamics::fluid;

namespace {

constexpr RiemannConstants water{2, 10};  // rho0 c0 = 20
constexpr double slope = 3;               // abs(W')

/// j lies below i: e_ij = (0.6, 0.8), (0.6, 0, 0.8) in 3D.
template <int Dim, class Number>
Pair<Dim, Number> pairAbove() {
    Pair<Dim, Number> pair;
    for (Number& g : pair.gradient) g = Number{};
    pair.gradient[0] = everywhere<Number>(-0.6 * slope);
    pair.gradient[Dim - 1] = everywhere<Number>(-0.8 * slope);
    pair.dW = everywhere<Number>(slope);
    pair.inverse_dW = everywhere<Number>(1 / slope);
    return pair;
}

/// The value along e_ij, with something across that must not matter.
template <int Dim, class Number>
void along(double value, Number (&v)[Dim]) {
    for (Number& c : v) c = Number{};
    v[0] = everywhere<Number>(0.6 * value + 0.8 * 7);
    v[Dim - 1] = everywhere<Number>(0.8 * value - 0.6 * 7);
}

template <class Number>
double laneOf(Number a, int k) {
    if constexpr (std::is_arithmetic_v<Number>)
        return a;
    else
        return a[k];
}

/// All lanes have that value, to the precision of the number.
template <class Number>
void checkValue(Number a, double expected) {
    const double precision = std::is_same_v<ScalarOf<Number>, float> ? 1e-6 : 1e-14;
    for (int k = 0; k < static_cast<int>(sizeof(Number) / sizeof(ScalarOf<Number>)); ++k)
        CHECK(laneOf(a, k) == Approx(expected).epsilon(precision).margin(precision));
}

template <int Dim, class Number, Riemann R>
void checkPressure(double closing, double expected) {
    Number v_ij[Dim];
    along<Dim>(-closing, v_ij);
    const auto pair = pairAbove<Dim, Number>();
    const auto p = [](double value) { return everywhere<Number>(value); };
    checkValue(twicePressure<R, Dim>(water, pair, v_ij, p(5), p(8)), expected);
    // Seen from j it is the same.
    Number v_ji[Dim];
    for (int c = 0; c < Dim; ++c) v_ji[c] = -v_ij[c];
    checkValue(twicePressure<R, Dim>(water, pair.reversed(), v_ji, p(8), p(5)), expected);
}

template <int Dim, class Number>
void checkAllPressures() {
    checkPressure<Dim, Number, Riemann::none>(0.5, 13);
    // rho0 c0 (U_L - U_R), whatever its sign
    checkPressure<Dim, Number, Riemann::dissipative>(0.5, 13 + 20 * 0.5);
    checkPressure<Dim, Number, Riemann::dissipative>(-0.5, 13 - 20 * 0.5);
    // rho0 min(3 max(dU, 0), c0) dU
    checkPressure<Dim, Number, Riemann::low_dissipation>(0.5, 13 + 2 * 1.5 * 0.5);
    checkPressure<Dim, Number, Riemann::low_dissipation>(4, 13 + 2 * 10 * 4);
    checkPressure<Dim, Number, Riemann::low_dissipation>(-0.5, 13);
}

template <int Dim, class Number>
void checkClosingRates() {
    Number v_ij[Dim];
    along<Dim>(-0.5, v_ij);
    const auto pair = pairAbove<Dim, Number>();
    // -v_ij . e_ij abs(W') = 0.5 abs(W'), and the Riemann problem's part abs(W') (p_i - p_j)/(rho
    // c)
    checkValue(closingRate<Riemann::none, Dim>(water, pair, v_ij, everywhere<Number>(-4)),
               0.5 * slope);
    checkValue(
        closingRate<Riemann::low_dissipation, Dim>(water, pair, v_ij, everywhere<Number>(-4)),
        0.5 * slope + slope * 4 / 20);
}

/// Water and a liquid of three times its density and half its sound speed.
template <int Dim, class Number, Riemann R>
void checkInterface(double closing, double jump) {
    constexpr RiemannConstants brine{6, 5};  // rho0 c0 = 30
    const Interface of_water = interfaceOf(water, brine);
    const Interface of_brine = interfaceOf(brine, water);
    const auto number = [](double value) { return everywhere<Number>(value); };
    // p* is that of the lighter by three quarters, v* that of the heavier.
    const double p2 = 2 * (0.75 * 5 + 0.25 * 8) + jump;
    checkValue(twiceInterfacePressure<R>(of_water, number(closing), number(5), number(8)), p2);
    checkValue(twiceInterfacePressure<R>(of_brine, number(closing), number(8), number(5)), p2);
    const auto pair = pairAbove<Dim, Number>();
    Number v_ij[Dim];
    Number v_ji[Dim];
    along<Dim>(-closing, v_ij);
    for (int c = 0; c < Dim; ++c) v_ji[c] = -v_ij[c];
    checkValue(interfaceClosingRate<Dim>(of_water, pair, v_ij), 2 * 0.75 * closing * slope);
    checkValue(interfaceClosingRate<Dim>(of_brine, pair.reversed(), v_ji),
               2 * 0.25 * closing * slope);
    // Two equal liquids are one.
    checkValue(
        twiceInterfacePressure<R>(interfaceOf(water, water), number(closing), number(5), number(8)),
        laneOf(twicePressure<R, Dim>(water, pair, v_ij, number(5), number(8)), 0));
}

template <int Dim, class Number>
void checkInterfaces() {
    // 2 Z beta dU with Z = 20 30/50 = 12; c = (2 10 + 6 5)/8 = 6.25
    checkInterface<Dim, Number, Riemann::none>(0.5, 0);
    checkInterface<Dim, Number, Riemann::dissipative>(-0.5, -2 * 12 * 0.5);
    checkInterface<Dim, Number, Riemann::low_dissipation>(0.5, 2 * 12 * (3 * 0.5 / 6.25) * 0.5);
    checkInterface<Dim, Number, Riemann::low_dissipation>(4, 2 * 12 * 4);
    checkInterface<Dim, Number, Riemann::low_dissipation>(-0.5, 0);
}

/// A normal of a wall that is not along the line of the two.
template <int Dim, class Number>
void tilt(double side, Number (&n)[Dim]) {
    for (Number& component : n) component = Number{};
    n[0] = everywhere<Number>(0.6 * side);
    n[Dim - 1] = everywhere<Number>(0.8 * side);
}

/// A fluid particle at distance 0.1 above a wall that moves up at 1.
template <int Dim, class Number>
void checkWall() {
    FluidSide<Dim, Number> fluid;
    WallSide<Dim, Number> wall;
    along<Dim>(0.25, fluid.v);
    along<Dim>(1, wall.v);
    along<Dim>(-9, fluid.g);
    along<Dim>(-2, wall.a);
    fluid.p = everywhere<Number>(5);
    fluid.rho = everywhere<Number>(2);
    const auto pair = pairAbove<Dim, Number>();
    const auto r = everywhere<Number>(0.1);
    for (const double side : {1, -1}) {  // the normal is turned towards the fluid
        tilt<Dim>(side, wall.n);
        // Ghost: p + rho r (9 - 2); closing at 0.75, mirrored at 1.5: rho0 min(4.5, 10) 1.5.
        checkValue(
            twiceWallPressure<Riemann::low_dissipation, Dim, Number>(water, fluid, wall, pair, r),
            2 * 5 + 2 * 0.1 * 7 + 2 * 4.5 * 1.5);
        checkValue(wallClosingRate<Dim, Number>(fluid.v, wall, pair), 2 * 0.75 * slope);
    }
    along<Dim>(9, fluid.g);  // away from the wall: it does not pull
    checkValue(twiceWallPressure<Riemann::none, Dim, Number>(water, fluid, wall, pair, r), 2 * 5);
    fluid.least_pull = everywhere<Number>(-100);  // or does
    checkValue(twiceWallPressure<Riemann::none, Dim, Number>(water, fluid, wall, pair, r),
               2 * 5 - 2 * 0.1 * 11);
}

/// A fluid particle that moves away from a wall at rest.
template <int Dim, class Number>
void checkParting() {
    FluidSide<Dim, Number> fluid;
    WallSide<Dim, Number> wall;
    along<Dim>(0.25, fluid.v);
    along<Dim>(0, wall.v);
    along<Dim>(0, fluid.g);
    tilt<Dim>(1, wall.n);
    fluid.p = everywhere<Number>(1);
    fluid.rho = everywhere<Number>(2);
    const auto pair = pairAbove<Dim, Number>();
    const auto pressure = [&] {
        return twiceWallPressure<Riemann::dissipative, Dim, Number>(water, fluid, wall, pair,
                                                                    everywhere<Number>(0.1));
    };
    // The ghost moves away with the mirrored velocity; the normal part is 0.25 for both axes here.
    const Number held = pressure();
    fluid.least = Number{};  // a wall that cannot hold it
    const Number free = pressure();
    checkValue(held, 2 * 1 - 20 * 2 * 0.25);
    checkValue(free, 0);
}

template <ViscousForm F, int Dim, class Number>
void checkViscosity(const double (&expected)[2]) {
    Number v_ij[Dim];
    along<Dim>(-0.5, v_ij);
    const auto r = everywhere<Number>(0.1);
    const auto V = everywhere<Number>(0.02);
    const auto term = [&](const Pair<Dim, Number>& pair, const Number(&v)[Dim], int c) {
        return viscousFactor<F, Dim, Number>(pair, v, r, V) *
               viscousDirection<F, Dim, Number>(pair, v)[c];
    };
    const auto pair = pairAbove<Dim, Number>();
    checkValue(term(pair, v_ij, 0), expected[0]);
    checkValue(term(pair, v_ij, Dim - 1), expected[1]);
    // What i gets j loses.
    Number v_ji[Dim];
    for (int c = 0; c < Dim; ++c) v_ji[c] = -v_ij[c];
    checkValue(term(pair.reversed(), v_ji, 0), -expected[0]);
    checkValue(term(pair.reversed(), v_ji, Dim - 1), -expected[1]);
}

template <int Dim, class Number>
void checkContinuation() {
    const auto pair = pairAbove<Dim, Number>();
    Number n[Dim];
    for (Number& c : n) c = Number{};
    n[Dim - 1] = everywhere<Number>(-1);
    // Across the surface the two are 0.8 x 0.1 apart; the wall particle is 0.03 deep.
    const auto at = [&](double depth, double nearest) {
        return continuation<Dim, Number>(pair, everywhere<Number>(0.1), n,
                                         everywhere<Number>(depth), nearest);
    };
    checkValue(at(0.03, 0.001), 1 + 0.03 / 0.05);
    checkValue(at(0.03, 0.06), 1 + 0.03 / 0.06);
}

template <int Dim, class Number>
void checkAll() {
    checkAllPressures<Dim, Number>();
    checkClosingRates<Dim, Number>();
    checkInterfaces<Dim, Number>();
    checkWall<Dim, Number>();
    checkParting<Dim, Number>();
    // v W'/r V with v = (-0.3 + 5.6, -0.4 - 4.2), and -(0.5) e abs(W')... along e_ij alone.
    const double scale = -slope / 0.1 * 0.02;
    checkViscosity<ViscousForm::laplacian, Dim, Number>({scale * 5.3, scale * -4.6});
    checkViscosity<ViscousForm::central, Dim, Number>({scale * -0.5 * 0.6, scale * -0.5 * 0.8});
    checkContinuation<Dim, Number>();
}

}  // namespace

TEMPLATE_TEST_CASE("pair terms of fluids on two particles", "", double, Lanes, FloatTile,
                   DoubleTile) {
    checkAll<2, TestType>();
    checkAll<3, TestType>();
}

TEST_CASE("eight pairs give what each gives alone") {
    Lanes v_ij[2];
    double v_one[2];
    Pair<2, Lanes> pair;
    Pair<2, double> one;
    for (int k = 0; k < lane_count; ++k) {
        for (int c = 0; c < 2; ++c) {
            v_ij[c][k] = std::sin(3.0 * k + c);
            pair.gradient[c][k] = std::cos(2.0 * k - c);
        }
        pair.dW[k] = std::hypot(pair.gradient[0][k], pair.gradient[1][k]);
        pair.inverse_dW[k] = 1 / pair.dW[k];
    }
    const Lanes p_i = lanes(3), p_j = v_ij[0] * 5.0;
    const Lanes eight =
        twicePressure<Riemann::low_dissipation, 2, Lanes>(water, pair, v_ij, p_i, p_j);
    for (int k = 0; k < lane_count; ++k) {
        for (int c = 0; c < 2; ++c) {
            v_one[c] = v_ij[c][k];
            one.gradient[c] = pair.gradient[c][k];
        }
        one.dW = pair.dW[k];
        one.inverse_dW = pair.inverse_dW[k];
        const double single =
            twicePressure<Riemann::low_dissipation, 2, double>(water, one, v_one, p_i[k], p_j[k]);
        CHECK(single == Approx(eight[k]).epsilon(4e-16));
    }
}
