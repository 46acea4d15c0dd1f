// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/declare.h"
#include "materials/fluid.h"

namespace sphinx::dynamics::fluid {

enum class Surface { free, confined };

struct DensitySummationParameters {
    input::Name body;
    Surface surface = Surface::free;
};

/// Re-initialisation of the density by summation, guide (54) and (55):
///   free:     rho_i = max(rho_i, rho0 S_i/S0)
///   confined: rho_i = rho_i(start) S_i/S0, so that an initial pressure is kept
/// S_i = W(0) + sum_j W_ij over the fluid and the solids it sees; a neighbor of another spacing
/// counts with V_j0/V_i0. S0 is the sum over the full lattice of the body.
template <int Dim>
class DensitySummation final : public Method {
 public:
    DensitySummation(Context<Dim>& context, Body<Dim>& body, Surface surface);

    void run(const Clock& clock);
    std::size_t workSize() const override { return body_->size(); }

 private:
    struct Term {
        const Relation<Dim>* relation;
        double weight;
    };

    Body<Dim>* body_;
    Surface surface_;
    double rho0_;
    double own_;          // W(0)
    double lattice_sum_;  // S0
    std::vector<Term> terms_;
    Field<double>& density_;
    Field<double>* reference_ = nullptr;  // confined
};

/// Registers fluid.density_summation.
void declareDensitySummation(input::Registry& registry);

}  // namespace sphinx::dynamics::fluid
