// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/types/values.h"

namespace sphinx::dynamics::fluid {

enum class Surface { free, confined };
inline auto surfaceWords() {
    return input::choice<Surface>({
        {"free", Surface::free, "flow with a free surface"},
        {"confined", Surface::confined, "flow without free surface"},
    });
}

/// Re-initialisation of the density by summation. S_i = W(0) + sum_j W_ij over the fluid and the
/// solids it sees; a neighbor of another spacing counts with V_j0/V_i0. S0 is the sum over the full
/// lattice of the body.
///   confined: rho_i = rho_i(start) S_i/S0, guide (55), so that an initial pressure is kept
///   free:     with the sum rho_S = m_i/V0 S_i/S0, V0 the volume of a cell of the lattice,
///             drho_i/dt = (rho_S - rho_i)/tau inside, by its solution over the step of its layer,
///             elsewhere upwards only, guide (54): at least min(rho_S, rho0) at once, where no
///             pressure follows, above rho0 with the same tau
/// Inside is where no neighbor lacks support: no surface cuts off a part of the sum. A particle has
/// support if S_i is nearer to S0 than that of the outermost row of a flat surface.
///
/// Guide (54) everywhere takes the upper side of the noise of the sum for true. Nothing takes it
/// back, most of all where a gap opens at a wall, and water at rest swells by 0.3 spacings in
/// 10 sqrt(H/g). The whole difference at once is no better: the Riemann problems take the noise out
/// of the density and the sum puts it back in each step; that feeds motion, and the kinetic energy
/// of water at rest is five times that with tau. And where a splash falls together, or water runs
/// along an edge of its tank, max(rho, rho_S) is a pressure from nothing, which does work.
///
/// tau = 250 dp/c0, dp the spacing. The Riemann problems spread density with D = c0 <r>
/// (Dim+1)/2Dim, <r> the mean distance under the kernel: D = 0.65 c0 dp in 2D, 0.73 in 3D. Up to
/// sqrt(D tau), 13 spacings, the density is theirs, and of the noise of the sum 1/440 gets into it.
/// Above it is the sum's, since they have nothing to hold a level by. How wide the range of tau is,
/// and what bounds it: free_surface.md.
///
/// Tension: without support, and at solids, a fluid with a free surface is slack (fields::slack):
/// its density may sink below rho0, but no pressure and no volume follow (PressureRelaxation). What
/// is missing is the width of a gap, which has to close again before there is pressure: a gap that
/// was forgotten would be pumped wider by any noise. It is forgotten where it has become a surface:
/// without support and away from solids, and where tension begins again, rho_i is rho0 at least. A
/// particle without any neighbor has no pressure.
struct DensitySummationParameters {
    input::Name body;
    Surface surface = Surface::free;
};

}  // namespace sphinx::dynamics::fluid
