// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/lanes.h"
#include "core/parallel.h"
#include "particles/field.h"

namespace sphinx::fluid {

/// Largest abs(v)^2 of a body's particles; 0 where there are none. Eight at a time: a single
/// running maximum waits for itself.
template <int Dim>
double largestSquaredSpeed(const Field<Vec<Dim>>& velocity) {
    const auto larger = [](double a, double b) { return b > a ? b : a; };
    return parallelReduce(
        velocity.size(), 0.0,
        [&](std::size_t begin, std::size_t end) {
            Lanes most = {};
            std::size_t i = begin;
            for (; i + lane_count <= end; i += lane_count) {
                double speed2[lane_count];
                for (std::size_t k = 0; k < lane_count; ++k)
                    speed2[k] = velocity[i + k].squaredNorm();
                most = maxLanes(loadLanes(speed2), most);
            }
            double largest = 0;
            for (int k = 0; k < lane_count; ++k) largest = larger(largest, most[k]);
            for (; i < end; ++i) largest = larger(largest, velocity[i].squaredNorm());
            return largest;
        },
        larger);
}

}  // namespace sphinx::fluid
