# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""3D dam break over an obstacle against the experiment of MARIN (SPHERIC benchmark 2).

Kleefsman et al. 2005, doi:10.1016/j.jcp.2004.12.007. Pressures at the front of the obstacle, 0.021,
0.061 and 0.101 m up, and the height of the water at four gauges; the force on the obstacle is the
rate at which it takes momentum from the water.
"""

import numpy as np

import checks

CASE = "dam_break_obstacle_3d"
GAUGES = ("h1", "h2", "h3", "h4")
SENSORS = 4
# Measured at 0.05, 0.025 and 0.0167 m: README.md.
ARRIVAL_LIMIT = 0.03           # s, of P1 to P3
MEAN_LIMIT = 0.30              # of the mean pressure for 0.4 < t < 0.6, P1 to P3
GAUGE_LIMIT = 0.12             # mean difference of H2 and H4, of the range of the experiment
ENERGY_RISE = 1e-3
WINDOW = (0.4, 0.6)


def mean(time, values, low, high):
    inside = (time >= low) & (time <= high)
    return np.trapezoid(values[inside], time[inside]) / (time[inside][-1] - time[inside][0])


def experiment():
    return (checks.reference(CASE, "experiment_50Hz.csv"),
            checks.reference(CASE, "experiment_impact_1kHz.csv"))


def gauge_error(run, name, slow):
    gauge = run.series(name)
    height = np.nan_to_num(gauge["elevation"])
    truth = np.interp(gauge["time"], slow["t"], slow[name.upper()])
    return np.abs(height - truth).mean() / np.ptp(truth)


def measure(spacing, cells, end):
    run = checks.Run(f"{CASE}/case.yaml", f"variables.spacing={spacing!r}", f"variables.obstacle_cells={cells}",
                     f"loop.end_time={end}", "outputs.fields.every={time: 1}")
    slow, fast = experiment()
    series, energy, force = run.series("pressure"), run.series("energy"), run.series("force")
    t = series["time"]
    pressure = [np.nan_to_num(series[f"average_pressure_{k}"]) for k in range(SENSORS)]
    total = energy["total"] / energy["total"][0]
    return {
        "time": t,
        "pressure": pressure,
        "arrival": [t[np.argmax(p > 1000)] if (p > 1000).any() else np.nan for p in pressure],
        "first": [fast["t"][np.argmax(fast[f"P{k + 1}"] > 1000)] for k in range(SENSORS)],
        "mean": [mean(t, p, *WINDOW) for p in pressure],
        "truth": [mean(fast["t"], fast[f"P{k + 1}"], *WINDOW) for k in range(SENSORS)],
        "force": mean(force["time"], force["force_x"], *WINDOW),
        "gauges": {name: gauge_error(run, name, slow) for name in GAUGES},
        "series": {name: run.series(name) for name in GAUGES},
        "rise": (total - np.minimum.accumulate(total)).max(),
    }


def study():
    for spacing, cells in ((0.05, 4), (0.025, 8), (1 / 60, 10)):
        found = measure(spacing, cells, 6)
        print(f"| {spacing:.4f} |", " ".join(f"{x:.3f}" for x in found["arrival"]),
              "|", " ".join(f"{x / 1000:.2f}" for x in found["mean"]), f"| {found['force']:.0f} |",
              " ".join(f"{100 * x:.1f}" for x in found["gauges"].values()), f"| {found['rise']:.1e} |", flush=True)
    print("| experiment |", " ".join(f"{x:.3f}" for x in found["first"]),
          "|", " ".join(f"{x / 1000:.2f}" for x in found["truth"]), "| | | |")


def plot():
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    slow, _ = experiment()
    found = measure(0.025, 8, 6)
    figure, panels = pyplot.subplots(2, 2, figsize=(9, 6), layout="constrained")
    for axes, sensor in zip(panels[0], (0, 2)):
        t = np.arange(0.01, 6, 0.02)  # means over 0.02 s, as those of the experiment
        p = [found["pressure"][sensor][np.abs(found["time"] - x) <= 0.01].mean() / 1000 for x in t]
        axes.plot(slow["t"], slow[f"P{sensor + 1}"] / 1000, color="0.4", label="experiment")
        axes.plot(t, p, label="ours, spacing 0.025 m", linewidth=0.9)
        axes.set(title=f"P{sensor + 1} [kPa]", xlim=(0, 6), ylim=(-2, 12))
    for axes, gauge in zip(panels[1], ("h2", "h4")):
        axes.plot(slow["t"], slow[gauge.upper()], color="0.4")
        axes.plot(found["series"][gauge]["time"], found["series"][gauge]["elevation"], linewidth=0.9)
        axes.set(title=f"{gauge.upper()} [m]", xlim=(0, 6), ylim=(0, 0.6), xlabel="t [s]")
    for axes in panels.flat:
        axes.grid(alpha=0.3)
    panels[0][0].legend(fontsize=8)
    checks.save_plot(figure, CASE, "series.png")


def main():
    options = checks.arguments(study=study, plot=plot)
    found = measure(0.025, 8, 6 if options.long else 0.62)
    report = checks.Report()
    for k in range(3):
        report.check(f"P{k + 1} first above 1 kPa, less that of the experiment [s]",
                     found["arrival"][k] - found["first"][k], -ARRIVAL_LIMIT, ARRIVAL_LIMIT)
        report.check(f"mean of P{k + 1} for 0.4 < t < 0.6, less that of the experiment, of it",
                     found["mean"][k] / found["truth"][k] - 1, -MEAN_LIMIT, MEAN_LIMIT)
    if options.long:
        for name in ("h2", "h4"):
            report.check(f"mean difference of {name.upper()}, of its range", found["gauges"][name], 0, GAUGE_LIMIT)
    report.check("rise of the energy above its earlier minimum, of its start", found["rise"], 0, ENERGY_RISE)
    report.end()


main()
