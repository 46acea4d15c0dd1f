# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Every shipped case passes `sphinx check`, and its folder has what a reader needs."""

import subprocess

import checks

report = checks.Report()
for folder in sorted(path for path in checks.CASES.iterdir() if path.is_dir()):
    for case in sorted(folder.glob("*.yaml")):
        done = subprocess.run([checks.SPHINX, "check", str(case)], capture_output=True, text=True,
                              timeout=600, check=False)
        if done.returncode != 0:
            print(done.stderr)
        report.check(f"exit code of check {folder.name}/{case.name}", done.returncode, 0, 0)
    text = (folder / "README.md").read_text() if (folder / "README.md").exists() else ""
    pictures = sorted(folder.glob("*.png"))
    report.check(f"pictures in {folder.name}", len(pictures), 1, 10)
    for picture in pictures:
        report.check(f"{folder.name}/README.md shows {picture.name}", f"({picture.name})" in text, 1, 1)
        report.check(f"bytes of {folder.name}/{picture.name}", picture.stat().st_size, 1, 200_000)
report.end()
