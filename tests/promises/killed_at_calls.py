# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""A run killed, or told to end, at any call that changes a file ends, resumed, in the same bits and files.

DIE_LIBRARY names the library made from die_at_call.c. Every call is too many for each day: the
calls tried are STRIDE apart (environment, default 41; the long test takes all of them).
"""

import json
import os
import shutil
import signal
import subprocess
import unittest

import results
from support import SECONDS, Promise, command, last_restart, load_case

LIBRARY = os.environ["DIE_LIBRARY"]
STRIDE = int(os.environ.get("STRIDE", "41"))
KILLED = -9
TOLD_TO_END = 128 + signal.SIGTERM


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

    def run_killed(self, output, call, *arguments, by=signal.SIGKILL):
        """The exit code of a run that gets the signal at this call."""
        environment = dict(os.environ, LD_PRELOAD=LIBRARY, DIE_AT_CALL=str(call),
                           DIE_BY=str(int(by)), CALLS_COUNTED=str(self.folder / "calls"))
        done = subprocess.run(command(self.case_file, output, *arguments), env=environment,
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                              timeout=SECONDS)
        self.assertIn(done.returncode, (0, 4, KILLED, TOLD_TO_END), done.stderr)
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

    def test_told_to_end(self):
        """From the first call on a restart is left, and the last calls come too late to stop it."""
        self.assertEqual(self.run_killed(self.whole, 0), 0)
        calls = int((self.folder / "calls").read_text())
        codes, steps = set(), set()
        for call in sorted({*range(1, 30, 3), *range(30, calls, STRIDE), *range(calls - 6, calls + 1)}):
            with self.subTest(call=call):
                output = self.folder / "stopped"
                code = self.run_killed(output, call, by=signal.SIGTERM)
                codes.add(code)
                steps.add(last_restart(output).steps)
                results.check_readable(output)
                finished = json.loads((output / "profile.json").read_text())["finished"]
                self.assertEqual(code, 0 if finished else TOLD_TO_END)
                if not finished:
                    self.sphinx(self.case_file, output, "--resume")
                self.assert_like_whole(output)
            shutil.rmtree(output, ignore_errors=True)
        self.assertEqual(codes, {0, TOLD_TO_END})
        self.assertEqual(min(steps), 0)

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
