# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Lid-driven cavity: velocities on the lines through the centre, against a steady solution by finite differences.

The reference (cases/lid_driven_cavity_2d/reference) is a solution of second order for the stream function on 128
and 192 cells, extrapolated; at Re = 1000 its extremes are those of Botella & Peyret 1998,
doi:10.1016/S0045-7930(98)00002-4, within 3e-5. Ours is the mean over the last five times side/speed.
"""

import numpy as np

import checks

CASE = "lid_driven_cavity_2d"
# Times at which the flow is steady, and limits at 1/50 and 1/100, largest and rms: README.md.
END = {100: 15, 400: 40, 1000: 80}
LIMITS = {(100, 50): (0.012, 0.006), (100, 100): (0.012, 0.005), (400, 100): (0.03, 0.015), (1000, 100): (0.05, 0.025)}


def measure(reynolds, cells):
    run = checks.Run(f"{CASE}/case.yaml", f"variables.reynolds={reynolds}", f"variables.spacing={1 / cells!r}",
                     f"loop.end_time={END[reynolds]}")
    off = []
    for name, table, component, axis in (("upright", "u_vs_y", "x", "y"), ("across", "v_vs_x", "y", "x")):
        series = run.series(name)
        exact = checks.reference(CASE, f"{table}.csv")
        count = sum(column.startswith("velocity_") and column.endswith("_x") for column in series)
        place = np.linspace(0.04, 0.96, count)
        found = np.array([series[f"velocity_{k}_{component}"][-1] for k in range(count)])
        off.append(found - np.interp(place, exact[axis], exact[f"Re{reynolds}"]))
    return np.abs(np.concatenate(off)).max(), max(np.sqrt((o**2).mean()) for o in off)


def study():
    for reynolds in END:
        for cells in (25, 50, 100):
            largest, rms = measure(reynolds, cells)
            print(f"| {reynolds} | 1/{cells} | {largest:.4f} | {rms:.4f} |", flush=True)


def main():
    options = checks.arguments(study=study)
    report = checks.Report()
    for (reynolds, cells), (most, most_rms) in LIMITS.items():
        if (cells == 50) == options.long:
            continue
        largest, rms = measure(reynolds, cells)
        name = f"Re {reynolds}, 1/{cells}: velocity on the lines through the centre less the reference, "
        report.check(name + "largest", largest, 0, most)
        report.check(name + "rms of the worse line", rms, 0, most_rms)
    report.end()


if __name__ == "__main__":
    main()
