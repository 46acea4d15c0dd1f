# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Rigid bodies on a rigid floor with dry friction, cases/block_on_floor.yaml and disc_on_floor.yaml: where they stop,
when they slide or tip, how they fall, rock and roll. All references are closed forms of a block or disc with sharp
corners on a plane, but for the tipping, which is integrated.
"""

import numpy as np

import checks

HERE = checks.REPOSITORY / "tests/regression/cases"
G = 9.81
SLOPE = np.radians(20)


def run(case, **variables):
    settings = [f"variables.{name}={value}" for name, value in variables.items()]
    return checks.Run(HERE / f"{case}.yaml", *settings).series(case.split("_")[0])


def block(**variables):
    return run("block_on_floor", **variables)


def stops(report):
    stop = checks.table(HERE / "reference/block_stop.csv")
    for friction, speed, distance, time in zip(stop["mu"], stop["v0"], stop["stop_distance"], stop["stop_time"]):
        b = block(friction=friction, speed=speed, end=time + 0.3)
        x = b["center_x"] - b["center_x"][0]
        stands = b["time"] > time + 0.01
        what = f"block with friction {friction} and {speed} m/s"
        report.check(f"{what}: way less the exact one, of it", x[-1] / distance - 1, -0.005, 0.005, "measured 4e-4")
        stopped = b["time"][np.argmax(b["velocity_x"] < 1e-3 * speed)]
        report.check(f"{what}: time less the exact one, of it", stopped / time - 1, -0.01, 0.01, "rows are 2 ms apart")
        report.check(f"{what}: drifts afterwards [m]", np.ptp(x[stands]), 0, 1e-5, "measured 1e-6")


def slides(report):
    """At 3 % beside the friction that holds it."""
    for factor in (0.97, 1.03):
        b = block(slope=SLOPE, friction=factor * np.tan(SLOPE), end=0.6)
        way = b["center_x"][-1] - b["center_x"][0]
        exact = max(0.0, 0.5 * G * np.sin(SLOPE) * (1 - factor) * 0.6**2)
        report.check(f"on a slope with {factor} of the friction that holds: way less the exact one [m]", way - exact, -1e-4, 2e-3,
                     "it has to settle first")


def tips(report, rows):
    """From rest on the slope."""
    width, height = 0.1, 0.4
    sharp = checks.table(HERE / "reference/block_tipping.csv")
    for row in rows:
        b = block(width=width, height=height, spacing=width / row, slope=SLOPE, friction=2, modulus=1e9, end=0.3)
        report.check(f"tips, {row} spacings wide: angle after 0.3 s less the exact one, of it",
                     -b["angle"][-1] / np.interp(b["time"][-1], sharp["t"], sharp["angle_rad"]) - 1, -0.02, 0.02,
                     "measured 0.012; 0.036 and 0.004 with a tenth and ten times the modulus")


def pushed(report, rows=20):
    """At the height z: it tips first if the friction is above b/(2 z)."""
    width, height = 0.1, 0.2
    spacing = width / rows
    edge = width / (2 * height)
    for factor in (0.97, 1.03):
        b = block(width=width, height=height, spacing=spacing, friction=factor * edge, push=edge * (factor + 1) / 2,
                  push_at=height, modulus=3e7, end=0.4)
        tilt = -b["angle"][-1]
        corner = b["center_x"][-1] + width / 2 * np.cos(tilt) - height / 2 * np.sin(tilt) - width
        report.check(f"pushed at the top, {factor} of the friction at which it tips: turns by", tilt,
                     *((0, 0.005) if factor < 1 else (0.05, 1)))
        report.check(f"pushed at the top, {factor} of the friction at which it tips: slides by [m]", corner,
                     *((0.002, 1) if factor < 1 else (-0.001, 0.002)))


def rocks(report, rows):
    """Stood on its corner by 0.1 rad: one with sharp corners hits the floor after 0.19106 s."""
    for row in rows:
        spacing = 0.2 / row
        b = block(width=0.2, height=0.6, spacing=spacing, friction=2, tilt=0.1, modulus=3e7, end=0.22)
        hit = b["time"][np.argmax(b["angular_velocity"])]
        report.check(f"rocks, {row} spacings wide: first impact less 0.19106 s, of it", hit / 0.19106 - 1, -0.02, 0.02,
                     "rows are 2 ms apart")


def falls(report):
    """Flat, without gravity."""
    for restitution in (0.3, 0.5, 0.7, 0.9, 1):
        b = block(g=0, restitution=restitution, sink=1, modulus=1e7, end=0.01)
        report.check(f"falls flat with restitution {restitution}: less that found", b["velocity_y"][-1] - restitution,
                     -0.005, 0.005, "measured 3e-3 at 0.3")
        report.check("falls flat: turns by", np.abs(b["angle"]).max(), 0, 1e-6)


def rolls(report, rows=20):
    """Down the slope with a = 2/3 g sin; where friction is low it slides; thrown along a floor it ends rolling at 2/3 of
    its speed."""
    radius = 0.05
    rolling = run("disc_on_floor", spacing=radius / rows, slope=SLOPE, end=0.3)
    acceleration = np.polyfit(rolling["time"], rolling["velocity_x"], 1)[0]
    report.check("rolls down: acceleration less the exact one, of it", acceleration / (2 / 3 * G * np.sin(SLOPE)) - 1,
                 -0.005, 0.005, "measured 1e-4")
    slip = rolling["velocity_x"] + radius * rolling["angular_velocity"]
    report.check("rolls down: slips by, of its speed", np.abs(slip[-1]) / rolling["velocity_x"][-1], 0, 0.01)
    steep = np.radians(50)
    sliding = run("disc_on_floor", spacing=radius / rows, slope=steep, friction=0.2, end=0.3)
    acceleration = np.polyfit(sliding["time"], sliding["velocity_x"], 1)[0]
    report.check("slides down: acceleration less the exact one, of it",
                 acceleration / (G * (np.sin(steep) - 0.2 * np.cos(steep))) - 1, -0.01, 0.01)
    spin = -np.polyfit(sliding["time"], sliding["angular_velocity"], 1)[0]
    report.check("slides down: angular acceleration less the exact one, of it",
                 spin / (2 * 0.2 * G * np.cos(steep) / radius) - 1, -0.02, 0.02)
    thrown = run("disc_on_floor", spacing=radius / rows, speed=1, friction=0.3, end=0.2)
    report.check("thrown: speed when it rolls less 2/3, of that", 1.5 * thrown["velocity_x"][-1] - 1, -0.005, 0.005,
                 "measured 4e-4")
    report.check("thrown: speed by its turning less 2/3, of that", -1.5 * radius * thrown["angular_velocity"][-1] - 1,
                 -0.005, 0.005)


def main():
    options = checks.arguments()
    report = checks.Report()
    stops(report)
    slides(report)
    tips(report, (10, 20, 40) if options.long else (10,))
    pushed(report)
    rocks(report, (10, 20, 40) if options.long else (10,))
    falls(report)
    rolls(report)
    report.end()


main()
