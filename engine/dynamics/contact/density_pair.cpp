// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/contact/density_pair.h"

#include "core/parallel.h"
#include "neighbors/common_kernel.h"

#include <algorithm>

namespace sphinx::dynamics::contact {

template <int Dim>
DensityPair<Dim>::DensityPair(const Domain<Dim>& domain, Surface<Dim>& a, Surface<Dim>& b,
                              const PairLaw& law)
    : Pair<Dim>(domain, a, b, law, sphinx::neighbors::commonKernel(a.body(), b.body()).cutoff()),
      kernel_(&sphinx::neighbors::commonKernel(a.body(), b.body())),
      modulus_(law.stiffness * std::max(a.body().spacing, b.body().spacing)) {
    sides_.push_back({&a, &b, &this->search_.ofA(), {}});
    if (&a != &b) sides_.push_back({&b, &a, &this->search_.ofB(), {}});
}

template <int Dim>
void DensityPair<Dim>::findPressure(Side& side) const {
    const Surface<Dim>& from = *side.from;
    const std::vector<Index>& active = side.lists->active();
    side.pressure.resize(from.size());
    parallelFor(active.size(), [&](std::size_t m) {
        const Index n = active[m];
        const Vec<Dim> x = from.place(n);
        double sum = 0;
        for (const Index k : side.lists->of(n)) {
            const double r = this->domain_->difference(x, side.to->place(k)).norm();
            if (r < this->reach_) sum += kernel_->value(r);
        }
        side.pressure[n] = modulus_ * from.volume(n) * sum;
    });
}

template <int Dim>
void DensityPair<Dim>::push(Side& side, const Side& other) const {
    Surface<Dim>& from = *side.from;
    const Surface<Dim>& to = *side.to;
    const std::vector<Index>& active = side.lists->active();
    Loads<Dim>& loads = from.loads();
    for (const Index n : active) loads.touch(from.particle(n));
    parallelFor(active.size(), [&](std::size_t m) {
        const Index n = active[m];
        const Vec<Dim> x = from.place(n);
        const Vec<Dim> v = from.velocity(n);
        Vec<Dim> force = Vec<Dim>::Zero();
        for (const Index k : side.lists->of(n)) {
            const Vec<Dim> apart = this->domain_->difference(x, to.place(k));
            const double r = apart.norm();
            if (r >= this->reach_ || r == 0) continue;
            const Vec<Dim> e = apart / r;
            const double slope = -kernel_->derivative(r) * from.volume(n) * to.volume(k);
            const double closing = (v - to.velocity(k)).dot(e);
            force += ((side.pressure[n] + other.pressure[k]) -
                      2 * (Dim + 2) * this->law_.viscous * closing / r) *
                     slope * e;
        }
        if (force.isZero(0)) return;
        loads.force[from.particle(n)] += force;
        loads.pressure[from.particle(n)] += side.pressure[n];
    });
}

template <int Dim>
void DensityPair<Dim>::act(double) {
    this->search();
    for (Side& side : sides_) findPressure(side);
    for (std::size_t s = 0; s < sides_.size(); ++s) push(sides_[s], sides_[sides_.size() - 1 - s]);
}

template class DensityPair<2>;
template class DensityPair<3>;

}  // namespace sphinx::dynamics::contact
