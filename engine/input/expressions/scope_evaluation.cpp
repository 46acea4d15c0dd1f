// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/expressions/scope_evaluation.h"

#include "input/expressions/characters.h"
#include "input/expressions/decimal.h"
#include "input/tree/suggest.h"

#include <fmt/format.h>
#include <atomic>
#include <cmath>

namespace sphinx::input {

/// "3 cm" as number and unit: a number, blanks, and a text that starts like a unit.
struct Scope::Evaluation::Quantity {
    std::string_view number;
    std::string_view unit;
    bool blank;  ///< a blank stands between them
};

namespace {

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

/// Whether the call of a function has t alone as its argument: "f(t)".
bool isOfTimeAlone(std::string_view text, const Identifier& function) {
    const auto next = [&](std::size_t k) { return text.find_first_not_of(' ', k); };
    const std::size_t open = next(function.position + function.name.size());
    const std::size_t argument = next(open + 1);
    const std::size_t close = next(argument + 1);
    return close < text.size() && text[argument] == 't' && text[close] == ')';
}

/// "x and t", or "t (through 'phase')" where another variable is the reason.
std::string why(const ExpressionParts& variable) {
    std::string text;
    for (const char field : variable.fields)
        text += (text.empty() ? "" : " and ") + std::string(1, field);
    std::set<char> left = variable.fields;
    std::optional<ExpressionError> wrong;
    for (const Identifier& name : scanExpression(variable.text, wrong))
        if (name.name.size() == 1) left.erase(name.name[0]);
    for (const auto& [name, used] : variable.variables)
        for (const char field : left)
            if (used->fields.contains(field)) return text + " (through '" + name + "')";
    return text;
}

}  // namespace

auto Scope::Evaluation::splitQuantity(std::string_view text) -> std::optional<Quantity> {
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

std::optional<FieldExpression> Scope::Evaluation::evaluate(const Node& node) {
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

std::optional<FieldExpression> Scope::Evaluation::finite(const Node& node, double value) {
    if (!std::isfinite(value))
        return fail(node.place, label + fmt::format(" is {}, not a finite number", value));
    return FieldExpression(value);
}

std::optional<double> Scope::Evaluation::convert(const Node& node, const Quantity& quantity) {
    const auto offset = static_cast<std::size_t>(quantity.unit.data() - node.text.data());
    const Place place = within(node, offset);
    const std::string unit_text(quantity.unit);
    const auto number = parseDecimal<double>(quantity.number);
    const auto unit = parseUnit(quantity.unit);
    if (!number) return fail(node.place, label + " is '" + node.text + "', not a number");
    if (!unit && scope.has(quantity.unit))
        return fail(place, label + ": an operator is missing before '" + unit_text + "'");
    if (!unit) return fail(place, "'" + unit_text + "' is not a unit" + suggestUnit(quantity.unit));
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

std::optional<FieldExpression> Scope::Evaluation::expression(const Node& node) {
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
    ExpressionParts parts;
    parts.text = node.text;
    parts.conditional = node.text.find('?') != std::string::npos;
    bool good = true;
    for (const Identifier& name : identifiers) {
        if (!check(node, name))
            good = false;
        else if (contains(fieldNames(), name.name))
            parts.fields.insert(name.name[0]);
        else if (scope.hasTable(name.name))
            good = useTable(node, name, parts) && good;
        else if (scope.has(name.name))
            good = useVariable(within(node, name.position), name.name, parts) && good;
    }
    if (!good) return std::nullopt;
    try {
        ExpressionParser parser(parts);
        if (!checkDimension(node)) return std::nullopt;
        if (parts.fields.empty()) return finite(node, parser.evaluate(0, 0, 0, nan_value));
    } catch (const ExpressionError& e) {
        return fail(within(node, e.position), label + ": " + e.message);
    } catch (const OutsideTable& asked) {
        return fail(node.place, label + ": " + asked.table->rangeText() + ", but none at " +
                                    asked.table->argumentText(asked.argument));
    }
    static std::atomic<std::uint64_t> next_id{0};
    FieldExpression result;
    result.compiled_ = std::make_shared<FieldExpression::Compiled>(
        FieldExpression::Compiled{next_id++, std::move(parts)});
    return result;
}

bool Scope::Evaluation::useTable(const Node& node, const Identifier& name, ExpressionParts& parts) {
    const Place place = within(node, name.position);
    const TablePointer table = scope.table(name.name, place, diagnostics);
    if (!table) return false;
    UsedTable& used = parts.tables[name.name];
    used.table = table;
    if (isOfTimeAlone(node.text, name)) used.of_time.push_back(place);
    return true;
}

bool Scope::Evaluation::useVariable(const Place& place, const std::string& name,
                                    ExpressionParts& parts) {
    const FieldExpression* value = scope.resolve(name, place, units, diagnostics);
    if (!value) return false;
    if (value->constant()) {
        parts.constants[name] = value->value();
        return true;
    }
    const ExpressionParts& variable = value->compiled_->parts;
    if (!allow_fields)
        return fail(place, "the variable '" + name + "' depends on " + why(variable) +
                               ": it may be used in initial values and profiles only"),
               false;
    parts.variables[name] = {value->compiled_, &variable};
    parts.fields.insert(variable.fields.begin(), variable.fields.end());
    parts.conditional = parts.conditional || variable.conditional;
    return true;
}

bool Scope::Evaluation::checkDimension(const Node& node) {
    const KnownNames names{
        [&](std::string_view name) {
            const auto variable = scope.variables_.find(name);
            return variable == scope.variables_.end() ? KnownDimension{}
                                                      : variable->second.dimension;
        },
        [&](std::string_view name) -> const TabulatedFunction* {
            const auto table = scope.tables_.find(name);
            return table == scope.tables_.end() ? nullptr : table->second.function.get();
        }};
    std::optional<ExpressionError> error;
    known = knownDimension(node.text, names, error);
    if (error) return fail(within(node, error->position), label + ": " + error->message), false;
    if (!known || !dimension || *known == *dimension) return true;
    return fail(node.place,
                *dimension == unit::none
                    ? fmt::format("{} is a plain number, but '{}' is {}", label, node.text,
                                  dimensionText(*known))
                    : fmt::format("{} needs a unit like {}, but '{}' is {}", label,
                                  siText(*dimension), node.text, dimensionWords(*known))),
           false;
}

bool Scope::Evaluation::check(const Node& node, const Identifier& name) {
    const Place place = within(node, name.position);
    const bool is_table = scope.hasTable(name.name);
    const bool is_function = is_table || contains(expressionFunctions(), name.name);
    if (name.is_call || is_function) {
        if (is_function && name.is_call) return true;
        if (is_function)
            return fail(place, name.name + " is a " + (is_table ? "table" : "function") + ": " +
                                   name.name + "(...)"),
                   false;
        std::vector<std::string> functions = expressionFunctions();
        for (const auto& [table, entry] : scope.tables_) functions.push_back(table);
        return fail(place,
                    "there is no function '" + name.name + "'" + didYouMean(name.name, functions)),
               false;
    }
    if (contains(fieldNames(), name.name)) {
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

}  // namespace sphinx::input
