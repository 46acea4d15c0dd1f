# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""3D dam break: the 2D flow again, the pressure on the far wall, the energy.

Between parallel walls without friction the collapse is that of dam_break_2d: the front of a 2D run
at the same spacing is the reference, to within a fraction of a spacing. The pressure first exceeds
0.1 at 0.1 H at T = 2.52 in the experiment of Lobovsky et al. 2014,
doi:10.1016/j.jfluidstructs.2014.03.009; ours, at a coarse spacing: README.md.
"""

import numpy as np

import checks

SPACING = 0.05
PLACES = (3, 4, 5)
# Measured at 1/10, 1/20 and 1/30: README.md.
FRONT_LIMIT = 0.018
ARRIVAL = (2.35, 2.60)
PLATEAU = (0.38, 0.70)  # 30 % around that of the experiment, 0.54
ENERGY_RISE = 1e-3


def front_times(run):
    front = run.series("front")
    return [np.interp(x, front["front_position"], front["time"]) for x in PLACES]


def measure(spacing, end):
    run = checks.Run("dam_break_3d/case.yaml", f"variables.spacing={spacing!r}", f"loop.end_time={end}")
    flat = checks.Run("dam_break_2d/case.yaml", f"variables.spacing={spacing!r}", "loop.end_time=3",
                      "outputs.front={type: reduce, every: {time: 0.05}, body: water, quantity: front_position}")
    pressure, energy = run.series("pressure"), run.series("energy")
    total = energy["total"] / energy["total"][0]
    wet = np.nan_to_num(pressure["average_pressure_1"]) > 0.1
    plateau = (pressure["time"] > 3.5) & (pressure["time"] < 5)
    return {
        "fronts": list(zip(PLACES, front_times(run), front_times(flat))),
        "arrival": pressure["time"][np.argmax(wet)] if wet.any() else np.nan,
        "plateau": np.nan_to_num(pressure["average_pressure_3"][plateau]).mean() if plateau.any() else np.nan,
        "rise": (total - np.minimum.accumulate(total)).max(),
        "end": total[-1],
    }


def study():
    for cells in (10, 20, 30):
        found = measure(1 / cells, 6)
        print(f"| 1/{cells} |", " | ".join(f"{t:.3f} ({flat:.3f})" for _, t, flat in found["fronts"]),
              f"| {found['arrival']:.2f} | {found['plateau']:.2f} | {found['rise']:.1e} | {found['end']:.3f} |")


def main():
    options = checks.arguments(study=study)
    found = measure(SPACING, 6 if options.long else 2.8)
    report = checks.Report()
    for x, t, flat in found["fronts"]:
        report.check(f"time of the front at x = {x} less that in 2D, of it", t / flat - 1, -FRONT_LIMIT, FRONT_LIMIT)
    report.check("pressure at 0.1 H first above 0.1", found["arrival"], *ARRIVAL)
    if options.long:
        report.check("mean pressure at 0.2 H for 3.5 < T < 5", found["plateau"], *PLATEAU)
    report.check("rise of the energy above its earlier minimum, of its start", found["rise"], 0, ENERGY_RISE)
    report.end()


main()
