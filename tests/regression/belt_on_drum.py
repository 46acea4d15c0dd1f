# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Belt around half a drum, cases/belt_on_drum.yaml, one end of which is pulled further: it slides at T2/T1 = exp(mu pi).
Friction acts at the inner side of a belt of thickness t, so that is exp(mu pi R/(R + t/2)) with the tensions in the middle."""

import numpy as np

import checks

FRICTION, MIDDLE, RADIUS = 0.2, 0.1025, 0.1


def main():
    checks.arguments()
    report = checks.Report()
    ends = checks.Run(checks.REPOSITORY / "tests/regression/cases/belt_on_drum.yaml").series("ends")
    late = ends["time"] > 0.1
    both, more = -ends["reaction_y"][late].mean(), -ends["reaction_moment"][late].mean() / MIDDLE
    ratio = (both + more) / (both - more)
    report.check("T2/T1 less exp(mu pi), of it", ratio / np.exp(FRICTION * np.pi) - 1, -0.08, 0.08)
    print(f"       less that of its thickness, of it: {ratio / np.exp(FRICTION * np.pi * RADIUS / MIDDLE) - 1:+.4f}")
    report.end()


main()
