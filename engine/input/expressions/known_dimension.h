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

/// What is known of the names in an expression.
struct KnownNames {
    /// Of a variable that was given with a unit.
    std::function<KnownDimension(std::string_view)> dimension;
    /// nullptr when it is not the name of a table.
    std::function<const TabulatedFunction*(std::string_view)> table;
};

/// Dimension of an expression that muParser accepts, from those of its names. `error` where two
/// known ones are added or compared that differ, or the argument of a table has another one.
KnownDimension knownDimension(std::string_view text, const KnownNames& names,
                              std::optional<ExpressionError>& error);

/// "time", or "a plain number".
std::string dimensionWords(Dimension dimension);

}  // namespace sphinx::input
