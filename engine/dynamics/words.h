// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/world.h"
#include "neighbors/relations.h"

// The everyday words of methods, which would otherwise carry their folder on every line. All others
// do carry it; `sphinx::` before those of which there is an area of dynamics.
namespace sphinx::dynamics {

using bodies::Body;
using bodies::Domain;
using bodies::World;
using kernels::Kernel;
using sphinx::neighbors::NeighborList;
using sphinx::neighbors::PairTiles;
using sphinx::neighbors::ReferenceList;
using sphinx::neighbors::ReferenceRelation;
using sphinx::neighbors::Relation;
using sphinx::neighbors::Relations;
using sphinx::particles::Field;
using sphinx::particles::ParticleSet;

}  // namespace sphinx::dynamics
