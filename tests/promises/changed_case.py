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

    def test_version_of_the_language_is_free_where_it_leaves_the_state(self):
        whole = self.folder / "whole"
        self.sphinx(self.case_file, whole)
        self.case("splash_2d", sphinx=1)
        said = self.sphinx(self.case_file, self.output, "--resume")
        self.assertIn("since version 2 of the language", said)
        self.assert_same_physics(last_restart(self.output), last_restart(whole))

    def test_other_physics_is_refused(self):
        changes = {
            "variables.spacing=0.04": "spacing: 0.04",
            "resolution.smoothing_ratio=1.4": "smoothing_ratio: 1.4",
            "resolution.kernel=cubic_spline": "kernel: cubic_spline",
            "materials.fresh_water.viscosity=0.003": "viscosity: 0.003",
            "dynamics.gravity.acceleration=[0, -2]": "acceleration: [0, -2]",
            "dynamics.pressure_relaxation.riemann=none": "riemann: none",
            "loop.start_time=-1": "start_time: -1",
            "loop.steps=[density_summation, gravity, {layer: acoustic, dt: acoustic_dt, steps: "
            "[pressure_relaxation.first_half, pressure_relaxation.second_half]}, neighbors]": "- viscosity",
        }
        before = content(self.output)
        for change, shown in changes.items():
            with self.subTest(change=change):
                said = self.sphinx(self.case_file, self.output, "--resume", "--set", change, expect=2)
                self.assertIn("only title, observers, outputs, loop.end_time and domain.lost_particles may change", said)
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
        good, other = column.read_text(), "0 0\n0.6 0\n0.6 0.5\n0 0.6\n"
        column.write_text(other)
        said = self.sphinx(path, output, "--resume", expect=2)
        self.assertRegex(said, rf"\n- +file: .column.txt \({len(good)} bytes, .*\n"
                               rf"\+ +file: .column.txt \({len(other)} bytes, ")
        self.assertEqual(results.changed(before, content(output)), [])
        column.write_text(good)
        # The same files at another place are the same physics, and what observers read is none.
        points.write_text("1.5, 0.2\n0.3, 0.1\n")
        elsewhere = self.folder / "elsewhere"
        elsewhere.mkdir()
        for moved in (path, column, points):
            moved.rename(elsewhere / moved.name)
        self.sphinx(elsewhere / path.name, output, "--resume")

    def test_observers_are_free(self):
        whole = self.folder / "whole"
        self.sphinx(self.case_file, whole)
        case = load_case("splash_2d")
        del case["bodies"]["probe"]["points"][0]
        case["bodies"]["probe"]["points"].append([0.5, 0.05])
        case["bodies"]["gauge"] = {"kind": "observer", "points": [[0.2, 0.1]]}
        case["topology"]["gauge"] = ["water"]
        case["outputs"]["gauge"] = {"type": "observe", "every": {"time": 0.05}, "observer": "gauge",
                                    "fields": ["pressure"]}
        self.write_case("splash_2d", case)
        self.sphinx(self.case_file, self.output, "--resume")
        self.assert_same_physics(last_restart(self.output), last_restart(whole))
        results.check_readable(self.output)

    def test_followers_of_the_material_that_move_attach_anew(self):
        """One that stays the same keeps its particles, the same as in a run in one go."""
        case, whole, parts = load_case("gate_2d"), self.folder / "gate_whole", self.folder / "gate_parts"
        path = self.write_case("gate", case)
        self.sphinx(path, whole)
        tip = results.read_csv(whole / "tip.csv")
        half = float(tip[len(tip) // 2, 0])
        self.sphinx(path, parts, "--set", f"loop.end_time={half}")
        shutil.copytree(parts, self.folder / "moved")
        self.sphinx(path, parts, "--resume")
        self.assertEqual((parts / "tip.csv").read_text(), (whole / "tip.csv").read_text())

        case["bodies"]["tip"]["points"][0][1] = "4*spacing"
        self.write_case("gate", case)
        self.sphinx(path, self.folder / "moved", "--resume")
        self.assert_same_physics(last_restart(self.folder / "moved"), last_restart(whole))
        moved = results.read_csv(self.folder / "moved/tip.csv")
        self.assertEqual(len(moved), len(tip))
        first = int((moved[:, 0] <= half).sum())
        self.assertEqual(moved[:first].tolist(), tip[:first].tolist())
        self.assertTrue((moved[first:, 1:] != tip[first:, 1:]).any(axis=1).all())

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

    def test_newest_by_what_it_says_itself(self):
        older, newest = restarts(self.output).values()
        shutil.copy(older, self.output / "restart" / "notes_5000.xml")
        said = self.sphinx(self.case_file, self.output, "--resume")
        self.assertIn(f"going on from {newest}", said)

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

    def test_what_a_run_reads_is_not_overwritten(self):
        part, points = self.output / "part.yaml", self.output / "points.csv"
        case = load_case("splash_2d")
        outer = self.folder / "outer.yaml"
        inner = self.output / "inner.yaml"
        inner.write_text(self.case_file.read_text())
        case["bodies"]["probe"]["points"] = {"file": "out/points.csv"}
        points.write_text("1.5, 0.1\n0.3, 0.1\n")
        reads_points = self.write_case("reads_points", case)
        del case["bodies"]["probe"]["points"]
        part.write_text("title: from the part\n")
        includes = load_case("splash_2d")
        del includes["title"]
        includes["include"] = ["out/part.yaml"]
        including = self.write_case("including", includes)
        outer.symlink_to(inner)
        link = self.output / "link.yaml"
        link.symlink_to(self.case_file)
        before = content(self.output)
        for path, read in ((inner, inner), (reads_points, points), (including, part), (outer, outer),
                           (link, link)):
            with self.subTest(path=path):
                said = self.sphinx(path, self.output, "--overwrite", expect=4)
                self.assertIn(f"error: --overwrite would remove {read}, which the run reads", said)
                self.assertEqual(results.changed(before, content(self.output)), [])
        # Beside the folder they are not in its way.
        self.sphinx(self.case_file, self.output, "--overwrite", "--set", "loop.end_time=0.1")
        self.assertFalse(points.exists())


if __name__ == "__main__":
    unittest.main()
