// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/solid/neighbor_order.h"

#include "core/errors.h"
#include "core/parallel.h"
#include "dynamics/group.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace sphinx::dynamics::solid {
namespace {

/// Of the nearest neighbors, over the spacing: those along the axes of the lattice.
constexpr double nearest = 1.1;
/// Of the least distance between two that have not changed places. When no particle moves by more
/// than u, r_ij changes by 2 u at most, and F_ij R_ij by about 4 u: it is a sum over differences of
/// 2 u whose weights, abs(g_ij) R_ij, add up to 2.
constexpr double safe = 1.0 / 8;

template <int Dim>
VecOf<Dim, Wide> placesOf(const AlignedVector<Vec<Dim>>& places, const Group& group) {
    Lanes a[Dim];
    dynamics::detail::load<Dim>(places.data()->data(), group, a);
    return wide<Dim, 1>(a);
}

}  // namespace

template <int Dim>
NeighborOrder<Dim>::NeighborOrder(const World<Dim>& world, Relations<Dim>& relations,
                                  Body<Dim>& body)
    : world_(&world),
      body_(&body),
      relation_(&relations.reference(body, body)),
      relations_(&relations) {}

template <int Dim>
bool NeighborOrder<Dim>::findPairs() {
    if (!watch_.hasChanged(body_->particles)) return false;
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
    return true;
}

template <int Dim>
NeighborOrder<Dim>::Found NeighborOrder<Dim>::look() const {
    const auto& position = body_->particles.position();
    const auto& gradient = body_->particles.matrix(fields::deformation_gradient);
    const std::size_t none = pairs_.size();
    const Found all{none, std::numeric_limits<double>::infinity()};
    return reduceAll(
        pairs_.size(), all,
        [&](std::size_t begin, std::size_t end) {
            Found found = all;
            for (std::size_t k = begin; k < end; ++k) {
                const Pair& pair = pairs_[k];
                const Vec<Dim> r = world_->domain.difference(position[pair.i], position[pair.j]);
                const Vec<Dim> foretold =
                    0.5 * (gradient[pair.i] + gradient[pair.j]) * pair.distance;
                const double along = r.dot(foretold) / foretold.norm();
                if (!(along > 0)) return Found{k, 0};
                found.least = std::min(found.least, along);
            }
            return found;
        },
        [](const Found& a, const Found& b) {
            return Found{std::min(a.first, b.first), std::min(a.least, b.least)};
        });
}

template <int Dim>
double NeighborOrder<Dim>::moved() const {
    const auto& position = body_->particles.position();
    const std::size_t n = body_->size();
    if (std::ranges::any_of(world_->domain.periodic, std::identity()))
        return std::sqrt(maxAll(n, 0, [&](std::size_t i) {
            return world_->domain.difference(position[i], places_[i]).squaredNorm();
        }));
    return std::sqrt(reduceAll(
        groupCount(n), 0.0,
        [&](std::size_t begin, std::size_t end) {
            Wide most = 0;
            for (std::size_t number = begin; number < end; ++number) {
                const Group group = groupOf(number, n);
                most = max(most, (load(position, group) - placesOf(places_, group)).squaredNorm());
            }
            return maxOf(most);
        },
        [](double a, double b) { return std::max(a, b); }, group_block));
}

template <int Dim>
void NeighborOrder<Dim>::check(const Clock& clock) {
    if (!findPairs() && moved() < allowed_) return;
    const Found found = look();
    if (found.first < pairs_.size()) fail(pairs_[found.first], clock);
    const auto& position = body_->particles.position();
    places_.assign(position.data(), position.data() + body_->size());
    allowed_ = safe * found.least;
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
