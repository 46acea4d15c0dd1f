# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Tables in expressions: a motion by table is the motion by formula, runs go on, files are physics."""

import subprocess
import unittest

import numpy as np

from support import SPHINX, Promise, last_restart, load_case

SPEED = 0.5


class Tables(Promise):
    def tank(self, end_time, displacement, **blocks):
        """The tank that moves along x at a constant speed, with all that is in it."""
        case = load_case("tank_2d")
        case["resolution"]["precision"] = "double"  # runs that differ by rounding are compared
        case["variables"]["speed"] = SPEED
        case["dynamics"]["motion"]["displacement"] = [displacement, 0]
        case["loop"]["end_time"] = end_time
        case.update(blocks)
        return case

    def test_motion_by_table_is_motion_by_formula(self):
        (self.folder / "motion.csv").write_text("t; x\n0; 0\n100; 50\n300; 150\n1000; 500\n")
        file = {"file": "motion.csv", "argument": {"column": "t", "unit": "ms"},
                "value": {"column": "x", "unit": "mm"}}
        rows = {"rows": [["0 s", 0], ["1000 ms", "speed"]]}
        units = {"length": "m", "time": "s", "mass": "kg"}
        formula = self.tank(0.3, "speed*t", units=units)
        self.sphinx(self.write_case("formula", formula), self.folder / "formula")
        moved = last_restart(self.folder / "formula")
        for name, table in {"file": file, "spline": {**file, "interpolation": "cubic"}, "rows": rows}.items():
            with self.subTest(table=name):
                case = self.tank(0.3, "along(t)", units=units, tables={"along": table})
                self.sphinx(self.write_case(name, case), self.folder / name)
                by_table = last_restart(self.folder / name)
                for body in ("wall", "water"):
                    far = moved.by_id(body, "position") - by_table.by_id(body, "position")
                    self.assertLess(np.abs(far).max(), 1e-11)

    def test_resolved_case_runs_the_same(self):
        table = {"rows": [["0 ms", 0], ["500 ms", "speed/2"], ["1 s", 0]], "interpolation": "cubic"}
        units = {"length": "m", "time": "s", "mass": "kg"}
        variables = {"speed": SPEED, "span": "along(0.5)", "later": "along(t) + sway*t^2", "sway": "x*0",
                     "idle": "2*t"}
        case = self.tank(0.1, "later*span/span", units=units, tables={"along": table, "unused": table},
                         variables=load_case("tank_2d")["variables"] | variables)
        path = self.write_case("written", case)
        self.sphinx(path, self.folder / "written")
        shown = subprocess.run([SPHINX, "show", str(path)], capture_output=True, text=True, check=True).stdout
        self.assertNotIn("unused", shown)
        self.assertNotIn("idle", shown)
        self.assertIn("later: along(t) + sway*t^2", shown)
        resolved = self.folder / "resolved.yaml"
        resolved.write_text(shown)
        self.sphinx(resolved, self.folder / "resolved")
        self.assert_same_physics(last_restart(self.folder / "written"), last_restart(self.folder / "resolved"))

    def test_what_a_table_holds_is_physics(self):
        content = "0 0\n1 0.5\n"
        (self.folder / "motion.txt").write_text(content)
        case = self.tank(0.1, "along(t)", tables={"along": {"file": "motion.txt"}})
        path = self.write_case("tank", case)
        output = self.folder / "out"
        self.sphinx(path, output)
        (self.folder / "motion.txt").write_text(content.replace("0.5", "0.4"))
        said = self.sphinx(path, output, "--resume", "--set", "loop.end_time=0.2", expect=2)
        self.assertRegex(said, r"\n- +file: .motion.txt \(10 bytes, .*\n\+ +file: .motion.txt \(10 bytes, ")
        # Elsewhere the same content is the same physics.
        (self.folder / "there").mkdir()
        (self.folder / "there" / "motion.txt").write_text(content)
        case["tables"]["along"]["file"] = "there/motion.txt"
        self.write_case("tank", case)
        self.sphinx(path, output, "--resume", "--set", "loop.end_time=0.2")
        whole = self.folder / "whole"
        self.sphinx(path, whole, "--set", "loop.end_time=0.2")
        self.assert_same_physics(last_restart(output), last_restart(whole))

    def test_a_table_of_time_reaches_to_the_end(self):
        # The last step, of 0.01, ends after the end time, and after the table.
        case = self.tank(0.105, "along(t)", tables={"along": {"rows": [[0, 0], [0.105, 0.0525]]}})
        path = self.write_case("tank", case)
        self.sphinx(path, self.folder / "out")
        longer = ("--resume", "--set", "loop.end_time=0.2")
        said = self.sphinx(path, self.folder / "out", *longer, expect=2)
        self.assertIn("the table 'along' has values from 0 to 0.105, but the run goes from 0 to 0.2", said)
        # To the last bit as if it had been known how it would go on.
        case["tables"]["along"]["rows"] = [[0, 0], [0.105, 0.0525], [0.21, 0.105]]
        self.sphinx(self.write_case("far", case), self.folder / "far")
        near, far = last_restart(self.folder / "out"), last_restart(self.folder / "far")
        self.assertLess(np.abs(near.by_id("water", "position") - far.by_id("water", "position")).max(), 1e-14)

    def test_outside_of_a_table_the_physics_fails(self):
        case = self.tank(0.2, "0.5*t", tables={"along": {"rows": [[0, 0], [0.2, 0.1]]}})
        case["dynamics"]["damping"] = {"type": "force.velocity_damping", "body": "water", "rate": "along(1.25*t)"}
        case["loop"]["steps"].insert(0, "damping")
        for threads in (1, 2):
            said = self.sphinx(self.write_case("tank", case), self.folder / f"out_{threads}",
                               threads=threads, expect=3)
            self.assertIn("the table 'along' has values from 0 to 0.2, but 'along(1.25*t)' asks it for 0.20", said)

    def test_a_known_motion_outside_of_a_table_is_told_before(self):
        case = self.tank(0.2, "along(1.25*t)", tables={"along": {"rows": [[0, 0], [0.2, 0.1]]}})
        said = self.sphinx(self.write_case("tank", case), self.folder / "out", expect=2)
        self.assertIn("the table 'along' has values from 0 to 0.2, but 'along(1.25*t)' asks it for 0.20", said)


if __name__ == "__main__":
    unittest.main()
