// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/fluid/solid_load.h"
#include "io/output/factory.h"
#include "io/series/quantity.h"
#include "io/series/series.h"
#include "measure/reduced_body.h"

#include <deque>
#include <optional>

namespace sphinx::measure {

/// Force of all fluids on a solid at the present velocities and pressures: the part by pressure,
/// the part by viscosity, and their sum; or of the moments about a point. The pair terms and lists
/// are those of the methods that act (fluid/solid_load.h): within an advection step, in which lists
/// stay as they are, the force is the one that the fluid feels. After particles were sorted or lost
/// it takes a list of its own.
template <int Dim>
class ForceSource final : public io::SeriesSource {
 public:
    ForceSource(const ReducedBody<Dim>& reduced,
                const std::vector<const dynamics::fluid::SolidLoad<Dim>*>& loads,
                const std::optional<Vec<Dim>>& moment_about);

    const std::vector<io::SeriesQuantity>& quantities() const override { return quantities_; }
    void sample(const Clock& clock, std::span<double> row) override;

 private:
    struct FluidLoads {
        const neighbors::Relation<Dim>* acting;  // of the fluid to the solid
        neighbors::Relation<Dim> own;            // the same, where the acting one cannot be read
        std::vector<const dynamics::fluid::SolidLoad<Dim>*> loads;
    };

    const neighbors::NeighborList<Dim>& listOf(FluidLoads& fluid) const;

    const bodies::Body<Dim>* solid_;
    const bodies::BodyPart<Dim>* part_;
    neighbors::Relations<Dim>* relations_;
    std::optional<Vec<Dim>> moment_about_;
    std::deque<FluidLoads> fluids_;
    std::vector<io::SeriesQuantity> quantities_;
};

/// Throws CaseError at the place when no method of the loop acts between a fluid and the solid.
template <int Dim>
std::unique_ptr<io::SeriesSource> makeForceSource(const ReducedBody<Dim>& reduced,
                                                  const io::OutputContext<Dim>& context,
                                                  const std::optional<Vec<Dim>>& moment_about = {});

extern template class ForceSource<2>;
extern template class ForceSource<3>;

}  // namespace sphinx::measure
