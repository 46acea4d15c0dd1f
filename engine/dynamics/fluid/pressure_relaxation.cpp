// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/number.h"
#include "dynamics/fluid/liquid_pairs.h"
#include "dynamics/fluid/mean.h"
#include "dynamics/fluid/pair_state.h"
#include "dynamics/fluid/solid_load.h"
#include "dynamics/fluid/surroundings.h"
#include "dynamics/fluid/terms/pressure.h"
#include "dynamics/fluid/terms/riemann.h"
#include "dynamics/fluid/wall_pairs.h"
#include "dynamics/methods.h"
#include "dynamics/tile_loop.h"
#include "materials/fluid_laws.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>

namespace sphinx::dynamics::fluid {
namespace {

/// Acoustic step of a weakly compressible fluid, guide (51) and (56)-(58) read as drift-kick-drift:
///   first half:  rho += dt/2 drho, p(rho), r += dt/2 v, then
///                dv_i = -1/m_i sum_j 2 p*_ij e_ij W' V_i V_j + external,  v += dt dv
///   second half: drho_i = rho_i sum_j 2 (v_i - v*_ij) . e_ij W' V_j,  rho += dt/2 drho, r += dt/2
///   v
/// with p* and v* of the Riemann problem (riemann.h). Each sum runs once a step, and a solid loaded
/// between the halves feels the pressure that the fluid felt.
///
/// The pressures in U* are those above the hydrostatic one, p - rho0 g . r: a fluid at rest is left
/// at rest (Fourtakas et al. 2019, doi:10.1016/j.compfluid.2019.06.009, for the equivalent density
/// diffusion). With p itself the solver takes the weight of the fluid for a jump: the pressure of
/// water at rest is then too high by that of half a spacing at the surface. g is what weighs in the
/// frame of the walls, so that a tank that is shaken does what it does under a force the other way:
/// the mean external acceleration of the fluid less that of all rigid walls which it sees.
/// (That it is not 1.5 % too high everywhere: Kernel::gradientFactor.)
///
/// Solid neighbors are walls of dummy particles, one-sided Riemann problem along the wall's normal
/// n (turned towards the fluid): the ghost has the mirrored normal velocity (free slip) and the
/// pressure p_i + rho_i r_ij max(0, -(g_i - a_w) . e_ij). Where fluids see each other it is without
/// the max: hydrostatic also above the particle. With it a wall at the side bears only a half of
/// what it should of the weight beside it, and oil creeps down along it into water of twice its
/// density: by 4 to 16 spacings in three seconds, at rest as in waves.
///
/// Where the fluid is slack (fields::slack) it has the pressure and the volume of max(rho, rho0),
/// and a wall's p* is not negative: nothing pulls it.
///
/// Fluids that see each other are stepped by one method (`bodies`), so that each sum finds all of
/// them at the same instant: both halves go phase by phase, each for all fluids in turn. Their
/// pairs have terms of their own (terms/interface.h).
struct PressureRelaxationParameters {
    std::optional<input::Name> body;
    std::vector<input::Name> bodies;
    Riemann riemann = Riemann::low_dissipation;
};

std::vector<input::Name> bodiesOf(const PressureRelaxationParameters& p) {
    return p.body ? std::vector{*p.body} : p.bodies;
}

/// The step of one fluid, phase by phase.
template <int Dim>
class FluidStep final : public SolidLoad<Dim> {
 public:
    FluidStep(Context<Dim>& context, const input::Name& body, Riemann riemann);
    /// The step of a fluid that may be one of those which this one sees.
    void meet(const FluidStep& other);

    Load<Dim> loadOn(const Body<Dim>& solid, const NeighborList<Dim>& list,
                     const Vec<Dim>& about) const override;
    void addForces(const Body<Dim>& solid, const NeighborList<Dim>& list,
                   Field<Vec<Dim>>& force) const override;
    void addImpedance(const Body<Dim>& solid, const NeighborList<Dim>& list,
                      Field<Mat<Dim>>& impedance) const override;
    void transfer(Archive& archive) override {
        SolidLoad<Dim>::transfer(archive);
        archive.value("last_dt", last_dt_);
    }

    // The first half, then the second.
    void predict(const Clock& clock);
    void kick(const Clock& clock);
    void answerSolids(const Clock& clock);
    void compress(const Clock& clock);

 private:
    using SolidLoad<Dim>::body_;

    /// Another liquid that this one sees.
    struct Neighbor {
        const Relation<Dim>* relation;
        const FluidStep* step;
        Interface interface;
        std::uint64_t builds = 0;  ///< of the list, when `facing` was found
        AlignedVector<Vec<Dim>> facing = {};
    };
    /// Across the interface with another liquid, of each particle.
    void findFacings();
    const AlignedVector<Vec<Dim>>& facing(const FluidStep& other) const;

    /// FluidSide::least_pull
    double leastPull() const {
        return liquids_.empty() ? 0 : -std::numeric_limits<double>::infinity();
    }
    /// What the momentum sum has read.
    bool isReadLater() const { return loads_solids_ || !liquids_.empty(); }
    template <class Real>
    void predict(double dt);
    template <class Real>
    void record(const Group& group, const VecOf<Dim, Wide>& v, Wide p, Wide V);
    /// The mean weight of the fluid in the frame of its walls, and its mean velocity.
    void findMeans();
    /// Gives back what elastic solids have lost by the impedance of the fluid (Radiation).
    template <class Real>
    void addSlipImpulses();
    /// That impulse on particle i from one of them.
    Vec<Dim> slipImpulse(const WallFields<Dim>& fields, const NeighborList<Dim>& list,
                         std::size_t i) const;
    template <Riemann R>
    Load<Dim> loadOn(const typename Surroundings<Dim>::Wall& wall, const NeighborList<Dim>& list,
                     const Vec<Dim>& about) const;
    /// Of the sums over each wall, in the unit of its list.
    std::vector<SumGrid> wallGrids(double largest) const;
    template <Riemann R>
    void addLiquidForce(const Neighbor& liquid, Index i, std::array<double, Dim>& force) const;
    double liquidClosing(const Neighbor& liquid, Index i) const;
    template <Riemann R>
    void addWallForce(const typename Surroundings<Dim>::Wall& wall, const SumGrid& grid, Index i,
                      std::array<double, Dim>& force) const;
    double wallClosing(const typename Surroundings<Dim>::Wall& wall, const SumGrid& grid,
                       Index i) const;
    template <Riemann R, class Real>
    void momentum(double dt);
    template <Riemann R, class Real>
    void continuity(double dt);

    const Domain<Dim>* domain_;
    const materials::Fluid* fluid_;
    Riemann riemann_;
    RiemannConstants constants_;
    double largest_force_;  // that sums over pairs may reach, and of the rate
    double largest_rate_;
    double largest_impedance_;
    double cell_;         // volume of a particle of the lattice
    bool loads_solids_;   // that answer to forces
    double last_dt_ = 0;  // of the last slips
    // Found in the first step of each interval: no state of a restart.
    Vec<Dim> weight_ = Vec<Dim>::Zero();         // per volume
    Vec<Dim> mean_velocity_ = Vec<Dim>::Zero();  // in records it is taken off, which saves digits
    double interval_start_ = nan_value;
    mutable Surroundings<Dim> around_;  // looks at walls anew for a load
    std::vector<Neighbor> liquids_;

    Field<Vec<Dim>>& position_;
    Field<Vec<Dim>>& velocity_;
    Field<Vec<Dim>>& external_;
    Field<double>& mass_;
    Field<double>& volume_;
    Field<double>& density_;
    Field<double>& density_rate_;
    Field<double>& slack_;
    Field<double>& pressure_;

    // Filled anew in every step, in which no particle comes, goes or moves in memory.
    // As the momentum sum reads it, then with the new velocity and the pressure above the
    // hydrostatic, as the continuity sum does. Velocities in units of c0, pressures in rho0 c0^2,
    // volumes in those of a cell of the lattice.
    TileRecords<Dim> records_;
    TileSums<Dim, Dim> forces_;
    TileSums<Dim, 1> rates_;
    // What the momentum sum has read, for other liquids, which meet it at the same instant, and for
    // solids that get what the fluid has felt.
    AlignedVector<PairState<Dim>> before_;
};

template <int Dim>
FluidStep<Dim>::FluidStep(Context<Dim>& context, const input::Name& body, Riemann riemann)
    : SolidLoad<Dim>(context, bodyOf(context, body), LoadKind::pressure),
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
    ++body_->version;
}

template <int Dim>
void FluidStep<Dim>::answerSolids(const Clock& clock) {
    this->actedAt(clock.time);
    last_dt_ = clock.dt;
    around_.look();
    withPrecision(around_.own().precision(), [&]<class Real>() { addSlipImpulses<Real>(); });
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
                        const VecOf<Dim, Wide> x = load(position_, group);
                        Wide hydrostatic = weight_[0] * x[0];
                        for (int c = 1; c < Dim; ++c) hydrostatic += weight_[c] * x[c];
                        record<Real>(group, v, load(pressure_, group) - hydrostatic,
                                     load(volume_, group));
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

/// The steps of all fluids that see each other.
template <int Dim>
class PressureRelaxation final : public Method {
 public:
    PressureRelaxation(Context<Dim>& context, const PressureRelaxationParameters& p) {
        for (const input::Name& body : bodiesOf(p))
            steps_.push_back(std::make_unique<FluidStep<Dim>>(context, body, p.riemann));
        for (const auto& step : steps_)
            for (const auto& other : steps_)
                if (step != other) step->meet(*other);
    }

    void firstHalf(const Clock& clock) {
        for (const auto& step : steps_) step->predict(clock);
        for (const auto& step : steps_) step->kick(clock);
    }
    void secondHalf(const Clock& clock) {
        for (const auto& step : steps_) step->answerSolids(clock);
        for (const auto& step : steps_) step->compress(clock);
    }
    std::size_t workSize() const override {
        std::size_t n = 0;
        for (const auto& step : steps_) n += step->workSize();
        return n;
    }
    void rest() override {
        for (const auto& step : steps_) step->rest();
    }
    void transfer(Archive& archive) override {
        if (steps_.size() == 1) return steps_.front()->transfer(archive);
        for (const auto& step : steps_) {
            Section section(archive, step->fluid().name);
            step->transfer(archive);
        }
    }

 private:
    std::vector<std::unique_ptr<FluidStep<Dim>>> steps_;
};

/// What both sums need of the solids that the fluid sees.
input::Action& readSolids(input::Action& action) {
    return action.reads("neighbors.solid", {"volume"})
        .reads("neighbors.rigid", {"normal"})
        .reads("neighbors.driven", {"velocity", "acceleration"})
        .reads("neighbors.responding", {"average_velocity"});
}

/// Fluids that see each other are stepped together. Stresses at an interface are those of constant
/// viscosities (LiquidFriction).
void checkTogether(const input::Component& method, WrittenCase& written) {
    const std::vector<input::Name> own = bodiesOf(method.as<PressureRelaxationParameters>());
    const auto steps = [&](std::string_view body) {
        return std::ranges::any_of(own, [&](const auto& name) { return name.text == body; });
    };
    for (const input::Name& name : own)
        for (const WrittenCase::Sight& sight : written.topology) {
            const auto seen = written.materials.find(sight.seen.text);
            if (sight.body.text != name.text || sight.seen.text == name.text ||
                seen == written.materials.end() || !seen->second->declaration->hasTrait("fluid"))
                continue;
            if (!steps(sight.seen.text))
                written.diagnostics.error(
                    name.place,
                    fmt::format("{0} sees {1}, but {2} does not step {1}: one method steps both, "
                                "'bodies: [{0}, {1}]'",
                                name.text, sight.seen.text, method.name));
            const std::string& material = written.materials.at(name.text)->declaration->name();
            if (material != "weakly_compressible_fluid")
                written.diagnostics.error(
                    name.place, fmt::format("{} sees {} and is a {}: fluids that see each other "
                                            "are of weakly_compressible_fluid",
                                            name.text, sight.seen.text, material));
        }
}

}  // namespace

void declarePressureRelaxation(input::Registry& registry) {
    using P = PressureRelaxationParameters;
    auto& d = declareMethod<PressureRelaxation, P>(registry, "fluid.pressure_relaxation");
    d.summary("Acoustic step of a weakly compressible fluid in two halves around the momentum sum");
    d.formula(
        "guide (51), (56)-(58) as drift-kick-drift; m_i dv_i/dt = -2 sum_j p*_ij e_ij W' V_i V_j, "
        "drho_i/dt = 2 rho_i sum_j (v_i - v*_ij) . e_ij W' V_j; between fluids p* = s_j p_i + s_i "
        "p_j "
        "+ jump, v* = s_i v_i + s_j v_j, s_i = rho_i/(rho_i + rho_j)");
    d.cite("guide", "(51), (56)-(58)").cite("Zhang, Hu & Adams 2017");
    d.cite("Rezavand, Zhang & Hu 2020", "(jump between two fluids)");
    d.optional("body", &P::body, input::bodyReference({"fluid"}), "fluid that is stepped");
    d.optional("bodies", &P::bodies, input::list(input::bodyReference({"fluid"})),
               "in place of body: fluids that see each other, which are stepped together");
    d.check("body", [](const P& p) -> std::string {
        if (p.body && !p.bodies.empty()) return "either body or bodies, not both";
        return p.body || !p.bodies.empty() ? "" : "body or bodies says which fluid is stepped";
    });
    d.check("bodies", [](const P& p) -> std::string {
        for (std::size_t k = 1; k < p.bodies.size(); ++k)
            for (std::size_t m = 0; m < k; ++m)
                if (p.bodies[k].text == p.bodies[m].text)
                    return p.bodies[k].text + " is listed twice";
        return "";
    });
    d.optional("riemann", &P::riemann,
               input::choice<Riemann>({
                   {"none", Riemann::none, "averages: no dissipation"},
                   {"dissipative", Riemann::dissipative, "linearised Riemann problem"},
                   {"low_dissipation", Riemann::low_dissipation, "the same with the limiter"},
               }),
               "how pressure and velocity between two particles are found");
    d.trait("sums_over_itself");
    d.rule([](const input::Component& method, WrittenCase& written) {
        warnUnbounded(method, written, "fluid.acoustic_time_step");
        checkTogether(method, written);
    });
    auto& first = d.action(
        "first_half", "density, pressure and position to the half step; velocity by a whole step",
        [](auto& method, const Clock& clock) { method.firstHalf(clock); });
    auto& second = d.action("second_half",
                            "rate of change of the density; density and position to the full step",
                            [](auto& method, const Clock& clock) { method.secondHalf(clock); });
    for (const char* owner : {"body", "bodies"}) {
        first.reads(owner, {"velocity", "mass", "density", "density_rate", "slack", "position",
                            "external_acceleration", "neighbors"});
        second.reads(owner, {"velocity", "pressure", "volume", "density", "position",
                             "external_acceleration", "mass", "neighbors"});
    }
    readSolids(first);
    readSolids(second).mayRead("neighbors.responding", {"slip"});
    for (const char* owner : {"body", "bodies"}) {
        first.writes(owner, {"density", "pressure", "volume", "position", "velocity"})
            .opens(owner, "step");
        second.writes(owner, {"density_rate", "density", "position", "velocity"})
            .closes(owner, "step");
    }
}

}  // namespace sphinx::dynamics::fluid
