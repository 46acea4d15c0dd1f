// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "measure/multibody.h"

#include "dynamics/multibody/step.h"
#include "io/series/columns.h"
#include "io/series/rows_output.h"
#include "measure/reduce.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace sphinx::measure {
namespace {

using dynamics::multibody::Mechanism;
using dynamics::multibody::MechanismOwner;
using dynamics::multibody::Vector;
using Row = std::span<double>;

struct MultibodyOutputParameters : io::MeanParameters {
    input::Name body;
    input::Name joint;
};

template <int Dim>
const MechanismOwner& ownerOf(const input::Component& component,
                              const io::OutputContext<Dim>& context) {
    for (const dynamics::Method* method : context.methods)
        if (const auto* owner = dynamic_cast<const MechanismOwner*>(method)) return *owner;
    io::failAt(component.place, "no line of the loop calls a multibody.step");
}

template <class Entries, class NameOf>
int numberOf(const Entries& entries, const std::string& name, NameOf&& nameOf) {
    return static_cast<int>(std::ranges::find(entries, name, nameOf) - entries.begin());
}

/// Writes what a case of Dim dimensions has of a vector, or of an axial one.
template <int Dim>
double* put(double* at, const Vector& v) {
    return std::copy_n(v.data(), Dim, at);
}
template <int Dim>
double* putAxial(double* at, const Vector& v) {
    return Dim == 2 ? std::copy_n(v.data() + 2, 1, at) : std::copy_n(v.data(), 3, at);
}

template <int Dim>
std::unique_ptr<io::SeriesSource> bodySource(const MechanismOwner& owner, const std::string& name,
                                             const input::UnitSystem& units) {
    const int body = numberOf(owner.parameters().bodies, name,
                              [](const auto& entry) { return entry.first.text; });
    const auto vector = io::componentLabels<Dim>(particles::Rank::vector);
    const auto axial = io::momentLabels<Dim>();
    std::vector<io::SeriesQuantity> quantities{
        {"center", units.text(unit::length), "centre of mass", vector}};
    if (Dim == 2)
        quantities.push_back({"angle", "", "by which it has turned, from -pi to pi", {}});
    else
        quantities.push_back(
            {"rotation", "", "quaternion of the turn from the drawing", {"w", "x", "y", "z"}});
    quantities.push_back({"velocity", units.text(unit::velocity), "of the centre", vector});
    quantities.push_back(
        {"angular_velocity", units.text(unit::frequency), "angular velocity", axial});
    quantities.push_back({"particle_force", units.text(unit::force),
                          "of fluids and elastic material on its particles, mean over its last "
                          "step",
                          vector});
    quantities.push_back({"particle_moment", units.text(unit::energy),
                          "moment of this force about the centre", axial});
    quantities.push_back(
        {"particle_work", units.text(unit::energy), "work of both since the start", {}});
    return std::make_unique<ReduceSource>(std::move(quantities), [&owner, body](Row row) {
        const Mechanism& mechanism = *owner.mechanism();
        const auto motion = mechanism.motion(body);
        const auto received = mechanism.received(body);
        double* at = put<Dim>(row.data(), motion.center);
        if (Dim == 2) {
            *at++ = std::atan2(motion.rotation(1, 0), motion.rotation(0, 0));
        } else {
            const Eigen::Quaterniond q(motion.rotation);
            for (const double c : {q.w(), q.x(), q.y(), q.z()}) *at++ = c;
        }
        at = put<Dim>(at, motion.velocity.head<3>());
        at = putAxial<Dim>(at, motion.velocity.tail<3>());
        at = put<Dim>(at, received.head<3>());
        at = putAxial<Dim>(at, received.tail<3>());
        *at = mechanism.work()[static_cast<std::size_t>(body)];
    });
}

template <int Dim>
std::unique_ptr<io::SeriesSource> jointSource(const MechanismOwner& owner, const input::Name& name,
                                              const input::UnitSystem& units) {
    const auto& joints = owner.parameters().joints;
    const int joint = numberOf(joints, name.text, &input::Component::name);
    const auto kind = joints[static_cast<std::size_t>(joint)]
                          .declaration->builder<dynamics::multibody::JointKind>();
    const int count = dynamics::multibody::coordinateCount(kind);
    std::vector<io::SeriesQuantity> quantities;
    if (count > 0) {
        std::vector<std::string> labels;
        for (int k = 0; count > 1 && k < count; ++k) labels.push_back(std::to_string(k + 1));
        const std::string doc = "of the joint, case units and radian";
        quantities.push_back({"coordinate", "", "coordinates " + doc, labels});
        quantities.push_back({"rate", "", "rates " + doc, labels});
    }
    quantities.push_back({"reaction", units.text(unit::force), "force of the parent on the child",
                          io::componentLabels<Dim>(particles::Rank::vector)});
    quantities.push_back({"reaction_moment", units.text(unit::energy),
                          "moment of the parent on the child about the joint",
                          io::momentLabels<Dim>()});
    return std::make_unique<ReduceSource>(std::move(quantities), [&owner, joint, count](Row row) {
        const Mechanism& mechanism = *owner.mechanism();
        double* at = row.data();
        for (int k = 0; k < count; ++k) *at++ = mechanism.coordinate(joint, k).value;
        for (int k = 0; k < count; ++k) *at++ = mechanism.coordinate(joint, k).rate;
        const auto reaction = mechanism.reaction(joint);
        at = put<Dim>(at, reaction.force);
        putAxial<Dim>(at, reaction.moment);
    });
}

std::unique_ptr<io::SeriesSource> energySource(const MechanismOwner& owner,
                                               const input::UnitSystem& units) {
    const std::string unit = units.text(unit::energy);
    std::vector<io::SeriesQuantity> quantities{{"kinetic", unit, "of all bodies", {}},
                                               {"potential", unit, "-sum m g . x", {}},
                                               {"springs", unit, "of springs, ropes and stops", {}},
                                               {"total", unit, "their sum", {}}};
    return std::make_unique<ReduceSource>(std::move(quantities), [&owner](Row row) {
        const auto energy = owner.mechanism()->energy();
        row[0] = energy.kinetic;
        row[1] = energy.gravity;
        row[2] = energy.springs;
        row[3] = energy.kinetic + energy.gravity + energy.springs;
    });
}

}  // namespace

void declareMultibody(input::Registry& registry) {
    using P = MultibodyOutputParameters;
    auto& d = registry.declare<P>(input::Kind::output, "multibody");
    d.summary("Time series of a rigid body, of a joint, or of the energy of the mechanism");
    d.optional("body", &P::body, input::rigidBodyReference(),
               "its place, turn, velocities, and what its particles get");
    d.optional("joint", &P::joint, input::jointReference(),
               "its coordinates, their rates and its reaction; without body and joint: the energy "
               "of the whole mechanism");
    io::declareMeans(d);
    d.check("joint", [](const P& p) -> std::string {
        return p.body.empty() || p.joint.empty() ? "" : "give body or joint, not both";
    });
    d.builder(io::outputFactory<P>([]<int Dim>(const P& p, const input::Component& component,
                                               const io::OutputContext<Dim>& context) {
        const MechanismOwner& owner = ownerOf(component, context);
        auto source = !p.body.empty()    ? bodySource<Dim>(owner, p.body.text, context.units)
                      : !p.joint.empty() ? jointSource<Dim>(owner, p.joint, context.units)
                                         : energySource(owner, context.units);
        const std::string form = p.body.text + p.joint.text;
        return io::makeRowsOutput(component, context, {p, form}, std::move(source));
    }));
}

}  // namespace sphinx::measure
