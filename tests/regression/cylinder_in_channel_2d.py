# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""A cylinder in a periodic channel: its drag in creeping flow, and neither voids nor noise.

Ellero & Adams 2011, doi:10.1002/nme.3088: F/(mu U) = 106.77 in a channel of 6 by 4 radii, U the mean over a
cross-section, F the drag by the stresses under a uniform force. (A solution on staggered grids of 10, 20 and 30 cells
a radius with a cylinder of whole cells has 90.6, 96.9 and 100.1, and goes towards 106.4.) The Reynolds number is 0.5
here. Means over 3 < t < 6.
"""

import numpy as np

import checks

EXACT = 106.77
VISCOSITY = 4.0
DRAG_LIMIT = 0.03
NOISE_LIMIT = 0.005  # standard deviation, of the mean


def measure(per_radius, *settings):
    run = checks.Run("cylinder_in_channel_2d/case.yaml", f"variables.spacing=1/{per_radius}", *settings)
    drag = run.series("drag")
    late = drag["time"] > 3
    force = drag["force_x"][late]
    return {"drag": force.mean() / VISCOSITY, "noise": force.std() / force.mean(),
            "lift": drag["force_y"][late].std() / force.mean()}


def study():
    for per_radius in (6, 12, 24):
        for arrangement in ("lattice", "relaxed"):
            found = measure(per_radius, f"bodies.fluid.arrangement={arrangement}", f"bodies.cylinder.arrangement={arrangement}")
            print(f"| {per_radius} | {arrangement} | {found['drag']:.1f} | {100 * (found['drag'] / EXACT - 1):+.1f} | "
                  f"{100 * found['noise']:.2f} | {100 * found['lift']:.2f} |", flush=True)


def main():
    checks.arguments(study=study)
    found = measure(12)
    report = checks.Report()
    report.check("drag less that of the reference, of it", found["drag"] / EXACT - 1, -DRAG_LIMIT, DRAG_LIMIT)
    report.check("noise of the drag, of its mean", found["noise"], 0, NOISE_LIMIT)
    report.check("noise of the lift, of the drag", found["lift"], 0, NOISE_LIMIT)
    report.end()


if __name__ == "__main__":
    main()
