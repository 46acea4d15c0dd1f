# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Bars that collide along their axis, against the waves in them (exact, by characteristics): reference/bars.csv.

With --study the table of the README; with --plot its plot.
"""

import numpy as np

import checks

CASE = "colliding_bars_2d"
SPEED = 0.005


def measure(length, impedance, rows=40):
    """Of a right bar of that length and impedance, of the left one's."""
    run = checks.Run(f"{CASE}/case.yaml", f"variables.other={length}", f"variables.impedance={impedance}",
                     f"variables.spacing=length/{rows}", f"loop.end_time={2 * max(length, 1) + 2}",
                     "outputs.frames.every={time: 100}")
    left, right = run.series("left"), run.series("right")
    mass, other_mass = 0.25, 0.25 * length * impedance
    start = mass * SPEED
    moved = np.abs(np.diff(left["momentum_x"])) > 1e-3 * start
    momentum = np.array([left[f"momentum_{c}"] + right[f"momentum_{c}"] for c in "xy"])
    energy = run.series("left_energy")["total"] + run.series("right_energy")["total"]
    # Where nothing touches each bar keeps its momentum: the means of the last fifth are those of any of it.
    return {"t": left["time"], "v1": left["momentum_x"] / start, "v2": right["momentum_x"] / (other_mass * SPEED),
            "time": left["time"][1:][moved][-1], "momentum": np.abs(momentum.T - momentum[:, 0]).max() / start,
            "rise": (energy.max() - energy[0]) / (0.5 * start * SPEED)}


def rows_of_reference():
    table = checks.reference(CASE, "bars.csv")
    for n in range(len(table["T1"])):
        row = {name: column[n] for name, column in table.items()}
        yield row["T2_over_T1"], row["Z2_over_Z1"], row


def study():
    for length, impedance, row in rows_of_reference():
        for rows in (20, 40, 80):
            found = measure(length, impedance, rows)
            print(f"| {length:g} | {impedance:g} | {rows} | {found['v1'][-1]:.3f} ({row['v1_over_V']:.3f}) | "
                  f"{found['v2'][-1]:.3f} ({row['v2_over_V']:.3f}) | {found['time']:.2f} ({row['contact_time_over_T1']:g}) | "
                  f"{found['momentum']:.0e} | {found['rise']:.0e} |", flush=True)


def plot():
    found = measure(1, 1)
    figure, axes = checks.new_plot()
    for name, label in (("v1", "left bar"), ("v2", "right bar")):
        [drawn] = axes.plot(found["t"], found[name], label=label)
        final = 1 if name == "v2" else 0
        axes.plot([0, 2, 4], [1 - final, final, final], "--", color=drawn.get_color(), lw=0.8)
    axes.set(xlabel="time in which a wave runs through a bar", ylabel="mean velocity, of the first")
    axes.legend(title="dashed: wave theory")
    checks.save_plot(figure, CASE, "velocities.png")


def by_density(report):
    """The contact of the guide, cases/bars_by_density.yaml: it is elastic and keeps the momentum as well."""
    run = checks.Run(checks.REPOSITORY / "tests/regression/cases/bars_by_density.yaml", "outputs.frames.every={time: 100}")
    left, right = run.series("left"), run.series("right")
    start = left["momentum_x"][0]
    energy = run.series("left_energy")["total"] + run.series("right_energy")["total"]
    report.check("by density: v1/V", left["momentum_x"][-1] / start, -0.01, 0.01, "measured 1e-5")
    report.check("by density: v2/V less 1", right["momentum_x"][-1] / start - 1, -0.01, 0.01)
    report.check("by density: change of momentum, of sum m v", np.ptp(left["momentum_x"] + right["momentum_x"]) / start, 0, 1e-12)
    report.check("by density: energy afterwards, less that before, of it", energy[-1] / energy[0] - 1, -1e-3, 1e-4)


def main():
    options = checks.arguments(study=study, plot=plot)
    report = checks.Report()
    for rows, limit in ((40, 0.03), (80, 0.02))[:2 if options.long else 1]:
        for length, impedance, row in rows_of_reference():
            what = f"{rows} spacings long, other bar {length:g} times that, impedance {impedance:g}"
            found = measure(length, impedance, rows)
            report.check(f"{what}: v1/V less the exact one", found["v1"][-1] - row["v1_over_V"], -limit, limit)
            report.check(f"{what}: v2/V less the exact one", found["v2"][-1] - row["v2_over_V"], -limit, limit)
            report.check(f"{what}: time in contact less the exact one", found["time"] - row["contact_time_over_T1"],
                         -0.1, 0.1 + 2 / rows)
            report.check(f"{what}: change of momentum, of sum m v", found["momentum"], 0, 1e-12)
            report.check(f"{what}: rise of the energy, of the kinetic", found["rise"], 0, 1e-4)
    by_density(report)
    report.end()


main()
