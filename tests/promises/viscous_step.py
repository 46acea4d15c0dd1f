# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""The default time step is stable for flow that viscosity rules: any kernel, smoothing ratio and form."""

import copy
import csv
import unittest

import numpy as np

from support import REPOSITORY, Promise

CELLS = 8
SIDE = 1.0
SPEED = 1.0  # of the flow is SPEED times the largest of 0.0737, see below

# Slow flow through a square duct under a force per mass of SPEED nu/SIDE^2.
DUCT = {
    "sphinx": 2, "dimension": 3, "units": "none", "resolution": {"spacing": SIDE / CELLS},
    "variables": {"w": 0.5, "length": 0.75},
    "domain": {"lower": [0, "0-w", "0-w"], "upper": ["length", "1+w", "1+w"], "periodic": ["x"]},
    "geometry": {"duct": {"box": {"lower": [0, 0, 0], "upper": ["length", 1, 1]}},
                 "walls": {"difference": [{"box": {"lower": [0, "0-w", "0-w"], "upper": ["length", "1+w", "1+w"]}},
                                          "duct"]}},
    "materials": {"water": {"type": "weakly_compressible_fluid", "density": 1, "viscosity": 100, "sound_speed": 200},
                  "rigid": {"type": "rigid"}},
    "bodies": {"water": {"kind": "fluid", "shape": "duct", "material": "water"},
               "walls": {"kind": "solid", "shape": "walls", "material": "rigid"}},
    "topology": {"water": ["self", "walls"]},
    "dynamics": {"normals": {"type": "geometry.normals_from_shape", "body": "walls"},
                 "drive": {"type": "force.body_force", "body": "water", "acceleration": [100 * SPEED, 0, 0]},
                 "density": {"type": "fluid.density_summation", "body": "water", "surface": "confined"},
                 "viscosity": {"type": "fluid.viscous_force", "body": "water"},
                 "relaxation": {"type": "fluid.pressure_relaxation", "body": "water"},
                 "advection_dt": {"type": "fluid.advection_time_step", "body": "water", "reference_speed": 0.01},
                 "acoustic_dt": {"type": "fluid.acoustic_time_step", "body": "water"},
                 "neighbors": {"type": "neighbors.update", "bodies": ["water"]}},
    "loop": {"end_time": 0.006, "start": ["neighbors", "normals"], "layer": "advection", "dt": "advection_dt",
             "steps": ["density", "drive", "viscosity",
                       {"layer": "acoustic", "dt": "acoustic_dt",
                        "steps": ["relaxation.first_half", "relaxation.second_half"]}, "neighbors"]},
    "outputs": {"speed": {"type": "reduce", "every": {"time": 0.001}, "body": "water", "quantity": "maximum_speed"}},
}


class ViscousStep(Promise):
    def largest_speed(self, case, *changes):
        arguments = [word for change in changes for word in ("--set", change)]
        output = self.folder / "out"
        self.sphinx(self.write_case("case", case), output, "--overwrite", *arguments)
        with open(output / "speed.csv", encoding="utf-8") as file:
            return float(list(csv.reader(file))[-1][1])

    def test_duct(self):
        # At rest but for 0.3 %; the largest speed is that half a spacing from the middle line:
        # 0.07367 (White, Viscous Fluid Flow, (3-48)) less some percent.
        for change in ("kernel=wendland_c2", "smoothing_ratio=1.3", "kernel=quintic_spline", "kernel=cubic_spline"):
            with self.subTest(change=change):
                speed = self.largest_speed(DUCT, f"resolution.{change}")
                self.assertAlmostEqual(speed, 0.0737 * SPEED, delta=0.08 * 0.0737 * SPEED)

    def test_duct_of_another_form(self):
        case = copy.deepcopy(DUCT)
        case["loop"]["end_time"] = 0.003
        speed = self.largest_speed(case, "dynamics.viscosity.form=central")
        self.assertLess(speed, 0.09 * SPEED)

    def test_light_elastic_body(self):
        """It answers the fluid faster than the fluid itself, and is dragged as a heavy one."""
        case = REPOSITORY / "cases/shear_driven_elastic_layer_2d/case.yaml"
        forces = []
        for density in (1, 0.05):
            output = self.folder / f"layer_{density}"
            said = self.sphinx(case, output, "--set", "variables.spacing=gap/10", "--set", "loop.end_time=0.5",
                               "--set", "dynamics.advection_dt.cfl=0.25", "--set", f"materials.gel.density={density}")
            self.assertNotIn("warning: time", said)
            rows = np.genfromtxt(output / "force.csv", delimiter=",", names=True)
            forces.append(np.interp(0.5, rows["time"], rows["viscous_force_x"]))
        self.assertAlmostEqual(forces[0], forces[1], delta=0.05 * forces[0])

    def test_shear_wave(self):
        """exp(-nu k^2 t), of which the central form has 0.8 to 1.2 in the exponent."""
        case = copy.deepcopy(DUCT)
        case["geometry"] = {"duct": case["geometry"]["duct"]}
        case["domain"] = {"lower": [0, 0, 0], "upper": ["length", 1, 1], "periodic": ["x", "y", "z"]}
        noise = "1e-4*sin(50*x*y + 40*z)"
        case["bodies"] = {"water": {"kind": "fluid", "shape": "duct", "material": "water",
                                    "initial": {"velocity": [f"0.01*sin(2*pi*y) + {noise}", noise, noise]}}}
        case["variables"]["length"] = 1
        case["topology"] = {"water": ["self"]}
        case["loop"].update(end_time=0.0004, start=["neighbors"])
        del case["dynamics"]["normals"]
        case["dynamics"]["drive"]["acceleration"] = [0, 0, 0]
        for form in ("laplacian", "central"):
            with self.subTest(form=form):
                speed = self.largest_speed(case, f"dynamics.viscosity.form={form}")
                self.assertLess(speed, 0.01)
                self.assertGreater(speed, 0.001)


if __name__ == "__main__":
    unittest.main()
