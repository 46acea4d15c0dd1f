// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "fitting/kernel_gradient.h"

#include "core/exact_sum.h"
#include "core/parallel.h"
#include "core/records.h"

#include <cmath>
#include <numbers>

namespace sphinx::fitting {
namespace {

/// Of the sums: no arrangement has as much.
constexpr double bound_of_reference = 64;
/// Of the lists, in spacings.
constexpr double room = 0.3;

template <int Dim, class Term>
double latticeSum(double spacing, double reach, Term&& term) {
    const int n = static_cast<int>(std::ceil(reach / spacing));
    const int depth = Dim == 3 ? n : 0;
    double sum = 0;
    for (int k = -depth; k <= depth; ++k)
        for (int j = -n; j <= n; ++j)
            for (int i = -n; i <= n; ++i) {
                if (i == 0 && j == 0 && k == 0) continue;
                sum += term(std::array<int, 3>{i, j, k});
            }
    return sum;
}

/// The largest change of the sum of a particle in the lattice, over the displacement, by waves of
/// displacements along x that alternate from point to point along one axis or several: of all waves
/// these change the sums most.
template <int Dim>
double stiffnessOf(const kernels::Kernel<Dim>& kernel, double spacing) {
    double largest = 0;
    for (int alternates = 1; alternates < (1 << Dim); ++alternates)
        largest = std::max(
            largest,
            std::abs(latticeSum<Dim>(spacing, kernel.cutoff(), [&](const std::array<int, 3>& at) {
                int way = 0;
                for (int k = 0; k < Dim; ++k)
                    if (alternates >> k & 1) way += at[static_cast<std::size_t>(k)];
                if (way % 2 == 0) return 0.0;
                const double r =
                    spacing *
                    std::sqrt(static_cast<double>(at[0] * at[0] + at[1] * at[1] + at[2] * at[2]));
                const double x = spacing * at[0];
                const double step = 1e-4 * spacing;
                const double second =
                    (kernel.derivative(r + step) - kernel.derivative(r - step)) / (2 * step);
                const double first = kernel.derivative(r) / r;
                const double along = x * x / (r * r);
                return 2 * std::pow(spacing, Dim) * (second * along + first * (1 - along));
            })));
    return largest;
}

/// Integral of the slope of the kernel over a half space, whose edge is at its centre.
template <int Dim>
double halfSpace(const kernels::Kernel<Dim>& kernel) {
    // Minus the derivative of what of the kernel lies beyond a plane: its integral over the plane.
    constexpr int steps = 2000;
    const double dr = kernel.cutoff() / steps;
    double sum = 0;
    for (int k = 0; k < steps; ++k) {
        const double r = (k + 0.5) * dr;
        sum += (Dim == 2 ? 2 : 2 * std::numbers::pi * r) * kernel.value(r) * dr;
    }
    return sum;
}

}  // namespace

template <int Dim>
KernelGradient<Dim>::KernelGradient(const geometry::Shape<Dim>& shape,
                                    const particles::Lattice<Dim>& lattice,
                                    const kernels::Kernel<Dim>& kernel)
    : kernel_(kernel),
      reference_(halfSpace(kernel)),
      stiffness_(stiffnessOf(kernel, lattice.spacing)),
      outside_(outsideOf(shape, lattice, kernel.cutoff())),
      list_(kernel.cutoff(), room * lattice.spacing, outside_.place) {}

template <int Dim>
void KernelGradient<Dim>::compute(const AlignedVector<Vec<Dim>>& position,
                                  const AlignedVector<std::uint8_t>& moved, double volume,
                                  AlignedVector<Vec<Dim>>& gradient) {
    const std::size_t n = position.size();
    list_.update(position);
    gradient.resize(n);
    const auto source = [](const Vec<Dim>& x, double of) {
        return Source{{x[0], x[1], Dim == 3 ? x[Dim - 1] : 0}, of};
    };
    if (sources_.size() != n + outside_.place.size()) {
        sources_.resize(n + outside_.place.size());
        for (std::size_t k = 0; k < outside_.place.size(); ++k)
            sources_[n + k] = source(outside_.place[k], outside_.volume[k]);
    }
    parallelFor(n, [&](std::size_t i) { sources_[i] = source(position[i], volume); });
    kernels::withKernel<Dim>(kernel_.type(), [&]<class K>() { sum<K>(moved, gradient); });
}

template <int Dim>
template <class K>
void KernelGradient<Dim>::sum(const AlignedVector<std::uint8_t>& moved,
                              AlignedVector<Vec<Dim>>& gradient) {
    const double per_h = 1 / kernel_.smoothingLength();
    const double factor = -K::sigma * std::pow(per_h, Dim + 2);
    const SumGrid grid(bound_of_reference * reference_ / -factor);
    list_.forEachStirred(moved, [&](Index i, const Index* neighbors, std::size_t count) {
        ExactSums<Dim> sums(grid);
        const Source at = sources_[i];
        for (std::size_t first = 0; first < count; first += lane_count) {
            Lanes other[4];
            gatherRecords<4>(sources_.data()->x, neighbors + first, other);
            Lanes d[Dim];
            for (int k = 0; k < Dim; ++k) d[k] = at.x[k] - other[k];
            Lanes r2 = d[0] * d[0];
            for (int k = 1; k < Dim; ++k) r2 += d[k] * d[k];
            // At its reach the kernel has no slope.
            const Lanes q = minLanes(sqrtLanes(r2) * per_h, lanes(K::reach));
            const Lanes slope = other[3] * K::dwOverQ(q);
            for (int k = 0; k < Dim; ++k) sums[k].addProduct(slope, d[k]);
        }
        for (int k = 0; k < Dim; ++k) gradient[i][k] = factor * sums[k].value();
    });
}

template class KernelGradient<2>;
template class KernelGradient<3>;

}  // namespace sphinx::fitting
