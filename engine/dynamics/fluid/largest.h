// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/group.h"

namespace sphinx::dynamics::fluid {

/// Largest abs(v)^2 of a body's particles in the run; 0 where there are none. Eight at a time: a
/// single running maximum waits for itself.
template <int Dim>
double largestSquaredSpeed(Body<Dim>& body) {
    const Field<Vec<Dim>>& velocity = body.particles.vector(fields::velocity);
    const std::size_t n = velocity.size();
    return reduceAll(
        groupCount(n), 0.0,
        [&](std::size_t begin, std::size_t end) {
            Wide largest = 0;
            for (std::size_t number = begin; number < end; ++number)
                largest = max(largest, load(velocity, groupOf(number, n)).squaredNorm());
            return maxOf(largest);
        },
        [](double a, double b) { return b > a ? b : a; }, group_block);
}

/// Largest abs(p) in the same way.
template <int Dim>
double largestPressure(Body<Dim>& body) {
    const Field<double>& pressure = body.particles.scalar(fields::pressure);
    const std::size_t n = pressure.size();
    return reduceAll(
        groupCount(n), 0.0,
        [&](std::size_t begin, std::size_t end) {
            Wide largest = 0;
            for (std::size_t number = begin; number < end; ++number)
                largest = max(largest, abs(load(pressure, groupOf(number, n))));
            return maxOf(largest);
        },
        [](double a, double b) { return b > a ? b : a; }, group_block);
}

}  // namespace sphinx::dynamics::fluid
