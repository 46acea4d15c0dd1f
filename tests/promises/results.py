# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Results folders: opened by their real readers, and compared."""

import pathlib
import re
import subprocess
import xml.etree.ElementTree as ElementTree

import h5py
import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from support import REPOSITORY

SCHEMA = REPOSITORY / "schemas/restart.xsd"
# Say when, where and for how long a run was made.
ABOUT_THE_RUN = {"log.txt", "profile.json", "case.resolved.yaml"}


def _vtk_errors(reader):
    errors = []
    reader.AddObserver("ErrorEvent", lambda *event: errors.append(event))
    return errors


def read_vtu(path):
    reader = vtk.vtkXMLUnstructuredGridReader()
    errors = _vtk_errors(reader)
    reader.SetFileName(str(path))
    reader.Update()
    assert not errors and reader.GetOutput().GetNumberOfPoints() > 0, f"{path} does not open"
    return reader.GetOutput()


def read_vtkhdf(path):
    """Opens all time steps."""
    reader = vtk.vtkHDFReader()
    errors = _vtk_errors(reader)
    reader.SetFileName(str(path))
    reader.UpdateInformation()
    steps = reader.GetOutputInformation(0).Get(vtk.vtkStreamingDemandDrivenPipeline.TIME_STEPS())
    # A file with one frame is no time series to VTK.
    for step in steps or [0]:
        reader.UpdateTimeStep(step)
        assert reader.GetOutputDataObject(0).GetNumberOfPoints() > 0, f"{path} at {step} is empty"
    assert not errors, f"{path} does not open"


def hdf5_content(path):
    """Name -> value of all datasets and attributes, but for the provenance of the run."""
    content = {}

    def visit(name, item):
        content[name] = item[()] if isinstance(item, h5py.Dataset) else None
        for key, value in item.attrs.items():
            content[f"{name}@{key}"] = value

    with h5py.File(path) as file:
        file.visititems(visit)
    return {name: value for name, value in content.items() if not name.startswith("provenance")}


def read_csv(path):
    """The numbers below the header; every row is complete."""
    lines = path.read_text().splitlines()
    rows = [line.split(",") for line in lines if not line.startswith("#")]
    assert all(len(row) == len(rows[0]) for row in rows), f"{path} has an incomplete row"
    assert path.read_text().endswith("\n"), f"{path} ends within a row"
    return np.array([[float(v) for v in row] for row in rows[1:]])


def _files(folder):
    return sorted(p.relative_to(folder) for p in pathlib.Path(folder).rglob("*") if p.is_file())


def check_readable(folder, after_kill=False):
    """Opens every file; right after a kill an unfinished restart or frame (*.tmp) may lie there,
    and the last row of a CSV file may be incomplete."""
    folder = pathlib.Path(folder)
    for name in _files(folder):
        path = folder / name
        if path.suffix == ".tmp":
            assert after_kill, f"{path} is left over"
        elif path.suffix == ".vtu":
            read_vtu(path)
        elif path.suffix == ".pvd":
            for entry in ElementTree.parse(path).findall("./Collection/DataSet"):
                assert (path.parent / entry.get("file")).exists(), f"{path} names {entry.get('file')}"
        elif path.suffix == ".vtkhdf":
            read_vtkhdf(path)
        elif path.suffix == ".h5":
            hdf5_content(path)
        elif path.suffix == ".csv" and not after_kill:
            read_csv(path)
        elif path.suffix == ".xml":
            subprocess.run(["xmllint", "--noout", "--schema", SCHEMA, path], check=True,
                           capture_output=True)


def content(folder):
    """The bytes of every file."""
    return {name: (pathlib.Path(folder) / name).read_bytes() for name in _files(folder)}


def changed(before, after):
    return sorted(str(name) for name in before.keys() | after.keys()
                  if before.get(name) != after.get(name))


def _text_content(path):
    """Without the lines that say which run wrote it."""
    return [line for line in path.read_bytes().splitlines()
            if not re.search(rb"date|threads|commit", line)]


def _vtu_content(path):
    grid = read_vtu(path)
    content = {"points": vtk_to_numpy(grid.GetPoints().GetData())}
    for data in (grid.GetPointData(), grid.GetFieldData()):
        for k in range(data.GetNumberOfArrays()):
            array = data.GetArray(k)
            if array is not None:
                content[array.GetName()] = vtk_to_numpy(array)
    return content


def _content(path):
    if path.suffix in (".h5", ".vtkhdf"):
        return hdf5_content(path)
    if path.suffix == ".vtu":
        return _vtu_content(path)
    return {"text": _text_content(path)}


def _same(first, second):
    if isinstance(first, np.ndarray) and first.dtype.kind == "f":
        return (first.dtype == second.dtype and first.shape == second.shape and
                first.tobytes() == second.tobytes())
    return np.array_equal(first, second)


def differences(first, second, ignored=ABOUT_THE_RUN):
    """What two results folders do not have in common; the restarts are left to Restart."""
    first, second = pathlib.Path(first), pathlib.Path(second)

    def names(folder):
        return {n for n in _files(folder) if n.name not in ignored and n.parts[0] != "restart"}

    found = [f"only one has {name}" for name in names(first) ^ names(second)]
    for name in sorted(names(first) & names(second)):
        a, b = _content(first / name), _content(second / name)
        found += [f"only one {name} has {key}" for key in a.keys() ^ b.keys()]
        found += [f"{name}: {key} differs" for key in a.keys() & b.keys() if not _same(a[key], b[key])]
    return found
