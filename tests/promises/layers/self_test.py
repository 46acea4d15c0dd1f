# SPDX-FileCopyrightText: 2026 The sphinx developers
# SPDX-License-Identifier: Apache-2.0
"""Plants violations in small trees and expects scripts/check_layers to name each of them.

usage: self_test.py CHECK_LAYERS
"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CLEAN = {
    "engine/core/types.h": "#include <tbb/parallel_for.h>\n#include <vector>\n",
    "engine/core/log.h": "namespace sphinx {\nnamespace log {\n}  // namespace log\n"
                         "}  // namespace sphinx\n",
    "engine/input/tree/node.h": '#include "core/types.h"\n',
    "engine/input/tree/node.cpp": '#include "input/tree/node.h"\n#include <yaml-cpp/yaml.h>\n',
    "engine/bodies/body.h": '#include "core/types.h"\nnamespace sphinx::bodies {\n'
                            "namespace {\n}  // namespace\n}  // namespace sphinx::bodies\n",
    "engine/neighbors/list.h": '#include "bodies/body.h"\n',
    "engine/dynamics/context.h": "namespace sphinx::dynamics {\nnamespace force {\n"
                                 "}  // namespace force\n}  // namespace sphinx::dynamics\n",
    "engine/dynamics/force/spring.h": "namespace sphinx::dynamics::force {\n"
                                      "}  // namespace sphinx::dynamics::force\n",
    "engine/io/frames/vtu.h": '#include "neighbors/list.h"\nnamespace sphinx::io {\n'
                              "}  // namespace sphinx::io\n",
    "engine/loop/run/layer.h": '#include "core/types.h"\n',
    "engine/case/language/read.h": '#include "input/tree/node.h"\nnamespace sphinx::language {\n'
                                   "}  // namespace sphinx::language\n",
    "app/main.cpp": '#include "case/language/read.h"\n#include <CLI/CLI.hpp>\nnamespace {\n'
                    "using namespace sphinx;\n}  // namespace\n",
}


# What is wrong, the file that is added to the clean tree, its text, and the message.
VIOLATIONS = [
    ("include of a folder further left",
     "engine/core/log.h", '\n#include "input/tree/node.h"\n',
     "engine/core/log.h:2: core/ may not include input/: input/tree/node.h"),
    ("include within a layer",
     "engine/loop/run/output.h", '#include "io/frames/vtu.h"\n',
     "engine/loop/run/output.h:1: loop/ may not include io/: io/frames/vtu.h"),
    ("include within a layer has one direction",
     "engine/bodies/part.h", '#include "neighbors/list.h"\n',
     "engine/bodies/part.h:1: bodies/ may not include neighbors/"),
    ("include of a room further left",
     "engine/io/file/path.h", '#include "io/frames/vtu.h"\n',
     "engine/io/file/path.h:1: io/file may not include io/frames: io/frames/vtu.h"),
    ("room that is not on the map",
     "engine/case/attic/a.h", "",
     "engine/case/attic/a.h: case/ has no room attic"),
    ("file outside of the rooms",
     "engine/case/a.h", "",
     "engine/case/a.h: case/ has no room ."),
    ("namespace of the command line",
     "app/main.cpp", "namespace sphinx {\n}\n",
     "app/main.cpp:1: namespace sphinx, but the folder is no namespace"),
    ("nested namespace in core",
     "engine/core/a.h", "namespace sphinx {\nnamespace hidden {\n}\n}\n",
     "engine/core/a.h:2: namespace sphinx::hidden, but the folder is sphinx"),
    ("directive in a header",
     "engine/io/xml/a.h", "using namespace std;\n",
     "engine/io/xml/a.h:1: using namespace in a header"),
    ("unknown folder",
     "engine/misc/a.h", "",
     "folder misc/ has no place among the layers"),
    ("include that leads nowhere",
     "engine/core/a.h", '#include "types.h"\n',
     "engine/core/a.h:1: types.h is not a file of engine/ or app/"),
]


def check(changes):
    """Exit code and output for the clean tree with these files added or replaced."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in {**CLEAN, **changes}.items():
            path = Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        result = subprocess.run([sys.executable, CHECK_LAYERS, folder], capture_output=True,
                                text=True, check=False)
        return result.returncode, result.stdout + result.stderr


class CheckLayers(unittest.TestCase):
    def expect(self, changes, message):
        code, output = check(changes)
        self.assertIn(message, output)
        self.assertEqual(code, 1)

    def test_clean_tree_passes(self):
        self.assertEqual(check({}), (0, "12 files, no violation\n"))

    def test_violations(self):
        for what, name, text, message in VIOLATIONS:
            with self.subTest(what):
                self.expect({name: text}, message)

    def test_library_of_another_folder(self):
        for include in ("tbb/parallel_for.h", "yaml-cpp/yaml.h", "muParser.h", "nlohmann/json.hpp",
                        "CGAL/Origin.h", "tinyxml2.h", "hdf5.h", "Simbody.h", "CLI/CLI.hpp"):
            with self.subTest(include):
                self.expect({"engine/dynamics/force/a.h": f"#  include <{include}>\n"},
                            f"engine/dynamics/force/a.h:1: includes <{include}>, which only")

    def test_cycle_of_files(self):
        self.expect({"engine/core/a.h": '#include "core/b.h"\n',
                     "engine/core/b.h": '#include "core/c.h"\n',
                     "engine/core/c.h": '#include "core/a.h"\n'},
                    "cycle of includes: core/a.h -> core/b.h -> core/c.h -> core/a.h")

    def test_namespace_of_another_folder(self):
        for name, namespace, wanted in (
                ("core/a.h", "sphinx::input", "sphinx"),
                ("bodies/a.h", "sphinx", "sphinx::bodies"),
                ("bodies/a.h", "sphinx::particles", "sphinx::bodies"),
                ("bodies/a.h", "sphinx::bodies_of_others", "sphinx::bodies"),
                ("io/hdf5/a.cpp", "sphinx::hdf5", "sphinx::io"),
                ("dynamics/a.h", "sphinx::force", "sphinx::dynamics"),
                ("dynamics/force/a.h", "sphinx::dynamics", "sphinx::dynamics::force"),
                ("case/run/a.cpp", "sphinx::model", "sphinx::run"),
                ("case/run/a.cpp", "sphinx::case_::run", "sphinx::run")):
            with self.subTest(name, namespace=namespace):
                self.expect({f"engine/{name}": f"\nnamespace {namespace} {{\n}}\n"},
                            f"engine/{name}:2: namespace {namespace}, but the folder is {wanted}\n")

    def test_namespace_behind_another(self):
        self.expect({"engine/bodies/a.h": "namespace sphinx::bodies {\n"
                                          "}  // namespace sphinx::bodies\n"
                                          "namespace sphinx::io {\n}  // namespace sphinx::io\n"},
                    "engine/bodies/a.h:3: namespace sphinx::io, but the folder is sphinx::bodies")

    def test_tree_without_sources(self):
        with tempfile.TemporaryDirectory() as folder:
            result = subprocess.run([sys.executable, CHECK_LAYERS, folder], capture_output=True,
                                    text=True, check=False)
        self.assertEqual(result.returncode, 1)
        self.assertIn("no sources", result.stdout)


if __name__ == "__main__":
    CHECK_LAYERS = sys.argv.pop(1)
    unittest.main()
