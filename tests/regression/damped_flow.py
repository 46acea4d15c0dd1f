# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Damping of a uniform flow, cases/damped_flow.yaml: v = v0 exp(-int rate dt).

The rate 2 (1 + sin 3 t) is taken in the middle of each step, which misses its integral by
rate'' dt^2/24 t, some 1e-5; a steady rate is exact, also one of a thousand per step.
"""

import numpy as np

import checks

CASE = checks.REPOSITORY / "tests/regression/cases/damped_flow.yaml"
VELOCITY = (1.2, -0.7)
# Of the velocity at the start.
LIMIT = 1e-4
ROUND_OFF = 1e-13


def main():
    report = checks.Report()
    run = checks.Run(CASE)
    momentum, energy = run.series("momentum"), run.series("energy")["kinetic"]
    t = momentum["time"]
    left = np.exp(-2 * (t + (1 - np.cos(3 * t)) / 3))
    for axis, start in zip("xy", VELOCITY):
        off = momentum[f"momentum_{axis}"] / start - left
        report.check(f"velocity along {axis} less that of the closed form", np.abs(off).max(), 0, LIMIT)
    report.check("largest gain of kinetic energy in a step, of that at the start",
                 np.diff(energy).max() / energy[0], -1, 0)

    steady = checks.Run(CASE, "variables.rate=3").series("momentum")
    off = steady["momentum_x"] / VELOCITY[0] - np.exp(-3 * steady["time"])
    report.check("the same at a steady rate", np.abs(off).max(), 0, ROUND_OFF)

    stiff = checks.Run(CASE, "variables.rate=1e5", "loop.end_time=0.02").series("momentum")
    report.check("velocity left at a rate of 1000 per step", abs(stiff["momentum_x"][-1]), 0, ROUND_OFF)
    report.end()


if __name__ == "__main__":
    main()
