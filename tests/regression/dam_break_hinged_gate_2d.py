# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""A gate that water pushes open: the work of the water is what the gate and its damper have gained, and how far it opens
does not depend on the spacing (README.md).
"""

import numpy as np

import checks

DAMPING = 0.005
WORK_LIMIT = 1e-3  # measured 5e-5
OPENING = 60.9  # largest, degrees: 61.1, 61.2, 60.8 at 4, 8 and 16 particles across
OPENING_LIMIT = 1.0


def measure(across, end=0.3):
    run = checks.Run("dam_break_hinged_gate_2d/case.yaml", f"variables.spacing=thickness/{across}",
                     f"loop.end_time={end}", "outputs.frames.every={time: 100}")
    hinge, gate, energy = (run.series(name) for name in ("hinge", "gate", "energy"))
    gained = energy["total"] - energy["total"][0]
    power = DAMPING * hinge["rate"]**2
    lost = np.concatenate(([0], np.cumsum(0.5 * (power[1:] + power[:-1]) * np.diff(hinge["time"]))))
    top = hinge["coordinate"].argmax()
    return {
        "opening": np.degrees(hinge["coordinate"][top]),
        "time": hinge["time"][top],
        "early": np.degrees(np.interp(0.1, hinge["time"], hinge["coordinate"])),
        "work": gate["particle_work"][top] / (gained + lost)[top] - 1,
    }


def study():
    for across in (4, 8, 16):
        found = measure(across)
        print(f"| {across} | {found['early']:.1f} | {found['opening']:.1f} | {found['time']:.3f} | {found['work']:.1e} |",
              flush=True)


def main():
    options = checks.arguments(study=study)
    report = checks.Report()
    across = 8 if options.long else 4
    found = measure(across)
    report.check("work of the water over the gain of energy, less 1", found["work"], -WORK_LIMIT, WORK_LIMIT)
    report.check("largest opening, degrees", found["opening"], OPENING - OPENING_LIMIT, OPENING + OPENING_LIMIT)
    report.end()


if __name__ == "__main__":
    main()
