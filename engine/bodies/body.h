// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shape.h"
#include "kernels/kernel.h"
#include "materials/material.h"
#include "particles/particle_set.h"

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
    bool mirrors = false;  ///< its particles are images, see Body::images
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
    /// Not 0: the particle only mirrors the motion of others (constraint.clamp), it is no material
    /// and has no stress. Empty: there is none.
    std::vector<std::uint8_t> images;
    /// Stiffness of its hourglass control, pressure; see solid/deformation.h.
    double hourglass_modulus = 0;
    /// Counts every change of positions or order of the particles: a list that was built at
    /// another count is stale.
    std::uint64_t version = 0;

    std::size_t size() const { return particles.size(); }
    bool isImage(std::size_t i) const { return !images.empty() && images[i] != 0; }
    /// Finds the images anew, from the parts that mirror.
    void findImages() {
        images.clear();
        for (const BodyPart<Dim>& part : parts) {
            if (!part.mirrors) continue;
            images.resize(size());
            for (const Index i : part.particles) images[i] = 1;
        }
    }
    /// This body and those bonded to it: one piece of material.
    std::vector<Body*> piece() {
        std::vector<Body*> bodies{this};
        bodies.insert(bodies.end(), bonded.begin(), bonded.end());
        return bodies;
    }
};

}  // namespace sphinx
