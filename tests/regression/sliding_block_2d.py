# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Block on a slope of 30 degrees: s = g/2 (sin - mu cos) t^2 where it slides, that is for mu below tan 30 = 0.577."""

import numpy as np

import checks

CASE = "sliding_block_2d"
SLOPE, SPACING = np.radians(30), 0.01


def way(friction, *settings):
    block = checks.Run(f"{CASE}/case.yaml", f"variables.friction={friction}", "outputs.frames.every={time: 10}",
                       *settings).series("block")
    shift = np.array([block[f"center_{c}"] - block[f"center_{c}"][0] for c in "xy"])
    return block["time"], np.array([np.cos(SLOPE), -np.sin(SLOPE)]) @ shift


def exact(friction, t):
    return max(0.0, 0.5 * 9.81 * (np.sin(SLOPE) - friction * np.cos(SLOPE))) * t**2


def plot():
    reference = checks.reference(CASE, "sliding_block.csv")
    figure, axes = checks.new_plot()
    for friction in (0, 0.2, 0.4, 0.6):
        [drawn] = axes.plot(*way(friction), label=f"$\\mu$ = {friction}")
        axes.plot(reference["t"], reference[f"mu{friction}".replace(".", "p")], "o", color=drawn.get_color())
    axes.set(xlabel="t [s]", ylabel="way down the slope [m]")
    axes.legend(title="lines: particles, points: closed form")
    checks.save_plot(figure, CASE, "way.png")


def main():
    checks.arguments(plot=plot)
    report = checks.Report()
    reference = checks.reference(CASE, "sliding_block.csv")
    for friction, limit in ((0, 0.001), (0.2, 0.002), (0.4, 0.01)):
        t, s = way(friction)
        late = t > 0.2
        report.check(f"friction {friction}: way less the exact one, of it, largest",
                     np.abs(s[late] / exact(friction, t[late]) - 1).max(), 0, limit)
        same = np.abs(exact(friction, reference["t"]) - reference[f"mu{friction}".replace(".", "p")]).max()
        report.check(f"friction {friction}: the table less the formula [m]", same, 0, 1e-6)
    t, s = way(0.6)
    report.check("friction 0.6: settles by, in spacings", s[-1] / SPACING, 0, 0.01, "measured 0.003")
    report.check("friction 0.6: creeps from 0.2 s on, in spacings a second", np.ptp(s[t > 0.2]) / 0.8 / SPACING, 0, 1e-3)
    report.end()


main()
