// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/expressions/units.h"
#include "io/file/file.h"
#include "io/file/provenance.h"

namespace sphinx::io {

/// What outputs of frames in files of their own are built from, besides the bodies.
struct FrameParameters {
    Path folder;
    bool single_precision = false;  ///< numbers as Float32; ids stay Int64
    input::UnitSystem units;
    Provenance provenance;
};

}  // namespace sphinx::io
