// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/generalised_newtonian.h"
#include "materials/law_list.h"
#include "materials/oldroyd_b_fluid.h"
#include "materials/weakly_compressible_fluid.h"

namespace sphinx::materials {

/// Every law of fluids. What the classes have in common: Fluid.
using FluidLaws = LawList<LinearFluid, TaitFluid, PowerLawFluid, CarreauFluid, HerschelBulkleyFluid,
                          OldroydBFluid>;

///     withLaw(fluid, [&](const auto& law) { ... law.pressure(rho) ... });
template <class F>
decltype(auto) withLaw(const Fluid& fluid, F&& f) {
    return visitLaw(FluidLaws{}, fluid, std::forward<F>(f));
}

}  // namespace sphinx::materials
