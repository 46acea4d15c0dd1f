# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Rigid disc that falls on a rigid floor: its height after each blow is e^2 of that before it."""

import numpy as np

import checks

CASE = "bouncing_ball_2d"
G, HEIGHT, RADIUS = 9.81, 0.3, 0.05


def heights(restitution, *settings):
    """Of the bounces, by the energy in flight: largest of y + v^2/2g in the middle of each."""
    run = checks.Run(f"{CASE}/case.yaml", f"variables.restitution={restitution}", "outputs.frames.every={time: 10}", *settings)
    ball = run.series("ball")
    y, v = ball["center_y"] - RADIUS, ball["velocity_y"]
    tops = np.flatnonzero((v[:-1] > 0) & (v[1:] <= 0))
    return y[tops] + v[tops]**2 / (2 * G), ball


def plot():
    _, ball = heights(0.7)
    figure, axes = checks.new_plot()
    axes.plot(ball["time"], ball["center_y"] - RADIUS, "-", label="ball")
    t, h = np.sqrt(2 * HEIGHT / G), HEIGHT
    while t < 1.5 and h > 1e-3:
        h *= 0.7**2
        flight = 2 * np.sqrt(2 * h / G)
        axes.plot([t + flight / 2], [h], "k+", label="closed form" if h == HEIGHT * 0.7**2 else None)
        t += flight
    axes.set(xlabel="t [s]", ylabel="height of the lowest point [m]")
    axes.legend()
    checks.save_plot(figure, CASE, "height.png")


def main():
    options = checks.arguments(plot=plot)
    report = checks.Report()
    for restitution in (0.3, 0.5, 0.7, 0.9, 1) if options.long else (0.7, 1):
        tops, ball = heights(restitution, *(() if options.long else ("loop.end_time=0.8",)))
        found = np.sqrt(tops[0] / HEIGHT)
        # What touches of a disc grows while it presses: its damping is that of the area, its way is longer.
        report.check(f"restitution {restitution}: found, less it", found - restitution, -0.02, 1e-3)
        if restitution == 1:
            report.check("restitution 1: largest change of the height in two blows, of it", np.abs(tops / HEIGHT - 1).max(), 0, 1e-3)
        report.check(f"restitution {restitution}: speed along the floor, of that of the fall",
                     np.abs(ball["velocity_x"]).max() / np.sqrt(2 * G * HEIGHT), 0, 1e-6)
    report.end()


main()
