// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The pressure between a fluid particle and a dummy particle of a wall, eight pairs at a time: of
// one fluid particle with eight of a wall, or of one wall particle with eight of the fluid. Both
// get the same numbers, so what one loses the other gains.

#include "core/exact_sum.h"
#include "dynamics/fluid/pair_state.h"
#include "dynamics/fluid/terms/wall.h"
#include "dynamics/fluid/wall_fields.h"
#include "dynamics/pair_loop.h"

namespace sphinx::dynamics::fluid {

template <int Dim>
inline void spread(const Vec<Dim>& value, Lanes (&out)[Dim]) {
    for (int c = 0; c < Dim; ++c) out[c] = lanes(value[c]);
}

/// `slack`: see fields::slack; `pull`: FluidSide::least_pull.
template <int Dim>
inline FluidSide<Dim, Lanes> oneFluid(const Vec<Dim>& v, const Vec<Dim>& g, double p, double rho,
                                      double slack, double pull) {
    FluidSide<Dim, Lanes> fluid;
    spread<Dim>(v, fluid.v);
    spread<Dim>(g, fluid.g);
    fluid.p = lanes(p);
    fluid.rho = lanes(rho);
    if (slack > 0) fluid.least = lanes(0);
    fluid.least_pull = lanes(pull);
    return fluid;
}

/// Direction along which a motion against the wall particles of eight pairs counts, whichever way
/// it points: along the line of the pair, or along their normals. Returns their volumes.
template <int Dim>
inline Lanes gatherFaces(const WallFields<Dim>& fields, const Pairs<Dim>& pair, bool along_line,
                         Lanes (&n)[Dim]) {
    Lanes words[4];
    gatherRecords<WallFace<Dim>::stride>(fields.faces.data()->n, pair.index, words);
    for (int c = 0; c < Dim; ++c) n[c] = along_line ? pair.gradient[c] * pair.inverse_dW : words[c];
    return words[Dim];
}

/// Velocities of the wall particles of eight pairs, and accelerations where they are seen.
template <int Dim>
inline void gatherMotion(const WallFields<Dim>& fields, const Pairs<Dim>& pair, bool accelerations,
                         WallSide<Dim, Lanes>& wall) {
    if (fields.stands_still) {
        spread<Dim>(Vec<Dim>::Zero(), wall.v);
        return;
    }
    gatherVectors<Dim>(fields.velocity->data(), pair.index, wall.v);
    if (accelerations && fields.acceleration)
        gatherVectors<Dim>(fields.acceleration->data(), pair.index, wall.a);
}

/// Adds sum_j 2 (v_i - v*_ij) . e_ij W' V_j over the wall particles j near the fluid
/// particle i, in the given gradient unit.
template <int Dim>
inline void addWallClosure(const WallFields<Dim>& fields, const NeighborList<Dim>& list,
                           std::size_t i, const Vec<Dim>& velocity, double unit, ExactSum& sum) {
    const double units = list.gradient_unit / unit;
    Lanes v[Dim];
    spread<Dim>(velocity, v);
    forEachPair(list, i, [&](const Pairs<Dim>& pair) {
        WallSide<Dim, Lanes> wall;
        gatherMotion(fields, pair, false, wall);
        const Lanes V_j = gatherFaces(fields, pair, fields.along_line.density, wall.n);
        sum.addProduct(units * wallClosingRate<Dim, Lanes>(v, wall, pair), V_j);
    });
}

/// Adds sum_j 2 p*_ij e_ij W' V_i V_j over the wall particles j near one fluid particle i, in the
/// given gradient unit.
template <Riemann R, int Dim>
inline void addWallPressure(const WallFields<Dim>& fields, const NeighborList<Dim>& list,
                            std::size_t i, const RiemannConstants& constants,
                            const FluidSide<Dim, Lanes>& fluid, double V, double unit,
                            ExactSums<Dim>& sum) {
    V *= list.gradient_unit / unit;
    Distances<Dim> distances(list, i);
    forEachPair(list, i, [&](const Pairs<Dim>& pair) {
        WallSide<Dim, Lanes> wall;
        gatherMotion(fields, pair, true, wall);
        const Lanes V_j = gatherFaces(fields, pair, fields.along_line.pressure, wall.n);
        const Lanes p2 =
            twiceWallPressure<R, Dim, Lanes>(constants, fluid, wall, pair, distances.next());
        const Lanes f = p2 * (V * V_j);
        for (int c = 0; c < Dim; ++c) sum[c].addProduct(f, pair.gradient[c]);
    });
}

/// The same for one wall particle j over the fluid particles i near it, from the states that the
/// fluid has packed: adds sum_i 2 p*_ij e_ji W' V_i V_j in the list's gradient unit.
template <Riemann R, int Dim>
inline void addFluidPressure(const WallFields<Dim>& fields, const NeighborList<Dim>& list,
                             std::size_t j, const RiemannConstants& constants,
                             const PairState<Dim>* states, const Field<Vec<Dim>>& external,
                             const Field<double>& density, const Field<double>& slack, double pull,
                             ExactSums<Dim>& sum) {
    Distances<Dim> distances(list, j);
    const double V = (*fields.volume)[j];
    forEachPair(list, j, [&](const Pairs<Dim>& pair) {
        WallSide<Dim, Lanes> wall;
        spread<Dim>((*fields.velocity)[j], wall.v);
        if (fields.acceleration) spread<Dim>((*fields.acceleration)[j], wall.a);
        if (fields.along_line.pressure)
            for (int c = 0; c < Dim; ++c) wall.n[c] = pair.gradient[c] * pair.inverse_dW;
        else
            spread<Dim>((*fields.normal)[j], wall.n);
        FluidSide<Dim, Lanes> fluid;
        const PairLanes<Dim> state = gather(states, pair.index);
        for (int c = 0; c < Dim; ++c) fluid.v[c] = state.v[c];
        fluid.p = state.p;
        gatherVectors<Dim>(external.data(), pair.index, fluid.g);
        fluid.rho = gatherLanes(density.data(), pair.index);
        fluid.least_pull = lanes(pull);
        fluid.least = gatherLanes(slack.data(), pair.index) > 0 ? lanes(0) : fluid.least;
        const Lanes p2 = twiceWallPressure<R, Dim, Lanes>(constants, fluid, wall, pair.reversed(),
                                                          distances.next());
        const Lanes f = p2 * (V * state.V);
        for (int c = 0; c < Dim; ++c) sum[c].addProduct(f, pair.gradient[c]);
    });
}

/// Adds to the components of Z_j of one particle j of an elastic solid, 2 rho0 c0 sum_i abs(W')
/// e_ij (x) e_ij V_i V_j, over the fluid particles i near it, without the factor 2 rho0 c0 and in
/// the list's gradient unit: row by row, up to the diagonal. Of a rigid body of a mechanism the
/// part along its normals, n_j (n_j . e_ij) in place of e_ij.
template <int Dim>
inline void addImpedance(const WallFields<Dim>& fields, const NeighborList<Dim>& list,
                         std::size_t j, const Field<double>& volume,
                         ExactSums<Dim*(Dim + 1) / 2>& sum) {
    const double V = (*fields.volume)[j];
    Lanes n[Dim] = {};
    if (!fields.along_line.pressure) spread<Dim>((*fields.normal)[j], n);
    forEachPair(list, j, [&](const Pairs<Dim>& pair) {
        const Lanes f = (V * gatherLanes(volume.data(), pair.index)) * pair.inverse_dW;
        Lanes along[Dim];
        const Lanes part = dot<Dim>(n, pair.gradient);
        for (int c = 0; c < Dim; ++c)
            along[c] = fields.along_line.pressure ? pair.gradient[c] : part * n[c];
        for (int row = 0, k = 0; row < Dim; ++row)
            for (int column = 0; column <= row; ++column, ++k)
                sum[k].addProduct(f, along[row] * along[column]);
    });
}

/// Of a slip that is nothing.
constexpr double least_square = std::numeric_limits<double>::min();

/// Adds the impulse on one fluid particle i by which the slips s_j of an elastic solid are
/// answered, 2 rho0 c0 sum_j abs(W') e_ij (e_ij . s_j) V_i V_j: what the solid has lost by its
/// impedance. Without the factor 2 rho0 c0, in the given gradient unit. Slips of a rigid body are
/// along the normals that it had when it answered; by now they have turned.
template <int Dim>
inline void addSlipImpulse(const WallFields<Dim>& fields, const NeighborList<Dim>& list,
                           std::size_t i, double V, double unit, ExactSums<Dim>& sum) {
    V *= list.gradient_unit / unit;
    forEachPair(list, i, [&](const Pairs<Dim>& pair) {
        Lanes s[Dim];
        gatherVectors<Dim>(fields.slip->data(), pair.index, s);
        const Lanes weight = (V * gatherLanes(fields.volume->data(), pair.index)) * pair.inverse_dW;
        const Lanes across = dot<Dim>(s, pair.gradient);
        if (fields.along_line.pressure) {
            for (int c = 0; c < Dim; ++c) sum[c].addProduct(weight * across, pair.gradient[c]);
        } else {
            const Lanes square = larger<Lanes>(dot<Dim>(s, s), lanes(least_square));
            for (int c = 0; c < Dim; ++c)
                sum[c].addProduct(weight * (across * across) / square, s[c]);
        }
    });
}

}  // namespace sphinx::dynamics::fluid
