// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "measure/observe_weights.h"

#include "core/errors.h"
#include "core/exact_total.h"
#include "core/parallel.h"

namespace sphinx::measure {

template <int Dim>
ObserveWeights<Dim>::ObserveWeights(const bodies::Body<Dim>& observer,
                                    neighbors::Relations<Dim>& relations)
    : observer_(&observer),
      weights_(observer.size()),
      coverage_(observer.size()),
      position_(observer.particles.position().data(),
                observer.particles.position().data() + observer.size()),
      relations_(&relations) {
    for (bodies::Body<Dim>* body : observer.sees) {
        seen_.push_back(&relations.observation(observer, *body));
        const auto* volume = dynamic_cast<const particles::Field<double>*>(
            body->particles.find(fields::volume.name));
        if (!volume)
            throw CaseError("'" + observer.name + "' cannot observe '" + body->name +
                            "': its particles have no volume");
        volume_.push_back(volume);
    }
}

template <int Dim>
void ObserveWeights<Dim>::update() {
    for (neighbors::Relation<Dim>* relation : seen_) relations_->update(*relation);
    parallelFor(
        points(),
        [&](std::size_t point) {
            std::vector<ParticleWeight>& weights = weights_[point];
            weights.clear();
            ExactTotal total;
            for (std::size_t b = 0; b < seen_.size(); ++b) {
                const neighbors::NeighborList<Dim>& list = seen_[b]->list;
                const kernels::Kernel<Dim>& kernel = seen_[b]->to->kernel;
                const std::int32_t* distance = list.distancesOf(point);
                for (std::uint32_t k = 0; k < list.ranges[point].count; ++k) {
                    const Index j = list.of(point)[k / lane_count].index[k % lane_count];
                    const double r = list.distanceUnit() * distance[k];
                    const double weight = (*volume_[b])[j] * kernel.value(r);
                    if (!(weight > 0)) continue;
                    weights.push_back({static_cast<std::uint32_t>(b), j, weight});
                    total.add(weight);
                }
            }
            coverage_[point] = total.value();
            for (ParticleWeight& one : weights) one.weight /= coverage_[point];
        },
        64);
}

template class ObserveWeights<2>;
template class ObserveWeights<3>;

}  // namespace sphinx::measure
