// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/world.h"
#include "core/clock.h"
#include "io/frames/vtu.h"

namespace sphinx::run {

/// All fields of all bodies as one VTU frame in the folder of `parameters`, to look for the reason
/// of a failure. Throws FileError.
template <int Dim>
void writeFailedState(const bodies::World<Dim>& world, const Clock& clock,
                      const io::FrameParameters& parameters);

}  // namespace sphinx::run
