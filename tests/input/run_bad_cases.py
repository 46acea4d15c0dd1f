#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Every wrong case here must end with exit code 2 and exactly the expected messages; those that
are only doubtful (warn_NAME.yaml) with exit code 0 and exactly the expected warnings.

usage: run_bad_cases.py SPHINX [NAME...]

bad_NAME.yaml is checked and its messages are compared with bad_NAME.expected. A first line
"# arguments: ..." adds arguments. Cases too large to keep are made here.
"""
import difflib
import pathlib
import resource
import signal
import subprocess
import sys
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parent
# None of them may take long, however hostile: seconds that the processor works for it, which do not grow
# with what else runs, and seconds after which nothing is waited for any more.
SECONDS = 5
PATIENCE = 300

GENERATED = {
    "generated_long_line": lambda: "title: " + "x" * 10_000_000 + "\n",
    "generated_long_line_of_brackets": lambda: "title: " + "[" * 90_000 + "\n",
    "generated_large_file": lambda: "# nothing but comments\n" * 400_000,
    "generated_deep_lists": lambda: "title: " + "[" * 1000 + "]" * 1000 + "\n",
    "generated_deep_maps": lambda: "title: " + "{a: " * 1000 + "1" + "}" * 1000 + "\n",
    "generated_deep_blocks": lambda: "".join(" " * k + f"k{k}:\n" for k in range(200)),
    "generated_many_keys": lambda: "".join(f"key_{k}: 1\n" for k in range(20_000)),
    "generated_long_expression": lambda: "variables: {a: " + "1+" * 5000 + "1}\n",
    "generated_deep_parentheses": lambda: "variables: {a: " + "(" * 500 + "1" + ")" * 500 + "}\n",
    "generated_long_dependency": lambda: "variables:\n  a0: 1\n"
    + "".join(f"  a{k}: a{k - 1} + 1\n" for k in range(1, 2000)),
    "generated_bytes": lambda: bytes(range(32, 256)),
    "generated_utf_16": lambda: "sphinx: 2\n".encode("utf-16-le"),
    "generated_null_byte": lambda: "sphinx: 2\n\0\ntitle: none\n",
}


def arguments(path):
    first = path.read_bytes().split(b"\n", 1)[0].decode(errors="replace")
    prefix = "# arguments: "
    return first[len(prefix):].split() if first.startswith(prefix) else []


def run(sphinx, path):
    command = [sphinx, "check", path.name, *arguments(path)]
    done = subprocess.run(command, cwd=path.parent, capture_output=True, text=True, timeout=PATIENCE,
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS)))
    return done.returncode, done.stderr


def check(sphinx, path):
    expected = (FOLDER / path.name).with_suffix(".expected").read_text()
    try:
        code, said = run(sphinx, path)
    except subprocess.TimeoutExpired:
        return f"{path.name}: no answer within {PATIENCE} s"
    if code in (-signal.SIGXCPU, -signal.SIGKILL):
        return f"{path.name}: no answer within {SECONDS} s of work"
    wanted = 2 if path.name.startswith("bad_") else 0
    if code != wanted:
        return f"{path.name}: exit code {code} instead of {wanted}\n{said}"
    if said != expected:
        lines = difflib.unified_diff(expected.splitlines(True), said.splitlines(True), "expected", "said")
        return f"{path.name}:\n" + "".join(lines)
    return ""


def main():
    sphinx = str(pathlib.Path(sys.argv[1]).resolve())
    wanted = sys.argv[2:]
    with tempfile.TemporaryDirectory() as folder:
        for name, make in GENERATED.items():
            made = make()
            content = made.encode() if isinstance(made, str) else made
            pathlib.Path(folder, f"bad_{name}.yaml").write_bytes(content)
        paths = [*sorted(FOLDER.glob("bad_*.yaml")), *sorted(FOLDER.glob("warn_*.yaml")),
                 *sorted(pathlib.Path(folder).iterdir())]
        if wanted:
            paths = [path for path in paths if path.stem.split("_", 1)[1] in wanted]
        failures = [failure for path in paths if (failure := check(sphinx, path))]
    print("\n".join(failures))
    print(f"{len(paths) - len(failures)} of {len(paths)} wrong and doubtful cases are answered as expected")
    sys.exit(1 if failures or not paths else 0)


if __name__ == "__main__":
    main()
