# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""A run is a restart and a run: the same bits, and the same results on disk."""

import shutil
import unittest

import results
from support import Promise, Restart, last_restart, restarts

ALL_RESTARTS = 1000
CASES = ("splash_2d", "splash_3d",
         "honey_2d",     # viscosity that is solved for
         "channel_2d",   # periodic
         "polymers_2d", "thinning_2d",
         "liquids_2d", "oil_gate_2d",
         "gate_2d",      # elastic
         "strip_2d",     # elastic, with loads and motion
         "raft_2d",      # a mechanism with rigid and elastic particles
         "linkage_2d",   # one that is driven, with a closed loop and a line
         "contact_2d",   # surfaces with friction, a mechanism, self-contact
         "clamped_3d")


class Continued(Promise):
    def resumed_equals_whole(self, name, changes):
        case = self.case(name, **changes, outputs__restart__keep=ALL_RESTARTS)
        whole = self.folder / f"{name}_whole"
        self.sphinx(case, whole)
        results.check_readable(whole)
        steps = list(restarts(whole))
        self.assertGreaterEqual(len(steps), 4)
        for step in sorted({steps[0], steps[len(steps) // 2], steps[-2], steps[-1]}):
            with self.subTest(step=step):
                # What lies in the folder when a run dies just before it writes the next restart.
                resumed = self.folder / f"{name}_from_{step}"
                shutil.copytree(whole, resumed)
                for later in steps:
                    if later > step:
                        restarts(resumed)[later].unlink()
                said = self.sphinx(case, resumed, "--resume")
                self.assertIn(f"_{step}.xml", said)
                self.assertEqual(list(restarts(resumed)), steps)
                for path in restarts(resumed).values():
                    self.assert_same_physics(Restart(path), Restart(whole / "restart" / path.name))
                self.assertEqual(results.differences(whole, resumed), [])
                results.check_readable(resumed)

                # In another folder: the same physics, without the earlier frames.
                if step == steps[-1]:
                    continue
                elsewhere = self.folder / f"{name}_elsewhere_{step}"
                self.sphinx(case, elsewhere, "--restart", restarts(whole)[step])
                self.assert_same_physics(last_restart(elsewhere), last_restart(whole))

    def test_cases(self):
        for name in CASES:
            with self.subTest(case=name):
                self.resumed_equals_whole(name, {})

    def test_text_encoding(self):
        self.resumed_equals_whole("splash_2d", {"outputs__restart__encoding": "text"})

    def test_later_end_of_a_finished_run(self):
        for name, half in (("splash_2d", 0.5), ("splash_3d", 0.4)):
            with self.subTest(case=name):
                case = self.case(name)
                self.sphinx(case, self.folder / f"{name}_whole")
                parts = self.folder / f"{name}_parts"
                self.sphinx(case, parts, "--set", f"loop.end_time={half}")
                self.sphinx(case, parts, "--resume")
                self.assert_same_physics(last_restart(parts), last_restart(self.folder / f"{name}_whole"))
                results.check_readable(parts)

    def test_finished_run_resumed_changes_nothing(self):
        case = self.case("splash_2d")
        whole = self.folder / "whole"
        self.sphinx(case, whole)
        shutil.copytree(whole, self.folder / "again")
        self.sphinx(case, self.folder / "again", "--resume")
        self.assertEqual(results.differences(whole, self.folder / "again"), [])
        self.assert_same_physics(last_restart(self.folder / "again"), last_restart(whole))


if __name__ == "__main__":
    unittest.main()
