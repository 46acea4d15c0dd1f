# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""results.h5 read by h5py."""

import unittest

import h5py
import numpy as np

import samples


class Hdf5Files(unittest.TestCase):
    def test_frames(self):
        for name, dimension, single in samples.CASES:
            with h5py.File(samples.folder() / name / "results.h5") as file:
                self.assertEqual(file.attrs["version"].decode(), "1.2.3")
                self.assertEqual(file.attrs["compiler"].decode(), "g++ <12> & é")
                for body in ("water", "wall"):
                    group = file["bodies"][body]
                    times = [samples.time(f) for f in range(samples.FRAMES)]
                    self.assertEqual(list(group["time"][:]), times)
                    self.assertEqual(group["time"].attrs["unit"].decode(), "s")
                    self.assertEqual(list(group["step"][:]), [0, 10, 20, 30])
                    for frame in range(samples.FRAMES):
                        stored = group[f"frame_{frame:06d}"]
                        self.assertEqual(stored.attrs["time"], times[frame])
                        self.assertEqual(stored.attrs["step"], 10 * frame)
                        position, arrays = samples.arrays(body, frame, dimension, padded=False)
                        arrays["position"] = position
                        self.assertEqual(sorted(stored), sorted(arrays))
                        for field, expected in arrays.items():
                            rounded = single and field != "position"  # places keep their digits
                            self.assertTrue(samples.same(stored[field][:], expected, rounded),
                                            f"{name} {body} {frame} {field}")
                pressure = file["bodies/water/frame_000000/pressure"]
                self.assertEqual(pressure.attrs["unit"].decode(), "Pa")
                self.assertEqual(pressure.attrs["description"].decode(), "pressure")

    def test_unchanged_field_is_stored_once(self):
        with h5py.File(samples.folder() / "frames_2d" / "results.h5") as file:
            wall = file["bodies/wall"]
            self.assertEqual(wall["frame_000000/position"], wall["frame_000002/position"])
            self.assertNotEqual(wall["frame_000000/position"], wall["frame_000003/position"])

    def test_series(self):
        with h5py.File(samples.folder() / "series" / "results.h5") as file:
            probe = file["series/probe"]
            row = np.arange(2500)
            time = 0.1 * row
            gap = np.where(row == 2, np.nan, 0)
            self.assertTrue(np.array_equal(probe["time"][:], time))
            self.assertTrue(np.array_equal(probe["pressure"][:], time / 3 + gap, equal_nan=True))
            expected = np.stack([time / 3 + 1 + gap, time / 3 + 2 + gap], axis=1)
            self.assertTrue(np.array_equal(probe["velocity"][:], expected, equal_nan=True))
            attributes = probe["velocity"].attrs
            self.assertEqual(attributes["unit"].decode(), "m/s")
            self.assertEqual(attributes["description"].decode(), "velocity at the probe")
            self.assertEqual([label.decode() for label in attributes["labels"]], ["x", "y"])


if __name__ == "__main__":
    unittest.main()
