// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/words.h"

#include <cstdint>

namespace sphinx::dynamics {

/// Tells whether what names particles by their places in memory has to be made anew.
class ArrangementWatch {
 public:
    /// Since it was asked last; at first it has.
    template <int Dim>
    bool hasChanged(const ParticleSet<Dim>& particles) {
        const bool changed = seen_ != particles.arrangement();
        seen_ = particles.arrangement();
        return changed;
    }

 private:
    std::uint64_t seen_ = ~std::uint64_t{0};
};

}  // namespace sphinx::dynamics
