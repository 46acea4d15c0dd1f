// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/finite_extensibility.h"
#include "materials/holzapfel_muscle.h"
#include "materials/linear_elastic.h"
#include "materials/neo_hookean.h"
#include "materials/saint_venant_kirchhoff.h"

#include <utility>

namespace sphinx {

/// f(law) with the solid as its final class: once per call of a method, so that nothing is virtual
/// per particle. What the classes have in common: ElasticSolid.
///
///     withLaw(solid, [&](const auto& law) { ... law.template stress<Dim>(C, {}) ... });
template <class F>
decltype(auto) withLaw(const ElasticSolid& solid, F&& f) {
    switch (solid.law()) {
        case ElasticLaw::linear_elastic:
            return std::forward<F>(f)(static_cast<const LinearElastic&>(solid));
        case ElasticLaw::neo_hookean:
            return std::forward<F>(f)(static_cast<const NeoHookean&>(solid));
        case ElasticLaw::finite_extensibility:
            return std::forward<F>(f)(static_cast<const FiniteExtensibility&>(solid));
        case ElasticLaw::holzapfel_muscle:
            return std::forward<F>(f)(static_cast<const HolzapfelMuscle&>(solid));
        case ElasticLaw::saint_venant_kirchhoff: break;
    }
    return std::forward<F>(f)(static_cast<const SaintVenantKirchhoff&>(solid));
}

}  // namespace sphinx
