# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Mechanisms without water: pendulum_2d, double_pendulum_2d, four_bar_linkage_2d, torque_free_body_3d, and of
cases/ here slider_crank, heavy_top, torque_free_euler, pushed_elastic_block, joint_springs, swung_pendulum,
loose_linkage and moored_body. References: integrations of the equations of each in minimal coordinates by DOP853 to
1e-12, beside the cases; the period of the pendulum (complete elliptic integral), the flips of the free body (elliptic
integral), the largest tilt of the top (cubic of its energy), oscillators and the catenary are closed forms.

With --plot the plots in the folders of the cases.
"""

import numpy as np

import beam
import checks

HERE = checks.REPOSITORY / "tests/regression/cases"


def same(report, what, times, values, reference_times, reference, limit=1e-5, until=np.inf):
    """Largest difference over the range of the reference."""
    at = (reference_times <= min(times[-1] + 1e-9, until))
    found = np.interp(reference_times[at], times, values)
    report.check(f"{what}: largest difference, of the range", np.abs(found - reference[at]).max() / np.ptp(reference),
                 0, limit)


def energy(report, run, limit=1e-6):
    series = run.series("energy")
    largest = np.abs(series["kinetic"]).max()
    report.check("energy drifts by, of the largest kinetic energy", np.ptp(series["total"]) / largest, 0, limit)


def pendulum(report):
    run = checks.Run("pendulum_2d/case.yaml", "outputs.frames.every={time: 10}")
    pin, reference = run.series("pin"), checks.reference("pendulum_2d", "swing.csv")
    crossings = beam.zeros(pin["time"], pin["coordinate"])
    report.check("pendulum: period less 2.093199 s, of it", 2 * (crossings[1] - crossings[0]) / 2.093199 - 1, -1e-5,
                 1e-5)
    same(report, "pendulum: angle", pin["time"], pin["coordinate"], reference["t"], reference["theta"])
    energy(report, run)


def double_pendulum(report):
    run = checks.Run("double_pendulum_2d/case.yaml", "outputs.frames.every={time: 10}")
    upper, elbow = run.series("shoulder"), run.series("elbow")
    reference = checks.reference("double_pendulum_2d", "angles.csv")
    # A disturbance grows 13 times until t = 5.
    same(report, "double pendulum: upper angle", upper["time"], upper["coordinate"], reference["t"],
         reference["theta1"], until=5)
    same(report, "double pendulum: lower angle", upper["time"], upper["coordinate"] + elbow["coordinate"],
         reference["t"], reference["theta2"], until=5)
    energy(report, run)


def four_bar(report):
    run = checks.Run("four_bar_linkage_2d/case.yaml", "outputs.frames.every={time: 10}")
    crank, coupler, rocker = (run.series(name) for name in ("crank", "coupler", "rocker"))
    reference = checks.reference("four_bar_linkage_2d", "free.csv")
    turned = crank["coordinate"] + np.pi / 2
    same(report, "four-bar linkage: crank", crank["time"], turned, reference["t"], reference["crank"])
    start = reference["coupler"][0]
    same(report, "four-bar linkage: coupler", crank["time"], crank["coordinate"] + coupler["coordinate"] + start,
         reference["t"], reference["coupler"])
    same(report, "four-bar linkage: rocker", crank["time"], rocker["coordinate"] + reference["rocker"][0],
         reference["t"], reference["rocker"])
    energy(report, run)
    driven = checks.Run("four_bar_linkage_2d/driven.yaml", "outputs.frames.every={time: 10}")
    crank, rocker = driven.series("crank"), driven.series("rocker")
    reference = checks.reference("four_bar_linkage_2d", "kinematics.csv")
    # The linkage starts with the crank at 90 degrees and turns once a second.
    angle = (crank["coordinate"] + np.pi / 2) % (2 * np.pi)
    expected = np.interp(angle, reference["crank_rad"], reference["rocker_rad"])
    start = np.interp(np.pi / 2, reference["crank_rad"], reference["rocker_rad"])
    # The table has steps of 3 degrees; linear interpolation of it is good to 2e-4.
    report.check("four-bar linkage, driven: rocker, largest difference", np.abs(
        rocker["coordinate"] + start - expected).max(), 0, 4e-4)


def in_own_axes(body):
    """Angular velocity of a body in its axes, from a series of it."""
    q = np.array([body[f"rotation_{c}"] for c in "wxyz"])
    space = np.array([body[f"angular_velocity_{c}"] for c in "xyz"])
    vector = -q[1:]  # the inverse turn: into axes of the body
    return space + 2 * q[0] * np.cross(vector.T, space.T).T + 2 * np.cross(vector.T, np.cross(vector.T, space.T)).T


def torque_free(report):
    run = checks.Run("torque_free_body_3d/case.yaml", "outputs.frames.every={time: 10}")
    box = run.series("box")
    own = in_own_axes(box)
    reference = checks.reference("torque_free_body_3d", "angular_velocity.csv")
    for c, name in enumerate(("wx_body", "wy_body", "wz_body")):
        same(report, f"torque-free body: {name}", box["time"], own[c], reference["t"], reference[name])
    flips = np.diff(beam.zeros(box["time"], own[1]))
    report.check("torque-free body: time between flips less 2.434493 s, of it", flips.mean() / 2.434493 - 1, -1e-5,
                 1e-5)
    energy(report, run)


def torque_free_euler(report):
    run = checks.Run(HERE / "torque_free_euler.yaml")
    body = run.series("body")
    reference = checks.table(HERE / "reference/torque_free_euler.csv")
    for own, name in zip(in_own_axes(body), ("w1", "w2", "w3")):
        same(report, f"moments 1, 2, 3: {name}", body["time"], own, reference["t"], reference[name])
    energy(report, run)


def pushed_elastic_block(report):
    block = checks.Run(HERE / "pushed_elastic_block.yaml").series("block")
    t = block["time"]
    for c, acceleration in (("x", 2.0), ("y", -9.81)):
        same(report, f"pushed elastic block: {c}", t, block[f"center_{c}"] - block[f"center_{c}"][0], t,
             0.5 * acceleration * t**2, 1e-9)


def slider_crank(report):
    run = checks.Run(HERE / "slider_crank.yaml")
    crank, slider = run.series("crank"), run.series("slider")
    reference = checks.table(HERE / "reference/slider_crank.csv")
    same(report, "slider-crank: crank", crank["time"], crank["coordinate"] + np.pi / 4, reference["t"],
         reference["crank_angle"])
    same(report, "slider-crank: slider", slider["time"], slider["coordinate"] + reference["slider_x"][0],
         reference["t"], reference["slider_x"])
    forces = checks.table(HERE / "reference/slider_crank_reactions.csv")
    same(report, "slider-crank: force of the pin", crank["time"], crank["reaction_x"], forces["t"],
         forces["pin_force_x_on_crank"], 1e-4)
    same(report, "slider-crank: force of the guide", slider["time"], slider["reaction_y"], forces["t"],
         forces["guide_force_y_on_slider"], 1e-4)
    energy(report, run)


def heavy_top(report):
    run = checks.Run(HERE / "heavy_top.yaml")
    top = run.series("top")
    centre = np.array([top[f"center_{c}"] for c in "xyz"])
    tilt = np.arccos(np.clip(centre[2] / np.linalg.norm(centre, axis=0), -1, 1))
    report.check("heavy top: largest tilt less 35.2018 degrees", np.degrees(tilt.max()) - 35.2018, -0.002, 0.002)
    reference = checks.table(HERE / "reference/heavy_top.csv")
    same(report, "heavy top: tilt", top["time"], tilt, reference["t"], reference["tilt_rad"])
    energy(report, run)


def oscillator(t, mass, damping, stiffness, start, rate=0.0, rest=0.0):
    """A lightly damped one, released at `start` with a rate."""
    decay = damping / (2 * mass)
    omega = np.sqrt(stiffness / mass - decay**2)
    a = start - rest
    return rest + np.exp(-decay * t) * (a * np.cos(omega * t) + (rate + decay * a) / omega * np.sin(omega * t))


def bouncing(t, speed, gap, omega):
    """To and fro between springs without damping, from the middle."""
    flight, push = 2 * gap / speed, np.pi / omega
    half = flight + push
    t = t + flight / 2
    n, t = np.floor(t / half), t % half
    x = np.where(t < flight, speed * t - gap, gap + speed / omega * np.sin(omega * (t - flight)))
    return np.where(n % 2 == 0, x, -x)


def joint_springs(report):
    run = checks.Run(HERE / "joint_springs_2d.yaml")

    def compare(what, found, expected, limit=1e-7):
        report.check(f"{what}: largest difference, of the range", np.abs(found - expected).max() / np.ptp(expected), 0,
                     limit)

    held, pushed, bounced, spun = (run.series(name) for name in ("held", "pushed", "bounced", "spun"))
    t = held["time"]
    compare("planar joint: torsional spring", held["coordinate_1"], oscillator(t, 0.5, 0.1, 8, 0, 1, 0.3))
    compare("planar joint: spring along x", held["coordinate_2"], oscillator(t, 2, 0, 50, 0.1))
    compare("planar joint: spring along y", held["coordinate_3"], oscillator(t, 2, 0.6, 20, 0.2, 0, -0.1))
    compare("planar joint: its reaction is the spring's force", held["reaction_x"], -50 * held["coordinate_2"])
    compare("planar joint: motor", pushed["coordinate_1"], t**3 / 12)
    compare("planar joint: moment of the motor", pushed["reaction_moment"], 0.25 * t)
    compare("planar joint: spring beside a motion", pushed["coordinate_2"], oscillator(t, 2, 0, 50, 0.1))
    compare("planar joint: motion", pushed["coordinate_3"], 0.1 * np.sin(3 * t))
    compare("planar joint: force of the motion", pushed["reaction_y"], -1.8 * np.sin(3 * t), 1e-5)
    # Where a stop begins, the force has a kink.
    compare("planar joint: stops", bounced["coordinate_2"], bouncing(t, 1, 0.2, np.sqrt(1000)), 1e-4)
    compare("given moment", spun["angle"], t**3 / 15)
    compare("given moment, as it is written", run.series("moment")["moment"], 0.2 * t)

    run = checks.Run(HERE / "joint_springs_3d.yaml")
    cylinder, universal, gimbal, ball, free, spun = (
        run.series(name) for name in ("cylinder", "universal", "gimbal", "ball", "free", "spun"))
    compare("cylinder: torsional spring", cylinder["coordinate_1"], oscillator(t, 0.7, 0.1, 8, 0.2))
    compare("cylinder: motor along the axis", cylinder["coordinate_2"], 0.75 * t**2)
    compare("universal: spring", universal["coordinate_2"], oscillator(t, 0.6, 0.1, 8, 0.2))
    compare("gimbal: spring", gimbal["coordinate_3"], oscillator(t, 0.7, 0, 8, 0, 1, 0.1))

    def turn(body, axis):
        return 2 * np.arctan2(body[f"rotation_{axis}"], body["rotation_w"])

    compare("ball: spring", turn(ball, "y"), oscillator(t, 0.6, 0.1, 8, 0.2))
    compare("free: torsional spring", turn(free, "x"), oscillator(t, 0.5, 0.1, 8, 0.2))
    compare("free: spring along z", free["center_z"], oscillator(t, 2, 0.4, 50, 0.3))
    compare("given moment in 3D", turn(spun, "y"), t**3 / 18)


def convergence(report):
    def swing(integrator, step):
        run = checks.Run(HERE / "swung_pendulum.yaml", f"multibody.integrator={integrator}", f"variables.step={step}")
        return run.series("pin")["coordinate"]

    exact = swing("runge_kutta_4", 0.0005)
    for integrator, order in (("runge_kutta_4", 4), ("midpoint", 2)):
        errors = [np.abs(swing(integrator, step) - exact).max() for step in (0.04, 0.02, 0.01)]
        print(f"       {integrator}: errors {', '.join(f'{e:.3g}' for e in errors)} with steps of 0.04, 0.02, 0.01 s")
        report.check(f"{integrator}: order", np.log2(errors[1] / errors[2]), order - 0.3, order + 0.3)


def accuracy(report):
    loose = checks.Run(HERE / "loose_linkage.yaml", "outputs.frames.every={time: 10}").series("energy")
    report.check("loose linkage: error of its constraints", loose["constraint_error"].max(), 1e-9, 1e-5)
    tight = checks.Run(HERE / "loose_linkage.yaml", "multibody.accuracy=1e-12", "outputs.frames.every={time: 10}")
    report.check("tight linkage: error of its constraints", tight.series("energy")["constraint_error"].max(), 0, 1e-12)


def moored_bodies(report):
    run = checks.Run(HERE / "moored_body.yaml")
    still, mooring = run.series("still"), run.series("mooring")
    for c in "xyz":
        report.check(f"moored body at rest: way along {c}, in m", np.ptp(still[f"center_{c}"]), 0, 1e-7)
    report.check("mooring line: tension less the given one, of it",
                 np.abs(mooring["tension"] / np.hypot(8000, 18000) - 1).max(), 0, 1e-9)
    report.check("mooring line: tension at the anchor less the given one, of it",
                 np.abs(mooring["anchor_tension"] / 8000 - 1).max(), 0, 1e-9)
    report.check("mooring line: length on the ground less 60 m, of it", np.abs(mooring["resting"] / 60 - 1).max(), 0,
                 1e-9)
    swung, series = run.series("swung"), run.series("energy")
    total = series["total"] - 1.5e4 * 9.81 * swung["center_z"] - (1e4 * 9.81 + 18000) * still["center_z"]
    print(f"       the body on two lines moves by {np.ptp(swung['center_x']):.3g}, {np.ptp(swung['center_y']):.3g} and "
          f"{np.ptp(swung['center_z']):.3g} m; tension {run.series('line')['tension'].min():.3g} to "
          f"{run.series('line')['tension'].max():.3g} N, on the ground "
          f"{run.series('ground_line')['resting'].min():.3g} to {run.series('ground_line')['resting'].max():.3g} m")
    report.check("body on two lines: energy drifts by, of the largest kinetic energy",
                 np.ptp(total) / series["kinetic"].max(), 0, 1e-6)


def trace(case, body, axes_of, every, last):
    """The particles of a body at some times, one over the other, later ones darker."""
    figure, axes = checks.new_plot(5, 5)
    frames = [(t, f) for t, f in checks.Run(f"{case}/case.yaml").frames(body)][:last:every]
    for n, (_, fields) in enumerate(frames):
        x, y = (fields["position"][:, k] for k in axes_of)
        axes.scatter(x, y, s=6, color=str(0.85 - 0.7 * n / max(1, len(frames) - 1)))
    axes.set(aspect="equal", xlabel="xyz"[axes_of[0]] + " [m]", ylabel="xyz"[axes_of[1]] + " [m]",
             title=f"from {frames[0][0]:g} s to {frames[-1][0]:.3g} s")
    checks.save_plot(figure, case, f"{case}.png")


def plot():
    trace("pendulum_2d", "box", (0, 1), 2, 12)
    trace("double_pendulum_2d", "bob", (0, 1), 1, 60)
    trace("four_bar_linkage_2d", "rocker", (0, 1), 2, 20)
    trace("torque_free_body_3d", "box", (0, 2), 6, 30)
    figure, axes = checks.new_plot()
    reference = checks.reference("pendulum_2d", "swing.csv")
    axes.plot(reference["t"], np.degrees(reference["theta"]), "--", label="exact")
    pin = checks.Run("pendulum_2d/case.yaml").series("pin")
    axes.plot(pin["time"], np.degrees(pin["coordinate"]), label="sphinx")
    axes.set(xlabel="t [s]", ylabel="angle [degrees]", title="Pendulum")
    axes.legend()
    checks.save_plot(figure, "pendulum_2d", "angle.png")


def main():
    checks.arguments(plot=plot)
    report = checks.Report()
    for test in (pendulum, double_pendulum, four_bar, torque_free, torque_free_euler, pushed_elastic_block,
                 slider_crank, heavy_top, joint_springs, convergence, accuracy, moored_bodies):
        test(report)
    report.end()


if __name__ == "__main__":
    main()
