# SPDX-License-Identifier: BSD-3-Clause
"""What the VS Code extension says of itself is what its code, the server and the linter do.

vscode_test.py SMURF-LSP SMURF-LINT
"""
import json
import pathlib
import re
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
EXTENSION = ROOT / "editors/vscode"
LINTER = None


class Extension(unittest.TestCase):
    def setUp(self):
        self.package = json.loads((EXTENSION / "package.json").read_text())
        self.code = (EXTENSION / "src/extension.ts").read_text()

    def test_commands(self):
        said = {one["command"] for one in self.package["contributes"]["commands"]}
        self.assertEqual(said, {f"smurf.{name}" for name in re.findall(r'command\("(\w+)"', self.code)})
        for one in self.package["contributes"]["menus"]["commandPalette"]:
            self.assertIn(one["command"], said)

    def test_settings(self):
        """Each is read, by the extension or by the server, and is in the docs when it is of the server."""
        server = (ROOT / "tools/smurf-lsp/server.cpp").read_text()
        docs = (ROOT / "docs/editors.md").read_text()
        for name in self.package["contributes"]["configuration"]["properties"]:
            own = name.removeprefix("smurf.")
            if own.startswith("server."):
                self.assertIn(f'"{own}"', self.code)
            else:
                self.assertIn("{" + ", ".join(f'"{part}"' for part in own.split(".")) + "}", server)
                self.assertIn(f"`{own}`", docs)

    def test_files(self):
        for one in self.package["contributes"]["languages"]:
            self.assertTrue((EXTENSION / one["configuration"]).exists())
            json.loads((EXTENSION / one["configuration"]).read_text())
        for one in self.package["contributes"]["grammars"]:
            json.loads((EXTENSION / one["path"]).read_text())

    def test_problem_matcher(self):
        pattern = self.package["contributes"]["problemMatchers"][0]["pattern"]
        model = ROOT / "build/fixtures/rules/SML3101-unknown-joint/bad/model.smurf"
        lines = subprocess.run([LINTER, "--format", "concise", "--quiet", model], capture_output=True, text=True,
                               check=False).stdout.splitlines()
        self.assertGreater(len(lines), 0)
        for line in lines:
            match = re.match(pattern["regexp"], line)
            self.assertIsNotNone(match, line)
            self.assertEqual(match[pattern["code"]], "SML3101")
            self.assertTrue(pathlib.Path(match[pattern["file"]]).exists())


if __name__ == "__main__":
    LINTER = sys.argv.pop(2)
    sys.argv.pop(1)
    unittest.main()
