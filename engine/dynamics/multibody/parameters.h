// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/multibody/mechanism.h"
#include "input/declaration/component.h"
#include "input/expressions/expression.h"
#include "input/types/values.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

// The block `multibody` of a case as it is written.
namespace sphinx::dynamics::multibody {

/// An entry of `bodies`: mass, centre and inertia are those of the particles where not given.
struct BodyParameters {
    std::vector<input::Name> particles;  ///< bodies and parts of bodies that it moves
    std::optional<double> mass;
    std::optional<input::Coordinates> center;
    std::vector<double> inertia;  ///< 2D: one; 3D: xx, yy, zz, or these and xy, xz, yz
};

/// Of a coordinate of a joint: an angle in radian, or a length.
struct SpringParameters {
    double stiffness = 0;
    double rest = 0;
};
struct LimitsParameters {
    double lower = 0, upper = 0;
    double stiffness = 0;
    double dissipation = 0;
};

/// What acts on a coordinate of a joint that has several.
struct CoordinateParameters {
    std::optional<SpringParameters> spring;
    double damping = 0;
    std::optional<LimitsParameters> limits;
    std::optional<input::FieldExpression> motor, motion;
};
/// The same of an angle or shift of a joint that has no coordinates.
struct BushingParameters {
    double stiffness = 0;
    double damping = 0;
};

/// An entry of `joints`. Each type has some of these.
struct JointParameters {
    input::Name parent, child;
    std::optional<input::Coordinates> at, child_at;
    std::optional<input::Coordinates> axis, second_axis;
    double lead = 0;
    double angle = 0, rate = 0;
    double displacement = 0, speed = 0;
    std::vector<double> angles, rates;
    std::optional<input::Coordinates> shift, velocity;
    std::vector<double> turn, angular_velocity;
    std::optional<SpringParameters> spring;
    double damping = 0;
    std::optional<LimitsParameters> limits;
    std::optional<input::FieldExpression> motor, motion;
    std::vector<CoordinateParameters> turning, sliding;
    std::vector<BushingParameters> turning_bushings, sliding_bushings;
};

/// A point of a body: the body, and where it is in the drawing.
struct PointParameters {
    input::Name body;
    input::Coordinates at;
};

struct MultibodyParameters {
    std::optional<input::Coordinates> gravity;
    std::vector<std::pair<input::Name, BodyParameters>> bodies;
    std::vector<input::Component> joints, forces, constraints;
    Integrator integrator = Integrator::runge_kutta_4;
    std::optional<double> step;      ///< largest step of the integrator, time
    std::optional<double> accuracy;  ///< of constraints, length or radian

    /// Whether there are constraints: those of the block, and motions of some coordinates of
    /// joints.
    bool constrains() const {
        const auto isDriven = [](const CoordinateParameters& c) { return c.motion.has_value(); };
        return !constraints.empty() ||
               std::ranges::any_of(joints, [&](const input::Component& joint) {
                   const auto& p = joint.as<JointParameters>();
                   return std::ranges::any_of(p.turning, isDriven) ||
                          std::ranges::any_of(p.sliding, isDriven);
               });
    }
    /// Whether one of its bodies has particles of that body of the case.
    bool carries(std::string_view body) const {
        const auto isOf = [&](const input::Name& name) {
            return std::string_view(name.text).substr(0, name.text.find('.')) == body;
        };
        return std::ranges::any_of(bodies, [&](const auto& entry) {
            return std::ranges::any_of(entry.second.particles, isOf);
        });
    }
};

}  // namespace sphinx::dynamics::multibody
