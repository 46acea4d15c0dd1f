// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/expressions/expression.h"
#include "input/expressions/tabulated_function.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sphinx::input {

/// A table that an expression uses.
struct UsedTable {
    TablePointer table;
    /// It is asked for the time, and whoever reads the case knows by then that it reaches from the
    /// start to the end of the run: beyond, in the last step, its last piece goes on.
    bool of_time = false;
};

/// A text with the meaning of its names.
struct ExpressionParts {
    std::string text;
    std::map<std::string, double> constants;  ///< variables of the case that it uses
    std::map<std::string, UsedTable> tables;
};

/// What a FieldExpression shares between its copies.
struct FieldExpression::Compiled {
    std::uint64_t id;  ///< never used again within the program
    ExpressionParts parts;
    bool uses_time;
    bool uses_place;
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
    /// Throws ExpressionError.
    explicit ExpressionParser(const ExpressionParts& parts);
    ~ExpressionParser();
    /// Throws OutsideTable.
    double evaluate(double x, double y, double z, double t);

 private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace sphinx::input
