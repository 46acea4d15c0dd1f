// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/constraint/fix.h"

#include "core/parallel.h"

namespace sphinx::dynamics::constraint {

template <int Dim>
Fix<Dim>::Fix(Part<Dim> part, const std::vector<int>& directions)
    : Support<Dim>(part),
      part_(part),
      velocity_(part.body().particles.vector(fields::velocity)),
      mass_(part.body().particles.scalar(fields::mass)) {
    fixed_.fill(directions.empty());
    for (const int axis : directions) fixed_[static_cast<std::size_t>(axis)] = true;
}

template <int Dim>
void Fix<Dim>::run(const Clock& clock) {
    AlignedVector<Vec<Dim>>& force = this->forces();
    const double rate = clock.is_start ? 0 : 1 / clock.dt;
    parallelFor(part_.size(), [&](std::size_t n) {
        const std::size_t i = part_[n];
        force[n].setZero();
        for (int c = 0; c < Dim; ++c) {
            if (!fixed_[static_cast<std::size_t>(c)]) continue;
            force[n][c] = -rate * mass_[i] * velocity_[i][c];
            velocity_[i][c] = 0;
        }
    });
}

void declareFix(input::Registry& registry) {
    using P = FixParameters;
    auto& d = declareMethod<P>(
        registry, "constraint.fix", []<int Dim>(const P& p, Context<Dim>& context) {
            return std::make_unique<Fix<Dim>>(Part<Dim>(context.world, p.part), p.directions);
        });
    d.summary("Holds particles of an elastic body: no motion, or none along some axes");
    d.required("part", &P::part, input::partReference({"elastic"}), "body, or part of a body");
    d.optional("directions", &P::directions, input::axes(),
               "axes along which nothing moves; without: all");
    d.action("between the halves of the step")
        .reads("part", {"velocity", "mass"})
        .writes("part", {"velocity"})
        .within("part", "step");
}

template class Fix<2>;
template class Fix<3>;

}  // namespace sphinx::dynamics::constraint
