# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Elastic bodies in water at the default steps, as users have them: cases/elastic_baffle.yaml, a baffle of 1 and 10 MPa in
a tank that is shaken, and cases/light_stiff_float.yaml, a free box of a tenth and of half the water's density. Before the
fluid answered motions within its steps the first inverted, the second shook the water to 29 m/s
(engine/dynamics/fsi/README.md).
"""

import numpy as np

import checks

HERE = checks.REPOSITORY / "tests/regression/cases"
QUIET = "outputs.{}.every={{time: 100}}"


def baffle(modulus, end):
    run = checks.Run(HERE / "elastic_baffle.yaml", f"materials.rubber.youngs_modulus={modulus}", f"loop.end_time={end}",
                     "outputs.tip.every={time: 0.002}", QUIET.format("fields"))
    tip = run.series("tip")
    name = next(name for name in tip if name.startswith("displacement") and name.endswith("x"))
    sway = tip[name]
    # What neighbors in time do not explain: chatter.
    return np.abs(sway).max(), np.sqrt(((sway[2:] - 2 * sway[1:-1] + sway[:-2])**2).mean())


def main():
    options = checks.arguments()
    report = checks.Report()
    end = 6 if options.long else 1.5
    for modulus, largest in (1e6, 0.03), (1e7, 0.006):
        sway, chatter = baffle(modulus, end)
        report.check(f"baffle of {modulus:g} Pa: sways by, m", sway, 1e-4, largest)
        report.check(f"baffle of {modulus:g} Pa: chatter, m", chatter, 0, 2e-4)
    for density in 100, 500:
        run = checks.Run(HERE / "light_stiff_float.yaml", f"variables.rho_box={density}", "loop.end_time=1",
                         QUIET.format("f"))
        kinetic = run.series("e")["kinetic"]
        report.check(f"box of {density} kg/m3: largest kinetic energy, J", kinetic.max(), 0, 1)
        report.check(f"box of {density} kg/m3: kinetic energy in the last tenth, J", kinetic[-3:].mean(), 0, 0.05)
    report.end()


if __name__ == "__main__":
    main()
