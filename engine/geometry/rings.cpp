// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "geometry/rings.h"

#include <algorithm>
#include <cmath>

namespace sphinx::geometry {

double signedArea(const Ring& ring) {
    double sum = 0;
    // Relative to the first point: far from the origin the products would cancel.
    for (std::size_t i = 2; i < ring.size(); ++i) {
        sum += cross(ring[i - 1] - ring[0], ring[i] - ring[0]);
    }
    return 0.5 * sum;
}

Box<2> boundsOf(const Rings& rings) {
    Box<2> box;
    for (const Ring& ring : rings) {
        for (const Vec<2>& p : ring) box.include(p);
    }
    return box;
}

Rings withoutSlivers(Rings rings) {
    Rings kept;
    for (Ring& ring : rings) {
        ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
        while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
        double length = 0, largest = 0;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            length += (ring[(i + 1) % ring.size()] - ring[i]).norm();
            largest = std::max(largest, ring[i].cwiseAbs().maxCoeff());
        }
        const double rounding = 16 * std::numeric_limits<double>::epsilon() * largest;
        if (std::abs(signedArea(ring)) > length * rounding) kept.push_back(std::move(ring));
    }
    return kept;
}

}  // namespace sphinx::geometry
