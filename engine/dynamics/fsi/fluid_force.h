// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/declare.h"
#include "dynamics/fluid/solid_load.h"

#include <algorithm>

namespace sphinx::dynamics::fsi {

struct FluidForceParameters {
    input::Name body;
    input::Name from;
};

/// Force of a fluid on the particles of a solid: exactly minus what the fluid has felt from them,
/// by the pair terms of the fluid's own method (fluid::SolidLoad). Added to the field that holds
/// forces of this kind.
template <int Dim, fluid::LoadKind kind>
class FluidForce final : public Method {
 public:
    FluidForce(Context<Dim>& context, const FluidForceParameters& p)
        : context_(&context),
          solid_(&bodyOf(context, p.body)),
          fluid_(&bodyOf(context, p.from)),
          relation_(&context.relations.flow(*solid_, *fluid_, {.distance = true})),
          force_(solid_->particles.vector(
              kind == fluid::LoadKind::pressure ? fields::pressure_force : fields::viscous_force)) {
        if (kind == fluid::LoadKind::pressure)
            impedance_ = &solid_->particles.matrix(fields::radiation_impedance);
    }
    /// Light bodies answer viscous forces faster than the fluid itself.
    void announce() override {
        if (kind != fluid::LoadKind::viscous) return;
        double& lightest = fluid_->fluid().viscous.lightest_solid;
        const double density = solid_->material()->density();
        if (density > 0) lightest = std::min(lightest, density);  // rigid ones may state none
    }
    void run(const Clock&) {
        if (kind == fluid::LoadKind::viscous)
            if (const auto* load =
                    fluid::presentLoad(context_->loads, *fluid_, fluid::LoadKind::polymer))
                load->addForces(*solid_, relation_->list, force_);
        const auto* load = fluid::presentLoad(context_->loads, *fluid_, kind);
        if (!load) return;
        load->addForces(*solid_, relation_->list, force_);
        if (impedance_) load->addImpedance(*solid_, relation_->list, *impedance_);
    }
    std::size_t workSize() const override { return solid_->size(); }

 private:
    Context<Dim>* context_;
    Body<Dim>* solid_;
    Body<Dim>* fluid_;
    const Relation<Dim>* relation_;  // of the solid to the fluid
    Field<Vec<Dim>>& force_;
    Field<Mat<Dim>>* impedance_ = nullptr;  // by pressure only
};

/// A rule: a fluid pushes the bodies that it sees.
void checkSight(const input::Component& method, WrittenCase& written);

/// A rule: a body that feels one of the fluids that see it feels the others.
void checkOtherFluids(const input::Component& method, WrittenCase& written);

/// A rule: rigid bodies get forces where a mechanism moves them.
void checkResponds(const input::Component& method, WrittenCase& written);

/// Registers the method that hands on loads of a kind, but for what is to be said of it alone.
/// `from`: what the fluid does.
template <fluid::LoadKind kind>
auto& declareFluidForce(input::Registry& registry, std::string name, const std::string& from) {
    using P = FluidForceParameters;
    const auto make = []<int Dim>(const P& p, Context<Dim>& context) {
        return std::make_unique<FluidForce<Dim, kind>>(context, p);
    };
    auto& d = declareMethod<P>(registry, std::move(name), make);
    d.required("body", &P::body, input::bodyReference({"elastic", "rigid"}),
               "elastic body, or rigid body that a mechanism moves");
    d.required("from", &P::from, input::bodyReference({"fluid"}), "fluid that " + from + " it");
    d.rule(checkSight);
    d.rule(checkResponds);
    return d;
}

}  // namespace sphinx::dynamics::fsi
