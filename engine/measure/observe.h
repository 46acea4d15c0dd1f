// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/declaration/registry.h"
#include "io/output/factory.h"
#include "io/series/series.h"
#include "measure/observe_weights.h"

namespace sphinx::measure {

/// Fields of the seen bodies at the points of an observer: for each field its components at each
/// point, then the coverage and the position of each point. Where an observer sees no particle
/// values are NaN and the coverage 0. With `mean` one value takes the place of those of the points:
/// the mean over the points that see something; that of the coverage is over all points.
template <int Dim>
class ObserveSource final : public io::SeriesSource {
 public:
    /// `fields[f]`: the field f of each body of weights->bodies(); none of whole numbers.
    ObserveSource(std::unique_ptr<ObserveWeights<Dim>> weights,
                  std::vector<std::vector<const particles::FieldBase*>> fields, bool mean,
                  const input::UnitSystem& units);

    const std::vector<io::SeriesQuantity>& quantities() const override { return quantities_; }
    void sample(const Clock& clock, std::span<double> row) override;
    void transfer(Archive& archive) override { weights_->transfer(archive); }

 private:
    /// Values of the points of a quantity with that many components, one point after the other.
    void addRow(const std::vector<double>& values, std::size_t components, std::span<double>& row);

    std::unique_ptr<ObserveWeights<Dim>> weights_;
    std::vector<std::vector<const particles::FieldBase*>> fields_;
    bool mean_;
    std::vector<io::SeriesQuantity> quantities_;
    std::vector<double> values_;
};

/// Registers observe.
void declareObserve(input::Registry& registry);

extern template class ObserveSource<2>;
extern template class ObserveSource<3>;

}  // namespace sphinx::measure
