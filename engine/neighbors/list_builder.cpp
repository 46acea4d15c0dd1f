// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "neighbors/list_builder.h"

#include "core/errors.h"
#include "core/exact_sum.h"
#include "core/huge_pages.h"
#include "core/parallel.h"
#include "neighbors/candidates.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace sphinx::neighbors {
namespace {

/// Of w <= 1 over at most a thousand neighbors.
const SumGrid weights_grid(1000);

/// Factors of a kernel that its pairs share.
template <class K, int Dim>
struct Factors {
    Factors(const kernels::Kernel<Dim>& kernel, double gradient_unit, double distance_unit)
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
    const double* sites = candidates.sites.data()->x;
    constexpr LaneMask lane = {0, 1, 2, 3, 4, 5, 6, 7};
    ExactSum sum(weights_grid);
    for (std::size_t first = 0; first < n; first += lane_count, ++block) {
        const std::uint16_t* place = found + first;
        Lanes site[4];
        gatherRecords<4>(sites, place, site);
        Lanes d[Dim];
        for (int c = 0; c < Dim; ++c) {
            d[c] = xi[c] - site[c];
            if constexpr (Shifted) d[c] -= gatherLanes(candidates.shift[c].data(), place);
        }
        Lanes r2 = d[0] * d[0];
        for (int c = 1; c < Dim; ++c) r2 += d[c] * d[c];
        const LaneMask valid = lane < static_cast<std::int64_t>(n - first);
        const Lanes r = sqrtLanes(r2);
        const Lanes q = r * factors.inverse_h;
        const Lanes g = valid ? factors.gradient * K::dwOverQ(q) : Lanes{};
        sum.add(valid ? K::w(q) : Lanes{});
        for (int c = 0; c < Dim; ++c) storeLanes(g * d[c], block->gradient[c]);
        storeLanes(site[3], reinterpret_cast<std::int32_t*>(block->index));
        if (distance) storeLanes(factors.per_distance_unit * r, distance + first);
    }
    return factors.value * sum.value();
}

/// Unit in which all gradients of a list are whole numbers below 2^31.
template <int Dim>
double wholeUnit(const kernels::Kernel<Dim>& kernel) {
    constexpr int samples = 100;
    constexpr double between = 1.01;  // a slope between two samples is nearer to them than that
    double steepest = 0;
    for (int k = 1; k < samples; ++k)
        steepest = std::max(steepest, std::abs(kernel.derivative(kernel.cutoff() * k / samples)));
    return std::ldexp(between * kernel.gradientFactor() * steepest, -31);
}

template <class K, int Dim, class Real>
void build(const CellGrid<Dim>& from, const CellGrid<Dim>& to, bool same,
           const kernels::Kernel<Dim>& kernel, const bodies::Domain<Dim>& domain,
           NeighborList<Dim, Real>& list) {
    list.gradient_unit = std::is_integral_v<Real> ? wholeUnit(kernel) : 1;
    const double cutoff = K::reach * kernel.smoothingLength();
    list.cutoff = cutoff;
    const Factors<K, Dim> factors(kernel, list.gradient_unit, list.distanceUnit());
    const double cutoff2 = cutoff * cutoff;
    const Images<Dim> images(domain);
    const std::size_t n = from.particles();
    list.ranges.resize(n);
    if (list.keeps.kernel_sum) list.kernel_sum.resize(n);

    // Every range of cells writes into its own stretch of the buffer: slots blocks per particle.
    // Where that was not enough, all is done again with more.
    double slots = n > 0 ? static_cast<double>(list.blocks.size()) / static_cast<double>(n) : 0;
    for (;;) {
        std::atomic<bool> full = false;
        std::atomic<std::size_t> needed = 0;
        const auto total = static_cast<std::size_t>(slots * static_cast<double>(n));
        if (list.keeps.distance) list.distance.resize(list.blocks.size() * lane_count);

        const auto cells = [&](std::size_t cell_begin, std::size_t cell_end) {
            thread_local Candidates<Dim> candidates;
            thread_local AlignedVector<std::uint16_t> found;  // numbers of candidates
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
                if (candidates.count == 0) {
                    for (std::size_t s = begin; s < end; ++s) {
                        const Index i = from.order()[s];
                        list.ranges[i] = {next, 0, 0};
                        if (list.keeps.kernel_sum) list.kernel_sum[i] = 0;
                    }
                    continue;
                }
                candidates.finish();
                if (candidates.count > std::numeric_limits<std::uint16_t>::max())
                    throw PhysicsError("more than 65535 particles in the reach of one cell");
                found.resize(candidates.count + lane_count);

                const auto particles = [&]<bool Shifted>() {
                    for (std::size_t s = begin; s < end; ++s) {
                        const Index i = from.order()[s];
                        Vec<Dim> xi;
                        for (int k = 0; k < Dim; ++k) xi[k] = from.sites()[s].x[k];
                        const std::size_t count =
                            findNear<Shifted>(xi, same ? static_cast<std::int32_t>(i) : no_particle,
                                              cutoff2, candidates, found.data());
                        const std::size_t blocks = (count + lane_count - 1) / lane_count;
                        used += blocks;
                        if (next + blocks > limit) {
                            full = true;
                            continue;
                        }
                        list.ranges[i] = {next, static_cast<std::uint32_t>(blocks),
                                          static_cast<std::uint32_t>(count)};
                        const double sum = fillBlocks<K, Shifted, Dim, Real>(
                            xi, candidates, found.data(), count, factors, list.blocks.data() + next,
                            list.keeps.distance ? list.distance.data() + next * lane_count
                                                : nullptr);
                        if (list.keeps.kernel_sum) list.kernel_sum[i] = sum;
                        next += blocks;
                    }
                };
                if (candidates.shifted)
                    particles.template operator()<true>();
                else
                    particles.template operator()<false>();
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
               const kernels::Kernel<Dim>& kernel, const bodies::Domain<Dim>& domain,
               NeighborList<Dim, Real>& list) {
    kernels::withKernel<Dim>(kernel.type(),
                             [&]<class K>() { build<K>(from, to, same, kernel, domain, list); });
}

template void buildList(const CellGrid<2>&, const CellGrid<2>&, bool, const kernels::Kernel<2>&,
                        const bodies::Domain<2>&, NeighborList<2>&);
template void buildList(const CellGrid<3>&, const CellGrid<3>&, bool, const kernels::Kernel<3>&,
                        const bodies::Domain<3>&, NeighborList<3>&);
template void buildList(const CellGrid<2>&, const CellGrid<2>&, bool, const kernels::Kernel<2>&,
                        const bodies::Domain<2>&, NeighborList<2, double>&);
template void buildList(const CellGrid<3>&, const CellGrid<3>&, bool, const kernels::Kernel<3>&,
                        const bodies::Domain<3>&, NeighborList<3, double>&);

}  // namespace sphinx::neighbors
