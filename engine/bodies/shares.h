// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/body.h"

namespace sphinx::bodies {

/// How much of the particle's cell, one spacing wide, lies outside of a part: 0 to 1.
template <int Dim>
double outside(Body<Dim>& body, const BodyPart<Dim>& part, std::size_t i);

/// Finds the shares of an elastic body anew, from its clamps.
template <int Dim>
void findShares(Body<Dim>& body);

}  // namespace sphinx::bodies
