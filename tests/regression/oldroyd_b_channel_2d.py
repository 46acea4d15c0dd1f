# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Start-up of plane Poiseuille flow of an Oldroyd-B fluid against its closed form.

Waters & King 1970, doi:10.1007/BF01975401, by the stored tables and by the series; in the steady flow
tau_xx = 2 eta_p lambda gamma^2.
"""

import numpy as np

import checks

CASE = "oldroyd_b_channel_2d"
SPACING = 1 / 40
TIMES = (0.1, 0.2, 0.4, 0.6, 1, 2, 5)
SOLVENT, LAMBDA = 0.1, 1.0


def velocity(y, time):
    """Of the series; rho = eta_s + eta_p = 1, force 8."""
    n = (2 * np.arange(200) + 1)[:, None] * np.pi
    alpha = 1 + SOLVENT * n**2 * LAMBDA
    beta = np.sqrt((alpha**2 - 4 * n**2 * LAMBDA).astype(complex))
    gamma = 1 + (SOLVENT - 2) * n**2 * LAMBDA
    t = time / LAMBDA / 2
    # exp(-alpha t) (cosh(beta t) + gamma/beta sinh(beta t)), of which neither part overflows.
    up, down = np.exp((beta - alpha) * t), np.exp((-beta - alpha) * t)
    fading = 0.5 * ((up + down) + gamma / beta * (up - down)).real
    return 4 * y * (1 - y) - np.sum(32 * np.sin(n * y) / n**3 * fading, axis=0)


def layer_means(fields, values, spacing):
    n = round(1 / spacing)
    at = np.clip((fields["position"][:, 1] / spacing).astype(int), 0, n - 1)
    return np.bincount(at, values, minlength=n) / np.maximum(np.bincount(at, minlength=n), 1)


def tension(fields):
    """tau_xx of the particles."""
    c = fields["conformation"].reshape(len(fields["position"]), -1)
    return (1 - SOLVENT) / LAMBDA * (c[:, 0] - 1)


def measure(spacing, end=12):
    """Errors of layers at the times, by the largest speed so far of the flow; the course of the speed on
    the centre line; the error of tau_xx over the last two units of time, by the largest."""
    run = checks.Run(f"{CASE}/case.yaml", f"variables.spacing={spacing!r}", f"loop.end_time={end}")
    errors, course, stresses, positive = {}, [], [], np.inf
    for time, fields in run.frames("fluid"):
        y, u = fields["position"][:, 1], fields["velocity"][:, 0]
        error = np.abs(layer_means(fields, u - velocity(y, time), spacing)).max()
        for wanted in TIMES:
            if time >= wanted - 1e-9 and wanted not in errors:
                errors[wanted] = error
        middle = np.abs(y - 0.5) < 0.75 * spacing
        course.append((time, (u[middle] + velocity(0.5, time) - velocity(y[middle], time)).mean(), error))
        if time >= end - 2:
            wanted = 2 * (1 - SOLVENT) * LAMBDA * (4 * (1 - 2 * y)) ** 2
            stresses.append(layer_means(fields, tension(fields) - wanted, spacing))
        c = fields["conformation"].reshape(len(y), -1)
        width = 3 if c.shape[1] == 9 else 2
        c = c.reshape(-1, width, width)[:, :2, :2]
        positive = min(positive, np.linalg.eigvalsh(c).min())
    stress = np.abs(np.mean(stresses, axis=0)).max() / (2 * (1 - SOLVENT) * LAMBDA * 16)
    return errors, np.array(course), stress, positive


def peak(course):
    """Of the speed on the centre line: parabola through the largest and its neighbors."""
    k = int(np.argmax(course[:, 1]))
    a, b, c = np.polyfit(course[k - 1 : k + 2, 0] - course[k, 0], course[k - 1 : k + 2, 1], 2)
    return course[k, 0] - b / (2 * a), c - b * b / (4 * a)


def study():
    for spacing in (1 / 10, 1 / 20, 1 / 40):
        errors, course, stress, positive = measure(spacing)
        time, speed = peak(course)
        print(f"| 1/{round(1 / spacing)} |", " | ".join(f"{100 * errors[t]:.2f}" for t in TIMES),
              f"| {speed:.3f} at {time:.3f} | {course[-1, 1]:.4f} | {100 * stress:.2f} | {positive:.3f}", flush=True)


def plot():
    _, course, _, _ = measure(SPACING)
    table = checks.reference(CASE, "startup_centre.csv")
    figure, axes = checks.new_plot()
    t = np.linspace(0, 12, 1201)
    axes.plot(t, [velocity(np.array([0.5]), time)[0] for time in t], label="closed form")
    axes.plot(course[::5, 0], course[::5, 1], ".", label="particles, spacing 1/40")
    axes.plot(table["t"][::10], table["A"][::10], "k+", markersize=4, label="stored table")
    axes.set(xlabel="t", ylabel="velocity on the centre line", title="Start-up of an Oldroyd-B fluid")
    axes.legend()
    checks.save_plot(figure, CASE, "start_up.png")


def main():
    options = checks.arguments(study=study, plot=plot)
    report = checks.Report()
    table = checks.reference(CASE, "startup_profiles.csv")
    worst = max(np.abs(table[f"t{time:g}"] - velocity(table["y"], time)).max() for time in TIMES)
    report.check("series less stored table", worst, 0, 1e-4)
    spacing = SPACING if options.long else 1 / 20
    errors, course, stress, positive = measure(spacing)
    for time in TIMES:
        report.check(f"error of the profile at {time}", errors[time], 0, 0.02)
    time, speed = peak(course)
    report.check("largest speed on the centre line", speed / 2.845, 0.98, 1.02)
    report.check("its time", time, 0.50, 0.54)
    report.check("steady speed on the centre line", course[-1, 1], 0.985, 1.015)
    report.check("error of the steady tau_xx, by the largest", stress, 0, 0.04)
    report.check("least eigenvalue of the conformation", positive, 1e-6, 1)
    report.end()


main()
