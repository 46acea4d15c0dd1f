# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Added mass: a circle in a concentric circular tank full of water without viscosity is pushed from rest by a steady force F.
Potential flow: F/(m + rho pi R^2 (b^2 + R^2)/(b^2 - R^2)), R and b the radii (Lamb 1932, art. 68-71).

The force comes at once and the fluid rings; the mean acceleration over the first 0.2 R, 2 x/t^2, hardly knows of it. It is too low
by the steps of the lattice around the circle, first order in the spacing, and with particles on rings by less than half of that:
engine/dynamics/fsi/README.md. --study prints its table.
"""

import numpy as np

import checks

CASE = checks.REPOSITORY / "tests/regression/cases/pushed_circle.yaml"
ACCELERATION, WAY = 0.1, 0.2
LIMITS = {10: 0.09, 20: 0.05, 40: 0.035}


def error(across):
    """Mean acceleration over that of theory, less 1."""
    circle = checks.Run(CASE, f"variables.spacing=radius/{across}").series("circle")
    t = np.interp(WAY, circle["center_x"], circle["time"])
    return 2 * WAY / t**2 / ACCELERATION - 1


def study():
    for across in LIMITS:
        print(f"| R/{across} | {100 * error(across):+.1f} % |", flush=True)


def main():
    options = checks.arguments(study=study)
    report = checks.Report()
    for across in LIMITS if options.long else (10, 20):
        report.check(f"mean acceleration at R/{across} less that of theory, of it", error(across), -LIMITS[across],
                     LIMITS[across])
    report.end()


if __name__ == "__main__":
    main()
