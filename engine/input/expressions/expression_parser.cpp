// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/expressions/expression_parser.h"

#include "input/expressions/characters.h"
#include "input/expressions/decimal.h"

#include <muParser.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <numbers>

namespace sphinx::input {
namespace {

constexpr std::size_t longest_expression = 2000;
constexpr int deepest_parentheses = 50;

struct Function {
    const char* name;
    double (*one)(double);
    const char* doc;
};
constexpr std::array functions{
    Function{"abs", [](double x) { return std::abs(x); }, "absolute value"},
    Function{"acos", [](double x) { return std::acos(x); }, "inverse of cos, radian"},
    Function{"asin", [](double x) { return std::asin(x); }, "inverse of sin, radian"},
    Function{"atan", [](double x) { return std::atan(x); }, "inverse of tan, radian"},
    Function{"ceil", [](double x) { return std::ceil(x); }, "next whole number above"},
    Function{"cos", [](double x) { return std::cos(x); }, "cosine of radian"},
    Function{"cosh", [](double x) { return std::cosh(x); }, "hyperbolic cosine"},
    Function{"exp", [](double x) { return std::exp(x); }, "e to the power"},
    Function{"floor", [](double x) { return std::floor(x); }, "next whole number below"},
    Function{"ln", [](double x) { return std::log(x); }, "natural logarithm"},
    Function{"log10", [](double x) { return std::log10(x); }, "decimal logarithm"},
    Function{"sin", [](double x) { return std::sin(x); }, "sine of radian"},
    Function{"sinh", [](double x) { return std::sinh(x); }, "hyperbolic sine"},
    Function{"sqrt", [](double x) { return std::sqrt(x); }, "square root"},
    Function{"tan", [](double x) { return std::tan(x); }, "tangent of radian"},
    Function{"tanh", [](double x) { return std::tanh(x); }, "hyperbolic tangent"},
};

double smallest(const double* values, int n) {
    return n > 0 ? *std::min_element(values, values + n) : nan_value;
}
double largest(const double* values, int n) {
    return n > 0 ? *std::max_element(values, values + n) : nan_value;
}
double angle(double y, double x) { return std::atan2(y, x); }

bool isWord(char c) { return isLetter(c) || c == '_' || isDigit(c); }

std::size_t endOfNumber(std::string_view text, std::size_t k) {
    while (k < text.size() && (isDigit(text[k]) || text[k] == '.')) ++k;
    if (k < text.size() && (text[k] == 'e' || text[k] == 'E')) {
        std::size_t digits = k + 1;
        if (digits < text.size() && (text[digits] == '+' || text[digits] == '-')) ++digits;
        if (digits < text.size() && isDigit(text[digits])) {
            k = digits;
            while (k < text.size() && isDigit(text[k])) ++k;
        }
    }
    return k;
}

std::string wordAt(std::string_view text, std::size_t begin) {
    std::size_t end = begin;
    while (end < text.size() && (isWord(text[end]) || text[end] == '.')) ++end;
    return std::string(text.substr(begin, end - begin));
}

std::string explain(const mu::Parser::exception_type& e) {
    switch (e.GetCode()) {
        case mu::ecUNEXPECTED_EOF: return "the expression ends too early";
        case mu::ecUNEXPECTED_OPERATOR: return "unexpected operator '" + e.GetToken() + "'";
        case mu::ecUNEXPECTED_VAL:
        case mu::ecUNEXPECTED_VAR:
        case mu::ecUNEXPECTED_FUN: return "an operator is missing before '" + e.GetToken() + "'";
        case mu::ecUNEXPECTED_PARENS: return "unexpected parenthesis '" + e.GetToken() + "'";
        case mu::ecUNEXPECTED_ARG_SEP: return "unexpected comma";
        case mu::ecTOO_MANY_PARAMS: return "too many arguments for " + e.GetToken();
        case mu::ecTOO_FEW_PARAMS: return "too few arguments for " + e.GetToken();
        case mu::ecMISSING_ELSE_CLAUSE: return "'?' without ':'";
        case mu::ecMISPLACED_COLON: return "':' without '?'";
        default: return "not an expression";
    }
}

}  // namespace

std::vector<Identifier> scanExpression(std::string_view text,
                                       std::optional<ExpressionError>& error) {
    std::vector<Identifier> identifiers;
    struct Parenthesis {
        std::size_t position;
        bool is_call;
    };
    std::vector<Parenthesis> open;
    bool operand = false;  // a number or name stands before, with nothing but blanks between
    const auto fail = [&](std::size_t position, std::string message) {
        error = ExpressionError{position, std::move(message)};
        return identifiers;
    };
    if (text.size() > longest_expression)
        return fail(0, "the expression is longer than " + std::to_string(longest_expression) +
                           " characters");
    for (std::size_t k = 0; k < text.size();) {
        const char c = text[k];
        if ((isDigit(c) || isWord(c)) && operand)
            return fail(k, "an operator is missing before '" + wordAt(text, k) + "'");
        operand = isDigit(c) || c == '.' || isWord(c) || (operand && c == ' ');
        if (isDigit(c) || c == '.') {
            const std::size_t begin = k;
            k = endOfNumber(text, k);
            const std::string_view number = text.substr(begin, k - begin);
            if (isBeyondRange(number) && (k == text.size() || !isWord(text[k])))
                return fail(begin, "'" + std::string(number) +
                                       "' is beyond the range of numbers, 1e-307 to 1e308");
            if ((k < text.size() && isWord(text[k])) || !parseDecimal<double>(number))
                return fail(begin, "'" + wordAt(text, begin) + "' is not a number");
            continue;
        }
        if (isWord(c)) {
            const std::size_t begin = k;
            while (k < text.size() && isWord(text[k])) ++k;
            std::size_t next = k;
            while (next < text.size() && text[next] == ' ') ++next;
            identifiers.push_back({std::string(text.substr(begin, k - begin)), begin,
                                   next < text.size() && text[next] == '('});
            continue;
        }
        if (c == '(')
            open.push_back(
                {k, !identifiers.empty() && identifiers.back().is_call &&
                        text.find_first_not_of(' ', identifiers.back().position +
                                                        identifiers.back().name.size()) == k});
        if (c == ',' && (open.empty() || !open.back().is_call)) return fail(k, "unexpected comma");
        if (static_cast<int>(open.size()) > deepest_parentheses)
            return fail(k, "parentheses are nested too deeply");
        if (c == ')') {
            if (open.empty()) return fail(k, "')' without '('");
            open.pop_back();
        }
        const std::string_view two = text.substr(k, 2);
        if (two == "<=" || two == ">=" || two == "==" || two == "!=" || two == "&&" ||
            two == "||") {
            k += 2;
            continue;
        }
        if (two == "**") return fail(k, "a power is written a^b");
        if (c == '=') return fail(k, "'=' does not belong here; equality is written ==");
        if (std::string_view("+-*/^()<>?:, ").find(c) == std::string_view::npos || c == '\0')
            return fail(k, std::string("unexpected ") + (static_cast<unsigned char>(c) < 0x80
                                                             ? "'" + std::string(1, c) + "'"
                                                             : "character"));
        ++k;
    }
    if (!open.empty()) return fail(open.back().position, "'(' is never closed");
    return identifiers;
}

const std::vector<std::string>& expressionFunctions() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all{"atan2", "max", "min"};
        for (const Function& f : functions) all.emplace_back(f.name);
        std::sort(all.begin(), all.end());
        return all;
    }();
    return names;
}

const std::vector<std::string>& expressionConstants() {
    static const std::vector<std::string> names{"e", "pi"};
    return names;
}

std::string expressionHelp() {
    std::string text =
        "+ - * / ^ (right to left), < <= > >= == !=, && ||, condition ? a : b; pi, e";
    for (const Function& f : functions) text += "; " + std::string(f.name) + "(a) " + f.doc;
    return text + "; atan2(y, x) angle of a point, radian; max(a, b, ...); min(a, b, ...)";
}

namespace {

/// Names of functions and constants for every text.
void defineWords(mu::Parser& parser) {
    parser.ClearFun();
    parser.ClearConst();
    for (const Function& f : functions) parser.DefineFun(f.name, f.one);
    parser.DefineFun("atan2", angle);
    parser.DefineFun("min", smallest);
    parser.DefineFun("max", largest);
    parser.DefineConst("pi", std::numbers::pi);
    parser.DefineConst("e", std::numbers::e);
}

}  // namespace

struct ExpressionParser::Implementation {
    /// What muParser hands to the function of a table.
    struct TableCall {
        UsedTable used;
        const Implementation* in;
    };
    /// A text of its own: the whole, or a variable that depends on place or time. muParser sees a
    /// variable as a function without arguments, so that only the chosen side of a condition is
    /// worked out.
    struct Part {
        const ExpressionParts* written;
        Implementation* in;
        std::unique_ptr<mu::Parser> parser = {};  // once it is needed
        std::uint64_t evaluation = 0;             // in which `value` was found
        double value = 0;
    };

    static double callTable(void* data, double argument) {
        const auto& [used, in] = *static_cast<const TableCall*>(data);
        if (in->compiling) return 0;
        const bool known = !used.of_time.empty() && !in->conditional && argument == in->t;
        return known ? used.table->continued(argument) : (*used.table)(argument);
    }
    static double callVariable(void* data) {
        Part& part = *static_cast<Part*>(data);
        if (part.in->compiling) return 0;
        if (!part.parser) part.in->compile(part);
        if (part.evaluation != part.in->evaluation) {
            part.value = part.parser->Eval();
            part.evaluation = part.in->evaluation;
        }
        return part.value;
    }

    Part& partOf(const ExpressionParts& written) {
        return parts.try_emplace(&written, &written, this).first->second;
    }
    void compile(Part& part);

    std::map<const ExpressionParts*, Part> parts;
    std::deque<TableCall> calls;
    Part* whole = nullptr;
    double x = 0, y = 0, z = 0, t = 0;
    bool conditional = false;
    bool compiling = false;  // muParser compiles by evaluating somewhere
    std::uint64_t evaluation = 0;
};

void ExpressionParser::Implementation::compile(Part& part) {
    const ExpressionParts& written = *part.written;
    part.parser = std::make_unique<mu::Parser>();
    mu::Parser& parser = *part.parser;
    std::string text;  // with variables as calls
    std::vector<std::size_t> calls_at;
    std::optional<ExpressionError> wrong;
    std::size_t copied = 0;
    for (const Identifier& name : scanExpression(written.text, wrong)) {
        if (!written.variables.contains(name.name)) continue;
        const std::size_t end = name.position + name.name.size();
        text += written.text.substr(copied, end - copied) + "()";
        calls_at.push_back(end);
        copied = end;
    }
    text += written.text.substr(copied);
    try {
        defineWords(parser);
        for (const auto& [name, value] : written.constants) parser.DefineConst(name, value);
        for (const auto& [name, variable] : written.variables)
            parser.DefineFunUserData(name, &callVariable, &partOf(*variable));
        for (const auto& [name, used] : written.tables)
            parser.DefineFunUserData(name, &callTable, &calls.emplace_back(used, this));
        parser.DefineVar("x", &x);
        parser.DefineVar("y", &y);
        parser.DefineVar("z", &z);
        parser.DefineVar("t", &t);
        parser.EnableOptimizer(false);  // it would change the order of operations, and so the bits
        parser.SetExpr(text);
        compiling = true;
        parser.Eval();
        compiling = false;
    } catch (const mu::Parser::exception_type& e) {
        std::size_t position = e.GetPos();
        for (std::size_t k = calls_at.size(); k-- > 0;)
            if (position > calls_at[k] + 2 * k) position -= std::min<std::size_t>(2, position);
        throw ExpressionError{std::min(position, written.text.size()), explain(e)};
    }
}

ExpressionParser::ExpressionParser(const ExpressionParts& parts)
    : implementation_(std::make_unique<Implementation>()) {
    implementation_->whole = &implementation_->partOf(parts);
    implementation_->conditional = parts.conditional;
    implementation_->compile(*implementation_->whole);
}

ExpressionParser::~ExpressionParser() = default;

double ExpressionParser::evaluate(double x, double y, double z, double t) {
    implementation_->x = x;
    implementation_->y = y;
    implementation_->z = z;
    implementation_->t = t;
    ++implementation_->evaluation;
    return implementation_->whole->parser->Eval();
}

}  // namespace sphinx::input
