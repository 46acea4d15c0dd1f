# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Sample files for the reader tests, and the values that must be in them.

The tests run by `python3 -m unittest discover tests/regression/readers` (pytest finds them as
well). UNIT_IO names the executable that writes the samples (default: build/release/tests/unit_io).
"""

import os
import pathlib
import subprocess
import tempfile

import numpy as np

REPOSITORY = pathlib.Path(__file__).resolve().parents[3]
WRITER = os.environ.get("UNIT_IO", str(REPOSITORY / "build/release/tests/unit_io"))
FRAMES = 4
_folder = None


def folder():
    """Written once for all tests of a process."""
    global _folder
    if _folder is None:
        _folder = tempfile.TemporaryDirectory()
        environment = dict(os.environ, SPHINX_SAMPLES=_folder.name)
        subprocess.run([WRITER, "[.samples]"], env=environment, check=True,
                       stdout=subprocess.DEVNULL)
    return pathlib.Path(_folder.name)


def time(frame):
    return 0.1 * frame


def ids(body, frame):
    """Particle 3 of the water is removed before frame 2."""
    if body == "wall":
        return np.arange(7)
    every = np.arange(1500)
    return every if frame < 2 else np.delete(every, 3)


def arrays(body, frame, dimension, padded):
    """Field name -> expected values; tests/unit/io/support.h has the same formulas."""
    i = ids(body, frame).astype(float)
    if body == "wall":
        frame = 0 if frame < 3 else frame
    width = 3 if padded else dimension
    position = np.zeros((len(i), width))
    velocity = np.zeros((len(i), width))
    strain = np.zeros((len(i), width, width))
    for k in range(dimension):
        position[:, k] = i / 7 + k + 0.25 * frame
        velocity[:, k] = i / 3 - k * frame
        for j in range(dimension):
            strain[:, k, j] = i + 10 * k + j + 100 * frame
    result = {"id": ids(body, frame), "mass": np.full(len(i), 0.5)}
    if body == "water":
        result["velocity"] = velocity
        result["pressure"] = 1 / (i + 1) + frame
        result["strain"] = strain.reshape(len(i), -1) if padded else strain
    return position, result


def same(found, expected, single):
    """Bitwise, after the one rounding to single precision."""
    if single and expected.dtype == float:
        expected = expected.astype(np.float32)
    return found.dtype == expected.dtype and np.array_equal(found, expected)


# frames_resumed: interrupted after frame 1 and resumed; what was written later must be gone.
CASES = [("frames_2d", 2, False), ("frames_3d", 3, False), ("frames_single", 3, True),
         ("frames_resumed", 2, False)]
