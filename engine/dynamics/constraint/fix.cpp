// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"
#include "dynamics/methods.h"
#include "dynamics/part_method.h"
#include "dynamics/radiation.h"

#include <algorithm>
#include <array>
#include <functional>

namespace sphinx::dynamics::constraint {
namespace {

/// Holds particles of an elastic body where they are: v = 0, in all or some directions. Between the
/// halves of the step, after the velocity has got its kick m dv = f dt, which is minus what the
/// support gives.
struct FixParameters {
    input::Name part;
    std::vector<int> directions;
};

}  // namespace

void declareFix(input::Registry& registry) {
    using P = FixParameters;
    auto& d = declarePartMethod<Support, P>(
        registry, "constraint.fix", []<int Dim>(const P& p, const Part<Dim>& whole, Context<Dim>&) {
            auto& velocity = whole.body().particles.vector(fields::velocity);
            std::array<bool, Dim> fixed;
            fixed.fill(p.directions.empty());
            for (const int axis : p.directions) fixed[static_cast<std::size_t>(axis)] = true;
            const bool all = std::ranges::all_of(fixed, std::identity());
            return [&velocity, fixed, all, radiation = Radiation<Dim>(whole.body().particles)](
                       const Clock& clock, KnownLoad<Dim>& load) mutable {
                const Part<Dim>& part = load.part();
                AlignedVector<Vec<Dim>>& force = load.forces();
                radiation.begin(clock.dt);
                const auto fix = [&](std::size_t n) {
                    const std::size_t i = part[n];
                    if (!clock.is_start) {
                        force[n] = radiation.impose(i, fixed, Vec<Dim>::Zero());
                        return;
                    }
                    force[n].setZero();
                    for (int c = 0; c < Dim; ++c)
                        if (fixed[static_cast<std::size_t>(c)]) velocity[i][c] = 0;
                };
                parallelForGroups(part.size(), [&](const Group& group) {
                    const std::size_t end = group.first + group.count;
                    const Group row{part[group.first], group.count};
                    if (all && !clock.is_start && part[end - 1] == row.first + row.count - 1)
                        return store(radiation.stop(row), force.data(), group);
                    for (std::size_t n = group.first; n < end; ++n) fix(n);
                });
            };
        });
    d.summary("Holds particles of an elastic body: no motion, or none along some axes");
    d.required("part", &P::part, input::partReference({"elastic"}), "body, or part of a body");
    d.optional("directions", &P::directions, input::axes(),
               "axes along which nothing moves; without: all");
    d.action("between the halves of the step")
        .reads("part", {"velocity", "mass"})
        .mayRead("part", {"radiation_impedance"})
        .writes("part", {"velocity"})
        .within("part", "step");
}

}  // namespace sphinx::dynamics::constraint
