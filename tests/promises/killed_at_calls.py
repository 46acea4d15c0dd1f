# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""A run killed at any call that changes a file ends, resumed, in the same bits and files.

DIE_LIBRARY names the library made from die_at_call.c. Every call is too many for each day: the
calls tried are STRIDE apart (environment, default 41; the long test takes all of them).
"""

import os
import shutil
import subprocess
import unittest

import results
from support import SECONDS, Promise, command, last_restart, load_case

LIBRARY = os.environ["DIE_LIBRARY"]
STRIDE = int(os.environ.get("STRIDE", "41"))
KILLED = -9


class KilledAtCalls(Promise):
    def setUp(self):
        super().setUp()
        # Short, with every kind of output and several restarts.
        outputs = load_case("splash_2d")["outputs"]
        for output in outputs.values():
            output["every"] = {"steps": 4}
        outputs["restart"]["every"] = {"steps": 3}
        self.case_file = self.case("splash_2d", outputs=outputs, loop__end_time=0.11)
        self.whole = self.folder / "whole"

    def run_killed(self, output, call, *arguments):
        """The exit code of a run that is killed at this call."""
        environment = dict(os.environ, LD_PRELOAD=LIBRARY, DIE_AT_CALL=str(call),
                           CALLS_COUNTED=str(self.folder / "calls"))
        done = subprocess.run(command(self.case_file, output, *arguments), env=environment,
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                              timeout=SECONDS)
        self.assertIn(done.returncode, (0, 4, KILLED), done.stderr)
        return done.returncode

    def complete(self, output):
        """What a user does: resumes; when there is no restart yet, begins anew."""
        done = subprocess.run(command(self.case_file, output, "--resume"), capture_output=True,
                              text=True, timeout=SECONDS)
        if done.returncode == 4:
            self.assertIn("no valid restart", done.stderr)
            self.sphinx(self.case_file, output, "--overwrite")
        else:
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.returncode

    def assert_like_whole(self, output):
        self.assert_same_physics(last_restart(output), last_restart(self.whole))
        self.assertEqual(results.differences(self.whole, output), [])
        results.check_readable(output)

    def test_every_call(self):
        self.assertEqual(self.run_killed(self.whole, 0), 0)
        calls = int((self.folder / "calls").read_text())
        self.assertGreater(calls, 200)
        resumed = 0
        # From 1 to the first, so that all calls of the beginning are among them.
        tried = sorted({*range(1, 30), *range(30, calls + 1, STRIDE), calls})
        for call in tried:
            with self.subTest(call=call):
                output = self.folder / "killed"
                self.assertEqual(self.run_killed(output, call), KILLED)
                results.check_readable(output, after_kill=True)
                # The next attempt dies as well, somewhere in its beginning.
                self.run_killed(output, 1 + call * 7919 % 90, "--resume")
                results.check_readable(output, after_kill=True)
                resumed += self.complete(output) == 0
                self.assert_like_whole(output)
            shutil.rmtree(output, ignore_errors=True)
        print(f"killed at {len(tried)} of {calls} calls; {resumed} resumed, the others begun anew")
        self.assertGreater(resumed, len(tried) / 4)

    def test_killed_while_overwriting(self):
        self.assertEqual(self.run_killed(self.whole, 0), 0)
        output = self.folder / "killed"
        for call in range(1, 60, 4):
            with self.subTest(call=call):
                shutil.copytree(self.whole, output)
                self.assertEqual(self.run_killed(output, call, "--overwrite"), KILLED)
                self.complete(output)
                self.assert_like_whole(output)
            shutil.rmtree(output, ignore_errors=True)


if __name__ == "__main__":
    unittest.main()
