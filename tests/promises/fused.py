#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Of the files on which the particles' motion hangs the compiler may fuse products and sums in those
that say so (SPHINX_FUSED), and in no other.

usage: fused.py COMPILE_COMMANDS
"""
import json
import pathlib
import re
import shlex
import sys

ENGINE = pathlib.Path(__file__).resolve().parents[2] / "engine"
FOLDERS = ["geometry", "neighbors", "dynamics"]


def sources_of(path):
    """The file itself, or those that a generated one includes."""
    if ENGINE in path.parents:
        return [path]
    return [ENGINE / name for name in re.findall(r'^#include "(.*\.cpp)"$', path.read_text(), re.M)]


def contraction_of(command):
    """The last word on it, which is the one that counts."""
    words = [word for word in shlex.split(command) if word.startswith("-ffp-contract=")]
    return words[-1].split("=")[1] if words else "nothing"


def main():
    compiled = {}
    for entry in json.loads(pathlib.Path(sys.argv[1]).read_text()):
        for source in sources_of(pathlib.Path(entry["directory"], entry["file"])):
            compiled.setdefault(source, set()).add(contraction_of(entry["command"]))
    sources = [path for folder in FOLDERS for path in (ENGINE / folder).rglob("*.cpp")]
    fused = [path for path in sources if "#ifndef SPHINX_FUSED\n#error" in path.read_text()]
    wrong = 0
    for path in sources:
        wanted = "fast" if path in fused else "off"
        found = compiled.get(path, {"nothing"})
        if found != {wanted}:
            wrong += 1
            print(f"{path.relative_to(ENGINE)}: -ffp-contract is {', '.join(sorted(found))}, not {wanted}")
    print(f"{len(sources)} files, {len(fused)} of them fused")
    sys.exit(1 if wrong or not fused else 0)


main()
