// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/force/surface_pressure.h"

#include "core/parallel.h"
#include "input/expressions/vector_at_time.h"

#include <fmt/format.h>
#include <Eigen/LU>

#include <cmath>
#include <optional>

namespace sphinx::dynamics::force {

template <int Dim>
SurfacePressure<Dim>::SurfacePressure(Part<Dim> part, input::FieldExpression pressure,
                                      double thickness, std::vector<input::FieldExpression> normal)
    : AppliedLoad<Dim>(part),
      part_(part),
      pressure_(std::move(pressure)),
      thickness_(thickness),
      given_normal_(std::move(normal)),
      velocity_(part.body().particles.vector(fields::velocity)),
      external_(part.body().particles.vector(fields::external_acceleration)),
      gradient_(part.body().particles.matrix(fields::deformation_gradient)),
      rate_(part.body().particles.matrix(fields::deformation_rate)),
      mass_(part.body().particles.scalar(fields::mass)) {}

template <int Dim>
void SurfacePressure<Dim>::findAreas() {
    ParticleSet<Dim>& particles = part_.body().particles;
    if (arrangement_ == particles.arrangement()) return;
    arrangement_ = particles.arrangement();
    const auto& start = particles.vector(fields::initial_position);
    const auto& volume = particles.scalar(fields::volume);
    area_.resize(part_.size());
    std::optional<input::VectorAtTime<Dim>> given;
    if (!given_normal_.empty()) given.emplace(given_normal_, 0);
    parallelFor(part_.size(), [&](std::size_t n) {
        const std::size_t i = part_[n];
        const Vec<Dim> normal = given ? (*given)(start[i]) : part_.body().shape->normal(start[i]);
        area_[n] = volume[i] / thickness_ * normal.normalized();
    });
}

template <int Dim>
void SurfacePressure<Dim>::run(const Clock& clock) {
    findAreas();
    const double half = 0.5 * clock.dt;
    const auto& position = part_.body().particles.position();
    AlignedVector<Vec<Dim>>& force = this->forces();
    parallelFor(part_.size(), [&](std::size_t n) {
        const std::size_t i = part_[n];
        const Mat<Dim> F = gradient_[i] + half * rate_[i];
        const Vec<Dim> r = position[i] + half * velocity_[i];
        const double p = pressure_.template operator()<Dim>(r, clock.time + half);
        const Vec<Dim> area = F.determinant() * (F.inverse().transpose() * area_[n]);
        external_[i] -= p / mass_[i] * area;
        force[n] = -p * area;
    });
}

namespace {

/// The normal has a direction, or the body a shape that tells it.
template <int Dim>
void checkNormal(const input::Component& method, BuiltCase<Dim>& built) {
    const auto& p = method.as<SurfacePressureParameters>();
    const ConstPart<Dim> part(built.world, p.part);
    if (p.normal.empty()) {
        if (!part.body().shape)
            built.diagnostics.error(method.place,
                                    fmt::format("{} has no shape that tells the normal of its "
                                                "surface: give 'normal'",
                                                part.body().name));
        return;
    }
    const input::VectorAtTime<Dim> normal(p.normal, 0);
    for (std::size_t n = 0; n < part.size(); ++n) {
        const Vec<Dim>& x = part.body().particles.position()[part[n]];
        const double length = normal(x).norm();
        if (length > 0 && std::isfinite(length)) continue;
        built.diagnostics.error(method.placeOf("normal"),
                                fmt::format("the normal has no direction at {}: its length is {:g}",
                                            built.world.placeText(x), length));
        return;
    }
}

}  // namespace

void declareSurfacePressure(input::Registry& registry) {
    using P = SurfacePressureParameters;
    auto& d = declareMethod<P>(
        registry, "force.surface_pressure", []<int Dim>(const P& p, Context<Dim>& context) {
            const Part<Dim> part(context.world, p.part);
            return std::make_unique<SurfacePressure<Dim>>(
                part, p.pressure, p.thickness.value_or(part.body().spacing), p.normal);
        });
    d.summary(
        "Pressure on the surface of an elastic body, which turns and stretches with it; a "
        "layer of particles along the surface carries it");
    d.formula(
        "f_i = -p(r_i, t) det(F_i) F_i^-T N_i V_i/d, N_i the outward normal at the start, d "
        "the thickness of the layer (Nanson's formula)");
    d.required("part", &P::part, input::partReference({"elastic"}),
               "the layer of particles: a part of a body");
    d.required("pressure", &P::pressure, input::fieldExpression(unit::pressure),
               "pressure p, an expression of the current place and t; positive pushes inwards");
    d.optional("thickness", &P::thickness, input::number(unit::length).above(0),
               "thickness d of the layer at the start; default: the body's spacing, for a single "
               "row of particles");
    d.optional("normal", &P::normal, input::fieldVector(unit::none),
               "outward normal N at the initial position, of any length; default: that of the "
               "body's shape, which at an edge may be of either face");
    d.check("normal", [](const P& p) -> std::string {
        for (const auto& component : p.normal)
            if (component.dependsOnTime())
                return "the normal is that at the start: it must not depend on time";
        return "";
    });
    d.worldRule([](const auto& method, auto& built) { checkNormal(method, built); });
    d.action("before the first half of the body's step, in the same layer")
        .reads("part", {"initial_position", "position", "velocity", "volume", "mass",
                        "deformation_gradient", "deformation_rate"})
        .accumulates("part", {"external_acceleration"});
}

template class SurfacePressure<2>;
template class SurfacePressure<3>;

}  // namespace sphinx::dynamics::force
