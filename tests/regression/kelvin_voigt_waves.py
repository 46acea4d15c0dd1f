# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Kelvin-Voigt damping: frequency and decay of standing waves in a slab, cases/kelvin_voigt_waves.yaml.

Small plane waves, u ~ exp(-g t) sin(w t) cos(k x): w0 = k c, g = eta k^2/(2 rho) for longitudinal
waves of c^2 = (lambda + 2 mu)/rho and half of it for shear waves of c^2 = mu/rho, since S = eta dE/dt
has no more than eta/2 of shear; w^2 = w0^2 - g^2.
"""

import numpy as np

import checks

CASE = checks.REPOSITORY / "tests/regression/cases/kelvin_voigt_waves.yaml"
WAVES = {
    "longitudinal": (1.3461538, 0.01 * np.pi**2 / 2, []),
    "shear": (0.38461538, 0.01 * np.pi**2 / 4,
              ["dynamics.guide.directions=[x]", "bodies.slab.initial={velocity: [0, 'speed*cos(pi*x)']}"]),
}
SPEED = 0.001

# Errors of frequency and decay, %, at 10, 20 and 40 particles along the slab, half a wavelength:
# longitudinal -0.71 -0.21 -0.05 and -2.1 -0.55 -0.10, shear -0.31 -0.14 -0.04 and -2.0 -0.59 -0.14.
SPACING = {False: "1/20", True: "1/40"}
FREQUENCY_LIMIT = {False: 0.004, True: 0.001}
DECAY_LIMIT = {False: 0.01, True: 0.003}


def amplitudes(run, component):
    """Projection of the displacement on the mode, in units of the velocity at the start."""
    times, values = [], []
    for time, fields in run.frames("slab"):
        mode = np.cos(np.pi * fields["initial_position"][:, 0])
        times.append(time)
        values.append((fields["displacement"][:, component] * mode).sum() / (mode**2).sum())
    return np.array(times), np.array(values) / SPEED


def fitted(t, u, start):
    """(w, g) of A exp(-g t) sin(w t) nearest to u: Gauss-Newton from a near start."""
    def wave(p):
        return p[2] * np.exp(-p[1] * t) * np.sin(p[0] * t)

    p = np.array([*start, 1 / start[0]])
    for _ in range(20):
        slopes = np.array([(wave(p + step) - wave(p)) / 1e-6 for step in 1e-6 * np.eye(3)]).T
        p = p + np.linalg.lstsq(slopes, u - wave(p), rcond=None)[0]
    return p[0], p[1]


def measure(kind, spacing):
    modulus, decay, settings = WAVES[kind]
    run = checks.Run(CASE, f"variables.spacing={spacing}", *settings)
    t, u = amplitudes(run, 1 if kind == "shear" else 0)
    frequency = np.sqrt(np.pi**2 * modulus - decay**2)
    w, g = fitted(t, u, (frequency, decay))
    return w / frequency - 1, g / decay - 1


def main():
    options = checks.arguments()
    report = checks.Report()
    for kind in WAVES:
        for spacing in ("1/10", "1/20", "1/40") if options.study else (SPACING[options.long],):
            w, g = measure(kind, spacing)
            if options.study:
                print(f"| {kind} | {spacing} | {100 * w:+.2f} | {100 * g:+.2f} |")
                continue
            limit = FREQUENCY_LIMIT[options.long]
            report.check(f"frequency less that of theory, of it, {kind}", w, -limit, limit)
            limit = DECAY_LIMIT[options.long]
            report.check(f"decay rate less that of theory, of it, {kind}", g, -limit, limit)
    report.end()


main()
