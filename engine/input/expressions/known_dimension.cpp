// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/expressions/known_dimension.h"

#include "input/expressions/characters.h"
#include "input/expressions/units.h"

#include <fmt/format.h>

namespace sphinx::input {
namespace {

/// Reads an expression from left to right. Where it meets what it does not follow (comparisons,
/// logic), it gives up: nothing is known then.
class Walk {
 public:
    Walk(std::string_view text, const KnownNames& names, std::optional<ExpressionError>& error)
        : text_(text), names_(names), error_(error) {}

    KnownDimension whole() {
        const KnownDimension result = sum();
        return peek() == '\0' && !given_up_ ? result : std::nullopt;
    }

 private:
    char peek() {
        while (at_ < text_.size() && text_[at_] == ' ') ++at_;
        return at_ < text_.size() && !given_up_ ? text_[at_] : '\0';
    }
    bool accept(char c) {
        if (peek() != c) return false;
        ++at_;
        return true;
    }

    /// Both have the dimension that one of them is known to have.
    KnownDimension same(const KnownDimension& a, const KnownDimension& b, std::size_t position) {
        if (a && b && *a != *b && !error_)
            error_ = ExpressionError{position, fmt::format("{} and {} do not go together",
                                                           dimensionText(*a), dimensionText(*b))};
        return a ? a : b;
    }

    KnownDimension sum() {
        KnownDimension result = product();
        for (char c = peek(); c == '+' || c == '-'; c = peek()) {
            const std::size_t position = at_++;
            result = same(result, product(), position);
        }
        return result;
    }
    KnownDimension product() {
        KnownDimension result = power();
        for (char c = peek(); c == '*' || c == '/'; c = peek()) {
            ++at_;
            const KnownDimension factor = power();
            if (!result || !factor)
                result.reset();
            else
                result = c == '*' ? *result * *factor : *result / *factor;
        }
        return result;
    }
    KnownDimension power() {
        if (accept('-') || accept('+')) return power();
        const KnownDimension base = value();
        if (!accept('^')) return base;
        const std::size_t begin = at_;
        power();
        // Of whole exponents that are written out.
        const std::string_view exponent = text_.substr(begin, at_ - begin);
        if (!base || exponent.size() != 1 || !isDigit(exponent[0])) return std::nullopt;
        Dimension result;
        for (int k = 0; k < exponent[0] - '0'; ++k) result = result * *base;
        return result;
    }
    KnownDimension value() {
        const char c = peek();
        if (accept('(')) {
            const KnownDimension inside = sum();
            if (!accept(')')) given_up_ = true;
            return inside;
        }
        if (isDigit(c) || c == '.') {
            number();
            return std::nullopt;
        }
        if (!isLetter(c) && c != '_') {
            given_up_ = true;
            return std::nullopt;
        }
        const std::string_view name = word();
        return accept('(') ? call(name) : names_.dimension(name);
    }
    /// Of x, y, z or t, which stand for any dimension elsewhere, as the whole argument of a call.
    KnownDimension ofField() {
        const char field = peek();
        const std::size_t next = text_.find_first_not_of(' ', at_ + 1);
        if (field == '\0' || next == std::string_view::npos || text_[next] != ')') return {};
        if (field == 't') return unit::time;
        return field == 'x' || field == 'y' || field == 'z' ? KnownDimension(unit::length)
                                                            : std::nullopt;
    }
    KnownDimension tableCall(const TabulatedFunction& table) {
        const KnownDimension field = ofField();
        const std::size_t position = at_;
        const KnownDimension inside = sum();
        const KnownDimension given = field ? field : inside;
        const KnownDimension wanted = table.argumentDimension();
        if (given && wanted && *given != *wanted && !error_)
            error_ = ExpressionError{
                position, fmt::format("the argument of {} is {} but must be {}", table.name(),
                                      dimensionWords(*given), dimensionWords(*wanted))};
        if (!accept(')')) given_up_ = true;
        return table.valueDimension();
    }
    KnownDimension call(std::string_view function) {
        if (const TabulatedFunction* table = names_.table(function)) return tableCall(*table);
        const std::size_t position = at_;
        KnownDimension common = sum();
        const bool compares = function == "min" || function == "max";
        while (accept(',')) {
            const KnownDimension next = sum();
            if (compares) common = same(common, next, position);
        }
        if (!accept(')')) given_up_ = true;
        if (compares || function == "abs") return common;
        const auto even = [](int exponent) { return exponent % 2 == 0; };
        if (function == "sqrt" && common && even(common->length) && even(common->time) &&
            even(common->mass))
            return Dimension{common->length / 2, common->time / 2, common->mass / 2};
        return std::nullopt;
    }

    void number() {
        const auto digits = [&] {
            while (at_ < text_.size() && (isDigit(text_[at_]) || text_[at_] == '.')) ++at_;
        };
        digits();
        if (at_ >= text_.size() || (text_[at_] != 'e' && text_[at_] != 'E')) return;
        ++at_;
        if (at_ < text_.size() && (text_[at_] == '+' || text_[at_] == '-')) ++at_;
        digits();
    }
    std::string_view word() {
        const std::size_t begin = at_;
        while (at_ < text_.size() &&
               (isLetter(text_[at_]) || isDigit(text_[at_]) || text_[at_] == '_'))
            ++at_;
        return text_.substr(begin, at_ - begin);
    }

    std::string_view text_;
    const KnownNames& names_;
    std::optional<ExpressionError>& error_;
    std::size_t at_ = 0;
    bool given_up_ = false;
};

}  // namespace

KnownDimension knownDimension(std::string_view text, const KnownNames& names,
                              std::optional<ExpressionError>& error) {
    return Walk(text, names, error).whole();
}

std::string dimensionWords(Dimension dimension) {
    return dimension == unit::none ? "a plain number" : dimensionText(dimension);
}

}  // namespace sphinx::input
