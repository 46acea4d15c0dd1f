// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0

// Simbody 3.7 is no C++20: its headers compare numbers of different types that C++20 finds
// ambiguous. engine/CMakeLists.txt compiles this file as C++17.

#include "dynamics/multibody/mechanism.h"

#include "dynamics/multibody/elements.h"

#include <algorithm>
#include <cmath>

namespace sphinx::dynamics::multibody {
namespace {

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

std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

/// A Runge-Kutta method each of whose stages needs only the one before: where in the step it is,
/// and how much it counts.
struct Stage {
    double place, weight;
};
std::vector<Stage> stagesOf(Integrator integrator) {
    if (integrator == Integrator::midpoint) return {{0, 0}, {0.5, 1}};
    return {{0, 1.0 / 6}, {0.5, 1.0 / 3}, {0.5, 1.0 / 3}, {1, 1.0 / 6}};
}

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
    std::vector<Element*> elements;            // likewise; Simbody owns them
    std::vector<BodyLoad> loads;
    std::vector<Screw> passed;
    std::vector<double> work;
    SimTK::State now;
    double last_step = 0;
    bool constrained = false;
    bool prescribed = false;
    TimeSpan span;  ///< the present step
    std::vector<Stage> stages = stagesOf(description.integrator);

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
    mean.pressure = mean.total - load.viscous - load.material;
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
