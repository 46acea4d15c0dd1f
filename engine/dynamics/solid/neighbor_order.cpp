// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/solid/neighbor_order.h"

#include "core/errors.h"
#include "core/parallel.h"

#include <fmt/format.h>
#include <algorithm>

namespace sphinx::dynamics::solid {
namespace {

/// Of the nearest neighbors, over the spacing: those along the axes of the lattice.
constexpr double nearest = 1.1;

}  // namespace

template <int Dim>
NeighborOrder<Dim>::NeighborOrder(const World<Dim>& world, Relations<Dim>& relations,
                                  Body<Dim>& body)
    : world_(&world),
      body_(&body),
      relation_(&relations.reference(body, body)),
      relations_(&relations) {}

template <int Dim>
void NeighborOrder<Dim>::findPairs() {
    if (!watch_.hasChanged(body_->particles)) return;
    relations_->build(*relation_);
    pairs_.clear();
    const auto& start = body_->particles.vector(fields::initial_position);
    const bodies::ElasticRole<Dim>& role = body_->elastic();
    for (std::size_t i = 0; i < body_->size(); ++i) {
        if (role.share(i) == 0) continue;
        relation_->list.forEach(i, [&](Index j, double) {
            if (j <= i || role.share(j) == 0) return;
            const Vec<Dim> R = world_->domain.difference(start[i], start[j]);
            if (R.norm() <= nearest * body_->spacing)
                pairs_.push_back({static_cast<Index>(i), j, R});
        });
    }
}

template <int Dim>
void NeighborOrder<Dim>::check(const Clock& clock) {
    findPairs();
    const auto& position = body_->particles.position();
    const auto& gradient = body_->particles.matrix(fields::deformation_gradient);
    const auto turned = [&](const Pair& pair) {
        const Vec<Dim> r = world_->domain.difference(position[pair.i], position[pair.j]);
        return !(r.dot((gradient[pair.i] + gradient[pair.j]) * pair.distance) > 0);
    };
    const std::size_t none = pairs_.size();
    const std::size_t first = reduceAll(
        pairs_.size(), none,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k)
                if (turned(pairs_[k])) return k;
            return none;
        },
        [](std::size_t a, std::size_t b) { return std::min(a, b); });
    if (first != none) fail(pairs_[first], clock);
}

template <int Dim>
void NeighborOrder<Dim>::fail(const Pair& pair, const Clock& clock) const {
    const auto& id = body_->particles.id();
    throw PhysicsError(fmt::format(
        "particles {} and {} of {} at {} have changed places, time {}: its deformation is finer "
        "than its spacing; a finer spacing or a stiffer material may help",
        std::min(id[pair.i], id[pair.j]), std::max(id[pair.i], id[pair.j]), body_->name,
        world_->placeText(body_->particles.position()[pair.i]),
        world_->quantityText(clock.time, unit::time)));
}

template class NeighborOrder<2>;
template class NeighborOrder<3>;

}  // namespace sphinx::dynamics::solid
