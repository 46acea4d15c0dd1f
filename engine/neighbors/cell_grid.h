// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aligned.h"
#include "core/types.h"

#include <array>

namespace sphinx::neighbors {

/// A particle as the search for neighbors reads it, at one go.
struct alignas(32) Site {
    double x[3];   ///< position; in 2D the last is 0
    double index;  ///< of the particle, exact
};

/// Particles of one body binned into cubic cells, x fastest. Within a cell particles stand in
/// storage order, so the bins are a function of the state alone.
template <int Dim>
class CellGrid {
 public:
    /// Bins n particles into cells of the given size over their bounding box. Throws PhysicsError
    /// when a position is not finite.
    void build(const Vec<Dim>* position, std::size_t n, double cell_size);

    std::size_t particles() const { return order_.size(); }
    std::size_t cells() const { return start_.empty() ? 0 : start_.size() - 1; }
    double cellSize() const { return size_; }
    const Vec<Dim>& origin() const { return origin_; }
    const std::array<int, Dim>& counts() const { return counts_; }

    std::array<int, Dim> cellCoordinates(std::size_t cell) const;
    std::size_t cellIndex(const std::array<int, Dim>& c) const;

    /// Particles of cell c are order()[start(c)] .. order()[start(c + 1) - 1].
    std::size_t start(std::size_t cell) const { return start_[cell]; }
    const AlignedVector<Index>& order() const { return order_; }
    /// The particles in the order of order().
    const Site* sites() const { return sites_.data(); }

    std::size_t bytes() const;

 private:
    double size_ = 0;
    Vec<Dim> origin_ = Vec<Dim>::Zero();
    std::array<int, Dim> counts_{};
    AlignedVector<std::uint32_t> start_;
    AlignedVector<Index> cell_of_;
    AlignedVector<Index> order_;
    AlignedVector<Site> sites_;
};

extern template class CellGrid<2>;
extern template class CellGrid<3>;

}  // namespace sphinx::neighbors
