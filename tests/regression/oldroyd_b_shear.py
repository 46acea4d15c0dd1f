# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Steady simple shear of an Oldroyd-B fluid: tau_xy = eta_p gamma, tau_xx = 2 eta_p lambda gamma^2."""

import numpy as np

import checks

POLYMER, SOLVENT = 0.5, 0.5
PATH = "../tests/regression/cases/oldroyd_b_shear.yaml"


def measure(weissenberg, spacing=1 / 20):
    run = checks.Run(PATH, f"variables.weissenberg={weissenberg}", f"variables.spacing={spacing!r}")
    least = np.inf
    for _, fields in run.frames("fluid"):
        c = fields["conformation"].reshape(len(fields["position"]), -1)
        width = 3 if c.shape[1] == 9 else 2
        c = c.reshape(-1, width, width)[:, :2, :2]
        least = min(least, np.linalg.eigvalsh(c).min())
    # Means over rows of particles: single ones near a wall differ from them by a tenth, by the sound
    # that runs along the rows.
    n = round(1 / spacing)
    at = np.clip((fields["position"][:, 1] / spacing).astype(int), 0, n - 1)
    rows = np.bincount(at, minlength=n)
    c = np.stack([[np.bincount(at, c[:, a, b], minlength=n) / rows for b in range(2)] for a in range(2)]).transpose(2, 0, 1)
    modulus = POLYMER / weissenberg
    xx = modulus * (c[:, 0, 0] - 1) / (2 * POLYMER * weissenberg) - 1
    xy = modulus * c[:, 0, 1] / POLYMER - 1
    speed = fields["velocity"][:, 0] - fields["position"][:, 1]
    drag = run.series("drag")
    return xx, xy, speed, least, drag


def study():
    for spacing in (1 / 10, 1 / 20, 1 / 40):
        for weissenberg in (0.5, 2, 5):
            xx, xy, speed, least, _ = measure(weissenberg, spacing)
            print(f"| 1/{round(1 / spacing)} | {weissenberg} | {100 * np.abs(xx).max():.2f} | {100 * np.abs(xy).max():.2f} | "
                  f"{100 * np.abs(speed).max():.2f} | {least:.4f} |", flush=True)


checks.arguments(study=study)
report = checks.Report()
for weissenberg in (0.5, 2, 5):
    xx, xy, speed, least, drag = measure(weissenberg)
    report.check(f"tau_xx at Weissenberg number {weissenberg}, worst of all rows", np.abs(xx).max(), 0, 0.02)
    # At 5 sound along the rows of the lower wall, under the tension of 50 moduli, disturbs it more.
    report.check("tau_xy", np.abs(xy).max(), 0, 0.02 if weissenberg < 5 else 0.04)
    report.check("velocity", np.abs(speed).max(), 0, 0.02)
    # Exactly 0.5 to 0.7 in the steady flow; single particles see less.
    report.check("least eigenvalue of the conformation", least, 0.1, 1.001)
report.end()
