// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/body.h"

namespace sphinx::constraint {

/// A constraint that knows the force it exerts.
template <int Dim>
class Support {
 public:
    virtual ~Support() = default;
    virtual const Body<Dim>& supported() const = 0;
    /// Sum of the forces on the held particles in the last step, force.
    virtual Vec<Dim> reaction() const = 0;
};

}  // namespace sphinx::constraint
