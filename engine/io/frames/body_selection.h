// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/types/type.h"
#include "io/frames/arrays.h"
#include "io/output/factory.h"

#include <optional>
#include <vector>

namespace sphinx::io {

/// One body whose frames are written.
struct SelectedBody {
    input::Name body;
    /// Empty: velocity, density and pressure of a fluid, velocity and normal of a solid, as far as
    /// it has them.
    std::optional<std::vector<input::Name>> fields;
};

/// Bodies of an output of frames; none: all but the observers.
using BodySelection = std::vector<SelectedBody>;

/// [water, wall] or {water: [velocity, pressure], wall: [normal]}.
input::Type<BodySelection> bodySelection();

/// What an output writes of which body. Throws CaseError when a body lacks a field.
template <int Dim>
std::vector<BodyFrames<Dim>> selectFrames(const BodySelection& selection,
                                          const bodies::World<Dim>& world);

}  // namespace sphinx::io
