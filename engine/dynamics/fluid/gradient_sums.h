// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/tile_loop.h"

#include <Eigen/LU>

namespace sphinx::dynamics::fluid {

/// Sums over a fluid's own pairs of which gradients are made: sum_j d_ij e_ij W' V_j, where d_ij is
/// a difference of what j and i have, the same seen from both with the other sign.
template <int Dim>
class GradientSums {
 public:
    /// difference(i, j, pair): d_ij, of the size of 1, which is `unit`. Volumes in records are
    /// those of a `cell`. Before the sums are stored, f(group, sum), also(i, sum) adds what else
    /// there is for the particles `some`.
    template <class Real, class Difference, class Also, class Function>
    void find(const PairTiles<Dim>& tiles, const TileRecords<Dim>& records, std::size_t n,
              double cell, double unit, Difference&& difference, const std::vector<Index>& some,
              Also&& also, Function&& f) {
        using Side = TileSide<Dim, Real>;
        using Tile = TileOf<Real>;
        sums_.template add<Reaction::own, Real>(
            tiles, records,
            [&](const Side& i, const Side& j, const TilePairs<Dim, Real>& pair, Tile(&on_i)[Dim],
                Tile(&on_j)[Dim]) {
                const Tile d = pair.weight * difference(i, j, pair);
                for (int b = 0; b < Dim; ++b) {
                    const Tile term = d * pair.gradient[b];
                    on_i[b] = term * j.V;
                    on_j[b] = term * i.V;
                }
            });
        sums_.forEach(tiles, n, unit * cell * tiles.gradientUnit(), some, also, f);
    }
    /// The same of the difference of places along an axis: a row of the moment matrix of which the
    /// inverse corrects gradients.
    template <class Real, class Also, class Function>
    void findMoments(const PairTiles<Dim>& tiles, const TileRecords<Dim>& records, std::size_t n,
                     double cell, int axis, const std::vector<Index>& some, Also&& also,
                     Function&& f) {
        constexpr double places = 0x1p28;  // they differ by up to 2^29 units
        using Side = TileSide<Dim, Real>;
        const auto apart = [axis](const Side&, const Side&,
                                  const TilePairs<Dim, Real>& pair) -> TileOf<Real> {
            return static_cast<Real>(1 / places) * pair.gradient[axis];
        };
        find<Real>(tiles, records, n, cell, places * tiles.placeUnit(), apart, some, also, f);
    }

 private:
    TileSums<Dim, Dim> sums_;
};

/// A row of matrices of a group of particles.
template <int Dim>
[[gnu::always_inline]] inline void storeRow(const VecOf<Dim, Wide>& row, int a,
                                            AlignedVector<Mat<Dim>>& matrices, const Group& group) {
    for (std::size_t k = 0; k < group.count; ++k)
        for (int b = 0; b < Dim; ++b) matrices[group.first + k](a, b) = row[b][k];
}

/// The inverse of a moment matrix, zero where too few neighbors are left: it is about 1 where all
/// are there, its determinant in a corner of the fluid 1/16 in 2D and 1/512 in 3D, and the least
/// that counts a third of that.
template <int Dim>
Mat<Dim> correctionOf(const Mat<Dim>& moment) {
    constexpr double least = Dim == 2 ? 1.0 / 48 : 1.0 / 1536;
    const Mat<Dim> symmetric = 0.5 * (moment + moment.transpose());
    if (!(symmetric.determinant() > least)) return Mat<Dim>::Zero();
    return symmetric.inverse();
}

/// Gradients of scalars of a fluid's particles over its own neighbors, B-corrected: what is
/// continued linearly into a wall.
template <int Dim>
class OwnGradients {
 public:
    /// With the present lists and volumes; `cell`: that of a particle of the lattice.
    void begin(const PairTiles<Dim>& tiles, std::size_t n, const Field<double>& volume,
               double cell) {
        tiles_ = &tiles;
        cell_ = cell;
        correction_.resize(n);
        slope_.resize(n);
        records_.follow(tiles);
        withPrecision(tiles.precision(), [&]<class Real>() {
            records_.template fill<Real>(tiles, [&](TileRecord<Dim, Real>& record, Index i) {
                record.V = static_cast<Real>(volume[i] / cell);
            });
            for (int a = 0; a < Dim; ++a)
                sums_.template findMoments<Real>(
                    tiles, records_, n, cell, a, {}, [](Index, std::array<double, Dim>&) {},
                    [&](const Group& group, const VecOf<Dim, Wide>& row) {
                        storeRow(row, a, correction_, group);
                    });
        });
        parallelFor(n, [&](std::size_t i) { correction_[i] = correctionOf<Dim>(correction_[i]); });
    }
    /// Of value(i), up to `largest` in size.
    template <class Value>
    const AlignedVector<Vec<Dim>>& find(double largest, Value&& value) {
        const std::size_t n = slope_.size();
        withPrecision(tiles_->precision(), [&]<class Real>() {
            using Side = TileSide<Dim, Real>;
            records_.template fill<Real>(*tiles_, [&](TileRecord<Dim, Real>& record, Index i) {
                record.p = static_cast<Real>(value(i) / largest);
            });
            sums_.template find<Real>(
                *tiles_, records_, n, cell_, largest,
                [](const Side& i, const Side& j, const TilePairs<Dim, Real>&) -> TileOf<Real> {
                    return j.p - i.p;
                },
                {}, [](Index, std::array<double, Dim>&) {},
                [&](const Group& group, const VecOf<Dim, Wide>& sum) {
                    store(sum, slope_.data(), group);
                });
        });
        parallelFor(n, [&](std::size_t i) { slope_[i] = (correction_[i] * slope_[i]).eval(); });
        return slope_;
    }

 private:
    const PairTiles<Dim>* tiles_ = nullptr;
    double cell_ = 1;
    TileRecords<Dim> records_;  // a value in the place of the pressure
    GradientSums<Dim> sums_;
    AlignedVector<Mat<Dim>> correction_;
    AlignedVector<Vec<Dim>> slope_;
};

}  // namespace sphinx::dynamics::fluid
