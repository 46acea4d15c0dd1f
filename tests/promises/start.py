# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""How long it takes until something happens.

Promised for a quiet machine, tests share theirs: measured is the time that the processor works for
the program, on all threads together, which does not grow with what else runs.
"""

import math
import re
import resource
import subprocess
import unittest

from support import REPOSITORY, SPHINX, Promise, command

CASE = REPOSITORY / "cases/dam_break_2d/case.yaml"
CHECK_SECONDS = 3  # a million particles
FIRST_STEP_SECONDS = 1  # 100 000 particles


def processor_seconds():
    """Of all programs that were run and have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def quickest(arguments, runs=3):
    """Seconds, and what was said."""
    best, said = math.inf, ""
    for _ in range(runs):
        begin = processor_seconds()
        done = subprocess.run(arguments, capture_output=True, text=True, check=True)
        seconds = processor_seconds() - begin
        if seconds < best:
            best, said = seconds, done.stdout
    return best, said


def particles(said):
    return sum(int(n) for n in re.findall(r": (\d+) particles", said))


class Start(Promise):
    def test_check_of_a_million(self):
        seconds, said = quickest([SPHINX, "check", str(CASE), "--set", "variables.spacing=0.00142"])
        print(f"check of {particles(said)} particles: {seconds:.2f} s")
        self.assertGreater(particles(said), 1_000_000)
        self.assertLess(seconds, CHECK_SECONDS)

    def test_first_step_of_100_000(self):
        # The limit of time is over after the first step.
        arguments = ["--set", "variables.spacing=0.0048", "--time-limit", "1e-9"]
        seconds, said = quickest(command(CASE, self.folder / "out", *arguments, "--no-outputs"))
        print(f"first step of {particles(said)} particles: {seconds:.2f} s")
        self.assertGreater(particles(said), 100_000)
        self.assertRegex(said, r"\nadvection +1 ")
        self.assertLess(seconds, FIRST_STEP_SECONDS)


if __name__ == "__main__":
    unittest.main()
