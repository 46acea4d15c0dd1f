// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/multibody/elements.h"
#include "dynamics/multibody/mechanism.h"

namespace sphinx::dynamics::multibody {

/// A Runge-Kutta method each of whose stages needs only the one before: where in the step it is,
/// and how much it counts.
struct Stage {
    double place, weight;
};

inline SimTK::Rotation rotation(const Matrix& m) {
    return SimTK::Rotation(SimTK::Mat33(m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2),
                                        m(2, 0), m(2, 1), m(2, 2)),
                           true);
}

/// A mechanism as Simbody has it. system.cpp makes it, mechanism.cpp moves it.
struct Mechanism::Simbody {
    MechanismDescription description;
    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter{system};
    SimTK::GeneralForceSubsystem forces{system};
    SimTK::Force::UniformGravity gravity{forces, matter, simtk(description.gravity)};
    std::vector<SimTK::MobilizedBody> bodies;  // in the order of the description
    std::vector<Element*> elements;            // likewise; Simbody owns them
    std::vector<BodyLoad> loads;
    std::vector<Screw> passed;
    std::vector<double> work;
    SimTK::State now;
    double last_step = 0;
    bool constrained = false;
    bool prescribed = false;
    TimeSpan span;  ///< the present step
    std::vector<Stage> stages;

    explicit Simbody(MechanismDescription d) : description(std::move(d)) {}

    /// Place of a point of the drawing in the frame of its body: there centres of mass are origins.
    SimTK::Vec3 placeOf(const BodyPoint& p) const {
        return simtk(p.body == ground ? p.at
                                      : Vector(p.at - description.bodies[index(p.body)].center));
    }
    SimTK::MobilizedBody& mobilized(int body) {
        return body == ground ? matter.updGround() : bodies[index(body)];
    }
    Station station(const BodyPoint& p) { return {mobilized(p.body), placeOf(p)}; }
    /// The joint's frame on its parent and on its child.
    SimTK::Transform onParent(const Joint& joint) const {
        return {rotation(joint.frame), placeOf({joint.parent, joint.at_parent})};
    }
    SimTK::Transform onChild(const Joint& joint) const {
        return {rotation(joint.frame), placeOf({joint.child, joint.at_child})};
    }
    static std::size_t index(int body) { return static_cast<std::size_t>(body); }

    void build();
    void start(double time);
    void goOn(double time, const std::vector<double>& state);
    void addBody(const Joint& joint);
    SimTK::MobilizedBody makeMobilizer(const Joint& joint, SimTK::MobilizedBody& parent,
                                       const SimTK::Transform& on_parent, const SimTK::Body& child,
                                       const SimTK::Transform& on_child);
    void addCoordinateForces(const Joint& joint);
    void addMotion(const Joint& joint);
    Element* makeElementOf(const ForceElement& element);
    void setStart(const Joint& joint);
    void addConstraints();
    /// A first step, before any is known: short enough for all given motions.
    void findFirstSpan(double time);
    void prescribe();
    /// Onto constraints and prescribed motions, and unit quaternions.
    void project();
    void advance(double dt);
    void realize();
};

}  // namespace sphinx::dynamics::multibody
