// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/constraint/motion.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace sphinx::dynamics::constraint {
namespace {

template <int Dim>
Mat<Dim> turnBy(double angle, const std::optional<input::Coordinates>& axis) {
    if constexpr (Dim == 2)
        return Eigen::Rotation2Dd(angle).toRotationMatrix();
    else
        return Eigen::AngleAxisd(angle, axis->as<3>().normalized()).toRotationMatrix();
}

}  // namespace

template <int Dim>
MotionAt<Dim> Motion<Dim>::at(double time) const& {
    if (!displacement_.empty()) return {displacement_, time};
    const Vec<Dim> origin = Vec<Dim>::Zero();
    Vec<Dim> shift = origin;
    if (!translation_.empty()) shift = input::VectorAtTime<Dim>(translation_, time)(origin);
    if (!rotation_) return {Mat<Dim>::Identity(), origin, shift};
    const double angle = rotation_->angle.template operator()<Dim>(origin, time);
    return {turnBy<Dim>(angle, rotation_->axis), rotation_->about.template as<Dim>(), shift};
}

template <int Dim>
bool Motion<Dim>::turns() const {
    return rotation_ || std::ranges::any_of(displacement_, [](const input::FieldExpression& u) {
               return u.dependsOnPlace();
           });
}

template class Motion<2>;
template class Motion<3>;

}  // namespace sphinx::dynamics::constraint
