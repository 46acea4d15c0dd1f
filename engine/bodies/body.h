// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shape.h"
#include "kernels/kernel.h"
#include "materials/material.h"
#include "particles/particle_set.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace sphinx {

enum class BodyKind { fluid, solid, observer };

/// Particles of a body that lie in a shape at the start.
template <int Dim>
struct BodyPart {
    std::string name;
    AlignedVector<Index> particles;  ///< ascending
    geometry::ShapePointer<Dim> shape;
    bool mirrors = false;  ///< a clamp: its particles are images, see Body::isImage
};

/// Particles with a material, a shape and a resolution.
template <int Dim>
struct Body {
    std::string name;
    BodyKind kind = BodyKind::fluid;
    ParticleSet<Dim> particles;
    std::shared_ptr<const Material> material;  ///< null for observers
    geometry::ShapePointer<Dim> shape;         ///< null for bodies given by points
    double spacing = 0;                        ///< dp, length
    Kernel<Dim> kernel;
    Vec<Dim> gravity = Vec<Dim>::Zero();  ///< sum of its uniform gravities, acceleration
    std::vector<Body*> sees;              ///< topology: whose particles act on this body
    /// Neighbors that are one piece of material with this body (topology: bonded).
    std::vector<Body*> bonded;
    std::vector<BodyPart<Dim>> parts;
    /// Part of its cell that is elastic material, 0 to 1: what no clamp covers. Empty: 1.
    std::vector<double> shares;
    /// Stiffness of its hourglass control, pressure; see solid/deformation.h.
    double hourglass_modulus = 0;
    /// Counts every change of positions or order of the particles: a list that was built at
    /// another count is stale.
    std::uint64_t version = 0;

    std::size_t size() const { return particles.size(); }
    double share(std::size_t i) const { return shares.empty() ? 1 : shares[i]; }
    /// The motion of the particle is that of others (constraint.clamp), it has no mass of its own.
    bool isImage(std::size_t i) const { return share(i) < real_share; }
    /// Finds the shares anew, from the parts that mirror.
    void findShares() {
        shares.clear();
        for (const BodyPart<Dim>& part : parts) {
            if (!part.mirrors) continue;
            shares.resize(size(), 1);
            for (std::size_t i = 0; i < size(); ++i)
                shares[i] = std::min(shares[i], outside(part, i));
        }
    }
    /// How much of the particle's cell, one spacing wide, lies outside of a part: 0 to 1.
    double outside(const BodyPart<Dim>& part, std::size_t i) {
        const auto& start = particles.vector(fields::initial_position);
        const double share = 0.5 + part.shape->signedDistance(start[i]) / spacing;
        constexpr double rounding = 1e-6;  // of the places of a lattice
        return share < rounding ? 0 : share > 1 - rounding ? 1 : share;
    }
    /// A particle of which clamps leave less is an image: rows of a lattice then begin between a
    /// quarter and five quarters of a spacing outside of it.
    static constexpr double real_share = 0.75 - 1e-6;
    /// This body and those bonded to it: one piece of material.
    std::vector<Body*> piece() {
        std::vector<Body*> bodies{this};
        bodies.insert(bodies.end(), bonded.begin(), bonded.end());
        return bodies;
    }
};

}  // namespace sphinx
