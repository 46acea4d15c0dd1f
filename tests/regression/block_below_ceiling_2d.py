# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""A block of water that touches a ceiling falls as it would without it, at any sound speed."""

import numpy as np

import checks

SPEED_LIMIT = 0.02   # of that of free fall
HANGING_LIMIT = 0.3  # how far the slowest particle has fallen, of the free fall


def measure(sound_speed, *settings):
    run = checks.Run("block_below_ceiling_2d/case.yaml", f"variables.sound_speed={sound_speed}", *settings)
    momentum, mass = run.series("momentum"), run.series("mass")["mass"][0]
    time, fields = list(run.frames("water"))[-1]
    return {
        "speed": -momentum["momentum_y"] / mass,
        "time": momentum["time"],
        "top": (1 - fields["position"][:, 1].max()) / (0.5 * time**2),
        "pressure": np.abs(fields["pressure"]).max(),
    }


def study():
    for sound_speed in (10, 20, 50):
        for height in (0.0125, 0.1):
            found = measure(sound_speed, f"variables.height={height}")
            print(f"| {sound_speed} | {height / 0.0125:.0f} | {found['speed'][-1] / found['time'][-1]:.5f} | "
                  f"{found['top']:.3f} | {found['pressure']:.1e} |", flush=True)


def main():
    checks.arguments(study=study)
    report = checks.Report()
    for sound_speed in (10, 20, 50):
        for rows in (1, 8):
            found = measure(sound_speed, f"variables.height={rows}*spacing")
            what = f"{rows} rows, sound speed {sound_speed}"
            report.check(f"mean speed at t = 1 less that of free fall, of it: {what}",
                         found["speed"][-1] / found["time"][-1] - 1, -SPEED_LIMIT, SPEED_LIMIT)
            report.check(f"fall of the highest particle, of the free fall: {what}",
                         found["top"], 1 - HANGING_LIMIT, 1.1)
    report.end()


if __name__ == "__main__":
    main()
