# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""How far an elastic block that falls on a rigid floor goes into it at a tenth of its speed of sound, flat and on corners at
angles to its lattice, whether its energy rises, and that one which stands there at rest stays; cases/block_hits_floor.yaml.
"""

import numpy as np

import checks

CASE = checks.REPOSITORY / "tests/regression/cases/block_hits_floor.yaml"


def hit(spacing, angle, *settings):
    """How far the lowest particle is below the floor, in spacings, rise of the energy of that at first, and the run."""
    turn = np.radians(angle)
    low = 0.5 * (np.sin(turn) + np.cos(turn)) + (spacing if angle else 0)
    run = checks.Run(CASE, f"variables.spacing={spacing}", f"variables.turn={turn}", f"variables.low={low}", *settings)
    lowest = min(fields["position"][:, 1].min() for _, fields in run.frames("block"))
    energy = run.series("energy")["total"]
    return -lowest / spacing, energy.max() / energy[0] - 1, run


def study():
    for angle in 0, 3, 10, 20, 30, 45:
        for spacing in (0.1, 0.05, 0.025):
            for settings in [], ["dynamics.contact_dt.cfl=0.1"]:
                deep, rise, _ = hit(spacing, angle, "loop.end_time=14", *settings)
                print(f"| {angle} | {1 / spacing:.0f} | {settings} | {deep:.2f} | {rise:.1e} |", flush=True)


def main():
    options = checks.arguments(study=study)
    report = checks.Report()
    for spacing in (0.1, 0.05, 0.025) if options.long else (0.05,):
        deep, rise, _ = hit(spacing, 0)
        report.check(f"{1 / spacing:.0f} spacings, flat: outermost row, below the floor by, in spacings", deep, -0.5, 0)
        report.check(f"{1 / spacing:.0f} spacings, flat: rise of the energy, of it", rise, -1, 1e-4)
        for angle in (10, 30, 45) if options.long else (45,):
            deep, rise, _ = hit(spacing, angle, "loop.end_time=14", "dynamics.contact_dt.cfl=0.1")
            what = f"{1 / spacing:.0f} spacings, on a corner at {angle} degrees"
            report.check(f"{what}: lowest particle, below the floor by, in spacings", deep, -0.5, 0.3)
            report.check(f"{what}: rise of the energy, of it", rise, -1, 5e-4)
    # Weight of a thousandth of the modulus at its foot.
    _, _, run = hit(0.05, 0, "variables.speed=0", "dynamics.gravity.acceleration=[0, -1e-3]", "loop.end_time=20")
    sunk = [fields["position"][:, 1].min() for _, fields in run.frames("block")]
    report.check("at rest: moves by, in spacings", np.ptp(sunk) / 0.05, 0, 0.1)
    report.end()


if __name__ == "__main__":
    main()
