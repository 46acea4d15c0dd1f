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
        return q < K::reach ? K::sigma * K::dw(q) / std::pow(h_, Dim + 1) : 0.0;
    });
}

template <int Dim>
double Kernel<Dim>::latticeSum(double spacing) const {
    const int n = static_cast<int>(std::ceil(cutoff() / spacing));
    double sum = 0;
    for (int k = Dim == 3 ? -n : 0; k <= (Dim == 3 ? n : 0); ++k)
        for (int j = -n; j <= n; ++j)
            for (int i = -n; i <= n; ++i)
                sum += value(spacing * std::sqrt(static_cast<double>(i * i + j * j + k * k)));
    return sum;
}

template class Kernel<2>;
template class Kernel<3>;

}  // namespace sphinx
