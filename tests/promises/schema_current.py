#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""The schema and the reference page are those of the program, and every shipped case passes the
schema in an independent validator.

usage: schema_current.py SPHINX PROJECT
"""
import json
import pathlib
import subprocess
import sys

import jsonschema
import yaml

sphinx, project = sys.argv[1], pathlib.Path(sys.argv[2])
failures = []


def printed(*arguments):
    return subprocess.run([sphinx, *arguments], check=True, capture_output=True, text=True).stdout


for name, arguments in [
    ("schemas/case.schema.json", ["schema"]),
    ("schemas/reference.md", ["schema", "--markdown"]),
]:
    if (project / name).read_text() != printed(*arguments):
        failures.append(f"{name} is stale: sphinx {' '.join(arguments)} > {name}")

schema = json.loads(printed("schema"))
jsonschema.Draft7Validator.check_schema(schema)
validator = jsonschema.Draft7Validator(schema)
cases = sorted(project.glob("cases/*/*.yaml"))
if not cases:
    failures.append("no shipped cases found")
for case in cases:
    for error in validator.iter_errors(yaml.safe_load(case.read_text())):
        path = ".".join(str(key) for key in error.absolute_path)
        failures.append(f"{case.relative_to(project)}: {path}: {error.message[:200]}")

# A wrong case must not pass: the validator would otherwise prove nothing.
wrong = yaml.safe_load((project / "cases/dam_break_2d/case.yaml").read_text())
wrong["resolution"]["spacing_typo"] = 1
if validator.is_valid(wrong):
    failures.append("an unknown key passes the schema")

print("\n".join(failures) or f"{len(cases)} cases pass the schema")
sys.exit(1 if failures else 0)
