# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Oscillating plate: period and amplitude of its tip for both clamps, and its energy.

References are finite elements of second order of the same law and the same clamps, refined until they
had converged: README.md of the case. The thin plate of theory has a period of 0.2540 s. The period is the
time of the second return through rest, the amplitude is the first maximum.
"""

import beam
import checks

REFERENCE = {"case": (0.2627, 0.1089), "ideal": (0.2548, 0.1065)}
CLAMP = {"case": "insert", "ideal": "ideal"}

# Errors of period and amplitude at H/10 and H/20, README.md: insert +1.6 % and +1.3 %, +0.6 % and
# +0.5 %; ideal +0.9 % and +0.9 %, +0.3 % and +0.3 %.
PERIOD_LIMIT = {("case", 10): 0.02, ("ideal", 10): 0.012, ("case", 20): 0.009, ("ideal", 20): 0.005}
AMPLITUDE_LIMIT = {("case", 10): 0.017, ("ideal", 10): 0.012, ("case", 20): 0.008, ("ideal", 20): 0.005}
# Of all energy, in five periods; measured 2e-5 at H/5, 5e-6 at H/10.
ENERGY_LIMIT = 1e-4


def measure(name, across, end=0.3):
    run = checks.Run(f"oscillating_plate_2d/{name}.yaml", f"variables.spacing=thickness/{across}",
                     "outputs.fields.every={time: 10}", f"loop.end_time={end}")
    t, u = beam.tip(run)
    return {"t": t, "y": u[:, 1], "period": beam.zeros(t, u[:, 1])[1],
            "amplitude": beam.extremes(t, u[:, 1])[1][0],
            "energy": beam.energy_change(run)}


def plot():
    figure, axes = checks.new_plot(8, 4)
    for name, clamp in CLAMP.items():
        reference = checks.reference("oscillating_plate_2d", f"tip_{clamp}.csv")
        [drawn] = axes.plot(reference["t"], 100 * reference["uy"], "--", label=f"finite elements, {clamp} clamp")
        found = measure(name, 10, 0.6)
        axes.plot(found["t"], 100 * found["y"], "-", color=drawn.get_color(), label=f"H/10, {clamp} clamp")
    axes.set(xlabel="t [s]", ylabel="tip [cm]", xlim=(0, 0.6), title="Oscillating plate")
    axes.legend(loc="lower left", fontsize="small", ncols=2)
    checks.save_plot(figure, "oscillating_plate_2d", "tip.png")


def main():
    options = checks.arguments(plot=plot)
    report = checks.Report()
    for name, (period, amplitude) in REFERENCE.items():
        if options.study:
            rows = {}
            for across in (5, 10, 20):
                found = measure(name, across)
                rows[across] = found["period"], found["amplitude"]
            print(CLAMP[name])
            beam.study(rows, (period, amplitude))
            continue
        across = 20 if options.long else 10
        found = measure(name, across)
        limit = PERIOD_LIMIT[name, across]
        report.check(f"{CLAMP[name]} clamp: period less reference, of it", found["period"] / period - 1,
                     -limit, limit)
        limit = AMPLITUDE_LIMIT[name, across]
        report.check(f"{CLAMP[name]} clamp: amplitude less reference, of it",
                     found["amplitude"] / amplitude - 1, -limit, limit)
    if not options.study:
        energy = measure("case", 10 if options.long else 5, 1.4)["energy"]
        report.check("largest change of the energy in five periods, of it", energy, 0, ENERGY_LIMIT)
    report.end()


main()
