# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Example: reads the results of a run in Python.

usage: .venv/bin/python scripts/read_results.py output/dam_break_2d
"""
import sys
from pathlib import Path

import h5py
import numpy as np

folder = Path(sys.argv[1])

# results.h5: the time series of all observers and reductions, with units.
with h5py.File(folder / "results.h5") as file:
    for name, series in file["series"].items():
        time = series["time"][:]
        for quantity in sorted(series.keys() - {"time"}):
            values = series[quantity]
            unit = values.attrs["unit"].decode() or "-"
            print(f"{name}: {quantity} [{unit}], {len(time)} times "
                  f"up to {time[-1]:g}, largest {np.nanmax(values):g}")

# The same series as text: one CSV file each, a line of names, then the numbers.
for path in sorted(folder.glob("*.csv")):
    table = np.genfromtxt(path, delimiter=",", names=True)
    print(f"{path.name}: {', '.join(table.dtype.names)}")
