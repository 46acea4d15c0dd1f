// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace sphinx {

template <int Dim>
using Vec = Eigen::Matrix<double, Dim, 1>;
template <int Dim>
using Mat = Eigen::Matrix<double, Dim, Dim>;

/// Index of a particle in its body; lists store it in 32 bits.
using Index = std::uint32_t;

/// The unit in which neighbor lists are stored and summed (core/lanes.h).
inline constexpr int lane_count = 8;

/// Stands for "no value": a gauge without water, an observer without neighbors.
inline constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

/// Axis-aligned box, closed.
template <int Dim>
struct Box {
    Vec<Dim> lower = Vec<Dim>::Constant(std::numeric_limits<double>::infinity());
    Vec<Dim> upper = Vec<Dim>::Constant(-std::numeric_limits<double>::infinity());

    bool empty() const { return (lower.array() > upper.array()).any(); }
    bool contains(const Vec<Dim>& p) const {
        return (p.array() >= lower.array()).all() && (p.array() <= upper.array()).all();
    }
    void include(const Vec<Dim>& p) {
        lower = lower.cwiseMin(p);
        upper = upper.cwiseMax(p);
    }
    void include(const Box& b) {
        lower = lower.cwiseMin(b.lower);
        upper = upper.cwiseMax(b.upper);
    }
    Vec<Dim> size() const { return upper - lower; }
};

}  // namespace sphinx
