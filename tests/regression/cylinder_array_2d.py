# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Creeping flow through a square array of cylinders: the force on each, and that the particles leave no voids.

F/(mu U) = 30.30 at R/L = 0.2, U the flow rate by the side of the cell: series of Sangani & Acrivos 1982,
doi:10.1016/0301-9322(82)90029-5. F is that of the mean pressure gradient G on a cell, G L^2; of it the drag of the
stresses is what acts on the fluid, G (L^2 - pi R^2), as a uniform force makes no pressure gradient in the
cylinder. Means over 0.1 < t < 0.2, in which the fluid moves half a radius.
"""

import numpy as np

import checks
from voids import grid, largest_hole

EXACT = 30.30
VISCOSITY = 4.0
CYLINDER = np.pi * 0.2**2
FORCE_LIMIT = 0.03
BALANCE_LIMIT = 2e-3
NOISE_LIMIT = 0.02  # standard deviation, of the mean
MEAN_LIMIT = 2e-3
VOID_LIMIT = 1.2  # spacings; the hole in a square of a lattice has 0.71


def measure(cells):
    run = checks.Run("cylinder_array_2d/case.yaml", f"variables.spacing={1 / cells!r}")
    drag, drive, momentum = run.series("drag"), run.series("drive"), run.series("momentum")
    late = drag["time"] > 0.1
    force, given = drag["force_x"][late], drive["applied_x"][late].mean()
    *_, (_, fields) = run.frames("fluid")
    points = grid(200)
    points = points[np.hypot(*(points - 0.5).T) > 0.2 + 0.5 / cells]
    return {"force": given / (1 - CYLINDER) / VISCOSITY, "balance": force.mean() / given - 1,
            "noise": force.std() / force.mean(), "flow": momentum["momentum_x"][-1] - 1,
            "hole": largest_hole(points, fields["position"]) * cells}


def study():
    for cells in (25, 50, 100):
        found = measure(cells)
        print(f"| {cells // 5} | {found['force']:.2f} | {100 * (found['force'] / EXACT - 1):+.1f} | "
              f"{100 * found['noise']:.2f} | {found['hole']:.2f} |", flush=True)


def main():
    checks.arguments(study=study)
    found = measure(50)
    report = checks.Report()
    report.check("force less that of the series, of it", found["force"] / EXACT - 1, -FORCE_LIMIT, FORCE_LIMIT)
    report.check("drag less the force that drives, of it", found["balance"], -BALANCE_LIMIT, BALANCE_LIMIT)
    report.check("noise of the drag, of its mean", found["noise"], 0, NOISE_LIMIT)
    report.check("flow rate less the wanted, of it", found["flow"], -MEAN_LIMIT, MEAN_LIMIT)
    report.check("largest hole in spacings", found["hole"], 0, VOID_LIMIT)
    report.end()


if __name__ == "__main__":
    main()
