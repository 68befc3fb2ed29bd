# SPDX-License-Identifier: BSD-3-Clause
"""What smurf2urdf makes of MJCF files: known robots, and, where they are, those of which the answers of MuJoCo were
recorded (../shared/imports).

mjcf_import_test.py SMURF2URDF
"""
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ET

SHARED = pathlib.Path(__file__).resolve().parents[2].parent / "shared/imports"
TOOL = str(pathlib.Path(sys.argv[1]).resolve())
LEAST_EQUAL = 0.98

LEG = """<mujoco model="leg">
  <default><default class="hip"><joint damping="2" range="-90 45"/></default></default>
  <worldbody><body name="thigh" pos="0 0 1"><joint name="a" class="hip" axis="1 0 0"/>
    <joint name="b" axis="0 1 0" pos="0 0 .1"/><geom type="capsule" size=".05 .2"/></body></worldbody>
  <actuator><motor joint="a" gear="20" ctrlrange="-1 1"/></actuator></mujoco>
"""


class MjcfTest(unittest.TestCase):
    def run_tool(self, text, *options):
        with tempfile.TemporaryDirectory() as folder:
            path, out = pathlib.Path(folder, "robot.xml"), pathlib.Path(folder, "robot.urdf")
            path.write_text(text, encoding="utf-8")
            result = subprocess.run([TOOL, str(path), "-o", str(out), *options], capture_output=True, text=True,
                                    check=False)
            return result, out.read_text(encoding="utf-8") if out.exists() else None

    def test_leg(self):
        result, text = self.run_tool(LEG)
        self.assertEqual(result.returncode, 0, result.stderr)
        robot = ET.fromstring(text)
        self.assertEqual(robot.get("name"), "leg")
        self.assertEqual([one.get("name") for one in robot.findall("joint")], ["a", "b", "thigh_at"])
        joint = robot.find("joint[@name='a']")
        self.assertEqual(joint.get("type"), "revolute")
        limit = joint.find("limit")
        self.assertAlmostEqual(float(limit.get("lower")), -math.pi / 2, 12)
        self.assertEqual(float(limit.get("effort")), 20)
        self.assertEqual(float(joint.find("dynamics").get("damping")), 2)
        mass = 1000 * (math.pi * 0.05**2 * 0.4 + 4 / 3 * math.pi * 0.05**3)
        self.assertAlmostEqual(float(robot.find("link[@name='thigh']/inertial/mass").get("value")), mass, 9)

    def test_refused(self):
        result, text = self.run_tool(LEG.replace('class="hip" axis', 'class="hp" axis'))
        self.assertNotEqual(result.returncode, 0)
        self.assertIsNone(text)
        self.assertIn("SML9301", result.stderr)
        self.assertIn("robot.xml:3", result.stderr)

    def test_copies_of_copies_of_copies(self):
        bomb = '<replicate count="1000">' * 3 + '<body><geom size="1"/></body>' + "</replicate>" * 3
        result, text = self.run_tool(f"<mujoco><worldbody>{bomb}</worldbody></mujoco>")
        self.assertNotEqual(result.returncode, 0)
        self.assertIsNone(text)
        self.assertIn("SML9303", result.stderr)

    def test_a_mass_that_is_not_known(self):
        """A robot with another mass would be a wrong result at exit code 0."""
        text = LEG.replace("<default><default", '<asset><mesh name="m" file="nowhere.stl"/></asset><default><default')
        text = text.replace('<geom type="capsule" size=".05 .2"/>', '<geom type="mesh" mesh="m"/>')
        result, made = self.run_tool(text)
        self.assertEqual((result.returncode, made), (1, None))
        self.assertIn("SML9302", result.stderr)
        result, made = self.run_tool(text, "--force")
        self.assertEqual(result.returncode, 0)
        self.assertIn("SML9302", result.stderr)
        self.assertIsNone(ET.fromstring(made).find("link[@name='thigh']/inertial"))

    def compare(self, kind, *arguments):
        command = [sys.executable, str(SHARED / "compare.py"), kind, *arguments, "--tool", TOOL + " {file} -o {out}"]
        result = subprocess.run(command, capture_output=True, text=True, check=False, cwd=SHARED)
        counts = next(line for line in result.stdout.splitlines() if line.startswith("{"))
        counts = {name: number for name, number in eval(counts).items() if name.startswith("mjcf")}  # printed by compare.py
        equal = sum(number for name, number in counts.items() if name in ("mjcf same", "mjcf both refuse"))
        self.assertGreaterEqual(equal, LEAST_EQUAL * sum(counts.values()), result.stdout)
        return counts

    @unittest.skipUnless(SHARED.is_dir(), "the recorded answers of MuJoCo are not here")
    def test_recorded_cases(self):
        self.compare("cases", "cases.tsv", "--root", str(SHARED), "--truth", "cases.json.gz")

    @unittest.skipUnless(SHARED.is_dir(), "the recorded answers of MuJoCo are not here")
    def test_recorded_robots(self):
        self.compare("entries", "entries.tsv", "--root", str(SHARED / "corpus"), "--expected", "expected", "--only", "m")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
