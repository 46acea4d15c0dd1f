// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/archive.h"
#include "dynamics/context.h"
#include "dynamics/dynamics.h"
#include "dynamics/load.h"

#include <limits>
#include <vector>

namespace sphinx::dynamics::fluid {

/// `polymer`: counted as viscous by whoever asks for the force on a solid.
enum class LoadKind { pressure, viscous, polymer };

/// A method by which a fluid and the solids that it sees push each other: says how large the force
/// is, without acting. What the solid gets is what the method takes from the fluid, by the same
/// pair terms.
template <int Dim>
class SolidLoad : public Method {
 public:
    LoadKind loadKind() const { return kind_; }
    Body<Dim>& fluid() const { return *body_; }
    std::size_t workSize() const override { return body_->size(); }
    void rest() override { has_ended_ = true; }
    void transfer(Archive& archive) override {
        archive.value("last_time", last_time_);
        archive.value("has_ended", has_ended_);
    }

    /// Time of the step in which it acted last; without one: minus infinity.
    double lastTime() const { return last_time_; }
    /// The window in which it acted is over.
    bool hasEnded() const { return has_ended_; }
    /// Force on the solid at the present state and its moment about a point; zero when the method
    /// does not act on it. `list`: the fluid's neighbors in the solid, with distances.
    virtual Load<Dim> loadOn(const Body<Dim>& solid, const NeighborList<Dim>& list,
                             const Vec<Dim>& about) const = 0;
    /// Adds to `force` what each particle of the solid gets, exactly minus what the fluid has felt
    /// in its last sum. `list`: the solid's neighbors in the fluid that belong to the fluid's in
    /// the solid, with distances.
    virtual void addForces(const Body<Dim>& solid, const NeighborList<Dim>& list,
                           Field<Vec<Dim>>& force) const = 0;
    /// Adds to `impedance`, of each particle of the solid, by what the fluid answers its motion at
    /// once (fields::radiation_impedance). A load by viscosity has none.
    virtual void addImpedance(const Body<Dim>& /*solid*/, const NeighborList<Dim>& /*list*/,
                              Field<Mat<Dim>>& /*impedance*/) const {}

 protected:
    SolidLoad(Context<Dim>& context, Body<Dim>& fluid, LoadKind kind) : body_(&fluid), kind_(kind) {
        context.loads.push_back(this);
    }
    void actedAt(double time) {
        last_time_ = time;
        has_ended_ = false;
    }

    Body<Dim>* body_;  // the fluid

 private:
    LoadKind kind_;
    double last_time_ = -std::numeric_limits<double>::infinity();
    bool has_ended_ = false;
};

/// The load by which that fluid pushes at present: of several, which share the time of the run, the
/// one that acted last, and before any has, the first. nullptr when there is none, or all have
/// ended.
template <int Dim>
const SolidLoad<Dim>* presentLoad(const std::vector<const SolidLoad<Dim>*>& loads,
                                  const Body<Dim>& fluid, LoadKind kind) {
    const SolidLoad<Dim>* present = nullptr;
    for (const SolidLoad<Dim>* load : loads)
        if (load->loadKind() == kind && &load->fluid() == &fluid && !load->hasEnded() &&
            (!present || load->lastTime() > present->lastTime()))
            present = load;
    return present;
}

}  // namespace sphinx::dynamics::fluid
