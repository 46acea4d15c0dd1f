# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""A run killed by `kill -9` at random moments ends, resumed, in the same bits and files."""

import os
import pathlib
import random
import resource
import subprocess
import time
import unittest

import results
from support import SECONDS, Promise, command, last_restart, restarts

KILLS = 20
# Of which at least so many must hit the process while it steps or writes.
HITS = 15


class Killed(Promise):
    def test_kill_9(self):
        case = self.case("splash_2d", variables__spacing=0.0125, loop__end_time=0.6)
        whole = self.folder / "whole"
        self.sphinx(case, whole)
        # A kill comes after about a fifth of the run, so that most runs take several: a fifth of the work,
        # since time passes faster or slower with what else the machine does.
        longest = 0.4 * self.work_of_children()
        chance = random.Random(1)
        hits = tried = runs = 0
        while tried < KILLS:
            output = self.folder / f"run_{runs}"
            runs += 1
            arguments = ()
            while True:
                process = subprocess.Popen(command(case, output, *arguments), stdout=subprocess.PIPE,
                                           stderr=subprocess.PIPE, text=True)
                stepping = self.wait_for_steps(process)
                if tried < KILLS and stepping:
                    self.wait_for_work(process, chance.uniform(0, longest))
                    tried += 1
                    if process.poll() is None:
                        hits += 1
                    process.kill()
                _, said = process.communicate(timeout=SECONDS)
                if process.returncode == 0:
                    break
                if process.returncode == 4:
                    # Killed before the first restart: nothing to go on from.
                    self.assertIn("no valid restart", said)
                    arguments = ("--overwrite",)
                    continue
                self.assertEqual(process.returncode, -9, said)
                results.check_readable(output, after_kill=True)
                arguments = ("--resume",)
            self.assert_same_physics(last_restart(output), last_restart(whole))
            self.assertEqual(list(restarts(output)), list(restarts(whole)))
            self.assertEqual(results.differences(whole, output), [])
            results.check_readable(output)
        print(f"{hits} of {tried} kills hit {runs} runs")
        self.assertGreaterEqual(hits, HITS)

    @staticmethod
    def work_of_children():
        """Seconds that the processor has worked for processes that have ended."""
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        return used.ru_utime + used.ru_stime

    @staticmethod
    def wait_for_work(process, seconds):
        """Until the processor has worked for it so long from now on, or it has ended."""

        def work():
            fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()
            return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

        begin = work()
        while process.poll() is None and work() < begin + seconds:
            time.sleep(0.001)

    @staticmethod
    def wait_for_steps(process):
        """True as soon as a line says that the particles are there and stepping begins."""
        return any("particles" in line for line in process.stdout)


if __name__ == "__main__":
    unittest.main()
