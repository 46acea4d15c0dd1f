# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""1, 2 and 7 threads give the same bits, at every restart of a run."""

import shutil
import unittest

from support import Promise, Restart, restarts

# Loops are shared out in ranges of some hundred particles: this many make several.
PARTICLES = 5000


class Threads(Promise):
    def same_for_all_threads(self, name, changes, body="water"):
        outputs = {"restart": {"type": "restart", "every": {"steps": 5}, "keep": 1000}}
        case = self.case(name, **changes, outputs=outputs)
        for threads in (1, 2, 7):
            self.sphinx(case, self.folder / str(threads), threads=threads)
        one = restarts(self.folder / "1")
        self.assertGreaterEqual(len(one), 4)
        self.assertGreater(len(Restart(one[5]).values(body, "id")), PARTICLES)
        for threads in ("2", "7"):
            self.assertEqual(list(restarts(self.folder / threads)), list(one))
            for path in one.values():
                self.assert_same_physics(Restart(path), Restart(self.folder / threads / "restart" / path.name))

    def test_2d(self):
        self.same_for_all_threads("splash_2d", {"variables__spacing": 0.6 / 81, "loop__end_time": 0.12})

    def test_3d(self):
        self.same_for_all_threads("splash_3d", {"variables__spacing": 0.4 / 16, "loop__end_time": 0.2})

    def test_solver(self):
        self.same_for_all_threads("honey_2d", {"variables__spacing": 0.6 / 81, "loop__end_time": 0.08})

    def test_stress_of_fluids(self):
        for name in ("polymers_2d", "thinning_2d"):
            with self.subTest(case=name):
                self.same_for_all_threads(name, {"variables__spacing": 0.01, "loop__end_time": 0.02})
                for threads in (1, 2, 7):
                    shutil.rmtree(self.folder / str(threads))

    def test_two_liquids(self):
        self.same_for_all_threads("liquids_2d", {"variables__spacing": 1 / 80, "loop__end_time": 0.05})

    def test_two_liquids_at_an_elastic_gate(self):
        self.same_for_all_threads("oil_gate_2d", {"variables__spacing": 0.5 / 120, "loop__end_time": 0.05})

    def test_elastic(self):
        self.same_for_all_threads(
            "gate_2d", {"variables__refined": 3, "variables__spacing": 0.025, "loop__end_time": 0.15,
                        "materials__rubber__youngs_modulus": 400}, "gate")

    def test_elastic_with_loads_and_motion(self):
        size = {"variables__spacing": 0.008, "variables__width": 0.4, "variables__length": 1.2}
        self.same_for_all_threads("strip_2d", {**size, "loop__end_time": 0.02}, "strip")

    def test_mechanism(self):
        self.same_for_all_threads("raft_2d", {"variables__spacing": 0.0125, "loop__end_time": 0.1})

    def test_contact(self):
        self.same_for_all_threads("contact_3d", {}, "slab")

    def test_elastic_3d(self):
        size = {"variables__spacing": 0.02, "variables__width": 0.3, "variables__length": 0.8}
        self.same_for_all_threads("clamped_3d", {**size, "loop__end_time": 0.02}, "beam")


if __name__ == "__main__":
    unittest.main()
