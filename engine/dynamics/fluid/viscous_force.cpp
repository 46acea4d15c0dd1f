// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fluid/viscous_force.h"

#include "core/exact_sum.h"
#include "core/sum_all.h"
#include "dynamics/fluid/largest.h"
#include "dynamics/fluid/solid_load.h"
#include "dynamics/fluid/surroundings.h"
#include "dynamics/fluid/viscous_bound.h"
#include "dynamics/methods.h"
#include "dynamics/pair_loop.h"
#include "dynamics/tile_loop.h"
#include "materials/fluid.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace sphinx::dynamics::fluid {
namespace {

template <class F>
decltype(auto) withForm(ViscousForm form, F&& f) {
    if (form == ViscousForm::laplacian) return f.template operator()<ViscousForm::laplacian>();
    return f.template operator()<ViscousForm::central>();
}

/// term(pair, v_ij, r, V_j) for the wall particles j near a fluid particle i of velocity v: with
/// the velocity difference continued into the wall.
template <int Dim, class Term>
inline void forEachWallPair(const WallFields<Dim>& wall, const NeighborList<Dim>& list,
                            std::size_t i, const Vec<Dim>& v, double nearest, Term&& term) {
    Distances<Dim> distances(list, i);
    forEachPair(list, i, [&](const Pairs<Dim>& pair) {
        const Lanes r = distances.next();
        Lanes v_ij[Dim];
        Lanes n[Dim];
        gatherVectors<Dim>(wall.velocity->data(), pair.index, v_ij);
        gatherVectors<Dim>(wall.normal->data(), pair.index, n);
        const Lanes depth = gatherLanes(wall.depth->data(), pair.index);
        const Lanes continued = continuation<Dim, Lanes>(pair, r, n, depth, nearest);
        for (int c = 0; c < Dim; ++c) v_ij[c] = continued * (v[c] - v_ij[c]);
        term(pair, v_ij, r, gatherLanes(wall.volume->data(), pair.index));
    });
}

/// The same for the fluid particles i near one wall particle j: term(pair, v_ji, r, V_i).
template <int Dim, class Term>
inline void forEachFluidPair(const WallFields<Dim>& wall, const NeighborList<Dim>& list,
                             std::size_t j, const Field<Vec<Dim>>& velocity,
                             const Field<double>& volume, double nearest, Term&& term) {
    Distances<Dim> distances(list, j);
    const Vec<Dim> vw = (*wall.velocity)[j];
    Lanes n[Dim];
    for (int c = 0; c < Dim; ++c) n[c] = lanes((*wall.normal)[j][c]);
    const Lanes depth = lanes((*wall.depth)[j]);
    forEachPair(list, j, [&](const Pairs<Dim>& pair) {
        const Lanes r = distances.next();
        const Lanes continued = continuation<Dim, Lanes>(pair, r, n, depth, nearest);
        Lanes v_ji[Dim];
        gatherVectors<Dim>(velocity.data(), pair.index, v_ji);
        for (int c = 0; c < Dim; ++c) v_ji[c] = continued * (vw[c] - v_ji[c]);
        term(pair, v_ji, r, gatherLanes(volume.data(), pair.index));
    });
}

/// Adds the term of eight pairs, in the list's gradient unit.
template <ViscousForm F, int Dim>
inline void addPairs(const Pairs<Dim>& pair, const Lanes (&v_ij)[Dim], Lanes r, Lanes V,
                     ExactSums<Dim>& sum) {
    const Lanes f = viscousFactor<F, Dim, Lanes>(pair, v_ij, r, V);
    const auto& direction = viscousDirection<F, Dim, Lanes>(pair, v_ij);
    for (int c = 0; c < Dim; ++c) sum[c].addProduct(f, direction[c]);
}

/// Difference of velocities that are whole numbers of a step.
[[gnu::always_inline]] inline FloatTile stepsBetween(FloatTile i, FloatTile j) {
    return toFloat(reinterpret_cast<WholeTile>(i) - reinterpret_cast<WholeTile>(j));
}
/// Of doubles, which need no steps.
[[gnu::always_inline]] inline DoubleTile stepsBetween(const DoubleTile& i, const DoubleTile& j) {
    return i - j;
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

    template <ViscousForm F, class Real>
    void accelerate();
    template <ViscousForm F>
    Load<Dim> loadOn(const typename Surroundings<Dim>::Wall& wall, const NeighborList<Dim>& list,
                     const Vec<Dim>& about) const;
    template <ViscousForm F>
    void addForces(const typename Surroundings<Dim>::Wall& wall, const NeighborList<Dim>& list,
                   Field<Vec<Dim>>& force) const;

    double nearest_;  // least distance of a fluid particle from a wall that is told apart
    ViscousForm form_;
    double factor_;   // dynamic viscosity times 2 L or 2 (d + 2)
    double largest_;  // that sums over pairs may reach
    Surroundings<Dim> around_;
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
      nearest_(0.25 * body_->spacing),
      form_(p.form),
      // What makes the sums forces.
      factor_(2 * body_->fluid().material->viscosity() *
              (p.form == ViscousForm::laplacian ? body_->kernel.laplacianFactor() : Dim + 2)),
      // Weakly compressible: speeds stay below a tenth of that of sound. sum_j abs(W')/r V_j is a
      // few 1/spacing^2.
      largest_(body_->fluid().material->soundSpeed() * std::pow(body_->spacing, Dim - 2)),
      around_(context, *body_,
              {.walls = {.distance = true}, .sees_walls = p.wall == WallSlip::no_slip}),
      velocity_(body_->particles.vector(fields::velocity)),
      external_(body_->particles.vector(fields::external_acceleration)),
      mass_(body_->particles.scalar(fields::mass)),
      volume_(body_->particles.scalar(fields::volume)) {}

template <int Dim>
void ViscousForce<Dim>::announce() {
    std::vector<const Body<Dim>*> walls;
    for (const auto& wall : around_.walls()) walls.push_back(wall.body);
    const ViscousBound bound = viscousBound<Dim>(*body_, form_, walls);
    const double mu = body_->fluid().material->viscosity();
    body_->fluid().viscous.whole += mu * bound.whole;
    body_->fluid().viscous.walls += mu * bound.walls;
}

template <int Dim>
void ViscousForce<Dim>::run(const Clock& clock) {
    this->actedAt(clock.time);
    withForm(form_, [&]<ViscousForm F>() {
        withPrecision(around_.own().precision(), [&]<class Real>() { accelerate<F, Real>(); });
    });
}

template <int Dim>
template <ViscousForm F, class Real>
void ViscousForce<Dim>::accelerate() {
    const PairTiles<Dim>& tiles = around_.own();
    using Side = TileSide<Dim, Real>;
    using Tile = TileOf<Real>;
    const double cell = std::pow(body_->spacing, Dim);
    // Floats are whole numbers of a step: so their differences, of which viscosity lives, are
    // exact.
    const double fastest = std::sqrt(largestSquaredSpeed<Dim>(*body_));
    const double speed = fastest > 0 ? fastest : body_->fluid().material->soundSpeed();
    constexpr double steps = 0x1p29;  // differences are below 2^31
    const auto stepsOf = [&](double v) -> Real {
        const double exact = v * (steps / speed);
        if constexpr (std::is_same_v<Real, double>)
            return exact;
        else
            return std::bit_cast<float>(static_cast<std::int32_t>(std::nearbyint(exact)));
    };
    records_.follow(tiles);
    records_.template fill<Real>(tiles, [&](TileRecord<Dim, Real>& record, Index i) {
        for (int c = 0; c < Dim; ++c) record.v[c] = stepsOf(velocity_[i][c]);
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
            const Tile V = (pair.weight * static_cast<Real>(places / steps)) * (i.V * j.V);
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
                    addPairs<F, Dim>(pair, v_ij, r, volume_[i] * V_j, sum);
                });
            for (int c = 0; c < Dim; ++c) force[c] += list.gradient_unit * sum[c].value();
        }
    };
    sums_.forEach(tiles, body_->size(), unit, around_.atWalls(), addWalls,
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
                const Lanes f = viscousFactor<F, Dim, Lanes>(pair, v_ij, r, volume_[i] * V_j);
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
        forEachFluidPair<Dim>(wall.fields, list, j, velocity_, volume_, nearest_,
                              [&](const Pairs<Dim>& pair, const Lanes(&v_ji)[Dim], Lanes r,
                                  Lanes V_i) { addPairs<F, Dim>(pair, v_ji, r, V * V_i, sum); });
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

}  // namespace

void declareViscousForce(input::Registry& registry) {
    using P = ViscousForceParameters;
    auto& d = declareMethod<ViscousForce, P>(registry, "fluid.viscous_force");
    d.summary("Viscous force between fluid particles and from no-slip walls");
    d.formula(
        "laplacian: dv_i/dt = 2 mu L/m_i sum_j v_ij/r_ij W' V_i V_j; central, guide (35): "
        "dv_i/dt = 2 (d+2) mu/m_i sum_j (v_ij . e_ij)/r_ij e_ij W' V_i V_j");
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
    d.worldRule([](const auto& method, auto& built) { checkEffect(method, built); });
    d.caseRule([](auto& built) { checkApplied(built); });
    d.action()
        .reads("body", {"velocity", "mass", "volume", "neighbors"})
        .reads("neighbors.solid", {"normal", "depth", "volume"})
        .reads("neighbors.driven", {"velocity"})
        .reads("neighbors.responding", {"average_velocity"})
        .writes("body", {"fresh_viscous_load"})
        .accumulates("body", {"external_acceleration"});
}

}  // namespace sphinx::dynamics::fluid
