# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Where particles stand in memory changes no bit: sorted in every step, seldom or never, a run writes the
same results and restarts."""

import copy
import re
import unittest
import xml.etree.ElementTree as ElementTree

import yaml

import results
from support import REPOSITORY, Promise, Restart, load_case, restarts

EVERY_STEP, SELDOM, NEVER = 1, 100, 10**6


def sorted_every(case, interval):
    """The case with its lines `sort` at that interval of steps."""
    changed = copy.deepcopy(case)
    lines = [step for step in changed["loop"]["steps"]
             if isinstance(step, dict) and step.get("run", "").startswith("sort")]
    assert lines
    for line in lines:
        line["every"] = {"steps": interval}
    return changed


def without_triggers(path):
    """A restart but for the steps in which lines under `every` act next."""
    restart = Restart(path)
    next_step = r'<section name="every_\d+">\s*<integer name="next">\d+</integer>\s*</section>'
    restart.physics["layers"] = re.sub(next_step, "", restart.physics["layers"])
    return restart


class Order(Promise):
    def same_in_any_order(self, case):
        # That of a case without one goes by the clock on the wall, and says so in restarts.
        case["outputs"]["progress"] = {"type": "progress", "every": {"steps": 100}}
        runs = {}
        for interval in (EVERY_STEP, SELDOM, NEVER):
            runs[interval] = self.folder / f"every_{interval}"
            self.sphinx(self.write_case("ordered", sorted_every(case, interval)), runs[interval])
        first = restarts(runs[NEVER])
        self.assertGreaterEqual(len(first), 2)
        for interval in (EVERY_STEP, SELDOM):
            with self.subTest(sorted_every=interval):
                self.assertEqual(results.differences(runs[NEVER], runs[interval]), [])
                self.assertEqual(list(restarts(runs[interval])), list(first))
                for steps, path in restarts(runs[interval]).items():
                    unsorted, other = without_triggers(first[steps]), without_triggers(path)
                    self.assert_same_physics(unsorted, other)
                    self.assertEqual(ElementTree.tostring(unsorted.outputs),
                                     ElementTree.tostring(other.outputs))

    def shipped(self, name, end, outputs):
        case = yaml.safe_load((REPOSITORY / "cases" / name / "case.yaml").read_text())
        case["loop"]["end_time"] = end
        case["outputs"] = {"restart": {"type": "restart", "every": {"steps": 10}, "keep": 1000}}
        for output, (kind, time, settings) in outputs.items():
            case["outputs"][output] = {"type": kind, "every": {"time": time}, **settings}
        self.same_in_any_order(case)

    def test_dam_break(self):
        self.shipped("dam_break_2d", 2, {
            "frames": ("vtu", 0.5, {}),
            "series": ("vtkhdf", 0.5, {}),
            "plain": ("hdf5", 0.5, {"precision": "single"}),
            "tables": ("tecplot", 1, {}),
            "pressure": ("observe", 0.05, {"observer": "probe", "fields": ["average_pressure"]}),
            "front": ("reduce", 0.2, {"body": "water", "quantity": "front_position"}),
            "energy": ("reduce", 0.2, {"body": "water", "quantity": "mechanical_energy"}),
            "spin": ("reduce", 0.2, {"body": "water", "quantity": "angular_momentum"}),
            "force": ("reduce", 0.2, {"body": "wall", "quantity": "force", "average": True, "layer": "acoustic"})})

    def test_elastic_gate(self):
        self.shipped("dam_break_elastic_gate_2d", 20, {
            "frames": ("vtu", 5, {}),
            "tip": ("observe", 0.5, {"observer": "tip", "fields": ["displacement"]}),
            "energy": ("reduce", 0.5, {"body": "gate", "quantity": "mechanical_energy"}),
            "reaction": ("reduce", 0.5, {"body": "gate", "quantity": "support_reaction"}),
            "force": ("reduce", 0.5, {"body": "gate", "quantity": "force"})})

    def test_gate_with_all_methods(self):
        self.same_in_any_order(load_case("gate_2d"))

    def test_splash_3d(self):
        case = load_case("splash_3d")
        # Points of the water that follow it, and a gauge.
        case["bodies"]["floats"] = {"kind": "observer", "points": [[0.2, 0.2, 0.2], [0.4, 0.1, 0.4]],
                                    "follows": "material"}
        case["topology"]["floats"] = ["water"]
        case["outputs"]["floats"] = {"type": "observe", "every": {"time": 0.02}, "observer": "floats",
                                     "fields": ["pressure", "velocity"]}
        case["outputs"]["level"] = {"type": "observe", "every": {"time": 0.02}, "observer": "probe",
                                    "quantity": "surface_elevation"}
        self.same_in_any_order(case)

    def test_honey(self):
        self.same_in_any_order(load_case("honey_2d"))

    def test_drop_without_gravity(self):
        case = load_case("free_2d")
        case["outputs"]["frames"]["every"] = {"time": 0.1}
        case["outputs"]["restart"]["every"] = {"steps": 50}
        for quantity in ("mechanical_energy", "momentum", "angular_momentum"):
            case["outputs"][quantity] = {"type": "reduce", "every": {"time": 0.02}, "body": "water",
                                         "quantity": quantity}
        self.same_in_any_order(case)

    def test_two_liquids(self):
        self.same_in_any_order(load_case("liquids_2d"))

    def test_two_liquids_at_an_elastic_gate(self):
        self.same_in_any_order(load_case("oil_gate_2d"))

    def test_particles_that_leave(self):
        case = load_case("free_2d")
        case["domain"] = {"lower": [-0.49, -1], "upper": [0.5, 1], "lost_particles": "remove"}
        case["outputs"]["restart"]["every"] = {"steps": 50}
        case["outputs"]["mass"] = {"type": "reduce", "every": {"time": 0.02}, "body": "water",
                                   "quantity": "mass"}
        self.same_in_any_order(case)
        last = results.read_csv(self.folder / "every_1" / "mass.csv")[-1]
        self.assertGreater(last[-1], 0, "no particle left")


if __name__ == "__main__":
    unittest.main()
