// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "neighbors/list_builder.h"

#include "core/parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

namespace sphinx {
namespace {

/// Particles that may be neighbors of those in one cell of `from`, with the shift of their image.
template <int Dim>
struct Candidates {
    std::array<AlignedVector<double>, Dim> x;
    std::array<AlignedVector<double>, Dim> shift;  // filled only when `shifted`
    AlignedVector<Index> index;
    std::size_t count = 0;
    bool shifted = false;

    void clear() {
        count = 0;
        shifted = false;
    }

    void reserve(std::size_t n) {
        if (index.size() >= n) return;
        n += n / 2 + lane_count;
        for (auto& axis : x) axis.resize(n);
        for (auto& axis : shift) axis.resize(n);
        index.resize(n);
    }
};

/// Neighbors of one particle before they go into blocks.
template <int Dim>
struct Found {
    std::array<AlignedVector<double>, Dim> d;
    AlignedVector<double> r2;
    AlignedVector<Index> index;

    void reserve(std::size_t n) {
        if (index.size() >= n) return;
        n += n / 2 + 2 * lane_count;
        for (auto& axis : d) axis.resize(n);
        r2.resize(n);
        index.resize(n);
    }
};

template <int Dim>
class Images {
   public:
    explicit Images(const Domain<Dim>& domain) {
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
        for (int k = 0; k < Dim; ++k) {
            std::copy_n(to.sorted(k) + begin, n, out.x[k].data() + out.count);
            if (moved && !out.shifted) std::fill_n(out.shift[k].data(), out.count, 0.0);
            if (moved || out.shifted) std::fill_n(out.shift[k].data() + out.count, n, shift[k]);
        }
        out.shifted = out.shifted || moved;
        std::copy_n(to.order().data() + begin, n, out.index.data() + out.count);
        out.count += n;
        int k = 1;
        for (; k < Dim; ++k) {
            if (++row[k] <= last[k]) break;
            row[k] = first[k];
        }
        if (k == Dim) break;
    }
}

constexpr Index no_particle = std::numeric_limits<Index>::max();

/// The candidates nearer than the cutoff, without a branch. The difference of two positions (and
/// then the shift) is exactly antisymmetric, whichever of the two particles asks.
template <bool Shifted, int Dim>
std::size_t findNear(const Vec<Dim>& xi, Index self, double cutoff2,
                 const Candidates<Dim>& candidates, Found<Dim>& found) {
    std::size_t count = 0;
    for (std::size_t m = 0; m < candidates.count; ++m) {
        double r2 = 0;
        for (int k = 0; k < Dim; ++k) {
            double d = xi[k] - candidates.x[k][m];
            if constexpr (Shifted) d -= candidates.shift[k][m];
            found.d[k][count] = d;
            r2 += d * d;
        }
        found.r2[count] = r2;
        found.index[count] = candidates.index[m];
        count += (r2 < cutoff2) & (candidates.index[m] != self);
    }
    return count;
}

/// Writes the blocks of one particle and returns the sum of W.
template <class K, int Dim, class Real>
double fillBlocks(const Found<Dim>& found, std::size_t n, double h, double gradient_factor,
                  PairBlock<Dim, Real>* block, float* distance) {
    const double sigma = K::sigma / std::pow(h, Dim);
    const double factor = gradient_factor * sigma / h;
    const double inverse_h = 1 / h;
    double sum = 0;
    const std::size_t blocks = (n + lane_count - 1) / lane_count;
    for (std::size_t b = 0; b < blocks; ++b) {
        const std::size_t first = b * lane_count;
        double w[lane_count];
#pragma omp simd
        for (int k = 0; k < lane_count; ++k) {
            const double r = std::sqrt(found.r2[first + k]);
            const double q = r * inverse_h;
            const double valid = first + k < n ? 1.0 : 0.0;
            const double g = valid * factor * K::dw(q) / (r > 0 ? r : 1.0);
            for (int c = 0; c < Dim; ++c)
                block[b].gradient[c][k] = static_cast<Real>(g * found.d[c][first + k]);
            block[b].index[k] = found.index[first + k];
            w[k] = valid * K::w(q);
            if (distance) distance[first + k] = static_cast<float>(r);
        }
        for (double value : w) sum += value;
    }
    return sum * sigma;
}

template <class K, int Dim, class Real>
void build(const CellGrid<Dim>& from, const CellGrid<Dim>& to, bool same,
           const Kernel<Dim>& kernel, const Domain<Dim>& domain,
           NeighborList<Dim, Real>& list) {
    const double h = kernel.smoothingLength();
    const double cutoff = K::reach * h;
    const double cutoff2 = cutoff * cutoff;
    const Images<Dim> images(domain);
    const std::size_t n = from.particles();
    list.cutoff = cutoff;
    list.ranges.resize(n);
    if (list.keep_kernel_sum) list.kernel_sum.resize(n);

    // Every range of cells writes into its own stretch of the buffer: slots blocks per particle.
    // Where that was not enough, all is done again with more.
    double slots = n > 0 ? static_cast<double>(list.blocks.size()) / static_cast<double>(n) : 0;
    for (;;) {
        std::atomic<bool> full = false;
        std::atomic<std::size_t> needed = 0;
        const auto total = static_cast<std::size_t>(slots * static_cast<double>(n));
        if (list.keep_distance) list.distance.resize(list.blocks.size() * lane_count);

        const auto cells = [&](std::size_t cell_begin, std::size_t cell_end) {
            thread_local Candidates<Dim> candidates;
            thread_local Found<Dim> found;
            const auto place = [&](std::size_t cell) {
                return static_cast<std::size_t>(slots * static_cast<double>(from.start(cell)));
            };
            std::size_t next = place(cell_begin);
            const std::size_t limit =
                cell_end == from.cells() ? total : place(cell_end);
            std::size_t used = 0;
            for (std::size_t cell = cell_begin; cell < cell_end; ++cell) {
                const std::size_t begin = from.start(cell);
                const std::size_t end = from.start(cell + 1);
                if (begin == end) continue;
                const auto c = from.cellCoordinates(cell);
                Vec<Dim> lower;
                for (int k = 0; k < Dim; ++k) lower[k] = from.origin()[k] + c[k] * from.cellSize();
                const Vec<Dim> box_lower = lower.array() - cutoff;
                const Vec<Dim> box_upper = lower.array() + (from.cellSize() + cutoff);
                candidates.clear();
                for (const Vec<Dim>& shift : images.shifts())
                    collect(to, box_lower, box_upper, shift, candidates);
                found.reserve(candidates.count);

                for (std::size_t s = begin; s < end; ++s) {
                    const Index i = from.order()[s];
                    Vec<Dim> xi;
                    for (int k = 0; k < Dim; ++k) xi[k] = from.sorted(k)[s];
                    const Index self = same ? i : no_particle;
                    const std::size_t count =
                        candidates.shifted ? findNear<true>(xi, self, cutoff2, candidates, found)
                                           : findNear<false>(xi, self, cutoff2, candidates, found);
                    const std::size_t blocks = (count + lane_count - 1) / lane_count;
                    used += blocks;
                    if (next + blocks > limit) {
                        full = true;
                        continue;
                    }
                    for (std::size_t m = count; m < blocks * lane_count; ++m) {
                        for (int k = 0; k < Dim; ++k) found.d[k][m] = 0;
                        found.r2[m] = 0;
                        found.index[m] = found.index[0];
                    }
                    list.ranges[i] = {next, static_cast<std::uint32_t>(blocks),
                                      static_cast<std::uint32_t>(count)};
                    const double sum = fillBlocks<K, Dim, Real>(
                        found, count, h, kernel.gradientFactor(), list.blocks.data() + next,
                        list.keep_distance ? list.distance.data() + next * lane_count : nullptr);
                    if (list.keep_kernel_sum) list.kernel_sum[i] = sum;
                    next += blocks;
                }
            }
            needed += used;
        };
        parallelRanges(from.cells(), cells, 64);
        if (!full) return;
        slots = std::max(1.2 * slots, 1.2 * static_cast<double>(needed) / static_cast<double>(n));
        list.blocks.resize(static_cast<std::size_t>(std::ceil(slots * static_cast<double>(n))));
        slots = static_cast<double>(list.blocks.size()) / static_cast<double>(n);
    }
}

}  // namespace

template <int Dim, class Real>
void buildList(const CellGrid<Dim>& from, const CellGrid<Dim>& to, bool same,
               const Kernel<Dim>& kernel, const Domain<Dim>& domain,
               NeighborList<Dim, Real>& list) {
    withKernel<Dim>(kernel.type(), [&]<class K>() {
        build<K>(from, to, same, kernel, domain, list);
    });
}

template void buildList(const CellGrid<2>&, const CellGrid<2>&, bool, const Kernel<2>&,
                        const Domain<2>&, NeighborList<2, float>&);
template void buildList(const CellGrid<3>&, const CellGrid<3>&, bool, const Kernel<3>&,
                        const Domain<3>&, NeighborList<3, float>&);
template void buildList(const CellGrid<2>&, const CellGrid<2>&, bool, const Kernel<2>&,
                        const Domain<2>&, NeighborList<2, double>&);
template void buildList(const CellGrid<3>&, const CellGrid<3>&, bool, const Kernel<3>&,
                        const Domain<3>&, NeighborList<3, double>&);

}  // namespace sphinx
