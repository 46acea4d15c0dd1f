# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""--resume: what may change in the case, damaged restarts, and a folder that stays as it is."""

import shutil
import unittest

import results
from results import content
from support import Promise, last_restart, load_case, restarts


class ChangedCase(Promise):
    def setUp(self):
        super().setUp()
        self.case_file = self.case("splash_2d")
        self.output = self.folder / "out"
        self.sphinx(self.case_file, self.output, "--set", "loop.end_time=0.5")

    def test_outputs_title_and_end_time_are_free(self):
        whole = self.folder / "whole"
        self.sphinx(self.case_file, whole)
        outputs = load_case("splash_2d")["outputs"]
        del outputs["frames"], outputs["plain"]
        outputs["speed"] = {"type": "reduce", "every": {"time": 0.02}, "body": "water",
                            "quantity": "maximum_speed"}
        outputs["series"]["bodies"] = {"water": ["density"], "wall": ["velocity", "volume"]}
        outputs["more"] = {"type": "vtu", "every": {"time": 0.05}, "bodies": {"wall": ["density"]}}
        self.case("splash_2d", outputs=outputs, title="another title")
        self.sphinx(self.case_file, self.output, "--resume")
        self.assert_same_physics(last_restart(self.output), last_restart(whole))
        results.check_readable(self.output)

    def test_other_physics_is_refused(self):
        changes = {
            "variables.spacing=0.04": "spacing: 0.04",
            "resolution.smoothing_ratio=1.4": "smoothing_ratio: 1.4",
            "resolution.kernel=cubic_spline": "kernel: cubic_spline",
            "materials.fresh_water.viscosity=0.003": "viscosity: 0.003",
            "dynamics.gravity.acceleration=[0, -2]": "acceleration: [0, -2]",
            "dynamics.pressure_relaxation.riemann=none": "riemann: none",
            "loop.start_time=-1": "start_time: -1",
            "domain.lost_particles=remove": "lost_particles: remove",
            "loop.steps=[density_summation, gravity, {layer: acoustic, dt: acoustic_dt, steps: "
            "[pressure_relaxation.first_half, pressure_relaxation.second_half]}, neighbors]": "- viscosity",
        }
        before = content(self.output)
        for change, shown in changes.items():
            with self.subTest(change=change):
                said = self.sphinx(self.case_file, self.output, "--resume", "--set", change, expect=2)
                self.assertIn("only title, outputs and loop.end_time may change", said)
                self.assertIn(shown, said)
                self.assertEqual(results.changed(before, content(self.output)), [])
                newest = list(restarts(self.output).values())[-1]
                elsewhere = self.folder / "elsewhere"
                self.sphinx(self.case_file, elsewhere, "--restart", newest, "--set", change, expect=2)
                self.assertFalse(elsewhere.exists())

    def test_variable_within_an_expression_of_place_is_physics(self):
        case = load_case("splash_2d")
        case["variables"]["shake"] = 0.5
        case["dynamics"]["gravity"] = {"type": "force.body_force", "body": "water",
                                       "acceleration": ["shake*sin(3*t)", -1]}
        path, output = self.write_case("shaken", case), self.folder / "shaken_out"
        self.sphinx(path, output, "--set", "loop.end_time=0.3")
        said = self.sphinx(path, output, "--resume", "--set", "variables.shake=0.6", expect=2)
        self.assertIn("0.6", said)
        self.sphinx(path, output, "--resume")

    def test_content_of_a_named_file_is_physics(self):
        column, points = self.folder / "column.txt", self.folder / "points.csv"
        column.write_text("0 0\n0.6 0\n0.6 0.6\n0 0.6\n")
        points.write_text("1.5, 0.1\n0.3, 0.1\n")
        case = load_case("splash_2d")
        case["geometry"]["column"] = {"polygon": {"file": "column.txt"}}
        case["bodies"]["probe"]["points"] = {"file": "points.csv"}
        path, output = self.write_case("drawn", case), self.folder / "drawn_out"
        self.sphinx(path, output, "--set", "loop.end_time=0.3")
        before = content(output)
        for file, other in ((column, "0 0\n0.6 0\n0.6 0.5\n0 0.6\n"), (points, "1.5, 0.2\n0.3, 0.1\n")):
            with self.subTest(file=file.name):
                good = file.read_text()
                file.write_text(other)
                said = self.sphinx(path, output, "--resume", expect=2)
                self.assertRegex(said, rf"\n- +file: .{file.name} \({len(good)} bytes, .*\n"
                                       rf"\+ +file: .{file.name} \({len(other)} bytes, ")
                self.assertEqual(results.changed(before, content(output)), [])
                file.write_text(good)
        # The same files at another place are the same physics.
        elsewhere = self.folder / "elsewhere"
        elsewhere.mkdir()
        for moved in (path, column, points):
            moved.rename(elsewhere / moved.name)
        self.sphinx(elsewhere / path.name, output, "--resume")

    def test_damaged_restarts(self):
        whole = self.folder / "whole"
        self.sphinx(self.case_file, whole)
        older, newest = restarts(self.output).values()
        good = newest.read_bytes()
        damages = {
            "cut short": good[: len(good) // 2],
            "empty": b"",
            "one bit": good[:3000] + bytes([good[3000] ^ 1]) + good[3001:],
            "something else": b"<svg/>\n",
        }
        for name, bad in damages.items():
            with self.subTest(damage=name):
                output = self.folder / name
                shutil.copytree(self.output, output)
                (output / "restart" / newest.name).write_bytes(bad)
                said = self.sphinx(self.case_file, output, "--resume")
                self.assertRegex(said, f"skipped .*{newest.name}: .*(cut short|damaged|not a restart)")
                self.assertIn(f"going on from {output}/restart/{older.name}", said)
                self.assert_same_physics(last_restart(output), last_restart(whole))
                results.check_readable(output)

    def test_all_restarts_damaged(self):
        for path in restarts(self.output).values():
            path.write_bytes(path.read_bytes()[:-1])
        before = content(self.output)
        said = self.sphinx(self.case_file, self.output, "--resume", expect=4)
        self.assertIn("no valid restart in", said)
        for path in restarts(self.output).values():
            self.assertIn(f"skipped {path}: ", said)
        self.assertEqual(results.changed(before, content(self.output)), [])

    def test_nothing_there(self):
        nowhere = self.folder / "nowhere"
        self.assertIn("no valid restart in", self.sphinx(self.case_file, nowhere, "--resume", expect=4))
        self.assertFalse(nowhere.exists())
        missing = self.folder / "missing.xml"
        self.sphinx(self.case_file, nowhere, "--restart", missing, expect=4)
        self.assertFalse(nowhere.exists())

    def test_results_are_not_overwritten_by_accident(self):
        before = content(self.output)
        said = self.sphinx(self.case_file, self.output, expect=4)
        self.assertIn("holds results already", said)
        newest = list(restarts(self.output).values())[-1]
        said = self.sphinx(self.case_file, self.output, "--restart", newest, "--overwrite", expect=4)
        self.assertIn("--overwrite would remove", said)
        self.assertEqual(results.changed(before, content(self.output)), [])


if __name__ == "__main__":
    unittest.main()
