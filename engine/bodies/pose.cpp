// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "bodies/pose.h"

#include <Eigen/LU>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

namespace sphinx::bodies {
namespace {

/// The rotation Q for which the sum of a . Q b is largest, of the sum S of a b^T.
Mat<2> bestTurn(const Mat<2>& S) {
    const double sine = S(1, 0) - S(0, 1), cosine = S(0, 0) + S(1, 1);
    const double length = std::hypot(sine, cosine);
    if (!(length > 0)) return Mat<2>::Identity();
    Mat<2> Q;
    Q << cosine / length, -sine / length, sine / length, cosine / length;
    return Q;
}
Mat<3> bestTurn(const Mat<3>& S) {
    const Eigen::JacobiSVD<Mat<3>> svd(S, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Vec<3> sizes = svd.singularValues();
    if (!(sizes[1] > 1e-12 * sizes[0])) return Mat<3>::Constant(nan_value);
    const bool mirrors = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0;
    return svd.matrixU() * Vec<3>(1, 1, mirrors ? -1 : 1).asDiagonal() * svd.matrixV().transpose();
}

}  // namespace

template <int Dim>
Pose<Dim> poseOf(const Body<Dim>& body, const BodyPart<Dim>* part, const Domain<Dim>& domain) {
    Pose<Dim> pose;
    const std::size_t size = part ? part->particles.size() : body.size();
    const auto* start = dynamic_cast<const particles::Field<Vec<Dim>>*>(
        body.particles.find(fields::initial_position.name));
    if (size == 0 || !start) return pose;  // nothing moves it
    const auto& position = body.particles.position();
    const auto at = [&](std::size_t n) { return part ? std::size_t{part->particles[n]} : n; };
    // Displacements beside that of the first particle, whichever image of it that is.
    const Vec<Dim> first = position[at(0)] - (*start)[at(0)];
    const auto displacement = [&](std::size_t n) -> Vec<Dim> {
        const Vec<Dim> u = position[at(n)] - (*start)[at(n)];
        return first + domain.difference(u, first);
    };
    bool moved = false;
    Vec<Dim> shift = Vec<Dim>::Zero();
    for (std::size_t n = 0; n < size; ++n) {
        const Vec<Dim> u = displacement(n);
        moved = moved || u != Vec<Dim>::Zero();
        shift += u;
        pose.from += (*start)[at(n)];
    }
    pose.from /= static_cast<double>(size);
    if (!moved) return {};
    pose.to = pose.from + shift / static_cast<double>(size);
    Mat<Dim> sum = Mat<Dim>::Zero();
    for (std::size_t n = 0; n < size; ++n) {
        const Vec<Dim>& R = (*start)[at(n)];
        sum += (R + displacement(n) - pose.to) * (R - pose.from).transpose();
    }
    pose.turn = bestTurn(sum);
    for (std::size_t n = 0; n < size; ++n) {
        const Vec<Dim>& R = (*start)[at(n)];
        pose.misfit = std::max(pose.misfit, (R + displacement(n) - pose(R)).norm());
    }
    if (!pose.turn.allFinite()) pose.misfit = nan_value;
    return pose;
}

template Pose<2> poseOf(const Body<2>&, const BodyPart<2>*, const Domain<2>&);
template Pose<3> poseOf(const Body<3>&, const BodyPart<3>*, const Domain<3>&);

}  // namespace sphinx::bodies
