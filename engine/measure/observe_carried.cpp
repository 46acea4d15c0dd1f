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
CarriedWeights<Dim>::CarriedWeights(bodies::Body<Dim>& observer, const io::Follower<Dim>& follower,
                                    neighbors::Relations<Dim>& relations,
                                    const bodies::World<Dim>& world)
    : ObserveWeights<Dim>(observer, relations),
      observer_(&observer),
      follower_(follower),
      world_(&world),
      start_(this->position_) {}

template <int Dim>
void CarriedWeights<Dim>::update() {
    const auto& [observer, solid, part] = follower_;
    const bodies::Pose<Dim> pose = bodies::poseOf(*solid, part, world_->domain);
    if (!(pose.misfit <= most_misfit * solid->spacing))
        throw PhysicsError(
            fmt::format("the points of {} cannot follow {}{}: it has not moved as a rigid body",
                        observer->name, solid->name, part ? "." + part->name : ""));
    auto& position = observer_->particles.position();
    bool moved = false;
    for (std::size_t i = 0; i < start_.size(); ++i) {
        const Vec<Dim> now = world_->domain.wrapped(pose(start_[i]));
        moved = moved || now != position[i];
        position[i] = this->position_[i] = now;
    }
    if (moved) ++observer_->version;
    ObserveWeights<Dim>::update();
}

template class CarriedWeights<2>;
template class CarriedWeights<3>;

}  // namespace sphinx::measure
