# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Bending column: how far and when its tip swings out, and when it is back.

References are finite elements of second order (18 x 3 x 3, total Lagrangian) of the same law.
"""

import numpy as np

import beam
import checks

# Largest transverse displacement, its time, axial displacement then.
REFERENCE = (2.974, 0.457, -0.892)

# Errors at 4 and 8 particles across: README.md.
LIMITS = {4: (0.10, 0.08, 0.21), 8: (0.036, 0.02, 0.07)}
# Of all energy; measured 2.5e-5 and 7e-6.
ENERGY_LIMIT = 1e-4


def measure(across, end=1.0):
    run = checks.Run("bending_column_3d/case.yaml", f"variables.spacing=width/{across}",
                     "outputs.fields.every={time: 10}", f"loop.end_time={end}")
    t, u = beam.tip(run, components="xyz")
    out = u @ np.array([0, np.sqrt(3) / 2, 0.5])
    times, values = beam.extremes(t, out)
    energy = run.series("energy")["total"]
    return {"t": t, "u": u, "out": values[0], "time": times[0], "back": np.interp(times[0], t, u[:, 0]),
             "energy": abs(energy / energy[0] - 1).max()}


def plot():
    figure, axes = checks.new_plot(8, 4)
    reference = checks.reference("bending_column_3d", "tip.csv")
    found = measure(8, 0.6)
    for k, c in enumerate("xyz"):
        [drawn] = axes.plot(reference["t"], reference[f"u{c}_ctr"], "--", label=f"finite elements, {c}")
        axes.plot(found["t"], found["u"][:, k], "-", color=drawn.get_color(), label=f"1/8 m, {c}")
    axes.set(xlabel="t [s]", ylabel="displacement of the tip [m]", xlim=(0, 0.6), title="Bending column")
    axes.legend(fontsize="small", ncols=3)
    checks.save_plot(figure, "bending_column_3d", "tip.png")


def main():
    options = checks.arguments()
    if options.plot:
        plot()
        return
    if options.study:
        rows = {}
        for across in (4, 8, 12):
            found = measure(across, 0.6)
            rows[across] = found["out"], found["time"], found["back"]
        beam.study(rows, REFERENCE)
        return
    across = 8 if options.long else 4
    found = measure(across, 0.6)
    report = checks.Report()
    names = "largest transverse displacement", "its time", "axial displacement then"
    for what, key, value, limit in zip(names, ("out", "time", "back"), REFERENCE, LIMITS[across]):
        report.check(f"{what}, less reference, of it", found[key] / value - 1, -limit, limit)
    report.check("largest change of the energy, of it", found["energy"], 0, ENERGY_LIMIT)
    report.end()


main()
