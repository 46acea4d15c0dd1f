// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/types.h"
#include "input/expressions/vector_at_time.h"
#include "input/types/values.h"

#include <optional>
#include <vector>

namespace sphinx::dynamics::constraint {

/// A turn about a point, in 3D about an axis through it, counter-clockwise as the axis (in 2D z)
/// points to the eye.
struct RotationParameters {
    input::Coordinates about;
    input::FieldExpression angle;  ///< radians, of t alone
    std::optional<input::Coordinates> axis;
};

/// Where the points of a body are at a time, as a case prescribes it: r = R + u(R, t).
template <int Dim>
class MotionAt {
 public:
    /// Displacement given by expressions of R and t.
    MotionAt(const std::vector<input::FieldExpression>& displacement, double time)
        : displacement_(std::in_place, displacement, time) {}
    /// A body that turns and shifts as a whole: r = about + Q (R - about) + shift.
    MotionAt(const Mat<Dim>& turn, const Vec<Dim>& about, const Vec<Dim>& shift)
        : turn_(turn), about_(about), shift_(shift) {}

    /// Component of u of the point that began at R; length.
    double operator()(const Vec<Dim>& start, int axis) const {
        if (displacement_) return (*displacement_)(start, axis);
        const Vec<Dim> arm = start - about_;
        return about_[axis] + turn_.row(axis).dot(arm) + shift_[axis] - start[axis];
    }
    /// Gradient of the motion F = dr/dR. Of expressions by central differences over `step`, to
    /// rounding for those that are linear in the place.
    Mat<Dim> gradient(const Vec<Dim>& start, double step) const {
        if (!displacement_) return turn_;
        Mat<Dim> F = Mat<Dim>::Identity();
        for (int k = 0; k < Dim; ++k) {
            const Vec<Dim> ahead = start + step * Vec<Dim>::Unit(k);
            const Vec<Dim> behind = start - step * Vec<Dim>::Unit(k);
            F.col(k) += ((*displacement_)(ahead) - (*displacement_)(behind)) / (2 * step);
        }
        return F;
    }

 private:
    std::optional<input::VectorAtTime<Dim>> displacement_;
    Mat<Dim> turn_ = Mat<Dim>::Identity();
    Vec<Dim> about_ = Vec<Dim>::Zero();
    Vec<Dim> shift_ = Vec<Dim>::Zero();
};

/// A motion that a case prescribes: a displacement, or a rotation, a translation or both.
template <int Dim>
class Motion {
 public:
    explicit Motion(std::vector<input::FieldExpression> displacement)
        : displacement_(std::move(displacement)) {}
    /// `translation`: of t alone, one expression for each direction, or empty.
    Motion(std::optional<RotationParameters> rotation,
           std::vector<input::FieldExpression> translation)
        : rotation_(std::move(rotation)), translation_(std::move(translation)) {}

    /// It refers to this motion.
    MotionAt<Dim> at(double time) const&;
    MotionAt<Dim> at(double time) && = delete;
    /// Directions on the body do not stay as they are.
    bool turns() const;

 private:
    std::vector<input::FieldExpression> displacement_;
    std::optional<RotationParameters> rotation_;
    std::vector<input::FieldExpression> translation_;
};

extern template class Motion<2>;
extern template class Motion<3>;

}  // namespace sphinx::dynamics::constraint
