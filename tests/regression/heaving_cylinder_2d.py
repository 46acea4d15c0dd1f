# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Heave of a half-immersed cylinder that is let go above where it floats: zeros and first minimum against Maskell & Ursell
1970 (linear theory, deep water; own multipoles and impulse response, reference/heave.csv).

Errors are of first order in the spacing: the long test extrapolates, the short one holds what a/10 gives.
"""

import numpy as np

import checks

LIFT = 0.2
ZEROS, MINIMUM = (2.060, 5.779), -0.6406
# At a/10, measured +15 %, -2.6 %, and -0.41.
COARSE_LIMITS = (0.18, 0.05, 0.4)
# Extrapolated from a/10 and a/20, measured +0.9 %, +1.7 %, +0.4 %.
LIMITS = (0.03, 0.03, 0.1)


def measure(across):
    run = checks.Run("heaving_cylinder_2d/case.yaml", f"variables.spacing=radius/{across}", "loop.end_time=7",
                     "outputs.frames.every={time: 100}")
    cylinder = run.series("cylinder")
    t, y = cylinder["time"], cylinder["center_y"] / LIFT
    k = np.flatnonzero(np.sign(y[1:]) != np.sign(y[:-1]))
    zeros = t[k] + (t[k + 1] - t[k]) * y[k] / (y[k] - y[k + 1])
    return np.array([*zeros[:2], y.min()])


def errors(found):
    return found / np.array([*ZEROS, MINIMUM]) - 1


def study():
    coarse, fine = measure(10), measure(20)
    for name, values in (("a/10", coarse), ("a/20", fine), ("extrapolated", 2 * fine - coarse)):
        print(f"| {name} |", " | ".join(f"{v:.3f} ({100 * e:+.1f} %)" for v, e in zip(values, errors(values))), "|",
              flush=True)


def main():
    options = checks.arguments(study=study)
    report = checks.Report()
    found, limits, where = measure(10), COARSE_LIMITS, "a/10"
    if options.long:
        found, limits, where = 2 * measure(20) - found, LIMITS, "extrapolated"
    for what, error, limit in zip(("first zero", "second zero", "first minimum"), errors(found), limits):
        report.check(f"{what}, {where}, less that of theory, of it", error, -limit, limit)
    report.end()


if __name__ == "__main__":
    main()
