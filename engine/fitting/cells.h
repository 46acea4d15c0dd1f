// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shape.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sphinx::fitting {

/// Cubic cells of a grid whose faces meet a point.
template <int Dim>
struct Cells {
    double size = 0;
    Vec<Dim> origin = Vec<Dim>::Zero();

    Vec<Dim> center(const std::array<long, Dim>& index) const {
        Vec<Dim> x;
        for (int k = 0; k < Dim; ++k)
            x[k] = origin[k] + (static_cast<double>(index[k]) + 0.5) * size;
        return x;
    }
};

/// Calls use(center, distance) for the cells whose centres have a signed distance of `least` to
/// `most` from the shape, x fastest within blocks of cells. Of blocks that lie deeper inside than
/// that it calls within(number of cells). A signed distance is never larger than the way to the
/// surface, so one at the centre of a block tells of all its cells.
template <int Dim, class Use, class Within>
void forEachCell(const geometry::Shape<Dim>& shape, const Cells<Dim>& cells, double least,
                 double most, Use&& use, Within&& within) {
    constexpr long side = 8;  // of a block, in cells
    const double radius = 0.5 * side * cells.size * std::sqrt(static_cast<double>(Dim));
    constexpr double rounding = 1e-9;  // of a cell
    const Cells<Dim> blocks{side * cells.size, cells.origin};
    const Box<Dim> bounds = shape.bounds();
    const double around = std::max(most, 0.0) + cells.size;
    std::array<long, Dim> first{}, last{};
    for (int k = 0; k < Dim; ++k) {
        first[k] =
            std::lround(std::floor((bounds.lower[k] - around - cells.origin[k]) / blocks.size));
        last[k] =
            std::lround(std::floor((bounds.upper[k] + around - cells.origin[k]) / blocks.size));
    }
    const auto forEach = [](const std::array<long, Dim>& from, const std::array<long, Dim>& to,
                            auto&& call) {
        std::array<long, Dim> index = from;
        for (;;) {
            call(index);
            int k = 0;
            for (; k < Dim; ++k) {
                if (++index[k] <= to[k]) break;
                index[k] = from[k];
            }
            if (k == Dim) return;
        }
    };
    std::size_t per_block = 1;
    for (int k = 0; k < Dim; ++k) per_block *= side;
    forEach(first, last, [&](const std::array<long, Dim>& block) {
        const double distance = shape.signedDistance(blocks.center(block));
        if (distance > most + radius + rounding * cells.size) return;
        if (distance < least - radius - rounding * cells.size) return within(per_block);
        std::array<long, Dim> from{}, to{};
        for (int k = 0; k < Dim; ++k) {
            from[k] = side * block[k];
            to[k] = from[k] + side - 1;
        }
        forEach(from, to, [&](const std::array<long, Dim>& index) {
            const Vec<Dim> center = cells.center(index);
            const double at = shape.signedDistance(center);
            if (at < least) return within(std::size_t{1});
            if (at <= most) use(center, at);
        });
    });
}

/// How much of the width of a cell, along the nearest normal, lies outside of a shape from whose
/// surface its centre has that signed distance: right for a face that runs along the cells, and on
/// average over the places of a cell for any other.
template <int Dim>
double partOutside(const geometry::Shape<Dim>& shape, const Vec<Dim>& center, double distance,
                   double size) {
    const double width = size * shape.normal(center).template lpNorm<1>();
    const double part = std::clamp(0.5 + distance / width, 0.0, 1.0);
    // Cells side by side with a face are whole.
    constexpr double rounding = 1e-6;
    return part < rounding ? 0 : part > 1 - rounding ? 1 : part;
}

}  // namespace sphinx::fitting
