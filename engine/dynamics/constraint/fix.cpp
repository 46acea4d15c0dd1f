// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/constraint/fix.h"

#include "core/parallel.h"

namespace sphinx::constraint {

template <int Dim>
Fix<Dim>::Fix(Part<Dim> part, const std::vector<int>& directions)
    : part_(part),
      velocity_(part.body().particles.vector(fields::velocity)),
      mass_(part.body().particles.scalar(fields::mass)) {
    fixed_.fill(directions.empty());
    for (const int axis : directions) fixed_[static_cast<std::size_t>(axis)] = true;
}

template <int Dim>
void Fix<Dim>::run(const Clock& clock) {
    Vec<Dim> momentum = parallelReduce(
        part_.size(), Vec<Dim>(Vec<Dim>::Zero()),
        [&](std::size_t begin, std::size_t end) {
            Vec<Dim> sum = Vec<Dim>::Zero();
            for (std::size_t n = begin; n < end; ++n) {
                const std::size_t i = part_[n];
                for (int c = 0; c < Dim; ++c) {
                    if (!fixed_[static_cast<std::size_t>(c)]) continue;
                    sum[c] += mass_[i] * velocity_[i][c];
                    velocity_[i][c] = 0;
                }
            }
            return sum;
        },
        [](const Vec<Dim>& a, const Vec<Dim>& b) -> Vec<Dim> { return a + b; });
    if (!clock.is_start) this->reaction_ = -momentum / clock.dt;
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

}  // namespace sphinx::constraint
