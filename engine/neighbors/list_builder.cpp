// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "neighbors/list_builder.h"

#include "core/errors.h"
#include "core/exact_sum.h"
#include "core/huge_pages.h"
#include "core/parallel.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <vector>

namespace sphinx {
namespace {

/// Positions beyond the last candidate: farther than any cutoff, their square still finite.
constexpr double far_away = 1e150;

/// Particles that may be neighbors of those in one cell of `from`, with the shift of their image.
template <int Dim>
struct Candidates {
    std::array<AlignedVector<double>, Dim> x;
    std::array<AlignedVector<double>, Dim> shift;  // filled only when `shifted`
    AlignedVector<std::int64_t> index;
    std::size_t count = 0;
    bool shifted = false;

    void clear() {
        count = 0;
        shifted = false;
    }
    void reserve(std::size_t n) {
        if (index.size() >= n + lane_count) return;
        n += n / 2 + lane_count;
        for (auto& axis : x) axis.resize(n);
        for (auto& axis : shift) axis.resize(n);
        index.resize(n);
    }
    /// Fills up to a whole vector, so that the search needs no remainder.
    void pad() {
        reserve(count);  // where no cell came near, nothing has been reserved yet
        for (std::size_t m = count; m < count + lane_count; ++m) {
            for (auto& axis : x) axis[m] = far_away;
            for (auto& axis : shift) axis[m] = 0;
            index[m] = -1;
        }
    }
};

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
constexpr PackTable pack_table;

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
        for (std::size_t m = 0; m < n; ++m) out.index[out.count + m] = to.order()[begin + m];
        out.count += n;
        int k = 1;
        for (; k < Dim; ++k) {
            if (++row[k] <= last[k]) break;
            row[k] = first[k];
        }
        if (k == Dim) break;
    }
}

/// Asks for no particle to be left out; differs from the -1 of padding.
constexpr std::int64_t no_particle = -2;

/// Numbers of the candidates nearer than the cutoff, ascending; without a branch.
template <bool Shifted, int Dim>
std::size_t findNear(const Vec<Dim>& xi, std::int64_t self, double cutoff2,
                     const Candidates<Dim>& candidates, std::uint16_t* found) {
    using Places = std::uint16_t __attribute__((vector_size(16)));
    std::size_t count = 0;
    for (std::size_t m = 0; m < candidates.count; m += lane_count) {
        Lanes r2 = {};
        for (int k = 0; k < Dim; ++k) {
            Lanes d = xi[k] - loadLanes(candidates.x[k].data() + m);
            if constexpr (Shifted) d -= loadLanes(candidates.shift[k].data() + m);
            r2 += d * d;
        }
        LaneMask index;
        std::memcpy(&index, candidates.index.data() + m, sizeof index);
        const unsigned bits = maskBits((r2 < cutoff2) & (index != self));
        Places places;
        std::memcpy(&places, pack_table.places[bits], sizeof places);
        places += static_cast<std::uint16_t>(m);
        std::memcpy(found + count, &places, sizeof places);
        count += static_cast<std::size_t>(std::popcount(bits));
    }
    return count;
}

/// Of w <= 1 over at most a thousand neighbors.
const SumGrid weights_grid(1000);

/// Factors of a kernel that its pairs share.
template <class K, int Dim>
struct Factors {
    Factors(const Kernel<Dim>& kernel, double gradient_unit, double distance_unit)
        : inverse_h(1 / kernel.smoothingLength()),
          value(K::sigma * std::pow(inverse_h, Dim)),
          gradient(kernel.gradientFactor() * value * inverse_h * inverse_h / gradient_unit),
          per_distance_unit(1 / distance_unit) {}

    double inverse_h;
    double value;     // W = value w(q)
    double gradient;  // e W' = gradient_unit gradient (r_i - r_j) dw/q
    double per_distance_unit;
};

/// Writes the blocks of one particle and returns the sum of W. The difference of two positions (and
/// then the shift) is exactly antisymmetric, whichever of the two particles asks.
template <class K, bool Shifted, int Dim, class Real>
double fillBlocks(const Vec<Dim>& xi, const Candidates<Dim>& candidates, std::uint16_t* found,
                  std::size_t n, const Factors<K, Dim>& factors, PairBlock<Dim, Real>* block,
                  std::int32_t* distance) {
    // Places beyond the last neighbor repeat the first one.
    for (std::size_t m = n; m % lane_count != 0; ++m) found[m] = found[0];
    constexpr LaneMask lane = {0, 1, 2, 3, 4, 5, 6, 7};
    ExactSum sum(weights_grid);
    for (std::size_t first = 0; first < n; first += lane_count, ++block) {
        const std::uint16_t* place = found + first;
        Lanes d[Dim];
        Lanes r2 = {};
        for (int c = 0; c < Dim; ++c) {
            d[c] = xi[c] - gatherLanes(candidates.x[c].data(), place);
            if constexpr (Shifted) d[c] -= gatherLanes(candidates.shift[c].data(), place);
            r2 += d[c] * d[c];
        }
        const LaneMask valid = lane < static_cast<std::int64_t>(n - first);
        const Lanes r = sqrtLanes(r2);
        const Lanes q = r * factors.inverse_h;
        const Lanes g = valid ? factors.gradient * K::dwOverQ(q) : Lanes{};
        sum.add(valid ? K::w(q) : Lanes{});
        for (int c = 0; c < Dim; ++c) storeLanes(g * d[c], block->gradient[c]);
        for (int k = 0; k < lane_count; ++k)
            block->index[k] = static_cast<std::uint32_t>(candidates.index[place[k]]);
        if (distance) storeLanes(factors.per_distance_unit * r, distance + first);
    }
    return factors.value * sum.value();
}

/// Unit in which all gradients of a list are whole numbers below 2^31.
template <int Dim>
double wholeUnit(const Kernel<Dim>& kernel) {
    constexpr int samples = 100;
    constexpr double between = 1.01;  // a slope between two samples is nearer to them than that
    double steepest = 0;
    for (int k = 1; k < samples; ++k)
        steepest = std::max(steepest, std::abs(kernel.derivative(kernel.cutoff() * k / samples)));
    return std::ldexp(between * kernel.gradientFactor() * steepest, -31);
}

template <class K, int Dim, class Real>
void build(const CellGrid<Dim>& from, const CellGrid<Dim>& to, bool same, const Kernel<Dim>& kernel,
           const Domain<Dim>& domain, NeighborList<Dim, Real>& list) {
    list.gradient_unit = std::is_integral_v<Real> ? wholeUnit(kernel) : 1;
    const double cutoff = K::reach * kernel.smoothingLength();
    list.cutoff = cutoff;
    const Factors<K, Dim> factors(kernel, list.gradient_unit, list.distanceUnit());
    const double cutoff2 = cutoff * cutoff;
    const Images<Dim> images(domain);
    const std::size_t n = from.particles();
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
            thread_local std::vector<std::uint16_t> found;  // numbers of candidates
            const auto place = [&](std::size_t cell) {
                return static_cast<std::size_t>(slots * static_cast<double>(from.start(cell)));
            };
            std::size_t next = place(cell_begin);
            const std::size_t limit = cell_end == from.cells() ? total : place(cell_end);
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
                candidates.pad();
                if (candidates.count > std::numeric_limits<std::uint16_t>::max())
                    throw PhysicsError("more than 65535 particles in the reach of one cell");
                found.resize(candidates.count + lane_count);

                for (std::size_t s = begin; s < end; ++s) {
                    const Index i = from.order()[s];
                    Vec<Dim> xi;
                    for (int k = 0; k < Dim; ++k) xi[k] = from.sorted(k)[s];
                    const std::int64_t self = same ? std::int64_t{i} : no_particle;
                    const std::size_t count =
                        candidates.shifted
                            ? findNear<true>(xi, self, cutoff2, candidates, found.data())
                            : findNear<false>(xi, self, cutoff2, candidates, found.data());
                    const std::size_t blocks = (count + lane_count - 1) / lane_count;
                    used += blocks;
                    if (next + blocks > limit) {
                        full = true;
                        continue;
                    }
                    list.ranges[i] = {next, static_cast<std::uint32_t>(blocks),
                                      static_cast<std::uint32_t>(count)};
                    const auto fill = candidates.shifted ? fillBlocks<K, true, Dim, Real>
                                                         : fillBlocks<K, false, Dim, Real>;
                    const double sum = fill(
                        xi, candidates, found.data(), count, factors, list.blocks.data() + next,
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
        list.blocks = {};  // nothing of it is needed any more
        list.blocks.resize(static_cast<std::size_t>(std::ceil(slots * static_cast<double>(n))));
        adviseHugePages(list.blocks.data(), list.blocks.size() * sizeof(PairBlock<Dim, Real>));
        slots = static_cast<double>(list.blocks.size()) / static_cast<double>(n);
    }
}

}  // namespace

template <int Dim, class Real>
void buildList(const CellGrid<Dim>& from, const CellGrid<Dim>& to, bool same,
               const Kernel<Dim>& kernel, const Domain<Dim>& domain,
               NeighborList<Dim, Real>& list) {
    withKernel<Dim>(kernel.type(),
                    [&]<class K>() { build<K>(from, to, same, kernel, domain, list); });
}

template void buildList(const CellGrid<2>&, const CellGrid<2>&, bool, const Kernel<2>&,
                        const Domain<2>&, NeighborList<2>&);
template void buildList(const CellGrid<3>&, const CellGrid<3>&, bool, const Kernel<3>&,
                        const Domain<3>&, NeighborList<3>&);
template void buildList(const CellGrid<2>&, const CellGrid<2>&, bool, const Kernel<2>&,
                        const Domain<2>&, NeighborList<2, double>&);
template void buildList(const CellGrid<3>&, const CellGrid<3>&, bool, const Kernel<3>&,
                        const Domain<3>&, NeighborList<3, double>&);

}  // namespace sphinx
