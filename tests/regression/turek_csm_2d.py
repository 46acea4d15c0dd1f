# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Turek & Hron's beam without fluid: at rest (CSM1, CSM2) and swinging (CSM3).

References, of point A, the middle of the tip: at rest those of Turek & Hron 2006,
doi:10.1007/3-540-34596-5_15; of the swing its lowest point, how far back it is there, and its frequency, all
of finer finite elements than theirs (README.md).
"""

import numpy as np

import beam
import checks

# How far A sinks, m.
REST = {"csm1": 0.06610, "csm2": 0.01697}
LOWEST, BACK, FREQUENCY = 0.12961, 0.02926, 1.0950

# Errors at H/5, H/10 and H/20: README.md.
REST_LIMIT = {5: 0.055, 10: 0.015}
LOWEST_LIMIT = {10: 0.015, 20: 0.007}
FREQUENCY_LIMIT = {10: 0.011, 20: 0.006}
BACK_LIMIT = {10: 0.032, 20: 0.012}
SWING_LIMIT = 0.03  # of what it sinks by


def run_of(name, across, *settings):
    return checks.Run(f"turek_csm_2d/{name}.yaml", f"variables.spacing=thickness/{across}",
                      "outputs.fields.every={time: 10}", *settings)


def at_rest(name, across):
    t, u = beam.tip(run_of(name, across))
    rest, swing = beam.at_rest(t, u, t[-1] / 3)
    return -rest[1], swing / -rest[1]


def swinging(across, end=1.6):
    t, u = beam.tip(run_of("case", across, f"loop.end_time={end}"))
    times, values = beam.extremes(t, u[:, 1])
    low = values < -LOWEST / 2
    return {"t": t, "u": u, "lowest": -values[low].mean(), "frequency": 1 / np.diff(times[low]).mean(),
            "back": -np.mean([np.interp(time, t, u[:, 0]) for time in times[low]])}


def plot():
    figure, axes = checks.new_plot(8, 4)
    reference = checks.reference("turek_csm_2d", "tip.csv")
    found = swinging(10, 2)
    beam.compare(axes, reference, found, "H/10", scale=1000)
    axes.set(xlabel="t [s]", ylabel="displacement of A [mm]", xlim=(0, 2), title="CSM3")
    axes.legend(fontsize="small", ncols=2)
    checks.save_plot(figure, "turek_csm_2d", "tip.png")


def study():
    for name, reference in REST.items():
        print(name)
        beam.study({across: at_rest(name, across)[:1] for across in (5, 10, 20)}, (reference,))
    rows = {}
    for across in (5, 10, 20):
        found = swinging(across)
        rows[across] = found["lowest"], found["back"], found["frequency"]
    beam.study(rows, (LOWEST, BACK, FREQUENCY))


def main():
    options = checks.arguments(study=study, plot=plot)
    report = checks.Report()
    across = 10 if options.long else 5
    for name, reference in REST.items():
        down, swing = at_rest(name, across)
        limit = REST_LIMIT[across]
        report.check(f"{name}: A sinks, less reference, of it", down / reference - 1, -limit, limit)
        report.check(f"{name}: what is left of the swing", swing, 0, SWING_LIMIT)
    across = 20 if options.long else 10
    found = swinging(across)
    limit = LOWEST_LIMIT[across]
    report.check("csm3: lowest point of A less reference, of it", found["lowest"] / LOWEST - 1, -limit, limit)
    limit = BACK_LIMIT[across]
    report.check("csm3: A is back then, less reference, of it", found["back"] / BACK - 1, -limit, limit)
    limit = FREQUENCY_LIMIT[across]
    report.check("csm3: frequency less reference, of it", found["frequency"] / FREQUENCY - 1, -limit, limit)
    report.end()


main()
