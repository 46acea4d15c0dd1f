// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/declare.h"
#include "dynamics/fluid/solid_load.h"

namespace sphinx::dynamics::fsi {

struct FluidForceParameters {
    input::Name body;
    input::Name from;
};

/// Force of a fluid on the particles of a solid: exactly minus what the fluid has felt from them,
/// by the pair terms of the fluid's own method (fluid::SolidLoad). Added to `force`.
template <int Dim>
class FluidForce : public Method {
 public:
    FluidForce(Context<Dim>& context, Body<Dim>& solid, Body<Dim>& fluid, fluid::LoadKind kind,
               Field<Vec<Dim>>& force);
    void run(const Clock& clock);
    std::size_t workSize() const override { return solid_->size(); }

 private:
    Context<Dim>* context_;
    Body<Dim>* solid_;
    Body<Dim>* fluid_;
    fluid::LoadKind kind_;
    const Relation<Dim>* relation_;  // of the solid to the fluid
    Field<Vec<Dim>>& force_;
};

/// A rule: a fluid pushes the bodies that it sees.
void checkSight(const input::Component& method, WrittenCase& written);

}  // namespace sphinx::dynamics::fsi
