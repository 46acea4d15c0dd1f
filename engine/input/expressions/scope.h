// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/expressions/expression.h"
#include "input/expressions/known_dimension.h"
#include "input/expressions/units.h"
#include "input/tree/diagnostics.h"
#include "input/tree/node.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace sphinx::input {

/// The variables of a case, and the evaluation of texts that use them.
class Scope {
 public:
    /// Resolves the map `variables` by dependency; whatever is wrong is reported.
    void define(const Node& variables, const UnitSystem& units, Diagnostics& diagnostics);

    /// Value of a number, quantity or expression; nothing (and a report) when it is wrong.
    /// `label` names the value in messages.
    std::optional<double> number(const Node& node, Dimension dimension, const std::string& label,
                                 const UnitSystem& units, Diagnostics& diagnostics);
    /// The same, where x, y, z and t may be used.
    std::optional<FieldExpression> field(const Node& node, Dimension dimension,
                                         const std::string& label, const UnitSystem& units,
                                         int case_dimension, Diagnostics& diagnostics);

    bool has(std::string_view name) const { return variables_.contains(name); }
    std::vector<std::string> names() const;
    /// A warning for each variable that nothing used so far.
    void warnUnused(Diagnostics& diagnostics) const;
    /// The variables that expressions of x, y, z, t still need, for the resolved case.
    Node usedByFields() const;

 private:
    enum class State { waiting, busy, done, failed };
    struct Variable {
        const Node* node = nullptr;
        Place key;
        State state = State::waiting;
        double value = 0;
        KnownDimension dimension;  ///< known where it was given with a unit
        bool used = false;
        bool used_by_field = false;
    };
    struct Evaluation;

    std::optional<double> resolve(const std::string& name, const Place& user,
                                  const UnitSystem& units, Diagnostics& diagnostics,
                                  bool counts_as_use = true);

    std::map<std::string, Variable, std::less<>> variables_;
    std::vector<std::string> stack_;  // variables being evaluated, for the message of a cycle
};

}  // namespace sphinx::input
