# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Free rigid bodies in water, floating_box_2d, floating_barge_3d and a drop in free space with a body in it: draft, tilt and stability as Archimedes has them, and that nothing drives
or shakes them. A square of a quarter of the water's density heels by atan(1/2) = 26.57 degrees, one of half the density by
45 (the minima of the potential energy); twice as wide as high it floats upright.

With --study the tables of the README.
"""

import numpy as np

import checks

G = 9.81
CASE = "floating_box_2d/case.yaml"
RISE_LIMIT = {0.1: 0.4, 0.5: 0.25, 0.9: 0.25}  # spacings; measured 0.34, 0.22, 0.21
TILT_LIMIT = 1.5      # degrees; a lattice that is turned is not symmetric
HEEL_LIMIT = 2.5      # degrees
WORK_LIMIT = 1e-3     # of the largest change of the body's energy; measured 1.1e-4
DRIFT_LIMIT = 0.01    # sqrt(g h), mean speed of a body that should stay
BARGE_SHAKE_LIMIT = 0.02  # g, rms; measured 0.009, 0.012, 0.003 at densities 0.1, 0.3, 0.9
SHAKE_LIMIT = 0.025   # g, rms; measured 0.019, 0.015, 0.007
FORCE_LIMIT = 0.005    # of the weight, means of 2.4 s; measured 0.0009, 0.0013, 0.0010, 0.0015: momentum that is left
IMPULSE_LIMIT = 1e-12  # of that of the weight; measured 1e-16


def held(rows, bodies, along, mass, start):
    """Mean force of the water on a body from a time on, over its weight; and its impulse over the whole run over that
    of the weight and the change of momentum, less 1. Rows are means over the acoustic steps: at an instant the force on
    a light body is off by a tenth of its weight, and the mean of a hundred instants still by a hundredth."""
    time, force = rows["time"], rows[f"particle_force_{along}"]
    steps = np.diff(time, prepend=0)
    late = time > start
    speed = bodies[f"velocity_{along}"]
    assert np.array_equal(time, bodies["time"]) and speed[0] == 0
    return ((force * steps)[late].sum() / steps[late].sum() / (mass * G),
            (force * steps).sum() / (mass * (G * time[-1] + speed[-1])) - 1)


def outputs(body, every):
    """Setting: rows at an instant, and means over the acoustic steps, of a body; no frames."""
    rows = f"type: multibody, body: {body}, every: {{time: {every}}}"
    return f"outputs={{{body}: {{{rows}}}, means: {{{rows}, average: true, layer: acoustic}}}}"


def run(ratio, tilt=0.0, width=1.0, end=6.0, spacing="height/10"):
    settings = [f"variables.ratio={ratio}", f"variables.tilt={np.radians(tilt)}", f"variables.width={width}",
                f"loop.end_time={end}", f"variables.spacing={spacing}", outputs("box", 0.02)]
    done = checks.Run(CASE, *settings)
    box = done.series("box")
    late = box["time"] > 0.6 * end
    mass = 1000 * ratio * width * 0.5
    energy = mass * (0.5 * (box["velocity_x"]**2 + box["velocity_y"]**2 + (width**2 + 0.5**2) / 12 * box["angular_velocity"]**2) +
                     G * box["center_y"])
    time = box["time"][late]
    speed = box["velocity_y"][late]
    force, impulse = held(done.series("means"), box, "y", mass, 0.6 * end)
    return {
        "rise": (box["center_y"][late].mean() - box["center_y"][0]) / 0.05,
        "angle": tilt + np.degrees(box["angle"][late].mean()),
        "drift": (box["center_x"][late][-1] - box["center_x"][late][0]) / (time[-1] - time[0]),
        "shake": np.sqrt((np.gradient(speed, time)**2).mean()) / G,
        "force": force,
        "impulse": impulse,
        "work": np.abs(box["particle_work"] - energy + energy[0]).max() / np.ptp(energy),
    }


DROPS = checks.REPOSITORY / "tests/regression/cases"


def drop(name):
    """Largest change of the linear momentum of a drop and the body in it, over the sum of m abs(v); of the angular one."""
    done = checks.Run(DROPS / f"{name}.yaml")
    water, spin, box, light = (done.series(name) for name in ("water", "spin", "box", "light"))
    mass, inertia = 0.3 * 0.24, 0.3 * 0.24 * (0.6**2 + 0.4**2) / 12
    speeds = np.sqrt(2 * light["kinetic"].min() * np.pi)  # at most: the water's, by Cauchy and Schwarz
    linear = max(np.abs(np.ptp(water[f"momentum_{c}"] + mass * box[f"velocity_{c}"])) for c in "xy")
    turning = (spin["angular_momentum"] + inertia * box["angular_velocity"] +
               mass * (box["center_x"] * box["velocity_y"] - box["center_y"] * box["velocity_x"]))
    return linear / speeds, np.ptp(turning) / abs(turning[0])


def across_a_periodic_side():
    """How far the box in a drop that flies across the side of a periodic domain is, at the end, from one that
    reaches no side."""
    flies = "bodies.water.initial.velocity=['3 - 0.5*y', '0.4*x']", "multibody.joints.free.velocity=[2.6, 0.1]"
    wide, periodic = (checks.Run(DROPS / "drop_with_body.yaml", *flies, "resolution.precision=double", f"domain={domain}").series("box") for domain in (
        "{lower: [-7, -4], upper: [7, 4], periodic: [x]}", "{lower: [-1.4, -4], upper: [1.4, 4], periodic: [x]}"))
    return max(abs(wide[name][-1] - periodic[name][-1]) for name in ("center_x", "center_y", "angle"))


def barge():
    """Force of the water over the weight, rise in spacings, largest roll in degrees: at first, and at the end."""
    done = checks.Run("floating_barge_3d/case.yaml", outputs("barge", 0.01))
    body = done.series("barge")
    roll = np.abs(2 * np.degrees(np.arctan2(body["rotation_x"], body["rotation_w"])))
    late = body["time"] > 1.5
    force, _ = held(done.series("means"), body, "z", 0.4 * 0.2 * 0.1 * 300, 1.5)  # ropes take a part of the impulse
    return (force, (body["center_z"][late].mean() - body["center_z"][0]) / 0.02,
            roll.max(), roll[body["time"] > 2.5].max())


def quiet_barge(ratio):
    """Rms of the vertical acceleration of a barge that nobody pushes, from 3 s on, in g; before, its first heave dies down."""
    body = checks.Run("floating_barge_3d/case.yaml", f"variables.ratio={ratio}", "loop.end_time=5",
                      "multibody.joints.free.angular_velocity=[0, 0, 0]", "outputs.frames.every={time: 100}").series("barge")
    late = body["time"] > 3
    return np.sqrt((np.gradient(body["velocity_z"][late], body["time"][late])**2).mean()) / G


def study():
    for ratio in (0.1, 0.3, 0.9):
        print(f"| barge, {ratio} | {quiet_barge(ratio):.4f} |", flush=True)
    for ratio in (0.1, 0.3, 0.5, 0.9):
        found = run(ratio)
        print(f"| {ratio} | {found['rise']:+.2f} | {found['angle']:+.2f} | {found['shake']:.3f} | {found['force']:.4f} |",
              flush=True)
    for ratio, tilt in ((0.25, 20), (0.5, 8)):
        found = run(ratio, tilt, 0.5, 16)
        print(f"| square, {ratio} | {found['angle']:.1f} | {found['drift']:+.4f} |", flush=True)


def main():
    options = checks.arguments(study=study)
    report = checks.Report()
    for name in "drop_with_body", "viscous_drop_with_body":
        linear, angular = drop(name)
        report.check(f"{name}: change of the linear momentum, of the sum of m abs(v)", linear, 0, 1e-12)
        if name == "drop_with_body":  # the Laplacian form of viscosity keeps it only roughly
            report.check("the same of the angular momentum, of it", angular, 0, 1e-3)
    report.check("across a periodic side: box less that of a wide domain", across_a_periodic_side(), 0, 1e-9)
    for ratio in (0.1, 0.5, 0.9) if options.long else (0.1, 0.9):
        found = run(ratio)
        report.check(f"density {ratio}: stands above Archimedes' height, spacings", found["rise"], -RISE_LIMIT[ratio],
                     RISE_LIMIT[ratio])
        report.check(f"density {ratio}: tilt, degrees", found["angle"], -1, 1)
        report.check(f"density {ratio}: drift, m/s", found["drift"], -DRIFT_LIMIT, DRIFT_LIMIT)
        report.check(f"density {ratio}: acceleration, rms, g", found["shake"], 0, SHAKE_LIMIT)
        report.check(f"density {ratio}: force of the water over the weight", found["force"], 1 - FORCE_LIMIT, 1 + FORCE_LIMIT)
        report.check(f"density {ratio}: impulse of the water over that of the weight and the momentum, less 1",
                     found["impulse"], -IMPULSE_LIMIT, IMPULSE_LIMIT)
    found = run(0.5, 10, end=10)
    report.check("let go at 10 degrees: work of the water less the gain of energy, of it", found["work"], 0, WORK_LIMIT)
    report.check("let go at 10 degrees: tilt, degrees", found["angle"], -TILT_LIMIT, TILT_LIMIT)
    if options.long:
        force, rise, first, last = barge()
        report.check("barge: force of the water over the weight", force, 0.99, 1.01)
        report.check("barge: stands above Archimedes' height, spacings", rise, 0, 0.6)
        report.check("barge: largest roll, degrees", first, 2, 3.5)
        report.check("barge: roll that is left after 2.5 s, degrees", last, 0, 0.6)
        for ratio in (0.1, 0.9):
            report.check(f"barge of density {ratio}: acceleration, rms, g", quiet_barge(ratio), 0, BARGE_SHAKE_LIMIT)
        for ratio, tilt, heel in ((0.25, 20, 26.57), (0.5, 8, 45)):
            found = run(ratio, tilt, 0.5, 16)
            report.check(f"square of density {ratio}: heels by, degrees", abs(found["angle"]), heel - HEEL_LIMIT,
                         heel + HEEL_LIMIT)
            report.check(f"square of density {ratio}: drift, m/s", found["drift"], -DRIFT_LIMIT, DRIFT_LIMIT)
    report.end()


if __name__ == "__main__":
    main()
