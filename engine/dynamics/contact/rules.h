// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/rules.h"

namespace sphinx::dynamics::contact {

/// A contact.force has pairs that the topology names, which can move and have a stiffness.
void checkPairs(const input::Component& method, WrittenCase& written);

/// Its bodies have shapes, which know their surfaces.
template <int Dim>
void checkShapes(const input::Component& method, BuiltCase<Dim>& built);

/// Each contact of the topology is computed; solids that could touch have one.
template <int Dim>
void checkContacts(BuiltCase<Dim>& built);

}  // namespace sphinx::dynamics::contact
