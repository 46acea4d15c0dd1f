// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "fitting/reach_list.h"

#include "core/errors.h"
#include "neighbors/candidates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sphinx::fitting {

template <int Dim>
ReachList<Dim>::ReachList(double reach, double room, const std::vector<Vec<Dim>>& outside)
    : reach_(reach), room_(room), cell_size_(0.8 * reach) {
    outside_.build(outside.data(), outside.size(), cell_size_);
}

template <int Dim>
void ReachList<Dim>::update(const AlignedVector<Vec<Dim>>& position) {
    // Two that approach each other have half of the room each.
    const double most = 0.25 * room_ * room_;
    const bool stays = position.size() == built_at_.size() &&
                       maxAll(position.size(), 0, [&](std::size_t i) {
                           return (position[i] - built_at_[i]).squaredNorm();
                       }) < most;
    if (!stays) build(position);
}

template <int Dim>
void ReachList<Dim>::build(const AlignedVector<Vec<Dim>>& position) {
    built_at_ = position;
    fresh_ = true;
    particles_.build(position.data(), position.size(), cell_size_);
    blocks_.resize((particles_.cells() + cells_of_block - 1) / cells_of_block);
    parallelFor(
        blocks_.size(),
        [&](std::size_t b) {
            fill(blocks_[b], b * cells_of_block,
                 std::min((b + 1) * cells_of_block, particles_.cells()));
        },
        1);
}

template <int Dim>
void ReachList<Dim>::fill(Block& block, std::size_t first, std::size_t last) {
    thread_local neighbors::Candidates<Dim> near, beyond;
    thread_local AlignedVector<std::uint16_t> found;
    const double reach = reach_ + room_;
    const auto particles = static_cast<Index>(particles_.particles());
    block.neighbors.clear();
    block.count.clear();
    for (std::size_t cell = first; cell < last; ++cell) {
        const std::size_t begin = particles_.start(cell), end = particles_.start(cell + 1);
        if (begin == end) continue;
        const auto c = particles_.cellCoordinates(cell);
        Vec<Dim> lower;
        for (int k = 0; k < Dim; ++k)
            lower[k] = particles_.origin()[k] + c[k] * particles_.cellSize();
        const Vec<Dim> box_lower = lower.array() - reach;
        const Vec<Dim> box_upper = lower.array() + (particles_.cellSize() + reach);
        const Vec<Dim> none = Vec<Dim>::Zero();
        near.clear();
        beyond.clear();
        neighbors::collect(particles_, box_lower, box_upper, none, near);
        if (outside_.particles() > 0)
            neighbors::collect(outside_, box_lower, box_upper, none, beyond);
        near.finish();
        beyond.finish();
        const std::size_t most = std::max(near.count, beyond.count);
        if (most > std::numeric_limits<std::uint16_t>::max())
            throw PhysicsError("more than 65535 particles in the reach of one cell");
        found.resize(most + lane_count);
        for (std::size_t s = begin; s < end; ++s) {
            const Index i = particles_.order()[s];
            Vec<Dim> x;
            for (int k = 0; k < Dim; ++k) x[k] = particles_.sites()[s].x[k];
            const std::size_t before = block.neighbors.size();
            const auto add = [&](const neighbors::Candidates<Dim>& others, std::int32_t self,
                                 Index number) {
                const std::size_t n =
                    neighbors::findNear<false>(x, self, reach * reach, others, found.data());
                for (std::size_t m = 0; m < n; ++m)
                    block.neighbors.push_back(number + static_cast<Index>(others.index[found[m]]));
            };
            add(near, static_cast<std::int32_t>(i), 0);
            if (beyond.count > 0) add(beyond, neighbors::no_particle, particles);
            while ((block.neighbors.size() - before) % lane_count != 0)
                block.neighbors.push_back(i);
            block.count.push_back(
                static_cast<std::uint32_t>((block.neighbors.size() - before) / lane_count));
        }
    }
}

template <int Dim>
void ReachList<Dim>::findStirred(const AlignedVector<std::uint8_t>& moved) {
    const std::size_t cells = particles_.cells();
    if (std::exchange(fresh_, false)) {
        stirred_.assign(cells, 1);
        return;
    }
    moving_.assign(cells, 0);
    stirred_.resize(cells);
    parallelFor(cells, [&](std::size_t cell) {
        for (std::size_t s = particles_.start(cell); s < particles_.start(cell + 1); ++s)
            moving_[cell] |= moved[particles_.order()[s]];
    });
    const int reach = static_cast<int>(std::ceil((reach_ + room_) / particles_.cellSize()));
    std::size_t stride = 1;
    for (int k = 0; k < Dim; ++k) {  // one axis after the other
        const int count = particles_.counts()[k];
        parallelFor(cells, [&](std::size_t cell) {
            const int at = static_cast<int>(cell / stride % static_cast<std::size_t>(count));
            const int first = std::max(at - reach, 0), last = std::min(at + reach, count - 1);
            const std::uint8_t* row = moving_.data() + cell - static_cast<std::size_t>(at) * stride;
            std::uint8_t any = 0;
            for (int other = first; other <= last; ++other)
                any |= row[static_cast<std::size_t>(other) * stride];
            stirred_[cell] = any;
        });
        std::swap(moving_, stirred_);
        stride *= static_cast<std::size_t>(count);
    }
    std::swap(moving_, stirred_);
}

template class ReachList<2>;
template class ReachList<3>;

}  // namespace sphinx::fitting
