// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/multibody/elements.h"

#include "dynamics/multibody/catenary.h"

#include <algorithm>
#include <cmath>

namespace sphinx::dynamics::multibody {
namespace {

using State = SimTK::State;
using Forces = SimTK::Vector_<SimTK::SpatialVec>;
using Unused = SimTK::Vector_<SimTK::Vec3>;

class Motor final : public SimTK::Force::Custom::Implementation {
 public:
    Motor(const SimTK::MobilizedBody& body, int coordinate, FunctionOfTime value)
        : body_(body), coordinate_(coordinate), value_(std::move(value)) {}
    void calcForce(const State& state, Forces&, Unused&, SimTK::Vector& mobility) const override {
        body_.applyOneMobilityForce(state, SimTK::MobilizerUIndex(coordinate_),
                                    value_(state.getTime()), mobility);
    }
    SimTK::Real calcPotentialEnergy(const State&) const override { return 0; }

 private:
    SimTK::MobilizedBody body_;
    int coordinate_;
    FunctionOfTime value_;
};

/// A spring and damper between two points, or a rope, which bears no compression.
class PointSpringForce final : public Element {
 public:
    PointSpringForce(const PointSpring& spring, const Station& from, const Station& to)
        : p_(spring), from_(from), to_(to) {}
    void calcForce(const State& state, Forces& bodies, Unused&, SimTK::Vector&) const override {
        const Stretch s = stretch(state);
        if (s.tension == 0) return;
        from_.push(state, s.tension * s.e, bodies);
        to_.push(state, -s.tension * s.e, bodies);
    }
    SimTK::Real calcPotentialEnergy(const State& state) const override {
        const double longer = stretch(state).length - p_.rest_length;
        return p_.tension_only && longer <= 0 ? 0 : 0.5 * p_.stiffness * longer * longer;
    }
    std::vector<double> values(const State& state) const override {
        const Stretch s = stretch(state);
        return {s.length, s.rate, s.tension};
    }

 private:
    struct Stretch {
        double length, rate = 0, tension = 0;
        SimTK::Vec3 e;
    };
    Stretch stretch(const State& state) const {
        const SimTK::Vec3 way = to_.place(state) - from_.place(state);
        Stretch s;
        s.length = way.norm();
        if (s.length == 0) return s;
        s.e = way / s.length;
        // The energy is asked for where only places are known.
        if (state.getSystemStage() >= SimTK::Stage::Velocity)
            s.rate = SimTK::dot(to_.velocity(state) - from_.velocity(state), s.e);
        if (p_.tension_only && s.length <= p_.rest_length) return s;
        s.tension = p_.stiffness * (s.length - p_.rest_length) + p_.damping * s.rate;
        if (p_.tension_only) s.tension = std::max(s.tension, 0.0);
        return s;
    }

    PointSpring p_;
    Station from_, to_;
};

/// Force at a point and moment, as functions of time.
class GivenForceElement final : public Element {
 public:
    GivenForceElement(GivenForce given, const Station& at) : given_(std::move(given)), at_(at) {}
    void calcForce(const State& state, Forces& bodies, Unused&, SimTK::Vector&) const override {
        const double t = state.getTime();
        if (!given_.force.empty()) at_.push(state, value(given_.force, t), bodies);
        if (!given_.moment.empty())
            at_.body.applyBodyTorque(state, value(given_.moment, t), bodies);
    }
    SimTK::Real calcPotentialEnergy(const State&) const override { return 0; }
    std::vector<double> values(const State& state) const override {
        std::vector<double> all;
        for (const auto* f : {&given_.force, &given_.moment}) {
            const SimTK::Vec3 v = f->empty() ? SimTK::Vec3(0) : value(*f, state.getTime());
            all.insert(all.end(), {v[0], v[1], v[2]});
        }
        return all;
    }

 private:
    static SimTK::Vec3 value(const std::vector<FunctionOfTime>& f, double t) {
        return {f[0](t), f[1](t), f[2](t)};
    }

    GivenForce given_;
    Station at_;
};

class CatenaryElement final : public Element {
 public:
    CatenaryElement(const CatenaryLine& line, const Vector& up, const Station& from,
                    const Station& to)
        : line_(line), up_(simtk(up)), from_(from), to_(to) {}
    bool dependsOnlyOnPositions() const override { return true; }
    void calcForce(const State& state, Forces& bodies, Unused&, SimTK::Vector&) const override {
        SimTK::Vec3 level;
        const CatenaryShape s = shape(state, level);
        from_.push(state, s.across * level + s.lower * up_, bodies);
        to_.push(state, -s.across * level - s.upper * up_, bodies);
    }
    SimTK::Real calcPotentialEnergy(const State& state) const override {
        SimTK::Vec3 level;
        // The weight of the line, too, is where its anchor is.
        return shape(state, level).energy +
               line_.weight * line_.length * SimTK::dot(from_.place(state), up_);
    }
    std::vector<double> values(const State& state) const override {
        SimTK::Vec3 level;
        const CatenaryShape s = shape(state, level);
        return {std::hypot(s.across, s.upper), std::hypot(s.across, s.lower), s.across, s.resting};
    }

 private:
    CatenaryShape shape(const State& state, SimTK::Vec3& level) const {
        const SimTK::Vec3 way = to_.place(state) - from_.place(state);
        const double height = SimTK::dot(way, up_);
        level = way - height * up_;
        const double across = level.norm();
        if (across > 0) level /= across;
        return hang(line_, across, height);
    }

    CatenaryLine line_;
    SimTK::Vec3 up_;
    Station from_, to_;
};

class ParticleLoads final : public SimTK::Force::Custom::Implementation {
 public:
    ParticleLoads(const std::vector<SimTK::MobilizedBody>& bodies,
                  const std::vector<BodyLoad>& loads)
        : bodies_(bodies), loads_(loads) {}
    void calcForce(const State& state, Forces& forces, Unused&, SimTK::Vector&) const override {
        for (std::size_t b = 0; b < loads_.size(); ++b)
            forces[bodies_[b].getMobilizedBodyIndex()] +=
                spatial(forceOf(loads_[b], screw(bodies_[b].getBodyVelocity(state))));
    }
    SimTK::Real calcPotentialEnergy(const State&) const override { return 0; }

 private:
    const std::vector<SimTK::MobilizedBody>& bodies_;
    const std::vector<BodyLoad>& loads_;
};

class GivenMotion final : public SimTK::Motion::Custom::Implementation {
 public:
    GivenMotion(std::vector<FunctionOfTime> values, const TimeSpan& span)
        : values_(std::move(values)), span_(span) {}
    SimTK::Motion::Level getLevel(const State&) const override { return SimTK::Motion::Position; }
    void calcPrescribedPosition(const State& s, int, SimTK::Real* q) const override {
        for (const FunctionOfTime& value : values_) *q++ = value(s.getTime());
    }
    void calcPrescribedPositionDot(const State& s, int, SimTK::Real* rate) const override {
        for (const FunctionOfTime& value : values_)
            *rate++ = span_.derivatives(value, s.getTime()).first;
    }
    void calcPrescribedPositionDotDot(const State& s, int, SimTK::Real* second) const override {
        for (const FunctionOfTime& value : values_)
            *second++ = span_.derivatives(value, s.getTime()).second;
    }

 private:
    std::vector<FunctionOfTime> values_;
    const TimeSpan& span_;
};

class GivenCoordinate final : public SimTK::Function {
 public:
    GivenCoordinate(FunctionOfTime value, const TimeSpan& span)
        : value_(std::move(value)), span_(span) {}
    SimTK::Real calcValue(const SimTK::Vector& t) const override { return value_(t[0]); }
    SimTK::Real calcDerivative(const SimTK::Array_<int>& order,
                               const SimTK::Vector& t) const override {
        const TimeSpan::Derivatives d = span_.derivatives(value_, t[0]);
        return order.size() == 1 ? d.first : d.second;
    }
    int getArgumentSize() const override { return 1; }
    int getMaxDerivativeOrder() const override { return 2; }

 private:
    FunctionOfTime value_;
    const TimeSpan& span_;
};

}  // namespace

Screw forceOf(const BodyLoad& load, const Screw& velocity) {
    return load.force() + load.answered - load.impedance * velocity;
}

Element* makeElement(const PointSpring& spring, const Station& from, const Station& to) {
    return new PointSpringForce(spring, from, to);
}
Element* makeElement(const GivenForce& given, const Station& at) {
    return new GivenForceElement(given, at);
}
Element* makeElement(const CatenaryLine& line, const Vector& up, const Station& from,
                     const Station& to) {
    return new CatenaryElement(line, up, from, to);
}
SimTK::Force::Custom::Implementation* makeMotor(const SimTK::MobilizedBody& body, int coordinate,
                                                FunctionOfTime value) {
    return new Motor(body, coordinate, std::move(value));
}
SimTK::Force::Custom::Implementation* makeParticleLoads(
    const std::vector<SimTK::MobilizedBody>& bodies, const std::vector<BodyLoad>& loads) {
    return new ParticleLoads(bodies, loads);
}
SimTK::Motion::Custom::Implementation* makeMotion(std::vector<FunctionOfTime> values,
                                                  const TimeSpan& span) {
    return new GivenMotion(std::move(values), span);
}
SimTK::Function* makeMotion(FunctionOfTime value, const TimeSpan& span) {
    return new GivenCoordinate(std::move(value), span);
}

}  // namespace sphinx::dynamics::multibody
