// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "neighbors/relations.h"

#include "neighbors/list_builder.h"

#include <algorithm>

namespace sphinx {

template <int Dim>
Relation<Dim>& Relations<Dim>::relation(Body<Dim>& from, Body<Dim>& to) {
    for (const auto& r : relations_)
        if (r->from == &from && r->to == &to) return *r;
    auto r = std::make_unique<Relation<Dim>>();
    r->from = &from;
    r->to = &to;
    relations_.push_back(std::move(r));
    return *relations_.back();
}

template <int Dim>
const CellGrid<Dim>& Relations<Dim>::grid(Body<Dim>& body) {
    Grid& grid = grids_[&body];
    if (grid.version != body.version) {
        grid.cells.build(body.particles.position().data(), body.size(), body.kernel.cutoff());
        grid.version = body.version;
    }
    return grid.cells;
}

template <int Dim>
void Relations<Dim>::update(Relation<Dim>& r) {
    if (r.from_version == r.from->version && r.to_version == r.to->version) return;
    // Both directions of a pair of different smoothing lengths use the larger.
    const Kernel<Dim>& kernel =
        r.from->kernel.smoothingLength() >= r.to->kernel.smoothingLength() ? r.from->kernel
                                                                            : r.to->kernel;
    buildList(grid(*r.from), grid(*r.to), r.from == r.to, kernel, world_->domain, r.list);
    r.from_version = r.from->version;
    r.to_version = r.to->version;
}

template <int Dim>
void Relations<Dim>::update(const std::vector<Body<Dim>*>& bodies) {
    const auto named = [&](const Body<Dim>* body) {
        return std::find(bodies.begin(), bodies.end(), body) != bodies.end();
    };
    for (const auto& r : relations_) {
        if (r->from->kind == BodyKind::observer) continue;
        if (named(r->from) || named(r->to)) update(*r);
    }
}

template <int Dim>
std::size_t Relations<Dim>::bytes() const {
    std::size_t sum = 0;
    for (const auto& r : relations_) sum += r->list.bytes();
    for (const auto& [body, grid] : grids_) sum += grid.cells.bytes();
    return sum;
}

template class Relations<2>;
template class Relations<3>;

}  // namespace sphinx
