// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/fluid/solid_load.h"
#include "io/output_factory.h"
#include "io/series.h"
#include "io/series_quantity.h"

#include <deque>

namespace sphinx::io {

/// Force of all fluids on a solid at the present positions, velocities and pressures: the part by
/// pressure, the part by viscosity, and their sum. The pair terms are those of the methods that act
/// (fluid/solid_load.h), on neighbor lists of their own, because lists of the loop may be older
/// and must not change by being looked at.
template <int Dim>
class ForceSource final : public SeriesSource {
 public:
    ForceSource(const Body<Dim>& solid, const std::vector<const fluid::SolidLoad<Dim>*>& loads,
                Relations<Dim>& relations, const input::UnitSystem& units);

    const std::vector<SeriesQuantity>& quantities() const override { return quantities_; }
    void sample(const Clock& clock, std::span<double> row) override;

 private:
    struct FluidLoads {
        Relation<Dim> relation;  // of the fluid to the solid
        std::vector<const fluid::SolidLoad<Dim>*> loads;
    };

    const Body<Dim>* solid_;
    Relations<Dim>* relations_;
    std::deque<FluidLoads> fluids_;
    std::vector<SeriesQuantity> quantities_;
};

/// Throws CaseError at the place when no method of the loop acts between a fluid and the solid.
template <int Dim>
std::unique_ptr<SeriesSource> makeForceSource(const Body<Dim>& solid, const input::Place& place,
                                              const OutputContext<Dim>& context);

extern template class ForceSource<2>;
extern template class ForceSource<3>;

}  // namespace sphinx::io
