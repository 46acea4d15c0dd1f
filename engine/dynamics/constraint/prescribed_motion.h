// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/constraint/motion.h"
#include "dynamics/declare.h"

#include <optional>
#include <string>

namespace sphinx::dynamics::constraint {

/// Motion r = R + u(R, t) of particles with the initial position R, in all or some directions, by
/// the displacements at the times of a step alone: it holds no state of its own.
struct PrescribedMotionParameters {
    input::Name part;
    std::vector<input::FieldExpression> displacement;  ///< empty: rotation or translation
    std::optional<RotationParameters> rotation;
    std::vector<input::FieldExpression> translation;
    std::vector<int> directions;

    /// What is wrong with them together, or empty.
    std::string violation() const;
    template <int Dim>
    Motion<Dim> motion() const {
        if (!displacement.empty()) return Motion<Dim>(displacement);
        return Motion<Dim>(rotation, translation);
    }
};

}  // namespace sphinx::dynamics::constraint
