# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Dynamics only names what can act; the loop alone makes it act, and only as long as it says."""

import unittest

import numpy as np

from support import Promise, last_restart, load_case

UNTIL = 0.2


def series(path, column):
    """Times and values of a column of a CSV file, whose name may have a unit."""
    with open(path) as file:
        names = file.readline().strip().split(",")
        rows = np.loadtxt(file, delimiter=",", ndmin=2)
    index = next(k for k, name in enumerate(names) if name.startswith(column))
    return rows[:, 0], rows[:, index]


def windowed(steps, method, **window):
    """Gives the lines of that method a window, in inner layers as well."""
    for k, step in enumerate(steps):
        if isinstance(step, dict) and "layer" in step:
            windowed(step["steps"], method, **window)
        elif step == method or isinstance(step, dict) and step.get("run") == method:
            steps[k] = {"run": method, **window}


class Declared(Promise):
    def run_case(self, name, case):
        output = self.folder / name
        self.sphinx(self.write_case(name, case), output)
        return last_restart(output)

    def assert_idle(self, name, dynamics):
        case = load_case(name)
        without = self.run_case("without", case)
        case["dynamics"] = {**dynamics, **case["dynamics"]}
        self.assert_same_physics(self.run_case("with", case), without)

    def test_of_a_fluid(self):
        self.assert_idle("splash_2d", {
            "a_gravity": {"type": "force.gravity", "body": "water", "acceleration": [0, -3]},
            "a_pressure": {"type": "fluid.pressure_relaxation", "body": "water"},
            "a_drag": {"type": "fluid.viscous_force", "body": "water"}})

    def test_of_an_elastic_body(self):
        self.assert_idle("strip_2d", {
            "a_clamp": {"type": "constraint.clamp", "part": "strip.left"},
            "a_gravity": {"type": "force.gravity", "body": "strip", "acceleration": [0, -3]},
            "a_relaxation": {"type": "solid.stress_relaxation", "body": "strip",
                             "hourglass_control": False}})

    def test_wall_that_stops(self):
        case = load_case("tank_2d")
        case["variables"]["push"] = 1.0
        case["loop"]["end_time"] = UNTIL + 0.1
        windowed(case["loop"]["steps"], "motion", until=UNTIL)
        # Steps of 0.002: the last one that begins before ends at that time.
        stopped = self.run_case("stopped", case)
        moved = stopped.by_id("wall", "position") - stopped.by_id("wall", "initial_position")
        self.assertLess(np.abs(moved - [UNTIL**2 / 2, 0]).max(), 1e-12)
        self.assertEqual(np.abs(stopped.values("wall", "velocity")).max(), 0)
        self.assertEqual(np.abs(stopped.values("wall", "acceleration")).max(), 0)
        # The fluid sees no other wall than one whose motion levels off.
        case = load_case("tank_2d")
        case["loop"]["end_time"] = UNTIL + 0.1
        case["dynamics"]["motion"]["displacement"] = [f"(t < {UNTIL} ? t : {UNTIL})^2/2", 0]
        level = self.run_case("level", case)
        apart = stopped.by_id("water", "position") - level.by_id("water", "position")
        self.assertLess(np.abs(apart).max(), 1e-9)

    def test_support_that_lets_go(self):
        case = load_case("strip_2d")
        case["loop"]["end_time"] = 2 * UNTIL
        for end in ("left", "right"):
            windowed(case["loop"]["steps"], end, until=UNTIL)
        case["dynamics"]["right"]["displacement"] = [0, "pulled*t^2"]
        self.run_case("let_go", case)
        times, reaction = series(self.folder / "let_go" / "reaction.csv", "reaction_y")
        self.assertGreater(np.abs(reaction[(times > 0) & (times < UNTIL)]).min(), 0)
        self.assertEqual(np.abs(reaction[times > UNTIL + 0.01]).max(), 0)

    def test_load_that_ends(self):
        case = load_case("gate_2d")
        case["loop"]["end_time"] = UNTIL + 0.1
        windowed(case["loop"]["steps"], "load", until=UNTIL)
        windowed(case["loop"]["steps"], "friction", until=UNTIL)
        case["outputs"]["tip"]["fields"] = ["pressure_force", "viscous_force"]
        self.run_case("load", case)
        for field in ("pressure_force", "viscous_force"):
            times, force = series(self.folder / "load" / "tip.csv", field)
            self.assertGreater(np.abs(force[(times > 0) & (times < UNTIL)]).min(), 0)
            self.assertEqual(np.abs(force[times > UNTIL + 0.05]).max(), 0)


if __name__ == "__main__":
    unittest.main()
