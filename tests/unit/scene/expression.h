// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/expressions/scope.h"

namespace sphinx::test {

/// An expression of x, y, z and t as a case file has it.
inline input::FieldExpression expression(const std::string& text, Dimension unit) {
    input::Scope scope;
    input::Diagnostics diagnostics;
    auto value = scope.field(input::Node::plain(text), unit, "value", {}, 3, diagnostics);
    diagnostics.throwIfErrors();
    return value.value();
}

inline std::vector<input::FieldExpression> expressions(const std::vector<std::string>& texts,
                                                       Dimension unit) {
    std::vector<input::FieldExpression> all;
    for (const std::string& text : texts) all.push_back(expression(text, unit));
    return all;
}

}  // namespace sphinx::test
