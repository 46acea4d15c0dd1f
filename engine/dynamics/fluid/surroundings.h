// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/context.h"
#include "dynamics/fluid/wall_fields.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace sphinx::dynamics::fluid {

/// A fluid's neighbors as its methods sum over them: its own particles, and the walls that it sees.
/// Made in a method's constructor.
template <int Dim>
class Surroundings {
 public:
    struct Wall {
        Body<Dim>* body;
        const Relation<Dim>* relation;
        WallFields<Dim> fields;

        const NeighborList<Dim>& list() const { return relation->list; }
    };
    /// What the lists of walls keep for each pair besides the gradient.
    struct Needs {
        sphinx::neighbors::Keeps walls = {};
        bool sees_walls = true;
    };

    Surroundings(Context<Dim>& context, Body<Dim>& fluid, const Needs& needs) {
        for (Body<Dim>* other : fluid.sees) {
            if (other == &fluid)
                own_ = &context.relations.ownPairs(fluid);
            else if (needs.sees_walls)
                walls_.push_back({other, &context.relations.flow(fluid, *other, needs.walls),
                                  WallFields<Dim>(*other)});
        }
    }

    /// The fluid's own particles. The fluid is known to see itself.
    const PairTiles<Dim>& own() const { return *own_; }
    const std::vector<Wall>& walls() const { return walls_; }
    /// Before sums over walls that may have moved.
    void look() {
        for (Wall& wall : walls_) wall.fields.look(*wall.body);
    }
    /// The particles that have neighbors in any of the walls, ascending.
    const std::vector<Index>& atWalls() {
        std::uint64_t builds = own_->builds();  // counts only grow: so the sum tells of any
        for (const Wall& wall : walls_) builds += wall.relation->builds;
        if (builds == builds_) return at_walls_;
        builds_ = builds;
        at_walls_.clear();
        if (walls_.empty()) return at_walls_;
        const std::size_t n = walls_.front().list().ranges.size();
        for (Index i = 0; i < n; ++i)
            if (std::ranges::any_of(
                    walls_, [&](const Wall& wall) { return wall.list().ranges[i].count != 0; }))
                at_walls_.push_back(i);
        return at_walls_;
    }
    /// nullptr where the body is none of the walls.
    const Wall* wall(const Body<Dim>& body) const {
        for (const Wall& wall : walls_)
            if (wall.body == &body) return &wall;
        return nullptr;
    }

 private:
    const PairTiles<Dim>* own_ = nullptr;
    std::vector<Wall> walls_;
    std::vector<Index> at_walls_;
    std::uint64_t builds_ = 0;  // of all lists, when they were found
};

}  // namespace sphinx::dynamics::fluid
