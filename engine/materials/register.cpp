// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "materials/register.h"

#include "materials/generalised_newtonian.h"
#include "materials/oldroyd_b_fluid.h"
#include "materials/weakly_compressible_fluid.h"

#include <optional>

namespace sphinx::materials {
namespace {

struct RigidParameters {
    std::optional<double> density;
};

void declareRigid(input::Registry& registry) {
    using P = RigidParameters;
    auto& d = registry.declare<P>(input::Kind::material, "rigid");
    d.summary("Does not deform: walls and obstacles");
    d.trait("rigid");
    d.optional("density", &P::density, input::number(unit::density).above(0),
               "density, where a mass follows from it: of a body that a mechanism moves");
    d.builder(MaterialBuilder{[](const void* p) -> std::shared_ptr<const Material> {
        return std::make_shared<Rigid>(static_cast<const P*>(p)->density.value_or(0));
    }});
}

}  // namespace

void registerMaterials(input::Registry& registry) {
    declareRigid(registry);
    declareWeaklyCompressibleFluid(registry);
    declareGeneralisedNewtonian(registry);
    declareOldroydB(registry);
    registerElasticSolids(registry);
}

}  // namespace sphinx::materials
