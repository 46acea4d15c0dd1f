// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "neighbors/reference_list.h"

#include <algorithm>
#include <bit>
#include <tuple>

namespace sphinx::neighbors {
namespace {

/// Fewer neighbors than these in a row are gathered.
constexpr std::ptrdiff_t shortest_run = lane_count / 2;

}  // namespace

template <int Dim>
void ReferenceList<Dim>::append(std::vector<Neighbor>& neighbors, std::size_t particles) {
    GroupBlocks group{blocks_.size(), indices_.size(), 0, 0};
    // Equal for the neighbors of a run: what the first particle has there.
    const auto start = [](const Neighbor& n) { return std::int64_t{n.index} - n.lane; };
    std::sort(neighbors.begin(), neighbors.end(), [&](const Neighbor& a, const Neighbor& b) {
        return std::tuple(start(a), a.lane) < std::tuple(start(b), b.lane);
    });
    const auto last_start = static_cast<std::int64_t>(particles) - lane_count;
    std::array<std::vector<const Neighbor*>, lane_count> scattered;
    for (auto first = neighbors.begin(); first != neighbors.end();) {
        const std::int64_t row = start(*first);
        const auto end = std::find_if(first, neighbors.end(),
                                      [&](const Neighbor& n) { return start(n) != row; });
        if (end - first >= shortest_run && row >= 0 && row <= last_start) {
            Terms terms{};
            std::for_each(first, end, [&](const Neighbor& n) { put(n, terms); });
            appendBlock(terms);
            indices_.push_back(static_cast<Index>(row));
            ++group.runs;
        } else {
            std::for_each(first, end, [&](const Neighbor& n) {
                scattered[static_cast<std::size_t>(n.lane)].push_back(&n);
            });
        }
        first = end;
    }
    group.blocks = group.runs;
    for (std::size_t b = 0;; ++b) {
        const auto used = std::find_if(scattered.begin(), scattered.end(),
                                       [&](const auto& lane) { return b < lane.size(); });
        if (used == scattered.end()) break;
        Terms terms{};
        for (const auto& lane : scattered) {
            indices_.push_back((b < lane.size() ? lane : *used)[b]->index);
            if (b < lane.size()) put(*lane[b], terms);
        }
        appendBlock(terms);
        ++group.blocks;
    }
    groups_.push_back(group);
}

template <int Dim>
std::size_t ReferenceList<Dim>::Hash::operator()(const Terms& terms) const {
    std::uint64_t sum = 0;
    const auto add = [&](const Lane& values) {
        for (const double value : values)
            sum = std::rotl((sum ^ std::bit_cast<std::uint64_t>(value)) * 0x9e3779b97f4a7c15, 29);
    };
    for (const Lane& component : terms.gradient) add(component);
    add(terms.weight);
    return sum;
}

template <int Dim>
void ReferenceList<Dim>::appendBlock(const Terms& terms) {
    const auto [place, is_new] = known_.try_emplace(terms, static_cast<Index>(terms_.size()));
    if (is_new) terms_.push_back(terms);
    blocks_.push_back(place->second);
}

template <int Dim>
void ReferenceList<Dim>::put(const Neighbor& neighbor, Terms& terms) {
    const auto lane = static_cast<std::size_t>(neighbor.lane);
    for (int c = 0; c < Dim; ++c)
        terms.gradient[static_cast<std::size_t>(c)][lane] = neighbor.gradient[c];
    terms.weight[lane] = neighbor.weight;
}

template <int Dim>
void ReferenceList<Dim>::finish() {
    known_ = {};
    groups_.shrink_to_fit();
    terms_.shrink_to_fit();
    blocks_.shrink_to_fit();
    indices_.shrink_to_fit();
}

template <int Dim>
std::size_t ReferenceList<Dim>::bytes() const {
    return groups_.capacity() * sizeof(GroupBlocks) + terms_.capacity() * sizeof(Terms) +
           blocks_.capacity() * sizeof(Index) + indices_.capacity() * sizeof(Index);
}

template class ReferenceList<2>;
template class ReferenceList<3>;

}  // namespace sphinx::neighbors
