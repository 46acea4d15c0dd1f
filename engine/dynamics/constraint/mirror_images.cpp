// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/constraint/mirror_images.h"

#include <Eigen/LU>

#include <cmath>
#include <limits>

namespace sphinx::dynamics::constraint {
namespace {

/// The point's mirror image in the plane that touches the surface of the shape between it and a
/// point outside.
template <int Dim>
Vec<Dim> mirrored(const sphinx::geometry::Shape<Dim>& shape, Vec<Dim> outside,
                  const Vec<Dim>& point) {
    Vec<Dim> inside = point;
    for (int halving = 0; halving < 50; ++halving) {
        const Vec<Dim> middle = 0.5 * (inside + outside);
        (shape.contains(middle) ? inside : outside) = middle;
    }
    const Vec<Dim> normal = shape.normal(inside);
    return point - 2 * (point - inside).dot(normal) * normal;
}

/// The real particles around a particle, itself included if it is one.
template <int Dim>
class Surroundings {
 public:
    Surroundings(const Body<Dim>& body, const Field<Vec<Dim>>& start,
                 const ReferenceRelation<Dim>& relation, const Domain<Dim>& domain)
        : body_(body), start_(start), relation_(relation), domain_(domain) {}

    /// f(j) for every real particle within the cutoff of particle i.
    template <class Function>
    void forEach(Index i, Function&& f) const {
        forAll(i, [&](Index j) {
            if (!body_.elastic().isImage(j)) f(j);
        });
    }
    /// Of those around particle i, images included, the one with the largest share, i itself or
    /// the one of the lowest number before its equals.
    Index mostMaterial(Index i) const {
        Index best = i;
        forAll(i, [&](Index j) {
            const double more = body_.elastic().share(j) - body_.elastic().share(best);
            if (more > 0 || (more == 0 && best != i && j < best)) best = j;
        });
        return best;
    }
    /// Nearest to the point of those around particle i; i itself if there is none.
    /// Of two the one of the lower number.
    Index nearest(Index i, const Vec<Dim>& point) const {
        Index best = i;
        double distance = infinity;
        forEach(i, [&](Index j) {
            const double d = offset(j, point).squaredNorm();
            if (d > distance || (d == distance && j > best)) return;
            distance = d;
            best = j;
        });
        return best;
    }
    Vec<Dim> offset(Index j, const Vec<Dim>& point) const {
        return domain_.difference(start_[j], point);
    }

 private:
    template <class Function>
    void forAll(Index i, Function&& f) const {
        f(i);
        relation_.list.forEach(i, [&](Index j, double) { f(j); });
    }
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    const Body<Dim>& body_;
    const Field<Vec<Dim>>& start_;
    const ReferenceRelation<Dim>& relation_;
    const Domain<Dim>& domain_;
};

/// Adds the links of an image that moves `factor` times as the point, next to which `center` is.
template <int Dim>
void link(const Surroundings<Dim>& around, const Kernel<Dim>& kernel, Index image, double factor,
          Index center, const Vec<Dim>& point, double spacing, std::vector<ImageLink>& links) {
    if (around.offset(center, point).norm() < 1e-6 * spacing) {
        links.push_back({image, center, factor});
        return;
    }
    using Basis = Eigen::Matrix<double, Dim + 1, 1>;
    const auto basis = [&](Index j) {
        Basis p;
        p << 1, around.offset(j, point) / spacing;
        return p;
    };
    const auto near = [&](Index j) {
        return kernel.value(around.offset(j, point).norm()) / kernel.value(0);
    };
    Eigen::Matrix<double, Dim + 1, Dim + 1> moment, inverse;
    moment.setZero();
    around.forEach(center, [&](Index j) {
        const Basis p = basis(j);
        moment += near(j) * p * p.transpose();
    });
    bool invertible = false;
    moment.computeInverseWithCheck(inverse, invertible, 1e-9);
    if (!invertible) {  // in a row: no linear field
        links.push_back({image, center, factor});
        return;
    }
    const Basis factors = inverse.col(0);
    around.forEach(center, [&](Index j) {
        const double weight = near(j) * factors.dot(basis(j));
        if (weight != 0) links.push_back({image, j, factor * weight});
    });
}

}  // namespace

template <int Dim>
std::vector<ImageLink> mirrorImages(const Part<Dim>& part, const std::vector<Index>& images,
                                    const ReferenceRelation<Dim>& relation,
                                    const Domain<Dim>& domain) {
    Body<Dim>& body = part.body();
    const auto& start = body.particles.vector(fields::initial_position);
    const Surroundings<Dim> around(body, start, relation, domain);
    const sphinx::geometry::Shape<Dim>& shape = *part.shape();
    const double half = 0.5 * body.spacing;
    const double ahead = 0.75 * body.spacing;  // where rows begin, give or take half a spacing
    // The real particle next to the point, on the way from `from`.
    const auto approached = [&](Index from, const Vec<Dim>& point) {
        for (Index last = from;; last = from) {
            from = around.nearest(last, point);
            if (from == last) return from;
        }
    };
    std::vector<ImageLink> links;
    for (const Index image : images) {
        Vec<Dim> point = start[image];
        Index next = around.nearest(image, point);
        if (next == image) next = around.nearest(around.mostMaterial(image), point);
        if (body.elastic().isImage(next)) continue;
        // Links, if the point lies inside of the body: within half a diagonal of the lattice.
        const auto follow = [&](double factor) {
            const double reach = std::sqrt(1.01 * Dim) * half;
            if (around.offset(next, point).norm() > reach) return false;
            link(around, body.kernel, image, factor, next, point, body.spacing, links);
            return true;
        };
        const double distance = shape.signedDistance(point);
        if (distance > -(1 - 1e-6) * half) {
            point += (ahead - distance) * shape.normal(point);
            next = approached(next, point);
            if (follow(distance / ahead) || distance > 0) continue;
            point = start[image];  // cut where the body ends
        }
        // In a corner the image of one face lies behind another.
        for (int face = 0; face < Dim && shape.contains(point); ++face) {
            point = mirrored<Dim>(shape, start[next], point);
            next = approached(next, point);
        }
        follow(-1);
    }
    return links;
}

template std::vector<ImageLink> mirrorImages(const Part<2>&, const std::vector<Index>&,
                                             const ReferenceRelation<2>&, const Domain<2>&);
template std::vector<ImageLink> mirrorImages(const Part<3>&, const std::vector<Index>&,
                                             const ReferenceRelation<3>&, const Domain<3>&);

}  // namespace sphinx::dynamics::constraint
