// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/multibody/components.h"

#include <fmt/format.h>
#include <cmath>

namespace sphinx::dynamics::multibody {

int Assembly::body(const input::Name& name) const {
    for (std::size_t b = 0; b < parameters_->bodies.size(); ++b)
        if (parameters_->bodies[b].first.text == name.text) return static_cast<int>(b);
    return ground;
}

int Assembly::joint(const input::Name& name) const {
    for (std::size_t k = 0; k < parameters_->joints.size(); ++k)
        if (parameters_->joints[k].name == name.text) return static_cast<int>(k);
    return 0;
}

BodyPoint Assembly::point(const PointParameters& p) const { return {body(p.body), vectorOf(p.at)}; }

Vector vectorOf(const input::Coordinates& a) {
    Vector v = Vector::Zero();
    for (int k = 0; k < a.size; ++k) v[k] = a.values[static_cast<std::size_t>(k)];
    return v;
}

FunctionOfTime functionOfTime(const input::FieldExpression& expression, std::string what) {
    return [expression, what = std::move(what)](double t) {
        const double value = expression.operator()<2>(Vec<2>(Vec<2>::Zero()), t);
        if (!std::isfinite(value)) throw MechanismError(fmt::format("{} is {}", what, value));
        return value;
    };
}

}  // namespace sphinx::dynamics::multibody
