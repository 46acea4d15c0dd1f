// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0

// Simbody 3.7 is no C++20: its headers compare numbers of different types that C++20 finds
// ambiguous. engine/CMakeLists.txt compiles this file as C++17.

#include "dynamics/multibody/mechanism.h"

#include <SimTKsimbody.h>

#include <algorithm>
#include <cmath>

namespace sphinx::dynamics::multibody {
namespace {

SimTK::Vec3 simtk(const Vector& a) { return {a[0], a[1], a[2]}; }
Vector eigen(const SimTK::Vec3& a) { return {a[0], a[1], a[2]}; }
Matrix eigen(const SimTK::Rotation& R) {
    Matrix m;
    m << R.x()[0], R.y()[0], R.z()[0], R.x()[1], R.y()[1], R.z()[1], R.x()[2], R.y()[2], R.z()[2];
    return m;
}
SimTK::Rotation rotation(const Matrix& m) {
    return SimTK::Rotation(SimTK::Mat33(m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2),
                                        m(2, 0), m(2, 1), m(2, 2)),
                           true);
}
SimTK::Rotation turned(const Vector& turn) {
    const double angle = turn.norm();
    if (angle == 0) return {};
    return {angle, SimTK::UnitVec3(simtk(turn / angle))};
}
/// Simbody's pairs have the turning part first.
SimTK::SpatialVec spatial(const Vector& moment, const Vector& force) {
    return {simtk(moment), simtk(force)};
}

std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

/// Force or moment on a coordinate as a function of time.
class Motor final : public SimTK::Force::Custom::Implementation {
 public:
    Motor(const SimTK::MobilizedBody& body, int coordinate, FunctionOfTime value)
        : body_(body), coordinate_(coordinate), value_(std::move(value)) {}
    void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>&,
                   SimTK::Vector_<SimTK::Vec3>&, SimTK::Vector& mobility) const override {
        body_.applyOneMobilityForce(state, SimTK::MobilizerUIndex(coordinate_),
                                    value_(state.getTime()), mobility);
    }
    SimTK::Real calcPotentialEnergy(const SimTK::State&) const override { return 0; }

 private:
    SimTK::MobilizedBody body_;
    int coordinate_;
    FunctionOfTime value_;
};

/// A spring and damper between two points, or a rope, which bears no compression.
class PointSpringForce final : public SimTK::Force::Custom::Implementation {
 public:
    PointSpringForce(const SimTK::MobilizedBody& from, const SimTK::Vec3& from_station,
                     const SimTK::MobilizedBody& to, const SimTK::Vec3& to_station,
                     const PointSpring& spring)
        : from_(from), to_(to), from_station_(from_station), to_station_(to_station), p_(spring) {}
    void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& bodies,
                   SimTK::Vector_<SimTK::Vec3>&, SimTK::Vector&) const override {
        const SimTK::Vec3 way = to_.findStationLocationInGround(state, to_station_) -
                                from_.findStationLocationInGround(state, from_station_);
        const double length = way.norm();
        if (length == 0) return;
        const SimTK::Vec3 e = way / length;
        const double rate = SimTK::dot(to_.findStationVelocityInGround(state, to_station_) -
                                           from_.findStationVelocityInGround(state, from_station_),
                                       e);
        if (p_.tension_only && length <= p_.rest_length) return;
        double tension = p_.stiffness * (length - p_.rest_length) + p_.damping * rate;
        if (p_.tension_only) tension = std::max(tension, 0.0);
        from_.applyForceToBodyPoint(state, from_station_, tension * e, bodies);
        to_.applyForceToBodyPoint(state, to_station_, -tension * e, bodies);
    }
    SimTK::Real calcPotentialEnergy(const SimTK::State& state) const override {
        const double stretch = (to_.findStationLocationInGround(state, to_station_) -
                                from_.findStationLocationInGround(state, from_station_))
                                   .norm() -
                               p_.rest_length;
        return p_.tension_only && stretch <= 0 ? 0 : 0.5 * p_.stiffness * stretch * stretch;
    }

 private:
    SimTK::MobilizedBody from_, to_;
    SimTK::Vec3 from_station_, to_station_;
    PointSpring p_;
};

/// Force at a point and moment, as functions of time.
class GivenForce final : public SimTK::Force::Custom::Implementation {
 public:
    GivenForce(const SimTK::MobilizedBody& body, const SimTK::Vec3& station, BodyForce given)
        : body_(body), station_(station), given_(std::move(given)) {}
    void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& bodies,
                   SimTK::Vector_<SimTK::Vec3>&, SimTK::Vector&) const override {
        const double t = state.getTime();
        const auto at = [t](const std::vector<FunctionOfTime>& f) {
            return SimTK::Vec3(f[0](t), f[1](t), f[2](t));
        };
        if (!given_.force.empty())
            body_.applyForceToBodyPoint(state, station_, at(given_.force), bodies);
        if (!given_.moment.empty()) body_.applyBodyTorque(state, at(given_.moment), bodies);
    }
    SimTK::Real calcPotentialEnergy(const SimTK::State&) const override { return 0; }

 private:
    SimTK::MobilizedBody body_;
    SimTK::Vec3 station_;
    BodyForce given_;
};

Screw forceOf(const BodyLoad& load, const Screw& v) {
    return load.force + load.answered - load.impedance * v;
}

/// What particles do to the bodies in a step.
class ParticleLoads final : public SimTK::Force::Custom::Implementation {
 public:
    ParticleLoads(const std::vector<SimTK::MobilizedBody>& bodies,
                  const std::vector<BodyLoad>& loads)
        : bodies_(bodies), loads_(loads) {}
    bool dependsOnlyOnPositions() const override { return false; }
    void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& forces,
                   SimTK::Vector_<SimTK::Vec3>&, SimTK::Vector&) const override {
        for (std::size_t b = 0; b < loads_.size(); ++b) {
            const SimTK::SpatialVec V = bodies_[b].getBodyVelocity(state);
            Screw v;
            v << eigen(V[1]), eigen(V[0]);
            const Screw f = forceOf(loads_[b], v);
            forces[bodies_[b].getMobilizedBodyIndex()] += spatial(f.tail<3>(), f.head<3>());
        }
    }
    SimTK::Real calcPotentialEnergy(const SimTK::State&) const override { return 0; }

 private:
    const std::vector<SimTK::MobilizedBody>& bodies_;
    const std::vector<BodyLoad>& loads_;
};

/// A coordinate as a function of time. Its derivatives are central differences over a fraction of
/// the step: exact for parabolas, and to 1e-8 of the function's own for what a step resolves.
class GivenMotion final : public SimTK::Motion::Custom::Implementation {
 public:
    GivenMotion(FunctionOfTime value, double interval)
        : value_(std::move(value)), interval_(interval) {}
    SimTK::Motion::Level getLevel(const SimTK::State&) const override {
        return SimTK::Motion::Position;
    }
    void calcPrescribedPosition(const SimTK::State& s, int, SimTK::Real* q) const override {
        q[0] = value_(s.getTime());
    }
    void calcPrescribedPositionDot(const SimTK::State& s, int, SimTK::Real* rate) const override {
        const double t = s.getTime(), d = interval_;
        rate[0] = (value_(t + d) - value_(t - d)) / (2 * d);
    }
    void calcPrescribedPositionDotDot(const SimTK::State& s, int,
                                      SimTK::Real* acceleration) const override {
        const double t = s.getTime(), d = interval_;
        acceleration[0] = (value_(t + d) - 2 * value_(t) + value_(t - d)) / (d * d);
    }

 private:
    FunctionOfTime value_;
    double interval_;
};

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

struct Mechanism::Simbody {
    MechanismDescription description;
    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter{system};
    SimTK::GeneralForceSubsystem forces{system};
    SimTK::Force::UniformGravity gravity{forces, matter, simtk(description.gravity)};
    std::vector<SimTK::MobilizedBody> bodies;  // in the order of the description
    std::vector<BodyLoad> loads;
    std::vector<Screw> passed;
    std::vector<double> work;
    SimTK::State now;
    double last_step = 0;
    bool constrained = false;
    bool prescribed = false;

    explicit Simbody(MechanismDescription d) : description(std::move(d)) {}

    /// Place of a point of the drawing in the frame of its body: there centres of mass are origins.
    SimTK::Vec3 station(const BodyPoint& p) const {
        return simtk(p.body == ground ? p.at
                                      : Vector(p.at - description.bodies[index(p.body)].center));
    }
    SimTK::MobilizedBody& mobilized(int body) {
        return body == ground ? matter.updGround() : bodies[index(body)];
    }
    static std::size_t index(int body) { return static_cast<std::size_t>(body); }

    void build(double time);
    void addBody(const Joint& joint);
    SimTK::MobilizedBody makeMobilizer(const Joint& joint, SimTK::MobilizedBody& parent,
                                       const SimTK::Transform& on_parent, const SimTK::Body& child,
                                       const SimTK::Transform& on_child);
    void addCoordinateForces(const Joint& joint);
    void setStart(const Joint& joint);
    void addConstraints();
    /// Onto constraints and prescribed motions, and unit quaternions.
    void project();
    void advance(double dt);
    void realize();
    double interval() const {
        return description.largest_step > 0 ? 0.25 * description.largest_step : 1e-4;
    }
};

void Mechanism::Simbody::addBody(const Joint& joint) {
    const RigidBody& b = description.bodies[index(joint.child)];
    const Matrix& I = b.inertia;
    const SimTK::Body::Rigid child(SimTK::MassProperties(
        b.mass, SimTK::Vec3(0),
        SimTK::Inertia(I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2))));
    const SimTK::Rotation frame = rotation(joint.frame);
    bodies[index(joint.child)] = makeMobilizer(
        joint, mobilized(joint.parent), {frame, station({joint.parent, joint.at_parent})}, child,
        {frame, station({joint.child, joint.at_child})});
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
        if (c.motor) SimTK::Force::Custom(forces, new Motor(body, static_cast<int>(k), c.motor));
        if (c.motion) {
            SimTK::Motion::Custom(body, new GivenMotion(c.motion, interval()));
            prescribed = true;
        }
    }
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
        Constraint::Rod(mobilized(rod.from.body), station(rod.from), mobilized(rod.to.body),
                        station(rod.to), rod.length);
    for (const CoincidentPoints& c : description.coincident_points)
        Constraint::Ball(mobilized(c.from.body), station(c.from), mobilized(c.to.body),
                         station(c.to));
    for (const PointOnLine& c : description.points_on_lines)
        Constraint::PointOnLine(mobilized(c.line.body), SimTK::UnitVec3(simtk(c.along)),
                                station(c.line), mobilized(c.point.body), station(c.point));
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
    constrained = !description.rods.empty() || !description.coincident_points.empty() ||
                  !description.points_on_lines.empty() || !description.couplers.empty();
}

void Mechanism::Simbody::build(double time) {
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
    for (const Joint& joint : description.joints) addCoordinateForces(joint);
    for (const PointSpring& s : description.springs)
        SimTK::Force::Custom(forces, new PointSpringForce(mobilized(s.from.body), station(s.from),
                                                          mobilized(s.to.body), station(s.to), s));
    for (const BodyForce& f : description.forces)
        SimTK::Force::Custom(forces, new GivenForce(mobilized(f.at.body), station(f.at), f));
    SimTK::Force::Custom(forces, new ParticleLoads(bodies, loads));
    addConstraints();
    system.realizeTopology();
    now = system.getDefaultState();
    now.setTime(time);
    for (const Joint& joint : description.joints) setStart(joint);
    system.realize(now, SimTK::Stage::Instance);
    project();
    realize();
}

void Mechanism::Simbody::project() {
    if (prescribed) {
        system.realize(now, SimTK::Stage::Time);
        system.prescribeQ(now);
        system.realize(now, SimTK::Stage::Position);
        system.prescribeU(now);
    }
    system.realize(now, SimTK::Stage::Velocity);
    system.project(now, 1e-10);
}

void Mechanism::Simbody::realize() { system.realize(now, SimTK::Stage::Acceleration); }

void Mechanism::Simbody::advance(double h) {
    static constexpr double place[] = {0, 0.5, 0.5, 1};
    static constexpr double weight[] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
    const double t = now.getTime();
    const SimTK::Vector q = now.getQ();
    const SimTK::Vector u = now.getU();
    SimTK::Vector q_rate, u_rate;
    SimTK::Vector q_sum(q.size(), 0.0), u_sum(u.size(), 0.0);
    for (int stage = 0; stage < 4; ++stage) {
        if (stage > 0) {
            now.setTime(t + place[stage] * h);
            now.updQ() = q + (place[stage] * h) * q_rate;
            now.updU() = u + (place[stage] * h) * u_rate;
            if (prescribed) {
                system.realize(now, SimTK::Stage::Time);
                system.prescribeQ(now);
                system.realize(now, SimTK::Stage::Position);
                system.prescribeU(now);
            }
        }
        realize();
        q_rate = now.getQDot();
        u_rate = now.getUDot();
        q_sum += weight[stage] * q_rate;
        u_sum += weight[stage] * u_rate;
        for (std::size_t b = 0; b < bodies.size(); ++b) {
            const SimTK::SpatialVec V = bodies[b].getBodyVelocity(now);
            Screw v;
            v << eigen(V[1]), eigen(V[0]);
            passed[b] += h * weight[stage] * v;
            work[b] += h * weight[stage] * forceOf(loads[b], v).dot(v);
        }
    }
    now.setTime(t + h);
    now.updQ() = q + h * q_sum;
    now.updU() = u + h * u_sum;
    project();
}

Mechanism::Mechanism(MechanismDescription description, double time)
    : simbody_(std::make_unique<Simbody>(std::move(description))) {
    const auto unmet = [] {
        return MechanismError("no places of its joints meet the constraints");
    };
    try {
        simbody_->build(time);
    } catch (const SimTK::Exception::Base& e) {
        if (simbody_->constrained) throw unmet();
        throw MechanismError(firstLine(e.getMessageText()));
    }
    // Lengths and angles, both of the size of one in case units of a sensible case.
    if (!(constraintError() < 1e-6)) throw unmet();
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

void Mechanism::setState(double time, const std::vector<double>& state) {
    SimTK::State& s = simbody_->now;
    if (static_cast<int>(state.size()) != s.getNQ() + s.getNU())
        throw MechanismError("the state is that of another mechanism");
    s.setTime(time);
    for (int k = 0; k < s.getNQ(); ++k) s.updQ()[k] = state[static_cast<std::size_t>(k)];
    for (int k = 0; k < s.getNU(); ++k)
        s.updU()[k] = state[static_cast<std::size_t>(s.getNQ() + k)];
    simbody_->realize();
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
    } catch (const SimTK::Exception::Base& e) {
        throw MechanismError(firstLine(e.getMessageText()));
    }
}

Screw Mechanism::received(int body) const {
    const Simbody& s = *simbody_;
    if (s.last_step == 0) return Screw::Zero();
    return forceOf(s.loads[Simbody::index(body)], s.passed[Simbody::index(body)] / s.last_step);
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
    const SimTK::SpatialVec V = b.getBodyVelocity(s.now);
    motion.velocity << eigen(V[1]), eigen(V[0]);
    const SimTK::SpatialVec A = b.getBodyAcceleration(s.now);
    motion.acceleration << eigen(A[1]), eigen(A[0]);
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
