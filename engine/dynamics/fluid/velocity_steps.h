// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tile.h"
#include "dynamics/fluid/largest.h"
#include "materials/fluid.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace sphinx::dynamics::fluid {

/// Velocities in records of floats are whole numbers of a step: so their differences, of which
/// viscosity lives, are exact. Doubles need no rounding.
class VelocitySteps {
 public:
    template <int Dim>
    explicit VelocitySteps(Body<Dim>& body) {
        const double fastest = std::sqrt(largestSquaredSpeed<Dim>(body));
        speed_ = fastest > 0 ? fastest : body.fluid().material->soundSpeed();
    }
    /// For numbers up to `largest`, which is positive.
    explicit VelocitySteps(double largest) : speed_(largest) {}
    static constexpr double steps = 0x1p29;  ///< of the largest speed: differences are below 2^31
    double speed() const { return speed_; }

    template <class Real>
    Real of(double v) const {
        const double exact = v * (steps / speed_);
        if constexpr (std::is_same_v<Real, double>)
            return exact;
        else
            return std::bit_cast<float>(static_cast<std::int32_t>(std::nearbyint(exact)));
    }

 private:
    double speed_;
};

/// i - j.
[[gnu::always_inline]] inline FloatTile stepsBetween(FloatTile i, FloatTile j) {
    return toFloat(reinterpret_cast<WholeTile>(i) - reinterpret_cast<WholeTile>(j));
}
[[gnu::always_inline]] inline DoubleTile stepsBetween(const DoubleTile& i, const DoubleTile& j) {
    return i - j;
}

}  // namespace sphinx::dynamics::fluid
