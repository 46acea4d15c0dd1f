# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Heave of a half-immersed cylinder that is let go above where it floats: zeros and first minimum against Maskell & Ursell
1970 (linear theory, deep water; own multipoles and impulse response, reference/heave.csv).

A cylinder of lattice points floats too high by a part of a spacing, so errors go with the spacing: README.md.
"""

import numpy as np

import beam
import checks

LIFT = 0.2
ZEROS, MINIMUM = (2.060, 5.779), -0.6406
# Measured +15.0 %, -1.3 %, -34.8 % at a/10; +7.7 %, +2.1 %, -11.6 % at a/20.
LIMITS = {10: (0.18, 0.05, 0.4), 20: (0.09, 0.03, 0.14)}


def measure(across):
    run = checks.Run("heaving_cylinder_2d/case.yaml", f"variables.spacing=radius/{across}", "loop.end_time=7",
                     "outputs.frames.every={time: 100}")
    cylinder = run.series("cylinder")
    t, y = cylinder["time"], cylinder["center_y"] / LIFT
    return np.array([*beam.zeros(t, y)[:2], y.min()])


def errors(found):
    return found / np.array([*ZEROS, MINIMUM]) - 1


def study():
    for across in (10, 20, 40):
        found = measure(across)
        print(f"| a/{across} |", " | ".join(f"{v:.3f} ({100 * e:+.1f} %)" for v, e in zip(found, errors(found))), "|",
              flush=True)


def main():
    options = checks.arguments(study=study)
    report = checks.Report()
    across = 20 if options.long else 10
    found = measure(across)
    for what, error, limit in zip(("first zero", "second zero", "first minimum"), errors(found), LIMITS[across]):
        report.check(f"{what} at a/{across} less that of theory, of it", error, -limit, limit)
    report.end()


if __name__ == "__main__":
    main()
