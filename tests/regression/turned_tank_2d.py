# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Water in a tank that is turned once and then held: it gains no more energy than the walls give.

The walls turn about the middle of the tank, so their power is -M w, with the moment M of the water on
them and the rate w of the angle. Energies are in rho g H^2 L, of which the mass of the water is one
(g = H = 1, and the rows of `moment` are means over the time between them).
"""

import numpy as np

import checks

TURN_TIME, REST_TIME = 40.0, 40.0

# Measured at H/20 and H/40: README.md. The gain is that of water whose particles leave their lattice.
GAIN_LIMIT = {0.05: 3.5e-3, 0.025: 1.8e-3}
RISE_LIMIT = 1e-4
KINETIC_LIMIT = 1e-3


def angle(time):
    x = np.minimum(time / TURN_TIME, 1)
    return 2 * np.pi * x**3 * (10 - 15 * x + 6 * x**2)


def rise(values):
    """Largest rise of a series above what it has been before."""
    return (values - np.minimum.accumulate(values)).max()


def level(run, spacing):
    """Mean height of the surface in the last frame; drops that hang at the ceiling are left out."""
    _, fields = list(run.frames("water"))[-1]
    x, y = fields["position"][:, 0], fields["position"][:, 1]
    pool = y < 0.5
    columns = np.floor(x[pool] / (2 * spacing))
    return np.mean([y[pool][columns == c].max() for c in np.unique(columns)]) + 0.5 * spacing


def measure(spacing):
    run = checks.Run("turned_tank_2d/case.yaml", f"variables.spacing={spacing!r}")
    unit = run.series("mass")["mass"][0]
    energy = run.series("energy")
    moment = run.series("moment")["moment"]
    time = energy["time"]
    work = np.concatenate([[0], np.cumsum(-moment[1:] * np.diff(angle(time)))]) / unit
    total = (energy["total"] - energy["total"][0]) / unit
    held = time >= TURN_TIME
    return {
        "gain": rise((total - work)[~held]),
        "work": work[-1],
        "energy": total[held][0],
        "rise": rise(total[held]),
        "kinetic": energy["kinetic"][-1] / unit,
        "level": level(run, spacing) / spacing,
        "lost": run.series("mass")["removed"][-1],
    }


def study():
    for spacing in (0.05, 0.025, 1 / 60):
        found = measure(spacing)
        print(f"| 1/{1 / spacing:g} | " + " | ".join(f"{found[name]:.2e}" for name in found) + " |")


def main():
    options = checks.arguments(study=study)
    spacing = 0.025 if options.long else 0.05
    found = measure(spacing)
    report = checks.Report()
    report.check("gain of the energy over the work / (rho g H^2 L)", found["gain"], 0,
                 GAIN_LIMIT[spacing])
    report.check("rise of the energy after the stop", found["rise"], 0, RISE_LIMIT)
    report.check("kinetic energy at the end", found["kinetic"], 0, KINETIC_LIMIT)
    report.check("work of the walls", found["work"], 0.19, 0.22)
    report.check("level of the surface at the end, spacings", found["level"], -1, 1)
    report.check("particles that got out", found["lost"], 0, 0)
    report.end()


main()
