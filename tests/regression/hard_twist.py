# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""A column twisted at 400 rad/s, cases/twisted_column.yaml: until its faces crease (0.043 s) neighbors keep their
order, rows of particles do not zigzag, and the angle of twist converges; afterwards the run ends with exit code 3 and
the place. Why it must crease: engine/dynamics/solid/README.md; --study prints the table there.
"""

import subprocess
import tempfile

import numpy as np

import checks

TWIST = checks.REPOSITORY / "tests/regression/cases/twisted_column.yaml"
HARD = "variables.rate=-400", "variables.poisson_ratio=0.45"
BEFORE_CREASES = 0.04
FRAMES = "outputs.fields.every={time: 0.008}"

# Measured between 8 and 12 rows, 12 and 16: 0.9, 0.4 degrees at the middle of the column, 0.9, 0.4 at its free end.
ANGLE_LIMIT = 1.5
# Measured with 8, 12 and 16 rows: 0.18, 0.16, 0.11 spacings.
ZIGZAG_LIMIT = 0.2


def zigzag(lattice, r, spacing):
    """Largest sixth difference over 64 along a row of particles, in spacings: a row that alternates by +-a has a."""
    rows = np.full((*(lattice.max(axis=0) + 1), 3), np.nan)
    rows[tuple(lattice.T)] = r
    return max(np.abs(np.diff(rows, 6, axis=axis)).max() for axis in range(3)) / 64 / spacing


def angle(R, r, x, spacing):
    """Mean angle by which the cross-section at x has turned, degrees."""
    near = np.abs(R[:, 0] - x) < spacing
    start, now = R[near, 1] + 1j * R[near, 2], r[near, 1] + 1j * r[near, 2]
    return np.degrees(np.angle((now * start.conj()).sum()))


def measure(rows):
    """Largest zigzag over time; angles at 3 m and at the free end, length at the end."""
    run = checks.Run(TWIST, f"variables.across={rows}", *HARD, f"loop.end_time={BEFORE_CREASES}", FRAMES)
    spacing, largest = 1 / rows, 0
    for _, fields in run.frames("column"):
        free = fields["initial_position"][:, 0] > 0
        R, r = fields["initial_position"][free], fields["position"][free]
        lattice = np.round((R - R.min(axis=0)) / spacing).astype(int)
        largest = max(largest, zigzag(lattice, r, spacing))
    return {"zigzag": largest, "middle": angle(R, r, 3, spacing), "end": angle(R, r, 6, spacing),
            "length": r[:, 0].max() + spacing / 2}


def ending(rate, end_time):
    """Exit code of the run, and what it says."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([checks.SPHINX, "run", str(TWIST), "--set", f"variables.rate={rate}", "--set", HARD[1],
                               "--set", f"loop.end_time={end_time}", "--output", folder + "/out", "-j", "1"],
                              capture_output=True, text=True, timeout=checks.SECONDS, check=False)
    return done.returncode, done.stderr + done.stdout


def study():
    for rows in (8, 12, 16, 24):
        found = measure(rows)
        print(f"| {rows} | {found['zigzag']:.2f} | {found['middle']:.1f} | {found['end']:.1f} | {found['length']:.3f} |",
              flush=True)


def main():
    options = checks.arguments(study=study)
    report = checks.Report()
    coarse, fine = (measure(rows) for rows in ((12, 16) if options.long else (8, 12)))
    for place in ("middle", "end"):
        report.check(f"angle at the {place}, difference between two spacings, degrees", coarse[place] - fine[place],
                     -ANGLE_LIMIT, ANGLE_LIMIT)
    for found in (coarse, fine):
        report.check("zigzag, spacings", found["zigzag"], 0, ZIGZAG_LIMIT)
    code, said = ending(-400, 0.1)
    report.check("creased: exit code", code, 3, 3)
    report.check("creased: names the place", "of column at (" in said and "have changed places" in said, 1, 1)
    code, _ = ending(-200, 0.2)
    report.check("twisted at 200 rad/s: exit code", code, 0, 0)
    report.end()


if __name__ == "__main__":
    main()
