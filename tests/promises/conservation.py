# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Mass is kept exactly and momentum to rounding; a uniform drift changes nothing."""

import math
import shutil
import unittest

import numpy as np
from vtk.util.numpy_support import vtk_to_numpy

import results
from support import Promise, last_restart, load_case

# Part of sum m|v|: the pair forces cancel exactly, what remains is the rounding of sums.
MOMENTUM_DRIFT = 1e-12
# In particle spacings, as for a mirrored run.
POSITION_ERROR = 1e-9
SPACING = 0.05
# Of the weight's impulse in the same time.
IMPULSE_ERROR = 1e-3
PERIODIC_2D = {"lower": [-1, -1], "upper": [1, 1], "periodic": ["x", "y"]}
# "As good as random" in each direction.
NOISE = ["0.3*sin(1000*sin(12.9898*x + 78.233*y + 37.719*z))",
         "0.3*sin(1000*cos(39.3468*x - 11.135*y + 83.155*z))",
         "0.3*sin(1000*sin(73.156*x + 52.235*y - 9.151*z))"]
SOLID_3D = {
    "dimension": 3,
    "domain": {"lower": [-1, -1, -1], "upper": [1, 1, 1]},
    "geometry": {"drop": {"sphere": {"center": [0, 0, 0], "radius": 0.5}}},
    "bodies__water__initial": {"velocity": NOISE},
    "variables__spacing": 0.1,
}


def first_frame(output, field, body="water"):
    """By id, as the run began."""
    data = results.read_vtu(output / f"{body}_000000.vtu").GetPointData()
    values = vtk_to_numpy(data.GetArray(field))
    return values[np.argsort(vtk_to_numpy(data.GetArray("id")))]


def momentum(mass, velocity):
    return np.array([math.fsum(mass * velocity[:, k]) for k in range(velocity.shape[1])])


class Conservation(Promise):
    def mass_and_momentum_kept(self, **changes):
        self.kept_in(self.case("free_2d", **changes))

    def kept_in(self, case):
        output = self.folder / "out"
        self.sphinx(case, output)
        after = last_restart(output)
        mass, velocity = first_frame(output, "mass"), first_frame(output, "velocity")
        velocity = velocity[:, :after.values("water", "velocity").shape[1]]
        self.assertEqual(mass.tobytes(), after.by_id("water", "mass").tobytes())
        moved = np.abs(after.by_id("water", "velocity") - velocity).max()
        self.assertGreater(moved, 0.1, "nothing happened")
        drift = momentum(mass, after.by_id("water", "velocity")) - momentum(mass, velocity)
        size = math.fsum(mass * np.linalg.norm(velocity, axis=1))
        print(f"{len(mass)} particles, {after.steps} steps: momentum drift "
              f"{np.abs(drift).max() / size:.1e} of sum m|v|")
        self.assertGreaterEqual(after.steps, 200)
        self.assertLessEqual(np.abs(drift).max(), MOMENTUM_DRIFT * size)

    def test_drop(self):
        self.mass_and_momentum_kept()

    def test_drop_tait_dissipative(self):
        self.mass_and_momentum_kept(materials__fresh_water__equation_of_state="tait",
                                    dynamics__pressure_relaxation__riemann="dissipative")

    def test_drop_3d(self):
        self.mass_and_momentum_kept(**SOLID_3D)

    def test_drop_of_honey(self):
        """The viscosity is solved for, to 0.01 of the velocities: momentum is kept all the same."""
        for viscosity in (0.1, 100):
            with self.subTest(viscosity=viscosity):
                case = load_case("free_2d")
                case["materials"]["fresh_water"]["viscosity"] = viscosity
                case["bodies"]["water"]["initial"]["velocity"][0] += " + 0.5*y"
                case["dynamics"]["viscosity"] = {"type": "fluid.implicit_viscosity", "body": "water",
                                                 "tolerance": 0.01}
                case["loop"]["steps"].remove("viscosity")
                case["loop"]["steps"].insert(1, "none")
                case["dynamics"]["none"] = {"type": "force.gravity", "body": "water", "acceleration": [0, 0]}
                case["loop"]["steps"][2]["steps"].insert(1, "viscosity")
                self.kept_in(self.write_case(f"honey_{viscosity}", case))
                shutil.rmtree(self.folder / "out")

    def test_walls_get_what_the_honey_loses(self):
        """As below, at the velocities at which the honey has felt the walls: what is left is that
        the output asks for the pressure at the end of a step."""
        every = {"time": 0.05}
        case, output = self.case("honey_2d", outputs={
            "force": {"type": "reduce", "every": every, "body": "wall", "quantity": "force",
                      "average": True, "layer": "acoustic"},
            "momentum": {"type": "reduce", "every": every, "body": "water", "quantity": "momentum"},
            "mass": {"type": "reduce", "body": "water", "quantity": "mass"}}), self.folder / "out"
        self.sphinx(case, output)
        weight = results.read_csv(output / "mass.csv")[0, 1]  # g = 1
        rows = results.read_csv(output / "force.csv")
        duration, force = np.diff(rows[:, 0]), rows[1:, 5:7]
        gained = np.diff(results.read_csv(output / "momentum.csv")[:, 1:], axis=0)
        unexplained = gained + duration[:, None] * (force + [0, weight])
        part = np.abs(unexplained.sum(axis=0)) / (weight * duration.sum())
        print(f"impulse on the walls: {part[0]:.1e} and {part[1]:.1e} of the weight's unexplained")
        self.assertLessEqual(part[0], IMPULSE_ERROR)
        self.assertLessEqual(part[1], IMPULSE_ERROR)

    def test_periodic_block(self):
        self.mass_and_momentum_kept(
            domain=PERIODIC_2D, geometry={"drop": {"box": {"lower": [-1, -1], "upper": [1, 1]}}},
            dynamics__density_summation__surface="confined")

    def test_two_liquids(self):
        """The momentum of both together; each takes more than rounding from the other."""
        case, output = self.case("liquids_2d"), self.folder / "out"
        self.sphinx(case, output)
        after = last_restart(output)
        drift, size = {}, 0.0
        for body in ("water", "oil"):
            mass, velocity = (first_frame(output, field, body) for field in ("mass", "velocity"))
            velocity = velocity[:, :2]
            drift[body] = momentum(mass, after.by_id(body, "velocity")) - momentum(mass, velocity)
            size += math.fsum(mass * np.linalg.norm(velocity, axis=1))
        both = np.abs(sum(drift.values())).max()
        print(f"two liquids, {after.steps} steps: momentum drift {both / size:.1e} of sum m|v|, "
              f"of one {np.abs(drift['water']).max() / size:.1e}")
        self.assertGreater(np.abs(drift["water"]).max(), 1e-4 * size, "nothing happened")
        self.assertLessEqual(both, MOMENTUM_DRIFT * size)

    def test_mass_with_walls(self):
        case, output = self.case("splash_2d"), self.folder / "out"
        self.sphinx(case, output)
        self.assertEqual(first_frame(output, "mass").tobytes(),
                         last_restart(output).by_id("water", "mass").tobytes())

    def test_walls_get_what_the_water_loses(self):
        """The impulse of the mean force on the walls against momentum and weight of the water, in
        a splash. What is left: velocities change between the sum and the sample, friction in
        between. (Sampled after advection steps 0.066 is left in x.)"""
        every = {"time": 0.05}
        force = {"type": "reduce", "every": every, "body": "wall", "quantity": "force",
                 "average": True, "layer": "acoustic"}
        momentum = {"type": "reduce", "every": every, "body": "water", "quantity": "momentum"}
        mass = {"type": "reduce", "body": "water", "quantity": "mass"}
        case, output = self.case("splash_2d", outputs={
            "force": force, "momentum": momentum, "mass": mass}), self.folder / "out"
        self.sphinx(case, output)
        weight = results.read_csv(output / "mass.csv")[0, 1]  # g = 1
        rows = results.read_csv(output / "force.csv")
        duration, force = np.diff(rows[:, 0]), rows[1:, 5:7]
        gained = np.diff(results.read_csv(output / "momentum.csv")[:, 1:], axis=0)
        unexplained = gained + duration[:, None] * (force + [0, weight])
        part = np.abs(unexplained.sum(axis=0)) / (weight * duration.sum())
        print(f"impulse on the walls: {part[0]:.1e} and {part[1]:.1e} of the weight's unexplained")
        self.assertGreater(np.abs(gained).max(), 0.3 * weight * duration.max(), "nothing happened")
        self.assertLessEqual(part[0], IMPULSE_ERROR)
        self.assertLessEqual(part[1], IMPULSE_ERROR)

    def test_drifting_block(self):
        noise = load_case("free_2d")["bodies"]["water"]["initial"]["velocity"]
        found = {}
        # The drift carries the block around the box once and a half.
        for name, (u, v) in {"rest": (0, 0), "drift": (7.3, -5.1)}.items():
            velocity = [f"{u} + {noise[0]}", f"{v} + {noise[1]}"]
            case = self.case("free_2d", domain=PERIODIC_2D, resolution__precision="double",
                             geometry={"drop": {"box": {"lower": [-0.5, -0.5], "upper": [0.5, 0.5]}}},
                             bodies__water__initial={"velocity": velocity})
            self.sphinx(case, self.folder / name)
            restart = last_restart(self.folder / name)
            found[name] = restart.by_id("water", "position") - restart.time * np.array([u, v])
        difference = found["drift"] - found["rest"]
        difference -= 2 * np.round(difference / 2)  # the box is 2 wide
        print(f"drifting block: {np.abs(difference).max() / SPACING:.1e} spacings off")
        self.assertLessEqual(np.abs(difference).max(), POSITION_ERROR * SPACING)

    def test_drifting_elastic_block(self):
        """It crosses the periodic sides as a whole."""
        found = {}
        for name, (u, v) in {"rest": (0, 0), "drift": (7.3, -5.1)}.items():
            case = {
                "sphinx": 1, "dimension": 2, "units": "none", "resolution": {"spacing": SPACING},
                "domain": PERIODIC_2D,
                "geometry": {"block": {"box": {"lower": [-0.4, -0.2], "upper": [0.4, 0.2]}}},
                "materials": {"rubber": {"type": "saint_venant_kirchhoff", "density": 1,
                                         "youngs_modulus": 100, "poisson_ratio": 0.3}},
                "bodies": {"block": {"kind": "solid", "shape": "block", "material": "rubber", "initial": {
                    "velocity": [f"{u} + 0.2*sin(3*x)*y", f"{v} + 0.2*cos(4*y)*x"]}}},
                "topology": {"block": ["self"]},
                "dynamics": {"correction": {"type": "solid.linear_correction", "body": "block"},
                             "relaxation": {"type": "solid.stress_relaxation", "body": "block"},
                             "neighbors": {"type": "neighbors.update", "bodies": ["block"]}},
                "loop": {"start": ["neighbors", "correction"], "end_time": 0.6, "layer": "elastic",
                         "dt": 0.001,
                         "steps": ["relaxation.first_half", "relaxation.second_half", "neighbors"]},
                "outputs": {"restart": {"type": "restart"}},
            }
            self.sphinx(self.write_case(name, case), self.folder / name)
            restart = last_restart(self.folder / name)
            found[name] = restart.by_id("block", "position") - restart.time * np.array([u, v])
        difference = found["drift"] - found["rest"]
        difference -= 2 * np.round(difference / 2)
        print(f"drifting elastic block: {np.abs(difference).max() / SPACING:.1e} spacings off")
        self.assertLessEqual(np.abs(difference).max(), POSITION_ERROR * SPACING)


if __name__ == "__main__":
    unittest.main()
