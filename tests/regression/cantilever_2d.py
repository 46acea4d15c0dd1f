# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Cantilever under its own weight: where its tip comes to rest, for a small and a large bend.

References are finite elements of the second order (total Lagrangian, plane strain) of the same law,
converged to 0.1 %; the elastica, inextensible and without shear, sinks by 0.12347 and 0.42516. Tables
of the errors, and where they come from: README.md of the case.
"""

import beam
import checks

DOWN = {1: 0.12434, 4: 0.42968}
BACK = {1: 0.00883, 4: 0.11153}

# Measured: sinks by +1.7 % and +1.6 % at H/10, +0.5 % and +0.7 % at H/20; its way back goes with the
# square of that.
DOWN_LIMIT = {10: 0.022, 20: 0.009}
BACK_LIMIT = {10: 0.042, 20: 0.019}
SWING_LIMIT = 0.05  # of what it sinks by; 4 % for the large bend


def measure(load, across):
    run = checks.Run("cantilever_2d/case.yaml", f"variables.load={load}",
                     f"variables.spacing=thickness/{across}", "outputs.fields.every={time: 10}")
    t, u = beam.tip(run)
    rest, swing = beam.at_rest(t, u, t[-1] / 3)
    return -rest[1], -rest[0], swing


def main():
    options = checks.arguments()
    report = checks.Report()
    for load in DOWN:
        if options.study:
            print(f"load {load}")
            beam.study({across: measure(load, across)[:2] for across in (5, 10, 20)},
                       (DOWN[load], BACK[load]))
            continue
        across = 20 if options.long else 10
        down, back, swing = measure(load, across)
        limit = DOWN_LIMIT[across]
        report.check(f"load {load}: tip sinks, less reference, of it", down / DOWN[load] - 1, -limit, limit)
        limit = BACK_LIMIT[across]
        report.check(f"load {load}: tip goes back, less reference, of it", back / BACK[load] - 1,
                     -limit, limit)
        report.check(f"load {load}: what is left of the swing", swing / down, 0, SWING_LIMIT)
    report.end()


main()
