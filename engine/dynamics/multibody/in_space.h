// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/types.h"
#include "dynamics/multibody/mechanism.h"

namespace sphinx::dynamics::multibody {

/// A vector of a case of Dim dimensions in those of the mechanism.
template <int Dim>
Vector inSpace(const Vec<Dim>& a) {
    Vector v = Vector::Zero();
    v.head<Dim>() = a;
    return v;
}

}  // namespace sphinx::dynamics::multibody
