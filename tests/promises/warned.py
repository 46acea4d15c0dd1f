# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""What is doubtful is said once, on the terminal and in the log, and the run goes on."""

import math
import re
import subprocess
import unittest

import support
from support import Promise


class Warned(Promise):
    def check(self, *arguments):
        done = subprocess.run([support.SPHINX, "check", str(self.case("splash_2d")), *arguments],
                              capture_output=True, text=True, timeout=support.SECONDS)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def run_with(self, *arguments, **changes):
        said = self.sphinx(self.case("splash_2d", **changes), self.folder / "out", *arguments)
        self.assertIn("done at time", said)
        return said, (self.folder / "out" / "log.txt").read_text()

    def test_speed_and_density(self):
        for said in self.run_with("--set", "materials.fresh_water.sound_speed=3*speed"):
            self.assertRegex(said, r"warning: time [0-9.]+: water moves at [0-9.]+ about its mean velocity, "
                                   r"more than a tenth of its sound speed 4.65; raise sound_speed\n")
            self.assertRegex(said, r"warning: time [0-9.]+: the density of water is off by "
                                   r"[0-9.]+ % \(up to 3 % is normal\)\n")
            self.assertEqual(said.count("warning:"), 2)

    def test_units(self):
        for said in self.run_with("--set", "materials.fresh_water.sound_speed=3*speed",
                                  units={"length": "cm", "time": "ms", "mass": "g"}):
            self.assertRegex(said, r"warning: time [0-9.]+ ms: water moves at [0-9.]+ cm/ms about its mean "
                                   r"velocity, more than a tenth of its sound speed 4.65 cm/ms; raise sound_speed\n")
            self.assertRegex(said, r"done at time [0-9.]+ ms")

    def test_speed_of_the_whole(self):
        """Water at rest in a tank that moves is compressed by nothing."""
        case = self.case("tank_2d", variables__speed=4, domain={"lower": [-1, -1], "upper": [6, 2]})
        said = self.sphinx(case, self.folder / "tank", "--set", "loop.end_time=0.5")
        self.assertNotIn("warning", said)
        said = self.sphinx(case, self.folder / "jet", "--set", "loop.end_time=0.1", "--set",
                           "bodies.water.initial.velocity=['y > 0.3 ? 8 : 4', 0]")
        self.assertRegex(said, r"water moves at [0-9.]+ about its mean velocity, more than a tenth of its sound speed 15")

    def test_thin_wall(self):
        for said in self.run_with("--set", "variables.wall_width=2*spacing",
                                  "--set", "loop.end_time=0.1"):
            self.assertRegex(said, r"(?m)^\S+:\d+:3: warning: wall is only 2 layers of particles "
                                   r"thick, .*\n    wall:\n    \^\n(?!\n)")

    def test_changes_of_the_language(self):
        listed = (support.REPOSITORY / "schemas/CHANGES.md").read_text()
        said = self.check("--set", "sphinx=1").stderr
        changes = re.findall(r"warning: since version \d+ of the language (.*); 'sphinx: \d+'", said)
        self.assertTrue(changes)
        for change in changes:
            self.assertIn(change, listed)

    def test_nothing_to_warn_of(self):
        for said in self.run_with("--set", "loop.end_time=0.1"):
            self.assertNotIn("warning", said)

    def test_removed_particles(self):
        """All of them in the log, but not a line each on the terminal."""
        domain = {"lower": [-1, -1], "upper": [0.62, 2], "lost_particles": "remove"}
        output = self.folder / "out"
        said = self.sphinx(self.case("splash_2d", domain=domain), output)
        log = (output / "log.txt").read_text()
        one = re.compile(r"^removed: particle (\d+) of water left the domain at \(\S+, \S+\), time \S+: "
                         r"it reaches from \(-1, -1\) to \(0.62, 2\)$", re.MULTILINE)
        removed = one.findall(log)
        self.assertGreater(len(removed), 30)
        self.assertEqual(len(set(removed)), len(removed))
        self.assertEqual(one.findall(said), removed[:3])
        self.assertIn("removed: 10 particles so far; the log has the place of each\n", said)
        self.assertEqual(said.count("removed:"), 3 + int(math.log10(len(removed))))
        for text in said, log:
            self.assertIn(f"water: {len(removed)} particles left the domain and were removed\n", text)

    def test_disk_space(self):
        self.assertEqual(self.check().stderr, "")
        done = self.check("--set", "outputs.frames.every={time: 1e-12}")
        self.assertRegex(done.stderr, r"splash_2d.yaml:\d+:3: warning: the outputs may need \S+ TB, "
                                      r"but the disk of this folder has \S+ .B left\n")


if __name__ == "__main__":
    unittest.main()
