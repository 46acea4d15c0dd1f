// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "neighbors/relations.h"

#include "neighbors/common_kernel.h"
#include "neighbors/list_builder.h"
#include "neighbors/pair_tiles.h"

#include <algorithm>
#include <cmath>

namespace sphinx::neighbors {
namespace {

/// Without what rounding has made of multiples of the spacing: equal neighborhoods then have equal
/// bits.
template <int Dim>
Vec<Dim> onLattice(Vec<Dim> R, double spacing) {
    constexpr double rounding = 1e-9;
    for (double& component : R) {
        const double multiple = std::rint(component / spacing) * spacing;
        if (std::abs(component - multiple) < rounding * spacing) component = multiple;
    }
    return R;
}

}  // namespace

/// The pairs of a fluid's own particles where they are now.
template <int Dim>
struct Relations<Dim>::OwnPairs {
    const bodies::Body<Dim>* body = nullptr;
    PairTiles<Dim> tiles;
    std::uint64_t version = ~std::uint64_t{0};  ///< of the body when last built
};

template <int Dim>
Relations<Dim>::Relations(bodies::World<Dim>& world) : world_(&world) {}
template <int Dim>
Relations<Dim>::~Relations() = default;

template <int Dim>
Relation<Dim>& Relations<Dim>::relation(Purpose purpose, const bodies::Body<Dim>& from,
                                        const bodies::Body<Dim>& to, Keeps keeps) {
    const auto same = [&](const auto& r) {
        return r->purpose == purpose && r->from == &from && r->to == &to;
    };
    auto found = std::find_if(relations_.begin(), relations_.end(), same);
    if (found == relations_.end()) {
        relations_.push_back(
            std::make_unique<Relation<Dim>>(Relation<Dim>{purpose, &from, &to, {}}));
        found = relations_.end() - 1;
    }
    Keeps& kept = (*found)->list.keeps;
    kept.distance = kept.distance || keeps.distance;
    kept.kernel_sum = kept.kernel_sum || keeps.kernel_sum;
    return **found;
}

template <int Dim>
const CellGrid<Dim>& Relations<Dim>::grid(const bodies::Body<Dim>& body) {
    Grid& grid = grids_[&body];
    if (grid.version != body.version) {
        grid.cells.build(body.particles.position().data(), body.held(), body.kernel.cutoff());
        grid.version = body.version;
    }
    return grid.cells;
}

template <int Dim>
void Relations<Dim>::update(Relation<Dim>& r) {
    if (r.from_version == r.from->version && r.to_version == r.to->version) return;
    buildList(grid(*r.from), grid(*r.to), r.from == r.to, commonKernel(*r.from, *r.to),
              world_->domain, r.list);
    ++r.builds;
    r.from_version = r.from->version;
    r.to_version = r.to->version;
    r.from_arrangement = r.from->particles.arrangement();
    r.to_arrangement = r.to->particles.arrangement();
}

template <int Dim>
const PairTiles<Dim>& Relations<Dim>::ownPairs(const bodies::Body<Dim>& body) {
    for (const auto& own : own_pairs_)
        if (own->body == &body) return own->tiles;
    own_pairs_.push_back(std::make_unique<OwnPairs>(&body, PairTiles<Dim>(world_->precision)));
    return own_pairs_.back()->tiles;
}

template <int Dim>
void Relations<Dim>::update(const std::vector<bodies::Body<Dim>*>& bodies) {
    const auto named = [&](const bodies::Body<Dim>* body) {
        return std::find(bodies.begin(), bodies.end(), body) != bodies.end();
    };
    for (const auto& r : relations_) {
        if (r->purpose != Purpose::flow) continue;
        if (named(r->from) || named(r->to)) update(*r);
    }
    for (const auto& own : own_pairs_) {
        if (!named(own->body) || own->version == own->body->version) continue;
        own->tiles.build(own->body->particles.position().data(), own->body->held(),
                         own->body->kernel, own->body->spacing, world_->domain);
        own->version = own->body->version;
    }
}

template <int Dim>
ReferenceRelation<Dim>& Relations<Dim>::reference(bodies::Body<Dim>& from, bodies::Body<Dim>& to) {
    for (const auto& r : references_)
        if (r->from == &from && r->to == &to) return *r;
    auto r = std::make_unique<ReferenceRelation<Dim>>();
    r->from = &from;
    r->to = &to;
    references_.push_back(std::move(r));
    return *references_.back();
}

template <int Dim>
void Relations<Dim>::build(ReferenceRelation<Dim>& r) {
    const std::uint64_t from_arrangement = r.from->particles.arrangement();
    const std::uint64_t to_arrangement = r.to->particles.arrangement();
    if (r.from_arrangement == from_arrangement && r.to_arrangement == to_arrangement) return;
    r.list = {};
    const auto cells = [](bodies::Body<Dim>& body) {
        CellGrid<Dim> grid;
        grid.build(body.particles.vector(fields::initial_position).data(), body.held(),
                   body.kernel.cutoff());
        return grid;
    };
    const bool same = r.from == r.to;
    NeighborList<Dim, double> list;
    buildList(cells(*r.from), cells(*r.to), same, commonKernel(*r.from, *r.to), world_->domain,
              list);
    const particles::Field<double>& volume = r.to->particles.scalar(fields::volume);
    const auto& from = r.from->particles.vector(fields::initial_position);
    const auto& to = r.to->particles.vector(fields::initial_position);
    const kernels::Kernel<Dim>& kernel = commonKernel(*r.from, *r.to);
    const double spacing = std::min(r.from->spacing, r.to->spacing);
    std::vector<typename ReferenceList<Dim>::Neighbor> neighbors;
    for (std::size_t i = 0; i < r.from->size(); ++i) {
        const int lane = static_cast<int>(i % lane_count);
        for (const auto& block : list.of(i)) {
            for (int k = 0; k < lane_count; ++k) {
                const Index j = block.index[k];
                Vec<Dim> g;
                for (int c = 0; c < Dim; ++c) g[c] = block.gradient[c][k];
                if (g.isZero(0)) continue;
                const Vec<Dim> R = onLattice(world_->domain.difference(from[i], to[j]), spacing);
                const double slope =
                    kernel.gradientFactor() * kernel.derivative(R.norm()) / R.norm() * volume[j];
                // Each side bears half of a bond's energy, as far as it is material.
                const double share = 0.5 * (r.from->elastic().share(i) + r.to->elastic().share(j));
                neighbors.push_back({lane, j, slope * R, -share * slope});
            }
        }
        if (lane == lane_count - 1 || i + 1 == r.from->size()) {
            r.list.append(neighbors, r.to->held());
            neighbors.clear();
        }
    }
    r.list.finish();
    r.from_arrangement = from_arrangement;
    r.to_arrangement = to_arrangement;
}

template <int Dim>
std::size_t Relations<Dim>::bytes() const {
    std::size_t sum = 0;
    for (const auto& r : references_) sum += r->list.bytes();
    for (const auto& r : relations_) sum += r->list.bytes();
    for (const auto& own : own_pairs_) sum += own->tiles.bytes();
    for (const auto& [body, grid] : grids_) sum += grid.cells.bytes();
    return sum;
}

template class Relations<2>;
template class Relations<3>;

}  // namespace sphinx::neighbors
