// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/output/factory.h"
#include "io/series/series.h"
#include "measure/reduced_body.h"

#include <optional>

namespace sphinx::measure {

/// kinetic = sum m v^2/2; potential = -sum m g . x, g being the body's uniform gravities; internal
/// = sum m e(rho) of a weakly compressible fluid, dynamics::solid::internalEnergy() of an elastic
/// body; total, their sum.
template <int Dim>
std::unique_ptr<io::SeriesSource> mechanicalEnergy(const ReducedBody<Dim>& reduced);
template <int Dim>
std::unique_ptr<io::SeriesSource> kineticEnergy(const ReducedBody<Dim>& reduced);
/// mass; particles, their number; removed, how many have left the body so far.
template <int Dim>
std::unique_ptr<io::SeriesSource> mass(const ReducedBody<Dim>& reduced);
template <int Dim>
std::unique_ptr<io::SeriesSource> momentum(const ReducedBody<Dim>& reduced);
/// sum m x cross v about the origin; in 2D its z component alone.
template <int Dim>
std::unique_ptr<io::SeriesSource> angularMomentum(const ReducedBody<Dim>& reduced);
/// Largest abs(v); NaN without particles.
/// Of other surfaces on a solid; with `about` also its moment about that point.
template <int Dim>
std::unique_ptr<io::SeriesSource> contactForce(const ReducedBody<Dim>& reduced,
                                               const std::optional<Vec<Dim>>& about);
template <int Dim>
std::unique_ptr<io::SeriesSource> maximumSpeed(const ReducedBody<Dim>& reduced);
/// Largest coordinate along that axis (0 is x); NaN without particles.
template <int Dim>
std::unique_ptr<io::SeriesSource> frontPosition(const ReducedBody<Dim>& reduced, int axis);

}  // namespace sphinx::measure
