# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Results that vanish under a run or between two are told; nothing is lost without a word."""

import os
import re
import signal
import subprocess
import time
import unittest
import zlib

from support import SECONDS, Promise, command, last_restart, restarts

LONG = {"loop__end_time": 1e4}


class Vanished(Promise):
    def running(self, output, **changes):
        """A run that has written its first rows."""
        case = self.case("splash_2d", **LONG, **changes)
        process = subprocess.Popen(command(case, output), stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                   text=True)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        end = time.monotonic() + SECONDS
        while not (output / "energy.csv").exists() or (output / "energy.csv").stat().st_size < 200:
            self.assertLess(time.monotonic(), end)
            time.sleep(0.02)
        return process

    def told(self, process, message):
        said, _ = process.communicate(timeout=SECONDS)
        self.assertEqual(process.returncode, 4, said)
        self.assertRegex(said, message)

    def test_series_removed_under_a_run(self):
        output = self.folder / "out"
        process = self.running(output)
        (output / "energy.csv").unlink()
        self.told(process, r"error: cannot go on with .*energy\.csv: it was removed or replaced while it was being")

    def test_folder_removed_under_a_run(self):
        output = self.folder / "out"
        process = self.running(output)
        os.rename(output, self.folder / "elsewhere")
        self.told(process, r"error: the folder .*out was removed or renamed while the run wrote to it")
        self.assertFalse(output.exists())

    def test_another_run_takes_the_name_of_a_renamed_folder(self):
        output = self.folder / "out"
        first = self.running(output)
        os.rename(output, self.folder / "elsewhere")
        second = self.running(output)
        self.told(first, r"error: the folder .*out was removed or renamed while the run wrote to it")
        second.send_signal(signal.SIGTERM)
        second.communicate(timeout=SECONDS)
        self.sphinx(self.case("splash_2d"), output, "--resume", "--set", f"loop.end_time={last_restart(output).time}")

    def test_series_missing_when_a_run_goes_on(self):
        output, case = self.folder / "out", self.case("splash_2d")
        self.sphinx(case, output, "--set", "loop.end_time=0.2")
        (output / "energy.csv").rename(self.folder / "energy.csv")
        said = self.sphinx(case, output, "--resume", expect=4)
        self.assertRegex(said, r"error: .*energy\.csv is gone, of which the run had written \d+ rows: put the file back")
        # In another folder the series begin anew, and so does one that the case did not have.
        self.sphinx(case, self.folder / "other", "--restart", restarts(output).popitem()[1])
        (self.folder / "energy.csv").rename(output / "energy.csv")
        new = self.case("splash_2d", outputs__more={"type": "reduce", "body": "water", "quantity": "mass"})
        self.sphinx(new, output, "--resume")
        self.assertTrue((output / "more.csv").exists())


class Forged(Promise):
    def test_negative_counts(self):
        output, case = self.folder / "out", self.case("splash_2d")
        self.sphinx(case, output, "--set", "loop.end_time=0.2")
        path = restarts(output).popitem()[1]
        text = path.read_text()
        before = {file: file.read_bytes() for file in output.rglob("*") if file.is_file() and file != path}
        for name in ("frames", "rows", "steps"):
            forged, found = re.subn(rf'(name="{name}"[^>]*>)\d+', r"\g<1>-1", text, count=1)
            self.assertEqual(found, 1, name)
            path.write_bytes(self.signed(forged))
            for arguments in (("--resume",), ("--restart", path, "--overwrite")):
                said = self.sphinx(case, output, *arguments, expect=4)
                self.assertRegex(said, r"error: ", said)
                after = {file: file.read_bytes() for file in before}
                self.assertEqual(after, before, f"{name} {arguments}")

    @staticmethod
    def signed(text):
        """With the right checksum at its end."""
        body, end = text.rsplit("<checksum", 1)
        number = format(zlib.crc32(body.encode()), "08x")
        return (body + re.sub(r'"[0-9a-f]{8}"', f'"{number}"', "<checksum" + end)).encode()


class LastState(Promise):
    """A case without a restart output, and without one that tells of the progress."""

    def test_of_a_run_that_fails(self):
        """A jet that leaves the domain: the run goes on with other means."""
        case = self.case("splash_2d", outputs={}, domain={"upper": [1.5, 0.605]}, bodies__water__initial={
            "velocity": [0, 1]})
        output = self.folder / "out"
        said = self.sphinx(case, output, expect=3)
        self.assertIn("left the domain", said)
        self.assertGreater(last_restart(output).steps, 0)
        said = self.sphinx(case, output, "--resume", "--set", "domain.lost_particles=remove", "--set",
                           "loop.end_time=0.1")
        self.assertIn("particles left the domain and were removed", said)

    def test_progress_is_told(self):
        said = self.sphinx(self.case("splash_2d", outputs={}), self.folder / "out", "--set", "loop.end_time=0.1")
        self.assertRegex(said, r"time 0\.1\S* of 0\.1 \(100\.0 %\), step \d+")


if __name__ == "__main__":
    unittest.main()
