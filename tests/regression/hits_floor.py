# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""How far an elastic block that falls flat on a rigid floor goes into it at a tenth of its speed of sound, and that one which
stands on it at rest stays there; cases/block_hits_floor.yaml. With --study also on its corner.
"""

import numpy as np

import checks

CASE = checks.REPOSITORY / "tests/regression/cases/block_hits_floor.yaml"


def hit(spacing, corner, *settings):
    """By how many spacings the lowest particle goes down, rise of the energy of that at first, and the run."""
    turn, low = (np.pi / 4, np.sqrt(0.5)) if corner else (0, 0.5)
    run = checks.Run(CASE, f"variables.spacing={spacing}", f"variables.turn={turn}", f"variables.low={low}", *settings)
    lowest = np.array([fields["position"][:, 1].min() for _, fields in run.frames("block")])
    energy = run.series("energy")["total"]
    return (lowest[0] - lowest.min()) / spacing, energy.max() / energy[0] - 1, run


def study():
    for spacing in (0.1, 0.05, 0.025):
        for corner in False, True:
            deep, rise, _ = hit(spacing, corner)
            print(f"| {'corner' if corner else 'flat'} | {1 / spacing:.0f} | {deep:.2f} | {rise:.1e} |", flush=True)


def main():
    options = checks.arguments(study=study)
    report = checks.Report()
    for spacing in (0.1, 0.05, 0.025) if options.long else (0.05,):
        deep, rise, _ = hit(spacing, False)
        report.check(f"{1 / spacing:.0f} spacings: goes into the floor by, in spacings", deep, 0, 0.5, "measured 0.08")
        report.check(f"{1 / spacing:.0f} spacings: rise of the energy, of it", rise, -1, 1e-4)
    # Weight of a thousandth of the modulus at its foot.
    _, _, run = hit(0.05, False, "variables.speed=0", "dynamics.gravity.acceleration=[0, -1e-3]", "loop.end_time=20")
    sunk = [fields["position"][:, 1].min() for _, fields in run.frames("block")]
    report.check("at rest: moves by, in spacings", np.ptp(sunk) / 0.05, 0, 0.1)
    report.end()


if __name__ == "__main__":
    main()
