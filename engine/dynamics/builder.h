// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/context.h"
#include "dynamics/dynamics.h"
#include "input/declaration/declaration.h"
#include "input/declaration/registry.h"

#include <functional>
#include <memory>

namespace sphinx {

/// Factories of a component for both dimensions; Declaration::builder of Kind::dynamics holds
/// Factory<Method> or Factory<TimeStepMethod>.
template <class Product>
struct Factory {
    std::function<std::unique_ptr<Product>(const void* parameters, Context<2>&)> in2d;
    std::function<std::unique_ptr<Product>(const void* parameters, Context<3>&)> in3d;

    template <int Dim>
    std::unique_ptr<Product> make(const void* parameters, Context<Dim>& context) const {
        if constexpr (Dim == 2)
            return in2d(parameters, context);
        else
            return in3d(parameters, context);
    }
};

/// make: []<int Dim>(const P&, Context<Dim>&) -> std::unique_ptr<Product>.
template <class Product, class P, class Make>
Factory<Product> factory(Make make) {
    return {[make](const void* p, Context<2>& context) -> std::unique_ptr<Product> {
                return make.template operator()<2>(*static_cast<const P*>(p), context);
            },
            [make](const void* p, Context<3>& context) -> std::unique_ptr<Product> {
                return make.template operator()<3>(*static_cast<const P*>(p), context);
            }};
}

/// The body of a checked reference.
template <int Dim>
Body<Dim>& bodyOf(Context<Dim>& context, const input::Name& name) {
    return *context.world.find(name.text);
}

}  // namespace sphinx
