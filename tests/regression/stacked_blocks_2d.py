# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Three soft blocks on each other at rest: what each carries is the weight above it, and they settle as columns of an elastic
material do that is strained along its axis (Poisson's ratio 0), h + u with du/dY = l - 1, P(l) = -rho g (3 h - Y).
"""

import numpy as np

import checks

CASE = "stacked_blocks_2d"
G, SIDE, DENSITY, MODULUS = 9.81, 0.1, 1000.0, 1e5
SPACING = 0.01
NAMES = ("bottom", "middle", "top")


def stretch(stress):
    """l of Saint Venant and Kirchhoff, uniaxial with Poisson's ratio 0: P = E l (l^2 - 1)/2."""
    l = 1.0
    for _ in range(50):
        l -= (MODULUS * l * (l * l - 1) / 2 - stress) / (MODULUS * (3 * l * l - 1) / 2)
    return l


def settlement(place):
    """Of a point at a height in the undeformed stack."""
    heights = np.linspace(0, place, 2001)
    strains = [stretch(-DENSITY * G * (3 * SIDE - y)) - 1 for y in heights]
    return -np.trapezoid(strains, heights)


def measure(*settings):
    run = checks.Run(f"{CASE}/case.yaml", *settings)
    frames = {name: [(t, fields) for t, fields in run.frames(name)] for name in NAMES}
    return run.series("floor"), run.series("top"), frames


def main():
    options = checks.arguments()
    report = checks.Report()
    settings = ["loop.end_time=12"] if options.long else []
    floor, top, frames = measure(*settings)
    weight = DENSITY * G * SIDE**2
    report.check("force on the floor less the weight of three blocks, of it", -floor["contact_force_y"][-1] / (3 * weight) - 1,
                 -1e-4, 1e-4)
    report.check("force on the top block less its weight, of it", top["contact_force_y"][-1] / weight - 1, -1e-4, 1e-4)
    report.check("force along the floor, of the weight", np.abs(floor["contact_force_x"]).max() / weight, 0, 1e-6)
    for k, name in enumerate(NAMES):
        (_, start), (_, before), (_, end) = frames[name][0], frames[name][-3], frames[name][-1]
        # The uppermost row, half a spacing below the top.
        row = start["position"][:, 1] > (k + 1) * SIDE - SPACING
        sunk = (start["position"][row, 1] - end["position"][row, 1]).mean()
        exact = settlement((k + 1) * SIDE - SPACING / 2)
        report.check(f"{name}: sinks by less the exact settlement, in spacings", (sunk - exact) / SPACING, -0.05, 0.05)
        print(f"       {1e3 * sunk:.4f} mm, exact {1e3 * exact:.4f} mm")
        moved = np.abs(end["position"] - before["position"]).max() / SPACING
        report.check(f"{name}: moves between the last three frames, in spacings", moved, 0, 1e-4 if options.long else 1e-3)
    report.end()


main()
