// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/series/columns.h"

namespace sphinx::io {

template <int Dim>
std::vector<std::string> componentLabels(particles::Rank rank) {
    static const std::string axes[] = {"x", "y", "z"};
    std::vector<std::string> labels;
    if (rank == particles::Rank::vector) labels.assign(axes, axes + Dim);
    if (rank == particles::Rank::matrix)
        for (int row = 0; row < Dim; ++row)
            for (int column = 0; column < Dim; ++column) labels.push_back(axes[row] + axes[column]);
    return labels;
}

std::vector<std::string> pointLabels(std::size_t points,
                                     const std::vector<std::string>& components) {
    if (points == 1) return components;
    std::vector<std::string> labels;
    for (std::size_t point = 0; point < points; ++point) {
        if (components.empty()) labels.push_back(std::to_string(point));
        for (const std::string& component : components)
            labels.push_back(std::to_string(point) + "_" + component);
    }
    return labels;
}

template std::vector<std::string> componentLabels<2>(particles::Rank);
template std::vector<std::string> componentLabels<3>(particles::Rank);

}  // namespace sphinx::io
