# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""A mirrored or turned case moves as the mirrored or turned original."""

import random
import unittest

import numpy as np

from support import Promise, last_restart, load_case

SPACING = 0.05
STEPS = 200
SEEDS = range(1, 9)
# In spacings. It is 0 where no sum depends on the order of its terms: see core/exact_sum.h.
POSITION_ERROR = 1e-9

# Of a point, and of a velocity or acceleration, to the new place; and the old x, y of a new point.
TURNS = {
    "original": (lambda x, y: (x, y), ("x", "y")),
    "mirrored": (lambda x, y: (-x, y), ("(-x)", "y")),
    "turned": (lambda x, y: (-y, x), ("y", "(-x)")),
}


def velocity_text(turn):
    """Of a velocity field, as expressions of the new coordinates."""
    _, (x, y) = TURNS[turn]
    u = f"(0.3*sin(3*{x} + {y}) + 0.1*{x})"
    v = f"(0.2*cos(2*{x} - {y}) - 0.1*{y})"
    return {"original": [u, v], "mirrored": [f"-{u}", v], "turned": [f"-{v}", u]}[turn]


def box(turn, lower, upper):
    corners = np.array([TURNS[turn][0](*lower), TURNS[turn][0](*upper)])
    return {"box": {"lower": corners.min(axis=0).tolist(), "upper": corners.max(axis=0).tolist()}}


def splash(turn, seed, name="splash_2d"):
    """A block of shaken particles falls in a tank that is not symmetric itself."""
    chance = random.Random(seed)
    case = load_case(name)
    case["geometry"]["inside"] = box(turn, (-0.45, 0), (0.8, 0.8))
    del case["geometry"]["column"]
    points = []
    for i in range(14):
        for k in range(12):
            x = (i - 8.5) * SPACING + 0.1 * SPACING * chance.uniform(-1, 1)
            y = (k + 0.5) * SPACING + 0.1 * SPACING * chance.uniform(-1, 1)
            points.append([*TURNS[turn][0](x, y), SPACING**2])
    water = case["bodies"]["water"]
    del water["shape"]
    water["particles"] = points
    water["initial"] = {"velocity": velocity_text(turn)}
    case["dynamics"]["gravity"]["acceleration"] = list(TURNS[turn][0](0, -1))
    for observer in ("probe", "buoy"):
        case["bodies"].pop(observer, None)
        case["topology"].pop(observer, None)
    case["outputs"] = {"restart": {"type": "restart", "every": {"steps": STEPS}, "keep": 100}}
    case["loop"]["end_time"] = 2.2
    return case


def two_liquids(case):
    """Every other particle becomes oil, in the order in which splash() made them: they are rows, and fall apart."""
    bodies, dynamics, steps = case["bodies"], case["dynamics"], case["loop"]["steps"]
    points = bodies["water"]["particles"]
    case["materials"]["crude_oil"] = {**case["materials"]["fresh_water"], "density": 0.3, "viscosity": 0.01}
    bodies["oil"] = {**bodies["water"], "material": "crude_oil", "particles": points[1::2]}
    bodies["water"]["particles"] = points[::2]
    case["topology"] = {"water": ["self", "oil", "wall"], "oil": ["self", "water", "wall"]}
    del dynamics["pressure_relaxation"]["body"]
    dynamics["pressure_relaxation"]["bodies"] = ["water", "oil"]
    dynamics["neighbors"]["bodies"].append("oil")
    for name in ("gravity", "density_summation", "viscosity", "advection_dt", "acoustic_dt", "sort"):
        dynamics[f"oil_{name}"] = {**dynamics[name], "body": "oil"}
    acoustic = next(step for step in steps if isinstance(step, dict) and "layer" in step)
    acoustic["dt"] = ["acoustic_dt", "oil_acoustic_dt"]
    case["loop"]["dt"] = ["advection_dt", "oil_advection_dt"]
    case["loop"]["steps"] = ["oil_density_summation", "oil_viscosity", "oil_gravity", *steps[:-1],
                             {"run": "oil_sort", "every": {"steps": 5}}, steps[-1]]
    return case


class Mirrored(Promise):
    def same_in_all_turns(self, seed, change=lambda case: case, scene="splash_2d", least=5 * SPACING):
        position = {}
        for turn in TURNS:
            case = change(splash(turn, seed, scene))
            name = f"{turn}_{seed}"
            fluids = [name for name, body in case["bodies"].items() if body["kind"] == "fluid"]
            self.sphinx(self.write_case(name, case), self.folder / f"{name}_out", "--overwrite")
            restart = last_restart(self.folder / f"{name}_out")
            self.assertGreaterEqual(restart.steps, STEPS)
            position[turn] = np.concatenate([restart.by_id(fluid, "position") for fluid in fluids])
            if turn == "original":
                start = np.array([p[:2] for fluid in fluids for p in case["bodies"][fluid]["particles"]])
        moved = np.abs(position["original"] - start).max()
        self.assertGreater(moved, least, "nothing moved")
        for turn in ("mirrored", "turned"):
            x, y = position["original"].T
            error = np.abs(position[turn] - np.array(TURNS[turn][0](x, y)).T).max() / SPACING
            print(f"{' and '.join(fluids)}, {turn}, seed {seed}: {error:.1e} spacings off")
            self.assertLessEqual(error, POSITION_ERROR)

    def test_mirrored_and_turned(self):
        for seed in SEEDS:
            self.same_in_all_turns(seed)

    def test_two_liquids(self):
        for seed in (1, 2):
            self.same_in_all_turns(seed, two_liquids)

    def test_honey(self):
        for seed in (1, 2):
            self.same_in_all_turns(seed, scene="honey_2d", least=SPACING)


if __name__ == "__main__":
    unittest.main()
