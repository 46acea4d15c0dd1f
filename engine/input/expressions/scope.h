// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/expressions/expression.h"
#include "input/expressions/known_dimension.h"
#include "input/expressions/tabulated_function.h"
#include "input/expressions/units.h"
#include "input/tree/diagnostics.h"
#include "input/tree/node.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace sphinx::input {

/// The variables and tables of a case, and the evaluation of texts that use them.
class Scope {
 public:
    /// Reads an entry of `tables`; nullptr when it is wrong, which is reported.
    using ReadTable = std::function<TablePointer(const Node::Entry& entry)>;
    /// Tells the names in the map `tables`, before variables are defined. Each is read when it is
    /// first needed: variables may use tables, and the rows of tables may use variables.
    void declareTables(const Node& tables, ReadTable read, Diagnostics& diagnostics);
    /// The table of a name that is declared; nothing when it is wrong, which is reported.
    TablePointer table(const std::string& name, const Place& user, Diagnostics& diagnostics,
                       bool counts_as_use = true);

    /// Resolves the map `variables` by dependency; whatever is wrong is reported.
    void define(const Node& variables, const UnitSystem& units, Diagnostics& diagnostics,
                int case_dimension = 0);

    /// Value of a number, quantity or expression; nothing (and a report) when it is wrong.
    /// `label` names the value in messages.
    std::optional<double> number(const Node& node, Dimension dimension, const std::string& label,
                                 const UnitSystem& units, Diagnostics& diagnostics);
    /// The same, where x, y, z and t may be used.
    std::optional<FieldExpression> field(const Node& node, Dimension dimension,
                                         const std::string& label, const UnitSystem& units,
                                         int case_dimension, Diagnostics& diagnostics);

    /// A number, quantity or expression of any dimension, and what is known of that.
    struct Value {
        double number = 0;
        KnownDimension dimension;
    };
    std::optional<Value> value(const Node& node, const std::string& label, const UnitSystem& units,
                               Diagnostics& diagnostics);

    bool has(std::string_view name) const { return variables_.contains(name); }
    bool hasTable(std::string_view name) const { return tables_.contains(name); }
    std::vector<std::string> names() const;
    /// A warning for each variable and table that nothing used so far.
    void warnUnused(Diagnostics& diagnostics) const;
    /// The variables that expressions of x, y, z, t still need, for the resolved case.
    Node usedByFields() const;
    bool isUsedByFields(std::string_view table) const;

    /// Where a table is asked for the time itself, without a condition.
    struct TimedCall {
        TablePointer table;
        Place place;
    };
    const std::vector<TimedCall>& timedCalls() const { return timed_calls_; }

 private:
    enum class State { waiting, busy, done, failed };
    struct Table {
        const Node::Entry* entry = nullptr;
        Place key;
        State state = State::waiting;
        TablePointer function;
        bool used = false;
        bool used_by_field = false;
    };
    struct Variable {
        const Node* node = nullptr;
        Place key;
        State state = State::waiting;
        FieldExpression value;     ///< constant, or of place and time
        KnownDimension dimension;  ///< known where it was given with a unit
        bool used = false;
        bool used_by_field = false;
        bool used_always = false;  ///< by a field without a condition
    };
    struct Evaluation;

    /// The value of a variable; nullptr where it is wrong, which is reported.
    const FieldExpression* resolve(const std::string& name, const Place& user,
                                   const UnitSystem& units, Diagnostics& diagnostics,
                                   bool counts_as_use = true);
    /// An expression that is evaluated during the run needs these.
    void markUsed(const ExpressionParts& parts, bool conditional);

    /// Whether what is needed can be found out now: it may be failed, or depend on itself, which
    /// is reported.
    bool canBegin(const std::string& name, State state, const Place& user,
                  Diagnostics& diagnostics) const;

    int case_dimension_ = 0;
    std::map<std::string, Variable, std::less<>> variables_;
    std::map<std::string, Table, std::less<>> tables_;
    ReadTable read_table_;
    std::vector<TimedCall> timed_calls_;
    std::vector<std::string> stack_;  // what is being found out, for the message of a cycle
};

}  // namespace sphinx::input
