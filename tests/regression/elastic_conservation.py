# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""A free elastic block turns five times, cases/spinning_block.yaml: what no force from outside changes.

Pairs of particles act on each other by opposite forces, so linear momentum is kept to rounding. The
stress is symmetric and acts by gradients corrected in the form conjugate to that of the deformation,
so that angular momentum is kept as well. Energy is kept to the order of the step.
"""

import numpy as np

import checks

CASE = checks.REPOSITORY / "tests/regression/cases/spinning_block.yaml"
TURNS = 5
ANGULAR_LIMIT = 1e-10  # of it; measured 1e-13
LINEAR_LIMIT = 1e-12   # of sum m|v|; measured 1e-15
ENERGY_LIMIT = 1e-3    # of the energy; measured 1.7e-4


def main():
    checks.arguments()
    run = checks.Run(CASE)
    momentum, spin, energy = (run.series(name) for name in ("momentum", "spin", "energy"))
    frames = [fields for _, fields in run.frames("block")]
    size = (frames[0]["mass"] * np.linalg.norm(frames[0]["velocity"], axis=1)).sum()

    report = checks.Report()
    # The direction of a line of particles far apart, from frame to frame: no half turn between them.
    turned = 0.0
    for before, after in zip(frames, frames[1:]):
        a, b = (complex(*(f["position"][-1] - f["position"][0])[:2]) for f in (before, after))
        turned += np.angle(b / a)
    report.check("turns", turned / (2 * np.pi), TURNS - 0.5, TURNS + 0.5)
    report.check("strain energy at its largest, of the energy",
                 (energy["internal"] / energy["total"]).max(), 0.05, 1)

    drift = np.abs(spin["angular_momentum"] - spin["angular_momentum"][0]).max()
    report.check("drift of angular momentum, of it", drift / abs(spin["angular_momentum"][0]), 0, ANGULAR_LIMIT)
    for axis in "xy":
        p = momentum[f"momentum_{axis}"]
        report.check(f"drift of momentum along {axis}, of sum m|v|", np.abs(p - p[0]).max() / size, 0, LINEAR_LIMIT)
    drift = np.abs(energy["total"] - energy["total"][0]).max()
    report.check("drift of energy, of it", drift / energy["total"][0], 0, ENERGY_LIMIT)
    report.end()


main()
