# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Bodies that sink in viscous liquids in closed vessels: settling_cylinder_2d against Glowinski et al. 2001, the same in
creeping flow (cases/settling_stokes.yaml) against Faxen 1946, falling_sphere_3d against the experiment of ten Cate et al.
2002.

With --study the tables over spacings in the READMEs, with --plot the picture of the sphere.
"""

import numpy as np

import checks

FAXEN = 16.533  # force on unit length over mu U, of a radius of a fifth of the half width
FORCE = 4.13

NO_FRAMES = "outputs.frames.every={time: 100}"

# Measured 0.981 and 0.977 at D/10 and D/16.
LARGEST = 0.05
# Measured 0.993 and 0.997 at R/5 and R/10.
CREEPING = 0.03
# Measured 0.977 with 7 cells, D/5.25.
CELLS = 7
SPHERE = 0.12


def cylinder(across):
    """Largest speed, over Glowinski's, and mean speed from 0.4 s on."""
    body = checks.Run("settling_cylinder_2d/case.yaml", f"variables.spacing=2*radius/{across}", NO_FRAMES).series("cylinder")
    speed = -body["velocity_y"]
    wanted = -100 * checks.reference("settling_cylinder_2d", "velocity.csv")["v_m_s"].min()
    return speed.max() / wanted, speed[body["time"] > 0.4].mean()


def creeping(across):
    """F/(mu U) of a cylinder with `across` spacings in its radius; U is the mean from the time on at which it is steady."""
    body = checks.Run("../tests/regression/cases/settling_stokes.yaml", f"variables.spacing=radius/{across}",
                      NO_FRAMES).series("cylinder")
    steady = body["time"] > 0.3
    return FORCE * np.ptp(body["time"][steady]) / np.ptp(body["center_y"][steady])


def sphere(cells):
    """Mean speed from 0.5 to 0.8 s, over the experiment's."""
    body = checks.Run("falling_sphere_3d/case.yaml", f"variables.cells={cells}", "loop.end_time=0.8",
                      NO_FRAMES).series("sphere")
    reference = checks.reference("falling_sphere_3d", "velocity.csv")
    late = body["time"] > 0.5
    wanted = np.interp(body["time"][late], reference["t_s"], reference["v_m_s"])
    return body["velocity_z"][late].mean() / wanted.mean()


def study():
    for across in (10, 16):
        largest, mean = cylinder(across)
        print(f"| D/{across} | {largest:.3f} | {mean:.2f} |", flush=True)
    for across in (5, 10):
        print(f"| R/{across} | {creeping(across):.2f} |", flush=True)
    for cells in (CELLS, 9, 11):
        print(f"| D/{0.75 * cells:g} | {sphere(cells):.3f} |", flush=True)


def plot():
    run = checks.Run("falling_sphere_3d/case.yaml")
    reference = checks.reference("falling_sphere_3d", "velocity.csv")
    figure, axes = checks.new_plot(8, 4)
    grid = figure.add_gridspec(1, 5)
    axes.set_subplotspec(grid[:3])
    axes.plot(reference["t_s"], -1000 * reference["v_m_s"], "ko", markersize=4, label="ten Cate et al. 2002")
    body = run.series("sphere")
    axes.plot(body["time"], -1000 * body["velocity_z"], label="sphinx, 7 cells")
    axes.set(xlabel="time [s]", ylabel="speed of the sphere [mm/s]", xlim=(0, 1.2))
    axes.legend(loc="lower right")
    frames = zip(run.frames("oil"), run.frames("sphere"))
    time, oil, solid = next((time, oil, solid) for (time, oil), (_, solid) in frames if time >= 0.9)
    middle = figure.add_subplot(grid[3:])
    for fields, marker in (oil, "o"), (solid, "s"):
        near = np.abs(fields["position"][:, 1]) < 0.0015
        place = 1000 * fields["position"][near]
        speed = 1000 * np.linalg.norm(fields["velocity"][near], axis=1)
        drawn = middle.scatter(place[:, 0], place[:, 2], s=6, c=speed, vmin=0, vmax=37, marker=marker)
    figure.colorbar(drawn, label="speed [mm/s]")
    middle.set(aspect="equal", xlabel="x [mm]", ylabel="z [mm]", title=f"{time:.2g} s")
    checks.save_plot(figure, "falling_sphere_3d", "falling_sphere_3d.png")


def main():
    options = checks.arguments(study=study, plot=plot)
    report = checks.Report()
    across = 16 if options.long else 10
    report.check(f"cylinder, D/{across}: largest speed over Glowinski's", cylinder(across)[0], 1 - LARGEST, 1 + LARGEST)
    across = 10 if options.long else 5
    report.check(f"creeping cylinder, R/{across}: F/(mu U) over Faxen's", creeping(across) / FAXEN, 1 - CREEPING, 1 + CREEPING)
    if not options.long:
        report.check(f"sphere, D/{0.75 * CELLS:g}: speed over ten Cate's", sphere(CELLS), 1 - SPHERE, 1 + SPHERE)
    report.end()


if __name__ == "__main__":
    main()
