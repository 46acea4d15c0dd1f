// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fluid/viscous_force.h"

#include "dynamics/fluid/implicit_viscosity.h"
#include "dynamics/fluid/liquid_friction.h"
#include "dynamics/fluid/viscous_bound.h"
#include "dynamics/fluid/viscous_load.h"
#include "dynamics/methods.h"
#include "dynamics/pair_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sphinx::dynamics::fluid {
namespace {

template <int Dim>
class ViscousForce final : public ViscousLoad<Dim> {
 public:
    ViscousForce(Context<Dim>& context, const ViscousForceParameters& p)
        : ViscousLoad<Dim>(context, p),
          liquids_(*body_, around_, p.form),
          external_(body_->particles.vector(fields::external_acceleration)) {}

    void announce() override;
    void run(const Clock& clock);

 private:
    using Base = ViscousLoad<Dim>;
    using Base::around_, Base::body_, Base::cell_, Base::factor_, Base::form_, Base::largest_,
        Base::mass_, Base::nearest_, Base::per_viscosity_, Base::records_, Base::sums_,
        Base::varying_, Base::velocity_, Base::volume_;
    using typename Base::Varying;

    template <ViscousForm F, bool Varies, class Real>
    void accelerate();
    /// Of a generalised Newtonian fluid.
    void findViscosity();
    /// What the laplacian lacks where the viscosity varies.
    void addTransposedStress();

    LiquidFriction<Dim> liquids_;
    Field<Vec<Dim>>& external_;
};

template <int Dim>
void ViscousForce<Dim>::announce() {
    std::vector<const Body<Dim>*> walls = this->wallBodies();
    // Beside a far more viscous one a liquid feels twice its own viscosity, as it does at a wall.
    for (const Body<Dim>* liquid : liquids_.bodies()) walls.push_back(liquid);
    const ViscousBound bound = viscousBound<Dim>(*body_, form_, walls);
    const double mu = body_->fluid().material->viscosity();
    body_->fluid().viscous.whole += mu * bound.whole;
    body_->fluid().viscous.walls += mu * bound.walls;
}

template <int Dim>
void ViscousForce<Dim>::run(const Clock& clock) {
    this->actedAt(clock.time);
    if (varying_) findViscosity();
    withForm(form_, [&]<ViscousForm F>() {
        withPrecision(around_.own().precision(), [&]<class Real>() {
            if (varying_)
                accelerate<F, true, Real>();
            else
                accelerate<F, false, Real>();
        });
    });
    if (varying_ && form_ == ViscousForm::laplacian) addTransposedStress();
}

template <int Dim>
void ViscousForce<Dim>::findViscosity() {
    Varying& v = *varying_;
    v.velocity_gradient.find();
    materials::withViscosity(*v.law, [&](const auto& law) {
        parallelFor(body_->size(), [&](std::size_t i) {
            const Mat<Dim>& L = v.velocity_gradient.gradient()[i];
            // 2 D:D, D = (L + L^T)/2.
            const double rate = std::sqrt(0.5 * (L + L.transpose()).squaredNorm());
            v.shear_rate[i] = rate;
            v.viscosity[i] = law.viscosityAt(rate);
        });
    });
    v.largest = maxAll(body_->size(), 0.0, [&](std::size_t i) { return v.viscosity[i]; });
    factor_ = v.largest * per_viscosity_;
    this->findSlopes();
}

template <int Dim>
void ViscousForce<Dim>::addTransposedStress() {
    Varying& v = *varying_;
    v.stress.resize(body_->size());
    parallelFor(body_->size(), [&](std::size_t i) {
        const Mat<Dim>& L = v.velocity_gradient.gradient()[i];
        const Mat<Dim> transposed = L.transpose() - L.trace() * Mat<Dim>::Identity();
        v.stress[i] = v.viscosity[i] * transposed * v.velocity_gradient.correction()[i];
    });
    v.transposed.find(around_.own(), v.stress, volume_, body_->spacing);
    parallelFor(body_->size(),
                [&](std::size_t i) { external_[i] += v.transposed.force()[i] / mass_[i]; });
}

template <int Dim>
template <ViscousForm F, bool Varies, class Real>
void ViscousForce<Dim>::accelerate() {
    const PairTiles<Dim>& tiles = around_.own();
    const VelocitySteps velocity_steps(*body_);
    const double speed = velocity_steps.speed();
    records_.follow(tiles);
    records_.template fill<Real>(tiles, [&](TileRecord<Dim, Real>& record, Index i) {
        for (int c = 0; c < Dim; ++c) record.v[c] = velocity_steps.of<Real>(velocity_[i][c]);
        if constexpr (Varies) record.p = static_cast<Real>(this->share(i));
        record.V = static_cast<Real>(volume_[i] / cell_);
    });
    addOwnPairs<F, Varies, false, Real>(tiles, records_, sums_);
    const double unit = unitOfOwnPairs<Dim>(tiles, speed, cell_);
    const auto addWalls = [&](Index i, std::array<double, Dim>& force) {
        for (const auto& wall : around_.walls()) {
            const NeighborList<Dim>& list = wall.list();
            ExactSums<Dim> sum(SumGrid(largest_ / list.gradient_unit));
            forEachWallPair<Dim>(
                wall.fields, list, i, velocity_[i], nearest_,
                [&](const Pairs<Dim>& pair, const Lanes(&v_ij)[Dim], Lanes r, Lanes V_j) {
                    Lanes V = volume_[i] * V_j;
                    if constexpr (Varies) V *= this->shareAtWall(pair, r, i);
                    addPairs<F, Dim>(pair, v_ij, r, V, sum);
                });
            for (int c = 0; c < Dim; ++c) force[c] += list.gradient_unit * sum[c].value();
        }
        liquids_.template add<F>(i, velocity_[i], volume_[i], 1 / factor_, force);
    };
    sums_.forEach(tiles, body_->size(), unit, around_.atOthers(), addWalls,
                  [&](const Group& group, const VecOf<Dim, Wide>& force) {
                      const Wide factor = factor_ / load(mass_, group);
                      store(VecOf<Dim, Wide>(load(external_, group) + factor * force), external_,
                            group);
                  });
}

template <int Dim>
void checkEffect(const input::Component& method, BuiltCase<Dim>& built) {
    const std::string& body = method.as<ViscousForceParameters>().body.text;
    if (built.calls(method) && built.world.find(body)->fluid().material->viscosity() == 0)
        built.diagnostics.warning(
            method.place, fmt::format("{} does nothing: the viscosity of {} is 0", method.name,
                                      built.materials.at(body)->name));
}

/// No viscosity is forgotten.
template <int Dim>
void checkApplied(BuiltCase<Dim>& built) {
    for (const auto& body : built.world.bodies) {
        if (!body->isFluid() || body->fluid().material->viscosity() == 0) continue;
        const bool applied = std::ranges::any_of(built.called, [&](const input::Component* method) {
            const auto* p = method->template find<ViscousForceParameters>();
            const auto* implicit = method->template find<ImplicitViscosityParameters>();
            return (p && p->body.text == body->name) ||
                   (implicit && implicit->body.text == body->name);
        });
        if (!applied)
            built.diagnostics.warning(
                built.materials.at(body->name)->placeOf("viscosity"),
                fmt::format("nothing applies the viscosity of {}: the loop calls no "
                            "fluid.viscous_force or fluid.implicit_viscosity for it",
                            body->name));
    }
}

/// Fluids that see each other push each other alike.
void checkForms(const input::Component& method, WrittenCase& written) {
    const auto& own = method.as<ViscousForceParameters>();
    for (const input::Component* other : written.methods) {
        const auto* p = other->find<ViscousForceParameters>();
        if (!p || p->form == own.form || p->body.text == own.body.text) continue;
        if (other > &method || !written.sees(own.body.text, p->body.text)) continue;
        written.diagnostics.error(
            method.placeOf("form"),
            fmt::format("{} and {} see each other, so the viscous forces of both have one form",
                        p->body.text, own.body.text));
    }
}

}  // namespace

void declareViscousForce(input::Registry& registry) {
    using P = ViscousForceParameters;
    auto& d = declareMethod<ViscousForce, P>(registry, "fluid.viscous_force");
    d.summary("Viscous force between fluid particles and from no-slip walls");
    d.formula(
        "laplacian: dv_i/dt = 2 mu L/m_i sum_j v_ij/r_ij W' V_i V_j; central, guide (35): "
        "dv_i/dt = 2 (d+2) mu/m_i sum_j (v_ij . e_ij)/r_ij e_ij W' V_i V_j; where mu depends on "
        "the "
        "shear rate sqrt(2 D:D), the pair has sqrt(mu_i mu_j), and the laplacian gets "
        "1/m_i sum_j (T_i + T_j) . e_ij W' V_i V_j, T = mu (L^T - tr L), B-corrected");
    d.cite("guide", "(35)").cite("Morris, Fox & Zhu 1997", "(laplacian; velocity inside walls)");
    d.required("body", &P::body, input::bodyReference({"fluid"}),
               "fluid; its material gives the viscosity");
    d.optional("wall", &P::wall, wallSlips(), "condition at solids");
    d.optional("form", &P::form, viscousForms(), "sum over pairs");
    d.trait("sums_over_itself");
    d.rule(checkForms);
    d.worldRule([](const auto& method, auto& built) { checkEffect(method, built); });
    d.caseRule([](auto& built) { checkApplied(built); });
    d.action()
        .reads("body", {"velocity", "mass", "volume", "neighbors"})
        .reads("neighbors.fluid", {"velocity", "volume"})
        .reads("neighbors.solid", {"normal", "depth", "volume"})
        .reads("neighbors.driven", {"velocity"})
        .reads("neighbors.responding", {"average_velocity"})
        .writes("body", {"fresh_viscous_load"})
        .writes("body.generalised_newtonian", {"viscosity", "shear_rate"})
        .accumulates("body", {"external_acceleration"});
}

}  // namespace sphinx::dynamics::fluid
