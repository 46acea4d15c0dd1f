// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"
#include "dynamics/methods.h"

#include <fmt/format.h>
#include <cmath>
#include <limits>

namespace sphinx::dynamics::force {
namespace {

/// Uniform gravity. The body knows it from the start: the potential energy uses it, so it acts
/// throughout.
struct GravityParameters {
    input::Name body;
    input::Coordinates acceleration;
};

template <int Dim>
class Gravity final : public Method {
 public:
    Gravity(Context<Dim>& context, const GravityParameters& p)
        : body_(&bodyOf(context, p.body)),
          acceleration_(p.acceleration.as<Dim>()),
          external_(body_->particles.vector(fields::external_acceleration)) {}
    void announce() override { body_->addGravity(acceleration_); }
    void run(const Clock&) {
        parallelFor(body_->size(), [&](std::size_t i) { external_[i] += acceleration_; });
    }
    std::size_t workSize() const override { return body_->size(); }

 private:
    Body<Dim>* body_;
    Vec<Dim> acceleration_;
    Field<Vec<Dim>>& external_;
};

/// Of its density: what the weight of a fluid may compress it by without a word. Its equation of
/// state is meant for a hundredth.
constexpr double most_compression = 0.05;

/// A fluid at rest is compressed by about g H / c^2.
template <int Dim>
void warnSoft(const input::Component& method, BuiltCase<Dim>& built) {
    const auto& p = method.as<GravityParameters>();
    const Body<Dim>& body = *built.world.find(p.body.text);
    if (!body.isFluid() || body.size() == 0) return;
    const Vec<Dim> g = p.acceleration.as<Dim>();
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    const auto& position = body.particles.position();
    for (std::size_t i = 0; i < body.size(); ++i) {
        const Vec<Dim>& x = position[i];
        lowest = std::min(lowest, g.dot(x));
        highest = std::max(highest, g.dot(x));
    }
    const double c = body.fluid().material->soundSpeed();
    const double compression = (highest - lowest) / (c * c);
    if (!(compression > most_compression)) return;
    const double wanted = std::sqrt((highest - lowest) / 0.01);
    built.diagnostics.warning(
        method.place,
        fmt::format("{} is soft: its weight compresses it by {:.2g} %, g H/c^2 with its sound "
                    "speed of {}; about {:.2g}{} keeps that at 1 %",
                    body.name, 100 * compression, built.world.quantityText(c, unit::velocity),
                    wanted, built.world.units.suffix(unit::velocity)));
}

}  // namespace

void declareGravity(input::Registry& registry) {
    using P = GravityParameters;
    auto& d = declareMethod<Gravity, P>(registry, "force.gravity");
    d.summary("Uniform gravity on a body");
    d.formula("dv_i/dt += g");
    d.trait("uniform_gravity");
    d.required("body", &P::body, input::bodyReference({"fluid", "elastic"}),
               "fluid or elastic body");
    d.required("acceleration", &P::acceleration, input::coordinates(unit::acceleration),
               "acceleration of free fall, a vector");
    d.worldRule([](const input::Component& method, auto& built) { warnSoft(method, built); });
    d.action()
        .accumulates("body", {"external_acceleration"})
        .throughout(
            "the potential energy counts on it at all times; force.body_force can act at times");
}

}  // namespace sphinx::dynamics::force
