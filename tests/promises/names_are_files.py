#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""The name of a method is its file: GROUP.METHOD stands in engine/dynamics/GROUP/METHOD.cpp.

usage: names_are_files.py SPHINX
"""
import pathlib
import subprocess
import sys

DYNAMICS = pathlib.Path(__file__).resolve().parents[2] / "engine/dynamics"


def main():
    said = subprocess.run([sys.argv[1], "list", "dynamics"], capture_output=True, text=True, check=True).stdout
    names = [line.split()[0] for line in said.splitlines()]
    strays = [name for name in names if not (DYNAMICS / (name.replace(".", "/") + ".cpp")).exists()]
    for name in strays:
        print(f"{name}: there is no engine/dynamics/{name.replace('.', '/')}.cpp")
    print(f"{len(names)} methods")
    sys.exit(1 if strays or not names else 0)


main()
