// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/contact/pair.h"
#include "input/types/values.h"

#include <memory>
#include <optional>
#include <vector>

namespace sphinx::dynamics::contact {

struct FrictionParameters {
    std::optional<double> coulomb;
    std::optional<double> viscous;
};

enum class Form { surfaces, density };

struct ForceParameters {
    input::Name body;
    Form form = Form::surfaces;
    /// Filled in when the case is read: all that are in contact with the body in topology.
    std::vector<input::Name> with;
    std::optional<double> modulus;
    FrictionParameters friction;
    double restitution = 1;
};

/// A method that has pairs of surfaces: the time step finds them through the context.
template <int Dim>
class PairOwner {
 public:
    virtual ~PairOwner() = default;
    virtual const std::vector<std::unique_ptr<Pair<Dim>>>& pairs() const = 0;
    /// Of the surfaces, at the middle of a step by dt.
    virtual void takePlaces(double dt) = 0;
};

}  // namespace sphinx::dynamics::contact
