# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Elastic layer under Couette flow: at rest, the shear stress mu U/H of the flow is that of the layer.

The layer leans by u = (tau/G)(y + its thickness), so its surface by tau H/G.
"""

import numpy as np

import checks

CASE = "shear_driven_elastic_layer_2d"
LAYER, LENGTH, SHEAR, STRESS = 0.5, 2.0, 0.01, 0.5
SETTLED = 4.0
# Measured at gap/20: force -0.2 %, shear +0.7 %, surface +1.7 % (README.md).
LIMITS = {"force": 0.02, "shear": 0.02, "surface": 0.03}


def measure(rows):
    """Means over the time from SETTLED on: the force on the layer, its shear well between its ends and
    where the line through these displacements meets the surface; all less the closed form, of it."""
    run = checks.Run(f"{CASE}/case.yaml", f"variables.spacing=gap/{rows}")
    series = run.series("force")
    late = series["time"] > SETTLED
    force = series["viscous_force_x"][late].mean() / (STRESS * (LENGTH - 12 / rows))
    lines, profile = [], None
    for time, fields in run.frames("layer"):
        if time < SETTLED:
            continue
        place, u = fields["initial_position"], fields["displacement"][:, 0]
        middle = (np.abs(place[:, 0] - LENGTH / 2) < 0.3) & (place[:, 1] > -LAYER)
        lines.append(np.polyfit(place[middle, 1], u[middle], 1))
        rows_at = np.unique(place[middle, 1].round(6))
        profile = rows_at, [u[middle & (np.abs(place[:, 1] - y) < 1e-5)].mean() for y in rows_at]
    slope, surface = np.mean(lines, axis=0)
    for _, flow in run.frames("oil"):
        pass
    return {"force": force - 1, "shear": slope / SHEAR - 1, "surface": surface / (SHEAR * LAYER) - 1,
            "profile": profile, "flow": flow}


def study():
    for rows in (10, 20, 40):
        found = measure(rows)
        print(f"| {rows // 2} |", " | ".join(f"{100 * found[what]:+.1f}" for what in LIMITS), "|", flush=True)


def plot():
    found = measure(20)
    figure, axes = checks.new_plot()
    y, u = found["profile"]
    axes.plot([0, 1], [0, 1], "k-", lw=0.8, label="closed form")
    axes.plot([0, SHEAR * LAYER * 100], [-LAYER, 0], "k-", lw=0.8)
    axes.plot(found["flow"]["velocity"][:, 0], found["flow"]["position"][:, 1], ".", ms=3,
              label="velocity of the oil")
    axes.plot(100 * np.array(u), y, ".", ms=3, label="100 x displacement of the layer")
    axes.set(xlabel="along the lid", ylabel="y")
    axes.legend()
    checks.save_plot(figure, CASE, "profiles.png")


def main():
    checks.arguments(study=study, plot=plot)
    found = measure(20)
    report = checks.Report()
    for what, limit in LIMITS.items():
        report.check(f"{what} less that of theory, of it", found[what], -limit, limit)
    report.end()


main()
