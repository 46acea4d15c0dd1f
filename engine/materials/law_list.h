// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/material.h"

#include <stdexcept>
#include <typeinfo>
#include <utility>

namespace sphinx::materials {

/// The final classes that a kind of material can have.
template <class... Law>
struct LawList {};

/// f(law) with the material as its final class, one of the list. Called once per loop over
/// particles, so that nothing is virtual per particle and each law gets a loop of its own. Throws
/// std::logic_error for a class that the list lacks.
template <class First, class... Rest, class F>
decltype(auto) visitLaw(LawList<First, Rest...>, const Material& material, F&& f) {
    if constexpr (sizeof...(Rest) > 0) {
        if (typeid(material) != typeid(First))
            return visitLaw(LawList<Rest...>{}, material, std::forward<F>(f));
    } else if (typeid(material) != typeid(First)) {
        throw std::logic_error("a law is missing in the list of its kind");
    }
    return std::forward<F>(f)(static_cast<const First&>(material));
}

}  // namespace sphinx::materials
