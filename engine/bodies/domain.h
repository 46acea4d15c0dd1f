// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/types.h"

#include <array>
#include <cmath>

namespace sphinx::bodies {

enum class LostParticles { stop, remove };

/// Space of the simulation. Along a periodic axis the bounds are one period; along others they
/// only tell when a particle counts as lost.
template <int Dim>
struct Domain {
    Box<Dim> bounds;
    std::array<bool, Dim> periodic{};
    LostParticles lost = LostParticles::stop;

    /// The coordinate along that axis, within the period.
    double wrapped(double x, int axis) const {
        if (!periodic[static_cast<std::size_t>(axis)]) return x;
        const double period = bounds.upper[axis] - bounds.lower[axis];
        return x - period * std::floor((x - bounds.lower[axis]) / period);
    }
    Vec<Dim> wrapped(Vec<Dim> x) const {
        for (int k = 0; k < Dim; ++k) x[k] = wrapped(x[k], k);
        return x;
    }
    /// Shortest vector from b to a, over the periodic images.
    Vec<Dim> difference(const Vec<Dim>& a, const Vec<Dim>& b) const {
        Vec<Dim> d = a - b;
        for (int k = 0; k < Dim; ++k) {
            if (!periodic[k]) continue;
            const double period = bounds.upper[k] - bounds.lower[k];
            if (d[k] > 0.5 * period) d[k] -= period;
            if (d[k] < -0.5 * period) d[k] += period;
        }
        return d;
    }
};

}  // namespace sphinx::bodies
