// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0

// Simbody 3.7 is no C++20: its headers compare numbers of different types that C++20 finds
// ambiguous. engine/CMakeLists.txt compiles this file as C++17.

#include "dynamics/multibody/mechanism.h"

#include "dynamics/multibody/system.h"

#include <algorithm>
#include <cmath>

namespace sphinx::dynamics::multibody {
namespace {

std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

}  // namespace

int coordinateCount(JointKind kind) {
    switch (kind) {
        case JointKind::weld:
        case JointKind::ball:
        case JointKind::free: return 0;
        case JointKind::pin:
        case JointKind::slider:
        case JointKind::screw: return 1;
        case JointKind::universal:
        case JointKind::cylinder: return 2;
        case JointKind::planar:
        case JointKind::gimbal: return 3;
    }
    return 0;
}

void Mechanism::Simbody::start(double time) {
    now.setTime(time);
    for (const Joint& joint : description.joints) setStart(joint);
    findFirstSpan(time);
    system.realize(now, SimTK::Stage::Instance);
    project();
    realize();
}

void Mechanism::Simbody::goOn(double time, const std::vector<double>& state) {
    const auto q = index(now.getNQ()), u = index(now.getNU());
    if (state.size() != q + u) throw MechanismError("the state is that of another mechanism");
    now.setTime(time);
    findFirstSpan(time);
    for (std::size_t k = 0; k < q; ++k) now.updQ()[static_cast<int>(k)] = state[k];
    for (std::size_t k = 0; k < u; ++k) now.updU()[static_cast<int>(k)] = state[q + k];
    realize();
}

void Mechanism::Simbody::findFirstSpan(double time) {
    span = {time, description.largest_step > 0 ? description.largest_step : 1};
    if (description.largest_step > 0) return;
    const auto resolved = [this] {
        try {
            for (const Joint& joint : description.joints)
                for (const Coordinate& c : joint.coordinates)
                    if (c.motion && !span.resolves(c.motion)) return false;
        } catch (const std::exception&) {
            return false;  // it asks a table for what that does not have
        }
        return true;
    };
    for (int k = 0; k < 20 && !resolved(); ++k) span.length /= 5;
}

void Mechanism::Simbody::prescribe() {
    if (!prescribed) return;
    system.realize(now, SimTK::Stage::Time);
    system.prescribeQ(now);
    system.realize(now, SimTK::Stage::Position);
    system.prescribeU(now);
}

void Mechanism::Simbody::project() {
    prescribe();
    SimTK::ProjectOptions options(description.accuracy);
    options.setOption(SimTK::ProjectOptions::UseInfinityNorm);
    SimTK::ProjectResults results;
    SimTK::Vector no_estimate;
    system.realize(now, SimTK::Stage::Position);
    system.projectQ(now, no_estimate, options, results);
    system.realize(now, SimTK::Stage::Velocity);
    system.projectU(now, no_estimate, options, results);
}

void Mechanism::Simbody::realize() { system.realize(now, SimTK::Stage::Acceleration); }

void Mechanism::Simbody::advance(double h) {
    const double t = now.getTime();
    span = {t, h};
    // What was known of given motions was so by the step before.
    if (prescribed) now.setTime(t);
    prescribe();
    const SimTK::Vector q = now.getQ();
    const SimTK::Vector u = now.getU();
    SimTK::Vector q_rate, u_rate;
    SimTK::Vector q_sum(q.size(), 0.0), u_sum(u.size(), 0.0);
    for (const Stage& stage : stages) {
        if (stage.place > 0) {
            now.setTime(t + stage.place * h);
            now.updQ() = q + (stage.place * h) * q_rate;
            now.updU() = u + (stage.place * h) * u_rate;
            prescribe();
        }
        realize();
        q_rate = now.getQDot();
        u_rate = now.getUDot();
        if (stage.weight == 0) continue;
        q_sum += stage.weight * q_rate;
        u_sum += stage.weight * u_rate;
        for (std::size_t b = 0; b < bodies.size(); ++b) {
            const Screw v = screw(bodies[b].getBodyVelocity(now));
            passed[b] += h * stage.weight * v;
            work[b] += h * stage.weight * forceOf(loads[b], v).dot(v);
        }
    }
    now.setTime(t + h);
    now.updQ() = q + h * q_sum;
    now.updU() = u + h * u_sum;
    project();
}

Mechanism::Mechanism(MechanismDescription description, double time,
                     const std::vector<double>& state)
    : simbody_(std::make_unique<Simbody>(std::move(description))) {
    const auto unmet = [] {
        return MechanismError("no places of its joints meet the constraints");
    };
    try {
        simbody_->build();
        if (state.empty())
            simbody_->start(time);
        else
            simbody_->goOn(time, state);
    } catch (const SimTK::Exception::Base& e) {
        if (simbody_->constrained) throw unmet();
        throw MechanismError(firstLine(e.getMessageText()));
    }
    // Lengths and angles, both of the size of one in case units of a sensible case.
    if (state.empty() && !(constraintError() < 1e-6)) throw unmet();
}
Mechanism::~Mechanism() = default;

const MechanismDescription& Mechanism::description() const { return simbody_->description; }

std::vector<double> Mechanism::state() const {
    const SimTK::State& s = simbody_->now;
    std::vector<double> values;
    for (int k = 0; k < s.getNQ(); ++k) values.push_back(s.getQ()[k]);
    for (int k = 0; k < s.getNU(); ++k) values.push_back(s.getU()[k]);
    return values;
}

void Mechanism::step(double time, double dt, const std::vector<BodyLoad>& loads) {
    Simbody& s = *simbody_;
    s.loads = loads;
    // The answer is damping: with this bound the method is far from its limit of 2.8. A joint or a
    // constraint only makes bodies heavier.
    double fastest = 0;
    for (std::size_t b = 0; b < loads.size(); ++b) {
        const RigidBody& body = s.description.bodies[b];
        const double push = loads[b].impedance.topLeftCorner<3, 3>().trace() / body.mass;
        const double turn = loads[b].impedance.bottomRightCorner<3, 3>().trace() /
                            std::max(body.inertia.diagonal().minCoeff(), 1e-300);
        fastest = std::max({fastest, push, turn});
    }
    const double largest = s.description.largest_step;
    const double wanted = std::max(largest > 0 ? dt / largest : 1.0, 2 * dt * fastest);
    const int steps = std::clamp(static_cast<int>(std::ceil(wanted * (1 - 1e-12))), 1, 100'000);
    for (Screw& way : s.passed) way.setZero();
    s.last_step = dt;
    try {
        s.now.setTime(time);
        for (int n = 0; n < steps; ++n) s.advance(dt / steps);
        s.now.setTime(time + dt);
        s.realize();
        for (const double value : state())
            if (!std::isfinite(value))
                throw MechanismError("its coordinates are no numbers any more");
    } catch (const SimTK::Exception::Base& e) {
        throw MechanismError(firstLine(e.getMessageText()));
    }
}

Received Mechanism::received(int body) const {
    const Simbody& s = *simbody_;
    const std::size_t b = Simbody::index(body);
    if (s.last_step == 0) return {};
    const BodyLoad& load = s.loads[b];
    Received mean;
    mean.total = forceOf(load, s.passed[b] / s.last_step);
    mean.viscous = load.viscous;
    mean.material = load.material;
    mean.contact = load.contact;
    mean.pressure = mean.total - load.viscous - load.material - load.contact;
    return mean;
}

const std::vector<double>& Mechanism::work() const { return simbody_->work; }

void Mechanism::setWork(const std::vector<double>& work) {
    if (work.size() != simbody_->work.size())
        throw MechanismError("the state is that of another mechanism");
    simbody_->work = work;
}

BodyMotion Mechanism::motion(int body) const {
    const Simbody& s = *simbody_;
    const SimTK::MobilizedBody& b = s.bodies[Simbody::index(body)];
    BodyMotion motion;
    motion.rotation = eigen(b.getBodyRotation(s.now));
    motion.center = eigen(b.getBodyOriginLocation(s.now));
    motion.velocity = screw(b.getBodyVelocity(s.now));
    motion.acceleration = screw(b.getBodyAcceleration(s.now));
    motion.passed = s.passed[Simbody::index(body)];
    return motion;
}

Mechanism::Kinematics Mechanism::coordinate(int joint, int coordinate) const {
    const Simbody& s = *simbody_;
    const Joint& j = s.description.joints[Simbody::index(joint)];
    const SimTK::MobilizedBody& b = s.bodies[Simbody::index(j.child)];
    return {b.getOneQ(s.now, coordinate), b.getOneU(s.now, coordinate)};
}

JointReaction Mechanism::reaction(int joint) const {
    const Simbody& s = *simbody_;
    const Joint& j = s.description.joints[Simbody::index(joint)];
    const SimTK::MobilizedBody& b = s.bodies[Simbody::index(j.child)];
    const SimTK::SpatialVec f = b.findMobilizerReactionOnBodyAtMInGround(s.now);
    return {eigen(b.findStationLocationInGround(s.now, b.getOutboardFrame(s.now).p())), eigen(f[1]),
            eigen(f[0])};
}

std::vector<double> Mechanism::force(int number) const {
    return simbody_->elements[Simbody::index(number)]->values(simbody_->now);
}

MechanismEnergy Mechanism::energy() const {
    const Simbody& s = *simbody_;
    MechanismEnergy energy;
    energy.kinetic = s.system.calcKineticEnergy(s.now);
    for (std::size_t b = 0; b < s.bodies.size(); ++b)
        energy.gravity -=
            s.description.bodies[b].mass *
            s.description.gravity.dot(eigen(s.bodies[b].getBodyOriginLocation(s.now)));
    energy.springs = s.system.calcPotentialEnergy(s.now) - energy.gravity;
    return energy;
}

double Mechanism::constraintError() const {
    const SimTK::Vector& errors = simbody_->now.getQErr();
    double largest = 0;
    for (int k = 0; k < errors.size(); ++k) largest = std::max(largest, std::abs(errors[k]));
    return largest;
}

}  // namespace sphinx::dynamics::multibody
