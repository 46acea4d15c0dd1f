// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/archive.h"
#include "dynamics/load.h"
#include "dynamics/part.h"

#include <algorithm>
#include <vector>

namespace sphinx::dynamics {

/// A method that knows what it exerts on a solid. Steps are many and few ask: it writes down the
/// force on each particle, and the sum is made when somebody asks.
template <int Dim>
class KnownLoad {
 public:
    explicit KnownLoad(const Part<Dim>& part) : loaded_(part) {}
    virtual ~KnownLoad() = default;

    const Body<Dim>& loaded() const { return loaded_.body(); }
    /// Sum of the forces in the last step in which it acted, and of their moments about the origin
    /// at the present places of the particles; zero once the window of its line is over.
    Load<Dim> load() const {
        if (forces_.empty()) return sum_;
        const auto& position = loaded().particles.position();
        return sumAll(forces_.size(), [&](std::size_t n) {
            Load<Dim> load;
            load.add(position[loaded_[n]], forces_[n]);
            return load;
        });
    }
    /// What it acts on.
    const Part<Dim>& part() const { return loaded_; }
    /// For who acts, to be filled: the force on the n-th particle of the part.
    AlignedVector<Vec<Dim>>& forces() {
        forces_.resize(loaded_.size());
        return forces_;
    }
    /// In place of the forces.
    void setLoad(const Load<Dim>& sum) {
        forces_.clear();
        sum_ = sum;
    }
    /// For Method::transfer().
    void transferLoad(Archive& archive) {
        setLoad(load());
        std::vector<double> force(sum_.force.begin(), sum_.force.end());
        std::vector<double> moment(sum_.moment.begin(), sum_.moment.end());
        archive.value("force", force);
        archive.value("moment", moment);
        std::copy(force.begin(), force.end(), sum_.force.begin());
        std::copy(moment.begin(), moment.end(), sum_.moment.begin());
    }

 private:
    Part<Dim> loaded_;
    AlignedVector<Vec<Dim>> forces_;  // empty: the sum is known
    Load<Dim> sum_;
};

/// A constraint: its load is the reaction of the support.
template <int Dim>
class Support : public KnownLoad<Dim> {
 public:
    using KnownLoad<Dim>::KnownLoad;
};

/// A force from outside.
template <int Dim>
class AppliedLoad : public KnownLoad<Dim> {
 public:
    using KnownLoad<Dim>::KnownLoad;
};

}  // namespace sphinx::dynamics
