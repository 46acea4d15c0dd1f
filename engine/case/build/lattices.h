// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/domain.h"
#include "case/model/model.h"
#include "fitting/relax.h"
#include "particles/lattice.h"

#include <map>
#include <optional>
#include <string>

namespace sphinx::build {

/// Where the lattice of a body lies.
template <int Dim>
struct PlacedLattice {
    particles::Lattice<Dim> lattice;
    std::vector<Vec<Dim>> points;  ///< inside of the shape
    /// By half a spacing along each axis, from where its points would fall on opposite faces.
    std::array<bool, Dim> moved{};
    /// Points that lie on the surface all the same: those at which the body goes on towards larger
    /// coordinates are its particles, the others are not, and a mirrored body has others.
    std::size_t on_surface = 0;
    /// How the points became those of a relaxed arrangement; itself without points.
    std::optional<fitting::Relaxed<Dim>> relaxed;
};

/// The lattices of all bodies that have a shape and no particles of their own, by name.
///
/// Lattice lines start at the origin that the body names, else at that of the coordinates; along a
/// periodic axis at the lower bound, so that the lattice goes on across it. Where the body names
/// none and points of its lattice fall on two opposite faces, the lattice moves by half a spacing
/// along that axis, and so do those of bodies of the same spacing that share such a face: a beam of
/// five spacings about its axis has five rows, and not six or four.
template <int Dim>
std::map<std::string, PlacedLattice<Dim>> placeLattices(const model::Case& model,
                                                        const bodies::Domain<Dim>& domain);

}  // namespace sphinx::build
