// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/expressions/expression.h"

#include "input/expressions/expression_parser.h"

#include <fmt/format.h>
#include <unordered_map>

namespace sphinx::input {

double FieldExpression::evaluate(double x, double y, double z, double t) const {
    // A parser of muParser holds the values of its variables, so each thread keeps its own.
    thread_local std::unordered_map<std::uint64_t, std::unique_ptr<ExpressionParser>> parsers;
    auto& parser = parsers[compiled_->id];
    if (!parser) parser = std::make_unique<ExpressionParser>(compiled_->text, compiled_->constants);
    return parser->evaluate(x, y, z, t);
}

bool FieldExpression::dependsOnTime() const { return compiled_ && compiled_->uses_time; }

bool FieldExpression::dependsOnPlace() const { return compiled_ && compiled_->uses_place; }

std::string FieldExpression::text() const {
    return compiled_ ? compiled_->text : fmt::format("{}", constant_);
}

}  // namespace sphinx::input
