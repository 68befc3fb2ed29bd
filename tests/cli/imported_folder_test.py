# SPDX-License-Identifier: BSD-3-Clause
"""MJCF and SDF in a folder that smurf-lint searches. imported_folder_test.py SMURF-LINT"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

TOOL = str(pathlib.Path(sys.argv[1]).absolute())
ROBOT = '<mujoco model="lamp"><include file="parts/arm.xml"/><worldbody><body name="base"><joint name="turn"/>' \
        '<geom size="0.1"/></body></worldbody></mujoco>'
# Alone, it would be a robot without its class.
PART = '<mujoco><worldbody><body name="arm" childclass="gone"><geom size="0.1"/></body></worldbody></mujoco>'
CLASSES = '<mujocoinclude><default><default class="gone"/></default></mujocoinclude>'
MODEL = '<sdf version="1.9"><model name="cup"><link name="a"><inertial><mass>x</mass></inertial></link></model></sdf>'
WORLD = '<sdf version="1.9"><world name="w"><include><uri>../cup/model.sdf</uri></include></world></sdf>'


class FolderTest(unittest.TestCase):
    def check(self, files):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files.items():
                pathlib.Path(folder, name).parent.mkdir(parents=True, exist_ok=True)
                pathlib.Path(folder, name).write_text(text, encoding="utf-8")
            done = subprocess.run([TOOL, ".", "--format", "json"], capture_output=True, text=True, check=False, cwd=folder)
            return json.loads(done.stdout), done.stderr

    def test_by_the_root_element(self):
        report, _ = self.check({"lamp.xml": ROBOT.replace('<include file="parts/arm.xml"/>', ""), "notes.xml": "<notes/>",
                                "cup/model.sdf": MODEL})
        self.assertEqual([one["file"] for one in report["diagnostics"] if one["severity"] == "error"], ["cup/model.sdf"])
        self.assertEqual(report["summary"]["files"], 2)

    def test_parts_are_not_robots(self):
        report, _ = self.check({"lamp.xml": ROBOT.replace("<include", '<include file="classes.xml"/><include'),
                                "parts/arm.xml": PART, "classes.xml": CLASSES})
        self.assertEqual([one for one in report["diagnostics"] if one["severity"] == "error"], [])

    def test_world_and_its_model(self):
        """One fault in a file that is checked alone and in a world is one finding."""
        report, _ = self.check({"cup/model.sdf": MODEL, "worlds/w.world": WORLD})
        errors = [one["file"] for one in report["diagnostics"] if one["severity"] == "error"]
        self.assertEqual(errors, ["cup/model.sdf"])

    def test_losses_are_infos(self):
        """Whoever has a folder checked has not asked for a URDF; whoever names the file may want one."""
        lossy = MODEL.replace("<mass>x</mass>", "<mass>1</mass>").replace("</link>", '<light name="l" type="point"/></link>')
        report, _ = self.check({"cup/model.sdf": lossy})
        self.assertEqual([one["severity"] for one in report["diagnostics"] if one["id"] == "SML9304"], ["info"])
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "model.sdf").write_text(lossy, encoding="utf-8")
            done = subprocess.run([TOOL, "model.sdf", "--format", "concise"], capture_output=True, text=True, check=False,
                                  cwd=folder)
            self.assertIn("warning[SML9304]", done.stdout)

    def test_nothing_of_them(self):
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "notes.xml").write_text("<notes/>", encoding="utf-8")
            done = subprocess.run([TOOL, "."], capture_output=True, text=True, check=False, cwd=folder)
            self.assertIn("no .smurf", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
