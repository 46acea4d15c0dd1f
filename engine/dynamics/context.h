// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/contact_stress.h"

#include <memory>

namespace sphinx::dynamics {

namespace multibody {
struct MultibodyParameters;
}  // namespace multibody

namespace fluid {
template <int Dim>
class SolidLoad;
}

namespace contact {
template <int Dim>
class Loads;
template <int Dim>
class PairOwner;
}  // namespace contact

/// What methods are built from. It lives as long as they do.
template <int Dim>
struct Context {
    World<Dim>& world;
    Relations<Dim>& relations;
    /// Methods by which a fluid pushes solids; each adds itself when it is built.
    std::vector<const fluid::SolidLoad<Dim>*> loads = {};
    /// Methods that have pairs of surfaces in contact; likewise.
    std::vector<contact::PairOwner<Dim>*> contacts = {};
    std::vector<std::shared_ptr<contact::Loads<Dim>>> contact_loads = {};  ///< one for each body
    std::vector<const ContactStress<Dim>*> contact_stresses = {};          ///< of theirs
    /// The block `multibody` of the case, or null.
    const multibody::MultibodyParameters* multibody = nullptr;
    double start_time = 0;
};

}  // namespace sphinx::dynamics
