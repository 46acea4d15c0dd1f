// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "geometry/orientation.h"

#include <cmath>

// J. R. Shewchuk, Adaptive precision floating-point arithmetic and fast robust geometric
// predicates, Discrete Comput. Geom. 18 (1997) 305-363, doi:10.1007/PL00009321.

namespace sphinx::geometry {
namespace {

/// A sum of doubles without rounding, as non-overlapping terms of growing size.
class ExactSum {
 public:
    void add(double value) {
        for (int i = 0; i < size_; ++i) {
            const double sum = value + term_[i];
            const double part = sum - value;
            term_[i] = (value - (sum - part)) + (term_[i] - part);
            value = sum;
        }
        term_[size_++] = value;
    }
    void addProduct(double a, double b) {
        const double product = a * b;
        add(std::fma(a, b, -product));
        add(product);
    }
    int sign() const {
        for (int i = size_ - 1; i >= 0; --i) {
            if (term_[i] != 0) return term_[i] > 0 ? 1 : -1;
        }
        return 0;
    }

 private:
    double term_[16];
    int size_ = 0;
};

/// a - b as the rounded difference and what the rounding lost.
struct Difference {
    double value, lost;
    Difference(double a, double b) : value(a - b) {
        const double part = a - value;
        lost = (a - (value + part)) + (part - b);
    }
};

void addProduct(ExactSum& sum, const Difference& a, const Difference& b, double sign) {
    sum.addProduct(sign * a.lost, b.lost);
    sum.addProduct(sign * a.lost, b.value);
    sum.addProduct(sign * a.value, b.lost);
    sum.addProduct(sign * a.value, b.value);
}

int exactOrientation(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) {
    const Difference ax(a.x(), c.x()), ay(a.y(), c.y()), bx(b.x(), c.x()), by(b.y(), c.y());
    ExactSum sum;
    addProduct(sum, ax, by, 1);
    addProduct(sum, ay, bx, -1);
    return sum.sign();
}

}  // namespace

int orientation(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) {
    const double left = (a.x() - c.x()) * (b.y() - c.y());
    const double right = (a.y() - c.y()) * (b.x() - c.x());
    const double determinant = left - right;
    // Shewchuk's bound is (3 + 16 u) u with u = 2^-53, that is 3.4e-16; fusing only lowers the
    // error.
    const double bound = 4e-16 * (std::abs(left) + std::abs(right));
    if (determinant > bound) return 1;
    if (determinant < -bound) return -1;
    return exactOrientation(a, b, c);
}

}  // namespace sphinx::geometry
