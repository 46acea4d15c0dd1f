# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Elliptical drop: its axes, by the second moments of the mass, its area and its energy.

Monaghan 1994, doi:10.1006/jcph.1994.1034: an inviscid, incompressible drop stays an ellipse with
semi-axes a and b,
    dA/dt = A^2 (a^2 - b^2)/(a^2 + b^2),  da/dt = -A a,  db/dt = A b,
a the one that grows, A = -100/s and a = b = 1 m at the start.
"""

import numpy as np

import checks

# Measured at R/20, R/40 and R/80: README.md.
AXIS_LIMIT = 0.0025
AREA_LIMIT = 0.0025
ENERGY_LIMIT = 5e-4


def exact(end, steps=2000):
    """A, a, b at a time, by the classical Runge-Kutta method (error below 1e-9)."""
    def rate(z):
        big, a, b = z
        return np.array([big**2 * (a**2 - b**2) / (a**2 + b**2), -big * a, big * b])

    z, dt = np.array([-100.0, 1.0, 1.0]), end / steps
    for _ in range(steps):
        k1 = rate(z)
        k2 = rate(z + dt / 2 * k1)
        k3 = rate(z + dt / 2 * k2)
        k4 = rate(z + dt * k3)
        z = z + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    return z


def axes_of(fields):
    """Semi-axes of the ellipse with the second moments of the particles, the shorter first."""
    m = fields["mass"] / fields["mass"].sum()
    x = fields["position"][:, :2]
    x = x - m @ x
    return 2 * np.sqrt(np.linalg.eigvalsh((m[:, None] * x).T @ x))


def measure(spacing):
    run = checks.Run("elliptical_drop_2d/case.yaml", f"variables.spacing={spacing!r}")
    history = [(time, *axes_of(fields)) for time, fields in run.frames("drop")]
    time, short, long = history[-1]
    _, a, b = exact(time)
    energy = run.series("energy")["kinetic"]
    return {"history": np.array(history), "time": time, "short": short / b - 1, "long": long / a - 1,
            "area": short * long / (a * b) - 1, "energy": 1 - energy[-1] / energy[0]}


def study():
    for cells in (20, 40, 80):
        found = measure(1 / cells)
        print(f"| 1/{cells} |", " | ".join(
            f"{100 * found[key]:+.2f}" for key in ("long", "short", "area", "energy")), "|")


def plot():
    found = measure(1 / 40)
    table = checks.reference("elliptical_drop_2d", "elliptical_drop.csv")
    inside = table["t"] < 0.0081
    figure, axes = checks.new_plot()
    axes.plot(1e3 * table["t"][inside], table["a"][inside], "k-", label="closed form")
    axes.plot(1e3 * table["t"][inside], table["b"][inside], "k-")
    t, short, long = found["history"].T
    axes.plot(1e3 * t, long, "o", label="long semi-axis")
    axes.plot(1e3 * t, short, "s", label="short semi-axis")
    axes.set(xlabel="t [ms]", ylabel="semi-axis [m]", title="Elliptical drop, spacing R/40")
    axes.legend()
    checks.save_plot(figure, "elliptical_drop_2d", "axes.png")


def main():
    checks.arguments(study=study, plot=plot)
    found = measure(1 / 40)
    report = checks.Report()
    table = checks.reference("elliptical_drop_2d", "elliptical_drop.csv")
    row = np.argmin(np.abs(table["t"] - 0.0076))
    report.check("ours less the stored solution", abs(exact(table["t"][row])[1] - table["a"][row]), 0, 1e-6)
    report.check("long axis less the solution, of it", found["long"], -AXIS_LIMIT, AXIS_LIMIT)
    report.check("short axis less the solution, of it", found["short"], -AXIS_LIMIT, AXIS_LIMIT)
    report.check("area less the solution, of it", found["area"], -AREA_LIMIT, AREA_LIMIT)
    report.check("loss of kinetic energy", found["energy"], -ENERGY_LIMIT, ENERGY_LIMIT)
    report.end()


main()
