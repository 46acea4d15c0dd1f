// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "neighbors/reference_list.h"

#include <catch2/catch.hpp>
#include <map>
#include <random>

using namespace sphinx;
using namespace sphinx::neighbors;

namespace {

using Neighbor = ReferenceList<2>::Neighbor;

Neighbor neighbor(int lane, Index j) {
    const double value = 1 + 100 * lane + j;
    return {lane, j, {value, -value}, 2 * value};
}

/// The list of one group has these neighbors of its particles, and no others.
void checkHolds(const ReferenceList<2>& list, const std::vector<Neighbor>& neighbors) {
    for (int lane = 0; lane < lane_count; ++lane) {
        std::map<Index, double> found, expected;
        list.forEach(static_cast<std::size_t>(lane),
                     [&](Index j, double weight) { CHECK(found.emplace(j, weight).second); });
        for (const Neighbor& n : neighbors)
            if (n.lane == lane) expected.emplace(n.index, n.weight);
        CHECK(found == expected);
    }
    // Component by component, in blocks of which the runs come first.
    const auto& group = list.group(0);
    const Index* index = list.indices(group);
    for (std::uint32_t b = 0; b < group.blocks; ++b)
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            const auto& gradient = list.terms(group, b).gradient;
            CHECK(gradient[0][lane] == -gradient[1][lane]);
            if (gradient[0][lane] == 0) continue;
            const Index j = b < group.runs
                                ? index[b] + static_cast<Index>(lane)
                                : index[group.runs + (b - group.runs) * lane_count + lane];
            CHECK(gradient[0][lane] == neighbor(static_cast<int>(lane), j).gradient[0]);
        }
}

}  // namespace

TEST_CASE("neighbors in rows are runs, also where some are missing") {
    std::vector<Neighbor> neighbors;
    for (int lane = 0; lane < lane_count; ++lane)
        for (const int offset : {40, -1, 1, 20})
            if (!(offset == 20 && lane > 4)) neighbors.push_back(neighbor(lane, 8 + lane + offset));
    ReferenceList<2> list;
    std::vector<Neighbor> sorted = neighbors;
    list.append(sorted, 56);
    CHECK(list.group(0).runs == 4);
    CHECK(list.group(0).blocks == 4);
    checkHolds(list, neighbors);
}

TEST_CASE("a run stays within the body") {
    std::vector<Neighbor> neighbors;
    for (int lane = 0; lane < 7; ++lane) neighbors.push_back(neighbor(lane, 40 + lane));
    std::vector<Neighbor> sorted = neighbors;
    ReferenceList<2> list;
    list.append(sorted, 47);
    CHECK(list.group(0).runs == 0);
    CHECK(list.group(0).blocks == 1);
    checkHolds(list, neighbors);
}

TEST_CASE("neighbors anywhere are found again") {
    std::mt19937 random(3);
    std::uniform_int_distribution<Index> any(0, 99);
    std::map<std::pair<int, Index>, bool> used;
    std::vector<Neighbor> neighbors;
    for (int k = 0; k < 300; ++k) {
        const int lane = k % 7;  // the last particle has none
        const Index j = any(random);
        if (used.emplace(std::pair(lane, j), true).second) neighbors.push_back(neighbor(lane, j));
    }
    std::vector<Neighbor> sorted = neighbors;
    ReferenceList<2> list;
    list.append(sorted, 100);
    CHECK(list.group(0).blocks > list.group(0).runs);
    checkHolds(list, neighbors);
}
