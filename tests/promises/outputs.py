# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Outputs never change the physics."""

import re
import unittest

from support import Promise, Restart, load_case, restarts

RESTART = {"type": "restart", "every": {"steps": 10}, "keep": 1000}
# Fields of an elastic body that are made for outputs alone.
DERIVED = ["displacement", "green_lagrange_strain", "piola_kirchhoff_stress", "cauchy_stress",
           "von_mises_stress", "strain_energy_density"]


class Outputs(Promise):
    def any_outputs_same_physics(self, name, elastic=None, end_time=None):
        """`elastic`: a body whose derived fields are written as well."""
        case = load_case(name)
        every = case["outputs"]
        every["restart"] = RESTART
        if elastic:
            every["derived"] = {"type": "tecplot", "every": {"steps": 20}, "bodies": {elastic: DERIVED}}
        often = {key: dict(value, every={"steps": 1}) for key, value in every.items()}
        often["restart"] = RESTART
        sets = {"restart_only": {"restart": RESTART}, "every": every, "often": often}
        sets |= {f"only_{key}": {key: value, "restart": RESTART} for key, value in every.items()}
        for key, outputs in sets.items():
            changed = self.case(name, outputs=outputs, loop__end_time=end_time or case["loop"]["end_time"])
            self.sphinx(changed, self.folder / key)
        alone = restarts(self.folder / "restart_only")
        self.assertGreaterEqual(len(alone), 4)
        for key in sets:
            self.assertEqual(list(restarts(self.folder / key)), list(alone))
            for path in alone.values():
                self.assert_same_physics(Restart(path), Restart(self.folder / key / "restart" / path.name))

    def test_2d(self):
        self.any_outputs_same_physics("splash_2d")

    def test_3d(self):
        self.any_outputs_same_physics("splash_3d")

    def test_elastic_in_fluid(self):
        self.any_outputs_same_physics("gate_2d", "gate", end_time=0.5)

    def test_elastic_with_loads_and_motion(self):
        self.any_outputs_same_physics("strip_2d", "strip")

    def test_elastic_3d(self):
        self.any_outputs_same_physics("clamped_3d", "beam")

    def test_no_outputs(self):
        case = self.case("splash_2d")
        case_folder = sorted(self.folder.iterdir())
        progress = {}
        for key, arguments in (("with", ()), ("without", ("--no-outputs",))):
            said = self.sphinx(case, self.folder / key, *arguments)
            progress[key] = re.findall(r"^time \S+ of .*step \d+", said, re.MULTILINE)
        self.assertGreater(len(progress["with"]), 3)
        self.assertEqual(progress["with"], progress["without"])
        self.assertEqual(sorted(self.folder.iterdir()), sorted(case_folder + [self.folder / "with"]))


if __name__ == "__main__":
    unittest.main()
