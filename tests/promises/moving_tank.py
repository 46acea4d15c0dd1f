# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""A fluid in a tank that moves does what it does in the same tank at rest."""

import unittest

import numpy as np

from support import Promise, last_restart, load_case

SPACING = 0.05


class MovingTank(Promise):
    def run_tank(self, name, end_time, finer=1, **variables):
        case = load_case("tank_2d")
        case["variables"].update(variables)
        case["resolution"]["precision"] = "double"  # runs that differ by rounding are compared
        case["loop"]["end_time"] = end_time
        case["loop"]["dt"] /= finer
        acoustic = next(step for step in case["loop"]["steps"] if isinstance(step, dict))
        acoustic["dt"] /= finer
        output = self.folder / name
        self.sphinx(self.write_case(name, case), output)
        return last_restart(output)

    def seen_from_the_tank(self, restart, speed=0.0, push=0.0):
        t = restart.time
        wall = restart.by_id("wall", "position")
        position = restart.by_id("water", "position") - [speed * t + push * t * t / 2, 0]
        velocity = restart.by_id("water", "velocity") - [speed + push * t, 0]
        start = restart.by_id("wall", "initial_position")
        moved = np.abs(wall - start - [speed * t + push * t * t / 2, 0]).max()
        self.assertLess(moved, 1e-14)
        return position, velocity

    def test_at_constant_speed(self):
        # A sum of other roundings; the fluid is in full motion, which lets them grow.
        still = self.run_tank("still", 0.3)
        moving = self.run_tank("moving", 0.3, speed=1)
        rest = self.seen_from_the_tank(still)
        seen = self.seen_from_the_tank(moving, speed=1)
        self.assertGreater(np.abs(rest[1]).max(), 0.01)
        self.assertLess(np.abs(seen[0] - rest[0]).max(), 1e-11)
        self.assertLess(np.abs(seen[1] - rest[1]).max(), 1e-10)

    def test_a_sensor_of_the_tank_reads_the_same(self):
        # Of the water in full motion; the tank's own speed is in the velocity that it sees.
        rows = {}
        for name, speed, follows in (("still", 0, "space"), ("moving", 1, {"body": "wall"}),
                                     ("part", 1, {"body": "wall.side"})):
            case = load_case("tank_2d")
            case["resolution"]["precision"] = "double"
            case["variables"]["speed"] = speed
            case["geometry"]["side"] = {"box": {"lower": [-1, 0], "upper": [0, "height"]}}
            case["bodies"]["wall"]["parts"] = {"side": "side"}
            case["bodies"]["sensor"] = {"kind": "observer", "points": [[0.02, 0.1], [0.6, 0.33]], "follows": follows}
            case["topology"]["sensor"] = ["water"]
            case["outputs"]["seen"] = {"type": "observe", "observer": "sensor", "fields": ["pressure", "velocity"],
                                       "every": {"time": 0.02}}
            case["loop"]["end_time"] = 0.3
            path = self.write_case(name, case)
            self.sphinx(path, self.folder / name, "--set", "loop.end_time=0.15")
            self.sphinx(path, self.folder / name, "--resume")
            rows[name] = np.genfromtxt(self.folder / name / "seen.csv", delimiter=",", names=True)
        still = rows["still"]
        self.assertGreater(np.ptp(still["pressure_1"]), 0.05)
        for name in ("moving", "part"):
            moved = rows[name]
            self.assertEqual(len(moved), len(still))
            for column in still.dtype.names:
                along = column.endswith("_x")
                gain = still["time"] if along and column.startswith("position") else float(along)
                self.assertLess(np.abs(moved[column] - still[column] - gain).max(), 1e-9, column)

    def test_accelerated(self):
        # As under a force per mass the other way. Wall and fluid have their velocity at different
        # times of a step, so the difference falls with its size: 3.1e-4 and 7.7e-5.
        difference = []
        for finer in (1, 4):
            pulled = self.run_tank("pulled", 0.5, finer, pull=0.3)
            pushed = self.run_tank("pushed", 0.5, finer, push=0.3)
            rest = self.seen_from_the_tank(pulled)
            seen = self.seen_from_the_tank(pushed, push=0.3)
            self.assertGreater(np.abs(rest[1][:, 0]).max(), 0.1)  # it sloshes
            difference.append(np.abs(seen[0] - rest[0]).max())
            for folder in ("pulled", "pushed"):
                (self.folder / folder).rename(self.folder / f"{folder}_{finer}")
        self.assertLess(difference[0], 0.01 * SPACING)
        self.assertLess(difference[1], difference[0] / 3)


if __name__ == "__main__":
    unittest.main()
