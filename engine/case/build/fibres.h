// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "case/model/model.h"
#include "input/tree/diagnostics.h"

namespace sphinx::model {

/// Whether the body's particles have the fields `fibre` and `sheet`.
bool hasFibres(const Case& model, const Body& body);

/// Sets them from the directions of the body's material where the particles are; directions that
/// are none, or not perpendicular, are an error at their place in the case.
template <int Dim>
void setFibres(const Component& material, sphinx::Body<Dim>& body, input::Diagnostics& diagnostics);

}  // namespace sphinx::model
