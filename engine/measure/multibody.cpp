// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "measure/multibody.h"

#include "dynamics/multibody/components.h"
#include "dynamics/multibody/step.h"
#include "io/series/columns.h"
#include "io/series/rows_output.h"
#include "measure/reduce.h"

#include <fmt/format.h>
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
    input::Name force;
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
    const std::pair<const char*, const char*> sources[] = {
        {"particle",
         "of fluids, elastic material and other surfaces on its particles, mean over its last "
         "step"},
        {"pressure", "its part from the pressure of fluids"},
        {"viscous", "its part from the viscosity of fluids"},
        {"material", "its part from elastic material, and from methods that push that"},
        {"contact", "its part from other surfaces"}};
    for (const auto& [source, text] : sources) {
        quantities.push_back(
            {fmt::format("{}_force", source), units.text(unit::force), text, vector});
        quantities.push_back({fmt::format("{}_moment", source), units.text(unit::energy),
                              "moment of this force about the centre", axial});
    }
    quantities.push_back({"particle_work",
                          units.text(unit::energy),
                          "work of particle_force and its moment since the start",
                          {}});
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
        for (const dynamics::multibody::Screw& f :
             {received.total, received.pressure, received.viscous, received.material,
              received.contact}) {
            at = put<Dim>(at, f.head<3>());
            at = putAxial<Dim>(at, f.tail<3>());
        }
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
    quantities.push_back(
        {"reaction", units.text(unit::force),
         "force of the parent on the child, also by what acts on the joint's coordinates",
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

template <int Dim>
std::unique_ptr<io::SeriesSource> forceSource(const MechanismOwner& owner, const input::Name& name,
                                              const input::UnitSystem& units) {
    using dynamics::multibody::ForceKind;
    const auto& forces = owner.parameters().forces;
    const int number = numberOf(forces, name.text, &input::Component::name);
    const ForceKind kind = forces[static_cast<std::size_t>(number)]
                               .declaration->builder<dynamics::multibody::ForceBuilder>()
                               .kind;
    const std::string force = units.text(unit::force);
    if (kind == ForceKind::given) {
        std::vector<io::SeriesQuantity> quantities{
            {"force", force, "on the body", io::componentLabels<Dim>(particles::Rank::vector)},
            {"moment", units.text(unit::energy), "on the body", io::momentLabels<Dim>()}};
        return std::make_unique<ReduceSource>(std::move(quantities), [&owner, number](Row row) {
            const std::vector<double> v = owner.mechanism()->force(number);
            double* at = put<Dim>(row.data(), Vector(v[0], v[1], v[2]));
            putAxial<Dim>(at, Vector(v[3], v[4], v[5]));
        });
    }
    std::vector<io::SeriesQuantity> quantities;
    if (kind == ForceKind::spring)
        quantities = {{"length", units.text(unit::length), "between its ends", {}},
                      {"rate", units.text(unit::velocity), "of the length", {}},
                      {"tension", force, "below 0: it pushes", {}}};
    else
        quantities = {{"tension", force, "at its end 'to'", {}},
                      {"anchor_tension", force, "at its end 'from'", {}},
                      {"level_tension", force, "level part, the same all along it", {}},
                      {"resting", units.text(unit::length), "length that lies on the ground", {}}};
    return std::make_unique<ReduceSource>(std::move(quantities), [&owner, number](Row row) {
        std::ranges::copy(owner.mechanism()->force(number), row.begin());
    });
}

std::unique_ptr<io::SeriesSource> energySource(const MechanismOwner& owner,
                                               const input::UnitSystem& units) {
    const std::string unit = units.text(unit::energy);
    std::vector<io::SeriesQuantity> quantities{
        {"kinetic", unit, "of all bodies", {}},
        {"potential", unit, "-sum m g . x", {}},
        {"springs", unit, "of springs, ropes, lines and stops", {}},
        {"total", unit, "their sum", {}},
        {"constraint_error",
         "",
         "largest of the constraints, in the case's length "
         "and radian",
         {}}};
    return std::make_unique<ReduceSource>(std::move(quantities), [&owner](Row row) {
        const auto energy = owner.mechanism()->energy();
        row[0] = energy.kinetic;
        row[1] = energy.gravity;
        row[2] = energy.springs;
        row[3] = energy.kinetic + energy.gravity + energy.springs;
        row[4] = owner.mechanism()->constraintError();
    });
}

}  // namespace

void declareMultibody(input::Registry& registry) {
    using P = MultibodyOutputParameters;
    auto& d = registry.declare<P>(input::Kind::output, "multibody");
    d.summary(
        "Time series of a rigid body, of a joint, of a force, or of the energy of the mechanism");
    d.optional("body", &P::body, input::rigidBodyReference(),
               "its place, turn, velocities, and what its particles get");
    d.optional("joint", &P::joint, input::jointReference(),
               "its coordinates, their rates and its reaction");
    d.optional("force", &P::force, input::multibodyForceReference(),
               "what it exerts; without body, joint and force: the energy of the whole mechanism");
    io::declareMeans(d);
    d.check("joint", [](const P& p) -> std::string {
        return !p.body.empty() + !p.joint.empty() + !p.force.empty() <= 1
                   ? ""
                   : "give one of body, joint and force";
    });
    d.builder(io::outputFactory<P>([]<int Dim>(const P& p, const input::Component& component,
                                               const io::OutputContext<Dim>& context) {
        const MechanismOwner& owner = ownerOf(component, context);
        auto source = !p.body.empty()    ? bodySource<Dim>(owner, p.body.text, context.units)
                      : !p.joint.empty() ? jointSource<Dim>(owner, p.joint, context.units)
                      : !p.force.empty() ? forceSource<Dim>(owner, p.force, context.units)
                                         : energySource(owner, context.units);
        const std::string form = p.body.text + p.joint.text + p.force.text;
        return io::makeRowsOutput(component, context, {p, form}, std::move(source));
    }));
}

}  // namespace sphinx::measure
