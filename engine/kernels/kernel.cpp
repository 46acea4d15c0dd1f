// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "kernels/kernel.h"

#include <cmath>

namespace sphinx {

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

template <int Dim>
Kernel<Dim>::Kernel(KernelType type, double h, double spacing)
    : type_(type), h_(h), spacing_(spacing) {
    // Sum of V r abs(W')/Dim over the densest lattice with the volume spacing^Dim per point: for an
    // isotropic arrangement that is each diagonal entry of the moment.
    const int n = static_cast<int>(std::ceil(2 * cutoff() / spacing)) + 1;
    double moment = 0;
    for (int k = Dim == 3 ? -n : 0; k <= (Dim == 3 ? n : 0); ++k)
        for (int j = -n; j <= n; ++j)
            for (int i = -n; i <= n; ++i) {
                Vec<3> r;  // of the hexagonal or face-centred cubic lattice, unit edges
                double edge = 0;
                if constexpr (Dim == 2) {
                    r = {i + 0.5 * j, 0.5 * std::sqrt(3.0) * j, 0};
                    edge = std::sqrt(2 / std::sqrt(3.0));
                } else {
                    r = Vec<3>{i + j + 0.0, j + k + 0.0, i + k + 0.0} / std::sqrt(2.0);
                    edge = std::pow(2.0, 1.0 / 6.0);
                }
                const double distance = edge * spacing * r.norm();
                moment -= std::pow(spacing, Dim) * distance * derivative(distance) / Dim;
            }
    gradient_factor_ = 1 / moment;
}

template <int Dim>
double Kernel<Dim>::latticeSum() const {
    const int n = static_cast<int>(std::ceil(cutoff() / spacing_));
    double sum = 0;
    for (int k = Dim == 3 ? -n : 0; k <= (Dim == 3 ? n : 0); ++k)
        for (int j = -n; j <= n; ++j)
            for (int i = -n; i <= n; ++i)
                sum += value(spacing_ * std::sqrt(static_cast<double>(i * i + j * j + k * k)));
    return sum;
}

template class Kernel<2>;
template class Kernel<3>;

}  // namespace sphinx
