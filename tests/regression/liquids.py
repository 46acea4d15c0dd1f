# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Oil on water at rest: in 3D (cases/layers_3d.yaml), beside an elastic plate (cases/layers_at_plate.yaml), and with
a rigid box between them (cases/float_between_layers.yaml).

The force and the moment on the plate are those of the hydrostatic pressure, its deflection that of Timoshenko's beam
under this pressure in plane strain. The box has the mean density of both, so that its middle rests at the interface.
"""

import numpy as np

import checks

HERE = checks.REPOSITORY / "tests/regression/cases"
GRAVITY = 9.81
WATER, OIL = 1000.0, 500.0
# With low dissipation one liquid of both depths in the same tank has a noise of this part of free fall; its lattice
# breaks up, and it swings up and down, so that means of the pressure say little.
NOISE = {"dissipative": 0.001, "low_dissipation": 0.029}


def layers_3d(report, spacing, densities=(WATER, OIL)):
    lower, upper, width, start = 0.3, 0.2, 0.4, 2.0
    water, oil = densities
    floor = GRAVITY * (water * lower + oil * upper)
    for riemann in ("dissipative", "low_dissipation"):
        run = checks.Run(HERE / "layers_3d.yaml", f"variables.spacing={spacing}", f"variables.water_density={water}",
                         f"variables.oil_density={oil}", f"dynamics.relaxation.riemann={riemann}")
        worst, deepest, squares = 0.0, -1.0, []
        rows = round((lower + upper) / spacing) + 1
        for body in ("water", "oil"):
            sums, counts = np.zeros(rows), np.zeros(rows)
            for time, fields in run.frames(body):
                if time < start:
                    continue
                z, p = fields["position"][:, 2], fields["pressure"]
                exact = floor - GRAVITY * water * z if body == "water" else GRAVITY * oil * (lower + upper - z)
                row = np.clip((z / spacing).astype(int), 0, rows - 1)
                sums += np.bincount(row, p - exact, rows)
                counts += np.bincount(row, minlength=rows)
                squares.append((fields["velocity"]**2).sum(axis=1).mean())
                deepest = max(deepest, (z.max() - lower if body == "water" else lower - z.min()) / spacing)
            whole = counts > 0.2 * counts.max()
            worst = max(worst, np.abs(sums[whole] / counts[whole]).max() / floor)
        force = run.series("force")
        weight = GRAVITY * width**2 * (water * lower + oil * upper)
        mean = force["pressure_force_z"][force["time"] > start].mean()
        noise = np.sqrt(np.mean(squares) / (2 * GRAVITY * (lower + upper)))
        what = f"3D, densities {water:g} and {oil:g}, {riemann}: "
        report.check(what + "force on the tank, of the weight", -mean / weight - 1, -0.01, 0.01)
        report.check(what + "a liquid gets into the other by, spacings", deepest, -1, 1)
        report.check(what + "speeds, root mean square, of free fall", noise, 0, NOISE[riemann])
        if riemann == "dissipative":
            report.check(what + "error of the pressure, of that at the floor", worst, 0, 0.01)


def plate(report, spacing, densities=(WATER, OIL)):
    lower, upper, thickness, modulus, ratio = 0.6, 0.4, 0.1, 1e9, 0.3
    height = lower + upper
    water, oil = densities
    run = checks.Run(HERE / "layers_at_plate.yaml", f"variables.spacing={spacing}", f"variables.water_density={water}",
                     f"variables.oil_density={oil}")
    y = np.linspace(0, height, 20001)
    p = np.where(y < lower, GRAVITY * (oil * upper + water * (lower - y)), GRAVITY * oil * (height - y))
    force, moment = np.trapezoid(p, y), np.trapezoid(p * y, y)
    step = y[1] - y[0]

    def above(values):
        """The integral from y to the height."""
        return np.flip(np.concatenate([[0], np.cumsum(0.5 * (np.flip(values)[1:] + np.flip(values)[:-1]) * step)]))

    shear = above(p)
    bending = above(shear)
    rigidity = modulus / (1 - ratio**2) * thickness**3 / 12
    shear_rigidity = 5 / 6 * modulus / (2 * (1 + ratio)) * thickness
    tip = np.trapezoid(bending * (height - y), y) / rigidity + np.trapezoid(shear, y) / shear_rigidity
    late = run.series("force")["time"] > 1.2
    found = {"force": run.series("force")["pressure_force_x"][late].mean() / force - 1,
             "moment": -run.series("moment")["pressure_moment"][late].mean() / moment - 1}
    series = run.series("tip")
    name = next(name for name in series if name.startswith("displacement") and name.endswith("x"))
    bent = series[name][series["time"] > 1.2]
    what = f"plate, densities {water:g} and {oil:g}: "
    report.check(what + "force less the hydrostatic, of it", found["force"], -0.01, 0.01)
    report.check(what + "moment about the foot less the hydrostatic, of it", found["moment"], -0.02, 0.02)
    report.check(what + "deflection less that of the beam, of it", bent.mean() / tip - 1, -0.05, 0.05)
    report.check(what + "it swings by, of the deflection", np.ptp(bent) / tip, 0, 0.1)
    for body, sign in (("water", 1), ("oil", -1)):
        *_, (_, fields) = run.frames(body)
        report.check(what + f"{body} gets into the other by, spacings",
                     (sign * (fields["position"][:, 1] - lower)).max() / spacing, -1, 2)
        report.check(what + f"{body} gets behind the face by, spacings",
                     (fields["position"][:, 0].max() - 0.6) / spacing, -1, 0.5)


def between(report, spacing, densities=(WATER, OIL)):
    run = checks.Run(HERE / "float_between_layers.yaml", f"variables.spacing={spacing}",
                     f"variables.water_density={densities[0]}", f"variables.oil_density={densities[1]}")
    box = run.series("box")
    late = box["time"] > 1
    what = f"float, densities {densities[0]:g} and {densities[1]:g}: "
    report.check(what + "middle away from the interface, spacings", np.abs(box["center_y"][late] - 0.6).max() / spacing,
                 0, 0.5)
    report.check(what + "it heels by, degrees", np.degrees(np.abs(box["angle"][late]).max()), 0, 1)
    for body, sign in (("water", 1), ("oil", -1)):
        *_, (_, fields) = run.frames(body)
        report.check(what + f"{body} gets into the other by, spacings",
                     (sign * (fields["position"][:, 1] - 0.6)).max() / spacing, -1, 2)


def main():
    options = checks.arguments()
    report = checks.Report()
    for densities in ((WATER, OIL), (WATER, 100.0))[:2 if options.long else 1]:
        layers_3d(report, 0.025 if options.long else 0.05, densities)
        plate(report, 0.02 if options.long else 0.025, densities)
        between(report, 0.02 if options.long else 0.04, densities)
    report.end()


main()
