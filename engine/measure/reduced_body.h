// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/body.h"
#include "input/expressions/units.h"
#include "input/tree/place.h"
#include "neighbors/relations.h"

#include <string>

namespace sphinx::measure {

/// Particles that are summed over.
template <int Dim>
struct ReducedParticles {
    bodies::Body<Dim>* body;
    const bodies::BodyPart<Dim>* part = nullptr;  ///< of the body; null: all of it

    std::size_t size() const { return part ? part->particles.size() : body->size(); }
    /// Index in the body of the n-th of them.
    std::size_t operator[](std::size_t n) const { return part ? part->particles[n] : n; }
    /// In texts.
    std::string what() const { return part ? "part" : "body"; }
};

/// What sums and extremes need of it. All of them have the same bits for any number of threads;
/// they throw CaseError at the place when the body lacks a field that they need.
template <int Dim>
struct ReducedBody : ReducedParticles<Dim> {
    input::Place place = {};  ///< where the case names it
    input::UnitSystem units = {};
    neighbors::Relations<Dim>* relations = nullptr;  ///< needed for forces and elastic energies
};

}  // namespace sphinx::measure
