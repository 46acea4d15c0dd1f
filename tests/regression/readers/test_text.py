# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""CSV read by Python, restarts by xmllint and an XML parser."""

import base64
import csv
import re
import struct
import subprocess
import unittest
import xml.etree.ElementTree
import zlib

import numpy as np

import samples


class TextFiles(unittest.TestCase):
    def test_csv(self):
        with open(samples.folder() / "series" / "probe.csv", newline="") as file:
            rows = list(csv.reader(file))
        self.assertEqual(rows[0], ["time [s]", "pressure [Pa]", "velocity_x [m/s]",
                                   "velocity_y [m/s]"])
        self.assertEqual(len(rows), 2501)
        for k, row in enumerate(rows[1:]):
            time = 0.1 * k
            expected = [time, time / 3, time / 3 + 1, time / 3 + 2]
            if k == 2:
                expected[1:] = [np.nan] * 3
            self.assertTrue(np.array_equal([float(x) for x in row], expected, equal_nan=True), row)

    def test_restart_matches_its_schema(self):
        schema = samples.REPOSITORY / "schemas" / "restart.xsd"
        for name in ("zlib.xml", "text.xml"):
            path = samples.folder() / "restart" / name
            check = ["xmllint", "--huge", "--noout", "--schema", str(schema)]
            subprocess.run(check + [str(path)], check=True, stderr=subprocess.DEVNULL)
            # The schema is not so loose that it takes anything.
            for good, bad in ((b'rank="vector"', b'rank="tensor"'),
                              (b'" crc32="', b'9999999" crc32="'),
                              (b"</state>", b"</state><body/>"),
                              (b"<integer name=", b"<integer title=")):
                wrong = samples.folder() / "restart" / "wrong.xml"
                wrong.write_bytes(path.read_bytes().replace(good, bad, 1))
                result = subprocess.run(check + [str(wrong)], stderr=subprocess.DEVNULL)
                self.assertNotEqual(result.returncode, 0, bad)

    def test_restart_values(self):
        for file in ("zlib.xml", "text.xml"):
            root = xml.etree.ElementTree.parse(samples.folder() / "restart" / file).getroot()
            self.assertEqual(root.find("case_text").text, "title: a & b\n")
            self.assertEqual(float(root.get("time")), 0.1)
            body = root.find("body")
            self.assertEqual(body.get("particles"), "20000")
            i = np.arange(20000.0)
            strain = np.stack([i + 100, i + 110, i + 101, i + 111], axis=1)  # column by column
            pressure = 1 / (i + 1) + 1
            pressure[5] = -np.nan
            expected = {"id": np.arange(20000), "pressure": pressure, "strain": strain.reshape(-1)}
            for field in body.findall("field"):
                values = b""
                for piece in field:
                    if piece.tag == "zlib":
                        part = zlib.decompress(base64.b64decode(piece.text))
                    elif field.get("rank") == "integer":
                        part = np.array(piece.text.split(" "), dtype=np.int64).tobytes()
                    else:
                        part = b"".join(struct.pack("<Q", int(t, 16)) if t.startswith("0x") else
                                        struct.pack("<d", float(t)) for t in piece.text.split(" "))
                    self.assertEqual(f"{zlib.crc32(part):08x}", piece.get("crc32"))
                    self.assertEqual(len(part), 8 * int(piece.get("values")))
                    values += part
                name = field.get("name")
                if name in expected:
                    self.assertEqual(values, expected[name].tobytes(), name)

    def test_whole_file_checksum(self):
        content = (samples.folder() / "restart" / "zlib.xml").read_bytes()
        body, end = content.rsplit(b"<checksum", 1)
        self.assertIn(f'crc32="{zlib.crc32(body):08x}"'.encode(), end)

    def test_tecplot(self):
        """By Tecplot's data format guide; VTK's reader takes no one-dimensional zones."""
        for name, dimension, _ in samples.CASES:
            for frame in range(samples.FRAMES):
                header, values = {}, []
                path = samples.folder() / name / f"water_{frame:06d}.dat"
                for line in path.read_text().splitlines():
                    if line[0].isupper():
                        key, rest = line.split(" ", 1)
                        header[key] = rest
                    else:
                        values.append([float(x) for x in line.split()])
                variables = re.findall(r'"(.*?)"', header["VARIABLES"])
                zone = dict(part.split(" = ") for part in header["ZONE"].split(", "))
                self.assertEqual(float(zone["SOLUTIONTIME"]), samples.time(frame))
                self.assertEqual((zone["DATAPACKING"], zone["STRANDID"]), ("POINT", "1"))
                self.assertEqual(int(zone["I"]), len(values))
                columns = dict(zip(variables, np.array(values).T, strict=True))
                position, arrays = samples.arrays("water", frame, dimension, padded=False)
                for k in range(dimension):
                    self.assertTrue(np.array_equal(columns["xyz"[k] + " [m]"], position[:, k]))
                    for j in range(dimension):
                        name_kj = "strain_" + "xyz"[k] + "xyz"[j]
                        self.assertTrue(np.array_equal(columns[name_kj], arrays["strain"][:, k, j]))
                self.assertTrue(np.array_equal(columns["id"], arrays["id"]))
                self.assertTrue(np.array_equal(columns["pressure [Pa]"], arrays["pressure"]))


if __name__ == "__main__":
    unittest.main()
