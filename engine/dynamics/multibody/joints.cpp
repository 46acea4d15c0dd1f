// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/multibody/components.h"
#include "dynamics/multibody/mechanism.h"
#include "input/declaration/registry.h"

namespace sphinx::dynamics::multibody {
namespace {

using P = JointParameters;
using Declared = input::Declared<P>;

template <class Parameters>
auto& declareBlock(input::Registry& registry, const char* name, const char* summary) {
    auto& d = registry.declare<Parameters>(input::Kind::block, name);
    d.summary(summary);
    return d;
}

/// What a joint can have whose one coordinate is an angle or a length.
struct OneCoordinate {
    Dimension value;   ///< none: radian
    Dimension effort;  ///< force, or energy for a moment
    const char* word;  ///< of the blocks
};

std::string blockName(const OneCoordinate& c, const char* name) {
    return std::string("multibody.") + c.word + "_" + name;
}

/// Spring, damping, limits, motor and motion of a coordinate.
template <class Parameters>
void declareActing(const input::Registry& registry, input::Declared<Parameters>& d,
                   const OneCoordinate& c) {
    const auto block = [&](const char* name) -> const input::Declaration& {
        return *registry.find(input::Kind::block, blockName(c, name));
    };
    d.optional("spring", &Parameters::spring, input::structure<SpringParameters>(block("spring")),
               "spring on the coordinate");
    d.optional("damping", &Parameters::damping,
               input::number(c.effort * unit::time / c.value).atLeast(0),
               "force or moment per rate of the coordinate");
    d.optional("limits", &Parameters::limits, input::structure<LimitsParameters>(block("limits")),
               "stops");
    d.optional("motor", &Parameters::motor, input::fieldExpression(c.effort),
               "force or moment on the coordinate, an expression of t");
    d.optional("motion", &Parameters::motion, input::fieldExpression(c.value),
               "prescribed coordinate, an expression of t; at the start it counts instead of "
               "a given start");
}

void declareBlocks(input::Registry& registry, const OneCoordinate& c) {
    auto& spring = declareBlock<SpringParameters>(
        registry, blockName(c, "spring").c_str(),
        c.value == unit::none ? "Torsional spring on the coordinate of a joint"
                              : "Spring on the coordinate of a joint");
    spring.required("stiffness", &SpringParameters::stiffness,
                    input::number(c.effort / c.value).atLeast(0),
                    "force or moment per coordinate (angles in radian)");
    spring.optional("rest", &SpringParameters::rest, input::number(c.value),
                    "coordinate at which it exerts nothing");
    auto& limits = declareBlock<LimitsParameters>(registry, blockName(c, "limits").c_str(),
                                                  "Stops of a joint: springs beyond its limits");
    limits.formula("k (q - upper) (1 + d dq/dt) beyond the upper limit, likewise below the lower");
    limits.required("lower", &LimitsParameters::lower, input::number(c.value), "least coordinate");
    limits.required("upper", &LimitsParameters::upper, input::number(c.value),
                    "largest coordinate");
    limits.required("stiffness", &LimitsParameters::stiffness,
                    input::number(c.effort / c.value).above(0), "k: how far the stop gives way");
    limits.optional("dissipation", &LimitsParameters::dissipation,
                    input::number(unit::time / c.value).atLeast(0),
                    "d: 0 is a stop that loses no energy");
    limits.check("upper", [](const LimitsParameters& p) -> std::string {
        return p.lower < p.upper ? "" : "upper must be above lower";
    });
    declareActing(registry,
                  declareBlock<CoordinateParameters>(
                      registry, blockName(c, "coordinate").c_str(),
                      "What acts on a coordinate of a joint that has several; {} is nothing"),
                  c);
    auto& bushing = declareBlock<BushingParameters>(
        registry, blockName(c, "bushing").c_str(),
        "Spring and damper of a joint that turns about a point; {} is nothing");
    bushing.optional("stiffness", &BushingParameters::stiffness,
                     input::number(c.effort / c.value).atLeast(0),
                     "force or moment per way or angle from the drawing");
    bushing.optional("damping", &BushingParameters::damping,
                     input::number(c.effort * unit::time / c.value).atLeast(0),
                     "force or moment per rate");
}

class JointDeclarer {
 public:
    JointDeclarer(input::Registry& registry) : registry_(registry) {}

    Declared& declare(const char* name, JointKind kind, const char* summary) {
        auto& d = registry_.declare<P>(input::Kind::joint, name);
        d.summary(summary);
        d.builder(kind);
        d.required("parent", &P::parent, input::rigidBodyReference(true),
                   "body that carries it, or ground");
        d.required("child", &P::child, input::rigidBodyReference(), "body that it carries");
        return d;
    }
    void places(Declared& d) {
        d.optional("at", &P::at, input::coordinates(unit::length),
                   "where it is in the drawing; default: the child's centre of mass");
        d.optional("child_at", &P::child_at, input::coordinates(unit::length),
                   "point of the child in the drawing that comes to 'at'; default: 'at'");
    }
    void axis(Declared& d, const char* text) {
        d.optional("axis", &P::axis, input::coordinates(unit::none), text);
    }
    /// Start, spring, damping, limits, motor and motion of the one coordinate.
    void oneCoordinate(Declared& d, const OneCoordinate& c) {
        if (c.value == unit::none) {
            d.optional("angle", &P::angle, input::number(unit::none),
                       "angle at the start, from the drawing; radian");
            d.optional("rate", &P::rate, input::number(unit::frequency),
                       "angular velocity at the start");
        } else {
            d.optional("displacement", &P::displacement, input::number(unit::length),
                       "displacement at the start, from the drawing");
            d.optional("speed", &P::speed, input::number(unit::velocity), "its rate at the start");
        }
        declareActing(registry_, d, c);
    }
    /// Of a joint with several coordinates, in their order.
    void several(Declared& d, const OneCoordinate& c, const char* text) {
        const bool turns = c.value == unit::none;
        d.optional(turns ? "turning" : "sliding", turns ? &P::turning : &P::sliding,
                   input::list(input::structure<CoordinateParameters>(
                       *registry_.find(input::Kind::block, blockName(c, "coordinate")))),
                   text);
    }
    void bushings(Declared& d, const OneCoordinate& c, const char* text) {
        const bool turns = c.value == unit::none;
        d.optional(turns ? "turning" : "sliding",
                   turns ? &P::turning_bushings : &P::sliding_bushings,
                   input::list(input::structure<BushingParameters>(
                       *registry_.find(input::Kind::block, blockName(c, "bushing")))),
                   text);
    }

 private:
    input::Registry& registry_;
};

}  // namespace

void declareJoints(input::Registry& registry) {
    const OneCoordinate turning{unit::none, unit::energy, "turning"};
    const OneCoordinate sliding{unit::length, unit::force, "sliding"};
    declareBlocks(registry, turning);
    declareBlocks(registry, sliding);
    JointDeclarer joints(registry);

    joints.declare("weld", JointKind::weld, "Holds the child to the parent as in the drawing");
    {
        auto& d = joints.declare("pin", JointKind::pin, "Turns about an axis");
        joints.places(d);
        joints.axis(d, "3D: direction of the axis");
        joints.oneCoordinate(d, turning);
    }
    {
        auto& d = joints.declare("slider", JointKind::slider, "Moves along an axis");
        joints.places(d);
        joints.axis(d, "direction; default: x");
        joints.oneCoordinate(d, sliding);
    }
    {
        auto& d = joints.declare("planar", JointKind::planar,
                                 "Turns about an axis and moves across it; 2D: free");
        joints.places(d);
        joints.axis(d, "3D: direction of the axis");
        d.optional("angle", &P::angle, input::number(unit::none), "angle at the start, radian");
        d.optional("rate", &P::rate, input::number(unit::frequency),
                   "angular velocity at the start");
        d.optional("shift", &P::shift, input::coordinates(unit::length),
                   "displacement at the start");
        d.optional("velocity", &P::velocity, input::coordinates(unit::velocity),
                   "velocity at the start");
        joints.several(d, turning, "what acts on the angle: a list of one");
        joints.several(d, sliding, "what acts along the two axes across: a list of two; 2D: x, y");
    }
    {
        auto& d = joints.declare("cylinder", JointKind::cylinder,
                                 "3D: turns about an axis and moves along it");
        joints.places(d);
        joints.axis(d, "direction of the axis");
        d.optional("angle", &P::angle, input::number(unit::none), "angle at the start, radian");
        d.optional("rate", &P::rate, input::number(unit::frequency),
                   "angular velocity at the start");
        d.optional("displacement", &P::displacement, input::number(unit::length),
                   "way along the axis at the start");
        d.optional("speed", &P::speed, input::number(unit::velocity), "its rate at the start");
        joints.several(d, turning, "what acts on the angle: a list of one");
        joints.several(d, sliding, "what acts along the axis: a list of one");
    }
    {
        auto& d = joints.declare("screw", JointKind::screw,
                                 "3D: turns about an axis and moves along it by a lead");
        joints.places(d);
        joints.axis(d, "direction of the axis");
        d.required("lead", &P::lead, input::number(unit::length), "way per radian");
        joints.oneCoordinate(d, turning);
    }
    const auto angles = [](Declared& d, const char* text) {
        d.optional("angles", &P::angles, input::list(input::number(unit::none)), text);
        d.optional("rates", &P::rates, input::list(input::number(unit::frequency)),
                   "their rates at the start");
    };
    {
        auto& d = joints.declare("universal", JointKind::universal,
                                 "3D: turns about an axis of the parent and one of the child");
        joints.places(d);
        joints.axis(d, "axis of the parent; default: x");
        d.optional("second_axis", &P::second_axis, input::coordinates(unit::none),
                   "axis of the child, across the other; default: y");
        angles(d, "both angles at the start, radian");
        joints.several(d, turning, "what acts on both angles: a list of two");
    }
    {
        auto& d = joints.declare("gimbal", JointKind::gimbal,
                                 "3D: turns about x, the moved y and the moved z");
        joints.places(d);
        angles(d, "the three angles at the start, radian");
        joints.several(d, turning, "what acts on the angles: a list of three");
    }
    const auto turns = [](Declared& d) {
        d.optional("turn", &P::turn, input::list(input::number(unit::none)),
                   "rotation at the start: axis times angle in radian");
        d.optional("angular_velocity", &P::angular_velocity,
                   input::list(input::number(unit::frequency)), "angular velocity at the start");
    };
    const char* bushing_text =
        "springs and dampers on the angles about x, the moved y and the moved z, for the second "
        "below 90 degrees: a list of three";
    {
        auto& d = joints.declare("ball", JointKind::ball, "3D: turns about a point");
        joints.places(d);
        turns(d);
        joints.bushings(d, turning, bushing_text);
    }
    {
        auto& d = joints.declare("free", JointKind::free,
                                 "Carries nothing: what a body has that is child of no joint");
        joints.places(d);
        turns(d);
        d.optional("shift", &P::shift, input::coordinates(unit::length),
                   "displacement at the start");
        d.optional("velocity", &P::velocity, input::coordinates(unit::velocity),
                   "velocity at the start, of the joint's point");
        joints.bushings(d, turning, bushing_text);
        joints.bushings(d, sliding, "springs and dampers along x, y and z: a list of three");
    }
}

}  // namespace sphinx::dynamics::multibody
