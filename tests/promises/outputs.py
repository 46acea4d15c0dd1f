# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Outputs never change the physics."""

import re
import subprocess
import unittest

from support import SECONDS, SPHINX, Promise, Restart, load_case, restarts

RESTART = {"type": "restart", "every": {"steps": 10}, "keep": 1000}
# Fields of an elastic body that are made for outputs alone.
DERIVED = ["displacement", "green_lagrange_strain", "piola_kirchhoff_stress", "cauchy_stress",
           "von_mises_stress", "strain_energy_density"]


class Outputs(Promise):
    def any_outputs_same_physics(self, name, elastic=None, end_time=None, further=None, **changes):
        """`elastic`: a body whose derived fields are written as well; `further`: more outputs."""
        case = load_case(name)
        every = case["outputs"] | (further or {})
        every["restart"] = RESTART
        if elastic:
            every["derived"] = {"type": "tecplot", "every": {"steps": 20}, "bodies": {elastic: DERIVED}}
        often = {key: dict(value, every={"steps": 1}) for key, value in every.items()}
        often["restart"] = RESTART
        sets = {"restart_only": {"restart": RESTART}, "every": every, "often": often}
        sets |= {f"only_{key}": {key: value, "restart": RESTART} for key, value in every.items()}
        for key, outputs in sets.items():
            changed = self.case(name, outputs=outputs, loop__end_time=end_time or case["loop"]["end_time"],
                                **changes)
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

    def test_periodic(self):
        self.any_outputs_same_physics("channel_2d")

    def test_elastic_in_fluid(self):
        self.any_outputs_same_physics("gate_2d", "gate", end_time=0.5)

    def test_elastic_with_loads_and_motion(self):
        self.any_outputs_same_physics("strip_2d", "strip")

    def test_contact(self):
        self.any_outputs_same_physics("contact_2d", "cube", end_time=0.05)

    def test_elastic_3d(self):
        self.any_outputs_same_physics("clamped_3d", "beam")

    def test_sampled_inside_a_step_in_a_periodic_domain(self):
        """Lists are built for the observer before neighbors.update brings particles back."""
        means = {"type": "observe", "observer": "probe", "fields": ["velocity"], "average": True}
        self.any_outputs_same_physics(
            "free_2d", end_time=0.1, further={"means": means | {"layer": "acoustic"}},
            domain={"lower": [-1, -1], "upper": [1, 1], "periodic": ["x", "y"]},
            geometry={"drop": {"box": {"lower": [-1, -1], "upper": [1, 1]}}},
            bodies__water__initial={"velocity": ["2 + 0.3*sin(20*y)", "-1"]},
            bodies__probe={"kind": "observer", "points": [[0.99, 0.5]]}, topology__probe=["water"],
            dynamics__density_summation__surface="confined")

    def test_check_and_run_know_the_same_fields(self):
        def said(*arguments, **options):
            done = subprocess.run([SPHINX, *arguments], capture_output=True, text=True, timeout=SECONDS,
                                  **options)
            return done.returncode, done.stderr, done.stdout

        written = set()
        fields = [line.split()[0] for line in said("list", "field")[2].splitlines()]
        for field in fields:
            outputs = {"frames": {"type": "vtu", "bodies": {"strip": [field]}}}
            case = self.case("strip_2d", outputs=outputs, loop__end_time=1e-9)
            code, errors, _ = said("check", case)
            self.assertEqual(said("run", case, "-o", self.folder / field)[:2], (code, errors), field)
            if code == 0:
                written.add(field)
        self.assertLessEqual(set(DERIVED) | {"velocity", "deformation_gradient"}, written)
        # Those of a fluid, and what only a coupling with one computes.
        self.assertFalse(written & {"pressure", "density_rate", "radiation_impedance"})

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
