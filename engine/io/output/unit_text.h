// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/expressions/units.h"

#include <string>

namespace sphinx::io {

/// The unit of a quantity as result files name it: "m/s", in SI also Pa, N and J. Empty for a
/// plain number and for cases without units.
std::string unitText(const Dimension& dimension, const input::UnitSystem& units);

}  // namespace sphinx::io
