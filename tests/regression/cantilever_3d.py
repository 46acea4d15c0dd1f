# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Square cantilever under its own weight: where its tip comes to rest.

References are finite elements of second order (14 x 6 x 6, graded, total Lagrangian) of the same law,
within 0.2 %; beam theory has 0.0375 for gravity 1, without shear.
"""

import beam
import checks

DOWN = {1: 0.03833, 3: 0.11408}

# Measured: +9.0 % and +2.5 % at 4 and 8 particles across for gravity 1; README.md.
LIMIT = {4: 0.11, 8: 0.032}
SWING_LIMIT = 0.05  # of what it sinks by


def measure(gravity, across):
    run = checks.Run("cantilever_3d/case.yaml", f"variables.gravity={gravity}",
                     f"variables.spacing=thickness/{across}", "outputs.fields.every={time: 10}")
    t, u = beam.tip(run)
    rest, swing = beam.at_rest(t, u, t[-1] / 3)
    return -rest[1], swing


def main():
    options = checks.arguments()
    report = checks.Report()
    for gravity, reference in DOWN.items():
        if options.study:
            print(f"gravity {gravity}")
            beam.study({across: measure(gravity, across)[:1] for across in (4, 8, 16)}, (reference,))
            continue
        across = 8 if options.long else 4
        down, swing = measure(gravity, across)
        report.check(f"gravity {gravity}: tip sinks, less reference, of it", down / reference - 1,
                     -LIMIT[across], LIMIT[across])
        report.check(f"gravity {gravity}: what is left of the swing", swing / down, 0, SWING_LIMIT)
    report.end()


main()
