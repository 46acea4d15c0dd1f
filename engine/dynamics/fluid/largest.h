// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/group.h"

namespace sphinx::dynamics::fluid {

/// Largest value(group) of n particles, no less than 0. Eight at a time: a single running maximum
/// waits for itself.
template <class Value>
double largestOf(std::size_t n, Value&& value) {
    return reduceAll(
        groupCount(n), 0.0,
        [&](std::size_t begin, std::size_t end) __attribute__((flatten)) {
            Wide largest = 0;
            for (std::size_t number = begin; number < end; ++number)
                largest = max(largest, value(groupOf(number, n)));
            return maxOf(largest);
        },
        [](double a, double b) { return b > a ? b : a; }, group_block);
}

/// Largest abs(v)^2 of a body's particles in the run; 0 where there are none.
template <int Dim>
double largestSquaredSpeed(Body<Dim>& body) {
    const Field<Vec<Dim>>& velocity = body.particles.vector(fields::velocity);
    return largestOf(velocity.size(), [&](const Group& group) -> Wide {
        return load(velocity, group).squaredNorm();
    });
}

/// Largest abs(p) in the same way.
template <int Dim>
double largestPressure(Body<Dim>& body) {
    const Field<double>& pressure = body.particles.scalar(fields::pressure);
    return largestOf(pressure.size(),
                     [&](const Group& group) -> Wide { return abs(load(pressure, group)); });
}

}  // namespace sphinx::dynamics::fluid
