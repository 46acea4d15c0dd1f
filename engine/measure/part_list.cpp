// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "measure/part_list.h"

#include <algorithm>

namespace sphinx::measure {

template <int Dim>
neighbors::NeighborList<Dim> listOfPart(const neighbors::NeighborList<Dim>& list,
                                        const bodies::BodyPart<Dim>& part, std::size_t held) {
    std::vector<char> inside(held, 0);
    for (const Index j : part.particles) inside[j] = 1;
    neighbors::NeighborList<Dim> own;
    own.cutoff = list.cutoff;
    own.gradient_unit = list.gradient_unit;
    own.keeps.distance = list.keeps.distance;
    own.ranges.resize(list.ranges.size());
    for (std::size_t i = 0; i < list.ranges.size(); ++i) {
        auto& range = own.ranges[i];
        range.first = own.blocks.size();
        const std::int32_t* distance = list.keeps.distance ? list.distancesOf(i) : nullptr;
        for (std::size_t b = 0; b < list.of(i).size(); ++b) {
            auto block = list.of(i)[b];
            std::uint32_t count = 0;
            for (std::size_t k = 0; k < lane_count; ++k) {
                const bool is_neighbor = b * lane_count + k < list.ranges[i].count;
                if (is_neighbor && inside[block.index[k]])
                    ++count;
                else
                    for (auto& component : block.gradient) component[k] = 0;
            }
            if (count == 0) continue;
            own.blocks.push_back(block);
            if (distance)
                own.distance.insert(own.distance.end(), distance + b * lane_count,
                                    distance + (b + 1) * lane_count);
            ++range.blocks;
            range.count += count;
        }
    }
    return own;
}

template neighbors::NeighborList<2> listOfPart(const neighbors::NeighborList<2>&,
                                               const bodies::BodyPart<2>&, std::size_t);
template neighbors::NeighborList<3> listOfPart(const neighbors::NeighborList<3>&,
                                               const bodies::BodyPart<3>&, std::size_t);

}  // namespace sphinx::measure
