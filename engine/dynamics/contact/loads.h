// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/clock.h"
#include "dynamics/words.h"

#include <vector>

namespace sphinx::dynamics::contact {

/// What all contacts of a body do to it in a step: they share it, and the first of them in a step
/// takes back what the last step has left. Few particles are in contact, so the fields are never
/// zeroed as a whole.
template <int Dim>
class Loads {
 public:
    explicit Loads(Body<Dim>& body)
        : body_(&body),
          force(body.particles.vector(fields::contact_force)),
          pressure(body.particles.scalar(fields::contact_pressure)) {
        if (body.isWall() && body.responds())
            couple = &body.particles.matrix(fields::contact_couple);
    }

    const Body<Dim>& body() const { return *body_; }
    void begin(const Clock& clock) {
        if (known_ && step_ == clock.steps) return;
        // Fields that come out of a restart may have anything in them.
        if (!known_)
            for (std::size_t i = 0; i < body_->size(); ++i) zero(i);
        clear();
        known_ = true;
        step_ = clock.steps;
    }
    /// The window of a line is over.
    void clear() {
        for (const Index i : touched_) zero(i);
        touched_.clear();
    }
    /// Who adds to the fields says where.
    void touch(Index i) { touched_.push_back(i); }

 private:
    Body<Dim>* body_;

 public:
    Field<Vec<Dim>>& force;
    Field<double>& pressure;
    Field<Mat<Dim>>* couple = nullptr;  ///< of a rigid body that a mechanism carries

 private:
    void zero(std::size_t i) {
        force[i].setZero();
        pressure[i] = 0;
        if (couple) (*couple)[i].setZero();
    }

    std::vector<Index> touched_;
    bool known_ = false;
    std::int64_t step_ = 0;
};

}  // namespace sphinx::dynamics::contact
