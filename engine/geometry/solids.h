// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/composable.h"

namespace sphinx::geometry {

/// Primitive solids by their exact signed distance.
class Solid : public Composable<3> {
 public:
    bool contains(const Vec<3>& point) const final { return signedDistance(point) <= 0; }
    bool empty() const override { return false; }
};

/// Box, perhaps turned. The faces are kept as coordinates in a turned frame and not as centre and
/// half sizes, so that points on them are on them.
class BoxSolid final : public Solid {
 public:
    BoxSolid(const Vec<3>& lower, const Vec<3>& upper, const Mat<3>& axes = Mat<3>::Identity(),
             const Vec<3>& origin = Vec<3>::Zero())
        : local_{lower, upper}, axes_(axes), origin_(origin) {}

    double signedDistance(const Vec<3>& point) const override;
    Vec<3> normal(const Vec<3>& point) const override;
    Box<3> bounds() const override;
    ShapePointer<3> transformed(const Similarity<3>& map) const override;
    ShapePointer<3> grown(double by) const override;
    double measure() const override { return local_.size().prod(); }

 private:
    Vec<3> toLocal(const Vec<3>& p) const { return axes_.transpose() * (p - origin_); }

    Box<3> local_;
    Mat<3> axes_;    ///< columns: directions of the edges, orthonormal
    Vec<3> origin_;  ///< point of local coordinates zero
};

class Ball final : public Solid {
 public:
    Ball(const Vec<3>& center, double radius) : center_(center), radius_(radius) {}

    double signedDistance(const Vec<3>& point) const override;
    Vec<3> normal(const Vec<3>& point) const override;
    Box<3> bounds() const override;
    ShapePointer<3> transformed(const Similarity<3>& map) const override;
    ShapePointer<3> grown(double by) const override;
    double measure() const override {
        return 4.0 / 3.0 * std::numbers::pi * radius_ * radius_ * radius_;
    }

 private:
    Vec<3> center_;
    double radius_;
};

class Cylinder final : public Solid {
 public:
    Cylinder(const Vec<3>& from, const Vec<3>& to, double radius)
        : from_(from), to_(to), axis_((to - from) / (to - from).norm()), radius_(radius) {}

    double signedDistance(const Vec<3>& point) const override;
    Vec<3> normal(const Vec<3>& point) const override;
    Box<3> bounds() const override;
    ShapePointer<3> transformed(const Similarity<3>& map) const override;
    ShapePointer<3> grown(double by) const override;
    double measure() const override {
        return std::numbers::pi * radius_ * radius_ * (to_ - from_).norm();
    }

 private:
    /// A point seen from the axis, and how far it lies beyond the shell and beyond the nearer end.
    struct Place {
        Vec<3> radial;  ///< unit vector away from the axis
        Vec<3> axial;   ///< unit vector out of the nearer end
        double beyond_shell, beyond_end;
    };
    Place place(const Vec<3>& point) const;

    Vec<3> from_, to_, axis_;
    double radius_;
};

class Torus final : public Solid {
 public:
    Torus(const Vec<3>& center, const Vec<3>& axis, double ring_radius, double radius)
        : center_(center), axis_(axis / axis.norm()), ring_radius_(ring_radius), radius_(radius) {}

    double signedDistance(const Vec<3>& point) const override;
    Vec<3> normal(const Vec<3>& point) const override;
    Box<3> bounds() const override;
    ShapePointer<3> transformed(const Similarity<3>& map) const override;
    ShapePointer<3> grown(double by) const override;
    double measure() const override {
        return 2 * std::numbers::pi * std::numbers::pi * ring_radius_ * radius_ * radius_;
    }

 private:
    /// From the nearest point of the circle about which the torus lies.
    Vec<3> fromCore(const Vec<3>& point) const;

    Vec<3> center_, axis_;
    double ring_radius_, radius_;
};

}  // namespace sphinx::geometry
