# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""VTU, PVD and VTKHDF files read by VTK."""

import unittest
import xml.etree.ElementTree

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

import samples


class VtkFiles(unittest.TestCase):
    def check(self, points, body, frame, dimension, single, where):
        position, arrays = samples.arrays(body, frame, dimension, padded=True)
        found = vtk_to_numpy(points.GetPoints().GetData())
        self.assertTrue(samples.same(found, position, single=False), where)  # places keep their digits
        data = points.GetPointData()
        names = [data.GetArrayName(k) for k in range(data.GetNumberOfArrays())]
        self.assertEqual(sorted(names), sorted(arrays), where)
        for name, expected in arrays.items():
            found = vtk_to_numpy(data.GetArray(name))
            self.assertTrue(samples.same(found, expected, single), f"{where} {name}")

    def check_cells(self, points, cells, where):
        n = points.GetNumberOfPoints()
        connectivity = vtk_to_numpy(cells.GetConnectivityArray())
        offsets = vtk_to_numpy(cells.GetOffsetsArray())
        self.assertTrue(np.array_equal(connectivity, np.arange(n)), where)
        self.assertTrue(np.array_equal(offsets, np.arange(n + 1)), where)

    def read_vtu(self, path):
        reader = vtk.vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(path))
        errors = []
        reader.AddObserver("ErrorEvent", lambda *event: errors.append(event))
        reader.Update()
        self.assertEqual(errors, [], path)
        return reader.GetOutput()

    def test_pvd_and_vtu(self):
        for name, dimension, single in samples.CASES:
            folder = samples.folder() / name
            for body in ("water", "wall"):
                collection = xml.etree.ElementTree.parse(folder / f"{body}.pvd")
                entries = collection.findall("./Collection/DataSet")
                self.assertEqual([float(e.get("timestep")) for e in entries],
                                 [samples.time(f) for f in range(samples.FRAMES)])
                for frame, entry in enumerate(entries):
                    where = f"{name} {body} {frame}"
                    grid = self.read_vtu(folder / entry.get("file"))
                    self.check(grid, body, frame, dimension, single, where)
                    self.check_cells(grid, grid.GetCells(), where)
                    self.assertEqual(grid.GetCellType(0), vtk.VTK_VERTEX)

    def test_static_body_is_stored_once(self):
        names = sorted(p.name for p in (samples.folder() / "frames_2d").glob("wall_*.vtu"))
        self.assertEqual(names, ["wall_000000.vtu", "wall_000003.vtu"])

    def test_vtu_provenance_time_and_units(self):
        grid = self.read_vtu(samples.folder() / "frames_2d" / "water_000001.vtu")
        fields = grid.GetFieldData()
        self.assertEqual(fields.GetAbstractArray("version").GetValue(0), "1.2.3")
        self.assertEqual(fields.GetAbstractArray("compiler").GetValue(0), "g++ <12> & é")
        self.assertEqual(fields.GetArray("TimeValue").GetValue(0), samples.time(1))
        pressure = grid.GetPointData().GetArray("pressure")
        self.assertEqual(pressure.GetInformation().Get(vtk.vtkDataArray.UNITS_LABEL()), "Pa")

    def test_vtkhdf(self):
        for name, dimension, single in samples.CASES:
            for body in ("water", "wall"):
                reader = vtk.vtkHDFReader()
                reader.SetFileName(str(samples.folder() / name / f"{body}.vtkhdf"))
                errors = []
                reader.AddObserver("ErrorEvent", lambda *event: errors.append(event))
                self.assertTrue(reader.CanReadFile(reader.GetFileName()))
                reader.UpdateInformation()
                information = reader.GetOutputInformation(0)
                steps = information.Get(vtk.vtkStreamingDemandDrivenPipeline.TIME_STEPS())
                self.assertEqual(list(steps), [samples.time(f) for f in range(samples.FRAMES)])
                # Backwards as well: a step must not depend on the one read before.
                for frame in [0, 1, 2, 3, 1, 0, 3]:
                    where = f"{name} {body} {frame}"
                    reader.UpdateTimeStep(samples.time(frame))
                    self.assertEqual(errors, [], where)
                    points = reader.GetOutputDataObject(0)
                    self.assertTrue(points.IsA("vtkPolyData"), where)
                    self.check(points, body, frame, dimension, single, where)
                    self.check_cells(points, points.GetVerts(), where)
                    self.assertEqual(points.GetNumberOfLines() + points.GetNumberOfPolys(), 0)


if __name__ == "__main__":
    unittest.main()
