# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Elastic disc pressed slowly between two rigid plates, against finite elements: reference/finite_elements.csv.
With --study the table of the README, with --plot its plot."""

import numpy as np

import checks

CASE = "disc_between_plates_2d"


def measure(rows, approach):
    run = checks.Run(f"{CASE}/case.yaml", f"variables.spacing=radius/{rows}", f"variables.approach={approach}",
                     "outputs.frames.every={time: 10}")
    lower, upper = run.series("lower"), run.series("upper")
    late = lower["time"] > 0.18
    force = [column["contact_force_y"][late].mean() for column in (lower, upper)]
    return {"force": 0.5 * (force[1] - force[0]), "balance": np.abs(force[0] + force[1]) / force[1],
            "noise": np.ptp(lower["contact_force_y"][late]) / force[1]}


def exact(approach):
    table = checks.reference(CASE, "finite_elements.csv")
    return table["force_N_per_m"][np.argmin(np.abs(table["plate_approach_m"] - approach))]


def study():
    for approach in (0.4e-3, 0.8e-3, 1.6e-3, 3.2e-3):
        found = {rows: measure(rows, approach) for rows in (10, 20, 40)}
        print(f"| {1e3 * approach:.1f} mm | " +
              " | ".join(f"{one['force']:.1f} ({100 * (one['force'] / exact(approach) - 1):+.1f} %)" for one in found.values()) +
              f" | {exact(approach):.1f} |", {r: (f"{o['balance']:.0e}", f"{o['noise']:.0e}") for r, o in found.items()},
              flush=True)


def plot():
    table = checks.reference(CASE, "finite_elements.csv")
    figure, axes = checks.new_plot()
    axes.plot(1e3 * table["plate_approach_m"], table["force_N_per_m"], "k-", lw=0.8, label="finite elements")
    for rows in (10, 20):
        axes.plot(1e3 * table["plate_approach_m"], [measure(rows, a)["force"] for a in table["plate_approach_m"]], "o",
                  label=f"particles, R/{rows}")
    axes.set(xlabel="approach of the plates [mm]", ylabel="force [N/m]")
    axes.legend()
    checks.save_plot(figure, CASE, "force.png")


def main():
    options = checks.arguments(study=study, plot=plot)
    report = checks.Report()
    for approach in (0.8e-3, 1.6e-3):
        forces = {}
        for rows in (20, 40) if options.long else (20,):
            found = measure(rows, approach)
            what = f"approach {1e3 * approach:.1f} mm, R/{rows}"
            forces[rows] = found["force"] / exact(approach) - 1
            report.check(f"{what}: force less that of finite elements, of it", forces[rows], -0.06, 0.06)
            report.check(f"{what}: what the plates exert together, of the force", found["balance"], 0, 1e-3)
        if options.long:
            report.check(f"approach {1e3 * approach:.1f} mm: the same, extrapolated at first order",
                         2 * forces[40] - forces[20], -0.03, 0.03)
    report.end()


main()
