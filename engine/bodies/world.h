// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/body.h"

#include <array>
#include <memory>
#include <string_view>
#include <vector>

namespace sphinx {

enum class LostParticles { stop, remove };

/// Space of the simulation. Along a periodic axis the bounds are one period; along others they
/// only tell when a particle counts as lost.
template <int Dim>
struct Domain {
    Box<Dim> bounds;
    std::array<bool, Dim> periodic{};
    LostParticles lost = LostParticles::stop;

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

/// All bodies of a case and the space they live in.
template <int Dim>
struct World {
    Domain<Dim> domain;
    std::vector<std::unique_ptr<Body<Dim>>> bodies;

    Body<Dim>* find(std::string_view name) const {
        for (const auto& body : bodies)
            if (body->name == name) return body.get();
        return nullptr;
    }
};

}  // namespace sphinx
