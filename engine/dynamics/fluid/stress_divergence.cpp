// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fluid/stress_divergence.h"

#include <cmath>

namespace sphinx::dynamics::fluid {

template <int Dim>
void StressDivergence<Dim>::find(const PairTiles<Dim>& tiles, const AlignedVector<Mat<Dim>>& stress,
                                 const Field<double>& volume, double spacing) {
    const std::size_t n = stress.size();
    const double largest =
        maxAll(n, 0.0, [&](std::size_t i) { return stress[i].cwiseAbs().maxCoeff(); });
    force_.assign(n, Vec<Dim>::Zero());
    if (!(largest > 0)) return;
    const double cell = std::pow(spacing, Dim);
    withPrecision(tiles.precision(),
                  [&]<class Real>() { sum<Real>(tiles, stress, volume, cell, largest); });
}

template <int Dim>
template <class Real>
void StressDivergence<Dim>::sum(const PairTiles<Dim>& tiles, const AlignedVector<Mat<Dim>>& stress,
                                const Field<double>& volume, double cell, double largest) {
    using Side = TileSide<Dim, Real>;
    using Tile = TileOf<Real>;
    records_.follow(tiles);
    for (int a = 0; a < Dim; ++a) {
        records_.template fill<Real>(tiles, [&](TileRecord<Dim, Real>& record, Index i) {
            for (int b = 0; b < Dim; ++b)
                record.v[b] = static_cast<Real>(stress[i](a, b) / largest);
            record.V = static_cast<Real>(volume[i] / cell);
        });
        sums_.template add<Reaction::opposite, Real>(
            tiles, records_,
            [](const Side& i, const Side& j, const TilePairs<Dim, Real>& pair, Tile(&on_i)[1],
               Tile(&)[1]) {
                Tile both[Dim];
                for (int b = 0; b < Dim; ++b) both[b] = i.v[b] + j.v[b];
                on_i[0] = pair.weight * (i.V * j.V) * dot<Dim>(both, pair.gradient);
            });
        static const std::vector<Index> none;
        sums_.forEach(
            tiles, stress.size(), largest * cell * cell * tiles.gradientUnit(), none,
            [](Index, std::array<double, 1>&) {},
            [&](const Group& group, const VecOf<1, Wide>& sum) {
                for (std::size_t k = 0; k < group.count; ++k)
                    force_[group.first + k][a] = sum[0][k];
            });
    }
}

template class StressDivergence<2>;
template class StressDivergence<3>;

}  // namespace sphinx::dynamics::fluid
