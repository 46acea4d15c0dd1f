// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "materials/elastic_laws.h"
#include "materials/register.h"

namespace sphinx::materials {
namespace {

using input::coordinates;
using input::Declared;
using input::fieldVector;
using input::Kind;
using input::number;
using input::Registry;

template <class Law>
Declared<typename Law::Parameters>& declareSolid(Registry& registry, const char* name,
                                                 std::optional<PlaceRule> place_rule = {}) {
    using P = typename Law::Parameters;
    auto& d = registry.declare<P>(Kind::material, name);
    d.trait("elastic");
    d.required("density", &P::density, number(unit::density).above(0),
               "density in the reference configuration, rho0");
    d.optional("damping", &P::damping, number(unit::dynamic_viscosity).atLeast(0),
               "Kelvin-Voigt viscosity eta: stress of eta times the rate of strain, guide (16)");
    d.builder(MaterialBuilder{[](const void* p) -> std::shared_ptr<const Material> {
                                  return std::make_shared<Law>(*static_cast<const P*>(p));
                              },
                              place_rule});
    return d;
}

template <class Law>
Declared<typename Law::Parameters>& declareIsotropic(Registry& registry, const char* name) {
    using P = typename Law::Parameters;
    auto& d = declareSolid<Law>(registry, name);
    const auto modulus = [] { return number(unit::pressure).above(0); };
    d.optional("youngs_modulus", &P::youngs_modulus, modulus(),
               "Young's modulus E, with poisson_ratio");
    d.optional("poisson_ratio", &P::poisson_ratio, number(unit::none).above(-1).below(0.5),
               "Poisson ratio nu, with youngs_modulus");
    d.optional("bulk_modulus", &P::bulk_modulus, modulus(), "bulk modulus K, with shear_modulus");
    d.optional("shear_modulus", &P::shear_modulus, modulus(), "shear modulus G, with bulk_modulus");
    d.optional("lame_lambda", &P::lame_lambda, number(unit::pressure),
               "Lame's first constant lambda, with lame_mu");
    d.optional("lame_mu", &P::lame_mu, modulus(),
               "Lame's second constant mu, the shear modulus, with lame_lambda");
    d.check("", [](const P& p) { return p.violation(); });
    return d;
}

void declareSaintVenantKirchhoff(Registry& registry) {
    declareIsotropic<SaintVenantKirchhoff>(registry, "saint_venant_kirchhoff")
        .summary("Linear elastic solid for large rotations; softens under large compression")
        .formula("S = lambda tr(E) I + 2 mu E")
        .cite("guide", "(8)");
}

void declareNeoHookean(Registry& registry) {
    declareIsotropic<NeoHookean>(registry, "neo_hookean")
        .summary("Rubber-like solid for large strains")
        .formula("W = mu/2 (I_1 - 3 - 2 ln J) + lambda/2 (ln J)^2")
        .cite("guide", "(9)");
}

void declareFiniteExtensibility(Registry& registry) {
    using P = FiniteExtensibilityParameters;
    auto& d = declareIsotropic<FiniteExtensibility>(registry, "finite_extensibility");
    d.summary("Rubber-like solid that stiffens towards a largest stretch");
    d.formula(
        "W = -mu/2 J_m ln(1 - (I_1 - 3)/J_m) - mu ln J + lambda/2 (ln J)^2; "
        "at rest the bulk modulus is K + 2 mu/J_m");
    d.cite("guide", "(10), (11)");
    d.required("extensibility", &P::extensibility, number(unit::none).above(0),
               "J_m, the value that I_1 - 3 never reaches");
}

void declareLinearElastic(Registry& registry) {
    using P = LinearElasticParameters;
    auto& d = declareSolid<LinearElastic>(registry, "linear_elastic");
    d.summary("Anisotropic solid with a constant elasticity tensor, for large rotations");
    d.formula("S = c : E; orthotropic: E_i nu_ji = E_j nu_ij");
    d.cite("guide", "(6)");
    const auto modulus = [] { return number(unit::pressure).above(0); };
    d.optional("youngs_modulus_1", &P::youngs_modulus_1, modulus(), "Young's modulus along axis 1");
    d.optional("youngs_modulus_2", &P::youngs_modulus_2, modulus(), "Young's modulus along axis 2");
    d.optional("youngs_modulus_3", &P::youngs_modulus_3, modulus(), "Young's modulus along axis 3");
    d.optional("poisson_ratio_12", &P::poisson_ratio_12, number(unit::none),
               "contraction along 2 over extension along 1, under a stress along 1");
    d.optional("poisson_ratio_13", &P::poisson_ratio_13, number(unit::none),
               "contraction along 3 over extension along 1, under a stress along 1");
    d.optional("poisson_ratio_23", &P::poisson_ratio_23, number(unit::none),
               "contraction along 3 over extension along 2, under a stress along 2");
    d.optional("shear_modulus_12", &P::shear_modulus_12, modulus(), "shear modulus of 1 and 2");
    d.optional("shear_modulus_13", &P::shear_modulus_13, modulus(), "shear modulus of 1 and 3");
    d.optional("shear_modulus_23", &P::shear_modulus_23, modulus(), "shear modulus of 2 and 3");
    d.optional("stiffness", &P::stiffness, input::list(input::list(number(unit::pressure))),
               "instead of the moduli: the symmetric 6 x 6 matrix from strains E_11, E_22, E_33, "
               "2 E_23, 2 E_13, 2 E_12 to the stresses, in the same axes");
    d.optional("axis_1", &P::axis_1, coordinates(unit::none),
               "direction of axis 1 in the reference configuration; default: x");
    d.optional("axis_2", &P::axis_2, coordinates(unit::none),
               "direction of axis 2, perpendicular to it; default: y, in 2D axis 1 turned left");
    d.check("stiffness", [](const P& p) { return p.constantsViolation(); });
    d.check("axis_2", [](const P& p) { return p.axesViolation(); });
}

/// Directions that are none somewhere, or not perpendicular.
template <int Dim>
PlaceRule::Violation violationAt(const void* parameters, const Vec<Dim>& place) {
    Fibres<Dim> fibres;
    return static_cast<const HolzapfelMuscleParameters*>(parameters)->directions(place, fibres);
}

void declareHolzapfelMuscle(Registry& registry) {
    using P = HolzapfelMuscleParameters;
    auto& d = declareSolid<HolzapfelMuscle>(registry, "holzapfel_muscle",
                                            PlaceRule{violationAt<2>, violationAt<3>});
    d.trait("fibres");
    d.summary("Muscle: a soft solid with stiffening fibres in sheets");
    d.formula(
        "W = a/2b (exp(b (I_1 - 3 - 2 ln J)) - 1) + lambda/2 (ln J)^2 + sum over f and s of "
        "a_i/2b_i (exp(b_i (I_ii - 1)^2) - 1) + a_fs/2b_fs (exp(b_fs I_fs^2) - 1)");
    d.cite("guide", "(14), (15)").cite("Holzapfel & Ogden 2009");
    const auto modulus = [] { return number(unit::pressure).atLeast(0); };
    const auto exponent = [] { return number(unit::none).atLeast(0); };
    d.required("lame_lambda", &P::lame_lambda, modulus(),
               "lambda, the resistance to a change of volume; bulk modulus lambda + 2/3 a");
    d.required("a", &P::a, number(unit::pressure).above(0),
               "shear modulus of the isotropic part at rest");
    d.required("b", &P::b, exponent(), "exponent of its stiffening; 0: neo-Hookean");
    d.required("a_f", &P::a_f, modulus(), "stiffness along the fibre");
    d.required("b_f", &P::b_f, exponent(), "exponent of its stiffening");
    d.required("a_s", &P::a_s, modulus(), "stiffness along the sheet");
    d.required("b_s", &P::b_s, exponent(), "exponent of its stiffening");
    d.required("a_fs", &P::a_fs, modulus(), "stiffness against shear between fibre and sheet");
    d.required("b_fs", &P::b_fs, exponent(), "exponent of its stiffening");
    d.required("fibre", &P::fibre, fieldVector(unit::none),
               "direction of the fibres at the reference position, of any length");
    d.optional(
        "sheet", &P::sheet, fieldVector(unit::none),
        "direction in the sheet, perpendicular to the fibre; default in 2D: the fibre turned "
        "left");
    for (const char* parameter : {"fibre", "sheet"})
        d.check(parameter, [parameter](const P& p) {
            const auto violation = p.violation();
            return violation && violation->parameter == parameter ? violation->message : "";
        });
}

}  // namespace

void registerElasticSolids(Registry& registry) {
    declareSaintVenantKirchhoff(registry);
    declareLinearElastic(registry);
    declareNeoHookean(registry);
    declareFiniteExtensibility(registry);
    declareHolzapfelMuscle(registry);
}

}  // namespace sphinx::materials
