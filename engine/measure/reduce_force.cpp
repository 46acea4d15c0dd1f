// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "measure/reduce_force.h"

#include "io/series/columns.h"

#include <algorithm>

namespace sphinx::io {

template <int Dim>
ForceSource<Dim>::ForceSource(const Body<Dim>& solid,
                              const std::vector<const fluid::SolidLoad<Dim>*>& loads,
                              Relations<Dim>& relations, const input::UnitSystem& units,
                              const std::optional<Vec<Dim>>& moment_about)
    : solid_(&solid), relations_(&relations), moment_about_(moment_about) {
    for (const fluid::SolidLoad<Dim>* load : loads) {
        const auto same = [&](const FluidLoads& one) { return one.own.from == &load->fluid(); };
        auto place = std::find_if(fluids_.begin(), fluids_.end(), same);
        if (place == fluids_.end()) {
            FluidLoads& fluid = fluids_.emplace_back();
            fluid.own.from = &load->fluid();
            fluid.own.to = &solid;
            fluid.own.list.keeps.distance = true;
            fluid.acting = &relations.flow(load->fluid(), solid, {.distance = true});
            place = fluids_.end() - 1;
        }
        place->loads.push_back(load);
    }
    if (moment_about_) {
        const std::string moment = units.text(unit::force * unit::length);
        const std::vector<std::string> axes = momentLabels<Dim>();
        quantities_ = {{"pressure_moment", moment, "by the pressure of the fluids", axes},
                       {"viscous_moment", moment, "by the viscosity of the fluids", axes},
                       {"moment", moment, "of the fluids on the body", axes}};
        return;
    }
    const std::string force = units.text(unit::force);
    const std::vector<std::string> axes = componentLabels<Dim>(Rank::vector);
    quantities_ = {{"pressure_force", force, "by the pressure of the fluids", axes},
                   {"viscous_force", force, "by the viscosity of the fluids", axes},
                   {"force", force, "of the fluids on the body", axes}};
}

template <int Dim>
const NeighborList<Dim>& ForceSource<Dim>::listOf(FluidLoads& fluid) const {
    if (fluid.acting->namesParticles()) return fluid.acting->list;
    relations_->update(fluid.own);
    return fluid.own.list;
}

template <int Dim>
void ForceSource<Dim>::sample(const Clock&, std::span<double> row) {
    const Vec<Dim> about = moment_about_.value_or(Vec<Dim>(Vec<Dim>::Zero()));
    Load<Dim> pressure, viscous;
    for (FluidLoads& fluid : fluids_) {
        const NeighborList<Dim>& list = listOf(fluid);
        const auto add = [&](fluid::LoadKind kind, Load<Dim>& sum) {
            if (const auto* load = fluid::presentLoad(fluid.loads, *fluid.own.from, kind))
                sum += load->loadOn(*solid_, list, about);
        };
        add(fluid::LoadKind::pressure, pressure);
        add(fluid::LoadKind::viscous, viscous);
    }
    const auto fill = [&](const auto& a, const auto& b) {
        const int n = static_cast<int>(a.size());
        for (int k = 0; k < n; ++k) {
            row[k] = a[k];
            row[n + k] = b[k];
            row[2 * n + k] = a[k] + b[k];
        }
    };
    if (moment_about_)
        fill(pressure.moment, viscous.moment);
    else
        fill(pressure.force, viscous.force);
}

template <int Dim>
std::unique_ptr<SeriesSource> makeForceSource(const Body<Dim>& solid, const input::Place& place,
                                              const OutputContext<Dim>& context,
                                              const std::optional<Vec<Dim>>& moment_about) {
    std::vector<const fluid::SolidLoad<Dim>*> loads;
    for (const Method* method : context.methods) {
        const auto* load = dynamic_cast<const fluid::SolidLoad<Dim>*>(method);
        if (!load) continue;
        const std::vector<Body<Dim>*>& seen = load->fluid().sees;
        if (std::find(seen.begin(), seen.end(), &solid) != seen.end()) loads.push_back(load);
    }
    if (loads.empty())
        failAt(place, "there is no force on '" + solid.name +
                          "' to be summed: no fluid that the loop moves sees it");
    return std::make_unique<ForceSource<Dim>>(solid, loads, context.relations, context.units,
                                              moment_about);
}

template class ForceSource<2>;
template class ForceSource<3>;
template std::unique_ptr<SeriesSource> makeForceSource<2>(const Body<2>&, const input::Place&,
                                                          const OutputContext<2>&,
                                                          const std::optional<Vec<2>>&);
template std::unique_ptr<SeriesSource> makeForceSource<3>(const Body<3>&, const input::Place&,
                                                          const OutputContext<3>&,
                                                          const std::optional<Vec<3>>&);

}  // namespace sphinx::io
