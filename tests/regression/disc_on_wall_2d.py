# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Elastic disc that rebounds from a rigid wall, against explicit finite elements (two meshes, three penalties):
reference/impact.csv. With --study the table of the README, with --plot its plot."""

import numpy as np

import checks

CASE = "disc_on_wall_2d"
RADIUS, SPEED, GAP = 0.05, 2.0, 0.5e-3
RESTITUTION, DURATION, SHORTENING, WIDENING = 0.9655, 9.36e-3, 7.30e-3, 3.42e-3


def measure(rows):
    run = checks.Run(f"{CASE}/case.yaml", f"variables.spacing=radius/{rows}", "outputs.frames.every={time: 0.0002}",
                     "outputs.momentum.every={time: 0.00002}", "outputs.energy.every={time: 0.00002}")
    momentum, energy = run.series("momentum"), run.series("energy")["total"]
    mass = -momentum["momentum_y"][0] / SPEED
    touches = np.flatnonzero(np.abs(np.diff(momentum["momentum_y"])) > 1e-9 * mass * SPEED)
    frames = [fields["position"] for _, fields in run.frames("disc")]
    top, rim = np.argmax(frames[0][:, 1]), np.argmax(frames[0][:, 0])
    rear = np.argmin(frames[0][:, 0])
    return {"t": momentum["time"], "v": momentum["momentum_y"] / (mass * SPEED),
            "restitution": momentum["momentum_y"][-1] / (mass * SPEED),
            "duration": momentum["time"][touches[-1] + 1] - momentum["time"][touches[0]],
            "shortening": max(frames[0][top, 1] - f[top, 1] for f in frames) - GAP,
            "widening": max(np.ptp(f[[rim, rear], 0]) for f in frames) - np.ptp(frames[0][[rim, rear], 0]),
            # The area of a disc of particles is not quite that of the disc.
            "impulse": (momentum["momentum_y"][-1] - momentum["momentum_y"][0]) * np.pi * RADIUS**2 * 1000 / mass,
            "sideways": np.abs(momentum["momentum_x"]).max() / (mass * SPEED),
            "rise": (energy.max() - energy[0]) / energy[0], "loss": 1 - energy[-1] / energy[0]}


def study():
    for rows in (10, 20, 40):
        found = measure(rows)
        print(f"| R/{rows} | {found['restitution']:.4f} | {1e3 * found['duration']:.2f} | {1e3 * found['shortening']:.2f} | "
              f"{1e3 * found['widening']:.2f} | {found['impulse']:.2f} | {found['rise']:.0e} | {found['loss']:.0e} |", flush=True)


def plot():
    found, reference = measure(20), checks.reference(CASE, "impact.csv")
    figure, axes = checks.new_plot()
    axes.plot(1e3 * reference["t"], -reference["v_over_V"], "k-", lw=0.8, label="finite elements")
    axes.plot(1e3 * found["t"][::10], found["v"][::10], ".", label="particles, R/20")
    axes.set(xlabel="t [ms]", ylabel="mean velocity, of the first")
    axes.legend()
    checks.save_plot(figure, CASE, "velocity.png")


def main():
    options = checks.arguments(study=study, plot=plot)
    report = checks.Report()
    for rows in (10, 20, 40) if options.long else (20,):
        found = measure(rows)
        what = f"R/{rows}"
        report.check(f"{what}: speed after over that before less 0.9655", found["restitution"] - RESTITUTION, -0.03, 0.03)
        report.check(f"{what}: time in contact less 9.36 ms, of it", found["duration"] / DURATION - 1, -0.08, 0.08)
        if rows >= 20:
            report.check(f"{what}: largest shortening less 7.30 mm, of it", found["shortening"] / SHORTENING - 1, -0.08, 0.08)
            report.check(f"{what}: largest widening less 3.42 mm, of it", found["widening"] / WIDENING - 1, -0.08, 0.08)
        report.check(f"{what}: impulse of the wall less 30.87 N s/m, of it", found["impulse"] / 30.87 - 1, -0.02, 0.02)
        report.check(f"{what}: momentum along the wall, of m V", found["sideways"], 0, 1e-10)
        report.check(f"{what}: rise of the energy, of it", found["rise"], 0, 1e-4)
        report.check(f"{what}: loss of energy in the end, of it", found["loss"], -1e-4, 3e-4,
                     "2.2e-4 at R/10, 3e-5 there with a third of the step")
    report.end()


main()
