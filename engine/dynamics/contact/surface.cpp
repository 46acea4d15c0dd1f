// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/contact/surface.h"

#include "core/parallel.h"

#include <Eigen/Geometry>
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

template <int Dim>
struct Plane {
    Vec<Dim> normal;
    double distance;  // from a point below it
    bool has_foot;    // of that point on the surface
};

/// The planes of the face nearest to x, a point inside, and of those which are nearest a spacing
/// beside. All as drawn.
template <int Dim>
std::vector<Plane<Dim>> facesAbove(const sphinx::geometry::Shape<Dim>& shape, const Vec<Dim>& x,
                                   double dp) {
    std::vector<Plane<Dim>> faces;
    const auto look = [&](const Vec<Dim>& y) {
        const Vec<Dim> n = shape.normal(y);
        const double distance = n.dot(y - x) - shape.signedDistance(y);
        const bool known = std::ranges::any_of(
            faces, [&](const Plane<Dim>& face) { return face.normal.dot(n) > 0.9; });
        if (known || faces.size() == Dim || distance >= 2 * dp) return;
        const Vec<Dim> foot = y - shape.signedDistance(y) * n;
        // Where faces are equally near, the normal is none of theirs.
        if (std::abs(shape.signedDistance(foot)) >= 1e-3 * dp) return;
        const bool has_foot = std::abs(shape.signedDistance(x + distance * n)) < 0.01 * dp;
        faces.push_back({n, distance, has_foot});
    };
    look(x);
    const Vec<Dim> up = shape.normal(x);
    for (int k = 0; k < Dim; ++k) {
        const Vec<Dim> along = Vec<Dim>::Unit(k) - up[k] * up;
        if (along.norm() < 0.3) continue;
        for (const double side : {-1.0, 1.0}) look(x + side * dp * along.normalized());
    }
    return faces;
}

/// From x to where such planes meet, if that is an edge of the shape near it; else 0.
template <int Dim>
Vec<Dim> edgeOf(const std::vector<Plane<Dim>>& faces, const sphinx::geometry::Shape<Dim>& shape,
                const Vec<Dim>& x, double dp) {
    if (faces.size() < 2) return Vec<Dim>::Zero();
    Eigen::MatrixXd normals(faces.size(), Dim);
    Eigen::VectorXd distances(faces.size());
    for (std::size_t k = 0; k < faces.size(); ++k) {
        normals.row(k) = faces[k].normal.transpose();
        distances[k] = faces[k].distance;
        // The foot on one plane of a convex edge lies below the others.
        for (const Plane<Dim>& other : faces)
            if (other.normal.dot(faces[k].normal) * faces[k].distance > other.distance + 0.01 * dp)
                return Vec<Dim>::Zero();
    }
    const Vec<Dim> arm = normals.completeOrthogonalDecomposition().solve(distances);
    const bool there = arm.norm() < 1.25 * dp && std::abs(shape.signedDistance(x + arm)) < 0.1 * dp;
    return there ? arm : Vec<Dim>(Vec<Dim>::Zero());
}

}  // namespace

template <int Dim>
Surface<Dim>::Surface(const Domain<Dim>& domain, Body<Dim>& body, Loads<Dim>& loads, double depth,
                      bool edges)
    : domain_(&domain),
      body_(&body),
      deepest_(depth),
      edges_(edges),
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
    particles_.clear();
    points_.clear();
    areas_.clear();
    heights_.clear();
    normals_.clear();
    edge_arms_.clear();
    face_ends_.clear();
    ends_.clear();
    findFrame();
    // A row of a lattice that lies as deep by rounding is none.
    const double deepest = (1 - 1e-6) * deepest_;
    std::vector<Index> near;
    for (std::size_t i = 0; i < body_->size(); ++i)
        if (depth_[i] < deepest && body_->hasMass(i)) near.push_back(static_cast<Index>(i));
    struct Found {
        std::vector<Plane<Dim>> faces;
        Vec<Dim> edge = Vec<Dim>::Zero();  // from the particle; 0: none
    };
    std::vector<Found> found(near.size());
    if (edges_ && (gradient_ || !frame_.empty()))
        parallelFor(near.size(), [&](std::size_t m) {
            const Vec<Dim>& x = initial_position_[near[m]];
            found[m].faces = facesAbove(*body_->shape, x, body_->spacing);
            found[m].edge = edgeOf(found[m].faces, *body_->shape, x, body_->spacing);
        });
    // Rigid blocks tip about their edges. Where an elastic edge is crushed its particles bear, too.
    const double edge_share = gradient_ ? 0.5 : 1;
    std::vector<Index> edge_particles;
    std::vector<Vec<Dim>> edge_normals;
    for (std::size_t m = 0; m < near.size(); ++m) {
        const Index i = near[m];
        const double area = volume_[i] / body_->spacing;
        const auto& [faces, arm] = found[m];
        const bool at_edge = !arm.isZero(0);
        Vec<Dim> mean = Vec<Dim>::Zero();
        bool has_face = false;
        for (const Plane<Dim>& face : faces) {
            mean += face.normal;
            if (face.distance >= deepest || !face.has_foot) continue;
            addFace(i, face.normal, face.distance, area);
            has_face = true;
            if (!at_edge) continue;
            areas_.back() *= 1 - edge_share;
            Vec<Dim> others = Vec<Dim>::Zero();
            for (const Plane<Dim>& other : faces)
                if (&other != &face) others += other.normal;
            points_.back().ends = 1;
            ends_.back() = static_cast<Index>(face_ends_.size());
            face_ends_.push_back({arm, others.normalized()});
        }
        if (!has_face) addFace(i, initial_normal_[i], depth_[i], area);
        if (!at_edge) continue;
        edge_particles.push_back(i);
        edge_normals.push_back(mean.normalized());
        edge_arms_.push_back(arm);
    }
    first_edge_ = points_.size();
    for (std::size_t k = 0; k < edge_particles.size(); ++k) {
        const Index i = edge_particles[k];
        addFace(i, edge_normals[k], 0, edge_share * volume_[i] / body_->spacing);
        points_.back().met_area = 0;
    }
    forces_.assign(points_.size(), Vec<Dim>::Zero());
    by_normals_ = forces_;
    edge_forces_.assign(face_ends_.size(), Vec<Dim>::Zero());
    by_beyond_ = edge_forces_;
    pushed_.clear();
    if (gradient_) inverse_gradients_.resize(points_.size());
    body_version_ = ~std::uint64_t{0};
}

template <int Dim>
void Surface<Dim>::addFace(Index i, const Vec<Dim>& normal, double height, double area) {
    Point point{};
    point.met_area = area;
    points_.push_back(point);
    particles_.push_back(i);
    areas_.push_back(area);
    heights_.push_back(height);
    normals_.push_back(normal);
    ends_.push_back(0);
}

/// Two particles in 2D, three in 3D, far from each other; none if there are no such.
template <int Dim>
void Surface<Dim>::findFrame() {
    frame_.clear();
    if (gradient_ || body_->size() == 0) return;
    frame_.push_back(0);
    for (int k = 1; k < Dim; ++k) {
        // How much one adds to what the frame spans.
        const auto beside = [&](std::size_t i) {
            Vec<Dim> arm = initial_position_[i] - initial_position_[frame_[0]];
            if (k == 2) {
                const Vec<Dim> line =
                    (initial_position_[frame_[1]] - initial_position_[frame_[0]]).normalized();
                arm -= arm.dot(line) * line;
            }
            return arm.squaredNorm();
        };
        std::size_t far = 0;
        for (std::size_t i = 0; i < body_->size(); ++i)
            if (beside(i) > beside(far)) far = i;
        if (beside(far) < 0.25 * body_->spacing * body_->spacing) {
            frame_.clear();
            return;
        }
        frame_.push_back(static_cast<Index>(far));
    }
}

template <int Dim>
void Surface<Dim>::findTurn() {
    if (frame_.empty()) return;
    const auto basis = [&](auto&& arm) {
        Mat<Dim> axes;
        axes.col(0) = arm(frame_[1]).normalized();
        if constexpr (Dim == 2) {
            axes.col(1) = Vec<2>(-axes(1, 0), axes(0, 0));
        } else {
            axes.col(2) = axes.col(0).cross(arm(frame_[2])).normalized();
            axes.col(1) = axes.col(2).cross(axes.col(0));
        }
        return axes;
    };
    const Index first = frame_[0];
    const Mat<Dim> now = basis([&](Index i) {
        return Vec<Dim>(domain_->difference(position_[i], position_[first]) +
                        0.5 * dt_ * (velocity_[i] - velocity_[first]));
    });
    const Mat<Dim> drawn =
        basis([&](Index i) { return Vec<Dim>(initial_position_[i] - initial_position_[first]); });
    turn_ = now * drawn.transpose();
}

template <int Dim>
void Surface<Dim>::update(double dt) {
    if (arrangement_.hasChanged(body_->particles)) find();
    // What stands still is looked at once.
    if (body_version_ == body_->version && (dt_ == dt || !body_->responds())) return;
    if (body_version_ != body_->version) spin_known_ = false;
    body_version_ = body_->version;
    dt_ = dt;
    if (!gradient_) findTurn();
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
        const bool of_edge = n >= first_edge_;
        Vec<Dim> place = this->place(n);
        Vec<Dim> normal;
        Mat<Dim> rate = spin_;
        if (gradient_) {
            Mat<Dim>& inverse = inverse_gradients_[n];
            inverse = turnOf(i).inverse();
            normal = (inverse.transpose() * normals_[n]).normalized();
            rate = -inverse.transpose() * (*gradient_rate_)[i].transpose();
        } else {
            normal = frame_.empty() ? normal_[i] : Vec<Dim>(turn_ * normals_[n]);
        }
        Vec<Dim> velocity = velocity_[i];
        if (of_edge) {
            const Vec<Dim> arm = turnOf(i) * edgeArm(n);
            place += arm;
            velocity += gradient_ ? (*gradient_rate_)[i] * edgeArm(n) : spin_ * arm;
        } else {
            Vec<Dim> normal_rate = rate * normal;
            normal_rate -= normal.dot(normal_rate) * normal;
            place += heights_[n] * normal;
            velocity += heights_[n] * normal_rate;
        }
        for (int c = 0; c < Dim; ++c) {
            point.place[c] = place[c];
            point.normal[c] = normal[c];
            point.velocity[c] = velocity[c];
        }
        if (point.ends == 0) return;
        const End& end = face_ends_[ends_[n]];
        const Vec<Dim> edge = this->place(n) + turnOf(i) * end.arm;
        const Vec<Dim> beyond =
            gradient_ ? Vec<Dim>((inverse_gradients_[n].transpose() * end.beyond).normalized())
                      : Vec<Dim>(turn_ * end.beyond);
        for (int c = 0; c < Dim; ++c) {
            point.edge[c] = edge[c];
            point.beyond[c] = beyond[c];
        }
    });
}

template <int Dim>
void Surface<Dim>::release() {
    for (const Index n : pushed_) {
        forces_[n].setZero();
        by_normals_[n].setZero();
        if (points_[n].ends == 0) continue;
        edge_forces_[ends_[n]].setZero();
        by_beyond_[ends_[n]].setZero();
    }
    pushed_.clear();
    stress_.particles.clear();
    stress_.stress.clear();
}

/// dn = -(1 - n n) F^-T dF^T n.
template <int Dim>
Mat<Dim> Surface<Dim>::stressOf(std::size_t n, const Vec<Dim>& normal,
                                const Vec<Dim>& derivative) const {
    return -normal * (inverse_gradients_[n] * derivative).transpose();
}

/// What acts at the end of an arm t = F T is -f (x) T of stress, by volume, and a derivative of the
/// energy by a normal is one as well. On a rigid body both are couples, f (x) t and -m (x) n.
template <int Dim>
void Surface<Dim>::finish() {
    if (!std::ranges::is_sorted(pushed_)) std::ranges::sort(pushed_);  // by several pairs
    pushed_.erase(std::unique(pushed_.begin(), pushed_.end()), pushed_.end());
    for (const Index n : pushed_) {
        const Index i = particles_[n];
        Vec<Dim> force = Vec<Dim>::Zero();
        Mat<Dim> couple = Mat<Dim>::Zero(), stress = couple;
        const auto act = [&](const Vec<Dim>& f, const Vec<Dim>& arm) {
            force += f;
            if (gradient_)
                stress -= f * arm.transpose();
            else
                couple += f * (turn_ * arm).transpose();
        };
        const auto turn = [&](const double* components, const Vec<Dim>& derivative) {
            const Eigen::Map<const Vec<Dim>> normal(components);
            const Vec<Dim> across = derivative - normal.dot(derivative) * normal;
            if (gradient_)
                stress += stressOf(n, normal, across);
            else
                couple -= across * normal.transpose();
        };
        act(forces_[n], n < first_edge_ ? Vec<Dim>(Vec<Dim>::Zero()) : edgeArm(n));
        turn(points_[n].normal, by_normals_[n] - heights_[n] * forces_[n]);
        if (points_[n].ends > 0) {
            act(edge_forces_[ends_[n]], face_ends_[ends_[n]].arm);
            turn(points_[n].beyond, by_beyond_[ends_[n]]);
        }
        if (force.isZero(0) && stress.isZero(0) && couple.isZero(0)) continue;
        loads_->touch(i);
        loads_->force[i] += force;
        const Eigen::Map<const Vec<Dim>> normal(points_[n].normal);
        loads_->pressure[i] -= force.dot(normal) * body_->spacing / volume_[i];
        if (loads_->couple) (*loads_->couple)[i] += couple;
        if (!gradient_) continue;
        stress_.particles.push_back(i);
        stress_.stress.push_back(stress / volume_[i]);
    }
}

template class Surface<2>;
template class Surface<3>;

}  // namespace sphinx::dynamics::contact
