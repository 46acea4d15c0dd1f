// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/types.h"
#include "input/tree/place.h"

#include <array>
#include <cassert>
#include <cstdint>
#include <string>
#include <vector>

namespace sphinx::input {

/// Reference to a named thing of the case: a body, part ("gate.base"), material, method, ...
struct Name {
    std::string text;
    Place place;

    bool empty() const { return text.empty(); }
    bool operator==(const Name& other) const { return text == other.text; }
};

/// A point or vector with as many components as the case has dimensions, in case units.
struct Coordinates {
    std::array<double, 3> values{};
    int size = 0;

    template <int Dim>
    Vec<Dim> as() const {
        assert(size == Dim);
        return Vec<Dim>(values.data());
    }
    bool operator==(const Coordinates&) const = default;
};

/// Numbers in rows, given inline or read from a text file (one row a line in case units; blanks,
/// tabs, commas or semicolons between numbers; # starts a comment).
struct Table {
    std::vector<std::vector<double>> rows;
    std::string file;  ///< absolute path; empty when given inline
};

/// When something happens besides the start and the end: every so much time, steps or wall time.
struct Every {
    enum class By { ends, time, steps, wall_time };
    By by = By::ends;         ///< ends: only at the start and at the end
    double time = 0;          ///< interval, case units of time
    std::int64_t steps = 0;   ///< interval in steps of `layer`
    Name layer;               ///< empty: the outermost layer
    double wall_seconds = 0;  ///< interval in seconds of the clock on the wall
};

}  // namespace sphinx::input
