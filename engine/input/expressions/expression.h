// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/types.h"

#include <memory>
#include <string>

namespace sphinx::input {

/// A number or an expression of x, y, z and t, compiled once: initial values, boundary profiles.
/// Cheap to copy; may be evaluated by many threads at once.
class FieldExpression {
 public:
    /// The constant 0.
    FieldExpression() = default;
    explicit FieldExpression(double constant) : constant_(constant) {}

    /// True when the value depends on neither place nor time: value() holds everywhere.
    bool constant() const { return compiled_ == nullptr; }
    bool dependsOnTime() const;
    bool dependsOnPlace() const;
    double value() const { return constant_; }

    /// Throws PhysicsError where it asks a table for what that does not have.
    template <int Dim>
    double operator()(const Vec<Dim>& point, double t) const {
        return constant() ? constant_
                          : evaluate(point[0], point[1], Dim == 3 ? point[Dim - 1] : 0, t, Dim);
    }
    /// As in the case file, or the number.
    std::string text() const;

 private:
    friend class Scope;
    struct Compiled;
    double evaluate(double x, double y, double z, double t, int dimension) const;

    double constant_ = 0;
    std::shared_ptr<const Compiled> compiled_;
};

}  // namespace sphinx::input
