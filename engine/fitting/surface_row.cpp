// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "fitting/surface_row.h"

#include <Eigen/LU>
#include <cmath>

namespace sphinx::fitting {
namespace {

constexpr int most_turns = 8;
/// Of the cosine of two normals: of one face that is curved, or of two.
constexpr double same_face = 0.8;
/// In spacings: how near to the row is on it.
constexpr double on_row = 1e-6;
/// Of the Gram determinant of the normals: of faces so nearly parallel that they have no common
/// line within reach.
constexpr double parallel = 1e-4;

}  // namespace

template <int Dim>
void SurfaceRow<Dim>::Planes::add(const Plane& one) {
    int nearest = 0;
    for (int k = 1; k < count; ++k)
        if (plane[k].n.dot(one.n) > plane[nearest].n.dot(one.n)) nearest = k;
    if (count > 0 && (count == Dim || plane[nearest].n.dot(one.n) > same_face))
        plane[nearest] = one;
    else
        plane[count++] = one;
}

template <int Dim>
Vec<Dim> SurfaceRow<Dim>::Planes::nearest(const Vec<Dim>& x) const {
    std::array<double, Dim> miss{};
    for (int k = 0; k < count; ++k) miss[k] = plane[k].c - plane[k].n.dot(x);
    if (count == 1) return x + miss[0] * plane[0].n;
    const double cosine = plane[0].n.dot(plane[1].n);
    const double gram = 1 - cosine * cosine;
    if (count == 2 || gram < parallel) {
        if (gram < parallel)  // between them
            return x + 0.5 * (miss[0] * plane[0].n + miss[1] * plane[1].n);
        const double first = (miss[0] - cosine * miss[1]) / gram;
        const double second = (miss[1] - cosine * miss[0]) / gram;
        return x + (first * plane[0].n + second * plane[1].n);
    }
    Mat<Dim> normals;
    Vec<Dim> misses;
    for (int k = 0; k < Dim; ++k) {
        normals.row(k) = plane[k].n.transpose();
        misses[k] = miss[k];
    }
    if (std::abs(normals.determinant()) < std::sqrt(parallel))
        return x + 0.5 * (miss[0] * plane[0].n + miss[1] * plane[1].n);
    return x + normals.inverse() * misses;
}

template <int Dim>
Vec<Dim> SurfaceRow<Dim>::place(const Vec<Dim>& x, double depth) const {
    Planes planes;
    Vec<Dim> y = x;
    for (int turn = 0; turn < most_turns; ++turn) {
        const double miss = depth + shape_->signedDistance(y);
        if (turn == 0 ? miss == 0 : miss <= on_row * spacing_) break;
        const Vec<Dim> n = shape_->normal(y);
        planes.add({n, n.dot(y) - miss});
        y = planes.nearest(x);
    }
    return y;
}

template class SurfaceRow<2>;
template class SurfaceRow<3>;

}  // namespace sphinx::fitting
