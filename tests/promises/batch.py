# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""scripts/batch runs what is not finished, and only that, and says how far each run came."""

import csv
import os
import pathlib
import shutil
import subprocess
import unittest

from support import FOLDER, REPOSITORY, SECONDS, SPHINX, Promise, last_restart

CASE = FOLDER / "cases/strip_2d.yaml"
# The second pulls the strip apart.
SWEEP = ("--sweep", "variables.pulled=0.24,9")
RUNS = ("strip_2d_pulled=0.24", "strip_2d_pulled=9")


class Batch(Promise):
    def setUp(self):
        """A house of its own, in which nothing is installed or built."""
        super().setUp()
        self.script = self.folder / "house/scripts/batch"
        self.script.parent.mkdir(parents=True)
        shutil.copy(REPOSITORY / "scripts/batch", self.script)
        for name in ("setup", "build"):
            path = self.script.with_name(name)
            path.write_text("#!/bin/sh\n")
            path.chmod(0o755)
        program = self.folder / "house/build/release/sphinx"
        program.parent.mkdir(parents=True)
        program.symlink_to(pathlib.Path(SPHINX).resolve())
        self.results = self.folder / "results"

    def batch(self, *arguments, expect):
        done = subprocess.run([self.script, *arguments, "--output", self.results], timeout=SECONDS,
                              capture_output=True, text=True, check=False)
        said = done.stdout + done.stderr
        self.assertEqual(done.returncode, expect, said)
        return said

    def parallel(self, *arguments, expect):
        if not shutil.which("parallel"):
            self.skipTest("GNU parallel is not installed: scripts/setup --batch")
        return self.batch(CASE, "--jobs", "2", *arguments, expect=expect)

    def summary(self):
        with open(self.results / "summary.csv", newline="", encoding="utf-8") as file:
            return {row["run"]: row for row in csv.DictReader(file)}

    def test_finished_and_failed(self):
        said = self.parallel(*SWEEP, "--set", "loop.end_time=0.3", expect=1)
        self.assertIn("1 of 2 runs are finished", said)
        rows = self.summary()
        self.assertEqual(sorted(rows), sorted(RUNS))
        whole, broken = (rows[name] for name in RUNS)
        self.assertEqual((whole["state"], whole["exit_code"]), ("finished", "0"))
        self.assertEqual((whole["variables.pulled"], whole["loop.end_time"]), ("0.24", "0.3"))
        self.assertGreaterEqual(float(whole["time_reached"]), 0.3)
        self.assertGreater(int(whole["steps"]), 50)
        self.assertGreater(float(whole["particle_steps_per_second"]), 0)
        self.assertEqual((broken["state"], broken["exit_code"]), ("failed (exit code 3)", "3"))
        self.assertIn("error: ", (self.results / f"{RUNS[1]}.log").read_text())

        # What is finished is not touched, what failed is tried again.
        written = (self.results / RUNS[0] / "profile.json").stat().st_mtime_ns
        said = self.parallel(*SWEEP, "--set", "loop.end_time=0.3", expect=1)
        self.assertIn(f"{RUNS[0]}: finished before", said)
        self.assertNotIn(f"{RUNS[1]}: finished", said)
        self.assertEqual((self.results / RUNS[0] / "profile.json").stat().st_mtime_ns, written)

    def test_interrupted(self):
        name = "strip_2d_width=0.5"
        sweep = ("--sweep", "variables.width=0.5")
        self.parallel(*sweep, "--time-limit", "0.000001s", expect=1)
        row = self.summary()[name]
        self.assertEqual(row["state"], "interrupted")
        self.assertLess(float(row["time_reached"]), 0.5)
        said = self.parallel(*sweep, expect=0)
        self.assertIn(f"{name}: goes on", said)
        self.assertEqual(self.summary()[name]["state"], "finished")
        self.sphinx(CASE, self.folder / "whole", "--set", "variables.width=0.5")
        self.assert_same_physics(last_restart(self.folder / "whole"), last_restart(self.results / name))

        # Another end is another case, which goes on from there.
        said = self.parallel(*sweep, "--set", "loop.end_time=0.6", expect=0)
        self.assertIn(f"{name}: goes on", said)
        self.assertGreaterEqual(float(self.summary()[name]["time_reached"]), 0.6)

    def one_run(self, end_time, expect):
        """Of a batch of one, whose setting may differ from that of the time before."""
        self.batch(CASE, "--set", f"loop.end_time={end_time}", "--slurm", expect=0)
        return self.batch("--run", "0", expect=expect)

    def state(self):
        subprocess.run([self.script, "--summary", self.results], capture_output=True, check=False)
        return self.summary()["strip_2d"]["state"]

    def test_results_in_the_way(self):
        """They stay as they are, with what the user has put there."""
        results = self.results / "strip_2d"
        notes = results / "notes.txt"
        self.assertIn("strip_2d: finished", self.one_run(0.05, expect=0))
        shutil.rmtree(results / "restart")
        notes.write_text("mine")
        said = self.one_run(0.06, expect=1)
        self.assertIn(f"scripts/batch: {results} holds results that this batch did not leave "
                      "unfinished", said)
        self.assertEqual((notes.read_text(), self.state()), ("mine", "not started (results in the way)"))
        # The case that they belong to is still finished.
        self.assertIn("strip_2d: finished before", self.one_run(0.05, expect=0))
        self.assertEqual(self.state(), "finished")

        # Results of somebody else.
        (self.results / "strip_2d.status.json").unlink()
        self.one_run(0.05, expect=1)
        self.assertEqual(notes.read_text(), "mine")
        shutil.rmtree(results)
        self.assertIn("strip_2d: finished", self.one_run(0.05, expect=0))

        # Its own, killed before there was a restart.
        shutil.rmtree(results / "restart")
        (results / "profile.json").unlink()
        status = self.results / "strip_2d.status.json"
        status.write_text('{"digest": "of the run that was killed", "finished": false}')
        self.assertIn("strip_2d: finished", self.one_run(0.05, expect=0))

    def test_slurm(self):
        said = self.batch(CASE, *SWEEP, "--jobs", "5", "--threads", "3", "--slurm", expect=0)
        job = self.results / "job_array.sh"
        self.assertEqual(said, f"sbatch {job}\n")
        lines = job.read_text().splitlines()
        self.assertIn("#SBATCH --array=0-1%5", lines)
        self.assertIn("#SBATCH --cpus-per-task=3", lines)
        self.assertFalse((self.results / RUNS[0]).exists())
        # The job of the first run, as Slurm would start it.
        done = subprocess.run([job], env={**os.environ, "SLURM_ARRAY_TASK_ID": "0"}, timeout=SECONDS,
                              capture_output=True, text=True, check=True)
        self.assertIn(f"{RUNS[0]}: finished", done.stdout)
        self.assertFalse((self.results / RUNS[1]).exists())
        done = subprocess.run([self.script, "--summary", self.results], capture_output=True, text=True,
                              check=False)
        self.assertEqual(done.returncode, 1)
        self.assertEqual([row["state"] for row in self.summary().values()], ["finished", "not finished"])

    def test_wrong(self):
        for arguments, message in (
                (["nowhere"], "there is no case 'nowhere'"),
                ([CASE, "--sweep", "variables.width"], "must be PATH=VALUE,VALUE,..."),
                ([CASE, CASE], "two runs would be called 'strip_2d'")):
            self.assertIn(message, self.batch(*arguments, expect=1))
        self.assertFalse(self.results.exists())


if __name__ == "__main__":
    unittest.main()
