// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/output/factory.h"
#include "io/series/series.h"
#include "scene.h"

#include <string>
#include <vector>

namespace sphinx::test {

/// What outputs of a scene are built from.
template <int Dim>
io::OutputContext<Dim> outputContext(Scene<Dim>& scene, const io::Path& folder = {}) {
    return {scene.world, scene.relations,           folder, {}, {},
            nullptr,     [] { return Progress{}; }, {},     {}, {}};
}

/// What throws, says.
template <class F>
std::string errorOf(F&& f) {
    try {
        f();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

inline Clock clockAt(double time, double dt = 0) {
    Clock clock;
    clock.time = time;
    clock.dt = dt;
    return clock;
}

inline std::vector<double> rowOf(io::SeriesSource& source) {
    std::size_t width = 0;
    for (const io::SeriesQuantity& quantity : source.quantities()) width += quantity.size();
    std::vector<double> row(width);
    source.sample(Clock{}, row);
    return row;
}

}  // namespace sphinx::test
