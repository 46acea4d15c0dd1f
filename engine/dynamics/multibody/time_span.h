// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

// mechanism.cpp and its like are C++17: this header has nothing newer.

#include "dynamics/multibody/mechanism.h"

#include <algorithm>
#include <cmath>

namespace sphinx::dynamics::multibody {

/// A step of the integrator, by which given motions are differentiated: by the polynomial of
/// fourth degree through five places of it. So a motion is as smooth as the steps see it, and
/// nothing is asked of it beyond them.
struct TimeSpan {
    double start = 0, length = 1;

    struct Derivatives {
        double first, second;
    };
    Derivatives derivatives(const FunctionOfTime& f, double t) const {
        const double d = length / 4;
        double v[5];
        for (int k = 0; k < 5; ++k) v[k] = f(start + k * d);
        // About the middle, in units of d.
        const double s = (t - start) / d - 2;
        const double c1 = (v[0] - 8 * v[1] + 8 * v[3] - v[4]) / 12;
        const double c2 = (-v[0] + 16 * v[1] - 30 * v[2] + 16 * v[3] - v[4]) / 24;
        const double c3 = (-v[0] + 2 * v[1] - 2 * v[3] + v[4]) / 12;
        const double c4 = (v[0] - 4 * v[1] + 6 * v[2] - 4 * v[3] + v[4]) / 24;
        return {(c1 + s * (2 * c2 + s * (3 * c3 + s * 4 * c4))) / d,
                (2 * c2 + s * (6 * c3 + s * 12 * c4)) / (d * d)};
    }
    /// Whether a part of it gives the same rate at its start.
    bool resolves(const FunctionOfTime& f) const {
        const TimeSpan part{start, length / 4};
        double lowest = f(start), highest = lowest;
        for (int k = 1; k < 5; ++k) {
            lowest = std::min(lowest, f(start + k * length / 4));
            highest = std::max(highest, f(start + k * length / 4));
        }
        const double wrong = derivatives(f, start).first - part.derivatives(f, start).first;
        return std::abs(wrong) * length <=
               1e-9 * (highest - lowest) + 1e-14 * std::max(std::abs(lowest), std::abs(highest));
    }
};

}  // namespace sphinx::dynamics::multibody
