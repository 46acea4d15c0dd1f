// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0

// Simbody 3.7 is no C++20: see simbody.h.

#include "dynamics/multibody/system.h"

namespace sphinx::dynamics::multibody {
namespace {

SimTK::Rotation turned(const Vector& turn) {
    const double angle = turn.norm();
    if (angle == 0) return {};
    return {angle, SimTK::UnitVec3(simtk(turn / angle))};
}

std::vector<Stage> stagesOf(Integrator integrator) {
    if (integrator == Integrator::midpoint) return {{0, 0}, {0.5, 1}};
    return {{0, 1.0 / 6}, {0.5, 1.0 / 3}, {0.5, 1.0 / 3}, {1, 1.0 / 6}};
}

}  // namespace

void Mechanism::Simbody::addBody(const Joint& joint) {
    const RigidBody& b = description.bodies[index(joint.child)];
    const Matrix& I = b.inertia;
    const SimTK::Body::Rigid child(SimTK::MassProperties(
        b.mass, SimTK::Vec3(0),
        SimTK::Inertia(I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2))));
    bodies[index(joint.child)] =
        makeMobilizer(joint, mobilized(joint.parent), onParent(joint), child, onChild(joint));
}

SimTK::MobilizedBody Mechanism::Simbody::makeMobilizer(const Joint& joint,
                                                       SimTK::MobilizedBody& parent,
                                                       const SimTK::Transform& F,
                                                       const SimTK::Body& child,
                                                       const SimTK::Transform& M) {
    using SimTK::MobilizedBody;
    switch (joint.kind) {
        case JointKind::weld: return MobilizedBody::Weld(parent, F, child, M);
        case JointKind::pin: return MobilizedBody::Pin(parent, F, child, M);
        case JointKind::slider: return MobilizedBody::Slider(parent, F, child, M);
        case JointKind::planar: return MobilizedBody::Planar(parent, F, child, M);
        case JointKind::universal: return MobilizedBody::Universal(parent, F, child, M);
        case JointKind::ball: return MobilizedBody::Ball(parent, F, child, M);
        case JointKind::cylinder: return MobilizedBody::Cylinder(parent, F, child, M);
        case JointKind::gimbal: return MobilizedBody::Gimbal(parent, F, child, M);
        case JointKind::screw: return MobilizedBody::Screw(parent, F, child, M, joint.lead);
        case JointKind::free: break;
    }
    return MobilizedBody::Free(parent, F, child, M);
}

void Mechanism::Simbody::addCoordinateForces(const Joint& joint) {
    SimTK::MobilizedBody& body = bodies[index(joint.child)];
    for (std::size_t k = 0; k < joint.coordinates.size(); ++k) {
        const Coordinate& c = joint.coordinates[k];
        const SimTK::MobilizerQIndex q(static_cast<int>(k));
        const SimTK::MobilizerUIndex u(static_cast<int>(k));
        if (c.spring)
            SimTK::Force::MobilityLinearSpring(forces, body, q, c.spring->stiffness,
                                               c.spring->rest);
        if (c.damping > 0) SimTK::Force::MobilityLinearDamper(forces, body, u, c.damping);
        if (c.limits)
            SimTK::Force::MobilityLinearStop(forces, body, q, c.limits->stiffness,
                                             c.limits->dissipation, c.limits->lower,
                                             c.limits->upper);
        if (c.motor) SimTK::Force::Custom(forces, makeMotor(body, static_cast<int>(k), c.motor));
    }
    if (!joint.bushing) return;
    SimTK::Vec6 stiffness, damping;
    for (int k = 0; k < 6; ++k) {
        stiffness[k] = joint.bushing->stiffness[index(k)];
        damping[k] = joint.bushing->damping[index(k)];
    }
    SimTK::Force::LinearBushing(forces, mobilized(joint.parent), onParent(joint), body,
                                onChild(joint), stiffness, damping);
}

/// Simbody prescribes all coordinates of a joint, or none: some of them are constraints.
void Mechanism::Simbody::addMotion(const Joint& joint) {
    SimTK::MobilizedBody& body = bodies[index(joint.child)];
    std::vector<FunctionOfTime> given;
    for (const Coordinate& c : joint.coordinates)
        if (c.motion) given.push_back(c.motion);
    if (given.empty()) return;
    prescribed = true;
    if (given.size() == joint.coordinates.size()) {
        SimTK::Motion::Custom(body, makeMotion(given, span));
        return;
    }
    for (std::size_t k = 0; k < joint.coordinates.size(); ++k)
        if (joint.coordinates[k].motion)
            SimTK::Constraint::PrescribedMotion(
                matter, makeMotion(joint.coordinates[k].motion, span), body.getMobilizedBodyIndex(),
                SimTK::MobilizerQIndex(static_cast<int>(k)));
    constrained = true;
}

Element* Mechanism::Simbody::makeElementOf(const ForceElement& element) {
    if (const auto* spring = std::get_if<PointSpring>(&element))
        return makeElement(*spring, station(spring->from), station(spring->to));
    if (const auto* given = std::get_if<GivenForce>(&element))
        return makeElement(*given, station(given->at));
    const auto& line = std::get<HangingLine>(element);
    return makeElement(line.line, -description.gravity.normalized(), station(line.from),
                       station(line.to));
}

void Mechanism::Simbody::setStart(const Joint& joint) {
    const SimTK::MobilizedBody& body = bodies[index(joint.child)];
    if (joint.kind == JointKind::ball || joint.kind == JointKind::free) {
        const SimTK::Rotation R = turned(joint.frame.transpose() * joint.turn);
        body.setQToFitRotation(now, R);
        body.setUToFitAngularVelocity(now, simtk(joint.frame.transpose() * joint.angular_velocity));
        if (joint.kind == JointKind::free) {
            body.setQToFitTranslation(now, simtk(joint.frame.transpose() * joint.shift));
            body.setUToFitLinearVelocity(now, simtk(joint.frame.transpose() * joint.velocity));
        }
        return;
    }
    for (std::size_t k = 0; k < joint.coordinates.size(); ++k) {
        body.setOneQ(now, static_cast<int>(k), joint.coordinates[k].value);
        body.setOneU(now, static_cast<int>(k), joint.coordinates[k].rate);
    }
}

void Mechanism::Simbody::addConstraints() {
    using SimTK::Constraint;
    for (const Rod& rod : description.rods)
        Constraint::Rod(mobilized(rod.from.body), placeOf(rod.from), mobilized(rod.to.body),
                        placeOf(rod.to), rod.length);
    for (const CoincidentPoints& c : description.coincident_points)
        Constraint::Ball(mobilized(c.from.body), placeOf(c.from), mobilized(c.to.body),
                         placeOf(c.to));
    for (const PointOnLine& c : description.points_on_lines)
        Constraint::PointOnLine(mobilized(c.line.body), SimTK::UnitVec3(simtk(c.along)),
                                placeOf(c.line), mobilized(c.point.body), placeOf(c.point));
    for (const CoordinateCoupler& c : description.couplers) {
        SimTK::Vector factors(static_cast<int>(c.terms.size()) + 1);
        SimTK::Array_<SimTK::MobilizedBodyIndex> which;
        SimTK::Array_<SimTK::MobilizerQIndex> coordinates;
        int k = 0;
        for (const CoordinateCoupler::Term& term : c.terms) {
            factors[k++] = term.factor;
            const Joint& joint = description.joints[index(term.joint)];
            which.push_back(bodies[index(joint.child)].getMobilizedBodyIndex());
            coordinates.push_back(SimTK::MobilizerQIndex(term.coordinate));
        }
        factors[k] = -c.offset;
        Constraint::CoordinateCoupler(matter, new SimTK::Function::Linear(factors), which,
                                      coordinates);
    }
    constrained = constrained || !description.rods.empty() ||
                  !description.coincident_points.empty() || !description.points_on_lines.empty() ||
                  !description.couplers.empty();
}

void Mechanism::Simbody::build() {
    stages = stagesOf(description.integrator);
    bodies.resize(description.bodies.size());
    loads.resize(bodies.size());
    passed.assign(bodies.size(), Screw::Zero());
    work.assign(bodies.size(), 0);
    // A parent before its children.
    std::vector<bool> made(bodies.size(), false);
    for (std::size_t count = 0; count < description.joints.size();) {
        const std::size_t before = count;
        for (const Joint& joint : description.joints) {
            if (made[index(joint.child)]) continue;
            if (joint.parent != ground && !made[index(joint.parent)]) continue;
            addBody(joint);
            made[index(joint.child)] = true;
            ++count;
        }
        if (count == before) throw MechanismError("joints are no tree that begins at ground");
    }
    for (const Joint& joint : description.joints) {
        addCoordinateForces(joint);
        addMotion(joint);
    }
    for (const ForceElement& force : description.forces) {
        elements.push_back(makeElementOf(force));
        SimTK::Force::Custom(forces, elements.back());
    }
    SimTK::Force::Custom(forces, makeParticleLoads(bodies, loads));
    addConstraints();
    system.realizeTopology();
    now = system.getDefaultState();
}

}  // namespace sphinx::dynamics::multibody
