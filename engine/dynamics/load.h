// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sum_all.h"
#include "core/types.h"

namespace sphinx::dynamics {

/// A moment: in 2D its component out of the plane.
template <int Dim>
using Moment = Eigen::Matrix<double, Dim == 2 ? 1 : 3, 1>;

/// r x f: the moment of a force at a place r.
template <int Dim, class Number = double>
inline Eigen::Matrix<Number, Dim == 2 ? 1 : 3, 1> momentOf(const Eigen::Matrix<Number, Dim, 1>& r,
                                                           const Eigen::Matrix<Number, Dim, 1>& f) {
    Eigen::Matrix<Number, Dim == 2 ? 1 : 3, 1> m;
    if constexpr (Dim == 2)
        m[0] = r[0] * f[1] - r[1] * f[0];
    else
        for (int c = 0; c < 3; ++c)
            m[c] = r[(c + 1) % 3] * f[(c + 2) % 3] - r[(c + 2) % 3] * f[(c + 1) % 3];
    return m;
}

/// What a body gets from others: a force, and its moment about a point that goes with it.
template <int Dim>
struct Load {
    Vec<Dim> force = Vec<Dim>::Zero();
    Moment<Dim> moment = Moment<Dim>::Zero();

    /// Adds a force at a place r from the point.
    void add(const Vec<Dim>& r, const Vec<Dim>& f) {
        force += f;
        moment += momentOf<Dim>(r, f);
    }
    Load& operator+=(const Load& other) {
        force += other.force;
        moment += other.moment;
        return *this;
    }
};

}  // namespace sphinx::dynamics

namespace sphinx::detail {
/// For sumAll(): the components of the force, then those of the moment.
template <int Dim>
struct Summand<dynamics::Load<Dim>> {
    static constexpr int size = Dim + static_cast<int>(dynamics::Moment<Dim>::SizeAtCompileTime);
    static double of(const dynamics::Load<Dim>& load, int k) {
        return k < Dim ? load.force[k] : load.moment[k - Dim];
    }
    static void set(dynamics::Load<Dim>& load, int k, double value) {
        (k < Dim ? load.force[k] : load.moment[k - Dim]) = value;
    }
};
}  // namespace sphinx::detail
