// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "measure/reduce_force.h"

#include "io/series/columns.h"
#include "measure/part_list.h"

#include <algorithm>

namespace sphinx::measure {

template <int Dim>
ForceSource<Dim>::ForceSource(const ReducedBody<Dim>& reduced,
                              const std::vector<const dynamics::fluid::SolidLoad<Dim>*>& loads,
                              const std::optional<Vec<Dim>>& moment_about)
    : solid_(reduced.body),
      part_(reduced.part),
      relations_(reduced.relations),
      moment_about_(moment_about) {
    const bodies::Body<Dim>& solid = *solid_;
    const input::UnitSystem& units = reduced.units;
    const std::string total = "of the fluids on the " + reduced.what();
    for (const dynamics::fluid::SolidLoad<Dim>* load : loads) {
        const auto same = [&](const FluidLoads& one) { return one.own.from == &load->fluid(); };
        auto place = std::find_if(fluids_.begin(), fluids_.end(), same);
        if (place == fluids_.end()) {
            FluidLoads& fluid = fluids_.emplace_back();
            fluid.own.from = &load->fluid();
            fluid.own.to = &solid;
            fluid.own.list.keeps.distance = true;
            fluid.acting = &relations_->flow(load->fluid(), solid, {.distance = true});
            place = fluids_.end() - 1;
        }
        place->loads.push_back(load);
    }
    if (moment_about_) {
        const std::string moment = units.text(unit::force * unit::length);
        const std::vector<std::string> axes = io::momentLabels<Dim>();
        quantities_ = {{"pressure_moment", moment, "by the pressure of the fluids", axes},
                       {"viscous_moment", moment, "by the viscosity of the fluids", axes},
                       {"moment", moment, total, axes}};
        return;
    }
    const std::string force = units.text(unit::force);
    const std::vector<std::string> axes = io::componentLabels<Dim>(particles::Rank::vector);
    quantities_ = {{"pressure_force", force, "by the pressure of the fluids", axes},
                   {"viscous_force", force, "by the viscosity of the fluids", axes},
                   {"force", force, total, axes}};
}

template <int Dim>
const neighbors::NeighborList<Dim>& ForceSource<Dim>::listOf(FluidLoads& fluid) const {
    if (fluid.acting->namesParticles()) return fluid.acting->list;
    relations_->update(fluid.own);
    return fluid.own.list;
}

template <int Dim>
void ForceSource<Dim>::sample(const Clock&, std::span<double> row) {
    const Vec<Dim> about = moment_about_.value_or(Vec<Dim>(Vec<Dim>::Zero()));
    dynamics::Load<Dim> pressure, viscous;
    for (FluidLoads& fluid : fluids_) {
        const neighbors::NeighborList<Dim>& whole = listOf(fluid);
        neighbors::NeighborList<Dim> of_part;
        if (part_) of_part = listOfPart(whole, *part_, solid_->held());
        const neighbors::NeighborList<Dim>& list = part_ ? of_part : whole;
        const auto add = [&](dynamics::fluid::LoadKind kind, dynamics::Load<Dim>& sum) {
            if (const auto* load = dynamics::fluid::presentLoad(fluid.loads, *fluid.own.from, kind))
                sum += load->loadOn(*solid_, list, about);
        };
        add(dynamics::fluid::LoadKind::pressure, pressure);
        add(dynamics::fluid::LoadKind::viscous, viscous);
        add(dynamics::fluid::LoadKind::polymer, viscous);
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
std::unique_ptr<io::SeriesSource> makeForceSource(const ReducedBody<Dim>& reduced,
                                                  const io::OutputContext<Dim>& context,
                                                  const std::optional<Vec<Dim>>& moment_about) {
    std::vector<const dynamics::fluid::SolidLoad<Dim>*> loads;
    for (const dynamics::fluid::SolidLoad<Dim>* load : context.loads) {
        const std::vector<bodies::Body<Dim>*>& seen = load->fluid().sees;
        if (std::find(seen.begin(), seen.end(), reduced.body) != seen.end()) loads.push_back(load);
    }
    if (loads.empty())
        io::failAt(reduced.place, "there is no force on '" + reduced.body->name +
                                      "' to be summed: no fluid that the loop moves sees it");
    return std::make_unique<ForceSource<Dim>>(reduced, loads, moment_about);
}

template class ForceSource<2>;
template class ForceSource<3>;
template std::unique_ptr<io::SeriesSource> makeForceSource<2>(const ReducedBody<2>&,
                                                              const io::OutputContext<2>&,
                                                              const std::optional<Vec<2>>&);
template std::unique_ptr<io::SeriesSource> makeForceSource<3>(const ReducedBody<3>&,
                                                              const io::OutputContext<3>&,
                                                              const std::optional<Vec<3>>&);

}  // namespace sphinx::measure
