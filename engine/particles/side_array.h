// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/archive.h"
#include "core/errors.h"
#include "particles/id_order.h"
#include "particles/particle_set.h"

#include <cstring>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sphinx::particles {

/// One value for each particle of a set, kept by a method beside the fields: follows the particles
/// when they come, go or change places in memory. The set lives longer. (What is filled anew before
/// each use needs no such care, and what follows from the initial state can be made anew when
/// ParticleSet::arrangement() has changed.) What has to outlive the run itself goes through
/// transfer().
template <class T>
class SideArray {
 public:
    /// `initial`: value of the particle at that place, called for those that there are and later
    /// for every new one.
    template <int Dim>
    SideArray(ParticleSet<Dim>& particles, std::function<T(std::size_t)> initial)
        : initial_(std::move(initial)),
          order_([&particles] { return IdOrder(particles); }),
          subscription_(particles.remaps(), [this](const Remap& remap) { follow(remap); }) {
        grow(particles.held());
    }

    std::size_t size() const { return values_.size(); }
    T* data() { return values_.data(); }
    const T* data() const { return values_.data(); }
    T& operator[](std::size_t i) { return values_[i]; }
    const T& operator[](std::size_t i) const { return values_[i]; }

    /// For Method::transfer(): the values of the particles, by id. Those of a restart are there
    /// when methods are asked. T consists of doubles. FileError when the number is another.
    void transfer(Archive& archive, std::string_view name) {
        static_assert(sizeof(T) % sizeof(double) == 0, "of numbers in double precision");
        constexpr std::size_t width = sizeof(T) / sizeof(double);
        const IdOrder order = order_();
        std::vector<double> numbers;
        if (!archive.loading()) {
            numbers.resize(order.size() * width);
            for (std::size_t k = 0; k < order.size(); ++k)
                std::memcpy(&numbers[k * width], &values_[order[k]], sizeof(T));
        }
        archive.value(name, numbers);
        if (!archive.loading()) return;
        if (numbers.size() != order.size() * width)
            throw FileError("the restart has another number of values for " + std::string(name));
        for (std::size_t k = 0; k < order.size(); ++k)
            std::memcpy(static_cast<void*>(&values_[order[k]]), &numbers[k * width], sizeof(T));
    }

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
    std::function<IdOrder()> order_;
    RemapSubscription subscription_;
};

}  // namespace sphinx::particles
