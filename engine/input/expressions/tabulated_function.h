// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/unit.h"
#include "input/expressions/units.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace sphinx::input {

enum class Interpolation {
    linear,
    cubic,  ///< the natural cubic spline: two continuous derivatives, no curvature at the ends
};

enum class Outside {
    error,
    hold,  ///< the first or the last value
};

/// A function of one argument by its values at some places: an entry of `tables`. Arguments and
/// values are in case units.
class TabulatedFunction {
 public:
    struct Column {
        std::vector<double> numbers;
        std::optional<Dimension> dimension;  ///< nothing where bare numbers stand for any
    };

    /// At least two rows; the arguments increase strictly.
    TabulatedFunction(std::string name, Column argument, Column value, Interpolation interpolation,
                      Outside outside, const UnitSystem& units);

    /// Throws OutsideTable.
    double operator()(double argument) const;
    /// The same, but beyond its ends the first or the last piece goes on unless it is held.
    double continued(double argument) const;

    const std::string& name() const { return name_; }
    double first() const { return argument_.numbers.front(); }
    double last() const { return argument_.numbers.back(); }
    Outside outside() const { return outside_; }
    std::optional<Dimension> argumentDimension() const { return argument_.dimension; }
    std::optional<Dimension> valueDimension() const { return value_.dimension; }
    const UnitSystem& units() const { return units_; }

    /// "2 s", of an argument.
    std::string argumentText(double argument) const;
    /// "the table 'paddle' has values from 0 s to 2 s".
    std::string rangeText() const;

 private:
    std::string name_;
    Column argument_, value_;
    std::vector<double> curvature_;  // second derivatives at the rows; empty: linear
    Outside outside_;
    UnitSystem units_;
};

using TablePointer = std::shared_ptr<const TabulatedFunction>;

/// What a table was asked for that it does not have.
struct OutsideTable {
    const TabulatedFunction* table;
    double argument;
};

}  // namespace sphinx::input
