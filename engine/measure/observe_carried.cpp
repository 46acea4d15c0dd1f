// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "measure/observe_carried.h"

#include "bodies/pose.h"
#include "core/errors.h"

#include <fmt/format.h>

namespace sphinx::measure {
namespace {

/// Of the spacing: what particles of a rigid body may be elsewhere.
constexpr double most_misfit = 1e-4;

}  // namespace

template <int Dim>
std::vector<Vec<Dim>> CarriedPoints<Dim>::now() const {
    const auto& [observer, solid, part] = follower_;
    const bodies::Pose<Dim> pose = bodies::poseOf(*solid, part, world_->domain);
    if (!(pose.misfit <= most_misfit * solid->spacing))
        throw PhysicsError(
            fmt::format("the points of {} cannot follow {}{}: it has not moved as a rigid body",
                        observer->name, solid->name, part ? "." + part->name : ""));
    std::vector<Vec<Dim>> points;
    for (const Vec<Dim>& start : start_) points.push_back(world_->domain.wrapped(pose(start)));
    return points;
}

template <int Dim>
CarriedWeights<Dim>::CarriedWeights(bodies::Body<Dim>& observer, const io::Follower<Dim>& follower,
                                    neighbors::Relations<Dim>& relations,
                                    const bodies::World<Dim>& world)
    : ObserveWeights<Dim>(observer, relations),
      observer_(&observer),
      points_(follower, this->position_, world) {}

template <int Dim>
void CarriedWeights<Dim>::update() {
    const std::vector<Vec<Dim>> now = points_.now();
    auto& position = observer_->particles.position();
    bool moved = false;
    for (std::size_t i = 0; i < now.size(); ++i) {
        moved = moved || now[i] != position[i];
        position[i] = this->position_[i] = now[i];
    }
    if (moved) ++observer_->version;
    ObserveWeights<Dim>::update();
}

template class CarriedPoints<2>;
template class CarriedPoints<3>;
template class CarriedWeights<2>;
template class CarriedWeights<3>;

}  // namespace sphinx::measure
