// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/words.h"

namespace sphinx::dynamics {

namespace multibody {
struct MultibodyParameters;
}  // namespace multibody

namespace fluid {
template <int Dim>
class SolidLoad;
}

/// What methods are built from. It lives as long as they do.
template <int Dim>
struct Context {
    World<Dim>& world;
    Relations<Dim>& relations;
    /// Methods by which a fluid pushes solids; each adds itself when it is built.
    std::vector<const fluid::SolidLoad<Dim>*> loads = {};
    /// The block `multibody` of the case, or null.
    const multibody::MultibodyParameters* multibody = nullptr;
    double start_time = 0;
};

}  // namespace sphinx::dynamics
