// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/types.h"

#include <cmath>

namespace sphinx::geometry {

/// Map that keeps angles: p -> to + linear (p - from). The two points, rather than one shift, keep
/// a rotation or mirror about a far centre exact where the arithmetic allows it.
template <int Dim>
struct Similarity {
    Mat<Dim> linear = Mat<Dim>::Identity();  ///< factor times an orthogonal matrix
    Vec<Dim> from = Vec<Dim>::Zero();
    Vec<Dim> to = Vec<Dim>::Zero();
    double factor = 1;  ///< all lengths grow by it, > 0

    Vec<Dim> operator()(const Vec<Dim>& p) const { return to + linear * (p - from); }
    /// Orthogonal part: how directions turn.
    Mat<Dim> turn() const { return linear / factor; }
    /// Axes go to axes: a box stays an axis-aligned box.
    bool keepsAxes() const {
        for (int row = 0; row < Dim; ++row) {
            if ((linear.row(row).array() != 0).count() != 1) return false;
        }
        return true;
    }
};

template <int Dim>
Similarity<Dim> translation(const Vec<Dim>& by) {
    Similarity<Dim> map;
    map.to = by;
    return map;
}

template <int Dim>
Similarity<Dim> scaling(double factor, const Vec<Dim>& center) {
    return {factor * Mat<Dim>::Identity(), center, center, factor};
}

template <int Dim>
Similarity<Dim> mirror(const Vec<Dim>& point, const Vec<Dim>& normal) {
    const Mat<Dim> linear =
        Mat<Dim>::Identity() - (2 / normal.squaredNorm()) * normal * normal.transpose();
    return {linear, point, point, 1};
}

/// Cosine and sine; of quarter turns exactly 0 and +-1, which pi in doubles would miss by 1e-16.
struct Turn {
    double cosine, sine;
    explicit Turn(double angle) : cosine(std::cos(angle)), sine(std::sin(angle)) {
        // The error of k pi/2 in doubles: below 1e-15 for the first full turns.
        if (std::abs(cosine) < 1e-15) cosine = 0, sine = std::copysign(1, sine);
        if (std::abs(sine) < 1e-15) sine = 0, cosine = std::copysign(1, cosine);
    }
};

inline Similarity<2> rotation(double angle, const Vec<2>& center) {
    const Turn turn(angle);
    Mat<2> linear;
    linear << turn.cosine, -turn.sine, turn.sine, turn.cosine;
    return {linear, center, center, 1};
}

/// `axis` of any length but zero.
inline Similarity<3> rotation(double angle, const Vec<3>& center, const Vec<3>& axis) {
    const Turn turn(angle);
    const Vec<3> k = axis / axis.norm();
    Mat<3> turned;
    turned << 0, -k.z(), k.y(), k.z(), 0, -k.x(), -k.y(), k.x(), 0;
    const Mat<3> linear = turn.cosine * Mat<3>::Identity() + turn.sine * turned +
                          (1 - turn.cosine) * k * k.transpose();
    return {linear, center, center, 1};
}

}  // namespace sphinx::geometry
