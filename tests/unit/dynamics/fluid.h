// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/context.h"
#include "materials/weakly_compressible_fluid.h"

#include <algorithm>
#include <cmath>

namespace sphinx::test {

/// Water, and walls that it sees, in a world of their own.
template <int Dim>
struct FluidScene {
    static constexpr double spacing = 0.1;
    static constexpr double smoothing_length = 1.3 * spacing;
    static constexpr double density = 2;
    static constexpr double sound_speed = 10;

    /// Particles at rest, each with the volume spacing^Dim.
    explicit FluidScene(const std::vector<Vec<Dim>>& points, double viscosity = 0) {
        water = &add(points, spacing);
        water->role =
            FluidRole<Dim>{std::make_shared<LinearFluid>(density, sound_speed, viscosity)};
        water->sees = {water};
        ParticleSet<Dim>& p = water->particles;
        for (std::size_t i = 0; i < points.size(); ++i) {
            p.scalar(fields::density)[i] = density;
            p.scalar(fields::mass)[i] = density * std::pow(spacing, Dim);
        }
    }
    /// A wall at rest below y = 0.
    Body<Dim>& addWall(const std::vector<Vec<Dim>>& points, double spacing_of_wall) {
        Body<Dim>& wall = add(points, spacing_of_wall);
        wall.role = WallRole{};
        water->sees.push_back(&wall);
        ParticleSet<Dim>& p = wall.particles;
        for (std::size_t i = 0; i < points.size(); ++i) {
            p.vector(fields::normal)[i] = Vec<Dim>::Unit(1);
            p.scalar(fields::depth)[i] = std::max(0.0, -points[i][1]);
        }
        return wall;
    }
    /// Space repeats along x, between these.
    void repeat(double lower, double upper) {
        world.domain.bounds.lower = Vec<Dim>::Constant(lower);
        world.domain.bounds.upper = Vec<Dim>::Constant(upper);
        world.domain.periodic[0] = true;
    }

    World<Dim> world;
    Relations<Dim> relations{world};
    Context<Dim> context{world, relations};
    Body<Dim>* water;

 private:
    Body<Dim>& add(const std::vector<Vec<Dim>>& points, double its_spacing) {
        Body<Dim>& body = *world.bodies.emplace_back(std::make_unique<Body<Dim>>());
        body.spacing = its_spacing;
        body.kernel = Kernel<Dim>(KernelType::wendland_c2, 1.3 * its_spacing, its_spacing);
        ParticleSet<Dim>& p = body.particles;
        p.append(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            p.position()[i] = points[i];
            p.scalar(fields::volume)[i] = std::pow(its_spacing, Dim);
        }
        return body;
    }
};

/// Middles of the cells that fill a box.
template <int Dim>
std::vector<Vec<Dim>> filled(const Vec<Dim>& lower, const Vec<Dim>& upper, double spacing) {
    Vec<3> n = Vec<3>::Ones();
    for (int c = 0; c < Dim; ++c) n[c] = std::round((upper[c] - lower[c]) / spacing);
    std::vector<Vec<Dim>> points;
    for (int k = 0; k < n[2]; ++k)
        for (int j = 0; j < n[1]; ++j)
            for (int i = 0; i < n[0]; ++i)
                points.push_back(
                    lower +
                    spacing * (Vec<3>(i, j, k) + Vec<3>::Constant(0.5)).template head<Dim>());
    return points;
}

}  // namespace sphinx::test
