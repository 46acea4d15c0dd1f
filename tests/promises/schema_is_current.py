#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""The committed schema and reference page are those of the program, and every case passes it.

usage: schema_is_current.py SPHINX
"""
import json
import pathlib
import subprocess
import sys

import jsonschema
import yaml

ROOT = pathlib.Path(__file__).resolve().parents[2]


def said(sphinx, *arguments):
    return subprocess.run([sphinx, *arguments], capture_output=True, text=True, check=True).stdout


def main():
    sphinx = sys.argv[1]
    failures = []
    for name, arguments in (("case.schema.json", ["schema"]), ("reference.md", ["schema", "--markdown"])):
        if (ROOT / "schemas" / name).read_text() != said(sphinx, *arguments):
            failures.append(f"schemas/{name} is stale: sphinx {' '.join(arguments)} > schemas/{name}")
    schema = json.loads(said(sphinx, "schema"))
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    cases = sorted(ROOT.glob("cases/*/*.yaml"))
    for case in cases:
        written = yaml.safe_load(case.read_text())
        resolved = yaml.safe_load(said(sphinx, "show", str(case)))
        for document, what in ((written, "as written"), (resolved, "resolved")):
            for error in validator.iter_errors(document):
                place = ".".join(map(str, error.absolute_path))
                failures.append(f"{case.relative_to(ROOT)}, {what}: {place}: {error.message}")
    print("\n".join(failures) if failures else f"{len(cases)} cases pass the schema")
    sys.exit(1 if failures or not cases else 0)


if __name__ == "__main__":
    main()
