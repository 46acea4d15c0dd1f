# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Runs that blow up or cannot write stop with one message and damage nothing."""

import functools
import os
import re
import resource
import shutil
import signal
import subprocess
import tempfile
import unittest

import numpy as np

import results
from support import SECONDS, SPHINX, Promise, Restart, command, last_restart, load_case, restarts

NOBODY = 65534
LOOP = ("[density_summation, viscosity, gravity, {layer: acoustic, dt: 0.02, "
        "steps: [pressure_relaxation.first_half, pressure_relaxation.second_half]}, neighbors]")


class BlownUp(Promise):
    def fails(self, said):
        """The message, of which there is one."""
        lines = [line for line in said.splitlines() if line.startswith("error: ")]
        self.assertEqual(len(lines), 1, said)
        return lines[0]

    def stops(self, *changes):
        output = self.folder / "out"
        arguments = [word for change in changes for word in ("--set", change)]
        case = self.case("splash_2d", outputs__restart__every={"steps": 1})
        said = self.sphinx(case, output, *arguments, expect=3)
        message = self.fails(said)
        self.assertIn(message.removeprefix("error: "), (output / "log.txt").read_text())
        results.check_readable(output)
        self.assertTrue((output / "failed/water_000000.vtu").exists())
        self.assertTrue((output / "failed/wall_000000.vtu").exists())
        return output, message

    def test_number_that_stops_being_one(self):
        # The square root of a negative number in the step whose middle is past 0.3.
        force = "{type: force.body_force, body: water, acceleration: ['sqrt(0.3 - t)', -1]}"
        output, message = self.stops(f"dynamics.gravity={force}")
        self.assertRegex(message, r"^error: (density|velocity) of \d\d+ of \d+ particles of water, last seen "
                                  r"between \(0\.\d+, 0\.\d+\) and \(0\.\d+, 0\.\d+\), is not finite "
                                  r"after \S+ at time 0\.(29|3)\d*;")
        self.good_restarts(output, 0.25)

    def test_solver_that_does_not_converge(self):
        case = load_case("honey_2d")
        case["dynamics"]["viscosity"].update(tolerance=1e-8, most_iterations=12)
        case["dynamics"]["gravity"] = {"type": "force.body_force", "body": "water",
                                       "acceleration": ["t < 0.3 ? 0 : 10*sin(40*x)", "0"]}
        case["outputs"] = {"restart": {"type": "restart", "every": {"time": 0.1}}}
        output = self.folder / "out"
        said = self.sphinx(self.write_case("unsolved", case), output, expect=3)
        self.assertRegex(said, r"error: fluid.implicit_viscosity of water does not converge at time 0\.3\d*: after 12 "
                               r"iterations velocities are off by [\d.e-]+ \(rms\)")
        self.good_restarts(output, 0.2)

    def test_number_that_stops_being_one_before_a_sort(self):
        # Every step sorts into cells what has just stopped having a place.
        force = "{type: force.body_force, body: water, acceleration: ['sqrt(0.3 - t)', -1]}"
        loop = LOOP.replace("neighbors]", "sort, neighbors]").replace("0.02", "0.002")
        output, message = self.stops(f"dynamics.gravity={force}", "loop.steps=" + loop)
        self.assertRegex(message, r"^error: \S+ of \d+ of \d+ particles of water, .* is not finite .* at time 0\.(29|3)\d*")
        self.good_restarts(output, 0.25)

    def test_place_of_a_number_that_stops_being_one(self):
        """It has spread to neighbors at the end of the step; the box tells where from."""
        force = "'(x < 0.1 && y < 0.1 && t > 0.05) ? sqrt(0 - 1) : 0'"
        _, message = self.stops("variables.spacing=0.0125", "dynamics.gravity={type: force.body_force, "
                                f"body: water, acceleration: [{force}, -1]}}")
        found = re.match(r"error: \w+ of (\d+) of (\d+) particles of water, last seen between "
                         r"\((\S+), (\S+)\) and \((\S+), (\S+)\), is not finite", message)
        self.assertIsNotNone(found, message)
        some, every = map(int, found.groups()[:2])
        left, below, right, above = map(float, found.groups()[2:])
        self.assertLess(some, every)
        self.assertLess(max(left, below), 0.1)
        self.assertLess(max(right, above), 0.5)

    def test_motion_that_stops_being_a_number(self):
        said = self.sphinx(self.case("linkage_2d"), self.folder / "out", "--set",
                           "multibody.joints.crank.motion=0.5*sqrt(1.005 - t) - 0.5", expect=3)
        self.assertRegex(self.fails(said), r"^error: the mechanism cannot go on at time (0\.99\d*|1(\.0\d*)?): a motion of "
                                           r"crank is -?nan")

    def test_blow_up(self):
        # Far above the limit of stability: particles fly apart within some steps.
        output, message = self.stops("loop.dt=0.02", "loop.steps=" + LOOP)
        self.assertRegex(message, r"particle \d+ of water left the domain at \(.*\), time \S+")
        self.good_restarts(output, 0.02)

    def test_motion_of_a_wall_that_stops_being_a_number(self):
        case, output = load_case("tank_2d"), self.folder / "out"
        motion = next(method for method in case["dynamics"].values()
                      if method["type"] == "constraint.prescribed_motion")
        motion["displacement"][0] = "x < 0 && t > 0.05 ? sqrt(0 - 1) : 0"
        said = self.sphinx(self.write_case("tank_2d", case), output, expect=3)
        self.assertRegex(self.fails(said), r"^error: the prescribed motion of wall displaces the particle that "
                                           r"began at \(-0\.\d+, -?\d\.\d+\) by -?nan along x at time 0\.05\d*$")

    def good_restarts(self, output, time):
        kept = restarts(output)
        self.assertTrue(kept)
        for path in kept.values():
            self.assertGreaterEqual(Restart(path).time, time)
            for field in ("position", "velocity", "density"):
                self.assertTrue(np.isfinite(Restart(path).values("water", field)).all(), path)


class KeptState(Promise):
    """A run that fails leaves a state of some steps before, also where no restart was asked for."""

    # The splash runs through the end of the room; the water before it does not notice.
    ROOM = {"lower": [-0.2, -0.2], "upper": [1.2, 1.2]}
    LOST = r"particle \d+ of water left the domain"

    def fails(self, case, output, message, *arguments):
        said = self.sphinx(case, output, *arguments, expect=3)
        self.assertRegex(said, message)
        results.check_readable(output)
        kept = last_restart(output)
        self.assertRegex(said, rf"the state of time {kept.time:.6g}( s)? is kept: --resume goes on from it")
        return kept

    def room(self, outputs, lost_particles):
        case = load_case("splash_2d")
        case["domain"] = {**self.ROOM, "lost_particles": lost_particles}
        case["geometry"]["tank"] = {"intersection": [case["geometry"]["tank"], {"box": {
            "lower": [-0.2, -0.2], "upper": [1.2, 1.2]}}]}
        case["outputs"] = {name: case["outputs"][name] for name in outputs}
        return self.write_case(f"room_{lost_particles}", case)

    def test_lost_particle(self):
        for outputs in ((), ("frames", "inner", "energy", "path", "restart")):
            with self.subTest(outputs=outputs):
                strict, generous = self.room(outputs, "stop"), self.room(outputs, "remove")
                whole, output = self.folder / f"whole_{len(outputs)}", self.folder / f"out_{len(outputs)}"
                self.sphinx(generous, whole)
                kept = self.fails(strict, output, self.LOST)
                # Just before: what is lost is a small part of what was computed.
                said = self.sphinx(strict, output, "--resume", expect=3)
                time = float(re.search(r"time (\S+): it reaches", said).group(1))
                self.assertGreater(kept.time, 0.8 * time)
                self.assertGreaterEqual(last_restart(output).steps, kept.steps)
                arguments = ("--set", "domain.lost_particles=remove")
                self.sphinx(strict, output, "--resume", *arguments)
                self.assert_same_physics(last_restart(output), last_restart(whole))
                shutil.rmtree(output / "failed")
                self.assertEqual(results.differences(whole, output), [])

    def test_broken_solid(self):
        kept = self.fails(self.case("strip_2d", outputs={}, loop__end_time=3, variables__pulled="-0.6*length",
                                    materials__rubber=BrokenSolid.RUBBER),
                          self.folder / "out", "have changed places")
        self.assertGreater(kept.steps, 0)
        gradient = kept.values("strip", "deformation_gradient").reshape(-1, 2, 2)
        self.assertGreater(np.linalg.det(gradient).min(), 0)

    def test_fields_that_the_failing_step_has_spoilt(self):
        force = "{type: force.body_force, body: water, acceleration: ['sqrt(0.3 - t)', -1]}"
        kept = self.fails(self.case("splash_2d", outputs={}), self.folder / "out", "is not finite",
                          "--set", f"dynamics.gravity={force}")
        self.assertGreater(kept.time, 0.2)
        for field in ("position", "velocity", "density"):
            self.assertTrue(np.isfinite(kept.values("water", field)).all(), field)

    def test_first_step(self):
        said = self.sphinx(self.case("splash_2d"), self.folder / "out", "--set", "loop.dt=5", "--set",
                           "loop.steps=" + LOOP.replace("0.02", "5"), expect=3)
        self.assertIn("the state of time 0 is kept", said)
        self.assertEqual(last_restart(self.folder / "out").steps, 0)


class BrokenSolid(Promise):
    """A strip that bursts or collapses, or whose ends move through each other."""

    def breaks(self, message, changes, who=r"particle \d+"):
        output = self.folder / "out"
        case = self.case("strip_2d", **changes, loop__end_time=3, outputs__restart__every={"steps": 1})
        said = self.sphinx(case, output, expect=3)
        errors = [line for line in said.splitlines() if line.startswith("error: ")]
        self.assertEqual(len(errors), 1, said)
        self.assertRegex(errors[0], rf"^error: {who} of strip at \(\S+, \S+\) m {message}, time \d\S* s")
        self.assertTrue((output / "failed/strip_000000.vtu").exists())
        for path in restarts(output).values():
            gradient = Restart(path).values("strip", "deformation_gradient").reshape(-1, 2, 2)
            self.assertGreater(np.linalg.det(gradient).min(), 0, path)

    RUBBER = {"type": "saint_venant_kirchhoff", "density": 1, "youngs_modulus": 100, "poisson_ratio": 0.3}

    @staticmethod
    def flying(rate):
        """Apart, or together below 0, at a rate that leaves the particles no time to change places."""
        return {"bodies__strip__initial": {"velocity": [f"{rate}*(x - 0.6)", 0]}, "variables__pulled": 0}

    def test_finite_extensibility_exceeded(self):
        self.breaks(r"is stretched beyond the finite extensibility of its material "
                    r"\(I1 - 3 = 0\.\d+\)", self.flying(80))

    def test_inverted(self):
        self.breaks(r"is inverted \(det F = -\d\S*\); a smaller cfl, a finer spacing or a stiffer "
                    r"material may help", {"materials__rubber": self.RUBBER, **self.flying(-160)})

    def test_scrambled(self):
        self.breaks(r"have changed places", {"materials__rubber": self.RUBBER, "variables__pulled": "-0.6*length"},
                    r"particles \d+ and \d+")

    def test_number_that_stops_being_one(self):
        output = self.folder / "out"
        load = {"type": "force.body_force", "body": "strip", "acceleration": ["sqrt(0.2 - t)", 0]}
        case = self.case("strip_2d", dynamics__load=load, outputs__restart={
            "type": "restart", "every": {"steps": 1}, "keep": 1})
        said = self.sphinx(case, output, expect=3)
        self.assertRegex(said, r"error: velocity of \d+ of \d+ particles of strip, last seen between "
                               r"\(\S+, \S+\) m and \(\S+, \S+\) m, is not finite after \S+ at time 0\.2\d* s; "
                               r"a smaller cfl may help")
        kept = last_restart(output)
        self.assertGreaterEqual(kept.time, 0.19)
        for field in ("position", "velocity", "acceleration", "deformation_gradient"):
            self.assertTrue(np.isfinite(kept.values("strip", field)).all(), field)

    def test_solids_are_not_removed(self):
        """Their lists of the reference configuration would not fit any more."""
        case = self.case("gate_2d", domain={"lower": [-1, -1], "upper": [0.62, 2],
                                            "lost_particles": "remove"})
        said = self.sphinx(case, self.folder / "out", expect=3)
        self.assertRegex(said, r"error: particle \d+ of gate left the domain at \(\S+, \S+\), time 0\.\d+: "
                               r"it reaches from \(-1, -1\) to \(0\.62, 2\)\n")


class CannotWrite(Promise):
    """A run gets into trouble, keeps its last good restart and goes on when there is room again."""

    def setUp(self):
        self.addCleanup(os.umask, os.umask(0o022))  # nobody reads the case
        super().setUp()
        self.case_file = self.case("splash_2d")
        self.whole = self.folder / "whole"
        self.sphinx(self.case_file, self.whole)

    def goes_on(self, output, said):
        self.assertRegex(said, r"error: cannot \S+ .*: \S+")
        results.check_readable(output, after_kill=True)
        stopped = restarts(output)
        self.sphinx(self.case_file, output, *(["--resume"] if stopped else ["--overwrite"]))
        self.assert_same_physics(last_restart(output), last_restart(self.whole))
        self.assertEqual(results.differences(self.whole, output), [])
        results.check_readable(output)
        return stopped

    def test_file_size_limit(self):
        sizes = sorted(p.stat().st_size for p in self.whole.rglob("*") if p.is_file())
        largest = sizes[-1]
        resumed = 0
        for part in (0.05, 0.2, 0.5, 0.7, 0.9, 0.97):
            with self.subTest(part=part):
                limit = int(part * largest)

                def few_bytes():  # as `ulimit -f` does it: the signal is not ignored
                    resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

                output = self.folder / f"limit_{part}"
                said = self.sphinx(self.case_file, output, expect=4, preexec_fn=few_bytes)
                self.assertIn("File too large", said)
                resumed += bool(self.goes_on(output, said))
        self.assertGreater(resumed, 1)

    def test_full_disk(self):
        disk = self.folder / "disk"
        disk.mkdir()
        whole_size = sum(p.stat().st_size for p in self.whole.rglob("*") if p.is_file())
        resumed = 0
        for part in (0.1, 0.3, 0.5, 0.6, 0.7):
            with self.subTest(part=part):
                mount = ["mount", "-t", "tmpfs", "-o", f"size={int(part * whole_size)}", "none", disk]
                if subprocess.run(mount, capture_output=True).returncode:
                    self.skipTest("only the superuser can mount a small disk")
                try:
                    output = disk / "out"
                    said = self.sphinx(self.case_file, output, expect=4)
                    self.assertIn("No space left on device", said)
                    results.check_readable(output, after_kill=True)
                    subprocess.run(["mount", "-o", "remount,size=1g", disk], check=True)
                    resumed += bool(self.goes_on(output, said))
                finally:
                    subprocess.run(["umount", disk], check=True)
        self.assertGreater(resumed, 1)

    @functools.cached_property
    def as_nobody(self):
        """Options that run a process without the superuser's rights."""
        if os.geteuid() != 0:
            return {}
        os.chmod(self.folder, 0o755)
        # The folder of the executable may be one that only the superuser enters, and of memory nothing
        # may be executed.
        place = tempfile.TemporaryDirectory(prefix="promise.")
        self.addCleanup(place.cleanup)
        program = shutil.copy(SPHINX, place.name)
        for path in (place.name, program):
            os.chmod(path, 0o755)
        return {"user": NOBODY, "group": NOBODY, "extra_groups": [], "cwd": self.folder,
                "executable": program}

    def test_read_only_folder(self):
        parent = self.folder / "read_only"
        parent.mkdir(mode=0o555)
        output = parent / "out"
        said = self.sphinx(self.case_file, output, expect=4, **self.as_nobody)
        self.assertIn("Permission denied", said)
        self.assertFalse(output.exists())

        shutil.copytree(self.whole, self.folder / "kept")
        kept = self.folder / "kept"
        before = results.content(kept)
        for folder in (kept, kept / "restart"):
            folder.chmod(0o555)
        for arguments in (["--resume", "--set", "loop.end_time=2"], ["--overwrite"]):
            said = self.sphinx(self.case_file, kept, *arguments, expect=4, **self.as_nobody)
            self.assertIn("Permission denied", said)
            self.assertEqual(results.changed(before, results.content(kept)), [])
        for folder in (kept, kept / "restart"):
            folder.chmod(0o755)

    def test_folder_that_cannot_be_looked_at(self):
        hidden = self.folder / "hidden"
        hidden.mkdir(mode=0o000)
        long_name = self.folder / ("a" * 300)
        for output, reason in ((hidden / "out", "Permission denied"), (long_name, "File name too long")):
            for arguments in ([], ["--resume"], ["--overwrite"]):
                said = self.sphinx(self.case_file, output, *arguments, expect=4, **self.as_nobody)
                self.assertRegex(said, rf"^error: .*{reason}\n$")
        hidden.chmod(0o755)

    def test_no_more_threads(self):
        nobody = self.as_nobody
        if not nobody:
            self.skipTest("who runs this has processes of his own")
        output = self.folder / "threads"
        self.folder.chmod(0o777)
        # The search for leaks, where there is one, wants a process of its own.
        options = {**nobody, "env": {**os.environ, "ASAN_OPTIONS": "verify_asan_link_order=0:detect_leaks=0"}}
        said = self.sphinx(self.case_file, output, threads=4, expect=4, **options,
                           preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NPROC, (1, 1)))
        self.assertEqual(said, "error: the system refuses what the program needs: cannot start 4 threads: "
                               "Resource temporarily unavailable\n")
        self.assertFalse(output.exists())

    def test_without_standard_files(self):
        # The first files that it opens must not get their numbers.
        output = self.folder / "out"
        subprocess.run(["sh", "-c", 'exec "$@" <&- >&- 2>&-', "sh",
                        *command(self.case_file, output)], check=True, timeout=SECONDS)
        self.assertEqual(results.differences(self.whole, output), [])

    def test_answer_to_a_full_disk(self):
        for verb in (["show", self.case_file], ["check", self.case_file], ["list"], ["schema"],
                     ["schema", "--markdown"], ["describe", "loop"], ["--help"], ["--version"]):
            with self.subTest(verb=verb), open("/dev/full", "w", encoding="utf-8") as full:
                done = subprocess.run([SPHINX, *map(str, verb)], stdout=full, stderr=subprocess.PIPE,
                                      text=True, check=False)
                self.assertEqual(done.returncode, 4)
                self.assertEqual(done.stderr, "error: cannot write the answer: No space left on device\n")


if __name__ == "__main__":
    unittest.main()
