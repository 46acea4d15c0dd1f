# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""A block of muscle that is pulled apart: stress and stretch along its fibres and along its sheets.

The stress P at a cross-section is the weight beyond it, whatever the law. The stretches of the
sections at rest give a second value, that of the law in uniaxial stress: sides free of stress.
"""

import numpy as np

import checks

# Of the shipped case; stresses in units of Young's modulus of the isotropic part.
SHEAR = 1 / 2.6
LAMBDA = 0.3 / (1.3 * 0.4)
HALF = 0.05  # length
ALONG = {"case": "fibres", "sheet": "sheets"}

# Sections nearer to the ends are those of one or two spacings, the last of which hang free.
FROM = 0.25
# Largest error there at 4, 6 and 8 particles across: 4.1 %, 2.7 %, 1.9 %.
SHORT_LIMIT = 0.045
LONG_LIMIT = 0.02


def stresses(stretches, along_fibres):
    """First Piola-Kirchhoff stresses dW/dl for F = diag(l), Holzapfel & Ogden as guide (14), (15).

    The block has b = b_f = b_s = 1, a_f = a/2, a_s = a/4; the directions lie along the axes, so that
    fibre and sheet do not shear.
    """
    l = np.array(stretches)
    volume = l.prod()
    result = SHEAR * np.exp((l**2).sum() - 3 - 2 * np.log(volume)) * (l - 1 / l) + LAMBDA * np.log(volume) / l
    for axis, stiffness in zip((0, 1) if along_fibres else (1, 0), (SHEAR / 2, SHEAR / 4)):
        strain = l[axis] ** 2 - 1
        result[axis] += stiffness * strain * np.exp(strain**2) * 2 * l[axis]
    return result


def uniaxial(stretch, along_fibres):
    """Stress P along the first axis where the others are free: Newton's method for their stretches."""
    across = np.full(2, 1 / np.sqrt(stretch))
    for _ in range(30):
        off = stresses([stretch, *across], along_fibres)[1:]
        slopes = [(stresses([stretch, *(across + step)], along_fibres)[1:] - off) / 1e-6
                  for step in 1e-6 * np.eye(2)]
        across = across - np.linalg.solve(np.array(slopes).T, off)
    return stresses([stretch, *across], along_fibres)[0]


def measure(case, particles):
    """(stress, stretch, stress of the law at that stretch) of the cross-sections x > 0."""
    run = checks.Run(f"muscle_block_3d/{case}.yaml", f"variables.spacing=width/{particles}",
                     "outputs.fields.every={time: 100}")
    *_, (_, fields) = run.frames("block")
    x = fields["initial_position"][:, 0]
    # Column by column: the first entry is F_11.
    stretch = fields["deformation_gradient"].reshape(len(x), -1)[:, 0]
    sections = np.unique(x[x > 0])
    mean = np.array([stretch[x == section].mean() for section in sections])
    law = np.array([uniaxial(value, case == "case") for value in mean])
    energy = run.series("energy")
    return 1 - sections / HALF, mean, law, energy["kinetic"][-1] / energy["internal"][-1]


def plot():
    figure, axes = checks.new_plot()
    for case, along in ALONG.items():
        weight, stretch, _, _ = measure(case, 8)
        line = np.linspace(1, stretch.max() + 0.01, 60)
        [drawn] = axes.plot(line, [10 * uniaxial(v, case == "case") for v in line], "-",
                            label=f"law, along the {along}")
        axes.plot(stretch, 10 * weight, "o", color=drawn.get_color(), markersize=4,
                  label=f"sections of the block, along the {along}")
    axes.set(xlabel="stretch", ylabel="first Piola-Kirchhoff stress [kPa]",
             title="Muscle block, 8 particles across")
    axes.legend()
    checks.save_plot(figure, "muscle_block_3d", "stress.png")


def main():
    options = checks.arguments(plot=plot)
    report = checks.Report()
    for case, along in ALONG.items():
        for particles in (4, 6, 8) if options.study else (8 if options.long else 4,):
            weight, stretch, law, swing = measure(case, particles)
            inner = weight > FROM
            error = law[inner] / weight[inner] - 1
            if options.study:
                print(f"| {along} | {particles} | {100 * error.min():+.1f} to {100 * error.max():+.1f} "
                      f"| {100 * np.abs(error).mean():.1f} | {stretch.max():.3f} |")
                continue
            limit = LONG_LIMIT if options.long else SHORT_LIMIT
            report.check(f"largest stretch along {along}", stretch.max(), 1.25, 1.45)
            report.check(f"kinetic energy over strain energy, {along}", swing, 0, 1e-4)
            report.check(f"least stress of the law less the load, {along}", error.min(), -limit, limit)
            report.check(f"largest stress of the law less the load, {along}", error.max(), -limit, limit)
    report.end()


main()
