# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""An Oldroyd-B fluid in a throat: how its flow rate differs from the Newtonian one of the same steady
viscosity, that the flow is symmetric about the axis, and that the conformation stays positive."""

import numpy as np

import checks

CASE = "oldroyd_b_throat_2d"
SPACING = 1 / 20
LENGTH, THROAT = 4.0, 0.5
# So short a time that the polymers are but a viscosity.
RATIO = 1.06  # measured at L/20
NEWTONIAN = "variables.relaxation_time=0.005"


def flow(run):
    """Flow rate, the mean over the last second."""
    series = run.series("momentum")
    name = next(key for key in series if key.endswith("_x") or key.endswith("x"))
    late = series["time"] > series["time"][-1] - 1
    return series[name][late].mean() / LENGTH


def throat_profile(fields, spacing):
    """Means of the velocity along the channel over layers in the throat."""
    x, u = fields["position"], fields["velocity"][:, 0]
    inside = np.abs(x[:, 0] - 0.5 * LENGTH) < 0.5 * THROAT
    at = np.clip(((x[inside, 1] - 0.5 + 0.5 * THROAT) / spacing).astype(int), 0, round(THROAT / spacing) - 1)
    return np.bincount(at, u[inside]) / np.bincount(at)


def measure(*settings, spacing=SPACING):
    """Flow rate; asymmetry of the profile in the throat, mean of the frames from t = 3 on, by the largest
    speed; least eigenvalue and largest stretch of the conformation."""
    run = checks.Run(f"{CASE}/case.yaml", f"variables.spacing={spacing!r}", *settings)
    least, profiles = np.inf, []
    for time, fields in run.frames("fluid"):
        c = fields["conformation"].reshape(len(fields["position"]), -1)
        width = 3 if c.shape[1] == 9 else 2
        c = c.reshape(-1, width, width)[:, :2, :2]
        least = min(least, np.linalg.eigvalsh(c).min())
        if time >= 3:
            profiles.append(throat_profile(fields, spacing))
    mean = np.mean(profiles, axis=0)
    return flow(run), np.abs(mean - mean[::-1]).max() / mean.max(), least, c[:, 0, 0].max()


def study():
    for spacing in (1 / 10, 1 / 20, 1 / 40):
        newtonian = measure(NEWTONIAN, spacing=spacing)
        rate, skew, least, stretch = measure(spacing=spacing)
        print(f"| 1/{round(1 / spacing)} | {newtonian[0]:.4f} | {rate:.4f} | {100 * (rate / newtonian[0] - 1):+.1f} | {100 * skew:.2f} | "
              f"{stretch:.1f} | {least:.3f} |", flush=True)


checks.arguments(study=study)
report = checks.Report()
newtonian, _, _, _ = measure(NEWTONIAN)
rate, skew, least, stretch = measure()
report.check("flow rate by the Newtonian one", rate / newtonian, RATIO - 0.03, RATIO + 0.03,
             f"{rate:.4f} and {newtonian:.4f}")
report.check("asymmetry in the throat, by the largest speed", skew, 0, 0.03)
report.check("least eigenvalue of the conformation", least, 1e-6, 1)
report.check("largest stretch c_xx", stretch, 2, 200)
report.end()
