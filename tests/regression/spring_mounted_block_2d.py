# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Block on a spring and a dashpot, pushed for a while, against the oscillator of one degree of freedom.

After a force sets in, u = F/k (1 - exp(-z w t) (cos w' t + z w/w' sin w' t)), w^2 = k/m, w'^2 =
w^2 (1 - z^2); when it ends, the same is taken away again. What spring, dashpot and force exert together
is F - k u - 2 z k/w u'.
"""

import numpy as np

import checks

CASE = "spring_mounted_block_2d"
PERIOD, RATIO, DEFLECTION, PUSHED = 0.5, 0.05, 0.01, 0.75
MASS = 80  # per metre of depth
OMEGA = 2 * np.pi / PERIOD
DAMPED = OMEGA * np.sqrt(1 - RATIO**2)


def step(t):
    t = np.maximum(t, 0)
    return 1 - np.exp(-RATIO * OMEGA * t) * (np.cos(DAMPED * t) + RATIO * OMEGA / DAMPED * np.sin(DAMPED * t))


def step_rate(t):
    t = np.maximum(t, 0)
    return OMEGA**2 / DAMPED * np.exp(-RATIO * OMEGA * t) * np.sin(DAMPED * t)


def exact(t):
    return DEFLECTION * (step(t) - step(t - PUSHED))


def exact_load(t):
    """Of the force."""
    def load(t):
        return (t > 0) - step(t) - 2 * RATIO / OMEGA * step_rate(t)

    return load(t) - load(t - PUSHED)


def fitted(t, u):
    """(w', decay rate) of A exp(-g t) cos(w' t + phase) nearest to u: Gauss-Newton."""
    def wave(p):
        return np.exp(-p[1] * t) * (p[2] * np.cos(p[0] * t) + p[3] * np.sin(p[0] * t))

    basis = np.exp(-RATIO * OMEGA * t) * np.array([np.cos(DAMPED * t), np.sin(DAMPED * t)])
    p = np.array([DAMPED, RATIO * OMEGA, *np.linalg.lstsq(basis.T, u, rcond=None)[0]])
    for _ in range(20):
        slopes = np.array([(wave(p + h) - wave(p)) / 1e-6 for h in 1e-6 * np.eye(4)]).T
        p = p + np.linalg.lstsq(slopes, u - wave(p), rcond=None)[0]
    return p[0], p[1]


def measure(*settings):
    run = checks.Run(f"{CASE}/case.yaml", *settings)
    series = run.series("centre")
    t, u = series["time"], -series["displacement_y"]
    free = t > PUSHED
    # A load is that of the last step: none at the start, and at the end of the push that before it.
    load = run.series("load")
    times = load["time"]
    steady = (times > 0) & (np.abs(times - PUSHED) > 1e-3)
    load_off = -load["applied_y"] / (MASS * OMEGA**2 * DEFLECTION) - exact_load(times)
    frequency, decay = fitted(t[free] - PUSHED, u[free])
    return {"t": t, "u": u, "off": np.abs(u - exact(t)).max() / DEFLECTION,
            "load_off": np.abs(load_off[steady]).max(),
            "period": DAMPED / frequency - 1,
            "decrement": (decay / frequency) / (RATIO * OMEGA / DAMPED) - 1}


def study():
    for rows in (5, 10, 20):
        for modulus in (10, 100, 1000) if rows == 5 else (100,):
            found = measure(f"variables.spacing=height/{rows}",
                            f"materials.rubber.youngs_modulus={modulus} MPa")
            print(f"| {rows} | {modulus} | {100 * found['off']:.2f} | {100 * found['period']:+.3f} | "
                  f"{100 * found['decrement']:+.2f} |", flush=True)


def plot():
    found = measure()
    figure, axes = checks.new_plot()
    axes.plot(found["t"], 1e3 * exact(found["t"]), "k-", lw=0.8, label="closed form")
    axes.plot(found["t"][::10], 1e3 * found["u"][::10], ".", ms=4, label="particles")
    axes.set(xlabel="t [s]", ylabel="the centre is down by [mm]")
    axes.legend()
    checks.save_plot(figure, CASE, "centre.png")


def main():
    checks.arguments(study=study, plot=plot)
    found = measure()
    report = checks.Report()
    report.check("largest difference from the closed form, of the deflection", found["off"], 0, 0.003)
    report.check("largest difference of the load from the closed form, of the push", found["load_off"],
                 0, 0.005)
    report.check("period less that of theory, of it", found["period"], -1e-3, 1e-3)
    report.check("logarithmic decrement less that of theory, of it", found["decrement"], -0.01, 0.01)
    report.end()


main()
