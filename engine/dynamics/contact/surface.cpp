// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/contact/surface.h"

#include "core/parallel.h"

#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>

namespace sphinx::dynamics::contact {
namespace {

/// The skew matrix S for which the sum of abs(v - S r)^2 is least, of the sums of v r^T and r r^T.
Mat<2> skewOf(const Mat<2>& vr, const Mat<2>& rr) {
    const double rate = rr.trace() > 0 ? (vr(1, 0) - vr(0, 1)) / rr.trace() : 0;
    return Mat<2>{{0, -rate}, {rate, 0}};
}
Mat<3> skewOf(const Mat<3>& vr, const Mat<3>& rr) {
    const Vec<3> moment(vr(2, 1) - vr(1, 2), vr(0, 2) - vr(2, 0), vr(1, 0) - vr(0, 1));
    const Mat<3> inertia = rr.trace() * Mat<3>::Identity() - rr;
    const Vec<3> w = inertia.completeOrthogonalDecomposition().solve(moment);
    return Mat<3>{{0, -w[2], w[1]}, {w[2], 0, -w[0]}, {-w[1], w[0], 0}};
}

}  // namespace

template <int Dim>
Surface<Dim>::Surface(const Domain<Dim>& domain, Body<Dim>& body, Loads<Dim>& loads, double depth)
    : domain_(&domain),
      body_(&body),
      deepest_(depth),
      loads_(&loads),
      position_(body.particles.position()),
      initial_position_(body.particles.vector(fields::initial_position)),
      velocity_(body.particles.vector(fields::velocity)),
      normal_(body.particles.vector(fields::normal)),
      initial_normal_(body.particles.vector(fields::initial_normal)),
      depth_(body.particles.scalar(fields::depth)),
      volume_(body.particles.scalar(fields::volume)) {
    stress_.body = body_;
    if (body.isElastic()) {
        gradient_ = &body.particles.matrix(fields::deformation_gradient);
        gradient_rate_ = &body.particles.matrix(fields::deformation_rate);
    }
}

template <int Dim>
const Vec<Dim>& Surface<Dim>::initialPlace(std::size_t n) const {
    return initial_position_[particles_[n]];
}

template <int Dim>
void Surface<Dim>::find() {
    // A row of a lattice that lies as deep by rounding is none.
    const double deepest = (1 - 1e-6) * deepest_;
    particles_.clear();
    points_.clear();
    for (std::size_t i = 0; i < body_->size(); ++i) {
        if (depth_[i] >= deepest || !body_->hasMass(i)) continue;
        particles_.push_back(static_cast<Index>(i));
        // There the normal is no face's (geometry.normals_from_shape).
        const Vec<Dim> face = body_->shape->normal(initial_position_[i]);
        Point point{};
        point.depth = depth_[i];
        point.area = volume_[i] / body_->spacing;
        point.edge = (face - initial_normal_[i]).norm() > 0.1 ? 1 : 0;
        if (point.edge > 0) point.tip = wayOut(initial_position_[i], initial_normal_[i]);
        points_.push_back(point);
    }
    turns_.clear();
    turns_.resize(particles_.size(), Vec<Dim>::Zero());
    turned_.clear();
    if (gradient_) inverse_gradients_.resize(particles_.size());
    body_version_ = ~std::uint64_t{0};
}

template <int Dim>
double Surface<Dim>::wayOut(const Vec<Dim>& from, const Vec<Dim>& along) const {
    // The distance to the surface never leads beyond it.
    double way = 0;
    for (int k = 0; k < 100; ++k) {
        const double left = -body_->shape->signedDistance(from + way * along);
        if (left < 1e-6 * body_->spacing) break;
        way += left;
    }
    return std::min(way, 2 * body_->spacing);  // of a spike
}

template <int Dim>
void Surface<Dim>::update(double dt) {
    if (arrangement_.hasChanged(body_->particles)) find();
    // What stands still is looked at once.
    if (body_version_ == body_->version && (dt_ == dt || !body_->responds())) return;
    if (body_version_ != body_->version) spin_known_ = false;
    body_version_ = body_->version;
    dt_ = dt;
    ++version_;
}

template <int Dim>
void Surface<Dim>::findSpin() {
    spin_known_ = true;
    spin_.setZero();
    const bool moves =
        std::ranges::any_of(particles_, [&](Index i) { return velocity_[i] != Vec<Dim>::Zero(); });
    if (!moves) return;
    const auto arm = [&](Index i) {
        return Vec<Dim>(domain_->difference(position_[i], position_[particles_.front()]));
    };
    Vec<Dim> center = Vec<Dim>::Zero(), drift = Vec<Dim>::Zero();
    for (const Index i : particles_) {
        center += arm(i);
        drift += velocity_[i];
    }
    center /= static_cast<double>(particles_.size());
    drift /= static_cast<double>(particles_.size());
    Mat<Dim> vr = Mat<Dim>::Zero(), rr = vr;
    for (const Index i : particles_) {
        const Vec<Dim> r = arm(i) - center;
        vr += (velocity_[i] - drift) * r.transpose();
        rr += r * r.transpose();
    }
    spin_ = skewOf(vr, rr);
}

template <int Dim>
void Surface<Dim>::take(const std::vector<Index>& points) {
    if (points.empty()) return;
    if (!gradient_ && !spin_known_) findSpin();
    parallelFor(points.size(), [&](std::size_t m) {
        const Index n = points[m];
        const std::size_t i = particles_[n];
        Point& point = points_[n];
        const Vec<Dim> place = this->place(n);
        Vec<Dim> normal = normal_[i], normal_rate = spin_ * normal;
        if (gradient_) {
            Mat<Dim>& inverse = inverse_gradients_[n];
            inverse = ((*gradient_)[i] + 0.5 * dt_ * (*gradient_rate_)[i]).inverse();
            normal = (inverse.transpose() * initial_normal_[i]).normalized();
            normal_rate = -inverse.transpose() * ((*gradient_rate_)[i].transpose() * normal);
            normal_rate -= normal.dot(normal_rate) * normal;
        }
        const Vec<Dim> velocity = velocity_[i] + backArm(n) * normal_rate;
        const Vec<Dim> slip = velocity_[i] + slipArm(n) * normal_rate;
        for (int c = 0; c < Dim; ++c) {
            point.place[c] = place[c];
            point.normal[c] = normal[c];
            point.velocity[c] = velocity[c];
            point.slip[c] = slip[c];
        }
    });
}

template <int Dim>
void Surface<Dim>::release() {
    for (const Index n : turned_) turns_[n].setZero();
    turned_.clear();
    stress_.particles.clear();
    stress_.stress.clear();
}

/// dn = -(1 - n n) F^-T dF^T n, so that with the derivative m of the energy by n, across n, the
/// stress is dE/dF = -n (x) F^-1 m, by volume.
template <int Dim>
void Surface<Dim>::finish() {
    if (!std::ranges::is_sorted(turned_)) std::ranges::sort(turned_);  // by several pairs
    turned_.erase(std::unique(turned_.begin(), turned_.end()), turned_.end());
    for (const Index n : turned_) {
        if (turns_[n].isZero(0)) continue;
        const Eigen::Map<const Vec<Dim>> normal(points_[n].normal);
        const Vec<Dim> across = turns_[n] - normal.dot(turns_[n]) * normal;
        const Index i = particles_[n];
        if (loads_->turn) (*loads_->turn)[i] += across;
        if (!gradient_) continue;
        stress_.particles.push_back(i);
        stress_.stress.push_back(-normal * (inverse_gradients_[n] * across).transpose() /
                                 volume_[i]);
    }
}

template class Surface<2>;
template class Surface<3>;

}  // namespace sphinx::dynamics::contact
