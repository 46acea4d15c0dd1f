# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""What a system does not give is told in one line: memory beyond that of a cgroup, locks, any more memory.

OTHER_SYSTEM names the library made from other_system.c, SANITIZED says that the program watches its
memory itself. Memory ends at allocations that are STRIDE apart (environment, default 41; the long
test takes all of them).
"""

import errno
import os
import pathlib
import resource
import shutil
import subprocess
import time
import unittest

import results
from support import SECONDS, SPHINX, Promise, command, last_restart, load_case, restarts

LIBRARY = os.environ["OTHER_SYSTEM"]
STRIDE = int(os.environ.get("STRIDE", "41"))
OWN_MEMORY = bool(os.environ.get("SANITIZED"))
NO_MEMORY = r"^error: no memory is left at time \d\S*; restarts stay as they are\n$"


class OtherSystem(Promise):
    def elsewhere(self, words, **system):
        """Exit code, stderr."""
        environment = dict(os.environ, LD_PRELOAD=LIBRARY, **{name: str(value) for name, value in system.items()})
        done = subprocess.run(words, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                              timeout=SECONDS)
        return done.returncode, done.stderr


class Cgroup(OtherSystem):
    """A case of about 1.1 million particles of water, with its wall; tests/unit has more kinds of groups."""

    def setUp(self):
        super().setUp()
        self.case_file = self.case("splash_2d", variables__spacing=0.6 / 1040, loop__end_time=1e-6)
        self.root = self.folder / "root"

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(f"{text}\n")

    def refused(self):
        output = self.folder / "out"
        code, said = self.elsewhere(command(self.case_file, output), GROUPS_IN=self.root)
        self.assertEqual(code, 2, said)
        message, *place = said.splitlines()
        self.assertRegex(message, r"splash_2d\.yaml:\d+:\d+: error: the lattice of spacing 0\.000576923 gives water "
                                  r"about 1e\+06 particles, which do not fit in the memory of the cgroup of this "
                                  r"process \(0\.067 GB\)$")
        self.assertNotIn("error", "".join(place))
        self.assertFalse(output.exists())

    def test_version_2(self):
        self.write("proc/self/cgroup", "0::/batch/job")
        self.write("sys/fs/cgroup/batch/memory.max", 1 << 26)
        self.write("sys/fs/cgroup/batch/job/memory.max", "max")
        self.refused()

    def test_version_1(self):
        self.write("proc/self/cgroup", "3:cpu:/\n2:memory:/batch/job\n0::/")
        self.write("sys/fs/cgroup/memory/memory.limit_in_bytes", (1 << 63) - 4096)
        self.write("sys/fs/cgroup/memory/batch/job/memory.limit_in_bytes", 1 << 26)
        self.refused()

    def test_room_enough(self):
        self.write("proc/self/cgroup", "0::/batch/job")
        self.write("sys/fs/cgroup/batch/memory.max", 1 << 40)
        self.write("sys/fs/cgroup/batch/job/memory.max", "max")
        code, said = self.elsewhere([SPHINX, "check", self.case_file], GROUPS_IN=self.root)
        self.assertEqual(code, 0, said)


class Locks(OtherSystem):
    """As of network file systems."""

    def test_none(self):
        case, output = self.case("splash_2d", loop__end_time=0.1), self.folder / "out"
        for reason in (errno.ENOLCK, errno.ENOSYS):
            self.assertEqual(self.elsewhere(command(case, output), FLOCK_FAILS=reason),
                             (4, f"error: cannot lock {output}: {os.strerror(reason)}\n"))
            self.assertEqual(list(output.iterdir()), [])
        self.sphinx(case, output)
        before = results.content(output)
        for arguments in ([], ["--resume"], ["--overwrite"]):
            self.assertEqual(self.elsewhere(command(case, output, *arguments), FLOCK_FAILS=errno.ENOLCK),
                             (4, f"error: cannot lock {output}: No locks available\n"))
            self.assertEqual(results.changed(before, results.content(output)), [])


@unittest.skipIf(OWN_MEMORY, "a sanitizer has an allocator of its own, which does not run out of memory")
class LinearAlgebra(OtherSystem):
    def test_of_another_system(self):
        case = self.case("linkage_2d")
        whole = self.folder / "whole"
        self.sphinx(case, whole)
        words = command(case, self.folder / "elsewhere", "--restart", restarts(whole)[160])
        self.assertEqual(self.elsewhere(words), (0, ""))
        words = command(case, self.folder / "other", "--restart", restarts(whole)[160])
        code, said = self.elsewhere(words, LIBRARIES_IN="libother.so")
        self.assertEqual(code, 0, said)
        self.assertRegex(said, r"^warning: the restart was written with the linear algebra of \S.*, this system has "
                               r"libother\.so.*: the last bits of the mechanism may differ\n$")


class MemoryEnds(OtherSystem):
    """In the midst of a run."""

    def setUp(self):
        super().setUp()
        outputs = load_case("splash_2d")["outputs"]
        outputs["restart"]["every"] = {"steps": 3}
        self.case_file = self.case("splash_2d", outputs=outputs, loop__end_time=0.25)
        self.whole = self.folder / "whole"

    def allocations(self, output, *arguments):
        counted = self.folder / "allocations"
        self.assertEqual(self.elsewhere(command(self.case_file, output, *arguments), ALLOCATIONS_COUNTED=counted),
                         (0, ""))
        return int(counted.read_text())

    def test_at_many_places(self):
        """Within steps and within all kinds of outputs."""
        begin = self.allocations(self.folder / "begin", "--set", "loop.end_time=0.1")
        end = self.allocations(self.whole)
        self.assertGreater(end, begin + 300)
        kept = set()
        # Of two threads the number of allocations varies a little.
        tried = [(place, 1) for place in range(begin, end, STRIDE)]
        tried += [(place, 2) for place in range(begin, end - 50, 4 * STRIDE)]
        for place, threads in tried:
            output = self.folder / f"ended_{place}_{threads}"
            with self.subTest(place=place, threads=threads):
                code, said = self.elsewhere(command(self.case_file, output, threads=threads), MEMORY_ENDS_AT=place)
                self.assertEqual(code, 4, said)
                self.assertRegex(said, NO_MEMORY)
                self.assertIn(said, (output / "log.txt").read_text())
                results.check_readable(output, after_kill=True)
                self.assertGreater(last_restart(output).time, 0)
                kept.add(last_restart(output).steps)
                self.sphinx(self.case_file, output, "--resume")
                self.assert_same_physics(last_restart(output), last_restart(self.whole))
                self.assertEqual(results.differences(self.whole, output), [])
            shutil.rmtree(output, ignore_errors=True)
        print(f"out of memory at {len(tried)} of {end} allocations")
        self.assertGreater(len(kept), 2)

    def test_at_the_start(self):
        """While first lists are made and first outputs written: before that the case is what needs too much."""
        output, log = self.folder / "out", self.folder / "out/log.txt"
        end = self.allocations(output, "--set", "loop.end_time=1e-6")
        begun = 0
        for place in range(1, end, max(1, STRIDE // 4)):
            shutil.rmtree(output)
            with self.subTest(place=place):
                code, said = self.elsewhere(command(self.case_file, output), MEMORY_ENDS_AT=place)
                if log.exists() and "particles" in log.read_text():
                    begun += 1
                    self.assertEqual(code, 4, said)
                    self.assertRegex(said, NO_MEMORY)
            output.mkdir(exist_ok=True)
        self.assertGreater(begun, 20)

    def test_of_a_process(self):
        """Memory that ends for real: a limit below what the process asks for next."""
        output = self.folder / "out"
        case = self.case("splash_2d", loop__end_time=1e4)
        # Each piece of memory is asked for from the system.
        environment = dict(os.environ, GLIBC_TUNABLES="glibc.malloc.mmap_threshold=4096")
        process = subprocess.Popen(command(case, output), env=environment, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        end = time.monotonic() + SECONDS
        while len(restarts(output)) < 2:
            self.assertLess(time.monotonic(), end)
            time.sleep(0.01)
        pages = int(pathlib.Path(f"/proc/{process.pid}/statm").read_text().split()[0])
        resource.prlimit(process.pid, resource.RLIMIT_AS, (pages * resource.getpagesize(), -1))
        _, said = process.communicate(timeout=SECONDS)
        self.assertEqual(process.returncode, 4, said)
        self.assertRegex(said, NO_MEMORY)
        results.check_readable(output, after_kill=True)
        self.sphinx(case, output, "--resume", "--set", f"loop.end_time={last_restart(output).time + 0.1}")


if __name__ == "__main__":
    unittest.main(verbosity=2)  # tells why a test is skipped
