// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "case/model/model.h"
#include "input/tree/diagnostics.h"

#include <vector>

namespace sphinx::model {

/// Whether the body's particles have the fields `fibre` and `sheet`.
bool hasFibres(const Case& model, const Body& body);

/// Directions of the material that are none at one of the places, or not perpendicular, are an
/// error at their place in the case.
template <int Dim>
void checkFibres(const Component& material, const std::vector<Vec<Dim>>& places,
                 input::Diagnostics& diagnostics);

}  // namespace sphinx::model
