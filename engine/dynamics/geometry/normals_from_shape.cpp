// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "bodies/pose.h"
#include "core/parallel.h"
#include "dynamics/methods.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace sphinx::dynamics::geometry {
namespace {

/// Normal and depth of every particle from the signed distance of the body's shape: the normal of
/// the nearest point of its surface, outwards, and the distance to it. Bodies bonded to it, and
/// those joined to it, belong to the shape: where two parts meet is no surface.
///
/// Where the nearest point is none of the surface of the whole, or another face is as near (the
/// particles of an edge), the normal is that of the smoothed whole,
///   n = -sum_s c(x + s) W(s) s / |...|,   c = 1 inside of a part, 0 outside,
/// over points s half a spacing apart: at an edge the mean of both faces. (With the normal of one
/// of them fluid that moves along that face is not held back by the particle, and enters the
/// solid.)
struct NormalsFromShapeParameters {
    input::Name body;
    std::vector<input::Name> joined;
};

template <int Dim>
sphinx::geometry::ShapePointer<Dim> wholeShape(const Body<Dim>& body) {
    if (body.bonded.empty()) return body.shape;
    std::vector<sphinx::geometry::ShapePointer<Dim>> shapes{body.shape};
    for (const Body<Dim>* other : body.bonded) shapes.push_back(other->shape);
    return sphinx::geometry::makeUnion<Dim>(shapes);
}

template <int Dim>
class NormalsFromShape final : public Method {
 public:
    NormalsFromShape(Context<Dim>& context, const NormalsFromShapeParameters& p);
    void run(const Clock& clock);
    std::size_t workSize() const override { return body_->size(); }

 private:
    /// A point of the sum that smooths, with its weight in whole numbers: so the sum of a mirrored
    /// or turned solid is the mirrored or turned sum.
    struct StencilPoint {
        Vec<Dim> offset;
        std::array<int, Dim> place;  // in steps
        std::int64_t weight;
    };
    void makeStencil();
    bool insideOther(const Vec<Dim>& x) const;
    /// Of the whole.
    bool inside(const Vec<Dim>& x) const;
    /// Another face, at an angle, is the nearest within half a spacing.
    bool nearEdge(const Vec<Dim>& x) const;
    /// Zero where the surface of the whole is out of reach.
    Vec<Dim> smoothedNormal(const Vec<Dim>& x) const;
    double depthAlong(const Vec<Dim>& x, const Vec<Dim>& normal) const;

    const Domain<Dim>* domain_;
    Body<Dim>* body_;
    sphinx::geometry::ShapePointer<Dim> shape_;
    std::vector<sphinx::geometry::ShapePointer<Dim>> others_;
    std::vector<StencilPoint> stencil_;
    Field<Vec<Dim>>& normal_;
    Field<Vec<Dim>>& initial_normal_;
    Field<double>& depth_;
};

template <int Dim>
NormalsFromShape<Dim>::NormalsFromShape(Context<Dim>& context, const NormalsFromShapeParameters& p)
    : domain_(&context.world.domain),
      body_(&bodyOf(context, p.body)),
      shape_(wholeShape(*body_)),
      normal_(body_->particles.vector(fields::normal)),
      initial_normal_(body_->particles.vector(fields::initial_normal)),
      depth_(body_->particles.scalar(fields::depth)) {
    for (const input::Name& name : p.joined) others_.push_back(bodyOf(context, name).shape);
    for (const Body<Dim>* other : body_->bonded) others_.push_back(other->shape);
    makeStencil();
}

template <int Dim>
void NormalsFromShape<Dim>::makeStencil() {
    const double step = 0.5 * body_->spacing;
    const int n = static_cast<int>(body_->kernel.cutoff() / step);
    const double unit = body_->kernel.value(0) * std::pow(2.0, -30);
    const int depth = Dim == 3 ? n : 0;
    for (int a = -n; a <= n; ++a)
        for (int b = -n; b <= n; ++b)
            for (int c = -depth; c <= depth; ++c) {
                const double r = step * std::sqrt(static_cast<double>(a * a + b * b + c * c));
                const std::int64_t weight = std::llround(body_->kernel.value(r) / unit);
                if (weight == 0) continue;
                StencilPoint point;
                const std::array<int, 3> place{a, b, c};
                for (int k = 0; k < Dim; ++k) {
                    point.place[k] = place[k];
                    point.offset[k] = place[k] * step;
                }
                point.weight = weight;
                stencil_.push_back(point);
            }
}

template <int Dim>
bool NormalsFromShape<Dim>::insideOther(const Vec<Dim>& x) const {
    return std::ranges::any_of(others_, [&](const auto& other) { return other->contains(x); });
}

template <int Dim>
bool NormalsFromShape<Dim>::inside(const Vec<Dim>& x) const {
    return shape_->contains(x) || insideOther(x);
}

template <int Dim>
bool NormalsFromShape<Dim>::nearEdge(const Vec<Dim>& x) const {
    const double step = 0.5 * body_->spacing;
    Vec<Dim> slope;
    for (int k = 0; k < Dim; ++k) {
        const Vec<Dim> s = step * Vec<Dim>::Unit(k);
        slope[k] = (shape_->signedDistance(x + s) - shape_->signedDistance(x - s)) / (2 * step);
    }
    // 1 where one face is the nearest, less where the stencil reaches across an edge of the solid;
    // in the middle of a plate 0, and either face will do.
    constexpr double margin = 0.1;
    return slope.norm() > margin && slope.norm() < 1 - margin;
}

template <int Dim>
Vec<Dim> NormalsFromShape<Dim>::smoothedNormal(const Vec<Dim>& x) const {
    std::array<std::int64_t, Dim> sum{};
    for (const StencilPoint& point : stencil_) {
        if (!inside(x + point.offset)) continue;
        for (int k = 0; k < Dim; ++k) sum[k] -= point.weight * point.place[k];
    }
    Vec<Dim> normal;
    for (int k = 0; k < Dim; ++k) normal[k] = static_cast<double>(sum[k]);
    return normal.isZero(0) ? normal : Vec<Dim>(normal.normalized());
}

template <int Dim>
double NormalsFromShape<Dim>::depthAlong(const Vec<Dim>& x, const Vec<Dim>& normal) const {
    const double step = body_->spacing / 16;
    double depth = 0;
    while (depth < body_->kernel.cutoff() && inside(x + depth * normal)) depth += step;
    return depth;
}

template <int Dim>
void NormalsFromShape<Dim>::run(const Clock&) {
    // The joints of a mechanism may begin elsewhere than the shape was drawn.
    const auto* drawn =
        dynamic_cast<const Field<Vec<Dim>>*>(body_->particles.find(fields::initial_position.name));
    const auto& places = drawn ? *drawn : body_->particles.position();
    const Mat<Dim> turn = body_->isElastic() ? Mat<Dim>(Mat<Dim>::Identity())
                                             : bodies::poseOf<Dim>(*body_, nullptr, *domain_).turn;
    parallelFor(body_->size(), [&](std::size_t i) {
        const Vec<Dim>& x = places[i];
        Vec<Dim> normal = shape_->normal(x);
        double depth = -shape_->signedDistance(x);
        // Further inside no fluid sees the particle.
        if (depth <= body_->kernel.cutoff()) {
            // The nearest point of the shape's surface lies within another part.
            const bool hidden = insideOther(x + (depth + 0.25 * body_->spacing) * normal);
            if (hidden || nearEdge(x)) {
                const Vec<Dim> smoothed = smoothedNormal(x);
                if (!smoothed.isZero(0)) {
                    normal = smoothed;
                    if (hidden) depth = depthAlong(x, normal);
                }
            }
        }
        normal_[i] = turn * normal;
        initial_normal_[i] = normal;
        depth_[i] = depth;
    });
}

/// Normals from the shape want a shape, of the body and of those joined to it.
template <int Dim>
void checkShapes(const input::Component& method, BuiltCase<Dim>& built) {
    const auto& p = method.as<NormalsFromShapeParameters>();
    std::vector<input::Name> names{p.body};
    names.insert(names.end(), p.joined.begin(), p.joined.end());
    for (const input::Name& name : names)
        if (!built.world.find(name.text)->shape)
            built.diagnostics.error(name.place,
                                    fmt::format("{} has no shape that tells the normal of its "
                                                "surface: its particles are given one by one",
                                                name.text));
}

}  // namespace

void declareNormalsFromShape(input::Registry& registry) {
    using P = NormalsFromShapeParameters;
    auto& d = declareMethod<NormalsFromShape, P>(registry, "geometry.normals_from_shape");
    d.summary("Normals and depths of a solid's particles from the signed distance of its shape");
    d.required("body", &P::body, input::bodyReference({"solid"}), "solid body with a shape");
    d.optional("joined", &P::joined, input::list(input::bodyReference({"solid"})),
               "solid bodies that it touches: where they meet is no surface");
    d.worldRule([](const auto& method, auto& built) { checkShapes(method, built); });
    d.action().reads("body", {"position"}).writes("body", {"normal", "initial_normal", "depth"});
}

}  // namespace sphinx::dynamics::geometry
