// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/expressions/scope.h"

#include "input/expressions/characters.h"
#include "input/expressions/decimal.h"
#include "input/expressions/expression_parser.h"
#include "input/tree/suggest.h"

#include <fmt/format.h>
#include <algorithm>
#include <atomic>
#include <cmath>

namespace sphinx::input {
namespace {

constexpr std::size_t deepest_dependency = 500;

/// Place of a byte of a scalar; that of the scalar when quotes or folding have moved it.
Place within(const Node& node, std::size_t position) {
    Place place = node.place;
    if (!place.source) return place;
    const std::size_t quote = node.quoted ? 1 : 0;
    const std::string_view line = place.source->line(place.line);
    const std::size_t begin = static_cast<std::size_t>(place.column) - 1 + quote;
    if (begin <= line.size() && line.substr(begin, node.text.size()) == node.text)
        place.column += static_cast<int>(quote + position);
    return place;
}

/// "3 cm" as number and unit: a number, blanks, and a text that starts like a unit.
struct Quantity {
    std::string_view number;
    std::string_view unit;
    bool blank;  ///< a blank stands between them
};
std::optional<Quantity> splitQuantity(std::string_view text) {
    std::size_t end = 0;
    if (end < text.size() && (text[end] == '-' || text[end] == '+')) ++end;
    const std::size_t digits = end;
    while (end < text.size() && (isDigit(text[end]) || text[end] == '.')) ++end;
    if (end == digits) return std::nullopt;
    if (end + 1 < text.size() && (text[end] == 'e' || text[end] == 'E')) {
        std::size_t exponent = end + 1;
        if (text[exponent] == '-' || text[exponent] == '+') ++exponent;
        if (exponent < text.size() && isDigit(text[exponent])) {
            while (exponent < text.size() && isDigit(text[exponent])) ++exponent;
            end = exponent;
        }
    }
    std::size_t begin = end;
    while (begin < text.size() && text[begin] == ' ') ++begin;
    const std::string_view unit = text.substr(begin);
    const bool starts_like_unit =
        !unit.empty() && (isLetter(unit[0]) || (begin > end && unit.starts_with("1/")));
    if (!starts_like_unit) return std::nullopt;
    return Quantity{text.substr(0, end), unit, begin > end};
}

const std::vector<std::string> field_names{"t", "x", "y", "z"};

bool contains(const std::vector<std::string>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

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

    std::nullopt_t fail(const Place& place, std::string message) {
        diagnostics.error(place, std::move(message));
        return std::nullopt;
    }

    std::optional<FieldExpression> evaluate(const Node& node) {
        if (node.isNull()) return fail(node.place, label + " has no value");
        if (!node.isScalar())
            return fail(node.place, label + " must be a number, not " + describeNode(node));
        const std::string& text = node.text;
        if (text.find_first_not_of(' ') == std::string::npos)
            return fail(node.place, label + " has no value");
        std::optional<double> value = parseDecimal<double>(text);
        if (!value) {
            if (const auto quantity = splitQuantity(text)) {
                const bool expression = !quantity->blank && !parseUnit(quantity->unit);
                if (!expression) {
                    value = convert(node, *quantity);
                    if (!value) return std::nullopt;
                }
            }
        }
        if (value) return finite(node, *value);
        if (const auto comma = text.find(','); comma != std::string::npos) {
            std::string with_point = text;
            with_point[comma] = '.';
            if (parseDecimal<double>(with_point))
                return fail(within(node, comma),
                            label + ": numbers have a decimal point: " + with_point);
        }
        if (text.find(':') != std::string::npos && text.find('?') == std::string::npos &&
            isDigit(text[0]))
            return fail(node.place, label + " is '" + text +
                                        "', not a number; a time is a number or a quantity, "
                                        "such as 90 s");
        return expression(node);
    }

    std::optional<FieldExpression> finite(const Node& node, double value) {
        if (!std::isfinite(value))
            return fail(node.place, label + fmt::format(" is {}, not a finite number", value));
        return FieldExpression(value);
    }

    std::optional<double> convert(const Node& node, const Quantity& quantity) {
        const auto offset = static_cast<std::size_t>(quantity.unit.data() - node.text.data());
        const Place place = within(node, offset);
        const std::string unit_text(quantity.unit);
        const auto number = parseDecimal<double>(quantity.number);
        const auto unit = parseUnit(quantity.unit);
        if (!number) return fail(node.place, label + " is '" + node.text + "', not a number");
        if (!unit && scope.has(quantity.unit))
            return fail(place, label + ": an operator is missing before '" + unit_text + "'");
        if (!unit)
            return fail(place, "'" + unit_text + "' is not a unit" + suggestUnit(quantity.unit));
        if (!quantity.blank)
            return fail(place, "a blank is missing between number and unit: '" +
                                   std::string(quantity.number) + " " + unit_text + "'");
        if (dimension && unit->dimension != *dimension) {
            if (*dimension == unit::none)
                return fail(place, label + " is a plain number, without the unit " + unit_text);
            return fail(place, label + " needs a unit like " + siText(*dimension) + ", but " +
                                   unit_text + " is " + dimensionText(unit->dimension));
        }
        if (units.none && unit->dimension != unit::none)
            return fail(place,
                        "the case has 'units: none', so that " + unit_text + " means nothing here");
        known = unit->dimension;
        return units.convert(*number, *unit);
    }

    std::optional<FieldExpression> expression(const Node& node) {
        const auto blank = node.text.rfind(' ');
        const std::string_view tail = std::string_view(node.text).substr(blank + 1);
        if (blank != std::string::npos && blank > 0 && !tail.empty() && isLetter(tail[0]) &&
            (isDigit(node.text[blank - 1]) || isLetter(node.text[blank - 1]) ||
             node.text[blank - 1] == ')') &&
            parseUnit(tail))
            return fail(within(node, blank + 1),
                        label +
                            ": an expression contains no units; a quantity is a number, a "
                            "blank and a unit");
        std::optional<ExpressionError> error;
        const std::vector<Identifier> identifiers = scanExpression(node.text, error);
        if (error) return fail(within(node, error->position), label + ": " + error->message);
        std::map<std::string, double> constants;
        bool uses_time = false;
        bool uses_place = false;
        bool good = true;
        for (const Identifier& name : identifiers) {
            if (!check(node, name)) {
                good = false;
            } else if (contains(field_names, name.name)) {
                (name.name == "t" ? uses_time : uses_place) = true;
            } else if (scope.has(name.name)) {
                const auto value =
                    scope.resolve(name.name, within(node, name.position), units, diagnostics);
                good = good && value;
                if (value) constants[name.name] = *value;
            }
        }
        if (!good) return std::nullopt;
        try {
            ExpressionParser parser(node.text, constants);
            if (!checkDimension(node)) return std::nullopt;
            if (!uses_time && !uses_place) return finite(node, parser.evaluate(0, 0, 0, 0));
        } catch (const ExpressionError& e) {
            return fail(within(node, e.position), label + ": " + e.message);
        }
        static std::atomic<std::uint64_t> next_id{0};
        for (const auto& [name, value] : constants)
            scope.variables_.find(name)->second.used_by_field = true;
        FieldExpression result;
        result.compiled_ = std::make_shared<FieldExpression::Compiled>(FieldExpression::Compiled{
            next_id++, node.text, std::move(constants), uses_time, uses_place});
        return result;
    }

    /// Reports known dimensions that are wrong, and keeps that of the whole.
    bool checkDimension(const Node& node) {
        const auto ofName = [&](std::string_view name) {
            const auto variable = scope.variables_.find(name);
            return variable == scope.variables_.end() ? KnownDimension{}
                                                      : variable->second.dimension;
        };
        std::optional<ExpressionError> error;
        known = knownDimension(node.text, ofName, error);
        if (error) return fail(within(node, error->position), label + ": " + error->message), false;
        if (!known || !dimension || *known == *dimension) return true;
        return fail(node.place,
                    *dimension == unit::none
                        ? fmt::format("{} is a plain number, but '{}' is {}", label, node.text,
                                      dimensionText(*known))
                        : fmt::format("{} needs a unit like {}, but '{}' is {}", label,
                                      siText(*dimension), node.text, dimensionText(*known))),
               false;
    }

    /// Reports a name that cannot stand there.
    bool check(const Node& node, const Identifier& name) {
        const Place place = within(node, name.position);
        const bool is_function = contains(expressionFunctions(), name.name);
        if (name.is_call || is_function) {
            if (is_function && name.is_call) return true;
            if (is_function)
                return fail(place, name.name + " is a function: " + name.name + "(...)"), false;
            return fail(place, "there is no function '" + name.name + "'" +
                                   didYouMean(name.name, expressionFunctions())),
                   false;
        }
        if (contains(field_names, name.name)) {
            if (!allow_fields)
                return fail(place,
                            "'" + name.name + "' may be used in initial values and profiles only"),
                       false;
            if (name.name == "z" && case_dimension == 2)
                return fail(place, "there is no z in a 2D case"), false;
            return true;
        }
        if (contains(expressionConstants(), name.name) || scope.has(name.name)) return true;
        std::vector<std::string> known = scope.names();
        std::string hint = didYouMean(name.name, known);
        if (known.empty()) hint = "; the case defines no variables";
        return fail(place, "there is no variable '" + name.name + "'" + hint), false;
    }
};

void Scope::define(const Node& variables, const UnitSystem& units, Diagnostics& diagnostics) {
    for (const Node::Entry& entry : variables.entries) {
        if (contains(field_names, entry.key) || contains(expressionFunctions(), entry.key) ||
            contains(expressionConstants(), entry.key)) {
            diagnostics.error(entry.place, "'" + entry.key + "' is reserved for expressions");
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

std::optional<double> Scope::resolve(const std::string& name, const Place& user,
                                     const UnitSystem& units, Diagnostics& diagnostics,
                                     bool counts_as_use) {
    Variable& variable = variables_.find(name)->second;
    variable.used = variable.used || counts_as_use;
    if (variable.state == State::done) return variable.value;
    if (variable.state == State::failed) return std::nullopt;
    if (variable.state == State::busy) {
        std::string cycle;
        for (auto link = std::find(stack_.begin(), stack_.end(), name); link != stack_.end();
             ++link)
            cycle += *link + " -> ";
        diagnostics.error(user, "the variables depend on each other: " + cycle + name);
        return std::nullopt;
    }
    if (stack_.size() >= deepest_dependency) {
        diagnostics.error(user, "variables depend on each other more than " +
                                    std::to_string(deepest_dependency) + " deep");
        return std::nullopt;
    }
    variable.state = State::busy;
    stack_.push_back(name);
    Evaluation evaluation{*this, std::nullopt, name, units, diagnostics};
    const auto value = evaluation.evaluate(*variable.node);
    stack_.pop_back();
    variable.state = value ? State::done : State::failed;
    if (value) variable.value = value->value();
    variable.dimension = evaluation.known;
    return value ? std::optional(variable.value) : std::nullopt;
}

std::optional<double> Scope::number(const Node& node, Dimension dimension, const std::string& label,
                                    const UnitSystem& units, Diagnostics& diagnostics) {
    const auto value = Evaluation{*this, dimension, label, units, diagnostics}.evaluate(node);
    return value ? std::optional(value->value()) : std::nullopt;
}

std::optional<FieldExpression> Scope::field(const Node& node, Dimension dimension,
                                            const std::string& label, const UnitSystem& units,
                                            int case_dimension, Diagnostics& diagnostics) {
    return Evaluation{*this, dimension, label, units, diagnostics, true, case_dimension}.evaluate(
        node);
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
}

Node Scope::usedByFields() const {
    Node map = Node::map();
    for (const auto& [name, variable] : variables_)
        if (variable.used_by_field) map.set(name, Node::number(variable.value).at(variable.key));
    return map;
}

}  // namespace sphinx::input
