# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Rubber ball that falls into a shallow basin: fluid, solid and contact with the floor in one loop. No closed form; checked
are the free fall, that it meets the floor and does not go into it, and that no energy comes from nowhere."""

import numpy as np

import checks

CASE = "rubber_ball_on_water_2d"
G, FALL, RADIUS, DENSITY, SPACING = 9.81, 0.3, 0.1, 500, 0.1 / 16  # that of the ball


def main():
    checks.arguments()
    report = checks.Report()
    run = checks.Run(f"{CASE}/case.yaml", "outputs.frames.every={time: 0.01}", "loop.end_time=0.7")
    mass = np.pi * RADIUS**2 * DENSITY
    momentum, floor = run.series("momentum"), run.series("floor")
    dry = momentum["time"] < 0.9 * np.sqrt(2 * FALL / G)
    report.check("speed in free fall less g t, of it, largest",
                 np.abs(momentum["momentum_y"][dry][1:] / (-mass * G * momentum["time"][dry][1:]) - 1).max(), 0, 0.01)
    push = -floor["contact_force_y"]
    touched = floor["time"][push > 0]
    report.check("meets the floor first at [s]", touched[0] if len(touched) else np.nan, 0.36, 0.45)
    steps = np.diff(floor["time"], prepend=0)
    report.check("impulse of the floor, of the ball's momentum when it meets the water",
                 (push * steps).sum() / (mass * np.sqrt(2 * G * FALL)), 0.3, 1.5)
    lowest = min(fields["position"][:, 1].min() for _, fields in run.frames("ball"))
    report.check("lowest particle above the floor, in spacings of the ball (0.5 touches)", lowest / SPACING, 0, 1,
                 "it may go into the floor by half a spacing")
    energy = run.series("water")["total"] + run.series("ball")["total"]
    report.check("rise of all energy, of that of the fall", (energy.max() - energy[0]) / (mass * G * FALL), 0, 0.005)
    report.end()


main()
