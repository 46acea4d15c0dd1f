# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Two liquids in layers: standing wave between them, at rest, and flow along them.

The wave is that of the case: linear waves of two liquids under a rigid lid have
omega^2 = (rho1 - rho2) g k/(rho1 coth k h1 + rho2 coth k h2) (Lamb, Hydrodynamics, art. 231). Its
amplitude is the projection of the velocities on those of the potential solution; its zeros, every half
period, are crests and troughs. At rest the pressure is that of the weight above, and nothing moves.
Plane Poiseuille flow in two layers is a parabola in each, with one velocity and one shear stress
where they meet.
"""

import numpy as np

import checks

NUMBER = np.pi
LENGTH, LOWER, UPPER = 2.0, 0.6, 0.4
HEIGHT = LOWER + UPPER
GRAVITY = 9.81
DENSITIES = (1000.0, 500.0)
# How far particles may get into the other liquid, in spacings.
MIXING = 2.0


def period(densities):
    water, oil = densities
    square = ((water - oil) * GRAVITY * NUMBER
              / (water / np.tanh(NUMBER * LOWER) + oil / np.tanh(NUMBER * UPPER)))
    return float(2 * np.pi / np.sqrt(square))


def mode(body, x, y):
    """Velocity of the potential solution, 1 at the interface."""
    depth, away, sign = (LOWER, y, 1) if body == "water" else (UPPER, HEIGHT - y, -1)
    return np.array([-sign * np.sin(NUMBER * x) * np.cosh(NUMBER * away),
                     np.cos(NUMBER * x) * np.sinh(NUMBER * away)]).T / np.sinh(NUMBER * depth)


def frames(run):
    """(time, fields of the water, fields of the oil)"""
    for (time, water), (_, oil) in zip(run.frames("water"), run.frames("oil")):
        yield time, {"water": water, "oil": oil}


def amplitudes(run):
    times, values = [], []
    for time, bodies in frames(run):
        work = size = 0.0
        for body, fields in bodies.items():
            form = mode(body, fields["position"][:, 0], fields["position"][:, 1])
            work += (fields["mass"][:, None] * form * fields["velocity"][:, :2]).sum()
            size += (fields["mass"][:, None] * form**2).sum()
        times.append(time)
        values.append(work / size)
    return np.array(times), np.array(values) / values[0]


def mixing(bodies, spacing):
    """How far the foremost particle of either liquid is beyond the interface, in spacings. The
    interface is where the water in columns two spacings wide reaches up to, by the first waves. Of rows
    that lie as at the start it is -0.5."""
    count = round(LENGTH / (2 * spacing))
    place = (np.arange(count) + 0.5) * LENGTH / count

    def waves(x):
        return np.array([np.cos(np.pi * m * x / LENGTH) for m in range(9)]).T

    water, oil = bodies["water"]["position"], bodies["oil"]["position"]
    column = np.clip((water[:, 0] / LENGTH * count).astype(int), 0, count - 1)
    level = np.bincount(column, minlength=count) * spacing**2 * count / LENGTH
    factors = np.linalg.lstsq(waves(place), level, rcond=None)[0]
    return max((water[:, 1] - waves(water[:, 0]) @ factors).max(),
               (waves(oil[:, 0]) @ factors - oil[:, 1]).max()) / spacing


def wave(spacing, periods, densities=DENSITIES):
    expected = period(densities)
    run = checks.Run("two_liquids_2d/case.yaml", f"variables.spacing={spacing!r}",
                     f"variables.water_density={densities[0]!r}", f"variables.oil_density={densities[1]!r}",
                     f"loop.end_time={periods * expected!r}",
                     f"outputs.fields.every={{time: {expected / 40!r}}}")
    t, a = amplitudes(run)
    before = np.flatnonzero(a[:-1] * a[1:] <= 0)
    zeros = t[before] - a[before] * (t[before + 1] - t[before]) / (a[before + 1] - a[before])
    # Zero number n lies at (2n + 1)/4 periods: the slope of the line through all of them.
    found = 2 * np.polyfit(np.arange(len(zeros)), zeros, 1)[0]
    *_, (_, last) = frames(run)
    energy = [run.series(body) for body in ("water", "oil")]
    gain = sum(e["total"][-1] - e["total"][0] for e in energy) / sum(e["kinetic"][0] for e in energy)
    return {"t": t, "a": a, "period": found / expected - 1, "amplitude": np.abs(a[t > t[-1] - expected / 2]).max(),
            "mixing": mixing(last, spacing), "energy": gain}


def rest(spacing, densities=DENSITIES, end=4.0):
    """With room above the oil, which gives pressures a level. Largest error of the mean pressure of a
    row of the lattice in the second half of the time, of the pressure at the floor; fastest particle at
    the end, of free fall; mixing. (In the first half the layers swing up and down.)"""
    run = checks.Run("two_liquids_2d/case.yaml", f"variables.spacing={spacing!r}", "variables.amplitude=0",
                     "variables.room=0.2",
                     f"variables.water_density={densities[0]!r}", f"variables.oil_density={densities[1]!r}",
                     f"loop.end_time={end!r}", "outputs.fields.every={time: 0.05}")
    water, oil = densities
    floor = GRAVITY * (water * LOWER + oil * UPPER)
    sums, counts = np.zeros((2, round(HEIGHT / spacing) + 1)), np.zeros((2, round(HEIGHT / spacing) + 1))
    for time, bodies in frames(run):
        if time < end / 2:
            continue
        for k, (body, fields) in enumerate(bodies.items()):
            y = fields["position"][:, 1]
            exact = floor - GRAVITY * water * y if body == "water" else GRAVITY * oil * (HEIGHT - y)
            rows = np.clip((y / spacing).astype(int), 0, sums.shape[1] - 1)
            sums[k] += np.bincount(rows, fields["pressure"] - exact, sums.shape[1])
            counts[k] += np.bincount(rows, minlength=sums.shape[1])
    # A row that a few particles have swung into is none.
    whole = counts > 0.2 * counts.max()
    speed = max(np.linalg.norm(fields["velocity"], axis=1).max() for fields in bodies.values())
    return {"pressure": np.abs(sums[whole] / counts[whole]).max() / floor,
            "speed": speed / np.sqrt(2 * GRAVITY * HEIGHT), "mixing": mixing(bodies, spacing)}


def channel(spacing, viscosities=(0.2, 0.1), densities=(1.0, 1.0), end=6.0):
    """Largest error of a layer's mean velocity along the channel, of the largest velocity."""
    names = ("lower", "upper")
    run = checks.Run(checks.REPOSITORY / "tests/regression/cases/layered_channel.yaml",
                     f"variables.spacing={spacing!r}", f"loop.end_time={end!r}",
                     *(f"variables.{name}_viscosity={mu!r}" for name, mu in zip(names, viscosities)),
                     *(f"variables.{name}_density={rho!r}" for name, rho in zip(names, densities)))
    (mu_1, mu_2), (f_1, f_2) = viscosities, densities  # forces per volume: the acceleration is 1
    # u = s_1 y - f_1 y^2/(2 mu_1) below, s_2 z - f_2 z^2/(2 mu_2), z = 1 - y, above; y = 1/2: one velocity
    # and one shear stress.
    slopes = np.linalg.solve([[0.5, -0.5], [mu_1, mu_2]],
                             [f_1 / (8 * mu_1) - f_2 / (8 * mu_2), 0.5 * (f_1 + f_2)])

    def exact(name, y):
        k = names.index(name)
        z = y if k == 0 else 1 - y
        return slopes[k] * z - densities[k] * z**2 / (2 * viscosities[k])

    largest = max(exact(name, y).max() for name, y in (("lower", np.linspace(0, 0.5, 500)),
                                                       ("upper", np.linspace(0.5, 1, 500))))
    worst = 0.0
    for name in names:
        *_, (_, fields) = run.frames(name)
        y = fields["position"][:, 1]
        layers = (y / spacing).astype(int)
        count = np.bincount(layers)
        means = np.bincount(layers, fields["velocity"][:, 0] - exact(name, y))[count > 0] / count[count > 0]
        worst = max(worst, np.abs(means).max())
    return worst / largest


def study():
    for densities in (DENSITIES, (1000.0, 100.0), (1000.0, 900.0)):
        for spacing in (1 / 25, 1 / 50, 1 / 100):
            found, still = wave(spacing, 10, densities), rest(spacing, densities)
            print(f"| {densities[0] / densities[1]:.3g} | H/{1 / spacing:.0f} | {100 * found['period']:+.2f} | "
                  f"{found['amplitude']:.3f} | {found['energy']:+.2f} | {found['mixing']:.2f} | "
                  f"{100 * still['pressure']:.2f} | {100 * still['speed']:.2f} |", flush=True)
    for viscosities, densities in (((0.2, 0.1), (1, 1)), ((0.1, 0.1), (1, 1)), ((0.5, 0.05), (1, 1)), ((0.2, 0.1), (5, 1))):
        print(f"| {viscosities} | {densities} |",
              " | ".join(f"{100 * channel(s, viscosities, densities):.2f}" for s in (1 / 20, 1 / 40, 1 / 80)), "|", flush=True)


def plot():
    found = wave(1 / 50, 10)
    figure, axes = checks.new_plot(8, 4)
    expected = period(DENSITIES)
    t = np.linspace(0, found["t"][-1], 500)
    axes.plot(t, np.cos(2 * np.pi * t / expected), "k-", label=f"undamped, T = {expected:.3f} s")
    axes.plot(found["t"], found["a"], ".", label="amplitude of the velocities")
    axes.set(xlabel="t [s]", ylabel="amplitude / that at the start", title="Wave between two liquids, spacing H/50")
    axes.legend(loc="lower left")
    checks.save_plot(figure, "two_liquids_2d", "amplitude.png")


def main():
    options = checks.arguments(study=study, plot=plot)
    report = checks.Report()
    if options.long:
        cases = [(densities, spacing, 10) for densities in (DENSITIES, (1000.0, 100.0))
                 for spacing in (1 / 25, 1 / 50, 1 / 100)]
    else:
        cases = [(DENSITIES, 1 / 25, 3)]
    for densities, spacing, periods in cases:
        ratio = f"densities {densities[0]:g} and {densities[1]:g}, H/{1 / spacing:.0f}: "
        found = wave(spacing, periods, densities)
        report.check(ratio + "period less that of theory, of it", found["period"], -0.03, 0.03,
                     f"amplitude at the end {found['amplitude']:.2f}")
        report.check(ratio + "mixing, spacings", found["mixing"], -1, MIXING)
        still = rest(spacing, densities, 4.0 if options.long else 3.0)
        report.check(ratio + "error of the pressure at rest, of that at the floor", still["pressure"], 0, 0.01)
        report.check(ratio + "mixing at rest, spacings", still["mixing"], -1, MIXING)
    for spacing in (1 / 20, 1 / 40, 1 / 80)[:3 if options.long else 1]:
        report.check(f"error of the flow along two layers, gap/{1 / spacing:.0f}", channel(spacing), 0, 0.015)
    report.end()


main()
