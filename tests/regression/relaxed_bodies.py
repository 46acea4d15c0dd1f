# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Particles that are fitted to a sphere and to a torus: the row at the surface and the volume. (A circle and
a star: star_in_round_tank_2d.py; an elastic ring: pressurised_ring_2d.py.)"""

import pathlib

import numpy as np

import checks

SPACING = 0.1
AXIS = np.array([1, 2, 3]) / np.sqrt(14)
# In spacings, root of the mean square; of the volume.
ROW_LIMIT = 0.1
VOLUME_LIMIT = 0.005


def in_ball(x):
    return 1 - np.linalg.norm(x - [0, 0, 3], axis=1)


def in_torus(x):
    along = x @ AXIS
    aside = np.linalg.norm(x - along[:, None] * AXIS, axis=1)
    return 0.5 - np.hypot(aside - 1, along)


def main():
    checks.arguments()
    report = checks.Report()
    case = pathlib.Path(__file__).parent / "cases" / "relaxed_solids_3d.yaml"
    run = checks.Run(case, f"variables.spacing={SPACING}")
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
