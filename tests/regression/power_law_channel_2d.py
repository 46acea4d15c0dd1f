# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Steady plane Poiseuille flow of power-law and Herschel-Bulkley fluids against closed forms.

Of a stress tau = tau_y + k gamma^n, driven by a force f per volume between plates at 0 and 1, the
shear stress is f r at the distance r from the centre line; what has more than tau_y flows:
u = (1 - ((r - r_p)/(1/2 - r_p))^((n + 1)/n)) u_centre beyond the plug r_p = tau_y/f. Bird, Armstrong
& Hassager 1987, chapter 4.
"""

import numpy as np

import checks

CASE = "power_law_channel_2d"
SPACING = 1 / 20
PLUG = 0.3  # of herschel_bulkley.yaml
YIELDED_INDEX = 0.7


def exact(y, index, plug=0):
    r = np.maximum(np.abs(y - 0.5) - plug / 2, 0)
    return 1 - (r / (0.5 - plug / 2)) ** ((index + 1) / index)


def last_frame(file, *settings):
    run = checks.Run(f"{CASE}/{file}", *settings)
    *_, (_, fields) = run.frames("fluid")
    return fields


def layers(fields, values, spacing):
    """Mean over layers one spacing thick."""
    n = round(1 / spacing)
    at = np.clip((fields["position"][:, 1] / spacing).astype(int), 0, n - 1)
    count = np.maximum(np.bincount(at, minlength=n), 1)
    return np.bincount(at, values, minlength=n) / count


def profile_error(fields, spacing, index, plug=0):
    error = fields["velocity"][:, 0] - exact(fields["position"][:, 1], index, plug)
    return np.abs(layers(fields, error, spacing)).max()


def flow_error(fields, index, plug=0):
    """Of the flow rate, of which particles are equal shares."""
    y = (np.arange(20000) + 0.5) / 20000
    return fields["velocity"][:, 0].mean() / exact(y, index, plug).mean() - 1


def half_profile(fields, values, spacing):
    """Means over both halves of the channel, from the centre outwards."""
    means = layers(fields, values, spacing)
    half = len(means) // 2
    return (means[half:] + means[:half][::-1]) / 2


def unyielded_width(fields, spacing):
    """Of what bears less than the yield stress, by mu gamma."""
    drive = ((YIELDED_INDEX + 1) / YIELDED_INDEX) ** YIELDED_INDEX / (0.5 * (1 - PLUG)) ** (YIELDED_INDEX + 1)
    stress = half_profile(fields, fields["viscosity"] * fields["shear_rate"], spacing)
    return 2 * np.interp(0.5 * PLUG * drive, stress, (np.arange(len(stress)) + 0.5) * spacing)


FLAT = 0.02


def flat_width(fields, spacing):
    """Of what moves within two percent of one speed; exactly PLUG + (1 - PLUG) FLAT^(n/(n + 1))."""
    speed = half_profile(fields, fields["velocity"][:, 0], spacing)
    return 2 * np.interp(-(1 - FLAT) * speed[0], -speed, (np.arange(len(speed)) + 0.5) * spacing)


EXACT_WIDTH = PLUG + (1 - PLUG) * FLAT ** (YIELDED_INDEX / (YIELDED_INDEX + 1))


def settings(index, spacing):
    return [f"variables.index={index}", f"variables.spacing={spacing!r}"]


def study():
    for spacing in (1 / 10, 1 / 20, 1 / 40):
        row = []
        for index in (0.5, 1.5):
            fields = last_frame("case.yaml", *settings(index, spacing))
            row += [f"{100 * profile_error(fields, spacing, index):.2f}", f"{100 * flow_error(fields, index):+.2f}"]
        if spacing < 1 / 30:  # the steps are a quarter, and there are four times as many particles
            print(f"| 1/{round(1 / spacing)} |", " | ".join(row), "| | | |", flush=True)
            continue
        fields = last_frame("herschel_bulkley.yaml", f"variables.spacing={spacing!r}")
        row += [f"{100 * profile_error(fields, spacing, YIELDED_INDEX, PLUG):.2f}", f"{flat_width(fields, spacing):.3f}", f"{unyielded_width(fields, spacing):.3f}"]
        print(f"| 1/{round(1 / spacing)} |", " | ".join(row), "|", flush=True)


def plot():
    figure, axes = checks.new_plot()
    y = np.linspace(0, 1, 401)
    runs = [("n = 0.5", "case.yaml", settings(0.5, SPACING), 0.5, 0), ("n = 1.5", "case.yaml", settings(1.5, SPACING), 1.5, 0),
            ("Herschel-Bulkley, n = 0.7", "herschel_bulkley.yaml", [], YIELDED_INDEX, PLUG)]
    for k, (name, file, given, index, plug) in enumerate(runs):
        fields = last_frame(file, *given)
        axes.plot(exact(y, index, plug), y, color=f"C{k}", label=name)
        axes.plot(fields["velocity"][:, 0], fields["position"][:, 1], ".", color=f"C{k}")
    axes.set(xlabel="velocity along the channel", ylabel="y", title="Plane Poiseuille flow, spacing 1/20")
    axes.legend(title="lines: closed form; dots: particles", fontsize=8)
    checks.save_plot(figure, CASE, "profiles.png")


checks.arguments(study=study, plot=plot)
report = checks.Report()
for index in (0.5, 1.5):
    fields = last_frame("case.yaml", *settings(index, SPACING))
    report.check(f"error of the profile, n = {index}", profile_error(fields, SPACING, index), 0, 0.015)
    report.check(f"error of the flow rate, n = {index}", flow_error(fields, index), -0.015, 0.015)
fields = last_frame("herschel_bulkley.yaml")
report.check("error of the profile, Herschel-Bulkley", profile_error(fields, SPACING, YIELDED_INDEX, PLUG), 0, 0.015)
report.check("width of the plug, within 2 % of one speed", flat_width(fields, SPACING), EXACT_WIDTH - SPACING,
             EXACT_WIDTH + SPACING, f"below the yield stress {unyielded_width(fields, SPACING):.3f}")
report.end()
