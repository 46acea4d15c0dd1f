// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/body.h"
#include "core/place_text.h"
#include "input/expressions/units.h"

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
    input::UnitSystem units;  ///< of messages
    Domain<Dim> domain;
    std::vector<std::unique_ptr<Body<Dim>>> bodies;

    /// "0.1 m", "(1, 2) m", for messages.
    std::string quantityText(double value, Dimension dimension) const {
        return fmt::format("{:g}{}", value, units.suffix(dimension));
    }
    std::string placeText(const Vec<Dim>& p) const {
        return sphinx::placeText<Dim>(p) + units.suffix(unit::length);
    }

    Body<Dim>* find(std::string_view name) const {
        for (const auto& body : bodies)
            if (body->name == name) return body.get();
        return nullptr;
    }
};

}  // namespace sphinx
