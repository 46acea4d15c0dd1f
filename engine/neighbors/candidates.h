// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The search of a list build: which particles may be neighbors of those in one cell, and which of
// these are nearer than the cutoff to one of them.

#include "bodies/world.h"
#include "core/aligned.h"
#include "core/lanes.h"
#include "neighbors/cell_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

namespace sphinx::neighbors {

/// Shifts under which a domain sees its particles: none, and by the periods.
template <int Dim>
class Images {
 public:
    explicit Images(const bodies::Domain<Dim>& domain) {
        shifts_.push_back(Vec<Dim>::Zero());
        for (int k = 0; k < Dim; ++k) {
            if (!domain.periodic[k]) continue;
            const std::size_t n = shifts_.size();
            const double period = domain.bounds.upper[k] - domain.bounds.lower[k];
            for (double s : {-period, period})
                for (std::size_t m = 0; m < n; ++m) {
                    Vec<Dim> shift = shifts_[m];
                    shift[k] = s;
                    shifts_.push_back(shift);
                }
        }
    }
    const std::vector<Vec<Dim>>& shifts() const { return shifts_; }

 private:
    std::vector<Vec<Dim>> shifts_;
};

/// Particles that may be neighbors of those in one cell, with the shift of their image: as records,
/// and by components, which the search runs over.
template <int Dim>
struct Candidates {
    AlignedVector<Site> sites;
    std::array<AlignedVector<double>, Dim> x;
    std::array<AlignedVector<double>, Dim> shift;  // filled only when `shifted`
    AlignedVector<std::int32_t> index;
    std::size_t count = 0;
    bool shifted = false;

    void clear() {
        count = 0;
        shifted = false;
    }
    void reserve(std::size_t n) {
        if (sites.size() >= n + lane_count) return;
        n += n / 2 + 2 * lane_count;
        sites.resize(n);
        for (auto& axis : x) axis.resize(n);
        for (auto& axis : shift) axis.resize(n);
        index.resize(n);
    }
    /// Fills up to a whole vector, so that the search needs no remainder, and takes the records
    /// apart.
    void finish() {
        // Farther than any cutoff, the square still finite.
        constexpr double far_away = 1e150;
        reserve(count);  // where no cell came near, nothing has been reserved yet
        for (std::size_t m = count; m < count + lane_count; ++m) {
            sites[m] = {{far_away, far_away, far_away}, -1};
            for (auto& axis : shift) axis[m] = 0;
        }
        constexpr std::uint32_t next[lane_count] = {0, 1, 2, 3, 4, 5, 6, 7};
        for (std::size_t m = 0; m < count; m += lane_count) {
            Lanes component[4];
            gatherRecords<4>(sites[m].x, next, component);
            for (int k = 0; k < Dim; ++k) storeLanes(component[k], x[k].data() + m);
            storeLanes(component[3], index.data() + m);
        }
    }
};

/// Adds the particles of `to` whose image moved by shift lies in the box.
template <int Dim>
void collect(const CellGrid<Dim>& to, const Vec<Dim>& lower, const Vec<Dim>& upper,
             const Vec<Dim>& shift, Candidates<Dim>& out) {
    std::array<int, Dim> first{};
    std::array<int, Dim> last{};
    for (int k = 0; k < Dim; ++k) {
        // `to` is shifted, so its cells are searched with the box shifted back. Cells that the box
        // only touches are left out: a particle there is a cutoff away, where W and W' vanish.
        constexpr double touch = 1e-9;
        const double a = std::floor((lower[k] - shift[k] - to.origin()[k]) / to.cellSize() + touch);
        const double b = std::floor((upper[k] - shift[k] - to.origin()[k]) / to.cellSize() - touch);
        if (b < 0 || a > to.counts()[k] - 1) return;
        first[k] = static_cast<int>(std::max(a, 0.0));
        last[k] = static_cast<int>(std::min(b, to.counts()[k] - 1.0));
    }
    const bool moved = !shift.isZero(0);
    std::array<int, Dim> row = first;
    for (;;) {
        row[0] = first[0];
        const std::size_t cell = to.cellIndex(row);
        const std::size_t begin = to.start(cell);
        const std::size_t end = to.start(cell + static_cast<std::size_t>(last[0] - first[0]) + 1);
        const std::size_t n = end - begin;
        out.reserve(out.count + n);
        std::copy_n(to.sites() + begin, n, out.sites.data() + out.count);
        for (int k = 0; k < Dim; ++k) {
            if (moved && !out.shifted) std::fill_n(out.shift[k].data(), out.count, 0.0);
            if (moved || out.shifted) std::fill_n(out.shift[k].data() + out.count, n, shift[k]);
        }
        out.shifted = out.shifted || moved;
        out.count += n;
        int k = 1;
        for (; k < Dim; ++k) {
            if (++row[k] <= last[k]) break;
            row[k] = first[k];
        }
        if (k == Dim) break;
    }
}

/// Places of the set bits of a byte, packed to the front: what a comparison of eight lanes selects.
struct PackTable {
    std::uint16_t places[256][lane_count] = {};

    constexpr PackTable() {
        for (unsigned bits = 0; bits < 256; ++bits) {
            int n = 0;
            for (std::uint16_t k = 0; k < lane_count; ++k)
                if (bits & (1u << k)) places[bits][n++] = k;
        }
    }
};
inline constexpr PackTable pack_table;

/// Asks for no particle to be left out; differs from the -1 of padding.
inline constexpr std::int32_t no_particle = -2;

/// Numbers of the candidates nearer than the cutoff, ascending, without a branch. Writes up to
/// lane_count places beyond.
template <bool Shifted, int Dim>
[[gnu::always_inline]] inline std::size_t findNear(const Vec<Dim>& xi, std::int32_t self,
                                                   double cutoff2,
                                                   const Candidates<Dim>& candidates,
                                                   std::uint16_t* found) {
    using Places = std::uint16_t __attribute__((vector_size(16)));
    // Copies: for all that the compiler knows, what is found could be written over the originals.
    const std::size_t candidate_count = candidates.count;
    const std::int32_t* index = candidates.index.data();
    const double* x[Dim];
    const double* shift[Dim];
    for (int k = 0; k < Dim; ++k) {
        x[k] = candidates.x[k].data();
        shift[k] = candidates.shift[k].data();
    }
    std::size_t count = 0;
    for (std::size_t m = 0; m < candidate_count; m += lane_count) {
        const auto squared = [&](int k) {
            Lanes d = xi[k] - loadLanes(x[k] + m);
            if constexpr (Shifted) d -= loadLanes(shift[k] + m);
            return d * d;
        };
        Lanes r2 = squared(0);
        for (int k = 1; k < Dim; ++k) r2 += squared(k);
        const unsigned bits = lessBits(r2, lanes(cutoff2)) & differBits(index + m, self);
        Places places;
        std::memcpy(&places, pack_table.places[bits], sizeof places);
        places += static_cast<std::uint16_t>(m);
        std::memcpy(found + count, &places, sizeof places);
        count += static_cast<std::size_t>(std::popcount(bits));
    }
    return count;
}

}  // namespace sphinx::neighbors
