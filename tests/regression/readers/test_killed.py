# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Files of a writer that was killed at a random moment, opened by VTK and h5py."""

import os
import pathlib
import random
import subprocess
import tempfile
import time
import unittest
import xml.etree.ElementTree

import h5py
import vtk

import samples

KILLS = 10


class KilledWriter(unittest.TestCase):
    def test_every_file_opens(self):
        chance = random.Random(1)
        for _ in range(KILLS):
            with tempfile.TemporaryDirectory() as name:
                self.kill_writer(name, chance.uniform(0.05, 0.4))
                folder = pathlib.Path(name)
                frames = self.check_hdf5(folder)
                self.assertGreater(frames, 0)
                # All are written in the same call, so they are at most one frame apart.
                self.assertLessEqual(abs(self.check_vtkhdf(folder) - frames), 1)
                self.assertLessEqual(abs(self.check_pvd(folder) - frames), 1)

    def kill_writer(self, name, seconds):
        environment = dict(os.environ, SPHINX_SAMPLES=name)
        writer = subprocess.Popen([samples.WRITER, "[.endless]"], env=environment,
                                  stdout=subprocess.DEVNULL)
        # With the second frame of one the first of all is there, however busy the machine.
        index = pathlib.Path(name, "water.pvd")
        while not index.exists() or index.read_text().count("<DataSet ") < 2:
            self.assertIsNone(writer.poll())
            time.sleep(0.01)
        time.sleep(seconds)
        self.assertIsNone(writer.poll())
        writer.kill()
        writer.wait()

    def check_hdf5(self, folder):
        def read(name, item):
            if isinstance(item, h5py.Dataset):
                item[()]

        with h5py.File(folder / "results.h5") as file:
            file.visititems(read)
            frames = len(file["bodies/water/time"])
            self.assertIn(f"frame_{frames - 1:06d}", file["bodies/water"])
        return frames

    def check_vtkhdf(self, folder):
        reader = vtk.vtkHDFReader()
        reader.SetFileName(str(folder / "water.vtkhdf"))
        errors = []
        reader.AddObserver("ErrorEvent", lambda *event: errors.append(event))
        reader.UpdateInformation()
        information = reader.GetOutputInformation(0)
        steps = information.Get(vtk.vtkStreamingDemandDrivenPipeline.TIME_STEPS())
        for step in (steps[0], steps[-1]):
            reader.UpdateTimeStep(step)
            self.assertGreaterEqual(reader.GetOutputDataObject(0).GetNumberOfPoints(), 1499)
        self.assertEqual(errors, [])
        return len(steps)

    def check_pvd(self, folder):
        entries = xml.etree.ElementTree.parse(folder / "water.pvd").findall("./Collection/DataSet")
        reader = vtk.vtkXMLUnstructuredGridReader()
        errors = []
        reader.AddObserver("ErrorEvent", lambda *event: errors.append(event))
        for entry in entries:
            reader.SetFileName(str(folder / entry.get("file")))
            reader.Update()
        self.assertEqual(errors, [])
        return len(entries)


if __name__ == "__main__":
    unittest.main()
