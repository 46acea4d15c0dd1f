// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/material.h"

#include <cassert>
#include <typeinfo>
#include <utility>

namespace sphinx {

/// The final classes that a kind of material can have.
template <class... Law>
struct LawList {};

/// f(law) with the material as its final class, one of the list. Called once per loop over
/// particles, so that nothing is virtual per particle and each law gets a loop of its own.
template <class First, class... Rest, class F>
decltype(auto) visitLaw(LawList<First, Rest...>, const Material& material, F&& f) {
    if constexpr (sizeof...(Rest) > 0)
        if (typeid(material) != typeid(First))
            return visitLaw(LawList<Rest...>{}, material, std::forward<F>(f));
    assert(typeid(material) == typeid(First) && "the law is missing in its list");
    return std::forward<F>(f)(static_cast<const First&>(material));
}

}  // namespace sphinx
