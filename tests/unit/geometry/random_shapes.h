// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shape.h"

#include <cmath>
#include <random>
#include <string>

namespace sphinx::geometry {

/// Numbers that are the same with every standard library.
class Random {
 public:
    explicit Random(unsigned seed) : engine_(seed) {}
    double between(double low, double high) {
        return low + (high - low) * engine_() / 4294967296.0;
    }

 private:
    std::mt19937 engine_;
};

/// Star around the origin: simple, with sharp convex and reflex corners.
inline std::vector<Vec<2>> randomStar(Random& random, int corners) {
    std::vector<Vec<2>> points;
    for (int i = 0; i < corners; ++i) {
        const double angle = 6.283185307179586 * (i + random.between(0, 0.9)) / corners;
        points.push_back(random.between(0.3, 1) * Vec<2>(std::cos(angle), std::sin(angle)));
    }
    return points;
}

/// The message of the ShapeError that `make` throws, or what happened instead.
template <class Make>
std::string messageOf(Make&& make) {
    try {
        make();
    } catch (const ShapeError& error) {
        return error.what();
    }
    return "no ShapeError";
}

inline ShapePointer<2> box(double x0, double y0, double x1, double y1) {
    return makeBox<2>({x0, y0}, {x1, y1});
}

}  // namespace sphinx::geometry
