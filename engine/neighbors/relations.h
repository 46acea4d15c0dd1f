// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/world.h"
#include "neighbors/cell_grid.h"
#include "neighbors/neighbor_list.h"
#include "neighbors/reference_list.h"

#include <map>
#include <memory>
#include <vector>

namespace sphinx::neighbors {

/// What a list is for. Two bodies may have one for each purpose: an elastic body its neighbors in
/// the reference configuration (ReferenceRelation), and others in the present one.
enum class Purpose {
    flow,         ///< the sums of fluids; rebuilt by neighbors.update
    observation,  ///< outputs that look; rebuilt by them before they write
};

/// Neighbors in one body of the particles of another (or the same) where they are now.
template <int Dim>
struct Relation {
    Purpose purpose = Purpose::flow;
    const bodies::Body<Dim>* from = nullptr;
    const bodies::Body<Dim>* to = nullptr;
    NeighborList<Dim> list;
    std::uint64_t builds = 0;                        ///< of the list
    std::uint64_t from_version = ~std::uint64_t{0};  ///< versions of the bodies when last built
    std::uint64_t to_version = ~std::uint64_t{0};
    std::uint64_t from_arrangement = ~std::uint64_t{0};  ///< of their particles, likewise
    std::uint64_t to_arrangement = ~std::uint64_t{0};

    /// The list still names the particles that were meant, wherever they may have moved.
    bool namesParticles() const {
        return from_arrangement == from->particles.arrangement() &&
               to_arrangement == to->particles.arrangement();
    }
};

/// Neighbors in the reference configuration of an elastic body, in itself or in a body that is one
/// piece of material with it. Built from the initial positions when asked for, once for each
/// arrangement of the particles in memory.
template <int Dim>
struct ReferenceRelation {
    bodies::Body<Dim>* from = nullptr;
    bodies::Body<Dim>* to = nullptr;
    ReferenceList<Dim> list;
    std::uint64_t from_arrangement = ~std::uint64_t{0};  ///< of the particles when it was built
    std::uint64_t to_arrangement = ~std::uint64_t{0};
};

template <int Dim>
class PairTiles;

/// All relations of a simulation and the cell grids they share, one grid per body.
template <int Dim>
class Relations {
 public:
    explicit Relations(bodies::World<Dim>& world);
    ~Relations();

    /// The relation of that purpose, made (empty) on first use. Its address stays. Its list keeps
    /// what any of those keep who have asked for it.
    Relation<Dim>& flow(const bodies::Body<Dim>& from, const bodies::Body<Dim>& to, Keeps keeps) {
        return relation(Purpose::flow, from, to, keeps);
    }
    /// The pairs of the body's own particles, made (empty) on first use. Their address stays.
    const PairTiles<Dim>& ownPairs(const bodies::Body<Dim>& body);
    Relation<Dim>& observation(const bodies::Body<Dim>& observer, const bodies::Body<Dim>& to) {
        return relation(Purpose::observation, observer, to, {.distance = true});
    }
    /// Rebuilds what is stale of own pairs and of the relations of flow that have one of the bodies
    /// on either side.
    void update(const std::vector<bodies::Body<Dim>*>& bodies);
    /// Rebuilds this one if it is stale.
    void update(Relation<Dim>& relation);

    /// The relation of the reference configuration, made on first use. Its address stays.
    ReferenceRelation<Dim>& reference(bodies::Body<Dim>& from, bodies::Body<Dim>& to);
    /// Builds its list if it names no particles, or others. Both bodies have a field
    /// initial_position.
    void build(ReferenceRelation<Dim>& relation);

    const bodies::Domain<Dim>& domain() const { return world_->domain; }
    std::size_t bytes() const;

 private:
    struct OwnPairs;
    struct Grid {
        CellGrid<Dim> cells;
        std::uint64_t version = ~std::uint64_t{0};
    };
    Relation<Dim>& relation(Purpose purpose, const bodies::Body<Dim>& from,
                            const bodies::Body<Dim>& to, Keeps keeps);
    const CellGrid<Dim>& grid(const bodies::Body<Dim>& body);

    bodies::World<Dim>* world_;
    std::vector<std::unique_ptr<Relation<Dim>>> relations_;
    std::vector<std::unique_ptr<OwnPairs>> own_pairs_;
    std::vector<std::unique_ptr<ReferenceRelation<Dim>>> references_;
    std::map<const bodies::Body<Dim>*, Grid> grids_;
};

extern template class Relations<2>;
extern template class Relations<3>;

}  // namespace sphinx::neighbors
