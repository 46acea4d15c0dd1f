// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/declare.h"
#include "neighbors/cell_grid.h"

namespace sphinx::dynamics::particles {

struct SortParameters {
    input::Name body;
};

/// Reorders the particles of a body cell by cell, so that neighbors in space are neighbors in
/// memory: in 2D by the cells of the lists, in 3D, where the particles around such a cell fill the
/// first cache, by rows of single particles. Changes no value; lists of the body must be rebuilt
/// afterwards.
template <int Dim>
class Sort final : public Method {
 public:
    explicit Sort(Body<Dim>& body) : body_(&body) {}

    void run(const Clock& clock);
    std::size_t workSize() const override { return body_->size(); }

 private:
    Body<Dim>* body_;
    sphinx::neighbors::CellGrid<Dim> grid_;
};

/// Registers particles.sort.
void declareSort(input::Registry& registry);

}  // namespace sphinx::dynamics::particles
