// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/new_particles.h"
#include "bodies/world.h"
#include "materials/saint_venant_kirchhoff.h"
#include "materials/weakly_compressible_fluid.h"
#include "particles/lattice.h"
#include "random.h"

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace sphinx::test {

// What bodies are made of, unless the test says otherwise.
inline constexpr double spacing = 0.1;
inline constexpr double density = 2;
inline constexpr double sound_speed = 10;
inline constexpr double youngs_modulus = 1000;

struct Water {
    double density = test::density;
    double viscosity = 0;
};

struct Rubber {
    double density = test::density;
    double damping = 0;
};

inline std::shared_ptr<const materials::ElasticSolid> makeRubber(const Rubber& rubber = {}) {
    materials::IsotropicParameters p;
    p.density = rubber.density;
    p.damping = rubber.damping;
    p.youngs_modulus = youngs_modulus;
    p.poisson_ratio = 0.3;
    return std::make_shared<materials::SaintVenantKirchhoff>(p);
}

/// The plane where x[axis] is `at`, of a body that lies behind it.
struct Face {
    int axis = 1;
    double at = 0;
    double side = 1;  ///< 1: its normal points to larger x[axis]; -1: to smaller ones
};

/// Bodies in a world of their own: what a case says under `bodies`, in the same words. Their
/// particles are at rest, each with the volume spacing^Dim, and are made as those of a case.
template <int Dim>
struct Bodies {
    using Points = std::vector<Vec<Dim>>;

    bodies::World<Dim> world;
    double spacing = test::spacing;  ///< of the bodies that are added next
    Random random;

    /// It sees itself.
    bodies::Body<Dim>& fluid(const std::string& name, const Points& points,
                             const Water& water = {}) {
        bodies::Body<Dim>& body =
            add(name, bodies::FluidRole<Dim>{std::make_shared<materials::LinearFluid>(
                          water.density, sound_speed, water.viscosity)});
        body.sees = {&body};
        return place(body, points);
    }
    bodies::Body<Dim>& wall(const std::string& name, const Points& points) {
        return place(add(name, bodies::WallRole{std::make_shared<materials::Rigid>(density)}),
                     points);
    }
    bodies::Body<Dim>& wall(const std::string& name, const Points& points, const Face& face) {
        return setFace(wall(name, points), face);
    }
    bodies::Body<Dim>& elastic(const std::string& name, const Points& points,
                               const Rubber& rubber = {}) {
        return place(add(name, bodies::ElasticRole<Dim>{makeRubber(rubber)}, 1.15), points);
    }
    bodies::Body<Dim>& observer(const Points& points, std::vector<bodies::Body<Dim>*> sees) {
        bodies::Body<Dim>& body = place(add("probe", bodies::ObserverRole{}), points);
        body.sees = std::move(sees);
        return body;
    }

    /// Without particles. `smoothing`: smoothing lengths per spacing.
    bodies::Body<Dim>& add(const std::string& name, decltype(bodies::Body<Dim>::role) role,
                           double smoothing = 1.3) {
        bodies::Body<Dim>& body = *world.bodies.emplace_back(std::make_unique<bodies::Body<Dim>>());
        body.name = name;
        body.role = std::move(role);
        body.spacing = spacing;
        body.kernel =
            kernels::Kernel<Dim>(kernels::KernelType::wendland_c2, smoothing * spacing, spacing);
        return body;
    }
    /// More particles.
    bodies::Body<Dim>& place(bodies::Body<Dim>& body, const Points& points) {
        std::vector<bodies::NewParticle<Dim>> made(points.size());
        for (std::size_t k = 0; k < points.size(); ++k) {
            made[k].position = points[k];
            made[k].volume = body.isObserver() ? 0 : std::pow(body.spacing, Dim);
        }
        bodies::addParticles(body, made);
        return body;
    }
    /// Normals and depths of a solid behind a plane.
    bodies::Body<Dim>& setFace(bodies::Body<Dim>& body, const Face& face) {
        particles::ParticleSet<Dim>& p = body.particles;
        auto& normal = p.vector(fields::normal);
        auto& depth = p.scalar(fields::depth);
        for (std::size_t i = 0; i < body.size(); ++i) {
            normal[i] = face.side * Vec<Dim>::Unit(face.axis);
            depth[i] = face.side * (face.at - p.position()[i][face.axis]);
        }
        return body;
    }
    /// A part with the particles for which inside(R) holds.
    template <class Inside>
    void addPart(bodies::Body<Dim>& body, const std::string& name, Inside&& inside) {
        bodies::BodyPart<Dim> part;
        part.name = name;
        for (std::size_t i = 0; i < body.size(); ++i)
            if (inside(body.particles.position()[i]))
                part.particles.push_back(static_cast<Index>(i));
        body.parts.push_back(std::move(part));
    }
    /// Space repeats along one axis, between the bounds.
    void repeat(int axis, const Vec<Dim>& lower, const Vec<Dim>& upper) {
        world.domain.bounds = {lower, upper};
        world.domain.periodic[axis] = true;
    }

    /// Points of the lattice with lines half a spacing from the origin.
    Points box(const Vec<Dim>& lower, const Vec<Dim>& upper) const {
        return particles::latticePoints<Dim>(*geometry::makeBox<Dim>(lower, upper),
                                             {spacing, Vec<Dim>::Zero()});
    }
    /// So many of them from the origin, displaced by up to `jitter` spacings.
    Points lattice(const std::array<int, Dim>& n, double jitter = 0) {
        Vec<Dim> upper;
        for (int c = 0; c < Dim; ++c) upper[c] = n[c] * spacing;
        return disordered(box(Vec<Dim>::Zero(), upper), jitter);
    }
    Points lattice(int n, double jitter = 0) {
        std::array<int, Dim> size;
        size.fill(n);
        return lattice(size, jitter);
    }
    Points disordered(Points points, double jitter) {
        for (Vec<Dim>& x : points) x += spacing * random.template vector<Dim>(jitter);
        return points;
    }
};

}  // namespace sphinx::test
