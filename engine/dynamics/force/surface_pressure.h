// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/declare.h"
#include "dynamics/known_load.h"

#include <optional>

namespace sphinx::dynamics::force {

struct SurfacePressureParameters {
    input::Name part;
    input::FieldExpression pressure;
    std::optional<double> thickness;
    std::vector<input::FieldExpression> normal;
};

/// Pressure on the surface of an elastic body, carried by a layer of particles along it: the part.
/// Particle i stands for the reference area V_i/d of a layer of the thickness d with the outward
/// unit normal N, which the deformation turns and stretches (Nanson's formula): f_i = -p(r_i, t)
/// det(F_i) F_i^-T N_i V_i/d. On a plane face at rest the sum is exactly -p N times the area. Taken
/// at the middle of the step, where the velocity gets its kick.
template <int Dim>
class SurfacePressure final : public Method, public AppliedLoad<Dim> {
 public:
    /// thickness: d, length. normal: expressions of the initial position, of any length; empty: N
    /// of the body's shape.
    SurfacePressure(Part<Dim> part, input::FieldExpression pressure, double thickness,
                    std::vector<input::FieldExpression> normal);

    void prepare() override { findAreas(); }
    void run(const Clock& clock);
    std::size_t workSize() const override { return part_.size(); }
    void rest() override { this->setLoad({}); }
    void transfer(Archive& archive) override { this->transferLoad(archive); }

 private:
    /// Where the particles have other places than those found.
    void findAreas();

    Part<Dim> part_;
    input::FieldExpression pressure_;
    double thickness_;
    std::vector<input::FieldExpression> given_normal_;
    AlignedVector<Vec<Dim>> area_;                   // N V/d of the part's particles
    std::uint64_t arrangement_ = ~std::uint64_t{0};  // of the particles when they were found
    Field<Vec<Dim>>& velocity_;
    Field<Vec<Dim>>& external_;
    Field<Mat<Dim>>& gradient_;
    Field<Mat<Dim>>& rate_;
    Field<double>& mass_;
};

/// Registers force.surface_pressure.
void declareSurfacePressure(input::Registry& registry);

}  // namespace sphinx::dynamics::force
