# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Free beam whose ends roll up, meet and slide on the beam: what contact with itself has to keep, and that no part of the
beam goes through another. With --study the table of the README."""

import numpy as np

import checks

CASE = "self_contact_beam_2d"
THICKNESS = 0.01


def nearest(fields, spacing):
    """Least distance of two particles of the surface that lay more than a thickness apart at the start, in spacings."""
    start = fields["position"] - fields["displacement"]
    outer = np.abs(start[:, 1]) > THICKNESS / 2 - spacing
    now, start = fields["position"][outer, :2], start[outer, :2]
    distance, apart = (np.linalg.norm(x[:, None] - x[None], axis=2) for x in (now, start))
    return distance[apart > THICKNESS].min() / spacing


def measure(rows, mirrored=False):
    settings = [f"variables.spacing=thickness/{rows}",
                "outputs.frames={type: vtu, every: {time: 0.001}, bodies: {beam: [displacement, contact_pressure]}}"]
    if mirrored:
        settings.append("variables.left=1")
        settings.append("variables.right=0.8")
    run = checks.Run(f"{CASE}/case.yaml", *settings)
    momentum, turning, energy = (run.series(name) for name in ("momentum", "turning", "energy"))
    spacing = THICKNESS / rows
    frames = [fields for _, fields in run.frames("beam")]
    mass = 1000 * 0.2 * THICKNESS
    start = mass * np.sqrt(2 * energy["kinetic"][0] / mass)  # at least sum m abs(v)
    change = max(np.abs(momentum[f"momentum_{c}"] - momentum[f"momentum_{c}"][0]).max() for c in "xy")
    touched = [fields["contact_pressure"].max() > 0 for fields in frames]
    total = energy["total"]
    return {"momentum": change / start, "turning": np.ptp(turning["angular_momentum"]) / abs(turning["angular_momentum"][0]),
            "rise": (total.max() - total[0]) / total[0], "lost": 1 - total[-1] / total[0], "stored": 1 - total.min() / total[0],
            "nearest": min(nearest(fields, spacing) for fields in frames), "touched": sum(touched),
            "end": frames[-1]["position"], "start": frames[-1]["position"] - frames[-1]["displacement"]}


def mirrors(rows):
    """Largest difference of the end of the mirrored beam from the mirrored end, in spacings."""
    plain, mirrored = measure(rows), measure(rows, mirrored=True)
    # In the order of their places at the start, rounded.
    def order(places):
        return np.lexsort(np.round(places / (0.1 * THICKNESS / rows)).T)

    image, of = order(plain["start"] * [-1, 1, 1]), order(mirrored["start"])
    return np.abs(mirrored["end"][of] - plain["end"][image] * [-1, 1, 1]).max() / (THICKNESS / rows)


def study():
    for rows in (4, 8, 16):
        found = measure(rows)
        print(f"| {rows} | {found['momentum']:.0e} | {found['turning']:.0e} | {found['rise']:.0e} | {found['lost']:.0e} | {found['stored']:.0e} | "
              f"{found['nearest']:.2f} | {found['touched']} | {mirrors(rows):.0e} |", flush=True)


def main():
    options = checks.arguments(study=study)
    report = checks.Report()
    for rows in (4, 8, 16) if options.long else (4,):
        found = measure(rows)
        what = f"{rows} spacings thick"
        report.check(f"{what}: frames in which it touches itself", found["touched"], 2, 100)
        report.check(f"{what}: change of momentum, of sum m v", found["momentum"], 0, 1e-10)
        report.check(f"{what}: change of angular momentum, of it", found["turning"], 0, 1e-10)
        report.check(f"{what}: rise of the energy, of it", found["rise"], 0, 1e-4)
        # That of the layer of contact is not counted while it is pressed.
        report.check(f"{what}: energy lost in the end, of it", found["lost"], -1e-4, 0.005, "measured 1e-5")
        report.check(f"{what}: nearest particles of parts that meet, in spacings", found["nearest"], 0.5, 2)
        report.check(f"{what}: mirrored start, less the mirrored end, in spacings", mirrors(rows), 0, 1e-9)
    report.end()


main()
