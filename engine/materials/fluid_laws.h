// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/law_list.h"
#include "materials/weakly_compressible_fluid.h"

namespace sphinx::materials {

/// Every law of fluids. What the classes have in common: Fluid.
using FluidLaws = LawList<LinearFluid, TaitFluid>;

///     withLaw(fluid, [&](const auto& law) { ... law.pressure(rho) ... });
template <class F>
decltype(auto) withLaw(const Fluid& fluid, F&& f) {
    return visitLaw(FluidLaws{}, fluid, std::forward<F>(f));
}

}  // namespace sphinx::materials
