# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Water at rest is computed as well while other water hits a wall: the error of single pairs is below 1e-5 of its own
accelerations."""

import unittest

import numpy as np

from support import Promise, last_restart, load_case

ACCELERATION_ERROR = 1e-5
C0 = 15
DT = 0.002


class Quiet(Promise):
    def accelerations(self, precision, speed):
        """In the pool, in the second step: under its weight, hardly moving. Another pool of the same body is thrown at
        a wall."""
        case = load_case("tank_2d")
        case["resolution"]["precision"] = precision
        noise = f"{1e-3 * C0}*sin(50*x*y + 40*y)"
        case["geometry"] = {
            "pool": {"box": {"lower": [0, 0], "upper": ["length", "depth"]}},
            "thrown": {"box": {"lower": [2.5, 0], "upper": [3, "depth"]}},
            "water": {"union": ["pool", "thrown"]},
            "inside": {"box": {"lower": [0, 0], "upper": ["length", "height"]}},
            "space": {"box": {"lower": [2, 0], "upper": [3, "height"]}},
            "tank": {"difference": [{"offset": {"shape": {"union": ["inside", "space"]}, "by": "wall_width"}},
                                    "inside", "space"]}}
        case["domain"] = {"lower": [-1, -1], "upper": [4, 2]}
        other = "min(1, max(0, 10*x - 15))"  # 1 there, 0 in the pool
        case["bodies"]["water"].update(shape="water", initial={
            "velocity": [f"{noise}*(1 - {other}) + {speed}*{other}", f"{noise}*(1 - {other})"],
            "pressure": f"(depth - y)*(1 - {other}) + {0.1 * C0**2 * bool(speed)}*{other}"})
        del case["dynamics"]["motion"]
        case["loop"]["steps"][2]["steps"].remove("motion")
        case["loop"]["dt"] = DT
        velocity = []
        for end_time in (DT, 2 * DT):
            case["loop"]["end_time"] = end_time
            output = self.folder / f"{precision}_{speed}_{end_time}"
            self.sphinx(self.write_case("case", case), output)
            restart = last_restart(output)
            pool = restart.by_id("water", "position")[:, 0] < 1.5
            velocity.append(restart.by_id("water", "velocity")[pool])
        return (velocity[1] - velocity[0]) / DT

    def test_pool_beside_an_impact(self):
        exact = self.accelerations("double", 0)
        size = np.sqrt((exact**2).sum(axis=1).mean())
        for precision, speed in (("single", 0), ("double", 0.2 * C0), ("single", 0.2 * C0)):
            error = self.accelerations(precision, speed) - exact
            error = np.sqrt((error**2).sum(axis=1).mean()) / size
            print(f"{precision}, other water at {speed}: {error:.1e} of {size:.2g} (rms)")
            self.assertLess(error, ACCELERATION_ERROR)


if __name__ == "__main__":
    unittest.main()
