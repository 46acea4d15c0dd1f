// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/world.h"
#include "case/model/model.h"
#include "input/tree/diagnostics.h"

/// What is asked of the bodies of a case once their particles are made, and before anything runs.
namespace sphinx::check {

/// Reports lattices too large to be made.
template <int Dim>
void checkLattices(const model::Case& model, input::Diagnostics& diagnostics);

/// Reports bodies without particles, bodies that overlap, fluid outside of the domain and initial
/// values that are no numbers.
template <int Dim>
void checkParticles(const model::Case& model, const bodies::World<Dim>& world,
                    input::Diagnostics& diagnostics);

/// Reports bodies of which particles lie nearer than half a spacing to each other, and whether that
/// is because their shapes overlap or because a lattice does not end at the surface of its shape.
template <int Dim>
void checkOverlap(const model::Case& model, const bodies::World<Dim>& world,
                  input::Diagnostics& diagnostics);

/// Elastic bodies have two rows of particles at least, and rows enough to bend as they would. With
/// those bonded to them, they do not reach across a periodic side of the domain: their particles
/// would be neighbors of those at the other end, a whole domain away.
template <int Dim>
void checkElastic(const model::Case& model, const bodies::World<Dim>& world,
                  input::Diagnostics& diagnostics);

/// Warns of solids through which a fluid that sees them may leak: rigid ones of fewer than three
/// layers of particles, and any with a coarser spacing than the fluid; and of rigid bodies that
/// nothing sees.
template <int Dim>
void checkWalls(const model::Case& model, const bodies::World<Dim>& world,
                input::Diagnostics& diagnostics);

/// Reports rigid bodies with an initial velocity that nothing moves: it may be that of a surface
/// that slides along itself, and else pushes fluids while the body stands still.
template <int Dim>
void checkStandingWalls(const model::Case& model, const bodies::World<Dim>& world,
                        input::Diagnostics& diagnostics);

/// Asks the rules that want the particles at the start (DeclaredMethod::worldRule, caseRule).
template <int Dim>
void checkWorldRules(const model::Case& model, const bodies::World<Dim>& world,
                     input::Diagnostics& diagnostics);

}  // namespace sphinx::check
