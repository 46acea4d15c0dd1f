# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""The level of water at rest, cases/still_water.yaml, stays.

What raises it is whatever takes one side of the noise of the particles for true: see
engine/dynamics/fluid/density_summation.cpp.
"""

import numpy as np

import checks

CASE = checks.REPOSITORY / "tests/regression/cases/still_water.yaml"
DEPTH, GRAVITY, DENSITY = 0.5, 9.81, 1000.0
LEVEL_LIMIT = 0.1    # of a spacing, mean over the last tenth of the time
NOISE_LIMIT = 4e-4   # kinetic energy / (rho g H^2 L); Wendland C2 as in hydrostatic_tank_2d has 2e-4


def measure(spacing, *settings):
    run = checks.Run(CASE, f"variables.spacing={spacing}", *settings)
    gauge, energy = run.series("elevation"), run.series("energy")
    level = np.mean([gauge[name] for name in gauge if name.startswith("elevation_")], axis=0)

    def last_tenth(series, values):
        return values[series["time"] > 0.9 * series["time"][-1]].mean()

    return {
        "rise": (last_tenth(gauge, level) - DEPTH) / spacing,
        "kinetic": last_tenth(energy, energy["kinetic"]) / (DENSITY * GRAVITY * DEPTH**2),
    }


def study():
    for spacing in (0.05, 0.025, 0.0125):
        found = measure(spacing)
        print(f"| {DEPTH / spacing:.0f} | {found['rise']:+.3f} | {found['kinetic']:.1e} |", flush=True)


def main():
    checks.arguments(study=study)
    report = checks.Report()
    found = measure(0.02)
    report.check("rise of the level in spacings", found["rise"], -LEVEL_LIMIT, LEVEL_LIMIT)
    report.check("kinetic energy / (rho g H^2 L)", found["kinetic"], 0, NOISE_LIMIT)
    forced = measure(0.02, "dynamics.gravity.type=force.body_force")
    report.check("rise under a body force less that under gravity", forced["rise"] - found["rise"], 0, 0)
    # The pressure bounds the advection step, whatever speed the case expects: free_surface.md.
    found = measure(0.02, "dynamics.advection_dt.reference_speed=0.1*free_fall")
    report.check("low reference speed: rise of the level in spacings", found["rise"], -LEVEL_LIMIT, LEVEL_LIMIT)
    report.check("low reference speed: kinetic energy / (rho g H^2 L)", found["kinetic"], 0, NOISE_LIMIT)
    report.end()


if __name__ == "__main__":
    main()
