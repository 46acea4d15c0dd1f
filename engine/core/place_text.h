// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/types.h"

#include <fmt/format.h>
#include <string>

namespace sphinx {

/// "(1, 2)", for messages.
template <int Dim>
std::string placeText(const Vec<Dim>& p) {
    if constexpr (Dim == 2) return fmt::format("({:g}, {:g})", p[0], p[1]);
    return fmt::format("({:g}, {:g}, {:g})", p[0], p[1], p[Dim - 1]);
}

}  // namespace sphinx
