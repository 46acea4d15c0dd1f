// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/world.h"
#include "io/output/factory.h"
#include "measure/observe_weights.h"

namespace sphinx::measure {

/// Points that a solid carries along.
template <int Dim>
class CarriedPoints {
 public:
    /// `start`: where they are while the particles of the solid are where they began.
    CarriedPoints(const io::Follower<Dim>& follower, std::vector<Vec<Dim>> start,
                  const bodies::World<Dim>& world)
        : follower_(follower), start_(std::move(start)), world_(&world) {}

    /// Where they are now. Throws PhysicsError where the solid has not moved as a rigid body.
    std::vector<Vec<Dim>> now() const;

 private:
    io::Follower<Dim> follower_;
    std::vector<Vec<Dim>> start_;
    const bodies::World<Dim>* world_;
};

/// The weights of points that a solid carries along: they move with it, and look at what the
/// observer sees where they are.
template <int Dim>
class CarriedWeights final : public ObserveWeights<Dim> {
 public:
    /// The points are those of the observer as they are now, in which the solid is where its
    /// particles began.
    CarriedWeights(bodies::Body<Dim>& observer, const io::Follower<Dim>& follower,
                   neighbors::Relations<Dim>& relations, const bodies::World<Dim>& world);

    /// Throws PhysicsError where the solid has not moved as a rigid body.
    void update() override;

 private:
    bodies::Body<Dim>* observer_;
    CarriedPoints<Dim> points_;
};

extern template class CarriedPoints<2>;
extern template class CarriedPoints<3>;
extern template class CarriedWeights<2>;
extern template class CarriedWeights<3>;

}  // namespace sphinx::measure
