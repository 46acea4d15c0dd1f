// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "case/model/model.h"
#include "input/tree/diagnostics.h"

namespace sphinx::model {

/// Warns of a fluid whose material has a viscosity that no method applies (it would only shorten
/// the time step), and of viscous forces that are always zero.
void checkViscosity(const Case& model, input::Diagnostics& diagnostics);

}  // namespace sphinx::model
