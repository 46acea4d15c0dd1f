// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/context.h"
#include "dynamics/fluid/wall_fields.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace sphinx::dynamics::fluid {

/// A fluid's neighbors as its methods sum over them: its own particles, and the walls and the other
/// liquids that it sees. Made in a method's constructor.
template <int Dim>
class Surroundings {
 public:
    struct Wall {
        Body<Dim>* body;
        const Relation<Dim>* relation;
        WallFields<Dim> fields;

        const NeighborList<Dim>& list() const { return relation->list; }
    };
    /// Another fluid.
    struct Liquid {
        Body<Dim>* body;
        const Relation<Dim>* relation;
        const Field<Vec<Dim>>* velocity;
        const Field<double>* volume;

        const NeighborList<Dim>& list() const { return relation->list; }
    };
    /// What lists keep for each pair besides the gradient.
    struct Needs {
        sphinx::neighbors::Keeps walls = {};
        sphinx::neighbors::Keeps liquids = {};
        bool sees_walls = true;
    };

    Surroundings(Context<Dim>& context, Body<Dim>& fluid, const Needs& needs) {
        for (Body<Dim>* other : fluid.sees) {
            if (other == &fluid)
                own_ = &context.relations.ownPairs(fluid);
            else if (other->isFluid())
                liquids_.push_back({other, &context.relations.flow(fluid, *other, needs.liquids),
                                    &other->particles.vector(fields::velocity),
                                    &other->particles.scalar(fields::volume)});
            else if (needs.sees_walls)
                walls_.push_back({other, &context.relations.flow(fluid, *other, needs.walls),
                                  WallFields<Dim>(*other)});
        }
    }

    /// The fluid's own particles. The fluid is known to see itself.
    const PairTiles<Dim>& own() const { return *own_; }
    const std::vector<Wall>& walls() const { return walls_; }
    const std::vector<Liquid>& liquids() const { return liquids_; }
    /// Before sums over walls that may have moved.
    void look() {
        for (Wall& wall : walls_) wall.fields.look(*wall.body);
    }
    /// The particles that have neighbors in any of the walls or other liquids, ascending.
    const std::vector<Index>& atOthers() {
        std::uint64_t builds = own_->builds();  // counts only grow: so the sum tells of any
        const auto each = [&](auto&& f) {
            for (const Wall& wall : walls_) f(*wall.relation);
            for (const Liquid& liquid : liquids_) f(*liquid.relation);
        };
        each([&](const Relation<Dim>& relation) { builds += relation.builds; });
        if (builds == builds_) return at_others_;
        builds_ = builds;
        at_others_.clear();
        std::vector<const NeighborList<Dim>*> lists;
        each([&](const Relation<Dim>& relation) { lists.push_back(&relation.list); });
        if (lists.empty()) return at_others_;
        const std::size_t n = lists.front()->ranges.size();
        for (Index i = 0; i < n; ++i)
            if (std::ranges::any_of(lists, [&](const auto* l) { return l->ranges[i].count != 0; }))
                at_others_.push_back(i);
        return at_others_;
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
    std::vector<Liquid> liquids_;
    std::vector<Index> at_others_;
    std::uint64_t builds_ = 0;  // of all lists, when they were found
};

}  // namespace sphinx::dynamics::fluid
