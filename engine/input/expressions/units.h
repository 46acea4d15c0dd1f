// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/unit.h"

#include <optional>
#include <string>
#include <string_view>

namespace sphinx::input {

/// A unit as a multiple of SI: factor * 10^exponent. Powers of ten are kept apart because
/// moving the decimal point is exact: 2 cm is the same double as 0.02.
struct Unit {
    Dimension dimension;
    double factor = 1;
    int exponent = 0;
};

/// The unit that a text such as "kg/m^3" or "Pa*s" names; nothing when it is not one.
std::optional<Unit> parseUnit(std::string_view text);
/// "m, km, cm, ...": all names that units are made of.
std::string unitNames();
/// Unit names close to a wrong one, for messages.
std::string suggestUnit(std::string_view text);

/// Units of the bare numbers of a case.
struct UnitSystem {
    bool none = false;  ///< numbers without dimension: quantities are refused
    std::string length = "m";
    std::string time = "s";
    std::string mass = "kg";

    /// value in `unit`, in the units of the case; the dimension is not checked.
    double convert(double value, const Unit& unit) const;
    /// The unit of a quantity as results and messages name it: "mg/mm^3", in SI also Pa, N and J.
    /// Empty for a plain number and with `none`.
    std::string text(Dimension dimension) const;
    /// The same behind a number: " mg/mm^3".
    std::string suffix(Dimension dimension) const;
};

/// "mass/length^3", or "-" for a plain number.
std::string dimensionText(Dimension dimension);
/// "kg/m^3", or "-".
std::string siText(Dimension dimension);

}  // namespace sphinx::input
