# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""The largest stable acoustic step: sound in boxes of water at rest, steps of one size.

Where a step is too long the noise of an arrangement at rest grows from step to step without end. On a lattice
the limit is that of the eigenvalues of one step (`lattice_limit`); what walls and disorder make of it is tried.
engine/dynamics/fluid/acoustic_step.md has the results; --study prints the table of the experiments.
"""

import functools
import itertools
import json
import pathlib
import tempfile

import numpy as np
import yaml

import checks

SOUND_SPEED = 10.0
KERNELS = {"wendland_c2": 1.3, "quintic_spline": 1.0}  # and their smoothing ratios
CELLS = {2: 16, 3: 8}
STEPS = 600
NOISE = 1e-6  # of the sound speed
# The default factor over the limit on a lattice: 0.95 by engine/dynamics/fluid/acoustic_time_step.cpp, as two digits.
MARGIN = (0.94, 0.96)


def slope(kernel, dimension, q):
    """-dW/dq of the kernel with h = 1."""
    if kernel == "wendland_c2":
        factor = 7 / (4 * np.pi) if dimension == 2 else 21 / (16 * np.pi)
        return factor * np.where(q < 2, 5 * q * (1 - q / 2) ** 3, 0)
    factor = 7 / (478 * np.pi) if dimension == 2 else 1 / (120 * np.pi)
    power = [np.maximum(end - q, 0) ** 4 for end in (3, 2, 1)]
    return factor * 5 * (power[0] - 6 * power[1] + 15 * power[2])


@functools.cache
def lattice_limit(kernel, dimension, riemann):
    """Largest dt c0/h at which no wave on a cubic lattice grows, spacing 1.

    A step takes (v, rho'), rho' = c0/rho0 (rho - rho0) at its middle, with the sums over the neighbors
      Q = sum V |W'| e sin(k.r),  S = sum V |W'| (1 - cos(k.r)),  A = the same times e e
    to v - dt c0 (i Q rho' + beta A v), then to rho' - dt c0 (i Q.v + S rho'). S comes of the velocity jump
    of the Riemann problem, A of its pressure jump, of which beta is 0 for small waves with low_dissipation."""
    ratio = KERNELS[kernel]
    waves = 51 if dimension == 2 else 13
    reach = int(np.ceil(3 * ratio))
    offsets = np.array([x for x in itertools.product(range(-reach, reach + 1), repeat=dimension) if any(x)], float)
    r = np.linalg.norm(offsets, axis=1)
    weight = slope(kernel, dimension, r / ratio) / ratio ** (dimension + 1)
    e = offsets / r[:, None]
    k = np.array(list(itertools.combinations_with_replacement(np.linspace(0, np.pi, waves), dimension)))
    phase = k @ offsets.T
    q = (np.sin(phase) * weight) @ e
    lost = (1 - np.cos(phase)) * weight
    s = lost.sum(1) * (riemann != "none")
    a = np.einsum("kn,ni,nj->kij", lost, e, e) * (riemann == "dissipative")

    def grows(step):
        d = dimension
        x = step * ratio
        one = np.zeros((len(k), d + 1, d + 1), complex)
        one[:, :d, :d] = np.eye(d) - x * a
        one[:, :d, d] = -1j * x * q
        one[:, d, :d] = -1j * x * np.einsum("ki,kij->kj", q, one[:, :d, :d])
        one[:, d, d] = 1 - x * s - x * x * (q**2).sum(1)
        return np.abs(np.linalg.eigvals(one)).max() > 1 + 1e-7

    low, high = 0.1, 4.0
    while high - low > 1e-3:
        middle = (low + high) / 2
        low, high = (low, middle) if grows(middle) else (middle, high)
    return low


def box(folder, kernel, dimension, disorder=0.0, walls=False, riemann="low_dissipation"):
    """A box full of water at rest but for noise, particles displaced at random by up to `disorder` spacings."""
    cells, wall = CELLS[dimension], 4
    axes = "xyz"[:dimension]
    generator = np.random.default_rng(7)
    grid = np.stack(np.meshgrid(*[np.arange(cells) + 0.5] * dimension, indexing="ij"), -1).reshape(-1, dimension)
    points = grid + generator.uniform(-disorder, disorder, grid.shape)
    np.savetxt(folder / "points.csv", np.c_[points, np.ones(len(points))], delimiter=",", fmt="%.17g")
    speed = [f"{NOISE * SOUND_SPEED:g}*sin({'+'.join(f'{17.3 * (c + 1) + 5 * k:.1f}*{x}' for k, x in enumerate(axes))})"
             for c in range(dimension)]
    case = {
        "sphinx": 2, "dimension": dimension, "units": "none",
        "resolution": {"spacing": 1, "kernel": kernel, "smoothing_ratio": KERNELS[kernel]},
        "materials": {"water": {"type": "weakly_compressible_fluid", "density": 1, "sound_speed": SOUND_SPEED}},
        "bodies": {"water": {"kind": "fluid", "material": "water", "particles": {"file": "points.csv"},
                             "initial": {"velocity": speed}}},
        "topology": {"water": ["self"]},
        "dynamics": {"gravity": {"type": "force.gravity", "body": "water", "acceleration": [0] * dimension},
                     "relaxation": {"type": "fluid.pressure_relaxation", "body": "water", "riemann": riemann},
                     "acoustic_dt": {"type": "fluid.acoustic_time_step", "body": "water"},
                     "neighbors": {"type": "neighbors.update", "bodies": ["water"]}},
        "loop": {"end_time": 1, "start": ["neighbors"], "layer": "acoustic", "dt": "acoustic_dt",
                 "steps": ["gravity", "relaxation.first_half", "relaxation.second_half", "neighbors"]},
        "outputs": {"energy": {"type": "reduce", "every": {"steps": 20}, "body": "water",
                               "quantity": "mechanical_energy"}},
    }
    if walls:
        case["geometry"] = {"inside": {"box": {"lower": [0] * dimension, "upper": [cells] * dimension}},
                            "tank": {"difference": [{"offset": {"shape": "inside", "by": wall}}, "inside"]}}
        case["materials"]["rigid"] = {"type": "rigid"}
        case["bodies"]["tank"] = {"kind": "solid", "shape": "tank", "material": "rigid"}
        case["topology"]["water"].append("tank")
        case["dynamics"]["normals"] = {"type": "geometry.normals_from_shape", "body": "tank"}
        case["loop"]["start"].append("normals")
    else:
        case["domain"] = {"lower": [0] * dimension, "upper": [cells] * dimension, "periodic": list(axes)}
    path = folder / "case.yaml"
    path.write_text(yaml.safe_dump(case, sort_keys=False))
    return path


def run(kernel, dimension, factor, *settings, **what):
    """`factor` is dt c0/h, None for the default. Returns the growth of the energy over the last half of the
    steps, and the factor; infinite where particles fly off or the run ends for another reason of that kind."""
    with tempfile.TemporaryDirectory() as folder:
        case = box(pathlib.Path(folder), kernel, dimension, **what)
        unit = KERNELS[kernel] / SOUND_SPEED
        end = (STEPS - 0.5) * (factor or 0.5) * unit
        if factor:
            settings += (f"loop.dt={factor * unit!r}",)
        try:
            done = checks.Run(case, f"loop.end_time={end!r}", *settings)
        except SystemExit as failure:
            if " ended with 3:" not in str(failure):
                raise
            return np.inf, factor
        steps = json.loads((done.output / "profile.json").read_text())["steps"]["acoustic"]
        energy = done.series("energy")
        total = energy["kinetic"] + energy["internal"]
        return total[-1] / total[len(total) // 2], end / (steps * unit)


def study():
    for dimension, kernel, riemann in itertools.product(CELLS, KERNELS, ("none", "low_dissipation", "dissipative")):
        cells = []
        for disorder in (0, 0.1, 0.2, 0.3):
            found = []
            for walls in (False,) if riemann == "none" else (False, True):
                low, high = 0.3, 2.6
                while high - low > 0.01:
                    factor = (low + high) / 2
                    growth, _ = run(kernel, dimension, factor, disorder=disorder, walls=walls, riemann=riemann)
                    low, high = (factor, high) if growth < 4 else (low, factor)
                found.append(f"{low:.2f}")
            cells.append(", ".join(found))
        print(f"| {dimension}D, {kernel}, {riemann} | {lattice_limit(kernel, dimension, riemann):.3f} | "
              f"{' | '.join(cells)} |", flush=True)


def main():
    checks.arguments(study=study)
    report = checks.Report()
    for dimension, kernel in itertools.product(CELLS, KERNELS):
        name = f"{dimension}D, {kernel}"
        for riemann in ("none", "low_dissipation"):
            limit = lattice_limit(kernel, dimension, riemann)
            for part, low, high in ((0.96, 0, 1.5), (1.03, 10, np.inf)):
                growth, _ = run(kernel, dimension, part * limit, riemann=riemann)
                report.check(f"{name}, {riemann}: growth of the energy at {part} of the limit, {limit:.3f}", growth, low, high)
        growth, factor = run(kernel, dimension, None, disorder=0.1, walls=True)
        report.check(f"{name}: growth with the default factor, particles in disorder, between walls", growth, 0, 1)
        report.check(f"{name}: the default factor over the limit", factor / lattice_limit(kernel, dimension, "dissipative"),
                     *MARGIN)
    report.end()


if __name__ == "__main__":
    main()
