// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/group.h"
#include "dynamics/words.h"
#include "materials/elastic_solid.h"

namespace sphinx::dynamics::solid {

/// Directions of the muscle at each particle of a body, for laws that use them.
template <int Dim>
class ParticleFibres {
 public:
    ParticleFibres(Body<Dim>& body, bool used) {
        if (!used) return;
        fibre_ = &body.particles.vector(fields::fibre);
        sheet_ = &body.particles.vector(fields::sheet);
    }
    materials::Fibres<Dim> operator[](std::size_t i) const {
        if (!fibre_) return {};
        return {(*fibre_)[i], (*sheet_)[i]};
    }
    materials::Fibres<Dim, Wide> operator[](const Group& group) const {
        if (!fibre_) return {};
        return {load(*fibre_, group), load(*sheet_, group)};
    }

 private:
    const Field<Vec<Dim>>* fibre_ = nullptr;
    const Field<Vec<Dim>>* sheet_ = nullptr;
};

}  // namespace sphinx::dynamics::solid
