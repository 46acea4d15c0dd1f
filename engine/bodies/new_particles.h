// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/body.h"

#include <vector>

namespace sphinx::bodies {

/// What has to be said of a particle to make it.
template <int Dim>
struct NewParticle {
    Vec<Dim> position = Vec<Dim>::Zero();  ///< length
    double volume = 0;                     ///< length^Dim, above 0; observers have none
    Vec<Dim> velocity = Vec<Dim>::Zero();  ///< length/time
    double pressure = 0;                   ///< of a fluid
};

/// Fields that the particles of a body of that role have by themselves. Others come with the
/// methods that ask for them.
std::vector<const particles::FieldInfo*> ownFields(Role role, bool fibres);

/// Makes particles, at the start or in the midst of a run. All their fields have the right values,
/// those that methods have asked for included: the density is that at the pressure, the mass
/// density times volume, the directions of fibres those of the material at the place, which is
/// their place in the reference configuration; the others follow from FieldInfo::initial. Parts in
/// whose shapes they lie have them, too. Lists of neighbors are stale afterwards (Body::version).
/// Without particles the body has its fields alone.
template <int Dim>
void addParticles(Body<Dim>& body, const std::vector<NewParticle<Dim>>& made);

}  // namespace sphinx::bodies
