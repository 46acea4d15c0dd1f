// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fluid/transport_velocity.h"

#include "core/exact_sum.h"
#include "dynamics/fluid/mean.h"
#include "dynamics/fluid/support.h"
#include "dynamics/fluid/surroundings.h"
#include "dynamics/methods.h"
#include "dynamics/pair_loop.h"
#include "dynamics/tile_loop.h"
#include "materials/fluid.h"

#include <optional>

namespace sphinx::dynamics::fluid {
namespace {

/// Of the gradient of the sum, in squared spacings.
constexpr double shift_factor = 0.3;

template <int Dim>
class TransportVelocity final : public Method {
 public:
    TransportVelocity(Context<Dim>& context, const TransportVelocityParameters& p)
        : body_(&bodyOf(context, p.body)),
          c0_(body_->fluid().material->soundSpeed()),
          rho0_(body_->fluid().material->density()),
          cell_(std::pow(body_->spacing, Dim)),
          around_(context, *body_, {}),
          position_(body_->particles.position()),
          velocity_(body_->particles.vector(fields::velocity)),
          mass_(body_->particles.scalar(fields::mass)),
          volume_(body_->particles.scalar(fields::volume)) {
        if (p.surface == Surface::free) support_.emplace(context, *body_);
    }

    void run(const Clock&) {
        withPrecision(around_.own().precision(), [&]<class Real>() {
            findShift<Real>();
            Mean<Dim> mean;
            mean.add(velocity_, body_->size());
            for (int c = 0; c < Dim; ++c) carry<Real>(c, mean.value()[c]);
        });
        parallelForGroups(body_->size(), [&](const Group& group) {
            store(VecOf<Dim, Wide>(load(position_, group) + load(shift_.data(), group)), position_,
                  group);
        });
        ++body_->version;
    }
    std::size_t workSize() const override { return body_->size(); }

 private:
    template <class Real>
    void findShift();
    /// Of a component of the momentum, relative to the mean of that of the velocity.
    template <class Real>
    void carry(int component, double mean);
    /// sum_j e_ij W' V_j over the solids, over the other liquids.
    Vec<Dim> solidGradient(Index i) const;
    Vec<Dim> liquidGradient(Index i) const;
    /// Adds that over the neighbors of a list.
    void addGradient(const NeighborList<Dim>& list, const Field<double>& volume, Index i,
                     Vec<Dim>& gradient) const;

    Body<Dim>* body_;
    double c0_, rho0_, cell_;
    Surroundings<Dim> around_;
    std::optional<Support<Dim>> support_;
    Field<Vec<Dim>>& position_;
    Field<Vec<Dim>>& velocity_;
    Field<double>& mass_;
    Field<double>& volume_;
    // Filled anew in every call. Records have shifts in spacings in the place of velocities, and a
    // component of the momentum per volume, in rho0 c0, in that of the pressure.
    AlignedVector<Vec<Dim>> shift_;
    AlignedVector<Vec<Dim>> at_solids_;  // solidGradient(), of the particles at solids
    TileRecords<Dim> records_;
    TileSums<Dim, Dim> gradients_;
    TileSums<Dim, 1> momenta_;
};

template <int Dim>
void TransportVelocity<Dim>::addGradient(const NeighborList<Dim>& list, const Field<double>& volume,
                                         Index i, Vec<Dim>& gradient) const {
    // sum_j abs(W') V_j is about 1/spacing.
    ExactSums<Dim> sum(SumGrid(1 / (body_->spacing * list.gradient_unit)));
    forEachPair(list, i, [&](const Pairs<Dim>& pair) {
        const Lanes V_j = gatherLanes(volume.data(), pair.index);
        for (int c = 0; c < Dim; ++c) sum[c].addProduct(V_j, pair.gradient[c]);
    });
    for (int c = 0; c < Dim; ++c) gradient[c] += list.gradient_unit * sum[c].value();
}

template <int Dim>
Vec<Dim> TransportVelocity<Dim>::solidGradient(Index i) const {
    Vec<Dim> gradient = Vec<Dim>::Zero();
    for (const auto& wall : around_.walls())
        addGradient(wall.list(), *wall.fields.volume, i, gradient);
    return gradient;
}

template <int Dim>
Vec<Dim> TransportVelocity<Dim>::liquidGradient(Index i) const {
    Vec<Dim> gradient = Vec<Dim>::Zero();
    for (const auto& liquid : around_.liquids())
        addGradient(liquid.list(), *liquid.volume, i, gradient);
    return gradient;
}

template <int Dim>
template <class Real>
void TransportVelocity<Dim>::findShift() {
    const PairTiles<Dim>& tiles = around_.own();
    using Side = TileSide<Dim, Real>;
    using Tile = TileOf<Real>;
    const std::size_t n = body_->size();
    if (support_) support_->findSurface(n);
    shift_.resize(n);
    at_solids_.resize(n);
    records_.follow(tiles);
    parallelForGroups(n, [&](const Group& group) {
        const Wide V = 1 / cell_ * load(volume_, group);
        records_.template put<Real>(tiles, group, VecOf<Dim, Wide>::Zero(), 0, V);
    });
    records_.template updateCopies<Real>(tiles);
    gradients_.template add<Reaction::own, Real>(
        tiles, records_,
        [](const Side& i, const Side& j, const TilePairs<Dim, Real>& pair, Tile(&on_i)[Dim],
           Tile(&on_j)[Dim]) {
            for (int c = 0; c < Dim; ++c) {
                const Tile g = pair.weight * pair.gradient[c];
                on_i[c] = g * j.V;
                on_j[c] = -(g * i.V);
            }
        });
    const auto addOthers = [&](Index i, std::array<double, Dim>& gradient) {
        at_solids_[i] = solidGradient(i);
        const Vec<Dim> of_liquids = liquidGradient(i);
        for (int c = 0; c < Dim; ++c) gradient[c] += at_solids_[i][c] + of_liquids[c];
    };
    const double factor = -shift_factor * body_->spacing * body_->spacing;
    gradients_.forEach(tiles, n, cell_ * tiles.gradientUnit(), around_.atOthers(), addOthers,
                       [&](const Group& group, const VecOf<Dim, Wide>& gradient) {
                           VecOf<Dim, Wide> shift = factor * gradient;
                           if (support_) {
                               const LaneMask cut_off = support_->isCutOff(group);
                               for (int c = 0; c < Dim; ++c)
                                   shift[c] = select(cut_off, Wide(0), shift[c]);
                           }
                           store(shift, shift_.data(), group);
                       });
}

template <int Dim>
template <class Real>
void TransportVelocity<Dim>::carry(int component, double mean) {
    const PairTiles<Dim>& tiles = around_.own();
    using Side = TileSide<Dim, Real>;
    using Tile = TileOf<Real>;
    const std::size_t n = body_->size();
    const auto momentum = [&](const Group& group) -> Wide {
        return load(mass_, group) / load(volume_, group) *
               (load(velocity_, group)[component] - mean);
    };
    parallelForGroups(n, [&](const Group& group) {
        records_.template put<Real>(tiles, group, 1 / body_->spacing * load(shift_.data(), group),
                                    1 / (rho0_ * c0_) * momentum(group),
                                    1 / cell_ * load(volume_, group));
    });
    records_.template updateCopies<Real>(tiles);
    momenta_.template add<Reaction::opposite, Real>(
        tiles, records_,
        [](const Side& i, const Side& j, const TilePairs<Dim, Real>& pair, Tile(&on_i)[1],
           Tile(&)[1]) {
            Tile carried[Dim];
            for (int c = 0; c < Dim; ++c) carried[c] = i.p * i.v[c] + j.p * j.v[c];
            on_i[0] = pair.weight * (i.V * j.V) * dot<Dim>(carried, pair.gradient);
        });
    const auto addSolids = [&](Index i, std::array<double, 1>& sum) {
        const double rho = mass_[i] / volume_[i];
        sum[0] +=
            rho * (velocity_[i][component] - mean) * volume_[i] * shift_[i].dot(at_solids_[i]);
    };
    const double unit = rho0_ * c0_ * body_->spacing * cell_ * cell_ * tiles.gradientUnit();
    momenta_.forEach(tiles, n, unit, around_.atOthers(), addSolids,
                     [&](const Group& group, const VecOf<1, Wide>& sum) {
                         VecOf<Dim, Wide> v = load(velocity_, group);
                         v[component] += sum[0] / load(mass_, group);
                         store(v, velocity_, group);
                     });
}

}  // namespace

void declareTransportVelocity(input::Registry& registry) {
    using P = TransportVelocityParameters;
    auto& d = declareMethod<TransportVelocity, P>(registry, "fluid.transport_velocity");
    d.summary("Evens out the particles of a fluid: they move with another velocity than its own");
    d.formula(
        "s_i = -0.3 dp^2 sum_j e_ij W' V_j added to the position in each step of its layer, and "
        "the extra stress of guide (50): m_i dv_i = sum_j (rho_i v_i s_i + rho_j v_j s_j) . e_ij "
        "W' V_i V_j, v relative to the mean of the fluid");
    d.cite("guide", "(40), (48)-(51)").cite("Adami, Hu & Adams 2013");
    d.required("body", &P::body, input::bodyReference({"fluid"}), "fluid");
    d.optional("surface", &P::surface, surfaceWords(),
               "whether the fluid has a free surface; what is near it is not shifted");
    d.trait("sums_over_itself");
    d.rule([](const input::Component& method, WrittenCase& written) {
        const auto* own = method.find<P>();
        if (own->surface == Surface::free) return;
        for (const input::Component* other : written.methods) {
            const auto* density = other->find<DensitySummationParameters>();
            if (!density || density->body.text != own->body.text ||
                density->surface != Surface::free)
                continue;
            written.diagnostics.error(
                method.placeOf("body"),
                "the density of '" + own->body.text +
                    "' is that of a fluid with a free surface, over which a transport velocity "
                    "would spread it; 'surface: free' finds the surface");
        }
    });
    d.action("before the acoustic steps, with fresh neighbors")
        .reads("body", {"mass", "volume", "velocity", "position", "neighbors"})
        .reads("neighbors.fluid", {"volume"})
        .reads("neighbors.solid", {"volume"})
        .writes("body", {"position", "velocity"});
}

}  // namespace sphinx::dynamics::fluid
