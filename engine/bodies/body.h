// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/role.h"
#include "bodies/roles.h"
#include "geometry/shape.h"
#include "kernels/kernel.h"
#include "particles/particle_set.h"

#include <cassert>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace sphinx::bodies {

/// Particles of a body that lie in a shape at the start.
template <int Dim>
struct BodyPart {
    std::string name;
    AlignedVector<Index> particles;  ///< ascending
    geometry::ShapePointer<Dim> shape;
};

/// Particles with a role, a shape and a resolution.
template <int Dim>
struct Body {
    std::string name;
    /// In the order of Role.
    std::variant<ObserverRole, FluidRole<Dim>, WallRole, ElasticRole<Dim>> role;
    particles::ParticleSet<Dim> particles;
    geometry::ShapePointer<Dim> shape;  ///< null for bodies given by points
    double spacing = 0;                 ///< dp, length
    bool on_lattice = true;  ///< at the start; else its particles were fitted to the shape
    kernels::Kernel<Dim> kernel;
    std::vector<Body*> sees;  ///< topology: whose particles act on this body
    /// Neighbors that are one piece of material with this body (topology: bonded).
    std::vector<Body*> bonded;
    std::vector<BodyPart<Dim>> parts;
    /// Counts every change of positions or order of the particles: a list that was built at
    /// another count is stale.
    std::uint64_t version = 0;
    /// Parts and shares follow particles that come, go or change places in memory.
    particles::RemapSubscription remapped{particles.remaps(),
                                          [this](const particles::Remap& remap) { follow(remap); }};

    /// Own particles, and those with copies of other processes' (ParticleSet::held).
    std::size_t size() const { return particles.size(); }
    std::size_t held() const { return particles.held(); }
    /// Finds the particles of the parts, and the shares, anew from the initial positions.
    void findParts() { follow(particles::Remap(std::size_t{0}, size(), size())); }

    Role roleName() const { return static_cast<Role>(role.index()); }
    bool isFluid() const { return std::holds_alternative<FluidRole<Dim>>(role); }
    bool isWall() const { return std::holds_alternative<WallRole>(role); }
    bool isElastic() const { return std::holds_alternative<ElasticRole<Dim>>(role); }
    bool isObserver() const { return std::holds_alternative<ObserverRole>(role); }
    bool isSolid() const { return isWall() || isElastic(); }
    /// Its motion follows from the forces on it: fluids meet it so that both together are stable
    /// (dynamics/fsi/README.md).
    bool responds() const {
        return isElastic() || (isWall() && std::get<WallRole>(role).in_mechanism);
    }

    /// Of the rigid body of a mechanism that it belongs to; infinite where none carries it.
    double carriedMass() const {
        return isWall() ? std::get<WallRole>(role).carried_mass
                        : std::numeric_limits<double>::infinity();
    }

    /// The role of a body that is known to have it.
    FluidRole<Dim>& fluid() { return as<FluidRole<Dim>>(role); }
    const FluidRole<Dim>& fluid() const { return as<const FluidRole<Dim>>(role); }
    ElasticRole<Dim>& elastic() { return as<ElasticRole<Dim>>(role); }
    const ElasticRole<Dim>& elastic() const { return as<const ElasticRole<Dim>>(role); }

    /// Null for observers.
    const materials::Material* material() const {
        if (isFluid()) return fluid().material.get();
        if (isElastic()) return elastic().material.get();
        return isWall() ? std::get<WallRole>(role).material.get() : nullptr;
    }
    /// Uniform gravity on the body; zero where it feels none. Acceleration.
    Vec<Dim> gravity() const {
        if (isFluid()) return fluid().gravity;
        return isElastic() ? elastic().gravity : Vec<Dim>(Vec<Dim>::Zero());
    }
    /// Of a fluid or an elastic body.
    void addGravity(const Vec<Dim>& acceleration) {
        (isFluid() ? fluid().gravity : elastic().gravity) += acceleration;
    }
    /// False for images, which have no mass of their own (ElasticRole::isImage).
    bool hasMass(std::size_t i) const { return !isElastic() || !elastic().isImage(i); }
    /// This body and those bonded to it: one piece of material.
    std::vector<Body*> piece() {
        std::vector<Body*> bodies{this};
        bodies.insert(bodies.end(), bonded.begin(), bonded.end());
        return bodies;
    }
    std::vector<const Body*> piece() const {
        std::vector<const Body*> bodies{this};
        bodies.insert(bodies.end(), bonded.begin(), bonded.end());
        return bodies;
    }

 private:
    template <class Role, class Variant>
    static Role& as(Variant& role) {
        auto* found = std::get_if<std::remove_const_t<Role>>(&role);
        assert(found && "the body has another role");
        return *found;
    }
    void follow(const particles::Remap& remap);
};

}  // namespace sphinx::bodies
