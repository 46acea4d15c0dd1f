// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/expressions/expression.h"
#include "input/expressions/tabulated_function.h"
#include "input/tree/place.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace sphinx::input {

/// A table that an expression uses.
struct UsedTable {
    TablePointer table;
    std::vector<Place> of_time;  ///< where it is asked for t alone
};

/// A text with the meaning of its names.
struct ExpressionParts {
    std::string text;
    std::map<std::string, double> constants;  ///< variables of the case that it uses
    /// The same of those that depend on place or time: each is worked out when it is needed.
    std::map<std::string, std::shared_ptr<const ExpressionParts>> variables;
    std::map<std::string, UsedTable> tables;
    std::set<char> fields;  ///< of x, y, z and t, what its value depends on
    /// It, or a variable that it uses, has a condition: it may know better when it asks a table.
    bool conditional = false;
};

/// What a FieldExpression shares between its copies. Unless it is conditional, whoever reads the
/// case sees to it that its tables of t reach from the start to the end of the run: beyond, in the
/// last step, their last piece goes on.
struct FieldExpression::Compiled {
    std::uint64_t id;  ///< never used again within the program
    ExpressionParts parts;
};

/// Something wrong with an expression, at a byte of its text.
struct ExpressionError {
    std::size_t position;
    std::string message;
};

/// A name in an expression and where it stands.
struct Identifier {
    std::string name;
    std::size_t position;
    bool is_call;  ///< followed by "("
};

/// Names in the expression; the error when it contains what no expression has. Checked before
/// muParser sees the text, so that messages are ours and have a place.
std::vector<Identifier> scanExpression(std::string_view text,
                                       std::optional<ExpressionError>& error);

/// Names of functions and constants that every expression may use, sorted.
const std::vector<std::string>& expressionFunctions();
const std::vector<std::string>& expressionConstants();
/// Operators, constants and functions with their meaning, for people.
std::string expressionHelp();

/// One compiled expression. Not for two threads at once.
class ExpressionParser {
 public:
    /// The parts must outlive its evaluations. Throws ExpressionError.
    explicit ExpressionParser(const ExpressionParts& parts);
    ~ExpressionParser();
    /// Throws OutsideTable.
    double evaluate(double x, double y, double z, double t);

 private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace sphinx::input
