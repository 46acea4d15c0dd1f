# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""fluid.implicit_viscosity where steps of spacing^2/viscosity would be far too many: start-up and steady flow at
Reynolds number 0.01, pressure against viscosity, honey at rest and on its way, the force on an elastic body.

Closed forms: Morris, Fox & Zhu 1997, doi:10.1006/jcph.1997.5776, (22) and (25); Sangani & Acrivos 1982,
doi:10.1016/0301-9322(82)90029-5; Huppert 1982, doi:10.1017/S0022112082001797. Elsewhere the reference is
fluid.viscous_force with the same steps.
"""

import pathlib
import tempfile

import numpy as np

import channel
import checks

STARTUP_LIMIT = 0.02  # of the largest speed
STEADY_LIMIT = 0.005
DRAG_LIMIT = 0.005
TIMES = (0.1, 0.2, 0.3, 0.5, 1.0)  # in gap^2/viscosity
CREEPING = 100.0                   # viscosity at Reynolds number 0.01

CYLINDER = np.pi * 0.2**2
FORCE = 30.30
FORCE_LIMIT = 0.03
SAME_LIMIT = 0.01  # of both methods, with the same steps

WEIGHT_LIMIT = 0.0015
PRESSURE_LIMIT = 0.015
ENERGY_LIMIT = 7e-5
FRONT_LIMIT = 0.08
ELASTIC_LIMIT = 0.01

STEPS = "steps: [pressure_relaxation.first_half, viscous_force, pressure_relaxation.second_half]"


class Variant:
    """A shipped case with more in it."""

    def __init__(self, case, more):
        self._folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self._folder.name) / "case.yaml"
        self.path.write_text(f"sphinx: 2\ninclude: [{checks.CASES / case}]\n{more}")


def profiles(run, exact):
    """{time in gap^2/viscosity: largest error of a layer's mean velocity}."""
    found = {}
    for time, fields in run.frames("fluid"):
        scaled = time * CREEPING
        for wanted in TIMES:
            if scaled >= wanted - 1e-9 and wanted not in found:
                # channel's series have a viscosity of 0.1.
                found[wanted] = channel.profile_error(fields, exact, scaled / channel.VISCOSITY, channel.SPACING)[0]
    return found


def check_channel(report, name, exact, drag):
    run = checks.Run(f"{name}_2d/creeping.yaml")
    found = profiles(run, exact)
    for time in TIMES:
        limit = STEADY_LIMIT if time == TIMES[-1] else STARTUP_LIMIT
        report.check(f"{name}, profile at {time:g} gap^2/viscosity", found[time], 0, limit)
    last = run.series("drag")["force_x"][-1] / CREEPING
    report.check(f"{name}, drag less that of theory, of it", last / drag - 1, -DRAG_LIMIT, DRAG_LIMIT)


def cylinder_force(case, viscosity, *settings):
    """F/(mu U), mean over the later half of the time."""
    run = checks.Run(f"cylinder_array_2d/{case}.yaml", f"variables.viscosity={viscosity}", *settings)
    drive, drag = run.series("drive"), run.series("drag")
    late = drive["time"] > 0.5 * drive["time"][-1]
    return (drive["applied_x"][late].mean() / (1 - CYLINDER) / viscosity,
            drag["force_x"][late].mean() / drive["applied_x"][late].mean() - 1)


def check_cylinders(report, long):
    force, balance = cylinder_force("implicit", 20)
    report.check("cylinders, force less that of the series, of it", force / FORCE - 1, -FORCE_LIMIT, FORCE_LIMIT)
    report.check("cylinders, drag less the force that drives, of it", balance, -2e-3, 2e-3)
    if not long:
        return
    same = ("variables.sound_speed=200", "loop.end_time=0.1", "loop.dt=4.5e-5")
    found = [cylinder_force(case, 4, *same)[0] for case in ("implicit", "case")]
    report.check("cylinders, force less that of fluid.viscous_force in the same steps, of it", found[0] / found[1] - 1,
                 -SAME_LIMIT, SAME_LIMIT)


def check_rest(report):
    """Honey at rest in a tank."""
    variant = Variant("hydrostatic_tank_2d/case.yaml", f"""
variables: {{viscosity: 1}}
dynamics: {{viscous_force: {{type: fluid.implicit_viscosity, body: water}}}}
loop: {{steps: [density_summation, gravity, {{layer: acoustic, dt: acoustic_dt, {STEPS}}}, neighbors]}}
""")
    run = checks.Run(variant.path)
    energy, force, gauge = run.series("energy"), run.series("force"), run.series("pressure")
    weight = run.series("mass")["mass"][0]  # g = 1
    late = force["time"] > 5
    report.check("tank, kinetic energy / (rho g H^2 L) at the end", energy["kinetic"][-1] / 2, 0, ENERGY_LIMIT)
    report.check("tank, force on it less the weight, of it", -force["force_y"][late].mean() / weight - 1,
                 -WEIGHT_LIMIT, WEIGHT_LIMIT)
    names = [name for name in gauge if name.startswith("pressure_")]
    heights = np.linspace(0.04, 0.92, len(names))
    pressure = np.array([gauge[name][late].mean() for name in names])
    report.check("tank, rms error of the pressure / (rho g H)", np.sqrt(np.mean((pressure - (1 - heights))**2)), 0,
                 PRESSURE_LIMIT)


def check_honey(report):
    """The front against that of a viscous gravity current, 1.411 (g q^3 / (3 nu))^(1/5) t^(1/5), q the area of a half."""
    front = checks.Run("honey_2d/case.yaml").series("front")
    late = front["time"] > 1
    theory = 1.411 * (9.81 * 2e-4**3 / (3 * 10 / 1400))**0.2 * front["time"][late]**0.2
    off = front["front_position"][late] / theory - 1
    report.check("honey, front less that of theory, of it, at worst", off[np.abs(off).argmax()], -FRONT_LIMIT, FRONT_LIMIT)


def check_elastic(report):
    """The drag on an elastic bed is that of fluid.viscous_force."""
    case = "shear_driven_elastic_layer_2d/case.yaml"
    settings = ("variables.spacing=gap/10", "loop.end_time=2", "variables.viscosity=5")
    variant = Variant(case, """
dynamics:
  none: {type: force.gravity, body: oil, acceleration: [0, 0]}
  viscous_force: {type: fluid.implicit_viscosity, body: oil}
loop:
  steps:
    - density_summation
    - none
    - slide
    - turn_normals
    - layer: acoustic
      dt: acoustic_dt
      steps:
        - pressure_relaxation.first_half
        - viscous_force
        - drag
        - load
        - average.begin
        - layer: elastic
          dt: elastic_dt
          steps: [shear_left, shear_right, settle, relaxation.first_half, clamp, relaxation.second_half]
        - average.end
        - pressure_relaxation.second_half
    - neighbors
""")
    found = [checks.Run(path, *settings).series("force")["force_x"][-1] for path in (variant.path, case)]
    report.check("elastic bed, drag less that of fluid.viscous_force, of it", found[0] / found[1] - 1,
                 -ELASTIC_LIMIT, ELASTIC_LIMIT)


def main():
    options = checks.arguments()
    report = checks.Report()
    if options.long:
        check_honey(report)
    else:
        check_channel(report, "poiseuille", channel.poiseuille, 6.4)
        check_channel(report, "couette", channel.couette, -0.8)
        check_rest(report)
        check_elastic(report)
    check_cylinders(report, options.long)
    report.end()


if __name__ == "__main__":
    main()
