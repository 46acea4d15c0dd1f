// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/declare.h"
#include "dynamics/known_load.h"

namespace sphinx::dynamics::force {

struct SpringParameters {
    input::Name part;
    double stiffness = 0;
    double damping = 0;
};

/// Springs and dashpots from the particles of a part to their initial positions, with the total
/// stiffness k and damping c shared as the masses are: f_i = -m_i/M (k u_i + c v_i). Their sum is
/// that of one spring and one dashpot at the centre of mass, whatever the deformation. Taken at the
/// middle of the step, where the velocity gets its kick dt a: u = r + dt/2 v - R and v + dt/2 a, so
/// that a (M + c dt/2) = -(k u + c v).
template <int Dim>
class Spring final : public Method, public AppliedLoad<Dim> {
 public:
    Spring(const Domain<Dim>& domain, Part<Dim> part, double stiffness, double damping);

    void run(const Clock& clock);
    std::size_t workSize() const override { return part_.size(); }
    void rest() override { this->setLoad({}); }
    void transfer(Archive& archive) override { this->transferLoad(archive); }

 private:
    const Domain<Dim>* domain_;
    Part<Dim> part_;
    double stiffness_;
    double damping_;
    Field<Vec<Dim>>& initial_position_;
    Field<Vec<Dim>>& velocity_;
    Field<Vec<Dim>>& external_;
    Field<double>& mass_;
};

/// Registers force.spring.
void declareSpring(input::Registry& registry);

}  // namespace sphinx::dynamics::force
