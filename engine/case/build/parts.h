// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "case/model/model.h"

namespace sphinx::model {

/// Whether the body keeps its initial positions: elastic bodies, bodies with parts, and those of
/// which a method reads them.
bool keepsInitialPosition(const Case& model, const Body& body);

/// Fills the parts of all bodies with the particles that lie in their shapes at the start (also
/// after a restart was read).
template <int Dim>
void fillParts(const Case& model, World<Dim>& world);

}  // namespace sphinx::model
