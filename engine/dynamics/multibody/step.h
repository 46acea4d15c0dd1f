// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/multibody/mechanism.h"
#include "dynamics/multibody/parameters.h"

#include <vector>

namespace sphinx::dynamics::multibody {

/// A method that has a mechanism: outputs find it among the methods of the loop.
class MechanismOwner {
 public:
    virtual ~MechanismOwner() = default;
    virtual const MultibodyParameters& parameters() const = 0;
    /// Null until the method is prepared.
    virtual const Mechanism* mechanism() const = 0;
};

struct StepParameters {
    /// Those of all bodies of `multibody`: filled in when the case is read.
    std::vector<input::Name> parts;
};

}  // namespace sphinx::dynamics::multibody
