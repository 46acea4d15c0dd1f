// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/group.h"
#include "dynamics/solid/reference_loop.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace sphinx::dynamics::solid {

/// Groups of an elastic body that stand still together with all in which they have neighbors: a
/// part that is held may be most of the body. A sum over neighbors that are what they were, to the
/// last bit, is what it was, and that of velocities which are all 0 is 0.
template <int Dim>
class StillGroups {
 public:
    /// For particles that have other places in memory than before: nothing is known of them.
    void begin(std::size_t particles) {
        const std::size_t groups = groupCount(particles);
        first_.assign(groups + 1, 0);
        neighbors_.clear();
        alone_.assign(groups, true);
        stood_.assign(groups, false);
        changed_.assign(groups, true);
        known_.assign(groups, false);
        place_.resize(particles);
        sum_.resize(groups);
    }
    /// Their neighbors in their own body.
    void setNeighbors(const ReferenceList<Dim>& list, std::size_t particles);
    /// Those that have some in another body as well always move.
    void excludeNeighborsOf(const ReferenceList<Dim>& list) {
        for (std::size_t number = 0; number < alone_.size(); ++number)
            if (list.group(number).blocks > 0) alone_[number] = false;
    }

    /// All these velocities are 0.
    bool rests(const Field<Vec<Dim>>& velocity, const Group& group) const {
        const auto rest = [&](std::size_t number) {
            return isZero(velocity, groupOf(number, velocity.size()));
        };
        return isZero(velocity, group) && alone_[group.number()] && allNear(group, rest);
    }

    /// Before the sums of a step, for each group: T is its stress now, `last` has those of the last
    /// sums and gets it afterwards.
    void look(const Field<Vec<Dim>>& velocity, const Field<Vec<Dim>>& position,
              const MatOf<Dim, Wide>& T, const Planes<Dim>& last, const Group& group) {
        const std::size_t number = group.number();
        const bool stands = isZero(velocity, group);
        const Vec<Dim>* now = position.data() + group.first;
        Vec<Dim>* before = place_.data() + group.first;
        const std::size_t bytes = group.count * sizeof(Vec<Dim>);
        const bool same = stands && stood_[number] && std::memcmp(now, before, bytes) == 0 &&
                          last.holds(T, group);
        if (stands && !same) std::memcpy(static_cast<void*>(before), now, bytes);
        stood_[number] = stands;
        changed_[number] = !same;
    }
    /// What adds to its stress afterwards changes it.
    void change(std::size_t number) { changed_[number] = true; }
    /// The sum over its neighbors that sum() gives, or gave when they were as they are.
    template <class Sum>
    VecOf<Dim, Wide> sumOf(const Group& group, Sum&& sum) {
        const std::size_t number = group.number();
        const auto same = [&](std::size_t other) { return !changed_[other]; };
        if (known_[number] && same(number) && allNear(group, same)) return sum_[number];
        const VecOf<Dim, Wide> value = sum();
        known_[number] = stood_[number] && alone_[number];
        if (known_[number]) sum_[number] = value;
        return value;
    }

 private:
    template <class Property>
    bool allNear(const Group& group, Property&& has) const {
        const Index* all = neighbors_.data();
        return std::all_of(all + first_[group.number()], all + first_[group.number() + 1], has);
    }

    std::vector<std::size_t> first_;  // of the group in neighbors_
    std::vector<Index> neighbors_;    // numbers of groups
    // By group, as bytes: several threads write them.
    std::vector<char> alone_;        // neighbors are all in its body
    std::vector<char> stood_;        // had velocity 0 when it was looked at
    std::vector<char> changed_;      // since the last sums
    std::vector<char> known_;        // has a sum
    AlignedVector<Vec<Dim>> place_;  // of those that stood
    AlignedVector<VecOf<Dim, Wide>> sum_;
};

template <int Dim>
void StillGroups<Dim>::setNeighbors(const ReferenceList<Dim>& list, std::size_t particles) {
    std::vector<Index> near;
    for (std::size_t number = 0; number < groupCount(particles); ++number) {
        near.clear();
        const auto add = [&](std::size_t particle) {
            near.push_back(static_cast<Index>(particle / lane_count));
        };
        forEachBlock<Dim>(list, groupOf(number, particles), [&](const auto& places, const auto&) {
            if constexpr (std::is_same_v<std::decay_t<decltype(places)>, Run>) {
                add(*places.first);
                add(*places.first + lane_count - 1);
            } else {
                std::for_each(places.index, places.index + lane_count, add);
            }
        });
        std::sort(near.begin(), near.end());
        near.erase(std::unique(near.begin(), near.end()), near.end());
        neighbors_.insert(neighbors_.end(), near.begin(), near.end());
        first_[number + 1] = neighbors_.size();
    }
}

}  // namespace sphinx::dynamics::solid
