// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "measure/reduce.h"

#include "dynamics/part.h"
#include "io/series/rows_output.h"
#include "measure/reduce_force.h"
#include "measure/reduce_load.h"
#include "measure/reduce_motion.h"

namespace sphinx::measure {
namespace {

enum class Reduced {
    mechanical_energy,
    kinetic_energy,
    mass,
    momentum,
    angular_momentum,
    maximum_speed,
    front_position,
    force,
    moment,
    support_reaction,
    applied_load,
    contact_force,
};

/// Whether it has a moment, which is about a point.
bool hasMoment(Reduced quantity) {
    return quantity == Reduced::moment || quantity == Reduced::support_reaction ||
           quantity == Reduced::applied_load || quantity == Reduced::contact_force;
}

enum class Axis { x, y, z };

struct ReduceParameters : io::MeanParameters {
    input::Name body;
    Reduced quantity = Reduced::mechanical_energy;
    std::optional<Axis> axis;
    std::optional<input::Coordinates> about;
};

template <int Dim>
std::unique_ptr<io::SeriesSource> makeSource(const ReduceParameters& p,
                                             const input::Component& component,
                                             const io::OutputContext<Dim>& context) {
    const dynamics::Part<Dim> part(context.world, p.body);
    bodies::Body<Dim>& body = part.body();
    const ReducedBody<Dim> reduced{
        {&body, part.named()}, p.body.place, context.units, &context.relations};
    const auto about = p.about ? std::optional(p.about->template as<Dim>()) : std::nullopt;
    const bool knows_whole =
        p.quantity == Reduced::support_reaction || p.quantity == Reduced::applied_load;
    if (knows_whole && reduced.part)
        io::failAt(p.body.place, "supports and loads are known by body: ask for '" + body.name +
                                     "' instead of a part of it");
    switch (p.quantity) {
        case Reduced::mechanical_energy: return mechanicalEnergy(reduced);
        case Reduced::kinetic_energy: return kineticEnergy(reduced);
        case Reduced::mass: return mass(reduced);
        case Reduced::momentum: return momentum(reduced);
        case Reduced::angular_momentum: return angularMomentum(reduced);
        case Reduced::contact_force: return contactForce<Dim>(reduced, about);
        case Reduced::maximum_speed: return maximumSpeed(reduced);
        case Reduced::front_position: {
            const int axis = static_cast<int>(p.axis.value_or(Axis::x));
            if (axis >= Dim) io::failAt(component.placeOf("axis"), "a case in 2D has no axis z");
            return frontPosition(reduced, axis);
        }
        case Reduced::support_reaction:
            return makeLoadSource<Dim>(KnownLoads::supports, body, p.body.place, context, about);
        case Reduced::applied_load:
            return makeLoadSource<Dim>(KnownLoads::applied, body, p.body.place, context, about);
        case Reduced::moment:
        case Reduced::force: break;
    }
    if (!body.isSolid())
        io::failAt(p.body.place,
                   "the force is that of fluids on a solid, but '" + body.name + "' is a fluid");
    return makeForceSource<Dim>(reduced, context, about);
}

/// What is written, in the words of the case: a resumed run that writes something else begins its
/// mean anew.
std::string formOf(const ReduceParameters& p, const input::Component& component) {
    const auto word = [&](const char* name) {
        const input::Parameter& parameter = *component.declaration->parameter(name);
        return parameter.type->write(parameter.in(component.parameters.get()), nullptr).text;
    };
    std::string form = word("quantity") + " of " + p.body.text;
    if (p.axis) form += " along " + word("axis");
    return form;
}

}  // namespace

void declareReduce(input::Registry& registry) {
    using P = ReduceParameters;
    auto& d = registry.declare<P>(input::Kind::output, "reduce");
    d.summary("Time series of a sum or extreme over the particles of a body, or of a part of it");
    d.required("body", &P::body, input::partReference({"fluid", "solid"}),
               "fluid or solid, or a part of it");
    d.required(
        "quantity", &P::quantity,
        input::choice<Reduced>({
            {"mechanical_energy", Reduced::mechanical_energy,
             "kinetic, potential (-sum m g . x), internal (of a fluid or elastic body), total"},
            {"kinetic_energy", Reduced::kinetic_energy, "sum of m v^2/2"},
            {"mass", Reduced::mass, "mass, number of particles, number removed"},
            {"momentum", Reduced::momentum, "sum of m v"},
            {"angular_momentum", Reduced::angular_momentum, "sum of m x cross v about the origin"},
            {"maximum_speed", Reduced::maximum_speed, "largest abs(v)"},
            {"front_position", Reduced::front_position, "largest coordinate along 'axis'"},
            {"force", Reduced::force,
             "of the fluids on a solid: by pressure, by viscosity, and both"},
            {"moment", Reduced::moment,
             "of these forces about a point: by pressure, by viscosity, and both"},
            {"support_reaction", Reduced::support_reaction,
             "of the constraints on an elastic body, over its last step; with 'about' also the "
             "moment"},
            {"applied_load", Reduced::applied_load,
             "of the loads from outside (point_force, spring, surface_pressure) on an elastic "
             "body, or of mean_velocity on a fluid, over the last step; with 'about' also the "
             "moment"},
            {"contact_force", Reduced::contact_force,
             "of other surfaces on a solid (contact.force); with 'about' also the moment"},
        }),
        "what is written");
    d.optional("axis", &P::axis,
               input::choice<Axis>({{"x", Axis::x, ""}, {"y", Axis::y, ""}, {"z", Axis::z, ""}}),
               "of front_position; default x");
    d.optional("about", &P::about, input::coordinates(unit::length), "point of the moment");
    io::declareMeans(d);
    d.check("about", [](const P& p) -> std::string {
        return p.about && !hasMoment(p.quantity)
                   ? "'about' is for moment, support_reaction, applied_load and contact_force"
                   : "";
    });
    d.check("quantity", [](const P& p) -> std::string {
        return !p.about && p.quantity == Reduced::moment ? "a moment needs a point: 'about'" : "";
    });
    d.check("axis", [](const P& p) -> std::string {
        return p.axis && p.quantity != Reduced::front_position ? "'axis' is for front_position"
                                                               : "";
    });
    d.builder(io::outputFactory<P>([]<int Dim>(const P& p, const input::Component& component,
                                               const io::OutputContext<Dim>& context) {
        return io::makeRowsOutput(component, context, {p, formOf(p, component)},
                                  makeSource(p, component, context));
    }));
}

}  // namespace sphinx::measure
