// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "particles/particle_set.h"

#include <functional>
#include <utility>

namespace sphinx {

/// One value for each particle of a set, kept by a method beside the fields: follows the particles
/// when they come, go or change places in memory. The set lives longer. (What is filled anew before
/// each use needs no such care, and what follows from the initial state can be made anew when
/// ParticleSet::arrangement() has changed.)
template <class T>
class SideArray {
 public:
    /// `initial`: value of the particle at that place, called for those that there are and later
    /// for every new one.
    template <int Dim>
    SideArray(ParticleSet<Dim>& particles, std::function<T(std::size_t)> initial)
        : initial_(std::move(initial)),
          subscription_(particles.remaps(), [this](const Remap& remap) { follow(remap); }) {
        grow(particles.held());
    }

    std::size_t size() const { return values_.size(); }
    T* data() { return values_.data(); }
    const T* data() const { return values_.data(); }
    T& operator[](std::size_t i) { return values_[i]; }
    const T& operator[](std::size_t i) const { return values_[i]; }

 private:
    void follow(const Remap& remap) {
        if (!remap.inPlace()) {
            AlignedVector<T> moved(remap.carried());
            for (std::size_t k = 0; k < moved.size(); ++k) moved[k] = values_[remap.from(k)];
            values_ = std::move(moved);
        }
        values_.resize(remap.carried());
        grow(remap.after());
    }
    void grow(std::size_t n) {
        values_.reserve(n);
        while (values_.size() < n) values_.push_back(initial_(values_.size()));
    }

    std::function<T(std::size_t)> initial_;
    AlignedVector<T> values_;
    RemapSubscription subscription_;
};

}  // namespace sphinx
