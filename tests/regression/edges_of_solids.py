# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Drops fall onto, along and past edges of solids: blocks, plates of one to four rows, posts and cups.

Nothing gains energy there, and nothing passes a wall. Each drop has a solid of its own; the case is
made here. Findings: engine/dynamics/fluid/free_surface.md.
"""

import pathlib
import tempfile

import numpy as np
import yaml

import checks

SPACING = 0.01
FALL = 0.02  # from rest of the lowest point to the solid, besides the speed at the start
GRAVITY, DENSITY = 9.81, 1000.0
# Of the kinetic energy at impact, that the energy of a drop rises above the least it had before. Measured:
# 8e-4 past a wall in 3D, 3e-4 or less in 2D.
RISE_LIMIT = 1e-3
# What falls along the end of a plate of one row, whose last particle has one normal for three faces: measured 2.3e-2.
RISE_LIMIT_ONE_ROW = 0.05


DEPTH_LIMIT = 0.5  # spacings: where the first row of the solid stands


class Drop:
    """`kind` and `rows` of the solid; centre of the drop beside its middle, end or edge in radii; speed down."""

    def __init__(self, kind, rows, beside, speed, radius):
        self.kind, self.rows, self.beside, self.speed, self.radius = kind, rows, beside, speed, radius

    def solid(self):
        """Boxes: lower and upper corners (2D), the faces that the drop meets at y = 0."""
        t = self.rows * SPACING
        if self.kind == "block":
            return [((-0.3, -0.3), (0, 0))]
        if self.kind == "plate":
            return [((-0.15, -t), (0.15, 0))]
        if self.kind == "end of a plate":
            return [((-0.3, -t), (0, 0))]
        if self.kind == "post":
            return [((-t / 2, -0.3), (t / 2, 0))]
        if self.kind == "cup":
            return [((-0.12 - t, -t), (0.12 + t, 0)), ((-0.12 - t, 0), (-0.12, 0.12)), ((0.12, 0), (0.12 + t, 0.12))]
        return [((-t, -0.6), (0, 0))]  # a wall that the drop falls past

    def centre(self):
        if self.kind == "past":
            return self.radius + 0.5 * SPACING, self.radius + FALL
        return self.beside * self.radius, self.radius + FALL

    def text(self):
        return f"{self.kind}{f' of {self.rows} rows' if self.rows else ''}, {self.beside:+.1f} R, {self.speed} m/s"


DROPS = [
    Drop("block", 0, -0.5, 1, 0.06), Drop("block", 0, 0, 1, 0.06), Drop("block", 0, 0.5, 3, 0.06),
    Drop("block", 0, 0, 3, 0.1),
    Drop("plate", 1, 0, 1, 0.06), Drop("plate", 2, 0, 2, 0.06), Drop("plate", 3, 0, 3, 0.08),
    Drop("plate", 4, 0, 3, 0.08),
    Drop("end of a plate", 3, 0, 2, 0.06), Drop("end of a plate", 2, 0, 1, 0.05),
    Drop("post", 3, 0, 2, 0.06), Drop("post", 4, 0.3, 3, 0.08),
    Drop("cup", 3, 0, 1, 0.06), Drop("cup", 3, 0, 3, 0.08), Drop("cup", 4, 0.5, 2, 0.05),
    Drop("past", 3, 0, 2, 0.06),
]
DROPS_3D = [
    Drop("block", 0, 0, 1, 0.05), Drop("block", 0, 0.5, 3, 0.05), Drop("plate", 2, 0, 2, 0.05),
    Drop("plate", 3, 0, 3, 0.06), Drop("end of a plate", 3, 0, 2, 0.05), Drop("post", 3, 0, 2, 0.05),
    Drop("cup", 3, 0, 3, 0.05), Drop("past", 3, 0, 2, 0.05),
]


def case(drops, dim, end):
    """The drops side by side. In 3D solids are 0.3 m deep, and a cup has a wall on all sides."""
    bodies, geometry, dynamics, topology, outputs = {}, {}, {}, {}, {}
    of = lambda prefix: [f"{prefix}_{k}" for k in range(len(drops))]
    for k, drop in enumerate(drops):
        middle = 0.8 * k
        depth = 0.15 if drop.kind != "cup" else 0.12 + drop.rows * SPACING
        boxes = []
        for n, (lower, upper) in enumerate(drop.solid()):
            wide = ([-depth], [depth]) if dim == 3 else ([], [])
            # Height is the last axis.
            geometry[f"box_{k}_{n}"] = {"box": {
                "lower": [middle + lower[0], *wide[0], lower[1]],
                "upper": [middle + upper[0], *wide[1], upper[1]]}}
            boxes.append(f"box_{k}_{n}")
        if drop.kind == "cup" and dim == 3:
            for side, (lower, upper) in enumerate(((-depth, -0.12), (0.12, depth))):
                geometry[f"side_{k}_{side}"] = {"box": {"lower": [middle - 0.12, lower, 0],
                                                        "upper": [middle + 0.12, upper, 0.12]}}
                boxes.append(f"side_{k}_{side}")
        if len(boxes) == 1:
            geometry[f"solid_{k}"] = geometry.pop(boxes[0])
        else:
            geometry[f"solid_{k}"] = {"union": boxes}
        x, y = drop.centre()
        ball = "circle" if dim == 2 else "sphere"
        geometry[f"drop_{k}"] = {ball: {"center": [middle + x, *([0] * (dim - 2)), y], "radius": drop.radius}}
        still = [0] * (dim - 1)
        bodies[f"water_{k}"] = {"kind": "fluid", "shape": f"drop_{k}", "material": "water",
                                "initial": {"velocity": [*still, -drop.speed]}}
        bodies[f"solid_{k}"] = {"kind": "solid", "shape": f"solid_{k}", "material": "rigid"}
        topology[f"water_{k}"] = ["self", f"solid_{k}"]
        dynamics[f"normals_{k}"] = {"type": "geometry.normals_from_shape", "body": f"solid_{k}"}
        for name, method, settings in (
                ("gravity", "force.gravity", {"acceleration": [*still, -GRAVITY]}),
                ("summation", "fluid.density_summation", {}),
                ("relaxation", "fluid.pressure_relaxation", {}),
                ("advection_dt", "fluid.advection_time_step", {"reference_speed": 5}),
                ("acoustic_dt", "fluid.acoustic_time_step", {})):
            dynamics[f"{name}_{k}"] = {"type": method, "body": f"water_{k}", **settings}
        outputs[f"energy_{k}"] = {"type": "reduce", "every": {"time": 0.002}, "body": f"water_{k}",
                                  "quantity": "mechanical_energy"}
    outputs["frames"] = {"type": "vtu", "every": {"time": 0.05}, "bodies": {name: ["velocity"] for name in of("water")}}
    dynamics["neighbors"] = {"type": "neighbors.update", "bodies": of("water")}
    acoustic = {"layer": "acoustic", "dt": of("acoustic_dt"),
                "steps": [f"{name}.{half}" for half in ("first_half", "second_half") for name in of("relaxation")]}
    return {
        "sphinx": 2, "dimension": dim, "resolution": {"spacing": SPACING},
        "geometry": geometry, "bodies": bodies, "topology": topology, "dynamics": dynamics, "outputs": outputs,
        "materials": {"water": {"type": "weakly_compressible_fluid", "density": DENSITY, "sound_speed": 60},
                      "rigid": {"type": "rigid"}},
        "loop": {"end_time": end, "start": ["neighbors", *of("normals")], "layer": "advection",
                 "dt": of("advection_dt"), "steps": [*of("summation"), *of("gravity"), acoustic, "neighbors"]},
    }


def measure(drops, dim, end=0.25):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "case.yaml"
        path.write_text(yaml.safe_dump(case(drops, dim, end), sort_keys=False))
        run = checks.Run(path)
    for k, drop in enumerate(drops):
        total = run.series(f"energy_{k}")["total"]
        volume = np.pi * drop.radius**2 if dim == 2 else 4 / 3 * np.pi * drop.radius**3
        impact = 0.5 * DENSITY * volume * (drop.speed**2 + 2 * GRAVITY * FALL)
        depth, passed = 0, 0
        for _, fields in run.frames(f"water_{k}"):
            x = fields["position"][:, 0] - 0.8 * k
            y = fields["position"][:, dim - 1]
            near = abs(fields["position"][:, 1]) < 0.12 if dim == 3 else x == x
            for lower, upper in drop.solid():
                inside = np.min([x - lower[0], upper[0] - x, y - lower[1], upper[1] - y], axis=0)
                depth = max(depth, inside[near].max(initial=0) / SPACING)
            if drop.kind in ("cup", "plate"):
                half = 0.1 if drop.kind == "plate" else 0.12
                passed = max(passed, int((near & (abs(x) < half) & (y < -drop.rows * SPACING)).sum()))
        yield drop, {"rise": (total - np.minimum.accumulate(total)).max() / impact, "depth": depth, "passed": passed}


def study():
    for dim, drops in ((2, DROPS), (3, DROPS_3D)):
        for drop, found in measure(drops, dim):
            print(f"| {dim}D | {drop.text()} | {found['rise']:.1e} | {found['depth']:.2f} |", flush=True)


def main():
    options = checks.arguments(study=study)
    report = checks.Report()
    for dim, drops in ((2, DROPS), (3, DROPS_3D)) if options.long else ((2, DROPS),):
        for drop, found in measure(drops, dim):
            what = f"{dim}D: {drop.text()}"
            limit = RISE_LIMIT_ONE_ROW if drop.rows == 1 else RISE_LIMIT
            report.check(f"rise of the energy, of that at impact: {what}", found["rise"], 0, limit)
            report.check(f"deepest place in the solid, spacings: {what}", found["depth"], 0, DEPTH_LIMIT)
            report.check(f"particles beyond the wall: {what}", found["passed"], 0, 0)
    report.end()


if __name__ == "__main__":
    main()
