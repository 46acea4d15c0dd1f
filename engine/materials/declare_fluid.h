// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/register.h"

namespace sphinx::materials {

/// A declaration with what every fluid has: P has density and sound_speed.
template <class P>
input::Declared<P>& declareFluidBase(input::Registry& registry, const char* name) {
    auto& d = registry.declare<P>(input::Kind::material, name);
    d.trait("fluid");
    d.required("density", &P::density, input::number(unit::density).above(0),
               "density at zero pressure, rho0");
    d.required("sound_speed", &P::sound_speed, input::number(unit::velocity).above(0),
               "speed of sound c0, at least ten times the largest speed of the flow");
    return d;
}
/// The same of a Newtonian fluid: P has viscosity, too.
template <class P>
input::Declared<P>& declareFluid(input::Registry& registry, const char* name) {
    auto& d = declareFluidBase<P>(registry, name);
    d.optional("viscosity", &P::viscosity, input::number(unit::dynamic_viscosity).atLeast(0),
               "dynamic viscosity mu");
    return d;
}

}  // namespace sphinx::materials
