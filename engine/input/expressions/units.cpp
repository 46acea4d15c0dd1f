// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/expressions/units.h"

#include "core/types.h"
#include "input/expressions/characters.h"
#include "input/expressions/decimal.h"
#include "input/tree/suggest.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace sphinx::input {
namespace {

struct NamedUnit {
    std::string_view name;
    Unit unit;
};

constexpr std::array named_units{
    NamedUnit{"m", {unit::length, 1, 0}},
    NamedUnit{"km", {unit::length, 1, 3}},
    NamedUnit{"cm", {unit::length, 1, -2}},
    NamedUnit{"mm", {unit::length, 1, -3}},
    NamedUnit{"um", {unit::length, 1, -6}},
    NamedUnit{"s", {unit::time, 1, 0}},
    NamedUnit{"ms", {unit::time, 1, -3}},
    NamedUnit{"us", {unit::time, 1, -6}},
    NamedUnit{"min", {unit::time, 60, 0}},
    NamedUnit{"h", {unit::time, 3600, 0}},
    NamedUnit{"kg", {unit::mass, 1, 0}},
    NamedUnit{"g", {unit::mass, 1, -3}},
    NamedUnit{"mg", {unit::mass, 1, -6}},
    NamedUnit{"t", {unit::mass, 1, 3}},
    NamedUnit{"N", {unit::force, 1, 0}},
    NamedUnit{"mN", {unit::force, 1, -3}},
    NamedUnit{"kN", {unit::force, 1, 3}},
    NamedUnit{"MN", {unit::force, 1, 6}},
    NamedUnit{"Pa", {unit::pressure, 1, 0}},
    NamedUnit{"mPa", {unit::pressure, 1, -3}},
    NamedUnit{"hPa", {unit::pressure, 1, 2}},
    NamedUnit{"kPa", {unit::pressure, 1, 3}},
    NamedUnit{"MPa", {unit::pressure, 1, 6}},
    NamedUnit{"GPa", {unit::pressure, 1, 9}},
    NamedUnit{"bar", {unit::pressure, 1, 5}},
    NamedUnit{"J", {unit::energy, 1, 0}},
    NamedUnit{"mJ", {unit::energy, 1, -3}},
    NamedUnit{"kJ", {unit::energy, 1, 3}},
    NamedUnit{"W", {unit::energy / unit::time, 1, 0}},
    NamedUnit{"kW", {unit::energy / unit::time, 1, 3}},
    NamedUnit{"Hz", {unit::frequency, 1, 0}},
    NamedUnit{"kHz", {unit::frequency, 1, 3}},
    NamedUnit{"rad", {unit::none, 1, 0}},
    NamedUnit{"deg", {unit::none, 3.14159265358979323846 / 180, 0}},
};

const Unit* findUnit(std::string_view name) {
    for (const NamedUnit& named : named_units)
        if (named.name == name) return &named.unit;
    return nullptr;
}

void multiply(Unit& product, const Unit& by, int power) {
    product.dimension.length += power * by.dimension.length;
    product.dimension.time += power * by.dimension.time;
    product.dimension.mass += power * by.dimension.mass;
    product.factor *= std::pow(by.factor, power);
    product.exponent += power * by.exponent;
}

/// "a^2*b/c" of three base names; "-" when there is nothing.
std::string powers(Dimension d, std::string_view length, std::string_view time,
                   std::string_view mass) {
    std::string above;
    std::string below;
    int divisors = 0;
    const auto add = [&](std::string_view name, int power) {
        if (power == 0) return;
        std::string& side = power > 0 ? above : below;
        if (power < 0) ++divisors;
        if (!side.empty()) side += '*';
        side += name;
        if (std::abs(power) > 1) side += "^" + std::to_string(std::abs(power));
    };
    add(mass, d.mass);
    add(length, d.length);
    add(time, d.time);
    if (above.empty() && below.empty()) return "-";
    if (below.empty()) return above;
    return (above.empty() ? "1" : above) + "/" + (divisors > 1 ? "(" + below + ")" : below);
}

}  // namespace

std::optional<Unit> parseUnit(std::string_view text) {
    // Factors between * and /, left to right, each with an optional whole power; "1/s" is allowed,
    // and one pair of parentheses below the line: kg/(m*s).
    Unit product;
    int sign = 1;
    bool inside = false;
    std::size_t k = 0;
    for (;;) {
        if (k < text.size() && text[k] == '(' && sign < 0 && !inside) {
            inside = true;
            ++k;
        }
        const std::size_t begin = k;
        while (k < text.size() && isLetter(text[k])) ++k;
        const Unit* found = findUnit(text.substr(begin, k - begin));
        if (!found && begin == 0 && text.starts_with("1/")) {
            k = 1;
        } else if (!found) {
            return std::nullopt;
        } else {
            int power = 1;
            if (k < text.size() && text[k] == '^') {
                const char* first = text.data() + k + 1;
                const auto [end, error] = std::from_chars(first, text.data() + text.size(), power);
                if (error != std::errc() || power == 0 || std::abs(power) > 9) return std::nullopt;
                k = static_cast<std::size_t>(end - text.data());
            }
            multiply(product, *found, sign * power);
        }
        if (inside && k < text.size() && text[k] == ')') {
            inside = false;
            ++k;
        }
        if (k == text.size()) break;
        if (text[k] != '*' && text[k] != '/') return std::nullopt;
        if (!inside) sign = text[k] == '/' ? -1 : 1;
        if (inside && text[k] == '/') return std::nullopt;
        ++k;
    }
    if (inside || std::abs(product.exponent) > 300) return std::nullopt;
    return product;
}

namespace {

/// "1 kg / m3" and "kg m^-3" as they should be written: kg/m^3.
std::string tidyUnit(std::string_view text) {
    std::string tidy;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const char c = text[k];
        const bool digit = c >= '0' && c <= '9';
        if (digit && tidy.empty()) continue;
        if (c == ' ') {
            // Between two factors it stands for a product.
            const std::size_t next = text.find_first_not_of(' ', k);
            if (next != text.npos && isLetter(text[next]) && !tidy.empty() && tidy.back() != '*' &&
                tidy.back() != '/')
                tidy += '*';
            continue;
        }
        if (digit && isLetter(tidy.back())) tidy += '^';
        tidy += c;
    }
    // m^-3 behind a product is a quotient.
    for (std::size_t minus; (minus = tidy.find("^-")) != tidy.npos;) {
        const std::size_t factor = tidy.rfind('*', minus);
        if (factor == tidy.npos) break;
        tidy.erase(minus + 1, 1);
        if (tidy.substr(minus, 2) == "^1") tidy.erase(minus, 2);
        tidy[factor] = '/';
    }
    return tidy;
}

}  // namespace

std::string suggestUnit(std::string_view text) {
    if (const std::string tidy = tidyUnit(text); parseUnit(tidy))
        return "; did you mean '" + tidy + "'?";
    std::vector<std::string> names;
    for (const NamedUnit& named : named_units) names.emplace_back(named.name);
    // The first factor that is no unit is the one to talk about.
    for (std::size_t begin = 0; begin < text.size();) {
        std::size_t end = begin;
        while (end < text.size() && isLetter(text[end])) ++end;
        const std::string_view factor = text.substr(begin, end - begin);
        if (!factor.empty() && !findUnit(factor)) return didYouMean(factor, names);
        begin = std::max(end, begin + 1);
    }
    return "";
}

std::string unitNames() {
    std::vector<std::string> names;
    for (const NamedUnit& named : named_units) names.emplace_back(named.name);
    return joined(names);
}

namespace {

/// The number with its decimal point moved: 9.8 and -3 give what 0.0098 reads as.
double shifted(double value, int exponent) {
    const std::string text = fmt::format("{}", value);
    const auto e = text.find('e');
    int own = 0;
    if (e != std::string::npos)
        std::from_chars(text.data() + e + 1 + (text[e + 1] == '+'), text.data() + text.size(), own);
    const auto moved =
        parseDecimal<double>(fmt::format("{}e{}", text.substr(0, e), own + exponent));
    return moved.value_or(nan_value);
}

}  // namespace

double UnitSystem::convert(double value, const Unit& given) const {
    Unit ratio = given;
    for (const auto& [name, power] :
         {std::pair(&length, given.dimension.length), std::pair(&time, given.dimension.time),
          std::pair(&mass, given.dimension.mass)})
        if (power != 0) multiply(ratio, *findUnit(*name), -power);
    value *= ratio.factor;
    return ratio.exponent == 0 ? value : shifted(value, ratio.exponent);
}

std::string UnitSystem::text(Dimension dimension) const {
    if (none || dimension == unit::none) return "";
    if (length == "m" && time == "s" && mass == "kg") {
        if (dimension == unit::pressure) return "Pa";
        if (dimension == unit::force) return "N";
        if (dimension == unit::energy) return "J";
    }
    return powers(dimension, length, time, mass);
}

std::string UnitSystem::suffix(Dimension dimension) const {
    const std::string unit = text(dimension);
    return unit.empty() ? "" : " " + unit;
}

std::string dimensionText(Dimension dimension) {
    return powers(dimension, "length", "time", "mass");
}

std::string siText(Dimension dimension) {
    if (dimension == unit::pressure) return "Pa";
    if (dimension == unit::force) return "N";
    if (dimension == unit::energy) return "J";
    if (dimension == unit::dynamic_viscosity) return "Pa*s";
    return powers(dimension, "m", "s", "kg");
}

}  // namespace sphinx::input
