// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "kernels/kernel.h"

#include <cmath>

namespace sphinx::kernels {

const char* kernelName(KernelType type) {
    switch (type) {
        case KernelType::cubic_spline: return "cubic_spline";
        case KernelType::quintic_spline: return "quintic_spline";
        case KernelType::wendland_c2: break;
    }
    return "wendland_c2";
}

template <int Dim>
double Kernel<Dim>::cutoff() const {
    return withKernel<Dim>(type_, [&]<class K>() { return K::reach * h_; });
}

template <int Dim>
double Kernel<Dim>::value(double r) const {
    return withKernel<Dim>(type_, [&]<class K>() {
        const double q = r / h_;
        return q < K::reach ? K::sigma * K::w(q) / std::pow(h_, Dim) : 0.0;
    });
}

template <int Dim>
double Kernel<Dim>::derivative(double r) const {
    return withKernel<Dim>(type_, [&]<class K>() {
        const double q = r / h_;
        return q > 0 && q < K::reach ? K::sigma * q * K::dwOverQ(q) / std::pow(h_, Dim + 1) : 0.0;
    });
}

namespace {

/// Point of the lattice at whole coordinates, with the volume 1 per point.
template <int Dim>
Vec<3> squarePoint(int i, int j, int k) {
    return Vec<3>(i, j, k);
}
/// Hexagonal (face-centred cubic): the densest.
template <int Dim>
Vec<3> densestPoint(int i, int j, int k) {
    if constexpr (Dim == 2)
        return std::sqrt(2 / std::sqrt(3.0)) * Vec<3>(i + 0.5 * j, 0.5 * std::sqrt(3.0) * j, 0);
    return std::pow(2.0, 1.0 / 6.0) / std::sqrt(2.0) * Vec<3>(i + j, j + k, i + k);
}

/// Sum of V r abs(W')/Dim over a lattice. That is each diagonal entry of -sum_j V_j r_ij (x) grad
/// W, and what the sum of pairs for the Laplacian of a quadratic field gives of it.
template <int Dim, class Point>
double latticeMoment(const Kernel<Dim>& kernel, double spacing, Point&& point) {
    // The lattices are at least half as far apart along each axis as their coordinates say.
    const int n = static_cast<int>(std::ceil(2 * kernel.cutoff() / spacing)) + 1;
    double moment = 0;
    for (int k = Dim == 3 ? -n : 0; k <= (Dim == 3 ? n : 0); ++k)
        for (int j = -n; j <= n; ++j)
            for (int i = -n; i <= n; ++i) {
                const double r = spacing * point(i, j, k).norm();
                moment -= std::pow(spacing, Dim) * r * kernel.derivative(r) / Dim;
            }
    return moment;
}

}  // namespace

template <int Dim>
Kernel<Dim>::Kernel(KernelType type, double h, double spacing)
    : type_(type),
      h_(h),
      spacing_(spacing),
      gradient_factor_(1 / latticeMoment<Dim>(*this, spacing, densestPoint<Dim>)),
      laplacian_factor_(
          1 / (gradient_factor_ * latticeMoment<Dim>(*this, spacing, squarePoint<Dim>))) {}

template <int Dim>
double Kernel<Dim>::latticeSum() const {
    return latticeSum(static_cast<int>(std::ceil(cutoff() / spacing_)));
}

template <int Dim>
double Kernel<Dim>::surfaceSum() const {
    return latticeSum(0);
}

/// Over the rows up to that one.
template <int Dim>
double Kernel<Dim>::latticeSum(int last_row) const {
    const int n = static_cast<int>(std::ceil(cutoff() / spacing_));
    double sum = 0;
    for (int k = Dim == 3 ? -n : 0; k <= (Dim == 3 ? n : 0); ++k)
        for (int j = -n; j <= last_row; ++j)
            for (int i = -n; i <= n; ++i)
                sum += value(spacing_ * std::sqrt(static_cast<double>(i * i + j * j + k * k)));
    return sum;
}

template class Kernel<2>;
template class Kernel<3>;

}  // namespace sphinx::kernels
