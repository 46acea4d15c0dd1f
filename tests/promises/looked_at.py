# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Results are looked at with scripts/picture and scripts/read_results.py."""

import re
import subprocess
import sys
import unittest

import numpy as np
from PIL import Image

from results import read_csv
from support import REPOSITORY, SECONDS, Promise


class LookedAt(Promise):
    def script(self, name, *arguments, expect=0):
        done = subprocess.run([sys.executable, REPOSITORY / "scripts" / name, *map(str, arguments)],
                              capture_output=True, text=True, timeout=SECONDS, check=False)
        said = done.stdout + done.stderr
        self.assertEqual(done.returncode, expect, said)
        return said

    def run_of(self, name, **changes):
        self.sphinx(self.case(name, **changes), self.folder / name)
        return self.folder / name

    def pixels(self, path):
        with Image.open(path) as image:
            return np.asarray(image.convert("RGB")).astype(int)

    def assert_drawn(self, pixels, width):
        """Some of it white, some of it in colours, which are not those of a single value."""
        self.assertGreaterEqual(pixels.shape[1], width)
        pixels = pixels[40:-105]  # without title and colour bar
        coloured = np.ptp(pixels, axis=2) > 40
        self.assertGreater(coloured.mean(), 0.03)
        self.assertGreater((pixels == 255).all(axis=2).mean(), 0.03)
        self.assertGreater(np.ptp(pixels[coloured][:, 0]), 100)

    def test_picture_2d(self):
        out = self.run_of("splash_2d", loop__end_time=0.2)
        said = self.script("picture", out, "--width", "300")
        self.assertRegex(said, r"picture.png: pressure of water at time 0\.2")
        self.assert_drawn(self.pixels(out / "picture.png"), 300)
        first = self.folder / "first.png"
        said = self.script("picture", out, "--width", "300", "--time", "0", "--out", first)
        self.assertRegex(said, r"at time 0\n")
        self.assertFalse(np.array_equal(self.pixels(first), self.pixels(out / "picture.png")))
        # Seen from the water, which has moved, the tank is elsewhere.
        ridden = out / "ridden.png"
        self.script("picture", out, "--width", "300", "--follow", "water", "--out", ridden)
        self.assertFalse(np.array_equal(self.pixels(ridden), self.pixels(out / "picture.png")))
        said = self.script("picture", out, "--follow", "nobody", expect=1)
        self.assertIn("no body 'nobody' to follow", said)
        said = self.script("picture", out, "--field", "temperature", expect=1)
        self.assertIn("no body has the field 'temperature'; there are: ", said)

    def test_picture_3d(self):
        out = self.run_of("splash_3d", loop__end_time=0.1)
        self.script("picture", out, "--width", "300")
        self.assert_drawn(self.pixels(out / "picture.png"), 200)

    def test_read_results(self):
        out = self.run_of("gate_2d", loop__end_time=0.1)
        said = self.script("read_results.py", out)
        energy = read_csv(out / "energy.csv")
        kinetic = re.search(r"energy: kinetic \[\S+\], (\d+) times up to (\S+), largest (\S+)", said)
        self.assertIsNotNone(kinetic, said)
        times, end, largest = map(float, kinetic.groups())
        self.assertEqual(times, len(energy))
        self.assertAlmostEqual(end, energy[-1, 0], places=5)
        self.assertAlmostEqual(largest / energy[:, 1].max(), 1, places=4)
        for name in ("energy", "tip", "reaction", "force"):
            self.assertRegex(said, rf"\n{name}\.csv: time")


if __name__ == "__main__":
    unittest.main()
