// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The pressure between a fluid particle and a dummy particle of a wall, eight pairs at a time: of
// one fluid particle with eight of a wall, or of one wall particle with eight of the fluid. Both
// get the same numbers, so what one loses the other gains.

#include "core/exact_sum.h"
#include "dynamics/fluid/pair_state.h"
#include "dynamics/fluid/riemann.h"
#include "dynamics/fluid/wall_fields.h"
#include "dynamics/pair_loop.h"

namespace sphinx::fluid {

/// The fluid's side of eight pairs.
template <int Dim>
struct FluidLanes {
    Lanes v[Dim];
    Lanes g[Dim];  ///< acceleration by other forces than pressure
    Lanes p;
    Lanes rho;
};

/// The wall's side of eight pairs.
template <int Dim>
struct WallLanes {
    Lanes v[Dim];
    Lanes a[Dim] = {};
    Lanes n[Dim];
};

template <int Dim>
inline void spread(const Vec<Dim>& value, Lanes (&out)[Dim]) {
    for (int c = 0; c < Dim; ++c) out[c] = lanes(value[c]);
}
/// Turns the normals from the wall to the fluid and returns -(v_i - v_w) . n: closing in.
/// `gradient` = e_ij W' = -abs(W') e_ij of the fluid particle, so that e_ij points to the fluid.
template <int Dim>
inline Lanes closingSpeed(const Lanes (&v)[Dim], WallLanes<Dim>& wall,
                          const Lanes (&gradient)[Dim]) {
    const Lanes sign = dotLanes<Dim>(wall.n, gradient) > 0.0 ? lanes(-1) : lanes(1);
    Lanes closing[Dim];
    for (int c = 0; c < Dim; ++c) {
        wall.n[c] *= sign;
        closing[c] = wall.v[c] - v[c];
    }
    return dotLanes<Dim>(closing, wall.n);
}

/// Twice the pressure p* of the one-sided Riemann problem: p_i, the pressure of the ghost
/// p_i + rho_i r_ij max(0, -(g_i - a_w) . e_ij), and what closing in at twice the speed adds, since
/// the ghost moves with the mirrored normal velocity.
template <Riemann R, int Dim>
inline Lanes twiceWallPressure(const RiemannConstants& constants, const FluidLanes<Dim>& fluid,
                               WallLanes<Dim>& wall, const Lanes (&gradient)[Dim], Lanes inverse_dW,
                               Lanes r) {
    Lanes g[Dim];
    for (int c = 0; c < Dim; ++c) g[c] = fluid.g[c] - wall.a[c];
    const Lanes pull = dotLanes<Dim>(g, gradient);  // (g_i - a_w) . (-e_ij) abs(W')
    const Lanes ghost = fluid.rho * r * maxLanes(pull * inverse_dW, Lanes{});
    const Lanes closing = closingSpeed<Dim>(fluid.v, wall, gradient);
    return 2.0 * fluid.p + ghost + pressureJump<R>(constants, 2.0 * closing);
}

template <int Dim>
inline FluidLanes<Dim> oneFluid(const Vec<Dim>& v, const Vec<Dim>& g, double p, double rho) {
    FluidLanes<Dim> fluid;
    spread<Dim>(v, fluid.v);
    spread<Dim>(g, fluid.g);
    fluid.p = lanes(p);
    fluid.rho = lanes(rho);
    return fluid;
}

/// Adds -2 n . e_ij W' V_j times the speed of closing in, over the wall particles j near the fluid
/// particle i, in the given gradient unit.
template <int Dim>
inline void addWallClosure(const WallFields<Dim>& fields, const NeighborList<Dim>& list,
                           std::size_t i, const Vec<Dim>& velocity, double unit, ExactSum& sum) {
    const double factor = -2 * list.gradient_unit / unit;
    Lanes v[Dim];
    spread<Dim>(velocity, v);
    forEachPair(list, i, [&](const Pairs<Dim>& pair) {
        WallLanes<Dim> wall;
        gatherVectors<Dim>(fields.velocity->data(), pair.index, wall.v);
        gatherVectors<Dim>(fields.normal->data(), pair.index, wall.n);
        const Lanes closing = closingSpeed<Dim>(v, wall, pair.gradient);
        sum.addProduct(factor * closing * dotLanes<Dim>(wall.n, pair.gradient),
                       gatherLanes(fields.volume->data(), pair.index));
    });
}

/// Adds sum_j 2 p*_ij e_ij W' V_i V_j over the wall particles j near one fluid particle i, in the
/// given gradient unit.
template <Riemann R, int Dim>
inline void addWallPressure(const WallFields<Dim>& fields, const NeighborList<Dim>& list,
                            std::size_t i, const RiemannConstants& constants,
                            const FluidLanes<Dim>& fluid, double V, double unit,
                            ExactSums<Dim>& sum) {
    V *= list.gradient_unit / unit;
    Distances<Dim> distances(list, i);
    forEachPair(list, i, [&](const Pairs<Dim>& pair) {
        WallLanes<Dim> wall;
        gatherVectors<Dim>(fields.velocity->data(), pair.index, wall.v);
        if (fields.acceleration)
            gatherVectors<Dim>(fields.acceleration->data(), pair.index, wall.a);
        gatherVectors<Dim>(fields.normal->data(), pair.index, wall.n);
        const Lanes p2 = twiceWallPressure<R, Dim>(constants, fluid, wall, pair.gradient,
                                                   pair.inverse_dW, distances.next());
        const Lanes f = p2 * (V * gatherLanes(fields.volume->data(), pair.index));
        for (int c = 0; c < Dim; ++c) sum[c].addProduct(f, pair.gradient[c]);
    });
}

/// The same for one wall particle j over the fluid particles i near it, from the states that the
/// fluid has packed: adds sum_i 2 p*_ij e_ji W' V_i V_j in the list's gradient unit.
template <Riemann R, int Dim>
inline void addFluidPressure(const WallFields<Dim>& fields, const NeighborList<Dim>& list,
                             std::size_t j, const RiemannConstants& constants,
                             const PairState<Dim>* states, const Field<Vec<Dim>>& external,
                             const Field<double>& density, ExactSums<Dim>& sum) {
    Distances<Dim> distances(list, j);
    const double V = (*fields.volume)[j];
    forEachPair(list, j, [&](const Pairs<Dim>& pair) {
        WallLanes<Dim> wall;
        spread<Dim>((*fields.velocity)[j], wall.v);
        if (fields.acceleration) spread<Dim>((*fields.acceleration)[j], wall.a);
        spread<Dim>((*fields.normal)[j], wall.n);
        FluidLanes<Dim> fluid;
        const PairLanes<Dim> state = gather(states, pair.index);
        for (int c = 0; c < Dim; ++c) fluid.v[c] = state.v[c];
        fluid.p = state.p;
        gatherVectors<Dim>(external.data(), pair.index, fluid.g);
        fluid.rho = gatherLanes(density.data(), pair.index);
        Lanes gradient[Dim];
        for (int c = 0; c < Dim; ++c) gradient[c] = -pair.gradient[c];
        const Lanes p2 = twiceWallPressure<R, Dim>(constants, fluid, wall, gradient,
                                                   pair.inverse_dW, distances.next());
        const Lanes f = p2 * (V * state.V);
        for (int c = 0; c < Dim; ++c) sum[c].addProduct(f, pair.gradient[c]);
    });
}

}  // namespace sphinx::fluid
