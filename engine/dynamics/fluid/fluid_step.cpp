// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fluid/fluid_step.h"

#include "core/number.h"
#include "dynamics/fluid/liquid_pairs.h"
#include "dynamics/fluid/mean.h"
#include "dynamics/fluid/terms/pressure.h"
#include "dynamics/fluid/wall_pairs.h"
#include "materials/fluid_laws.h"

#include <algorithm>
#include <cmath>

namespace sphinx::dynamics::fluid {

template <int Dim>
FluidStep<Dim>::FluidStep(Context<Dim>& context, Body<Dim>& body, Riemann riemann)
    : SolidLoad<Dim>(context, body, LoadKind::pressure),
      domain_(&context.world.domain),
      fluid_(body_->fluid().material.get()),
      riemann_(riemann),
      constants_{fluid_->density(), fluid_->soundSpeed()},
      // Weakly compressible: pressures stay below a tenth of rho0 c0^2 and speeds below one of c0;
      // sum_j abs(W') V_j is about 1/spacing.
      largest_force_(0.1 * constants_.rho0 * constants_.c0 * constants_.c0 *
                     std::pow(body_->spacing, Dim - 1)),
      largest_rate_(0.1 * constants_.c0 / body_->spacing),
      largest_impedance_(4 * constants_.rho0 * constants_.c0 * std::pow(body_->spacing, Dim - 1)),
      cell_(std::pow(body_->spacing, Dim)),
      around_(context, *body_, {.walls = {.distance = true}}),
      position_(body_->particles.position()),
      velocity_(body_->particles.vector(fields::velocity)),
      external_(body_->particles.vector(fields::external_acceleration)),
      mass_(body_->particles.scalar(fields::mass)),
      volume_(body_->particles.scalar(fields::volume)),
      density_(body_->particles.scalar(fields::density)),
      density_rate_(body_->particles.scalar(fields::density_rate)),
      slack_(body_->particles.scalar(fields::slack)),
      pressure_(body_->particles.scalar(fields::pressure)) {
    loads_solids_ =
        std::ranges::any_of(around_.walls(), [](const auto& wall) { return wall.fields.responds; });
}

template <int Dim>
void FluidStep<Dim>::meet(const FluidStep& other) {
    for (const auto& liquid : around_.liquids())
        if (liquid.body == other.body_)
            liquids_.push_back(
                {liquid.relation, &other, interfaceOf(constants_, other.constants_)});
}

template <int Dim>
void FluidStep<Dim>::findFacings() {
    for (Neighbor& liquid : liquids_) {
        if (liquid.builds == liquid.relation->builds) continue;
        liquid.builds = liquid.relation->builds;
        findFacing(liquid.relation->list, liquid.facing);
    }
}

template <int Dim>
const AlignedVector<Vec<Dim>>& FluidStep<Dim>::facing(const FluidStep& other) const {
    return std::ranges::find(liquids_, &other, &Neighbor::step)->facing;
}

template <int Dim>
void FluidStep<Dim>::predict(const Clock& clock) {
    this->actedAt(clock.time);
    records_.follow(around_.own());
    around_.look();
    if (isReadLater()) before_.resize(body_->held());
    findFacings();
    if (clock.interval_start != interval_start_) {
        interval_start_ = clock.interval_start;
        findMeans();
    }
    withPrecision(around_.own().precision(), [&]<class Real>() { predict<Real>(clock.dt); });
}

template <int Dim>
void FluidStep<Dim>::kick(const Clock& clock) {
    withPrecision(around_.own().precision(), [&]<class Real>() {
        withRiemann(riemann_, [&]<Riemann R>() { momentum<R, Real>(clock.dt); });
    });
    kicks_ = body_->fluid().kicks;
    ++body_->version;
}

template <int Dim>
void FluidStep<Dim>::answerSolids(const Clock& clock) {
    this->actedAt(clock.time);
    last_dt_ = clock.dt;
    around_.look();
    withPrecision(around_.own().precision(), [&]<class Real>() {
        if (body_->fluid().kicks != kicks_) recordVelocities<Real>();
        addSlipImpulses<Real>();
    });
}

template <int Dim>
void FluidStep<Dim>::compress(const Clock& clock) {
    withPrecision(around_.own().precision(), [&]<class Real>() {
        withRiemann(riemann_, [&]<Riemann R>() { continuity<R, Real>(clock.dt); });
    });
    ++body_->version;
}

template <int Dim>
template <class Real>
void FluidStep<Dim>::predict(double dt) {
    const double half = 0.5 * dt;
    // A copy of the law: for all that the compiler knows, its constants could change in the loop.
    materials::withLaw(*fluid_, [&](const auto& law) {
        parallelForGroups(body_->size(), [&, law, rho0 = constants_.rho0](const Group& group) {
            const Wide rho = load(density_, group) + half * load(density_rate_, group);
            const Wide dense = select(load(slack_, group) > 0, max(rho, rho0), rho);
            const Wide p = law.pressure(dense);
            const Wide V = load(mass_, group) / dense;
            store(rho, density_, group);
            store(p, pressure_, group);
            store(V, volume_, group);
            addProduct(half, velocity_, position_, group);
            record<Real>(group, load(velocity_, group), p, V);
        });
    });
    records_.template updateCopies<Real>(around_.own());
    if (!isReadLater()) return;
    parallelFor(body_->size(), [&](std::size_t i) {
        PairState<Dim>& state = before_[i];
        for (int c = 0; c < Dim; ++c) state.v[c] = velocity_[i][c];
        state.p = pressure_[i];
        state.V = volume_[i];
    });
}

/// What the sums read of a group.
template <int Dim>
template <class Real>
[[gnu::always_inline]] inline void FluidStep<Dim>::record(const Group& group,
                                                          const VecOf<Dim, Wide>& v, Wide p,
                                                          Wide V) {
    const double per_c0 = 1 / constants_.c0;
    const double per_pressure = 1 / (constants_.rho0 * constants_.c0 * constants_.c0);
    const double per_cell = 1 / cell_;
    VecOf<Dim, Wide> relative;
    for (int c = 0; c < Dim; ++c) relative[c] = per_c0 * (v[c] - mean_velocity_[c]);
    records_.template put<Real>(around_.own(), group, relative, per_pressure * p, per_cell * V);
}

/// What the continuity sum reads of a group.
template <int Dim>
template <class Real>
[[gnu::always_inline]] inline void FluidStep<Dim>::recordKicked(const Group& group,
                                                                const VecOf<Dim, Wide>& v) {
    const VecOf<Dim, Wide> x = load(position_, group);
    Wide hydrostatic = weight_[0] * x[0];
    for (int c = 1; c < Dim; ++c) hydrostatic += weight_[c] * x[c];
    record<Real>(group, v, load(pressure_, group) - hydrostatic, load(volume_, group));
}

template <int Dim>
void FluidStep<Dim>::findMeans() {
    Mean<Dim> velocity, external, walls;
    velocity.add(velocity_, body_->size());
    mean_velocity_ = velocity.value();
    external.add(external_, body_->size());
    for (const auto& wall : around_.walls())
        if (wall.fields.acceleration) walls.add(*wall.fields.acceleration, wall.body->size());
    weight_ = constants_.rho0 * (external.value() - walls.value());
    // Along a periodic axis there is no hydrostatic pressure.
    for (int c = 0; c < Dim; ++c)
        if (domain_->periodic[c]) weight_[c] = 0;
}

template <int Dim>
std::vector<SumGrid> FluidStep<Dim>::wallGrids(double largest) const {
    std::vector<SumGrid> grids;
    for (const auto& wall : around_.walls())
        grids.emplace_back(largest / wall.list().gradient_unit);
    return grids;
}

/// Of the records' units.
constexpr RiemannConstants of_one{1, 1};

template <int Dim>
template <Riemann R, class Real>
void FluidStep<Dim>::momentum(double dt) {
    const PairTiles<Dim>& tiles = around_.own();
    using Side = TileSide<Dim, Real>;
    using Tile = TileOf<Real>;
    forces_.template add<Reaction::opposite, Real>(
        tiles, records_,
        [](const Side& i, const Side& j, const TilePairs<Dim, Real>& pair, Tile(&on_i)[Dim],
           Tile(&)[Dim]) {
            Tile v_ij[Dim];
            for (int c = 0; c < Dim; ++c) v_ij[c] = i.v[c] - j.v[c];
            const Tile p2 = twicePressure<R, Dim>(of_one, pair, v_ij, i.p, j.p);
            const Tile f = p2 * (pair.weight * (i.V * j.V));
            for (int c = 0; c < Dim; ++c) on_i[c] = f * pair.gradient[c];
        });
    const double pressure_unit = constants_.rho0 * constants_.c0 * constants_.c0;
    const double unit = pressure_unit * cell_ * cell_ * tiles.gradientUnit();
    const std::vector<SumGrid> grids = wallGrids(largest_force_);
    const auto addOthers = [&](Index i, std::array<double, Dim>& force) {
        for (std::size_t w = 0; w < grids.size(); ++w)
            addWallForce<R>(around_.walls()[w], grids[w], i, force);
        for (const Neighbor& liquid : liquids_) addLiquidForce<R>(liquid, i, force);
    };
    forces_.forEach(tiles, body_->size(), unit, around_.atOthers(), addOthers,
                    [&](const Group& group, const VecOf<Dim, Wide>& force) {
                        const Wide factor = -dt / load(mass_, group);
                        VecOf<Dim, Wide> v = load(velocity_, group);
                        v += factor * force;
                        v += dt * load(external_, group);
                        store(v, velocity_, group);
                        recordKicked<Real>(group, v);
                    });
}

template <int Dim>
template <class Real>
void FluidStep<Dim>::recordVelocities() {
    parallelForGroups(body_->size(), [&](const Group& group) {
        recordKicked<Real>(group, load(velocity_, group));
    });
}

/// Adds sum_j 2 p*_ij e_ij W' V_i V_j over the particles of a wall.
template <int Dim>
template <Riemann R>
[[gnu::noinline]] void FluidStep<Dim>::addWallForce(const typename Surroundings<Dim>::Wall& wall,
                                                    const SumGrid& grid, Index i,
                                                    std::array<double, Dim>& force) const {
    const NeighborList<Dim>& list = wall.list();
    const FluidSide<Dim, Lanes> fluid = oneFluid<Dim>(velocity_[i], external_[i], pressure_[i],
                                                      density_[i], slack_[i], leastPull());
    ExactSums<Dim> sum(grid);
    addWallPressure<R>(wall.fields, list, i, constants_, fluid, volume_[i], list.gradient_unit,
                       sum);
    for (int c = 0; c < Dim; ++c) force[c] += list.gradient_unit * sum[c].value();
}

/// Adds sum_j 2 p*_ij e_ij W' V_i V_j over the particles of another liquid.
template <int Dim>
template <Riemann R>
[[gnu::noinline]] void FluidStep<Dim>::addLiquidForce(const Neighbor& liquid, Index i,
                                                      std::array<double, Dim>& force) const {
    const NeighborList<Dim>& list = liquid.relation->list;
    const FluidStep& other = *liquid.step;
    // One for both: each gets what the other loses.
    const double largest = std::max(largest_force_, other.largest_force_);
    ExactSums<Dim> sum(SumGrid(largest / list.gradient_unit));
    addLiquidPressure<R>(liquid.interface, list, i, before_[i], other.before_.data(),
                         liquid.facing[i], other.facing(*this).data(), sum);
    for (int c = 0; c < Dim; ++c) force[c] += list.gradient_unit * sum[c].value();
}

template <int Dim>
Vec<Dim> FluidStep<Dim>::slipImpulse(const WallFields<Dim>& fields, const NeighborList<Dim>& list,
                                     std::size_t i) const {
    const double factor = 2 * constants_.rho0 * constants_.c0;
    const double unit = list.gradient_unit;
    // Slips are less than a spacing.
    ExactSums<Dim> sum(SumGrid(largest_impedance_ * body_->spacing / (factor * unit)));
    fluid::addSlipImpulse<Dim>(fields, list, i, volume_[i], unit, sum);
    Vec<Dim> impulse;
    for (int c = 0; c < Dim; ++c) impulse[c] = factor * unit * sum[c].value();
    return impulse;
}

template <int Dim>
template <class Real>
void FluidStep<Dim>::addSlipImpulses() {
    const std::vector<Index>& particles = around_.atOthers();
    for (const auto& wall : around_.walls()) {
        if (!wall.fields.responds) continue;
        parallelFor(particles.size(), [&](std::size_t k) {
            const Index i = particles[k];
            if (wall.list().ranges[i].count == 0) return;
            velocity_[i] += slipImpulse(wall.fields, wall.list(), i) / mass_[i];
            TileRecord<Dim, Real>& record =
                records_.template data<Real>()[around_.own().slotsOf()[i]];
            for (int c = 0; c < Dim; ++c)
                record.v[c] =
                    static_cast<Real>((velocity_[i][c] - mean_velocity_[c]) / constants_.c0);
        });
    }
}

template <int Dim>
Load<Dim> FluidStep<Dim>::loadOn(const Body<Dim>& solid, const NeighborList<Dim>& list,
                                 const Vec<Dim>& about) const {
    const auto* wall = around_.wall(solid);
    if (!wall) return {};
    Load<Dim> load;
    around_.look();
    withRiemann(riemann_, [&]<Riemann R>() { load = loadOn<R>(*wall, list, about); });
    return load;
}

template <int Dim>
template <Riemann R>
Load<Dim> FluidStep<Dim>::loadOn(const typename Surroundings<Dim>::Wall& wall,
                                 const NeighborList<Dim>& list, const Vec<Dim>& about) const {
    const double unit = list.gradient_unit;
    const SumGrid grid(largest_force_ / unit);
    return sumAll(body_->size(), [&](std::size_t i) {
        Load<Dim> own;
        if (list.ranges[i].count == 0) return own;
        ExactSums<Dim> sum(grid);
        const FluidSide<Dim, Lanes> fluid = oneFluid<Dim>(velocity_[i], external_[i], pressure_[i],
                                                          density_[i], slack_[i], leastPull());
        addWallPressure<R>(wall.fields, list, i, constants_, fluid, volume_[i], unit, sum);
        Vec<Dim> force;
        for (int c = 0; c < Dim; ++c) force[c] = unit * sum[c].value();
        if (wall.fields.responds && last_dt_ > 0)
            force -= slipImpulse(wall.fields, list, i) / last_dt_;
        // Along the line of two particles: the place of either gives the moment.
        own.add(position_[i] - about, force);
        return own;
    });
}

template <int Dim>
void FluidStep<Dim>::addForces(const Body<Dim>& solid, const NeighborList<Dim>& list,
                               Field<Vec<Dim>>& force) const {
    const double unit = list.gradient_unit;
    const SumGrid grid(largest_force_ / unit);
    if (const auto* wall = around_.wall(solid)) {
        withRiemann(riemann_, [&]<Riemann R>() {
            parallelFor(solid.size(), [&](std::size_t j) {
                if (list.ranges[j].count == 0) return;
                ExactSums<Dim> sum(grid);
                addFluidPressure<R>(wall->fields, list, j, constants_, before_.data(), external_,
                                    density_, slack_, leastPull(), sum);
                for (int c = 0; c < Dim; ++c) force[j][c] -= unit * sum[c].value();
            });
        });
    }
}

template <int Dim>
void FluidStep<Dim>::addImpedance(const Body<Dim>& solid, const NeighborList<Dim>& list,
                                  Field<Mat<Dim>>& impedance) const {
    const auto* wall = around_.wall(solid);
    if (!wall) return;
    const double factor = 2 * constants_.rho0 * constants_.c0;
    const double unit = list.gradient_unit;
    const SumGrid grid(largest_impedance_ / (factor * unit));
    parallelFor(solid.size(), [&](std::size_t j) {
        // An image moves as the others do, with nothing to be slowed down.
        if (list.ranges[j].count == 0 || !solid.hasMass(j)) return;
        ExactSums<Dim*(Dim + 1) / 2> sum(grid);
        fluid::addImpedance<Dim>(wall->fields, list, j, volume_, sum);
        for (int row = 0, k = 0; row < Dim; ++row)
            for (int column = 0; column <= row; ++column, ++k) {
                const double Z = factor * unit * sum[k].value();
                impedance[j](row, column) += Z;
                if (column < row) impedance[j](column, row) += Z;
            }
    });
}

template <int Dim>
template <Riemann R, class Real>
void FluidStep<Dim>::continuity(double dt) {
    const PairTiles<Dim>& tiles = around_.own();
    using Side = TileSide<Dim, Real>;
    using Tile = TileOf<Real>;
    records_.template updateCopies<Real>(tiles);
    rates_.template add<Reaction::own, Real>(
        tiles, records_,
        [](const Side& i, const Side& j, const TilePairs<Dim, Real>& pair, Tile(&on_i)[1],
           Tile(&on_j)[1]) {
            Tile v_ij[Dim];
            for (int c = 0; c < Dim; ++c) v_ij[c] = i.v[c] - j.v[c];
            const Tile p_ij = i.p - j.p;
            on_i[0] = pair.weight * j.V * closingRate<R, Dim>(of_one, pair, v_ij, p_ij);
            on_j[0] = pair.weight * i.V * closingRate<R, Dim>(of_one, pair, v_ij, -p_ij);
        });
    const double half = 0.5 * dt;
    const double unit = constants_.c0 * cell_ * tiles.gradientUnit();
    const std::vector<SumGrid> grids = wallGrids(largest_rate_);
    const auto addOthers = [&](Index i, std::array<double, 1>& closing) {
        for (std::size_t w = 0; w < grids.size(); ++w)
            closing[0] += wallClosing(around_.walls()[w], grids[w], i);
        for (const Neighbor& liquid : liquids_) closing[0] += liquidClosing(liquid, i);
    };
    rates_.forEach(tiles, body_->size(), unit, around_.atOthers(), addOthers,
                   [&](const Group& group, const VecOf<1, Wide>& closing) {
                       const Wide rho = load(density_, group);
                       const Wide rate = rho * closing[0];
                       store(rate, density_rate_, group);
                       store(rho + half * rate, density_, group);
                       addProduct(half, velocity_, position_, group);
                   });
}

/// sum_j 2 (v_i - v*_ij) . e_ij W' V_j over the particles of a wall.
template <int Dim>
[[gnu::noinline]] double FluidStep<Dim>::wallClosing(const typename Surroundings<Dim>::Wall& wall,
                                                     const SumGrid& grid, Index i) const {
    const NeighborList<Dim>& list = wall.list();
    ExactSum sum(grid);
    addWallClosure<Dim>(wall.fields, list, i, velocity_[i], list.gradient_unit, sum);
    return list.gradient_unit * sum.value();
}

/// sum_j 2 (v_i - v*_ij) . e_ij W' V_j over the particles of another liquid.
template <int Dim>
[[gnu::noinline]] double FluidStep<Dim>::liquidClosing(const Neighbor& liquid, Index i) const {
    const NeighborList<Dim>& list = liquid.relation->list;
    const FluidStep& other = *liquid.step;
    const double largest = std::max(largest_rate_, other.largest_rate_);
    ExactSum sum(SumGrid(largest / list.gradient_unit));
    addLiquidClosure<Dim>(liquid.interface, list, i, velocity_[i], other.velocity_, other.volume_,
                          sum);
    return list.gradient_unit * sum.value();
}

template class FluidStep<2>;
template class FluidStep<3>;

}  // namespace sphinx::dynamics::fluid
