# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""What the tests of the shipped cases share: runs, results, and the report of what was measured.

A test is a script: `python3 tests/regression/NAME.py [--long] [--study] [--plot]`. It runs
cases/NAME/case.yaml, prints each measured value beside its reference and its limit, and fails when
one is outside. SPHINX names the executable (default: build/release/sphinx).
  --long    the case as it is shipped, where the short test runs a coarser or shorter one
  --study   the table over spacings in the README of the case; nothing is checked
  --plot    the plot in the folder of the case
"""

import argparse
import os
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
CASES = REPOSITORY / "cases"
SPHINX = os.environ.get("SPHINX", str(REPOSITORY / "build/release/sphinx"))
# Far more than any run here needs, however busy the machine: nothing may hang.
SECONDS = 3600


def arguments(**instead):
    """The options. Where `study` or `plot` is asked for and given here as a function, that is done
    in place of the test."""
    parser = argparse.ArgumentParser()
    for name in ("long", "study", "plot"):
        parser.add_argument(f"--{name}", action="store_true")
    options = parser.parse_args()
    asked = [make for name, make in instead.items() if getattr(options, name)]
    for make in asked:
        make()
    if asked:
        sys.exit(0)
    return options


class Run:
    """A finished run of a case; its results are gone when it is."""

    def __init__(self, case, *settings):
        self._folder = tempfile.TemporaryDirectory()
        self.output = pathlib.Path(self._folder.name) / "output"
        command = [SPHINX, "run", str(CASES / case), "--output", str(self.output), "-j", "1"]
        for setting in settings:
            command += ["--set", setting]
        done = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=False)
        if done.returncode != 0:
            sys.exit(f"{' '.join(command)} ended with {done.returncode}:\n{done.stdout[-2000:]}\n{done.stderr}")

    def series(self, name):
        """A time series by columns, without their units; each an array over time."""
        lines = (self.output / f"{name}.csv").read_text().splitlines()
        names = [column.split(" [")[0] for column in lines[0].split(",")]
        rows = np.array([[float(value) for value in line.split(",")] for line in lines[1:]])
        return dict(zip(names, rows.T))

    def frames(self, body):
        """(time, fields) of each VTU frame; vectors with as many components as the file has."""
        pvd = ElementTree.parse(self.output / f"{body}.pvd")
        for entry in pvd.findall("./Collection/DataSet"):
            reader = vtkXMLUnstructuredGridReader()
            reader.SetFileName(str(self.output / entry.get("file")))
            reader.Update()
            grid = reader.GetOutput()
            data = grid.GetPointData()
            fields = {data.GetArrayName(k): vtk_to_numpy(data.GetArray(k))
                      for k in range(data.GetNumberOfArrays())}
            fields["position"] = vtk_to_numpy(grid.GetPoints().GetData())
            yield float(entry.get("timestep")), fields


def reference(case, name):
    """Columns of a CSV file in the folder of the case."""
    return table(CASES / case / "reference" / name)


def table(path):
    """Columns of a CSV file; lines of # are comments."""
    lines = [line for line in path.read_text().splitlines() if line and not line.startswith("#")]
    rows = np.array([[float(value) for value in line.split(",")] for line in lines[1:]])
    return dict(zip(lines[0].split(","), rows.T))


class Report:
    """Measured values with their limits; `end` fails the test when one is outside."""

    def __init__(self):
        self.failed = []

    def check(self, what, value, low, high, note=""):
        inside = bool(low <= value <= high)  # NaN is outside
        if not inside:
            self.failed.append(what)
        print(f"{'ok    ' if inside else 'FAILED'} {what}: {value:.6g}, "
              f"must be in [{low:.6g}, {high:.6g}]{'; ' + note if note else ''}", flush=True)

    def end(self):
        sys.exit(f"{len(self.failed)} outside: {'; '.join(self.failed)}" if self.failed else 0)


def new_plot(width=7.0, height=4.5):
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(width, height), layout="constrained")
    axes.grid(alpha=0.3)
    return figure, axes


def save_plot(figure, case, name):
    """At 256 colours: half the size, and no eye sees a difference in lines."""
    from PIL import Image

    path = CASES / case / name
    figure.savefig(path, dpi=100)
    Image.open(path).convert("P", palette=Image.ADAPTIVE, colors=256).save(path, optimize=True)
    print(path)
