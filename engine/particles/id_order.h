// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "particles/particle_set.h"

#include <string_view>

namespace sphinx::particles {

/// The particles of a set by ascending id, as files have them: results then do not depend on where
/// particles stand in memory. Nothing is copied for a set that stands in this order already. Valid
/// until the particles change places.
class IdOrder {
 public:
    template <int Dim>
    explicit IdOrder(const ParticleSet<Dim>& particles);

    std::size_t size() const { return size_; }
    /// Place in memory of the k-th particle.
    std::size_t operator[](std::size_t k) const { return places_.empty() ? k : places_[k]; }
    /// The values of a field one after the other, 8 bytes each, in `buffer` where they do not stand
    /// so in memory.
    std::string_view bytes(const FieldBase& field, AlignedVector<char>& buffer) const;
    /// The same in memory of their own.
    AlignedVector<char> copy(const FieldBase& field) const;

 private:
    std::size_t size_;
    AlignedVector<Index> places_;  // empty: as they stand
};

}  // namespace sphinx::particles
