# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""What `sphinx check` says of bodies, lattices and the domain before anything runs."""

import re
import subprocess
import unittest

from support import SECONDS, SPHINX, Promise, last_restart

BLOCK = {
    "sphinx": 2, "dimension": 2, "resolution": {"spacing": 0.1},
    "geometry": {"block": {"box": {"lower": [0, 0], "upper": [1, 1]}}},
    "materials": {"water": {"type": "weakly_compressible_fluid", "density": 1000, "sound_speed": 20}},
    "bodies": {"water": {"kind": "fluid", "shape": "block", "material": "water"}},
    "topology": {"water": ["self"]},
    "dynamics": {"neighbors": {"type": "neighbors.update", "bodies": ["water"]}},
    "loop": {"end_time": 0.001, "start": ["neighbors"], "layer": "all", "dt": 0.001, "steps": ["neighbors"]},
}


def standing(velocity, domain=None, **shapes):
    """A rigid body with a velocity that nothing moves, and water about it."""
    acoustic = {"layer": "acoustic", "dt": "acoustic_dt",
                "steps": ["relaxation.first_half", "relaxation.second_half"]}
    return {**BLOCK, **({"domain": domain} if domain else {}), "geometry": shapes,
            "materials": {**BLOCK["materials"], "rigid": {"type": "rigid"}},
            "bodies": {**BLOCK["bodies"], "wall": {"kind": "solid", "shape": "wall", "material": "rigid",
                                                   "initial": {"velocity": velocity}}},
            "topology": {"water": ["self", "wall"]},
            "dynamics": {**BLOCK["dynamics"],
                         "gravity": {"type": "force.gravity", "body": "water", "acceleration": [0, 0]},
                         "normals": {"type": "geometry.normals_from_shape", "body": "wall"},
                         "relaxation": {"type": "fluid.pressure_relaxation", "body": "water"},
                         "acoustic_dt": {"type": "fluid.acoustic_time_step", "body": "water"}},
            "loop": {"end_time": 0.001, "start": ["neighbors", "normals"], "layer": "all", "dt": 0.001,
                     "steps": ["gravity", acoustic, "neighbors"]}}


class Checked(Promise):
    def check(self, case):
        return self.check_ends(case, 0)

    def check_ends(self, case, code):
        path = self.write_case("case", case)
        done = subprocess.run([SPHINX, "check", path], capture_output=True, text=True, timeout=SECONDS,
                              check=False)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def block(self, **shape):
        case = {**BLOCK, "geometry": {"block": shape}}
        said = self.check(case)
        return said, next(line for line in said.splitlines() if line.startswith("  water: "))

    def places(self, **shape):
        """Of the particles, by id."""
        case = {**BLOCK, "geometry": {"block": shape}}
        output = self.folder / "out"
        self.sphinx(self.write_case("case", case), output, "--overwrite")
        return last_restart(output).values("water", "position")

    def test_volume_and_mass(self):
        _, line = self.block(box={"lower": [0, 0], "upper": [1, 1]})
        self.assertEqual(line, "  water: 100 particles, spacing 0.1 m, quintic_spline with h 0.1 m, "
                               "volume 1 m^3, mass 1000 kg")
        said, line = self.block(circle={"center": [0.5, 0.5], "radius": 0.5})
        self.assertRegex(line, r"volume 0\.8 m\^3, mass 800 kg \(its shape: 0\.785398 m\^3\)")
        self.assertRegex(said, r"warning: the particles of water have \+1\.9 % of the volume of its shape, "
                               r"0\.8 m\^3 for 0\.785398 m\^3: the shape measures 10 x 10 spacings")
        self.assertNotIn("volume of its shape", self.block(box={"lower": [0, 0], "upper": [1, 1]})[0])

    def test_rigid_bodies_slide_and_do_not_move(self):
        lid = {"box": {"lower": [0, 1], "upper": [1, 1.4]}}
        wide_lid = {"box": {"lower": [-0.4, 1], "upper": [1.4, 1.4]}}
        cavity = {"box": {"lower": [0, 0], "upper": [1, 1]}}
        ring = {"difference": [{"circle": {"center": [0, 0], "radius": 1.4}},
                               {"circle": {"center": [0, 0], "radius": 1}}]}
        disc = {"circle": {"center": [0, 0], "radius": 1}}
        drop = {"box": {"lower": [0, 3], "upper": [1, 4]}}
        turning = ["0 - 3*y", "3*x"]
        periodic = {"lower": [0, -0.5], "upper": [1, 2], "periodic": ["x"]}
        for case in (standing([1, 0], block=cavity, wall=lid), standing([1, 0], block=cavity, wall=wide_lid),
                     standing([1, 0], periodic, block=cavity, wall=lid),
                     standing(turning, block=disc, wall=ring), standing(turning, block=ring, wall=disc),
                     standing([1, 0], block=drop, wall=wide_lid), standing([0, 0], block=cavity, wall=lid)):
            self.check(case)
        for case in (standing([0, 1], block=cavity, wall=lid), standing([0.995, 0.1], block=cavity, wall=lid),
                     standing(["x", "y"], block=disc, wall=ring), standing([1, 0], block=ring, wall=disc),
                     standing([0, -1], block=drop, wall=wide_lid)):
            self.assertIn("wall stands still: a rigid body moves by constraint.prescribed_motion",
                          self.check_ends(case, 2))

    def test_a_lattice_on_opposite_faces_moves_by_half_a_spacing(self):
        for shift in (0, 0.05, 0.5, -0.35):
            said, line = self.block(box={"lower": [shift, shift], "upper": [1 + shift, 1 + shift]})
            self.assertIn("100 particles", line)
            self.assertIn("mass 1000 kg", line)
            moved = ", lattice moved by half a spacing in x, y"
            self.assertEqual(moved in line, abs(shift / 0.1 % 1 - 0.5) < 0.1, line)
            self.assertNotIn("volume of its shape", said)

    def test_a_beam_about_its_axis_has_whole_rows(self):
        for rows in range(3, 8):
            places = self.places(box={"lower": [0, -0.05 * rows], "upper": [1, 0.05 * rows]})
            heights = sorted(set(places[:, 1].round(9)))
            self.assertEqual(len(heights), rows)
            self.assertAlmostEqual(heights[0], -heights[-1], 12)
            self.assertAlmostEqual(heights[-1], 0.05 * (rows - 1), 12)

    def test_who_shares_a_face_moves_along(self):
        """A tank with 3.5 spacings of wall about water of which the lattice moves."""
        case = {**BLOCK,
                "geometry": {"block": {"box": {"lower": [0.05, 0.05], "upper": [1.05, 1.05]}},
                             "outer": {"offset": {"shape": "block", "by": 0.35}},
                             "tank": {"difference": ["outer", "block"]}},
                "materials": {**BLOCK["materials"], "rigid": {"type": "rigid"}},
                "bodies": {**BLOCK["bodies"], "tank": {"kind": "solid", "shape": "tank", "material": "rigid"}},
                "topology": {"water": ["self", "tank"]},
                "dynamics": {**BLOCK["dynamics"], "normals": {"type": "geometry.normals_from_shape", "body": "tank"}},
                "loop": {**BLOCK["loop"], "start": ["neighbors", "normals"]}}
        said = self.check(case)
        self.assertEqual(said.count("lattice moved by half a spacing in x, y"), 2, said)

    def test_a_point_on_an_oblique_face_costs_the_symmetry(self):
        said, line = self.block(polygon=[[0, 0], [1, 0], [1, 1]])
        self.assertIn("10 lattice points on its surface (kept where the body goes on towards larger "
                      "coordinates: not symmetric)", line)
        self.assertRegex(line, r"(45|55) particles")
        self.assertRegex(said, r"warning: the particles of water have [+-]10 % of the volume")

    def test_room_around_the_shapes(self):
        said, _ = self.block(box={"lower": [0, 0], "upper": [1, 0.5]})
        self.assertRegex(said, r"\ndomain: \(-1, -1\) m to \(2, 1\.5\) m\n")
        case = {**BLOCK, "domain": {"upper": [1.5, 1.2]}}
        self.assertRegex(self.check(case), r"\ndomain: \(-1, -1\) m to \(1\.5, 1\.2\) m\n")

    def test_tables_may_begin_with_a_byte_order_mark(self):
        (self.folder / "points.csv").write_text("\ufeff0.5, 0.5\n0.25, 0.5\n", encoding="utf-8")
        case = {**BLOCK, "bodies": {**BLOCK["bodies"], "probe": {"kind": "observer", "points": {"file": "points.csv"}}},
                "topology": {"water": ["self"], "probe": ["water"]}}
        self.assertIn("  probe: 2 particles", self.check(case))

    def test_the_first_language_is_told(self):
        case = {**BLOCK, "sphinx": 1, "geometry": {"block": {"box": {"lower": [0.05, 0], "upper": [1.05, 1]}}}}
        self.assertRegex(self.check(case), r"warning: since version 2 of the language a lattice whose points would "
                                           r"fall on opposite faces of the body moves by half a spacing")
        case["geometry"] = {"block": {"polygon": [[0, 0], [1, 0], [1, 1]]}}
        self.assertRegex(self.check(case), r"warning: since version 2 of the language a lattice point on the surface")
        self.assertNotIn("since version", self.check(
            {**BLOCK, "sphinx": 1, "resolution": {"spacing": 0.1, "smoothing_ratio": 1.3}}))


class Named(Promise):
    def test_a_case_is_called_as_its_folder(self):
        """Also where the path does not say it."""
        inside = self.folder / "small_tank" / "below"
        inside.mkdir(parents=True)
        (inside.parent / "case.yaml").write_text(self.case("splash_2d").read_text())
        for folder, path in ((inside.parent, "case.yaml"), (inside.parent, "./case.yaml"), (inside, "../case.yaml")):
            output = folder / "output/small_tank"
            said = subprocess.run([SPHINX, "run", path, "--overwrite", "--set", "loop.end_time=0.01"], cwd=folder,
                                  capture_output=True, text=True, timeout=SECONDS, check=False)
            self.assertEqual(said.returncode, 0, said.stderr)
            self.assertTrue(re.search(r"results are in output/small_tank$", said.stdout.strip()), said.stdout)
            self.assertTrue(list((output / "restart").glob("small_tank_*.xml")))


if __name__ == "__main__":
    unittest.main()
