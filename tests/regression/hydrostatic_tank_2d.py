# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Water at rest: hydrostatic pressure, hardly any motion, the weight on the bottom, the forces on the sides.

The compressed fluid has p = c^2 (exp(g d/c^2) - 1) at the depth d below its surface. The surface is
where the particles say: their lattice starts from a full square, so it lies at y = 1.
"""

import numpy as np

import checks

LENGTH, SOUND_SPEED2 = 2.0, 100 * 2.0  # c^2 = 100 * 2 g H

# Of rho g H, of rho g H^2 L and of the weight. Measured at H/12.5, H/25 and H/50: README.md.
# The impulse of the tank on the water less what its momentum tells, of the weight times the time:
# over the whole run, and root of the mean square over a tenth of a unit of time.
PROFILE_LIMIT = 0.015
LARGEST_ENERGY_LIMIT = 1e-4
LAST_ENERGY_LIMIT = 7e-5
WEIGHT_LIMIT = 0.0015
IMPULSE_LIMIT = 1e-5
ROW_LIMIT = 2e-5
# Of rho g H^2/2, on a side of the tank; and of the weight, what bottom and sides lack of the whole.
SIDE_LIMIT = 0.015
PARTS_LIMIT = 1e-12


def exact(y):
    return SOUND_SPEED2 * (np.exp((1 - y) / SOUND_SPEED2) - 1)


def measure(spacing, *settings):
    """Gauge heights, mean pressures there, and the figures of the test."""
    run = checks.Run("hydrostatic_tank_2d/case.yaml", f"variables.spacing={spacing!r}", *settings)
    pressure = run.series("pressure")
    last = pressure["time"] > 9
    names = [name for name in pressure if name.startswith("pressure_")]
    y = np.linspace(spacing, 1 - 2 * spacing, len(names))
    p = np.array([pressure[name][last].mean() for name in names])
    energy = run.series("energy")
    force = run.series("force")
    weight = run.series("mass")["mass"][0]  # g = 1
    parts = {name: run.series(name) for name in ("left", "right", "bottom")}
    on_side = [abs(parts[name]["force_x"][force["time"] > 9].mean()) for name in ("left", "right")]
    rest = [force[along] - sum(part[along] for part in parts.values()) for along in ("force_x", "force_y")]
    duration = np.diff(force["time"])
    unexplained = (np.diff(run.series("momentum")["momentum_y"]) +
                   duration * (force["force_y"][1:] + weight)) / weight
    return {
        "y": y,
        "p": p,
        "profile": np.sqrt(np.mean((p - exact(y)) ** 2)),
        "energy at the end": energy["kinetic"][-1] / LENGTH,
        "largest energy": energy["kinetic"].max() / LENGTH,
        "weight": -force["force_y"][force["time"] > 9].mean() / weight - 1,
        "sides": 2 * np.array(on_side) - 1,
        "parts": np.abs(rest).max() / weight,
        "impulse": unexplained.sum() / duration.sum(),
        "rows": np.sqrt(np.mean((unexplained / duration) ** 2)),
    }


def study():
    for spacing, *settings in ((0.1,), (0.05,), (0.04,), (0.025,),
                               (0.04, "outputs.force.layer=advection")):
        found = measure(spacing, *settings)
        print(f"| 1/{1 / spacing:g} | {100 * found['profile']:.2f} | "
              f"{found['energy at the end']:.1e} | {found['largest energy']:.1e} | "
              f"{100 * found['weight']:+.2f} | {100 * found['sides'].mean():+.2f} | {found['impulse']:+.1e} | {found['rows']:.1e} |")


def plot():
    found = measure(0.04)
    figure, axes = checks.new_plot(5.5, 4.5)
    axes.plot(exact(found["y"]), found["y"], "k-", label="closed form")
    axes.plot(found["p"], found["y"], "o", label="gauge, mean over 9 < t < 10")
    axes.set(xlabel="pressure / (rho g H)", ylabel="y / H", title="Hydrostatic tank, spacing H/25")
    axes.legend()
    checks.save_plot(figure, "hydrostatic_tank_2d", "pressure.png")


def main():
    checks.arguments(study=study, plot=plot)
    found = measure(0.04)
    report = checks.Report()
    report.check("rms error of the pressure / (rho g H)", found["profile"], 0, PROFILE_LIMIT)
    report.check("kinetic energy / (rho g H^2 L) at the end", found["energy at the end"], 0,
                 LAST_ENERGY_LIMIT)
    report.check("the same, largest over time", found["largest energy"], 0, LARGEST_ENERGY_LIMIT)
    report.check("force on the tank less the weight, of the weight", found["weight"],
                 -WEIGHT_LIMIT, WEIGHT_LIMIT)
    for side, found_there in zip(("left", "right"), found["sides"]):
        report.check(f"force on the {side} side less rho g H^2/2, of that", found_there, -SIDE_LIMIT, SIDE_LIMIT)
    report.check("force on the tank less those on its parts, of the weight", found["parts"], 0, PARTS_LIMIT)
    report.check("impulse of the tank less what the water tells, of the weight's", found["impulse"],
                 -IMPULSE_LIMIT, IMPULSE_LIMIT)
    report.check("the same, root of the mean square over tenths of time", found["rows"], 0, ROW_LIMIT)
    report.end()


main()
