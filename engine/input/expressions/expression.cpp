// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/expressions/expression.h"

#include "core/errors.h"
#include "core/place_text.h"
#include "input/expressions/expression_parser.h"

#include <fmt/format.h>
#include <unordered_map>

namespace sphinx::input {

double FieldExpression::evaluate(double x, double y, double z, double t, int dimension) const {
    // A parser of muParser holds the values of its variables, so each thread keeps its own.
    thread_local std::unordered_map<std::uint64_t, std::unique_ptr<ExpressionParser>> parsers;
    auto& parser = parsers[compiled_->id];
    if (!parser) parser = std::make_unique<ExpressionParser>(compiled_->parts);
    try {
        return parser->evaluate(x, y, z, t);
    } catch (const OutsideTable& asked) {
        const UnitSystem& units = asked.table->units();
        std::string where;
        if (dependsOnPlace())
            where = " at " + (dimension == 2 ? placeText<2>({x, y}) : placeText<3>({x, y, z})) +
                    units.suffix(unit::length) + " and";
        throw PhysicsError(fmt::format(
            "{}, but '{}' asks it for {}{} at time {:g}{}", asked.table->rangeText(), text(),
            asked.table->argumentText(asked.argument), where, t, units.suffix(unit::time)));
    }
}

bool FieldExpression::dependsOnTime() const {
    return compiled_ && compiled_->parts.fields.contains('t');
}

bool FieldExpression::dependsOnPlace() const {
    return compiled_ && (compiled_->parts.fields.size() > 1 || !dependsOnTime());
}

std::string FieldExpression::text() const {
    return compiled_ ? compiled_->parts.text : fmt::format("{}", constant_);
}

}  // namespace sphinx::input
