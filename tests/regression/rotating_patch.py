# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""The midst of a fluid with a free surface bears tension: a rotating square, cases/rotating_patch.yaml.

The incompressible flow has p = -0.14734 rho omega^2 L^2 at the centre at the start: the series for
the Poisson equation with the right side 2 rho omega^2 and p = 0 on the sides. Sound goes to and fro
in the square, so the mean is taken over a period of its lowest mode, sqrt(2) L/c.
"""

import numpy as np

import checks

CASE = checks.REPOSITORY / "tests/regression/cases/rotating_patch.yaml"
EXACT = -0.14734
PRESSURE_LIMIT = 0.1
LOSS_LIMIT = 0.01  # of the kinetic energy, 1/12
MOMENTUM_LIMIT = 1e-12


def measure(spacing):
    run = checks.Run(CASE, f"variables.spacing={spacing}")
    centre, energy, momentum = (run.series(name) for name in ("centre", "energy", "momentum"))
    t, p = centre["time"], centre["average_pressure"]
    moved = t > 0
    return {
        "pressure": np.trapezoid(p[moved], t[moved]) / (t[moved][-1] - t[moved][0]),
        "loss": 1 - energy["kinetic"][-1] / energy["kinetic"][0],
        "momentum": max(np.abs(momentum[f"momentum_{axis}"]).max() for axis in "xy"),
    }


def study():
    for spacing in (1 / 20, 1 / 40, 1 / 80):
        found = measure(spacing)
        print(f"| 1/{1 / spacing:.0f} | {found['pressure']:.4f} | {found['loss']:.1e} |", flush=True)


def main():
    checks.arguments(study=study)
    found = measure(1 / 40)
    report = checks.Report()
    report.check("mean pressure at the centre less the solution, of it", found["pressure"] / EXACT - 1,
                 -PRESSURE_LIMIT, PRESSURE_LIMIT)
    report.check("loss of kinetic energy", found["loss"], -LOSS_LIMIT, LOSS_LIMIT)
    report.check("momentum", found["momentum"], 0, MOMENTUM_LIMIT)
    report.end()


if __name__ == "__main__":
    main()
