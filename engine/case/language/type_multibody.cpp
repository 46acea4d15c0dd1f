// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/language/types.h"
#include "dynamics/multibody/parameters.h"

namespace sphinx::language {

using namespace input;

void declareMultibody(Registry& registry) {
    using namespace dynamics::multibody;
    {
        using P = BodyParameters;
        auto& d = registry.declare<P>(Kind::block, "multibody.bodies");
        d.summary(
            "A rigid body of the mechanism; its mass, centre and inertia are those of its "
            "particles where none are given");
        d.optional("particles", &P::particles, list(partReference({"elastic", "rigid"})),
                   "bodies and parts of bodies that it carries along");
        d.optional("mass", &P::mass, number(unit::mass).above(0),
                   "mass (2D: of a slice of unit depth)");
        d.optional("center", &P::center, coordinates(unit::length),
                   "centre of mass in the drawing");
        d.optional("inertia", &P::inertia, list(number(unit::mass * unit::area)),
                   "about the centre: 2D one number; 3D xx, yy, zz, or these and xy, xz, yz");
        d.check("center", [](const P& p) -> std::string {
            return p.center || !p.particles.empty()
                       ? ""
                       : "a body without particles needs its mass, center and inertia";
        });
    }
    using P = MultibodyParameters;
    auto& d = registry.declare<P>(Kind::block, "multibody");
    d.summary(
        "Rigid bodies, joints and what acts on them; moved by multibody.step. The drawing is "
        "the place of all bodies at which the coordinates of all joints are zero");
    d.optional("gravity", &P::gravity, coordinates(unit::acceleration),
               "acceleration of all its bodies");
    d.required("bodies", &P::bodies,
               mapOf(newName(),
                     structure<BodyParameters>(*registry.find(Kind::block, "multibody.bodies"))),
               "named bodies");
    d.optional("joints", &P::joints, components(Kind::joint),
               "named joints: a tree that begins at ground; a body in none is free");
    d.optional("forces", &P::forces, components(Kind::multibody_force), "named forces");
    d.optional("constraints", &P::constraints, components(Kind::multibody_constraint),
               "named constraints, which close loops");
    d.optional("integrator", &P::integrator,
               choice<Integrator>(
                   {{"runge_kutta_4", Integrator::runge_kutta_4,
                     "the classical method of fourth order, four evaluations a step"},
                    {"midpoint", Integrator::midpoint, "second order, two evaluations a step"}}),
               "method by which the mechanism steps, always with equal steps");
    d.optional("step", &P::step, number(unit::time).above(0),
               "largest step of the integrator; default: the step of its layer");
    d.optional("accuracy", &P::accuracy, number(unit::none).above(0).atMost(1e-3),
               "of constraints, default 1e-10: each step ends with their errors below it, in the "
               "case's length and radian");
    d.check("accuracy", [](const P& p) -> std::string {
        return !p.accuracy || p.constrains()
                   ? ""
                   : "accuracy is that of constraints, and the mechanism has none";
    });
}

}  // namespace sphinx::language
