// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/expressions/scope.h"

namespace sphinx::input {

/// Names that stand for place and time, sorted.
const std::vector<std::string>& fieldNames();
/// Whether the list has it.
bool contains(const std::vector<std::string>& names, std::string_view name);

/// One value being evaluated: what its texts need and where its messages go.
struct Scope::Evaluation {
    Scope& scope;
    const std::optional<Dimension> dimension;  // none: a variable, any
    const std::string& label;
    const UnitSystem& units;
    Diagnostics& diagnostics;
    const bool allow_fields = false;
    const int case_dimension = 0;
    KnownDimension known = {};  // of what was evaluated

    std::optional<FieldExpression> evaluate(const Node& node);

 private:
    struct Quantity;

    std::nullopt_t fail(const Place& place, std::string message) {
        diagnostics.error(place, std::move(message));
        return std::nullopt;
    }
    static std::optional<Quantity> splitQuantity(std::string_view text);
    std::optional<FieldExpression> finite(const Node& node, double value);
    std::optional<double> convert(const Node& node, const Quantity& quantity);
    std::optional<FieldExpression> expression(const Node& node);
    /// Reports known dimensions that are wrong, and keeps that of the whole.
    bool checkDimension(const Node& node);
    /// Reports a name that cannot stand there.
    bool check(const Node& node, const Identifier& name);
    bool useTable(const Node& node, const Identifier& name, ExpressionParts& parts);
    bool useVariable(const Place& place, const std::string& name, ExpressionParts& parts);
};

}  // namespace sphinx::input
