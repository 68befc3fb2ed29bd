# SPDX-License-Identifier: BSD-3-Clause
"""What smurf2urdf makes of SDF files: known robots, and, where they are, those of which the answers of libsdformat were
recorded (../shared/imports).

sdf_import_test.py SMURF2URDF
"""
import math
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree as ET

SHARED = pathlib.Path(__file__).resolve().parents[2].parent / "shared/imports"
TOOL = str(pathlib.Path(sys.argv[1]).resolve())
LEAST_EQUAL = 0.98

ARM = """<?xml version="1.0"?>
<sdf version="{version}"><model name="arm">
  <link name="base"><pose>0 0 1 0 0 0</pose><inertial><mass>2</mass><inertia><ixx>.1</ixx><iyy>.1</iyy><izz>.1</izz></inertia></inertial></link>
  <link name="tip"><pose>0 1 1 0 0 1.5707963267948966</pose><inertial><mass>3</mass></inertial></link>
  <joint name="j" type="{type}"><parent>base</parent><child>tip</child>{pose}
    <axis><xyz>1 0 0</xyz><limit><lower>-1</lower><upper>2</upper><effort>5</effort></limit><dynamics><damping>.5</damping></dynamics></axis></joint>
</model></sdf>
"""


def arm(version="1.9", kind="revolute", pose=""):
    return ARM.format(version=version, type=kind, pose=pose)


class SdfTest(unittest.TestCase):
    def run_tool(self, text, *options, files=None, name="robot.sdf"):
        with tempfile.TemporaryDirectory() as folder:
            path, out = pathlib.Path(folder, name), pathlib.Path(folder, "robot.urdf")
            for other, content in (files or {}).items():
                pathlib.Path(folder, other).parent.mkdir(parents=True, exist_ok=True)
                pathlib.Path(folder, other).write_text(content, encoding="utf-8")
            path.write_text(text, encoding="utf-8")
            result = subprocess.run([TOOL, str(path), "-o", str(out), *options], capture_output=True, text=True,
                                    check=False)
            return result, ET.parse(out).getroot() if out.exists() else None

    def axis(self, version):
        result, robot = self.run_tool(arm(version))
        self.assertEqual(result.returncode, 0, result.stderr)
        return [float(one) for one in robot.find("joint/axis").get("xyz").split()]

    def test_arm(self):
        result, robot = self.run_tool(arm())
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(robot.get("name"), "arm")
        self.assertEqual([one.get("name") for one in robot.findall("link")], ["base", "tip"])
        joint = robot.find("joint")
        self.assertEqual(joint.get("type"), "revolute")
        self.assertEqual(joint.find("origin").get("xyz"), "0 1 0")
        self.assertAlmostEqual(float(joint.find("origin").get("rpy").split()[2]), math.pi / 2, 12)
        self.assertEqual(joint.find("limit").get("effort"), "5")
        self.assertEqual(joint.find("dynamics").get("damping"), "0.5")
        self.assertEqual(robot.find("link[@name='tip']/inertial/inertia").get("ixx"), "1")

    def test_axis_of_versions(self):
        for got, want in zip(self.axis("1.4"), [0, -1, 0]):  # in the frame of the model
            self.assertAlmostEqual(got, want, 12)
        self.assertEqual(self.axis("1.5"), [1, 0, 0])

    def test_joint_beside_its_child(self):
        _, robot = self.run_tool(arm(pose="<pose>0 0 .5 0 0 0</pose>"))
        self.assertEqual([one.get("name") for one in robot.findall("joint")], ["j", "tip_at"])
        self.assertEqual(robot.find("joint[@name='tip_at']/origin").get("xyz"), "0 0 -0.5")

    def test_joints_with_several_axes(self):
        _, robot = self.run_tool(arm(kind="ball"))
        self.assertEqual([one.get("name") for one in robot.findall("joint")], ["j_x", "j_y", "j_z"])
        _, robot = self.run_tool(arm(kind="universal"))
        self.assertEqual([one.get("name") for one in robot.findall("joint")], ["j", "j_2"])

    def test_refused(self):
        for before, after, what in (("<child>tip", "<child>tp", "`tp`"), ("1 0 0</xyz>", "0 0 0</xyz>", "axis"),
                                    ("0 0 1 0 0 0", "0 0 1 0 0", "pose"), ('name="tip"', 'name="base"', "second"),
                                    ("revolute", "hinge", "`hinge`"), ("<mass>3", "<mass>x", "number"),
                                    ("</link>", '<visual name="world"/></link>', "reserves")):
            result, robot = self.run_tool(arm().replace(before, after, 1))
            self.assertNotEqual(result.returncode, 0, what)
            self.assertIsNone(robot)
            self.assertIn("SML9311", result.stderr)
            self.assertIn("robot.sdf:", result.stderr)
            self.assertIn(what, result.stderr)

    def test_include(self):
        text = '<sdf version="1.9"><model name="m"><link name="a"/><include><uri>model://arm</uri><name>left</name>' \
               '<pose>1 0 0 0 0 0</pose></include><joint name="f" type="fixed"><parent>a</parent>' \
               '<child>left::base</child></joint></model></sdf>'
        files = {"models/arm/model.sdf": arm("1.6"), "models/arm/model.config":
                 '<?xml version="1.0"?><model><name>arm</name><sdf version="1.6">model.sdf</sdf></model>'}
        result, robot = self.run_tool(text, files=files)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("left::tip", [one.get("name") for one in robot.findall("link")])
        self.assertEqual(robot.find("joint[@name='f']/origin").get("xyz"), "1 0 1")
        result, _ = self.run_tool(text)
        self.assertNotEqual(result.returncode, 0)
        self.assertIn("SML9312", result.stderr)

    def test_merged_model(self):
        text = '<sdf version="1.9"><model name="m"><include merge="true"><uri>arm.sdf</uri><pose>1 0 0 0 0 0</pose></include>' \
               '<link name="tool"><pose relative_to="tip">0 0 2 0 0 0</pose></link><joint name="f" type="fixed">' \
               '<parent>tip</parent><child>tool</child></joint></model></sdf>'
        result, robot = self.run_tool(text, files={"arm.sdf": arm()})
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual({one.get("name") for one in robot.findall("link")}, {"base", "tip", "tool"})
        self.assertEqual(robot.find("joint[@name='f']/origin").get("xyz"), "0 0 2")

    def test_prefix_that_nothing_declares(self):
        sensor = '<sensor name="s" type="custom" gz:type="flow"><gz:flow>1</gz:flow></sensor></link>'
        result, robot = self.run_tool(arm().replace("</link>", sensor, 1))
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(robot.find("gazebo").get("reference"), "base")

    def test_parts_that_hang_on_nothing(self):
        text = '<sdf version="1.9"><model name="m">{}<link name="a"><pose>0 0 1 0 0 0</pose></link><link name="b"/></model></sdf>'
        _, robot = self.run_tool(text.format(""))
        self.assertEqual([one.get("type") for one in robot.findall("joint")], ["floating"] * 2)
        _, robot = self.run_tool(text.format("<static>true</static>"))
        self.assertEqual([one.get("type") for one in robot.findall("joint")], ["fixed"] * 2)

    def test_model_that_includes_itself(self):
        text = '<sdf version="1.9"><model name="m"><link name="a"/><include><uri>robot.sdf</uri></include></model></sdf>'
        begin = time.monotonic()
        result, robot = self.run_tool(text)
        self.assertLess(time.monotonic() - begin, 20)  # 2 s, on a machine that does nothing else
        self.assertNotEqual(result.returncode, 0)
        self.assertIsNone(robot)
        self.assertIn("includes itself", result.stderr)

    def test_twenty_levels_of_two_includes(self):
        level = '<sdf version="1.9"><model name="m"><link name="a"/>' \
                '<include><uri>{0}.sdf</uri><name>x</name></include><include><uri>{0}.sdf</uri><name>y</name></include></model></sdf>'
        files = {f"{i}.sdf": level.format(i + 1) for i in range(20)}
        files["20.sdf"] = '<sdf version="1.9"><model name="m"><link name="a"/></model></sdf>'
        begin = time.monotonic()
        result, robot = self.run_tool(level.format(0), files=files)
        self.assertLess(time.monotonic() - begin, 20)
        self.assertNotEqual(result.returncode, 0)
        self.assertIsNone(robot)
        self.assertIn("SML9313", result.stderr)

    def test_world(self):
        world = '<sdf version="1.9"><world name="w">{}{}</world></sdf>'
        one = arm().split("\n", 1)[1].split(">", 1)[1].rsplit("</sdf>", 1)[0]
        result, robot = self.run_tool(world.format(one, one.replace('"arm"', '"other"')), name="w.world")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual([one.get("name") for one in robot.findall("link")],
                         ["world", "arm::base", "arm::tip", "other::base", "other::tip"])

    def compare(self, kind, *arguments):
        command = [sys.executable, str(SHARED / "compare.py"), kind, *arguments, "--tool", TOOL + " {file} -o {out}"]
        result = subprocess.run(command, capture_output=True, text=True, check=False, cwd=SHARED)
        counts = next(line for line in result.stdout.splitlines() if line.startswith("{"))
        counts = {name: number for name, number in eval(counts).items() if name.startswith("sdf")}  # printed by compare.py
        equal = sum(number for name, number in counts.items() if name.startswith(("sdf same", "sdf both refuse")))
        self.assertGreaterEqual(equal, LEAST_EQUAL * sum(counts.values()), result.stdout)

    @unittest.skipUnless(SHARED.is_dir(), "the recorded answers of libsdformat are not here")
    def test_recorded_cases(self):
        rows = (SHARED / "cases.tsv").read_text(encoding="utf-8").splitlines(keepends=True)
        with tempfile.NamedTemporaryFile("w", suffix=".tsv", encoding="utf-8") as only:
            only.writelines([rows[0]] + [row for row in rows if row.split("\t")[1:2] == ["sdf"]])
            only.flush()
            self.compare("cases", only.name, "--root", str(SHARED), "--truth", "cases.json.gz")

    @unittest.skipUnless(SHARED.is_dir(), "the recorded answers of libsdformat are not here")
    def test_recorded_robots(self):
        self.compare("entries", "entries.tsv", "--root", str(SHARED / "corpus"), "--expected", "expected", "--only", "s")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
