// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/finite_extensibility.h"
#include "materials/holzapfel_muscle.h"
#include "materials/law_list.h"
#include "materials/linear_elastic.h"
#include "materials/neo_hookean.h"
#include "materials/saint_venant_kirchhoff.h"

namespace sphinx::materials {

/// Every law of elastic solids. What the classes have in common: ElasticSolid.
using ElasticLaws =
    LawList<SaintVenantKirchhoff, LinearElastic, NeoHookean, FiniteExtensibility, HolzapfelMuscle>;

///     withLaw(solid, [&](const auto& law) { ... law.template stress<Dim>(C, {}) ... });
template <class F>
decltype(auto) withLaw(const ElasticSolid& solid, F&& f) {
    return visitLaw(ElasticLaws{}, solid, std::forward<F>(f));
}

}  // namespace sphinx::materials
