// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/types.h"

#include <numbers>

namespace sphinx::kernels {

enum class KernelType { wendland_c2, cubic_spline, quintic_spline };
/// As cases write it.
const char* kernelName(KernelType type);

/// A smoothing kernel W(r, h) = sigma/h^Dim w(q), q = r/h, with compact support r < rc = reach * h.
/// `w` is the shape and dwOverQ its derivative by q, divided by q: what a gradient is made of, for
/// a difference of positions; whoever has 1/q at hand gives it. T is a number or a vector of them;
/// sigma makes the integral over space 1.
///
/// Wendland C2: w = (1 - q/2)^4 (2q + 1), reach 2; Wendland 1995, doi:10.1007/BF02123482, in the
/// scaling of Dehnen & Aly 2012, doi:10.1111/j.1365-2966.2012.21439.x.
template <int Dim>
struct WendlandC2 {
    static constexpr double reach = 2;
    static constexpr double sigma =
        Dim == 2 ? 7.0 / (4.0 * std::numbers::pi) : 21.0 / (16.0 * std::numbers::pi);
    template <class T>
    static T w(T q) {
        const T a = 1.0 - 0.5 * q;
        const T b = a * a;
        return b * b * (2.0 * q + 1.0);
    }
    template <class T>
    static T dwOverQ(T q) {
        const T a = 1.0 - 0.5 * q;
        return -5.0 * a * a * a;
    }
    template <class T>
    static T dwOverQ(T q, T) {
        return dwOverQ(q);
    }
};

/// Cubic spline (M4), reach 2; Monaghan & Lattanzio 1985, A&A 149, 135.
template <int Dim>
struct CubicSpline {
    static constexpr double reach = 2;
    static constexpr double sigma =
        Dim == 2 ? 10.0 / (7.0 * std::numbers::pi) : 1.0 / std::numbers::pi;
    template <class T>
    static T w(T q) {
        const T a = 2.0 - q;
        const T b = 1.0 - q;
        const T outer = 0.25 * a * a * a;
        return q < 1.0 ? outer - b * b * b : outer;
    }
    template <class T>
    static T dwOverQ(T q, T per_q) {
        const T a = 2.0 - q;
        const T inner = 2.25 * q - 3.0;
        const T outer = -0.75 * a * a * per_q;
        return q < 1.0 ? inner : outer;
    }
    template <class T>
    static T dwOverQ(T q) {
        return dwOverQ<T>(q, 1.0 / q);
    }
};

/// Quintic spline (M6), reach 3; Morris, Fox & Zhu 1997, doi:10.1006/jcph.1997.5776.
template <int Dim>
struct QuinticSpline {
    static constexpr double reach = 3;
    static constexpr double sigma =
        Dim == 2 ? 7.0 / (478.0 * std::numbers::pi) : 1.0 / (120.0 * std::numbers::pi);
    template <class T>
    static T power4(T a) {
        const T b = a * a;
        return b * b;
    }
    template <class T>
    static T positive(T a) {
        const T zero = a - a;
        return a > zero ? a : zero;
    }
    template <class T>
    static T w(T q) {
        const T a = positive<T>(3.0 - q);
        const T b = positive<T>(2.0 - q);
        const T c = positive<T>(1.0 - q);
        return power4(a) * a - 6.0 * power4(b) * b + 15.0 * power4(c) * c;
    }
    template <class T>
    static T dwOverQ(T q, T per_q) {
        const T a = positive<T>(3.0 - q);
        const T b = positive<T>(2.0 - q);
        const T inner = q * q * (120.0 - 50.0 * q) - 120.0;  // of all three powers
        const T outer = (30.0 * power4(b) - 5.0 * power4(a)) * per_q;
        return q < 1.0 ? inner : outer;
    }
    template <class T>
    static T dwOverQ(T q) {
        return dwOverQ<T>(q, 1.0 / q);
    }
};

/// Calls f with the kernel's type: f.template operator()<WendlandC2<Dim>>().
template <int Dim, class F>
decltype(auto) withKernel(KernelType type, F&& f) {
    switch (type) {
        case KernelType::cubic_spline: return f.template operator()<CubicSpline<Dim>>();
        case KernelType::quintic_spline: return f.template operator()<QuinticSpline<Dim>>();
        case KernelType::wendland_c2: break;
    }
    return f.template operator()<WendlandC2<Dim>>();
}

/// A kernel with its smoothing length and the spacing of the particles that it sums over, for
/// places that are not hot.
template <int Dim>
class Kernel {
 public:
    Kernel() = default;
    Kernel(KernelType type, double h, double spacing);

    KernelType type() const { return type_; }
    double smoothingLength() const { return h_; }
    double cutoff() const;              ///< rc, length
    double value(double r) const;       ///< W, 1/length^Dim
    double derivative(double r) const;  ///< dW/dr, 1/length^(Dim+1)
    /// Sum of W over the points of an infinite square (cubic) lattice of that spacing, itself
    /// included: the sum of W0 in guide (54).
    double latticeSum() const;
    /// The same over the points on one side of a row (a plane) of the lattice, that row included:
    /// what a particle of the outermost row of a flat surface has.
    double surfaceSum() const;
    /// What the gradients in lists of moving particles are multiplied by, near 1: it makes the sum
    /// over neighbors exact for a linear field, sum_j V_j r_ij (x) grad W = -I, in the densest
    /// arrangement (hexagonal, face-centred cubic), to which a fluid relaxes. Without it the
    /// pressure at rest is 1.5 % too high at h = 1.3 spacings.
    double gradientFactor() const { return gradient_factor_; }
    /// What sums of pairs for a Laplacian, 2 sum_j V_j (u_j - u_i) abs(W')/r over such gradients,
    /// are multiplied by, near 1: it makes them exact for a quadratic field on the square (cubic)
    /// lattice. Not the densest lattice here: a shear flow lays particles in rows, and rows at the
    /// lattice's distance have its moment across them wherever each of them stands.
    double laplacianFactor() const { return laplacian_factor_; }

 private:
    double latticeSum(int last_row) const;

    KernelType type_ = KernelType::wendland_c2;
    double h_ = 1;
    double spacing_ = 1;
    double gradient_factor_ = 1;
    double laplacian_factor_ = 1;
};

extern template class Kernel<2>;
extern template class Kernel<3>;

}  // namespace sphinx::kernels
