// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/multibody/mechanism.h"
#include "dynamics/multibody/parameters.h"
#include "input/declaration/registry.h"

#include <string_view>

namespace sphinx::dynamics::multibody {

/// What entries of `forces` and `constraints` are added to: they name bodies and joints.
class Assembly {
 public:
    explicit Assembly(const MultibodyParameters& parameters) : parameters_(&parameters) {}

    /// Number of a body in the mechanism; `ground` is none of them.
    int body(const input::Name& name) const;
    int joint(const input::Name& name) const;
    BodyPoint point(const PointParameters& p) const;

    MechanismDescription mechanism;

 private:
    const MultibodyParameters* parameters_;
};

/// A point or vector of a case: in 2D at z = 0.
Vector vectorOf(const input::Coordinates& a);
/// Of t alone. It throws MechanismError, with what it is of, where its value is no number.
FunctionOfTime functionOfTime(const input::FieldExpression& expression, std::string what);

/// Adds a force or constraint to the mechanism: what Declaration::builder of a constraint holds.
using AddComponent = void (*)(const input::Component& component, Assembly& assembly);
/// The same of a force.
struct ForceBuilder {
    ForceKind kind;
    AddComponent add;
};

void declareJoints(input::Registry& registry);
void declareForces(input::Registry& registry);
void declareConstraints(input::Registry& registry);

}  // namespace sphinx::dynamics::multibody
