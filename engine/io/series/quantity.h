// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace sphinx::io {

/// One quantity of a time series.
struct SeriesQuantity {
    std::string name;  ///< lower_snake_case; "time" is taken
    std::string unit;  ///< empty: none
    std::string description;
    /// Empty: one value. Else one value for each label, like "x", "y" or the numbers of points.
    std::vector<std::string> labels;

    std::size_t size() const { return labels.empty() ? 1 : labels.size(); }
};

}  // namespace sphinx::io
