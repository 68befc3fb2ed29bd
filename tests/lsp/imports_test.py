# SPDX-License-Identifier: BSD-3-Clause
"""smurf-lsp on MJCF and SDF, which it recognises by their root element. imports_test.py SMURF-LSP"""
import pathlib
import shutil
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import client  # noqa: E402

TOOL = None
ROBOT = """<mujoco model="lamp">
  <worldbody><body name="base"><joint name="turn" dampng="1"/><geom size="0.1"/></body></worldbody>
</mujoco>
"""
WORLD = """<sdf version="1.9"><world name="hall">
  <model name="box"><link name="a"/><joint name="j" type="fixed"><parent>a</parent><child>b</child></joint></model>
</world></sdf>
"""


class Imports(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="smurf-imports-")).resolve()
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.client = client.Client(TOOL, [self.folder], {})
        self.addCleanup(self.client.end)

    def open(self, name, text):
        path = self.folder / name
        path.write_text(text)
        self.client.open(path, text, "xml")
        return [(one["code"], one["range"]["start"]["line"]) for one in self.client.published(path)]

    def test_robot_of_mujoco(self):
        self.assertIn(("SML9301", 1), self.open("lamp.xml", ROBOT))

    def test_world(self):
        self.assertIn(("SML9311", 1), self.open("hall.world", WORLD))


if __name__ == "__main__":
    TOOL = sys.argv.pop(1)
    unittest.main()
