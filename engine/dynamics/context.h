// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/world.h"
#include "neighbors/relations.h"

namespace sphinx {

/// What methods are built from.
template <int Dim>
struct Context {
    World<Dim>& world;
    Relations<Dim>& relations;
};

}  // namespace sphinx
