// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"
#include "dynamics/arrangement_watch.h"
#include "dynamics/methods.h"
#include "dynamics/part_method.h"
#include "input/expressions/vector_at_time.h"

#include <fmt/format.h>
#include <Eigen/LU>

#include <cmath>
#include <optional>

namespace sphinx::dynamics::force {
namespace {

/// Pressure on the surface of an elastic body, carried by a layer of particles along it: the part.
/// Particle i stands for the reference area V_i/d of a layer of the thickness d with the outward
/// unit normal N, which the deformation turns and stretches (Nanson's formula): f_i = -p(r_i, t)
/// det(F_i) F_i^-T N_i V_i/d. On a plane face at rest the sum is exactly -p N times the area. Taken
/// at the middle of the step, where the velocity gets its kick.
struct SurfacePressureParameters {
    input::Name part;
    input::FieldExpression pressure;
    std::optional<double> thickness;             ///< d, length; missing: the body's spacing
    std::vector<input::FieldExpression> normal;  ///< of the initial position, of any length; empty:
                                                 ///< N of the body's shape
};

template <int Dim>
class SurfacePressure final : public PartMethod<AppliedLoad, Dim> {
 public:
    SurfacePressure(Context<Dim>& context, const SurfacePressureParameters& p)
        : SurfacePressure::PartMethod(Part<Dim>(context.world, p.part)),
          pressure_(p.pressure),
          thickness_(p.thickness.value_or(this->part().body().spacing)),
          given_normal_(p.normal),
          velocity_(this->part().body().particles.vector(fields::velocity)),
          external_(this->part().body().particles.vector(fields::external_acceleration)),
          gradient_(this->part().body().particles.matrix(fields::deformation_gradient)),
          rate_(this->part().body().particles.matrix(fields::deformation_rate)),
          mass_(this->part().body().particles.scalar(fields::mass)) {}
    void prepare() override { findAreas(); }
    void run(const Clock& clock);

 private:
    /// Where the particles have other places than those found.
    void findAreas();

    input::FieldExpression pressure_;
    double thickness_;
    std::vector<input::FieldExpression> given_normal_;
    AlignedVector<Vec<Dim>> area_;  // N V/d of the part's particles
    ArrangementWatch watch_;
    Field<Vec<Dim>>& velocity_;
    Field<Vec<Dim>>& external_;
    Field<Mat<Dim>>& gradient_;
    Field<Mat<Dim>>& rate_;
    Field<double>& mass_;
};

template <int Dim>
void SurfacePressure<Dim>::findAreas() {
    const Part<Dim>& part = this->part();
    ParticleSet<Dim>& particles = part.body().particles;
    if (!watch_.hasChanged(particles)) return;
    const auto& start = particles.vector(fields::initial_position);
    const auto& volume = particles.scalar(fields::volume);
    area_.resize(part.size());
    std::optional<input::VectorAtTime<Dim>> given;
    if (!given_normal_.empty()) given.emplace(given_normal_, 0);
    parallelFor(part.size(), [&](std::size_t n) {
        const std::size_t i = part[n];
        const Vec<Dim> normal = given ? (*given)(start[i]) : part.body().shape->normal(start[i]);
        area_[n] = volume[i] / thickness_ * normal.normalized();
    });
}

template <int Dim>
void SurfacePressure<Dim>::run(const Clock& clock) {
    findAreas();
    const Part<Dim>& part = this->part();
    const double half = 0.5 * clock.dt;
    const auto& position = part.body().particles.position();
    AlignedVector<Vec<Dim>>& force = this->forces();
    parallelFor(part.size(), [&](std::size_t n) {
        const std::size_t i = part[n];
        const Mat<Dim> F = gradient_[i] + half * rate_[i];
        const Vec<Dim> r = position[i] + half * velocity_[i];
        const double p = pressure_.template operator()<Dim>(r, clock.time + half);
        const Vec<Dim> area = F.determinant() * (F.inverse().transpose() * area_[n]);
        external_[i] -= p / mass_[i] * area;
        force[n] = -p * area;
    });
}

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
    auto& d = declareMethod<SurfacePressure, P>(registry, "force.surface_pressure");
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

}  // namespace sphinx::dynamics::force
