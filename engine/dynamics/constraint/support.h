// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/body.h"
#include "core/archive.h"

#include <string>

namespace sphinx::constraint {

/// A constraint that knows the force it exerts.
template <int Dim>
class Support {
 public:
    virtual ~Support() = default;
    virtual const Body<Dim>& supported() const = 0;
    /// Sum of the forces on the held particles in the last step in which it held them, force; zero
    /// once the window of its line is over.
    virtual Vec<Dim> reaction() const { return reaction_; }

 protected:
    void letGo() { reaction_.setZero(); }
    void transferReaction(Archive& archive) {
        for (int c = 0; c < Dim; ++c)
            archive.value("reaction_" + std::string(1, "xyz"[c]), reaction_[c]);
    }
    Vec<Dim> reaction_ = Vec<Dim>::Zero();
};

}  // namespace sphinx::constraint
