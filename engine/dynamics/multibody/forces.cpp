// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/multibody/components.h"
#include "input/declaration/registry.h"

namespace sphinx::dynamics::multibody {
namespace {

struct SpringForceParameters {
    PointParameters from, to;
    double stiffness = 0;
    double rest_length = 0;
    double damping = 0;
    bool tension_only = false;
};

/// Along fixed directions; in 2D the moment is about z.
struct GivenForceParameters {
    input::Name body;
    std::optional<input::Coordinates> at;
    std::vector<input::FieldExpression> force;
    std::vector<input::FieldExpression> moment;
};

struct CatenaryParameters {
    PointParameters from, to;
    double length = 0, stiffness = 0, weight = 0;
    bool on_ground = false;
};

std::vector<FunctionOfTime> threeOf(const std::vector<input::FieldExpression>& given, bool about_z,
                                    const std::string& name) {
    if (given.empty()) return {};
    const FunctionOfTime zero = [](double) { return 0.0; };
    std::vector<FunctionOfTime> three(3, zero);
    for (std::size_t k = 0; k < given.size(); ++k)
        three[about_z ? 2 : k] = functionOfTime(given[k], name);
    return three;
}

void addGivenForce(const input::Component& component, Assembly& assembly) {
    const auto& p = component.as<GivenForceParameters>();
    const int body = assembly.body(p.body);
    const Vector at =
        p.at ? vectorOf(*p.at) : assembly.mechanism.bodies[static_cast<std::size_t>(body)].center;
    assembly.mechanism.forces.push_back(
        GivenForce{{body, at},
                   threeOf(p.force, false, component.name),
                   threeOf(p.moment, p.moment.size() == 1, component.name)});
}

void declarePoint(input::Registry& registry) {
    using P = PointParameters;
    auto& d = registry.declare<P>(input::Kind::block, "multibody.point");
    d.summary("A point of a rigid body");
    d.required("body", &P::body, input::rigidBodyReference(true), "body, or ground");
    d.required("at", &P::at, input::coordinates(unit::length), "where it is in the drawing");
}

void declareSpring(input::Registry& registry) {
    using P = SpringForceParameters;
    const auto point =
        input::structure<PointParameters>(*registry.find(input::Kind::block, "multibody.point"));
    auto& d = registry.declare<P>(input::Kind::multibody_force, "linear_spring");
    d.summary("Spring and damper between two points, or a rope");
    d.formula("F = k (L - L0) + d dL/dt along the line of both points");
    d.required("from", &P::from, point, "one end");
    d.required("to", &P::to, point, "the other end");
    d.required("stiffness", &P::stiffness, input::number(unit::force / unit::length).atLeast(0),
               "k");
    d.optional("rest_length", &P::rest_length, input::number(unit::length).atLeast(0), "L0");
    d.optional("damping", &P::damping, input::number(unit::mass_rate).atLeast(0), "d");
    d.optional("tension_only", &P::tension_only, input::boolean(),
               "a rope: it pulls where L is above L0, and never pushes");
    d.builder(ForceBuilder{ForceKind::spring, [](const input::Component& c, Assembly& assembly) {
                               const P& p = c.as<P>();
                               assembly.mechanism.forces.push_back(PointSpring{
                                   assembly.point(p.from), assembly.point(p.to), p.stiffness,
                                   p.rest_length, p.damping, p.tension_only});
                           }});
}

void declareGivenForce(input::Registry& registry) {
    using P = GivenForceParameters;
    auto& d = registry.declare<P>(input::Kind::multibody_force, "given_force");
    d.summary("Force and moment on a body, expressions of t along the axes of the case");
    d.required("body", &P::body, input::rigidBodyReference(), "body on which it acts");
    d.optional("at", &P::at, input::coordinates(unit::length),
               "point of the body in the drawing at which the force acts; default: its centre");
    d.optional("force", &P::force, input::fieldVector(unit::force),
               "force, an expression for each direction");
    d.optional("moment", &P::moment, input::list(input::fieldExpression(unit::energy)),
               "moment: in 2D one expression, in 3D three");
    d.check("", [](const P& p) -> std::string {
        return p.force.empty() && p.moment.empty() ? "give 'force', 'moment' or both" : "";
    });
    d.builder(ForceBuilder{ForceKind::given, addGivenForce});
}

void declareCatenary(input::Registry& registry) {
    using P = CatenaryParameters;
    const auto point =
        input::structure<PointParameters>(*registry.find(input::Kind::block, "multibody.point"));
    auto& d = registry.declare<P>(input::Kind::multibody_force, "catenary");
    d.summary(
        "Mooring line: an elastic line that hangs in its weight between two points, at any time as "
        "if at rest");
    d.formula(
        "elastic catenary of length L, EA and w: x = H/w (asinh(V/H) - asinh((V - w L)/H)) + H "
        "L/EA, z = (sqrt(H^2 + V^2) - sqrt(H^2 + (V - w L)^2))/w + (V L - w L^2/2)/EA; what lies "
        "on the ground bears H alone");
    d.cite("Jonkman 2007");
    d.required("from", &P::from, point, "its anchor");
    d.required("to", &P::to, point, "its other end");
    d.required("length", &P::length, input::number(unit::length).above(0), "L, without tension");
    d.required("stiffness", &P::stiffness, input::number(unit::force).above(0),
               "EA, force per strain");
    d.required("weight", &P::weight, input::number(unit::force / unit::length).above(0),
               "w, weight per length in the water, along multibody.gravity");
    d.optional("on_ground", &P::on_ground, input::boolean(),
               "the anchor lies on level ground, on which the line may lie, without friction");
    d.builder(ForceBuilder{ForceKind::line, [](const input::Component& c, Assembly& assembly) {
                               const P& p = c.as<P>();
                               assembly.mechanism.forces.push_back(
                                   HangingLine{assembly.point(p.from),
                                               assembly.point(p.to),
                                               {p.length, p.stiffness, p.weight, p.on_ground}});
                           }});
}

}  // namespace

void declareForces(input::Registry& registry) {
    declarePoint(registry);
    declareSpring(registry);
    declareGivenForce(registry);
    declareCatenary(registry);
}

}  // namespace sphinx::dynamics::multibody
