// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/expressions/expression.h"

#include <vector>

namespace sphinx::input {

/// A vector whose components are expressions, at one time; the expressions must outlive it.
/// Components that are the same everywhere are evaluated once, since an expression takes some
/// hundred nanoseconds.
template <int Dim>
class VectorAtTime {
 public:
    VectorAtTime(const std::vector<FieldExpression>& components, double time)
        : components_(components.data()), time_(time) {
        for (int c = 0; c < Dim; ++c)
            if (!components_[c].dependsOnPlace()) common_[c] = evaluate(Vec<Dim>::Zero(), c);
    }
    double operator()(const Vec<Dim>& place, int axis) const {
        return components_[axis].dependsOnPlace() ? evaluate(place, axis) : common_[axis];
    }
    Vec<Dim> operator()(const Vec<Dim>& place) const {
        Vec<Dim> value;
        for (int c = 0; c < Dim; ++c) value[c] = (*this)(place, c);
        return value;
    }

 private:
    double evaluate(const Vec<Dim>& place, int axis) const {
        return components_[axis].template operator()<Dim>(place, time_);
    }

    const FieldExpression* components_;
    double time_;
    Vec<Dim> common_ = Vec<Dim>::Zero();
};

}  // namespace sphinx::input
