// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/output/factory.h"
#include "io/series/series.h"
#include "measure/observe_carried.h"

#include <optional>

namespace sphinx::measure {

/// Height of the surface of the fluids that an observer sees, above the origin and against gravity
/// (the uniform gravity of the fluids; without any, along the last axis).
///
/// A gauge is a line along gravity through a point of the observer. On it the part of space that
/// fluid fills, F = sum_j V_j W_j, is 1 below a free surface and 0 above, and by symmetry 1/2 where
/// a flat surface stands. Solids that the fluids see, S = sum_k V_k W_k, leave 1 - S of the space:
/// at a wall half of it, where F is counted as a part of that. From above the highest particle the
/// gauge is searched downwards in steps of a quarter of a spacing for the first place with
/// F >= (1 - S)/2, which is then bisected. So a single drop (F < 1/2) does not count, but a jet or
/// sheet above the surface does. NaN: no fluid there, or the gauge is inside of a solid.
///
/// A gauge may follow a rigid body: it stays along gravity, through its point where that is now.
///
/// A gauge costs one pass over the particles of the fluids and of the solids that they see.
template <int Dim>
class ElevationSource final : public io::SeriesSource {
 public:
    struct Filler {
        const bodies::Body<Dim>* body;
        const particles::Field<double>* volume;
    };
    /// `up`: unit vector. Points that lie above each other at the start make one gauge, which
    /// follows what `follower` says, if anything.
    ElevationSource(const std::vector<Vec<Dim>>& points, std::vector<Filler> fluids,
                    std::vector<Filler> solids, const Vec<Dim>& up, const input::UnitSystem& units,
                    const io::Follower<Dim>* follower, const bodies::World<Dim>& world);

    const std::vector<io::SeriesQuantity>& quantities() const override { return quantities_; }
    void sample(const Clock& clock, std::span<double> row) override;

    double elevation(const Vec<Dim>& point) const;

 private:
    std::vector<Filler> fillers_;  // fluids, then solids
    std::size_t fluids_;           // number of them
    const bodies::Domain<Dim>* domain_;
    Vec<Dim> up_;
    double spacing_;
    std::vector<Vec<Dim>> gauges_;
    std::optional<CarriedPoints<Dim>> carried_;
    std::vector<io::SeriesQuantity> quantities_;
};

/// Throws CaseError at the place when the observer sees no fluid. `follower`: null for gauges that
/// are fixed in space.
template <int Dim>
std::unique_ptr<io::SeriesSource> makeElevationSource(const bodies::Body<Dim>& observer,
                                                      const io::Follower<Dim>* follower,
                                                      const input::Place& place,
                                                      const io::OutputContext<Dim>& context);

extern template class ElevationSource<2>;
extern template class ElevationSource<3>;

}  // namespace sphinx::measure
