#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""A wrong command line ends with exit code 2, says why, and does nothing.

usage: run_bad_command_lines.py SPHINX
"""
import pathlib
import subprocess
import sys
import tempfile

CASES = pathlib.Path(__file__).resolve().parents[2] / "cases"
CASE = str(CASES / "dam_break_2d" / "case.yaml")

WRONG = {
    "": "A subcommand is required",
    "fly": "error: there is no verb 'fly'; known: run, check, show, list, describe, schema",
    "chekc CASE": "error: there is no verb 'chekc'; did you mean 'check'?",
    "run": "case is required",
    "run nowhere.yaml": "case: File does not exist: nowhere.yaml",
    "run .": "case: File is actually a directory: .",
    "run CASE --fast": "The following argument was not expected: --fast",
    "run CASE CASE": "The following argument was not expected: CASE",
    "run CASE -j 0": "--threads: Value 0 not in range 1 to 4096",
    "run CASE --threads many": "--threads: Value many not in range 1 to 4096",
    "run CASE --resume --overwrite": "--resume excludes --overwrite",
    "run CASE --resume --restart some.xml": "--resume excludes --restart",
    "run CASE --time-limit soon":
        "error: --time-limit is 'soon' but must be a time like 3h, 90min, 45s, 2d or 01:30:00",
    "run CASE --time-limit -3h":
        "error: --time-limit is '-3h' but must be a time like 3h, 90min, 45s, 2d or 01:30:00",
    "run CASE --time-limit inf":
        "error: --time-limit is 'inf' but must be a time like 3h, 90min, 45s, 2d or 01:30:00",
    "run CASE --time-limit 1:75:00":
        "error: --time-limit is '1:75:00' but must be a time like 3h, 90min, 45s, 2d or 01:30:00",
    "run CASE --output EMPTY": "--output: an empty text is none",
    "check CASE --threads 0": "--threads: Value 0 not in range 1 to 4096",
    "run CASE --restart EMPTY": "--restart: an empty text is none",
    "run CASE --time-limit EMPTY": "--time-limit: an empty text is none",
    "run CASE --set include=[other.yaml]":
        "--set:1:1: error: files are included before values are set: write it in the case",
    "run CASE --set": "--set: 1 required PATH=VALUE missing",
    "check": "case is required",
    "check CASE --set loop.end_time":
        "--set:1:1: error: expected path=value, such as loop.end_time=1",
    "show CASE --output out": "The following arguments were not expected: out --output",
    "list colours": "error: there is no kind 'colours'; known: block, shape, kernel, material, "
                    "dynamics, joint, multibody_force, multibody_constraint, output, field",
    "describe": "name is required",
    "describe fluid.presure_relaxation":
        "error: there is nothing called 'fluid.presure_relaxation'; did you mean "
        "'fluid.pressure_relaxation'?",
    "describe colours": "error: there is nothing called 'colours'; 'sphinx list' prints the names",
    "describe viscosty": "error: there is nothing called 'viscosty'; did you mean 'viscosity'?",
    "schema CASE": "The following argument was not expected: CASE",
}


def check(sphinx, line, expected):
    arguments = [{"CASE": CASE, "EMPTY": ""}.get(word, word) for word in line.split()]
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([sphinx, *arguments], cwd=folder, capture_output=True, text=True,
                              timeout=300)
        left = [path.name for path in pathlib.Path(folder).iterdir()]
    said = done.stderr.replace(CASE, "CASE").split("\n")[0]
    if (done.returncode, said, done.stdout, left) == (2, expected, "", []):
        return True
    print(f"sphinx {line}: exit code {done.returncode}, said: {said!r}, expected: {expected!r}, "
          f"stdout: {done.stdout!r}, left behind: {left}")
    return False


def main():
    sphinx = str(pathlib.Path(sys.argv[1]).resolve())
    good = sum(check(sphinx, line, expected) for line, expected in WRONG.items())
    print(f"{good} of {len(WRONG)} wrong command lines are answered as expected")
    sys.exit(0 if good == len(WRONG) else 1)


if __name__ == "__main__":
    main()
