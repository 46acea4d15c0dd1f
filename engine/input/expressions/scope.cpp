// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/expressions/scope.h"

#include "input/expressions/scope_evaluation.h"

#include <algorithm>
#include <utility>

namespace sphinx::input {
namespace {

constexpr std::size_t deepest_dependency = 500;

/// Reports a name that means something in every expression.
bool isReserved(const Node::Entry& entry, Diagnostics& diagnostics) {
    if (!contains(fieldNames(), entry.key) && !contains(expressionFunctions(), entry.key) &&
        !contains(expressionConstants(), entry.key))
        return false;
    diagnostics.error(entry.place, "'" + entry.key + "' is reserved for expressions");
    return true;
}

}  // namespace

const std::vector<std::string>& fieldNames() {
    static const std::vector<std::string> names{"t", "x", "y", "z"};
    return names;
}

bool contains(const std::vector<std::string>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

void Scope::declareTables(const Node& tables, ReadTable read, Diagnostics& diagnostics) {
    read_table_ = std::move(read);
    for (const Node::Entry& entry : tables.entries) {
        if (isReserved(entry, diagnostics)) continue;
        Table table;
        table.entry = &entry;
        table.key = entry.place;
        tables_.emplace(entry.key, table);
    }
}

TablePointer Scope::table(const std::string& name, const Place& user, Diagnostics& diagnostics,
                          bool counts_as_use) {
    Table& table = tables_.find(name)->second;
    table.used = table.used || counts_as_use;
    if (table.state == State::done) return table.function;
    if (!canBegin(name, table.state, user, diagnostics)) return nullptr;
    table.state = State::busy;
    stack_.push_back(name);
    table.function = read_table_(*table.entry);
    stack_.pop_back();
    table.state = table.function ? State::done : State::failed;
    return table.function;
}

void Scope::define(const Node& variables, const UnitSystem& units, Diagnostics& diagnostics,
                   int case_dimension) {
    case_dimension_ = case_dimension;
    for (const Node::Entry& entry : variables.entries) {
        if (isReserved(entry, diagnostics)) continue;
        if (hasTable(entry.key)) {
            diagnostics.error(entry.place, "'" + entry.key + "' is a table already");
            continue;
        }
        Variable variable;
        variable.node = &entry.value;
        variable.key = entry.place;
        variables_.emplace(entry.key, variable);
    }
    for (auto& [name, variable] : variables_)
        resolve(name, variable.key, units, diagnostics, false);
    for (auto& [name, variable] : variables_) variable.node = nullptr;
}

bool Scope::canBegin(const std::string& name, State state, const Place& user,
                     Diagnostics& diagnostics) const {
    if (state == State::failed) return false;
    if (state == State::busy) {
        std::string cycle;
        bool of_tables = false;
        for (auto link = std::find(stack_.begin(), stack_.end(), name); link != stack_.end();
             ++link) {
            cycle += *link + " -> ";
            of_tables = of_tables || hasTable(*link);
        }
        diagnostics.error(user, std::string("the variables ") + (of_tables ? "and tables " : "") +
                                    "depend on each other: " + cycle + name);
        return false;
    }
    if (stack_.size() >= deepest_dependency) {
        diagnostics.error(user, "variables depend on each other more than " +
                                    std::to_string(deepest_dependency) + " deep");
        return false;
    }
    return true;
}

const FieldExpression* Scope::resolve(const std::string& name, const Place& user,
                                      const UnitSystem& units, Diagnostics& diagnostics,
                                      bool counts_as_use) {
    Variable& variable = variables_.find(name)->second;
    variable.used = variable.used || counts_as_use;
    if (variable.state == State::done) return &variable.value;
    if (!canBegin(name, variable.state, user, diagnostics)) return nullptr;
    variable.state = State::busy;
    stack_.push_back(name);
    Evaluation evaluation{*this, std::nullopt, name, units, diagnostics, true, case_dimension_};
    const auto value = evaluation.evaluate(*variable.node);
    stack_.pop_back();
    variable.state = value ? State::done : State::failed;
    if (value) variable.value = *value;
    variable.dimension = evaluation.known;
    return value ? &variable.value : nullptr;
}

std::optional<double> Scope::number(const Node& node, Dimension dimension, const std::string& label,
                                    const UnitSystem& units, Diagnostics& diagnostics) {
    const auto value = Evaluation{*this, dimension, label, units, diagnostics}.evaluate(node);
    return value ? std::optional(value->value()) : std::nullopt;
}

std::optional<FieldExpression> Scope::field(const Node& node, Dimension dimension,
                                            const std::string& label, const UnitSystem& units,
                                            int case_dimension, Diagnostics& diagnostics) {
    const auto field =
        Evaluation{*this, dimension, label, units, diagnostics, true, case_dimension}.evaluate(
            node);
    if (field && !field->constant())
        markUsed(field->compiled_->parts, field->compiled_->parts.conditional);
    return field;
}

void Scope::markUsed(const ExpressionParts& parts, bool conditional) {
    for (const auto& [name, value] : parts.constants)
        variables_.find(name)->second.used_by_field = true;
    for (const auto& [name, used] : parts.tables) {
        tables_.find(name)->second.used_by_field = true;
        if (!conditional)
            for (const Place& place : used.of_time) timed_calls_.push_back({used.table, place});
    }
    for (const auto& [name, variable] : parts.variables) {
        Variable& used = variables_.find(name)->second;
        const bool known = std::exchange(used.used_by_field, true);
        const bool told = conditional ? known : std::exchange(used.used_always, true);
        if (!told) markUsed(*variable, conditional);
    }
}

std::optional<Scope::Value> Scope::value(const Node& node, const std::string& label,
                                         const UnitSystem& units, Diagnostics& diagnostics) {
    Evaluation evaluation{*this, std::nullopt, label, units, diagnostics};
    const auto value = evaluation.evaluate(node);
    return value ? std::optional(Value{value->value(), evaluation.known}) : std::nullopt;
}

std::vector<std::string> Scope::names() const {
    std::vector<std::string> names;
    for (const auto& [name, variable] : variables_) names.push_back(name);
    return names;
}

void Scope::warnUnused(Diagnostics& diagnostics) const {
    for (const auto& [name, variable] : variables_)
        if (!variable.used && variable.key.source && variable.key.source->order == 0)
            diagnostics.warning(variable.key, "the variable '" + name + "' is never used");
    for (const auto& [name, table] : tables_)
        if (!table.used && table.key.source && table.key.source->order == 0)
            diagnostics.warning(table.key, "the table '" + name + "' is never used");
}

bool Scope::isUsedByFields(std::string_view table) const {
    const auto found = tables_.find(table);
    return found != tables_.end() && found->second.used_by_field;
}

Node Scope::usedByFields() const {
    Node map = Node::map();
    for (const auto& [name, variable] : variables_)
        if (variable.used_by_field)
            map.set(name, (variable.value.constant() ? Node::number(variable.value.value())
                                                     : Node::plain(variable.value.text()))
                              .at(variable.key));
    return map;
}

}  // namespace sphinx::input
