// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "measure/observe_elevation.h"

#include "core/exact_total.h"
#include "core/parallel.h"
#include "io/series/columns.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sphinx::measure {
namespace {

/// A particle near a gauge.
struct Near {
    double height;     // above the gauge's point
    double distance2;  // from the gauge, squared
    double volume;
    std::uint32_t filler;
};

/// Where solids leave less of the space there is no gauge. In an edge of two walls it is a quarter.
constexpr double least_space = 0.2;

}  // namespace

template <int Dim>
ElevationSource<Dim>::ElevationSource(const std::vector<Vec<Dim>>& points,
                                      std::vector<Filler> fluids, std::vector<Filler> solids,
                                      const Vec<Dim>& up, const input::UnitSystem& units,
                                      const io::Follower<Dim>* follower,
                                      const bodies::World<Dim>& world)
    : fillers_(std::move(fluids)), fluids_(fillers_.size()), domain_(&world.domain), up_(up) {
    spacing_ = fillers_.front().body->spacing;
    for (const Filler& fluid : fillers_) spacing_ = std::min(spacing_, fluid.body->spacing);
    fillers_.insert(fillers_.end(), solids.begin(), solids.end());
    for (const Vec<Dim>& point : points) {
        const auto above = [&](const Vec<Dim>& gauge) {
            const Vec<Dim> d = domain_->difference(point, gauge);
            return (d - up * up.dot(d)).norm() < 1e-6 * spacing_;
        };
        if (std::none_of(gauges_.begin(), gauges_.end(), above)) gauges_.push_back(point);
    }
    if (follower) carried_.emplace(*follower, gauges_, world);
    const std::string length = units.text(unit::length);
    quantities_ = {
        {"elevation", length, "height of the free surface against gravity",
         io::pointLabels(gauges_.size(), {})},
        {"position", length, "a point of each gauge",
         io::pointLabels(gauges_.size(), io::componentLabels<Dim>(particles::Rank::vector))}};
}

template <int Dim>
void ElevationSource<Dim>::sample(const Clock&, std::span<double> row) {
    if (carried_) gauges_ = carried_->now();
    parallelFor(
        gauges_.size(), [&](std::size_t k) { row[k] = elevation(gauges_[k]); }, 1);
    for (std::size_t k = 0; k < gauges_.size(); ++k)
        for (int c = 0; c < Dim; ++c) row[gauges_.size() + k * Dim + c] = gauges_[k][c];
}

template <int Dim>
double ElevationSource<Dim>::elevation(const Vec<Dim>& point) const {
    std::vector<Near> particles;
    double reach = 0;
    double highest = -std::numeric_limits<double>::infinity();  // of the fluids
    double lowest = -highest;
    for (std::uint32_t f = 0; f < fillers_.size(); ++f) {
        const bodies::Body<Dim>& body = *fillers_[f].body;
        const double cutoff = body.kernel.cutoff();
        reach = std::max(reach, cutoff);
        for (std::size_t i = 0; i < body.size(); ++i) {
            const Vec<Dim> d = domain_->difference(body.particles.position()[i], point);
            const double height = up_.dot(d);
            const double distance2 = (d - height * up_).squaredNorm();
            if (!(distance2 < cutoff * cutoff)) continue;
            particles.push_back({height, distance2, (*fillers_[f].volume)[i], f});
            if (f >= fluids_) continue;
            highest = std::max(highest, height);
            lowest = std::min(lowest, height);
        }
    }
    if (!(lowest <= highest)) return nan_value;
    std::sort(particles.begin(), particles.end(),
              [](const Near& a, const Near& b) { return a.height > b.height; });

    const auto filled = [&](double height) {
        auto near = std::partition_point(particles.begin(), particles.end(), [&](const Near& one) {
            return one.height > height + reach;
        });
        ExactTotal fluids, solids;
        for (; near != particles.end() && near->height > height - reach; ++near) {
            const double along = near->height - height;
            const double part = near->volume * fillers_[near->filler].body->kernel.value(
                                                   std::sqrt(near->distance2 + along * along));
            (near->filler < fluids_ ? fluids : solids).add(part);
        }
        const double fluid = fluids.value();
        const double space = 1 - solids.value();
        return space >= least_space && fluid >= 0.5 * space;
    };
    const double step = 0.25 * spacing_;
    const double bottom = lowest - reach;
    double above = highest + reach;
    double below = above - step;
    while (!filled(below)) {
        above = below;
        below -= step;
        if (above < bottom) return nan_value;
    }
    for (int k = 0; k < 40; ++k) {
        const double middle = 0.5 * (above + below);
        (filled(middle) ? below : above) = middle;
    }
    return up_.dot(point) + 0.5 * (above + below);
}

template <int Dim>
std::unique_ptr<io::SeriesSource> makeElevationSource(const bodies::Body<Dim>& observer,
                                                      const io::Follower<Dim>* follower,
                                                      const input::Place& place,
                                                      const io::OutputContext<Dim>& context) {
    using Filler = typename ElevationSource<Dim>::Filler;
    const auto filler = [&](const bodies::Body<Dim>& body) {
        return Filler{&body, dynamic_cast<const particles::Field<double>*>(
                                 &io::fieldOf(body, {std::string(fields::volume.name), place}))};
    };
    std::vector<Filler> fluids, solids;
    Vec<Dim> gravity = Vec<Dim>::Zero();
    for (const bodies::Body<Dim>* body : observer.sees) {
        if (!body->isFluid()) continue;
        fluids.push_back(filler(*body));
        if (gravity.isZero(0)) gravity = body->gravity();
        for (const bodies::Body<Dim>* seen : body->sees) {
            const auto same = [&](const Filler& known) { return known.body == seen; };
            if (seen->isSolid() && std::ranges::none_of(solids, same))
                solids.push_back(filler(*seen));
        }
    }
    if (fluids.empty()) io::failAt(place, "the observer '" + observer.name + "' sees no fluid");
    const Vec<Dim> up =
        gravity.isZero(0) ? Vec<Dim>(Vec<Dim>::Unit(Dim - 1)) : Vec<Dim>(-gravity.normalized());
    const Vec<Dim>* position = observer.particles.position().data();
    return std::make_unique<ElevationSource<Dim>>(
        std::vector<Vec<Dim>>(position, position + observer.size()), std::move(fluids),
        std::move(solids), up, context.units, follower, context.world);
}

template class ElevationSource<2>;
template class ElevationSource<3>;
template std::unique_ptr<io::SeriesSource> makeElevationSource<2>(const bodies::Body<2>&,
                                                                  const io::Follower<2>*,
                                                                  const input::Place&,
                                                                  const io::OutputContext<2>&);
template std::unique_ptr<io::SeriesSource> makeElevationSource<3>(const bodies::Body<3>&,
                                                                  const io::Follower<3>*,
                                                                  const input::Place&,
                                                                  const io::OutputContext<3>&);

}  // namespace sphinx::measure
