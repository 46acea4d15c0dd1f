// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/types.h"
#include "materials/elastic_solid.h"
#include "materials/fluid.h"
#include "materials/material.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace sphinx::bodies {

template <int Dim>
struct BodyPart;

// What a body is to methods and outputs. Its role is found once, when the world is built; whoever
// works on a body asks it for the role that it needs (Body::fluid() and others) and gets the
// material and what only bodies of that role know.

/// What the viscous forces on a fluid do at most, as they have announced, at the viscosity that the
/// material has at rest.
struct ViscousRates {
    double whole = 0;  ///< dynamic viscosity by area: its largest eigenvalue times mu
    double walls = 0;  ///< what solids have in it
    /// Least density of the elastic bodies that they push.
    double lightest_solid = std::numeric_limits<double>::infinity();
    /// Whether a method solves for them: then they limit no step of the fluid (unless another one
    /// that does not has announced some in `whole`), but what elastic bodies get they get
    /// explicitly.
    bool implicit = false;
    double implicit_walls = 0;  ///< as `walls`

    bool limitSteps() const { return whole > 0 || !implicit; }
    /// Of change of the velocity of solids that a solved force pushes, 1/time.
    double implicitRate() const { return implicit_walls / lightest_solid; }
    /// Of change of a velocity, 1/time, in a fluid of that density. Light solids change faster.
    double rate(double density) const {
        return whole / density + walls * std::max(0.0, 1 / lightest_solid - 1 / density);
    }
};

/// Moves by its pressure.
template <int Dim>
struct FluidRole {
    std::shared_ptr<const materials::Fluid> material;
    Vec<Dim> gravity = Vec<Dim>::Zero();  ///< sum of its uniform gravities, acceleration
    ViscousRates viscous = {};
    /// Counts what changes velocities between the halves of an acoustic step.
    std::uint64_t kicks = 0;
};

/// Does not deform: stands still, moves as prescribed, or as a mechanism moves it (multibody).
struct WallRole {
    std::shared_ptr<const materials::Material> material;
    bool in_mechanism = false;
    /// Of the body of the mechanism that carries it, once that is there.
    double carried_mass = std::numeric_limits<double>::infinity();
};

/// Moves by its stress.
template <int Dim>
struct ElasticRole {
    std::shared_ptr<const materials::ElasticSolid> material;
    Vec<Dim> gravity = Vec<Dim>::Zero();  ///< sum of its uniform gravities, acceleration
    /// Stiffness of its hourglass control, pressure; see solid/deformation.h.
    double hourglass_modulus = 0;
    /// Parts along whose surface the body is clamped (constraint.clamp).
    std::vector<const BodyPart<Dim>*> clamps = {};
    /// Part of the particle's cell that is elastic material, 0 to 1: what no clamp covers. Empty:
    /// 1. See shares.h.
    std::vector<double> shares = {};

    double share(std::size_t i) const { return shares.empty() ? 1 : shares[i]; }
    /// The motion of the particle is that of others (constraint.clamp), it has no mass of its own.
    bool isImage(std::size_t i) const { return share(i) < real_share; }
    /// A particle of which clamps leave less is an image: rows of a lattice then begin between a
    /// quarter and five quarters of a spacing outside of the clamp.
    static constexpr double real_share = 0.75 - 1e-6;
};

/// Looks, and does not act.
struct ObserverRole {};

}  // namespace sphinx::bodies
