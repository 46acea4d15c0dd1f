# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""SIGINT, SIGTERM and --time-limit write a restart, from which the run goes on with the same bits."""

import pathlib
import re
import signal
import subprocess
import time
import unittest

import results
from support import SECONDS, Promise, command, last_restart, restarts

# Some seconds of stepping.
CHANGES = {"variables__spacing": 0.0125, "loop__end_time": 0.6}


class Stopped(Promise):
    def setUp(self):
        super().setUp()
        self.case_file = self.case("splash_2d", **CHANGES)

    def stopped_by(self, number, output, *arguments):
        """Steps made before the signal ended the run."""
        process = subprocess.Popen(command(self.case_file, output, *arguments),
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        for line in process.stdout:
            if re.match(r"time .* step [1-9]", line):
                break
        process.send_signal(number)
        said, _ = process.communicate(timeout=SECONDS)
        self.assertEqual(process.returncode, 128 + number, said)
        self.assertIn("go on with --resume", said)
        results.check_readable(output)
        return last_restart(output).steps

    def test_signals_and_second_resume(self):
        whole, parts = self.folder / "whole", self.folder / "parts"
        self.sphinx(self.case_file, whole)
        first = self.stopped_by(signal.SIGINT, parts)
        second = self.stopped_by(signal.SIGTERM, parts, "--resume")
        self.assertGreater(first, 0)
        self.assertGreater(second, first)
        self.sphinx(self.case_file, parts, "--resume")
        self.assert_same_physics(last_restart(parts), last_restart(whole))
        self.assertEqual(results.differences(whole, parts), [])

    def test_signals_of_batch_systems(self):
        for number in (signal.SIGHUP, signal.SIGUSR1, signal.SIGUSR2, signal.SIGXCPU):
            with self.subTest(signal=number.name):
                self.assertGreater(self.stopped_by(number, self.folder / number.name), 0)

    def test_within_a_step_of_which_no_end_is_in_sight(self):
        # A step that is ten thousand years of substeps long.
        forever = ("--set", "loop.dt=1e3", "--set", "loop.steps.acoustic.dt=1e-9")
        output = self.folder / "out"
        for arguments, code, why in ((["--time-limit", "1s"], 0, "the time limit of 1 s is over"),
                                     ([], 128 + signal.SIGTERM, "told to end")):
            process = subprocess.Popen(
                command(self.case_file, output, *forever, "--overwrite", *arguments),
                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            for line in process.stdout:
                if "particles" in line:
                    break
            if not arguments:
                time.sleep(2)
                process.send_signal(signal.SIGTERM)
            said, _ = process.communicate(timeout=SECONDS)
            self.assertEqual(process.returncode, code, said)
            self.assertIn("stopped within the step from time 0, of which no end was in sight: " + why,
                          said)
            self.assertIn("the state of time 0 is kept: --resume goes on from it", said)
            self.assertEqual(last_restart(output).steps, 0)

    def test_ignored_signals_stay_so(self):
        # nohup ignores SIGHUP before it starts the program.
        case = self.case("splash_2d", loop__end_time=0.2)
        process = subprocess.Popen(
            command(case, self.folder / "out"), stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
            text=True, preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        for line in process.stdout:
            if re.match(r"time .* step [1-9]", line):
                break
        process.send_signal(signal.SIGHUP)
        said, _ = process.communicate(timeout=SECONDS)
        self.assertEqual(process.returncode, 0, said)

    def test_time_limit(self):
        whole, parts = self.folder / "whole", self.folder / "parts"
        self.sphinx(self.case_file, whole)
        # Looked at after every step: this one is over after the first.
        said = self.sphinx(self.case_file, parts, "--time-limit", "1e-9s")
        self.assertIn("the time limit of 1e-09 s is over; go on with --resume", said)
        self.assertEqual(last_restart(parts).steps, 1)
        parts_run = 1
        while "go on with --resume" in said:
            said = self.sphinx(self.case_file, parts, "--resume", "--time-limit", "0.05s")
            parts_run += 1
        self.assertGreater(parts_run, 2)
        self.assert_same_physics(last_restart(parts), last_restart(whole))
        self.assertEqual(results.differences(whole, parts), [])

    def test_time_limit_as_batch_systems_write_it(self):
        for limit in ("1-00:00:00", "01:30:00", "90 min", "2d"):
            said = self.sphinx(self.case_file, self.folder / "out", "--overwrite", "--time-limit", limit, "--set",
                               "loop.end_time=0.01")
            self.assertIn("done at time", said)

    def test_a_case_without_restarts_is_kept_as_well(self):
        case = self.case("splash_2d", **CHANGES, outputs={})
        said = self.sphinx(case, self.folder / "out", "--time-limit", "1e-9s")
        self.assertIn("go on with --resume", said)
        self.assertEqual(last_restart(self.folder / "out").steps, 1)
        said = self.sphinx(case, self.folder / "out", "--resume")
        self.assertIn("done at time", said)

    def test_a_finished_run_without_restarts_goes_on_as_well(self):
        case, parts = self.case("splash_2d", outputs={}), self.folder / "parts"
        self.sphinx(case, parts, "--set", "loop.end_time=0.2")
        self.assertEqual(len(restarts(parts)), 1)
        # Ended where it begins, in a folder of its own: the state is there, too.
        elsewhere = self.folder / "elsewhere"
        self.sphinx(case, elsewhere, "--restart", restarts(parts).popitem()[1], "--set",
                    "loop.end_time=0.2")
        self.assert_same_physics(last_restart(elsewhere), last_restart(parts))
        self.sphinx(case, parts, "--resume", "--set", "loop.end_time=0.4")
        self.sphinx(case, self.folder / "whole", "--set", "loop.end_time=0.4")
        self.assert_same_physics(last_restart(parts), last_restart(self.folder / "whole"))

    def test_signal_before_anything_is_written(self):
        # Two million particles take a while to be made.
        before = sorted(self.folder.iterdir())
        for number in (signal.SIGINT, signal.SIGTERM):
            many = command(self.case_file, self.folder / "out", "--set", "variables.spacing=0.0005")
            process = subprocess.Popen(many, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            self.wait_for_work(process)
            process.send_signal(number)
            said, complaint = process.communicate(timeout=SECONDS)
            self.assertEqual(process.returncode, 128 + number, said + complaint)
            self.assertEqual((said, complaint), ("", "stopped before the first step; nothing was "
                                                     "written\n"))
            self.assertEqual(sorted(self.folder.iterdir()), before)

    @staticmethod
    def wait_for_work(process):
        """Until it catches signals: the particles are being made."""
        status = pathlib.Path(f"/proc/{process.pid}/status")
        while process.poll() is None:
            caught = re.search(r"SigCgt:\s*(\S+)", status.read_text())
            if int(caught.group(1), 16) >> (signal.SIGTERM - 1) & 1:
                return


if __name__ == "__main__":
    unittest.main()
