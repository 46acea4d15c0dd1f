# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""An elastic box floats at rest, cases/floating_box.yaml (and _3d), from the light and stiff to the heavy and soft.

What it and the water may not do is gain energy from their coupling: engine/dynamics/fsi/README.md.
"""

import itertools

import numpy as np

import checks

CASES = {dim: checks.REPOSITORY / "tests/regression/cases" / name
         for dim, name in ((2, "floating_box.yaml"), (3, "floating_box_3d.yaml"))}
GRAVITY = 9.81
WEIGHT = {2: 500 * 0.4**2 * GRAVITY, 3: 500 * 0.3**3 * GRAVITY}
ALL_ENERGY = {2: 1000 * GRAVITY * 1**2 * 2, 3: 1000 * GRAVITY * 0.6**2 * 0.9**2}  # rho g H^2 L (B) of the water
RISE_LIMIT = 1e-4    # of that energy; measured 4e-5
KINETIC_LIMIT = 1.0  # of the box, J: 800 kg/m at 5 cm/s, 16 kg/m at 35 cm/s
# Lightest and softest, lightest and stiff, the middle, heaviest and softest.
SHORT = ((100, 1e5), (100, 1e7), (500, 1e7), (10000, 1e5))


def measure(density, stiffness, end=0.3, dim=2):
    run = checks.Run(CASES[dim], f"variables.density={density}", f"variables.E={stiffness}", f"loop.end_time={end}")
    water, box = run.series("water_energy"), run.series("box_energy")
    total = water["total"] + box["total"]
    momentum = run.series("box_momentum")
    force = np.diff(momentum["momentum_" + "xyz"[dim - 1]]) / np.diff(momentum["time"])
    late = momentum["time"][1:] > end / 3
    return {"rise": (total.max() - total[0]) / ALL_ENERGY[dim], "kinetic": box["kinetic"].max(),
            "force": np.sqrt(np.mean(force[late]**2)) / WEIGHT[dim]}


def study():
    for density, stiffness in itertools.product((100, 300, 500, 1000, 3000, 10000), (1e5, 1e6, 1e7, 1e8, 1e10)):
        found = measure(density, stiffness)
        print(f"| {density} | {stiffness:.0e} | {found['rise']:.1e} | {found['kinetic']:.2g} | "
              f"{found['force']:.3f} |", flush=True)


def main():
    options = checks.arguments(study=study)
    report = checks.Report()
    points = [(2, *point) for point in SHORT] + ([(3, *point) for point in SHORT] if options.long else [])
    for dim, density, stiffness in points:
        found = measure(density, stiffness, dim=dim)
        what = f"{dim}D, density {density}, E {stiffness:.0e}"
        report.check(f"rise of the energy / (rho g H^2 L): {what}", found["rise"], 0, RISE_LIMIT)
        report.check(f"kinetic energy of the box [J]: {what}", found["kinetic"], 0, KINETIC_LIMIT)
    report.end()


if __name__ == "__main__":
    main()
