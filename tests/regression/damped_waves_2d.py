# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Waves of a piston: their height by its stroke, their length, and what a damping zone sends back.

Linear theory of a piston (Biesel 1951): H/S = 4 sinh^2 kh/(sinh 2kh + 2kh), omega^2 = g k tanh kh.
Three gauges, by least squares: eta = a exp(i (omega t - k x)) + b exp(i (omega t + k x)); H = 2 abs(a)
and the reflection abs(b/a). The length of the wave is that of the phases between the gauges; by
the third order of Stokes it is longer than the linear one by 1.0 % at this height.
"""

import numpy as np

import checks

STROKE, PERIOD, DEPTH, GRAVITY = 0.05647, 1.2, 0.5, 9.81
GAUGES = np.array([1.8, 2.0, 2.25])
OMEGA = 2 * np.pi / PERIOD
LAST_PERIODS = 4

# Measured: README.md.
HEIGHT_LIMIT = 0.06
LENGTH_LIMIT = 0.02
REFLECTION_LIMIT = 0.05
WITHOUT_ZONE_LIMIT = 0.6


def wave_number():
    k = OMEGA**2 / GRAVITY
    for _ in range(100):
        k = 0.5 * (k + OMEGA**2 / (GRAVITY * np.tanh(k * DEPTH)))
    return k


NUMBER = wave_number()
HEIGHT = STROKE * 4 * np.sinh(NUMBER * DEPTH) ** 2 / (np.sinh(2 * NUMBER * DEPTH) + 2 * NUMBER * DEPTH)


def amplitudes(series):
    """Complex, of exp(i omega t) at each gauge over the last periods, beside a mean and the harmonic."""
    t = series["time"]
    last = t > t[-1] - LAST_PERIODS * PERIOD
    phase = OMEGA * t[last]
    modes = np.array([np.ones_like(phase), np.cos(phase), np.sin(phase), np.cos(2 * phase), np.sin(2 * phase)]).T
    elevations = np.array([series[f"elevation_{gauge}"][last] for gauge in range(len(GAUGES))]).T
    fitted = np.linalg.lstsq(modes, elevations, rcond=None)[0]
    return fitted[1] - 1j * fitted[2]


def measure(parts_of_depth, *settings):
    run = checks.Run("damped_waves_2d/case.yaml", f"variables.spacing=depth/{parts_of_depth}",
                     "outputs.fields.every={time: 100}", *settings)
    series = run.series("elevation")
    found = amplitudes(series)
    waves = np.array([np.exp(-1j * NUMBER * GAUGES), np.exp(1j * NUMBER * GAUGES)]).T
    there, back = np.linalg.lstsq(waves, found, rcond=None)[0]
    number = -np.polyfit(GAUGES, np.unwrap(np.angle(found)), 1)[0]
    return {"series": series, "height": 2 * abs(there) / HEIGHT - 1, "length": NUMBER / number - 1,
            "reflection": abs(back / there)}


def study():
    for parts in (20, 30, 40):
        found = measure(parts)
        print(f"| H/{HEIGHT / DEPTH * parts:.1f} | {100 * found['height']:+.1f} | {100 * found['length']:+.1f} | "
              f"{100 * found['reflection']:.1f} |", flush=True)
    for strength in (0, 2, 30):
        found = measure(20, f"variables.strength={strength}", "loop.end_time=16")
        print(f"rate {strength}/s: {100 * found['height']:+.1f} {100 * found['reflection']:.1f}", flush=True)


def plot():
    series = measure(30)["series"]
    figure, axes = checks.new_plot(8, 3.6)
    axes.plot(series["time"], series["elevation_1"] - DEPTH, "-", label="surface at x = 2 m")
    # Stokes' second order.
    kh = NUMBER * DEPTH
    harmonic = NUMBER * HEIGHT**2 * np.cosh(kh) * (2 + np.cosh(2 * kh)) / (16 * np.sinh(kh) ** 3)
    for level in (HEIGHT / 2 + harmonic, -HEIGHT / 2 + harmonic):
        axes.axhline(level, color="k", linewidth=0.8, linestyle="--")
    axes.set(xlabel="t [s]", ylabel="elevation [m]",
             title="Waves of a piston; dashed: crest and trough of the second order for Biesel's height")
    axes.legend(loc="lower left")
    checks.save_plot(figure, "damped_waves_2d", "elevation.png")


def check_table(report):
    """What the paddle does is what the case says."""
    rows = np.genfromtxt(checks.CASES / "damped_waves_2d" / "paddle.csv", delimiter=",", skip_header=2)
    t = rows[:, 0]
    ramp = np.where(t < 2 * PERIOD, (1 - np.cos(np.pi * t / (2 * PERIOD))) / 2, 1)
    off = rows[:, 1] - 1000 * STROKE / 2 * ramp * np.sin(OMEGA * t)
    report.check("rows of the table of the paddle less the formula, mm", np.abs(off).max(), 0, 1e-5)


def main():
    options = checks.arguments(study=study, plot=plot)
    report = checks.Report()
    check_table(report)
    found = measure(30 if options.long else 20)
    report.check("height of the waves less that of theory, of it", found["height"], -HEIGHT_LIMIT, HEIGHT_LIMIT)
    report.check("length of the waves less that of theory, of it", found["length"], -LENGTH_LIMIT, LENGTH_LIMIT)
    report.check("reflection of the zone", found["reflection"], 0, REFLECTION_LIMIT)
    if options.long:
        without = measure(20, "variables.strength=0", "loop.end_time=16")
        report.check("reflection without the zone", without["reflection"], WITHOUT_ZONE_LIMIT, 1.5)
    report.end()


if __name__ == "__main__":
    main()
