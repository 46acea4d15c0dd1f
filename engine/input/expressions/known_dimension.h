// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/unit.h"
#include "input/expressions/expression_parser.h"

#include <functional>
#include <optional>
#include <string_view>

namespace sphinx::input {

/// What is known of the physical dimension of a value: nothing where bare numbers went into it,
/// which stand for any dimension.
using KnownDimension = std::optional<Dimension>;

/// Dimension of an expression that muParser accepts, from those of its names (variables that were
/// given with a unit). `error` where two known ones are added or compared that differ.
KnownDimension knownDimension(std::string_view text,
                              const std::function<KnownDimension(std::string_view)>& ofName,
                              std::optional<ExpressionError>& error);

}  // namespace sphinx::input
