// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/declaration/registry.h"
#include "io/output/factory.h"
#include "io/series/series.h"

#include <functional>

namespace sphinx::measure {

/// Numbers that a function of the present state gives.
class ReduceSource final : public io::SeriesSource {
 public:
    /// `evaluate` fills in the values of all quantities, one behind the other.
    ReduceSource(std::vector<io::SeriesQuantity> quantities,
                 std::function<void(std::span<double>)> evaluate)
        : quantities_(std::move(quantities)), evaluate_(std::move(evaluate)) {}

    const std::vector<io::SeriesQuantity>& quantities() const override { return quantities_; }
    void sample(const Clock&, std::span<double> row) override { evaluate_(row); }

 private:
    std::vector<io::SeriesQuantity> quantities_;
    std::function<void(std::span<double>)> evaluate_;
};

/// Registers reduce.
void declareReduce(input::Registry& registry);

}  // namespace sphinx::measure
