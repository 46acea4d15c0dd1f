# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Start-up of plane Couette and Poiseuille flow: closed forms, and the comparison with them.

Morris, Fox & Zhu 1997, doi:10.1006/jcph.1997.5776, (22) and (25). The gap, the density and the
speeds are 1, the viscosity 0.1.
"""

import numpy as np

import checks

VISCOSITY = 0.1
TIMES = (0.1, 0.25, 0.5, 1, 2, 5)
SPACING = 1 / 20
# Of both cases, in units of the largest speed: at L/20 the error is below it, and it falls with the spacing. See the
# tables over spacings in the README.md of the cases.
LIMIT = 0.007


def couette(y, t):
    n = np.arange(1, 400)[:, None]
    terms = 2 / (n * np.pi) * (-1.0) ** n * np.sin(n * np.pi * y)
    return y + np.sum(terms * np.exp(-VISCOSITY * (n * np.pi) ** 2 * t), axis=0)


def poiseuille(y, t):
    force = 8 * VISCOSITY
    m = 2 * np.arange(400)[:, None] + 1
    terms = 4 * force / (VISCOSITY * (np.pi * m) ** 3) * np.sin(np.pi * m * y)
    decaying = np.sum(terms * np.exp(-VISCOSITY * (np.pi * m) ** 2 * t), axis=0)
    return force / (2 * VISCOSITY) * y * (1 - y) - decaying


def profile_error(fields, exact, time, spacing):
    """Largest deviation of a layer's mean velocity, and of a particle's. A layer is one spacing
    thick; each particle is compared at its own place."""
    y = fields["position"][:, 1]
    error = fields["velocity"][:, 0] - exact(y, time)
    layers = np.clip((y / spacing).astype(int), 0, round(1 / spacing) - 1)
    count = np.bincount(layers)
    means = np.bincount(layers, error)[count > 0] / count[count > 0]
    return np.abs(means).max(), np.abs(error).max()


def errors(case, exact, spacing):
    """{time: (error of the layers, of the particles)} at the first frame from each time on."""
    run = checks.Run(f"{case}/case.yaml", f"variables.spacing={spacing!r}")
    found = {}
    for time, fields in run.frames("fluid"):
        for wanted in TIMES:
            if time >= wanted - 1e-9 and wanted not in found:
                found[wanted] = profile_error(fields, exact, time, spacing)
    return found


def check_reference(report, case, name, exact):
    """The series against the stored table, which other code computed."""
    table = checks.reference(case, name)
    worst = max(np.abs(table[f"t{time:g}"] - exact(table["y"], time)).max() for time in TIMES)
    report.check("series less stored table", worst, 0, 1e-6)


def plot(case, table_name, exact, title):
    table = checks.reference(case, table_name)
    run = checks.Run(f"{case}/case.yaml")
    figure, axes = checks.new_plot()
    shown = set()
    for time, fields in run.frames("fluid"):
        for k, wanted in enumerate(TIMES):
            if time >= wanted - 1e-9 and wanted not in shown:
                shown.add(wanted)
                y = np.linspace(0, 1, 201)
                axes.plot(exact(y, time), y, color=f"C{k}", label=f"t = {time:.2f}")
                axes.plot(fields["velocity"][:, 0], fields["position"][:, 1], ".", color=f"C{k}")
    for time in TIMES:
        axes.plot(table[f"t{time:g}"], table["y"], "k+", markersize=4)
    axes.set(xlabel="velocity along the channel", ylabel="y", title=title)
    figure.legend(loc="outside right upper", title="lines: closed form\ndots: particles\n+: stored table", fontsize=8)
    checks.save_plot(figure, case, "profiles.png")


def study(case, exact):
    for spacing in (1 / 10, 1 / 20, 1 / 40):
        found = errors(case, exact, spacing)
        print(f"| 1/{round(1 / spacing)} |", " | ".join(f"{100 * found[t][0]:.2f}" for t in TIMES),
              f"| {100 * max(e[1] for e in found.values()):.2f} |")


def main(case, table_name, exact, title):
    checks.arguments(study=lambda: study(case, exact), plot=lambda: plot(case, table_name, exact, title))
    report = checks.Report()
    check_reference(report, case, table_name, exact)
    found = errors(case, exact, SPACING)
    for time in TIMES:
        layers, particles = found[time]
        report.check(f"error of the profile at {time:g}", layers, 0, LIMIT,
                     f"of single particles {particles:.4f}")
    report.end()
