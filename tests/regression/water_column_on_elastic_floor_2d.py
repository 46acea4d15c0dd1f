# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Water at rest on an elastic floor: its deflection, and the energy of both, whatever the floor is made of.

The middle of a slab that can only be compressed sinks by p t (1 + nu)(1 - 2 nu)/(E (1 - nu)) under the pressure p.
"""

import itertools

import numpy as np

import checks

CASE = "water_column_on_elastic_floor_2d"
DEPTH, THICKNESS, POISSON = 1.0, 0.2, 0.3
PRESSURE = 1000 * 9.81 * DEPTH
LOADED = 0.4  # the floor has swung once or more; the means are over the rest
RISE_LIMIT = 0.005               # of the energy, of rho g H^2 L; over a rigid floor it is the same
LIMIT = {25: 0.15, 50: 0.08}     # of the deflection at that many particles over the depth
# Lightest and softest, lightest and stiff, as shipped, heavy.
SHORT = ((100, 1e5), (100, 1e8), (1000, 1e6), (10000, 1e6))


def exact(stiffness):
    return PRESSURE * THICKNESS * (1 + POISSON) * (1 - 2 * POISSON) / (stiffness * (1 - POISSON))


def measure(density, stiffness, rows=25, end=2.4):
    run = checks.Run(f"{CASE}/case.yaml", f"variables.floor_density={density}", f"variables.E={stiffness}",
                     f"variables.spacing=H/{rows}", f"loop.end_time={end}", "outputs.fields.every.time=10")
    water, floor, middle = (run.series(name) for name in ("water_energy", "floor_energy", "middle"))
    total = water["total"] + floor["total"]
    after = middle["time"] > LOADED
    return {"rise": (total.max() - total[0]) / (PRESSURE * DEPTH), "middle": middle,
            "deflection": -middle["displacement_y"][after].mean() / exact(stiffness) - 1,
            "swing": middle["displacement_y"][after].std() / exact(stiffness),
            "kinetic": floor["kinetic"][floor["time"] > LOADED].mean()}


def study():
    for density, stiffness in itertools.product((100, 300, 1000, 3000, 10000), (1e5, 1e6, 1e7, 1e8, 1e10)):
        found = measure(density, stiffness)
        print(f"| {density} | {stiffness:.0e} | {100 * found['rise']:.2f} | {100 * found['deflection']:+.1f} | "
              f"{100 * found['swing']:.1f} | {found['kinetic']:.1e} |", flush=True)
    for rows in (25, 50, 100):
        found = measure(1000, 1e7, rows, 1.2)
        print(f"H/{rows}: {100 * found['deflection']:+.1f} %, swings by {100 * found['swing']:.1f} %", flush=True)


def plot():
    figure, axes = checks.new_plot()
    for stiffness, label in ((1e6, "1 MPa"), (1e7, "10 MPa")):
        middle = measure(1000, stiffness)["middle"]
        axes.plot(middle["time"], middle["displacement_y"] / exact(stiffness), lw=0.6, label=label)
    axes.axhline(-1, color="k", lw=0.8, label="at rest")
    axes.set(xlabel="t [s]", ylabel="displacement of the middle, in that at rest")
    axes.legend()
    checks.save_plot(figure, CASE, "middle.png")


def main():
    options = checks.arguments(study=study, plot=plot)
    report = checks.Report()
    for density, stiffness in SHORT:
        found = measure(density, stiffness)
        report.check(f"rise of the energy / (rho g H^2 L): density {density}, E {stiffness:.0e}", found["rise"],
                     0, RISE_LIMIT)
    rows = 50 if options.long else 25
    found = measure(1000, 1e7, rows, 1.2)
    report.check(f"deflection at H/{rows} less that at rest, of it", found["deflection"], -LIMIT[rows], LIMIT[rows])
    report.end()


if __name__ == "__main__":
    main()
