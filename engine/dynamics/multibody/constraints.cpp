// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/multibody/components.h"
#include "input/declaration/registry.h"

namespace sphinx::dynamics::multibody {
namespace {

struct TwoPointsParameters {
    PointParameters from, to;
    std::optional<double> length;
};
struct LineParameters {
    PointParameters line, point;
    input::Coordinates along;
};
struct CouplerParameters {
    input::Name joint, with;
    double ratio = 1;
    double offset = 0;
};

}  // namespace

void declareConstraints(input::Registry& registry) {
    const auto point =
        input::structure<PointParameters>(*registry.find(input::Kind::block, "multibody.point"));
    {
        using P = TwoPointsParameters;
        auto& d = registry.declare<P>(input::Kind::multibody_constraint, "rod");
        d.summary("Keeps two points at a distance: a rod without mass");
        d.required("from", &P::from, point, "one end");
        d.required("to", &P::to, point, "the other end");
        d.optional("length", &P::length, input::number(unit::length).above(0),
                   "distance; default: that of the drawing");
        d.builder(AddComponent([](const input::Component& c, Assembly& assembly) {
            const P& p = c.as<P>();
            const BodyPoint from = assembly.point(p.from), to = assembly.point(p.to);
            assembly.mechanism.rods.push_back(
                {from, to, p.length.value_or((to.at - from.at).norm())});
        }));
    }
    {
        using P = TwoPointsParameters;
        auto& d = registry.declare<P>(input::Kind::multibody_constraint, "coincident_points");
        d.summary("Keeps two points together: closes a loop by a pin (2D) or a ball (3D)");
        d.required("from", &P::from, point, "a point");
        d.required("to", &P::to, point, "a point of another body");
        d.builder(AddComponent([](const input::Component& c, Assembly& assembly) {
            const P& p = c.as<P>();
            assembly.mechanism.coincident_points.push_back(
                {assembly.point(p.from), assembly.point(p.to)});
        }));
    }
    {
        using P = LineParameters;
        auto& d = registry.declare<P>(input::Kind::multibody_constraint, "point_on_line");
        d.summary("Keeps a point on a line of another body: a slot");
        d.required("line", &P::line, point, "body of the line and a point on it");
        d.required("along", &P::along, input::coordinates(unit::none),
                   "direction of the line in the drawing");
        d.required("point", &P::point, point, "what stays on it");
        d.builder(AddComponent([](const input::Component& c, Assembly& assembly) {
            const P& p = c.as<P>();
            assembly.mechanism.points_on_lines.push_back(
                {assembly.point(p.line), vectorOf(p.along).normalized(), assembly.point(p.point)});
        }));
    }
    {
        using P = CouplerParameters;
        auto& d = registry.declare<P>(input::Kind::multibody_constraint, "coupler");
        d.summary("Couples the coordinates of two joints of one coordinate each: gears, belts");
        d.formula("q = ratio q' + offset");
        d.required("joint", &P::joint, input::jointReference(), "joint of q");
        d.required("with", &P::with, input::jointReference(), "joint of q'");
        d.optional("ratio", &P::ratio, input::number(unit::none),
                   "of the coordinates, in radian and in the case's length");
        d.optional("offset", &P::offset, input::number(unit::none),
                   "in radian or in the case's length");
        d.builder(AddComponent([](const input::Component& c, Assembly& assembly) {
            const P& p = c.as<P>();
            assembly.mechanism.couplers.push_back(
                {{{assembly.joint(p.joint), 0, 1}, {assembly.joint(p.with), 0, -p.ratio}},
                 p.offset});
        }));
    }
}

}  // namespace sphinx::dynamics::multibody
