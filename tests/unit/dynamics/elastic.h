// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/context.h"
#include "dynamics/solid/deformation.h"
#include "materials/saint_venant_kirchhoff.h"

#include <array>
#include <cmath>
#include <random>

namespace sphinx::test {

constexpr double spacing = 0.1;
constexpr double youngs_modulus = 1000;
constexpr double density = 2;

inline std::shared_ptr<const ElasticSolid> rubber(double damping = 0) {
    IsotropicParameters p;
    p.density = density;
    p.damping = damping;
    p.youngs_modulus = youngs_modulus;
    p.poisson_ratio = 0.3;
    return std::make_shared<SaintVenantKirchhoff>(p);
}

/// Numbers that are the same on every machine.
class Random {
 public:
    double operator()(double low, double high) {
        return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
    }
    template <int Dim>
    Vec<Dim> vector(double size) {
        Vec<Dim> v;
        for (int c = 0; c < Dim; ++c) v[c] = (*this)(-size, size);
        return v;
    }
    template <int Dim>
    Mat<Dim> matrix(double size) {
        Mat<Dim> m;
        for (int c = 0; c < Dim; ++c) m.col(c) = vector<Dim>(size);
        return m;
    }

 private:
    std::mt19937_64 engine_{7};
};

/// Elastic bodies in a world of their own.
template <int Dim>
struct ElasticScene {
    World<Dim> world;
    Relations<Dim> relations{world};
    Context<Dim> context{world, relations};
    Random random;

    /// Particles at rest, each with the volume spacing^Dim.
    Body<Dim>& add(const std::string& name, const std::vector<Vec<Dim>>& points,
                   double damping = 0) {
        Body<Dim>& body = *world.bodies.emplace_back(std::make_unique<Body<Dim>>());
        body.name = name;
        body.spacing = spacing;
        body.kernel = Kernel<Dim>(KernelType::wendland_c2, 1.15 * spacing, spacing);
        body.role = ElasticRole<Dim>{rubber(damping)};
        ParticleSet<Dim>& p = body.particles;
        p.append(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            p.position()[i] = p.vector(fields::initial_position)[i] = points[i];
            p.scalar(fields::volume)[i] = std::pow(spacing, Dim);
            p.scalar(fields::mass)[i] = density * std::pow(spacing, Dim);
            p.scalar(fields::density)[i] = density;
        }
        return body;
    }
    /// Points of a lattice with a face at the origin, displaced by up to `jitter` spacings.
    std::vector<Vec<Dim>> lattice(const std::array<int, Dim>& n, double jitter = 0) {
        std::vector<Vec<Dim>> points;
        std::array<int, Dim> k{};
        for (int axis = 0; axis < Dim;) {
            Vec<Dim> x = random.template vector<Dim>(jitter);
            for (int c = 0; c < Dim; ++c) x[c] = spacing * (x[c] + k[c] + 0.5);
            points.push_back(x);
            for (axis = 0; axis < Dim && ++k[axis] == n[axis]; ++axis) k[axis] = 0;
        }
        return points;
    }
    /// Jittered: one body, or the same cut in the middle into two that are bonded.
    std::vector<Body<Dim>*> patch(bool bonded, double damping = 0) {
        std::array<int, Dim> n;
        n.fill(Dim == 2 ? 10 : 6);
        std::vector<Vec<Dim>> left, right;
        for (const Vec<Dim>& x : lattice(n, 0.2))
            (bonded && x[0] > 0.5 * spacing * n[0] ? right : left).push_back(x);
        std::vector<Body<Dim>*> bodies{&add("left", left, damping)};
        if (!bonded) return bodies;
        bodies.push_back(&add("right", right, damping));
        bodies[0]->bonded = {bodies[1]};
        bodies[1]->bonded = {bodies[0]};
        return bodies;
    }
    /// A part of that name with the particles for which inside(R) holds.
    template <class Inside>
    void addPart(Body<Dim>& body, const std::string& name, Inside&& inside) {
        BodyPart<Dim> part;
        part.name = name;
        for (std::size_t i = 0; i < body.size(); ++i)
            if (inside(body.particles.position()[i]))
                part.particles.push_back(static_cast<Index>(i));
        body.parts.push_back(std::move(part));
    }
};

/// By a random axis in 3D.
template <int Dim>
Mat<Dim> rotation(double angle, Random& random) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    Mat<Dim> Q;
    if constexpr (Dim == 2) {
        Q << c, -s, s, c;
    } else {
        const Vec<3> n = random.vector<3>(1).normalized();
        Mat<3> N;
        N << 0, -n[2], n[1], n[2], 0, -n[0], -n[1], n[0], 0;
        Q = Mat<3>::Identity() + s * N + (1 - c) * N * N;
    }
    return Q;
}

}  // namespace sphinx::test
