# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""What the promise tests share: cases, runs of sphinx, restarts and the comparison of results.

A test runs by `python3 tests/promises/NAME.py`; SPHINX names the executable (default:
build/release/sphinx).
"""

import base64
import os
import pathlib
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
import zlib

import numpy as np
import yaml

FOLDER = pathlib.Path(__file__).resolve().parent
REPOSITORY = FOLDER.parents[1]
SPHINX = os.environ.get("SPHINX", str(REPOSITORY / "build/release/sphinx"))
# Far more than any run here needs, however busy the machine: nothing may hang.
SECONDS = int(os.environ.get("PATIENCE", "300"))


def load_case(name):
    return yaml.safe_load((FOLDER / "cases" / f"{name}.yaml").read_text())


def command(case, output, *arguments, threads=1):
    return [SPHINX, "run", str(case), "-o", str(output), "-j", str(threads), *map(str, arguments)]


class Restart:
    """A restart file; its physics as the text of the file, so that equal means bitwise equal."""

    def __init__(self, path):
        self.path = path
        root = ElementTree.parse(path).getroot()
        self.time = float(root.get("time"))
        self.steps = int(root.get("steps"))
        self.bodies = {body.get("name"): body for body in root.iter("body")}
        sections = {s.get("name"): s for s in root.iter("section")}
        self.outputs = sections["outputs"]
        self.physics = {"time": root.get("time"), "steps": root.get("steps")}
        for name in ("methods", "layers"):
            self.physics[name] = ElementTree.tostring(sections[name]).decode()
        for name, body in self.bodies.items():
            self.physics[name] = f"{body.get('particles')} {body.get('next_id')}"
            for field in body:
                self.physics[f"{name}.{field.get('name')}"] = ElementTree.tostring(field).decode()

    def values(self, body, field):
        """As an array: particles, or particles x components, by ascending id."""
        element = next(f for f in self.bodies[body] if f.get("name") == field)
        integers = element.get("rank") == "integer"
        pieces = []
        for piece in element:
            if piece.tag == "zlib":
                data = zlib.decompress(base64.b64decode(piece.text))
                pieces.append(np.frombuffer(data, dtype="<i8" if integers else "<f8"))
            else:
                pieces.append(np.array([int(v) if integers else float(v) for v in piece.text.split()]))
        values = np.concatenate(pieces) if pieces else np.zeros(0)
        width = int(element.get("components"))
        return values.reshape(-1, width) if width > 1 else values

    def by_id(self, body, field):
        return self.values(body, field)[np.argsort(self.values(body, "id"))]


def restarts(output):
    """Of a results folder, by number of steps."""
    found = {}
    for path in (pathlib.Path(output) / "restart").glob("*.xml"):
        found[int(path.stem.rsplit("_", 1)[1])] = path
    return dict(sorted(found.items()))


def last_restart(output):
    return Restart(list(restarts(output).values())[-1])


class Promise(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        # In memory where there is such a place: a test waits for no disk.
        memory = pathlib.Path("/dev/shm")
        temporary = tempfile.TemporaryDirectory(prefix="promise.", dir=memory if memory.is_dir() else None)
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def case(self, name, **changes):
        """Writes a case of cases/ into the folder; `loop__end_time=2` sets loop.end_time."""
        case = load_case(name)
        for path, value in changes.items():
            place = case
            *parents, last = path.split("__")
            for key in parents:
                place = place[key]
            place[last] = value
        return self.write_case(name, case)

    def write_case(self, name, case):
        path = self.folder / f"{name}.yaml"
        path.write_text(yaml.safe_dump(case, sort_keys=False))
        return path

    def sphinx(self, case, output, *arguments, threads=1, expect=0, **options):
        """Runs to the end and returns what was said: stdout and stderr."""
        options.setdefault("timeout", SECONDS)
        done = subprocess.run(command(case, output, *arguments, threads=threads),
                              capture_output=True, text=True, **options)
        said = done.stdout + done.stderr
        self.assertEqual(done.returncode, expect, said)
        return said

    def assert_same_physics(self, first, second):
        """Clocks, state of methods and all particle fields of two restarts, bitwise."""
        self.assertEqual(first.physics.keys(), second.physics.keys())
        wrong = [key for key, text in first.physics.items() if second.physics[key] != text]
        self.assertEqual(wrong, [], f"{first.path} (step {first.steps}) and {second.path} "
                                    f"(step {second.steps}) differ")
