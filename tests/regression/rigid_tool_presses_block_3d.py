# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Rigid tool of a mechanism that presses an elastic block on a rigid floor: what the floor carries is what the tool exerts
and the weight of the block."""

import numpy as np

import checks

CASE = "rigid_tool_presses_block_3d"
WEIGHT = 1000 * 0.08 * 0.08 * 0.04 * 9.81


def measure(rows):
    run = checks.Run(f"{CASE}/case.yaml", f"variables.spacing=height/{rows}", "outputs.frames.every={time: 10}")
    tool, floor = run.series("tool"), run.series("floor")
    late = tool["time"] > 0.12
    force = {name: [series[f"contact_force_{c}"][late].mean() for c in "xyz"] for name, series in
             (("tool", tool), ("floor", floor))}
    return {"force": force["tool"][2], "balance": force["tool"][2] + force["floor"][2] + WEIGHT,
            "sideways": np.abs(force["tool"][:2] + force["floor"][:2]).max(),
            "noise": np.ptp(tool["contact_force_z"][late])}


def main():
    options = checks.arguments()
    report = checks.Report()
    forces = {}
    for rows in (8, 12) if options.long else (4,):
        found = measure(rows)
        forces[rows] = found["force"]
        what = f"height/{rows}"
        report.check(f"{what}: force on the tool [N]", found["force"], 250, 500)
        report.check(f"{what}: floor less tool and weight, of the force", found["balance"] / found["force"], -1e-4, 1e-4)
        report.check(f"{what}: force sideways, of the force", found["sideways"] / found["force"], 0, 1e-6)
        report.check(f"{what}: swing of the force at rest, of it", found["noise"] / found["force"], 0, 1e-3)
    if options.long:
        report.check("force at height/12 less that at height/8, of it", forces[12] / forces[8] - 1, -0.1, 0.1)
    report.end()


main()
