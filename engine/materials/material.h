// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace sphinx::materials {

/// Base of all material laws: pure functions of the local state, no particles.
class Material {
 public:
    virtual ~Material() = default;
    /// Reference density rho0, mass/length^3.
    virtual double density() const = 0;
};

/// What parameters say wrongly, or fail to say at some place.
struct MaterialViolation {
    std::string parameter;
    std::string message;
};

/// A body that does not deform: walls, obstacles.
class Rigid final : public Material {
 public:
    explicit Rigid(double density) : density_(density) {}
    double density() const override { return density_; }

 private:
    double density_;
};

}  // namespace sphinx::materials
