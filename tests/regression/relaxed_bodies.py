# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Particles that are fitted to shapes: to a sphere and to a torus the row at the surface and the volume, of an
elastic disc the frequency at which it breathes. (A circle and a star: star_in_round_tank_2d.py; an elastic ring
under pressure: pressurised_ring_2d.py.)

A disc of radius 1 in plane strain breathes at w with x J0(x) = 2 mu/(lambda + 2 mu) J1(x),
x = w/c, c^2 = (lambda + 2 mu)/rho: no stress at its edge, of u_r = J1(w r/c)."""

import pathlib

import numpy as np

import checks

CASES = pathlib.Path(__file__).parent / "cases"
SPACING = 0.1
AXIS = np.array([1, 2, 3]) / np.sqrt(14)
# In spacings, root of the mean square; of the volume.
ROW_LIMIT = 0.1
VOLUME_LIMIT = 0.005
# Of the frequency, at 20 spacings in the radius. Measured: -0.26 % at 10, +0.02 % at 20, +0.28 % at 40; on lattices
# -1.24 %, -0.63 %, -0.10 %.
FREQUENCY_LIMIT = 0.004


def in_ball(x):
    return 1 - np.linalg.norm(x - [0, 0, 3], axis=1)


def in_torus(x):
    along = x @ AXIS
    aside = np.linalg.norm(x - along[:, None] * AXIS, axis=1)
    return 0.5 - np.hypot(aside - 1, along)


def bessel(n, x):
    angle = (np.arange(2000) + 0.5) * np.pi / 2000
    return np.mean(np.cos(n * angle - x * np.sin(angle)))


def breathing():
    """Frequency of the first mode of the disc, E = 1, nu = 0.3, rho = 1."""
    lame, shear = 0.3 / 1.3 / 0.4, 0.5 / 1.3
    modulus = lame + 2 * shear
    edge = lambda x: x * bessel(0, x) - 2 * shear / modulus * bessel(1, x)
    low, high = 1.5, 2.4
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (low, middle) if edge(low) * edge(middle) <= 0 else (middle, high)
    return low * np.sqrt(modulus)


def measured_breathing(spacing, arrangement="relaxed"):
    run = checks.Run(CASES / "breathing_disc.yaml", f"variables.spacing={spacing}",
                     f"bodies.disc.arrangement={arrangement}")
    energy = run.series("energy")
    waves = (energy["kinetic"] - energy["kinetic"].mean()) * np.hanning(len(energy["time"]))
    frequencies = np.linspace(2, 8, 12001)  # of the kinetic energy, twice that of the disc
    size = [abs(np.exp(-1j * w * energy["time"]) @ waves) for w in frequencies]
    return frequencies[np.argmax(size)] / 2


def study():
    for spacing in (0.1, 0.05, 0.025):
        print(spacing, *(f"{kind} {100 * (measured_breathing(spacing, kind) / breathing() - 1):+.2f} %"
                         for kind in ("relaxed", "lattice")), flush=True)


def main():
    checks.arguments(study=study)
    report = checks.Report()
    report.check("frequency of the breathing disc less that of theory, of it",
                 measured_breathing(0.05) / breathing() - 1, -FREQUENCY_LIMIT, FREQUENCY_LIMIT)
    run = checks.Run(CASES / "relaxed_solids_3d.yaml", f"variables.spacing={SPACING}")
    for body, depth, volume in (("ball", in_ball, 4 / 3 * np.pi), ("torus", in_torus, np.pi**2 / 2)):
        _, fields = next(iter(run.frames(body)))
        d = depth(fields["position"]) / SPACING
        row = d[d < 1]
        report.check(f"{body}: least depth, spacings", d.min(), 0.4, 0.6)
        report.check(f"{body}: row off half a spacing, rms in spacings", np.sqrt(np.mean((row - 0.5) ** 2)), 0, ROW_LIMIT)
        report.check(f"{body}: particles in the row, of those that its layer has",
                     len(row) / (layer(body) / SPACING**3), 0.97, 1.03)
        report.check(f"{body}: volume less that of the shape, of it", fields["mass"].sum() / volume - 1,
                     -VOLUME_LIMIT, VOLUME_LIMIT)
    report.end()


def layer(body):
    """Volume less than a spacing deep."""
    if body == "ball":
        return 4 / 3 * np.pi * (1 - (1 - SPACING) ** 3)
    return 2 * np.pi**2 * (0.25 - (0.5 - SPACING) ** 2)


main()
