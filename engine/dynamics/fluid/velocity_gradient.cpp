// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fluid/velocity_gradient.h"

#include "core/exact_sum.h"
#include "dynamics/fluid/no_slip_pairs.h"
#include "dynamics/fluid/velocity_steps.h"

#include <cmath>

namespace sphinx::dynamics::fluid {
template <int Dim>
VelocityGradient<Dim>::VelocityGradient(Context<Dim>& context, Body<Dim>& body,
                                        bool sticks_to_walls)
    : body_(&body),
      around_(context, body, {.walls = {.distance = true}, .sees_walls = sticks_to_walls}),
      velocity_(body.particles.vector(fields::velocity)),
      volume_(body.particles.scalar(fields::volume)) {}

template <int Dim>
void VelocityGradient<Dim>::addWalls() {
    const double nearest = nearest_to_wall * body_->spacing;
    // sum_j abs(W') V_j is about 1/spacing, and speeds continued into a wall are below that of
    // sound.
    const double c0 = body_->fluid().material->soundSpeed();
    const auto& at_walls = around_.atOthers();
    parallelFor(at_walls.size(), [&](std::size_t k) {
        const Index i = at_walls[k];
        for (const auto& wall : around_.walls()) {
            const NeighborList<Dim>& list = wall.list();
            const double unit = list.gradient_unit;
            ExactSums<Dim * Dim> velocities(SumGrid(4 * c0 / (body_->spacing * unit)));
            ExactSums<Dim*(Dim + 1) / 2> moments(SumGrid(4 / unit));
            forEachWallPair<Dim>(
                wall.fields, list, i, velocity_[i], nearest,
                [&](const Pairs<Dim>& pair, const Lanes(&v_ij)[Dim], Lanes r, Lanes V_j) {
                    const Lanes along = r * pair.inverse_dW * V_j;
                    for (int a = 0, m = 0; a < Dim; ++a) {
                        for (int b = 0; b < Dim; ++b)
                            velocities[a * Dim + b].addProduct(-v_ij[a] * V_j, pair.gradient[b]);
                        for (int b = 0; b <= a; ++b, ++m)
                            moments[m].addProduct(along, pair.gradient[a] * pair.gradient[b]);
                    }
                });
            for (int a = 0, m = 0; a < Dim; ++a) {
                for (int b = 0; b < Dim; ++b)
                    gradient_[i](a, b) += unit * velocities[a * Dim + b].value();
                for (int b = 0; b <= a; ++b, ++m) {
                    correction_[i](a, b) += unit * moments[m].value();
                    correction_[i](b, a) = correction_[i](a, b);
                }
            }
        }
    });
}

template <int Dim>
template <class Real>
void VelocityGradient<Dim>::sum() {
    const PairTiles<Dim>& tiles = around_.own();
    using Side = TileSide<Dim, Real>;
    using Tile = TileOf<Real>;
    const std::size_t n = body_->size();
    const double cell = std::pow(body_->spacing, Dim);
    const VelocitySteps steps(*body_);
    records_.follow(tiles);
    records_.template fill<Real>(tiles, [&](TileRecord<Dim, Real>& record, Index i) {
        for (int c = 0; c < Dim; ++c) record.v[c] = steps.of<Real>(velocity_[i][c]);
        record.V = static_cast<Real>(volume_[i] / cell);
    });
    for (int a = 0; a < Dim; ++a) {
        const auto addWall = [a](const AlignedVector<Mat<Dim>>& of_walls) {
            return [a, &of_walls](Index i, std::array<double, Dim>& row) {
                for (int b = 0; b < Dim; ++b) row[b] += of_walls[i](a, b);
            };
        };
        sums_.template find<Real>(
            tiles, records_, n, cell, steps.speed(),
            [a](const Side& i, const Side& j, const TilePairs<Dim, Real>&) -> Tile {
                return static_cast<Real>(1 / VelocitySteps::steps) * stepsBetween(j.v[a], i.v[a]);
            },
            around_.atOthers(), addWall(gradient_),
            [&](const Group& group, const VecOf<Dim, Wide>& row) {
                storeRow(row, a, gradient_, group);
            });
        sums_.template findMoments<Real>(tiles, records_, n, cell, a, around_.atOthers(),
                                         addWall(correction_),
                                         [&](const Group& group, const VecOf<Dim, Wide>& row) {
                                             storeRow(row, a, correction_, group);
                                         });
    }
}

template <int Dim>
void VelocityGradient<Dim>::find() {
    gradient_.assign(body_->size(), Mat<Dim>::Zero());
    correction_.assign(body_->size(), Mat<Dim>::Zero());
    addWalls();
    withPrecision(around_.own().precision(), [&]<class Real>() { sum<Real>(); });
    parallelFor(body_->size(), [&](std::size_t i) {
        correction_[i] = correctionOf<Dim>(correction_[i]);
        gradient_[i] = (gradient_[i] * correction_[i]).eval();
    });
}

template class VelocityGradient<2>;
template class VelocityGradient<3>;

}  // namespace sphinx::dynamics::fluid
