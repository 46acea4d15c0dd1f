// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "../memory_archive.h"
#include "io/output/factory.h"
#include "io/series/series.h"
#include "materials/weakly_compressible_fluid.h"
#include "support.h"

#include <utility>

namespace sphinx::test {

/// A world of lattices, for outputs that look at particles.
template <int Dim>
struct Scene {
    World<Dim> world;
    Relations<Dim> relations{world};
    double spacing = 0.1;

    Body<Dim>& add(const std::string& name) {
        auto body = std::make_unique<Body<Dim>>();
        body->name = name;
        body->spacing = spacing;
        body->kernel = Kernel<Dim>(KernelType::wendland_c2, 1.3 * spacing, spacing);
        world.bodies.push_back(std::move(body));
        return *world.bodies.back();
    }
    /// Points of a lattice with faces at multiples of the spacing, as long as they are in the box.
    Body<Dim>& fill(Body<Dim>& body, const Box<Dim>& box) {
        Vec<Dim> first;
        for (int k = 0; k < Dim; ++k)
            first[k] = (std::round(box.lower[k] / spacing) + 0.5) * spacing;
        std::vector<Vec<Dim>> points;
        std::array<int, Dim> n{};
        for (;;) {
            Vec<Dim> x = first;
            for (int k = 0; k < Dim; ++k) x[k] += n[k] * spacing;
            if (box.contains(x)) points.push_back(x);
            int k = 0;
            while (k < Dim && !(first[k] + ++n[k] * spacing < box.upper[k])) n[k++] = 0;
            if (k == Dim) break;
        }
        return place(body, points);
    }
    Body<Dim>& place(Body<Dim>& body, const std::vector<Vec<Dim>>& points) {
        const std::size_t before = body.size();
        body.particles.append(points.size());
        Field<double>& volume = body.particles.scalar(fields::volume);
        for (std::size_t i = 0; i < points.size(); ++i) {
            body.particles.position()[before + i] = points[i];
            volume[before + i] = std::pow(spacing, Dim);
        }
        ++body.version;
        return body;
    }
    Body<Dim>& observer(const std::vector<Vec<Dim>>& points, std::vector<Body<Dim>*> sees) {
        Body<Dim>& body = place(add("probe"), points);
        body.sees = std::move(sees);
        return body;
    }
    /// A weakly compressible fluid at rest with sound speed 10 and the given density.
    Body<Dim>& fluid(const std::string& name, const Box<Dim>& box, double density = 2,
                     double viscosity = 0) {
        Body<Dim>& body = add(name);
        body.role = FluidRole<Dim>{std::make_shared<LinearFluid>(density, 10, viscosity)};
        fill(body, box);
        ParticleSet<Dim>& p = body.particles;
        p.vector(fields::velocity);
        p.scalar(fields::pressure);
        for (std::size_t i = 0; i < body.size(); ++i) {
            p.scalar(fields::density)[i] = density;
            p.scalar(fields::mass)[i] = density * p.scalar(fields::volume)[i];
        }
        return body;
    }
    Body<Dim>& wall(const std::string& name) {
        Body<Dim>& body = add(name);
        body.role = WallRole{};
        return body;
    }
    io::OutputContext<Dim> context(const io::Path& folder) {
        return {world, relations, folder, {}, {}, nullptr, [] { return Progress{}; }, {}, {}};
    }
};

/// What throws, says.
template <class F>
std::string errorOf(F&& f) {
    try {
        f();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

inline Clock clockAt(double time, double dt = 0) {
    Clock clock;
    clock.time = time;
    clock.dt = dt;
    return clock;
}

inline std::vector<double> rowOf(io::SeriesSource& source) {
    std::size_t width = 0;
    for (const io::SeriesQuantity& quantity : source.quantities()) width += quantity.size();
    std::vector<double> row(width);
    source.sample(Clock{}, row);
    return row;
}

}  // namespace sphinx::test
