// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/lanes.h"

#include <algorithm>
#include <cmath>

namespace sphinx {

/// A number of each of eight particles that counts as one number, also in Eigen's matrices: what is
/// written for any type of number, as the laws of materials, works for eight particles at a time.
struct Wide {
    Lanes at;

    Wide() = default;
    Wide(Lanes lanes) : at(lanes) {}
    Wide(double a) : at(lanes(a)) {}

    /// Of particle k.
    double operator[](std::size_t k) const { return at[k]; }
    Wide& operator+=(Wide b) { return at += b.at, *this; }
    Wide& operator-=(Wide b) { return at -= b.at, *this; }
    Wide& operator*=(Wide b) { return at *= b.at, *this; }
    Wide& operator/=(Wide b) { return at /= b.at, *this; }
    friend Wide operator+(Wide a, Wide b) { return a.at + b.at; }
    friend Wide operator-(Wide a) { return -a.at; }
    friend Wide operator-(Wide a, Wide b) { return a.at - b.at; }
    friend Wide operator*(Wide a, Wide b) { return a.at * b.at; }
    friend Wide operator/(Wide a, Wide b) { return a.at / b.at; }
    friend LaneMask operator!=(Wide a, Wide b) { return a.at != b.at; }
    friend LaneMask operator<(Wide a, Wide b) { return a.at < b.at; }
    friend LaneMask operator>(Wide a, Wide b) { return a.at > b.at; }

    /// a where b is not a number, as std::max.
    friend Wide max(Wide a, Wide b) { return maxLanes(b.at, a.at); }
    /// The largest of the eight.
    friend double maxOf(Wide a) {
        double values[lane_count];
        storeLanes(a.at, values);
        return *std::max_element(values, values + lane_count);
    }
    friend Wide abs(Wide a) { return maxLanes(-a.at, a.at); }
    /// a where the mask is true, else b.
    friend Wide select(LaneMask mask, Wide a, Wide b) { return mask ? a.at : b.at; }
    friend Wide sqrt(Wide a) { return sqrtLanes(a.at); }
    friend Wide exp(Wide a) {
        return a.each([](double x) { return std::exp(x); });
    }
    friend Wide pow(Wide a, double exponent) {
        return a.each([=](double x) { return std::pow(x, exponent); });
    }
    friend Wide log1p(Wide a) {
        return a.each([](double x) { return std::log1p(x); });
    }

 private:
    /// Functions of libm take several times as long while the upper halves of vector registers are
    /// in use. Where this is inlined GCC 12 does not clear them.
    template <class Function>
    [[gnu::noinline]] Wide each(Function&& f) const {
        double values[lane_count];
        storeLanes(at, values);
#if defined(__AVX__)
        __builtin_ia32_vzeroupper();
#endif
        for (double& value : values) value = f(value);
        return loadLanes(values);
    }
};

// Number is double or Wide.

/// What a comparison gives: a bool, or a LaneMask.
template <class Number>
using Truth = decltype(Number() < Number());
template <class Number>
inline Truth<Number> always() {
    return Truth<Number>{} == Truth<Number>{};
}
template <int Dim, class Number>
using VecOf = Eigen::Matrix<Number, Dim, 1>;
template <int Dim, class Number>
using MatOf = Eigen::Matrix<Number, Dim, Dim>;

}  // namespace sphinx

template <>
struct Eigen::NumTraits<sphinx::Wide> : Eigen::GenericNumTraits<sphinx::Wide> {
    using Literal = double;
    static constexpr int IsSigned = 1;
    static constexpr int RequireInitialization = 0;
};
/// Products and the like of numbers that all particles share with their own.
template <class Operation>
struct Eigen::ScalarBinaryOpTraits<double, sphinx::Wide, Operation> {
    using ReturnType = sphinx::Wide;
};
template <class Operation>
struct Eigen::ScalarBinaryOpTraits<sphinx::Wide, double, Operation> {
    using ReturnType = sphinx::Wide;
};
