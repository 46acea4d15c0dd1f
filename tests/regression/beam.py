# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""What the tests of elastic beams share: the tip, values at rest, periods, extrapolation."""

import numpy as np


def tip(run, field="displacement", components="xy"):
    """(times, values) at the end of a beam.

    An observer tells means over the particles around its points, which next to a surface stand to one
    side. The points of these cases lie four and two spacings inside, where such a mean is exact for
    linear fields; the end, free of bending, is on the line through both.
    """
    series = run.series("tip")
    return series["time"], np.array(
        [2 * series[f"{field}_1_{c}"] - series[f"{field}_0_{c}"] for c in components]).T


def at_rest(t, values, period):
    """Values without the swing of the given period, from the last one: mean, cosine, sine fitted.

    Returns the means and the amplitude of the swing of the last component.
    """
    last = t >= t[-1] - period
    phase = 2 * np.pi * t[last] / period
    basis = np.array([np.ones_like(phase), np.cos(phase), np.sin(phase)]).T
    found = np.linalg.lstsq(basis, values[last], rcond=None)[0]
    return found[0], np.hypot(found[1], found[2])[-1]


def extremes(t, x):
    """(times, values) of the interior maxima and minima of a smooth curve, each by a parabola."""
    inside = np.flatnonzero((x[1:-1] - x[:-2]) * (x[2:] - x[1:-1]) < 0) + 1
    times, values = [], []
    for k in inside:
        p = np.polyfit(t[k - 1:k + 2] - t[k], x[k - 1:k + 2], 2)
        times.append(t[k] - p[1] / (2 * p[0]))
        values.append(p[2] - p[1] ** 2 / (4 * p[0]))
    return np.array(times), np.array(values)


def zeros(t, x):
    """Times at which a curve changes its sign, the start left out."""
    k = np.flatnonzero(x[1:-1] * x[2:] <= 0) + 1
    return t[k] - x[k] * (t[k + 1] - t[k]) / (x[k + 1] - x[k])


def energy_change(run):
    """Largest change of all energy since the start, of it."""
    energy = run.series("energy")["total"]
    return abs(energy / energy[0] - 1).max()


def compare(axes, reference, found, label, components="xy", column="u{}", scale=1):
    """Draws each component of the tip, and beside it that of a column of the reference."""
    for k, c in enumerate(components):
        [drawn] = axes.plot(reference["t"], scale * reference[column.format(c)], "--",
                            label=f"finite elements, {c}")
        axes.plot(found["t"], scale * found["u"][:, k], "-", color=drawn.get_color(), label=f"{label}, {c}")


def extrapolated(across, values):
    """(order p, limit f) of f + c h^p through values at three h = 1/across: Richardson."""
    h = 1 / np.array(across, dtype=float)
    coarse, middle, fine = values
    ratio = (coarse - middle) / (middle - fine)

    def excess(p):
        return (h[0] ** p - h[1] ** p) / (h[1] ** p - h[2] ** p) - ratio

    low, high = 0.1, 8.0
    if not excess(low) < 0 < excess(high):
        return float("nan"), float("nan")
    for _ in range(60):
        p = (low + high) / 2
        low, high = (p, high) if excess(p) < 0 else (low, p)
    return p, fine + (fine - middle) / (h[1] ** p - h[2] ** p) * h[2] ** p


def study(rows, references):
    """Prints the table of a README: rows are {particles across: values}, three, coarse to fine."""
    def cells(values):
        return " | ".join(f"{v:.4g} ({100 * (v / r - 1):+.1f} %)" for v, r in zip(values, references))

    for across, values in rows.items():
        print(f"| H/{across} | {cells(values)} |")
    found = [extrapolated(list(rows), column) for column in zip(*rows.values())]
    print(f"| extrapolated | {cells([limit for _, limit in found])} |")
    print(f"| order | {' | '.join(f'{order:.1f}' for order, _ in found)} |", flush=True)
