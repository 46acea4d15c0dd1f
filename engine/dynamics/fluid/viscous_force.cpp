// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fluid/viscous_force.h"

#include "core/exact_sum.h"
#include "core/sum_all.h"
#include "dynamics/fluid/liquid_friction.h"
#include "dynamics/fluid/no_slip_pairs.h"
#include "dynamics/fluid/solid_load.h"
#include "dynamics/fluid/stress_divergence.h"
#include "dynamics/fluid/surroundings.h"
#include "dynamics/fluid/velocity_gradient.h"
#include "dynamics/fluid/velocity_steps.h"
#include "dynamics/fluid/viscous_bound.h"
#include "dynamics/methods.h"
#include "dynamics/pair_loop.h"
#include "dynamics/tile_loop.h"
#include "materials/generalised_newtonian.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace sphinx::dynamics::fluid {
namespace {

template <class F>
decltype(auto) withForm(ViscousForm form, F&& f) {
    if (form == ViscousForm::laplacian) return f.template operator()<ViscousForm::laplacian>();
    return f.template operator()<ViscousForm::central>();
}

/// Adds the term of eight pairs, in the list's gradient unit.
template <ViscousForm F, int Dim>
inline void addPairs(const Pairs<Dim>& pair, const Lanes (&v_ij)[Dim], Lanes r, Lanes V,
                     ExactSums<Dim>& sum) {
    const Lanes f = viscousFactor<F, Dim, Lanes>(pair, v_ij, r, V);
    const auto& direction = viscousDirection<F, Dim, Lanes>(pair, v_ij);
    for (int c = 0; c < Dim; ++c) sum[c].addProduct(f, direction[c]);
}

template <int Dim>
class ViscousForce final : public SolidLoad<Dim> {
 public:
    ViscousForce(Context<Dim>& context, const ViscousForceParameters& p);

    void announce() override;
    void run(const Clock& clock);
    Load<Dim> loadOn(const Body<Dim>& solid, const NeighborList<Dim>& list,
                     const Vec<Dim>& about) const override;
    void addForces(const Body<Dim>& solid, const NeighborList<Dim>& list,
                   Field<Vec<Dim>>& force) const override;

 private:
    using SolidLoad<Dim>::body_;

    template <ViscousForm F, bool Varies, class Real>
    void accelerate();
    /// Of a generalised Newtonian fluid.
    void findViscosity();
    /// How its fluidity goes on at walls.
    void findSlopes() const;
    /// What the laplacian lacks where the viscosity varies.
    void addTransposedStress();
    template <ViscousForm F>
    Load<Dim> loadOn(const typename Surroundings<Dim>::Wall& wall, const NeighborList<Dim>& list,
                     const Vec<Dim>& about) const;
    template <ViscousForm F>
    void addForces(const typename Surroundings<Dim>::Wall& wall, const NeighborList<Dim>& list,
                   Field<Vec<Dim>>& force) const;

    /// Of a generalised Newtonian fluid: its law, and what it has found.
    struct Varying {
        const materials::GeneralisedNewtonianFluid* law;
        VelocityGradient<Dim> velocity_gradient;
        StressDivergence<Dim> transposed;
        Field<double>& viscosity;
        Field<double>& shear_rate;
        double largest = 0;
        AlignedVector<Mat<Dim>> stress = {};
        OwnGradients<Dim> gradients = {};
        /// Gradient of the fluidity largest/viscosity, empty where there are no walls.
        AlignedVector<Vec<Dim>> slope = {};
        std::uint64_t version = 0;  // of the particles, when it was found
    };
    /// The viscosity of particle i by that in factor_.
    double share(std::size_t i) const {
        return varying_ ? varying_->viscosity[i] / varying_->largest : 1;
    }
    /// The same of eight pairs of a fluid particle with particles of a wall, from the fluidities of
    /// the fluid and their gradients there: the wall's is the fluid's, continued linearly.
    static Lanes shareAtWall(const Pairs<Dim>& pair, Lanes r, Lanes fluidity,
                             const Lanes (&slope)[Dim]) {
        const Lanes at_wall = fluidity + r * pair.inverse_dW * dot<Dim>(slope, pair.gradient);
        return inverseSqrtLanes(fluidity * larger<Lanes>(at_wall, lanes(1)));
    }
    Lanes shareAtWall(const Pairs<Dim>& pair, Lanes r, std::size_t i) const {
        Lanes slope[Dim];
        for (int c = 0; c < Dim; ++c) slope[c] = lanes(varying_->slope[i][c]);
        return shareAtWall(pair, r, lanes(1 / share(i)), slope);
    }

    double nearest_;  // least distance of a fluid particle from a wall that is told apart
    ViscousForm form_;
    double per_viscosity_;  // 2 L or 2 (d + 2)
    double factor_;         // times the dynamic viscosity, the largest where it varies
    double largest_;        // that sums over pairs may reach
    mutable std::optional<Varying> varying_;
    Surroundings<Dim> around_;
    LiquidFriction<Dim> liquids_;
    TileRecords<Dim> records_;  // velocities in steps, volumes in those of a cell
    TileSums<Dim, Dim> sums_;
    Field<Vec<Dim>>& velocity_;
    Field<Vec<Dim>>& external_;
    Field<double>& mass_;
    Field<double>& volume_;
};

template <int Dim>
ViscousForce<Dim>::ViscousForce(Context<Dim>& context, const ViscousForceParameters& p)
    : SolidLoad<Dim>(context, bodyOf(context, p.body), LoadKind::viscous),
      nearest_(nearest_to_wall * body_->spacing),
      form_(p.form),
      per_viscosity_(
          2 * (p.form == ViscousForm::laplacian ? body_->kernel.laplacianFactor() : Dim + 2)),
      // What makes the sums forces.
      factor_(body_->fluid().material->viscosity() * per_viscosity_),
      // Weakly compressible: speeds stay below a tenth of that of sound. sum_j abs(W')/r V_j is a
      // few 1/spacing^2.
      largest_(body_->fluid().material->soundSpeed() * std::pow(body_->spacing, Dim - 2)),
      around_(context, *body_,
              {.walls = {.distance = true},
               .liquids = {.distance = true},
               .sees_walls = p.wall == WallSlip::no_slip}),
      liquids_(*body_, around_, p.form),
      velocity_(body_->particles.vector(fields::velocity)),
      external_(body_->particles.vector(fields::external_acceleration)),
      mass_(body_->particles.scalar(fields::mass)),
      volume_(body_->particles.scalar(fields::volume)) {
    if (const auto* law = materials::asGeneralisedNewtonian(*body_->fluid().material))
        varying_.emplace(
            Varying{law, VelocityGradient<Dim>(context, *body_, p.wall == WallSlip::no_slip),
                    StressDivergence<Dim>(), body_->particles.scalar(fields::viscosity),
                    body_->particles.scalar(fields::shear_rate), law->viscosity()});
}

template <int Dim>
void ViscousForce<Dim>::announce() {
    std::vector<const Body<Dim>*> walls;
    for (const auto& wall : around_.walls()) walls.push_back(wall.body);
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
    findSlopes();
}

template <int Dim>
void ViscousForce<Dim>::findSlopes() const {
    Varying& v = *varying_;
    if (around_.walls().empty()) return;
    const double cell = std::pow(body_->spacing, Dim);
    const double largest = maxAll(body_->size(), 0.0, [&](std::size_t i) { return 1 / share(i); });
    v.gradients.begin(around_.own(), body_->size(), volume_, cell);
    v.slope = v.gradients.find(largest, [&](Index i) { return 1 / share(i); });
    v.version = body_->version;
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
    using Side = TileSide<Dim, Real>;
    using Tile = TileOf<Real>;
    const double cell = std::pow(body_->spacing, Dim);
    const VelocitySteps velocity_steps(*body_);
    constexpr double steps = VelocitySteps::steps;
    const double speed = velocity_steps.speed();
    records_.follow(tiles);
    records_.template fill<Real>(tiles, [&](TileRecord<Dim, Real>& record, Index i) {
        for (int c = 0; c < Dim; ++c) record.v[c] = velocity_steps.of<Real>(velocity_[i][c]);
        if constexpr (Varies) record.p = static_cast<Real>(share(i));
        record.V = static_cast<Real>(volume_[i] / cell);
    });
    // The weight is abs(W')/r, where sums are made for abs(W'): r is about 2^28 places. Forces are
    // of the order of v_ij and not of its part along r, so some bits are left for that.
    constexpr double places = 0x1p24;
    sums_.template add<Reaction::opposite, Real>(
        tiles, records_,
        [](const Side& i, const Side& j, const TilePairs<Dim, Real>& pair, Tile(&on_i)[Dim],
           Tile(&)[Dim]) {
            Tile v_ij[Dim];
            for (int c = 0; c < Dim; ++c) v_ij[c] = stepsBetween(i.v[c], j.v[c]);
            Tile V = (pair.weight * static_cast<Real>(places / steps)) * (i.V * j.V);
            if constexpr (Varies) V = V * geometricMean<Tile>(i.p, j.p);
            const Tile f = viscousFactor<F, Dim, Tile>(pair, v_ij, pair.dW, V);
            const auto& direction = viscousDirection<F, Dim, Tile>(pair, v_ij);
            for (int c = 0; c < Dim; ++c) on_i[c] = f * direction[c];
        });
    const double unit = speed * cell * cell * tiles.gradientUnit() / (places * tiles.placeUnit());
    const auto addWalls = [&](Index i, std::array<double, Dim>& force) {
        for (const auto& wall : around_.walls()) {
            const NeighborList<Dim>& list = wall.list();
            ExactSums<Dim> sum(SumGrid(largest_ / list.gradient_unit));
            forEachWallPair<Dim>(
                wall.fields, list, i, velocity_[i], nearest_,
                [&](const Pairs<Dim>& pair, const Lanes(&v_ij)[Dim], Lanes r, Lanes V_j) {
                    Lanes V = volume_[i] * V_j;
                    if constexpr (Varies) V *= shareAtWall(pair, r, i);
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
Load<Dim> ViscousForce<Dim>::loadOn(const Body<Dim>& solid, const NeighborList<Dim>& list,
                                    const Vec<Dim>& about) const {
    const auto* wall = around_.wall(solid);
    if (!wall) return {};
    if (varying_) {
        if (!(maxAll(body_->size(), 0.0, [&](std::size_t i) { return share(i); }) > 0)) return {};
        if (varying_->version != body_->version || varying_->slope.size() != body_->size())
            findSlopes();
    }
    return withForm(form_, [&]<ViscousForm F>() { return loadOn<F>(*wall, list, about); });
}

template <int Dim>
template <ViscousForm F>
Load<Dim> ViscousForce<Dim>::loadOn(const typename Surroundings<Dim>::Wall& wall,
                                    const NeighborList<Dim>& list, const Vec<Dim>& about) const {
    using Vector = VecOf<Dim, Wide>;
    constexpr int moments = Dim == 2 ? 1 : 3;
    const double unit = list.gradient_unit;
    const SumGrid grid(largest_ / unit);
    const SumGrid moment_grid(largest_ * list.cutoff / unit);
    const auto& position = body_->particles.position();
    return sumAll(body_->size(), [&](std::size_t i) {
        Load<Dim> own;
        if (list.ranges[i].count == 0) return own;
        ExactSums<Dim> sum(grid);
        // The forces act at the wall's particles, r_ij away: -sum_j r_ij x f_ij.
        ExactSums<moments> lever(moment_grid);
        forEachWallPair<Dim>(
            wall.fields, list, i, velocity_[i], nearest_,
            [&](const Pairs<Dim>& pair, const Lanes(&v_ij)[Dim], Lanes r, Lanes V_j) {
                Lanes V = volume_[i] * V_j;
                if (varying_) V *= shareAtWall(pair, r, i);
                const Lanes f = viscousFactor<F, Dim, Lanes>(pair, v_ij, r, V);
                const auto& direction = viscousDirection<F, Dim, Lanes>(pair, v_ij);
                Vector d, e;
                for (int c = 0; c < Dim; ++c) {
                    sum[c].addProduct(f, direction[c]);
                    d[c] = direction[c];
                    e[c] = -pair.gradient[c] * pair.inverse_dW;
                }
                const auto turned = momentOf<Dim, Wide>(e, d);
                for (int c = 0; c < moments; ++c) lever[c].addProduct(f * r, turned[c].at);
            });
        const double scale = -unit * factor_;
        Vec<Dim> force;
        for (int c = 0; c < Dim; ++c) force[c] = scale * sum[c].value();
        own.add(position[i] - about, force);
        for (int c = 0; c < moments; ++c) own.moment[c] -= scale * lever[c].value();
        return own;
    });
}

template <int Dim>
void ViscousForce<Dim>::addForces(const Body<Dim>& solid, const NeighborList<Dim>& list,
                                  Field<Vec<Dim>>& force) const {
    if (const auto* wall = around_.wall(solid))
        withForm(form_, [&]<ViscousForm F>() { addForces<F>(*wall, list, force); });
}

template <int Dim>
template <ViscousForm F>
void ViscousForce<Dim>::addForces(const typename Surroundings<Dim>::Wall& wall,
                                  const NeighborList<Dim>& list, Field<Vec<Dim>>& force) const {
    const double unit = list.gradient_unit;
    const SumGrid grid(largest_ / unit);
    parallelFor(list.ranges.size(), [&](std::size_t j) {
        if (list.ranges[j].count == 0) return;
        ExactSums<Dim> sum(grid);
        const double V = (*wall.fields.volume)[j];
        forEachFluidPair<Dim>(
            wall.fields, list, j, velocity_, volume_, nearest_,
            [&](const Pairs<Dim>& pair, const Lanes(&v_ji)[Dim], Lanes r, Lanes V_i) {
                Lanes weight = V * V_i;
                if (varying_) {
                    Lanes slope[Dim];
                    gatherVectors<Dim>(varying_->slope.data(), pair.index, slope);
                    weight *= shareAtWall(
                        Pairs<Dim>{pair.reversed(), pair.index}, r,
                        varying_->largest / gatherLanes(varying_->viscosity.data(), pair.index),
                        slope);
                }
                addPairs<F, Dim>(pair, v_ji, r, weight, sum);
            });
        for (int c = 0; c < Dim; ++c) force[j][c] += unit * factor_ * sum[c].value();
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
            return p && p->body.text == body->name;
        });
        if (!applied)
            built.diagnostics.warning(
                built.materials.at(body->name)->placeOf("viscosity"),
                fmt::format("nothing applies the viscosity of {}: the loop calls no "
                            "fluid.viscous_force for it",
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
    d.optional("wall", &P::wall,
               input::choice<WallSlip>({
                   {"no_slip", WallSlip::no_slip, "the fluid sticks to solids"},
                   {"free_slip", WallSlip::free_slip, "solids exert no viscous force"},
               }),
               "condition at solids");
    d.optional("form", &P::form,
               input::choice<ViscousForm>({
                   {"laplacian", ViscousForm::laplacian, "exact in shear flow along walls"},
                   {"central", ViscousForm::central,
                    "guide (35): conserves angular momentum, for free fluid that turns; up to 18 % "
                    "too weak in shear flow along walls"},
               }),
               "sum over pairs");
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
