// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/types.h"

#include <cmath>
#include <random>

namespace sphinx::test {

/// Numbers that are the same on every machine.
class Random {
 public:
    double operator()(double low, double high) {
        return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
    }
    template <int Dim>
    Vec<Dim> vector(double size) {
        Vec<Dim> v;
        for (int c = 0; c < Dim; ++c) v[c] = (*this)(-size, size);
        return v;
    }
    template <int Dim>
    Mat<Dim> matrix(double size) {
        Mat<Dim> m;
        for (int c = 0; c < Dim; ++c) m.col(c) = vector<Dim>(size);
        return m;
    }

 private:
    std::mt19937_64 engine_{7};
};

/// By a random axis in 3D.
template <int Dim>
Mat<Dim> rotation(double angle, Random& random) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    Mat<Dim> Q;
    if constexpr (Dim == 2) {
        Q << c, -s, s, c;
    } else {
        const Vec<3> n = random.vector<3>(1).normalized();
        Mat<3> N;
        N << 0, -n[2], n[1], n[2], 0, -n[0], -n[1], n[0], 0;
        Q = Mat<3>::Identity() + s * N + (1 - c) * N * N;
    }
    return Q;
}

}  // namespace sphinx::test
