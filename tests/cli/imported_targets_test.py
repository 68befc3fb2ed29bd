# SPDX-License-Identifier: BSD-3-Clause
"""What smurf-lint says of MJCF and SDF for the programs that read them. imported_targets_test.py SMURF-LINT"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

TOOL = str(pathlib.Path(sys.argv[1]).absolute())
# In a URDF, a name with a slash, and a link that is called as its joint, are findings.
MJCF = '''<mujoco model="crate"><worldbody><body name="left/crate" pos="0 0 1"><freejoint name="left/crate"/>
<geom name="box" type="box" size="0.2 0.2 0.1"/><body name="lid"><joint name="lid"/><geom size="0.1"/></body></body>
</worldbody></mujoco>'''
SDF = '''<sdf version="1.9"><model name="cup"><link name="a"><inertial><mass>1</mass></inertial><collision name="c">
<geometry><capsule><radius>0.1</radius><length>0.2</length></capsule></geometry></collision></link></model></sdf>'''


class TargetTest(unittest.TestCase):
    def check(self, name, text, *options):
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, name).write_text(text, encoding="utf-8")
            done = subprocess.run([TOOL, name, "--format", "json", "--min-severity", "info", *options],
                                  capture_output=True, text=True, check=False, cwd=folder)
            report = json.loads(done.stdout)
        self.assumptions = report["summary"].get("assumptions", [])
        verdicts = {name: one["verdict"] for name, one in report.get("targets", {}).items()}
        levels = {one["id"]: one["severity"] for one in report["diagnostics"]}
        return verdicts, levels

    def test_nobody_reads_its_urdf(self):
        _, levels = self.check("crate.xml", MJCF)
        self.assertEqual(levels.get("SML1303"), "info")
        self.assertEqual(set(levels.values()), {"info"}, levels)

    def test_mujoco_reads_it_itself(self):
        verdicts, levels = self.check("crate.xml", MJCF, "--target", "mujoco")
        self.assertEqual(verdicts, {"mujoco": "takes"})
        self.assertEqual(self.assumptions, [])
        self.assertEqual(set(levels.values()), {"info"}, levels)

    def test_another_reads_the_urdf(self):
        verdicts, levels = self.check("crate.xml", MJCF, "--target", "mujoco,gazebo,ros")
        self.assertEqual(verdicts.pop("mujoco"), "takes")
        verdicts.pop("ros")
        self.assertEqual(self.assumptions, ["URDFs that smurf2urdf makes of MJCF files, for gazebo and ros"])
        self.assertEqual(verdicts, {"gazebo": "refuses"})
        self.assertEqual(levels["SML1303"], "error")

    def test_what_mujoco_refuses(self):
        verdicts, _ = self.check("crate.xml", MJCF.replace('size="0.1"', ""), "--target", "mujoco,gazebo")
        self.assertEqual(verdicts, {"mujoco": "refuses", "gazebo": "unknown"})

    def test_missing_mesh(self):
        text = MJCF.replace("<worldbody>", '<asset><mesh file="m.stl"/></asset><worldbody>') \
                   .replace('<geom size="0.1"/>', '<geom type="mesh" mesh="m"/>')
        verdicts, _ = self.check("crate.xml", text, "--target", "mujoco")
        self.assertEqual(verdicts, {"mujoco": "refuses"})

    def test_mesh_of_mujocos_own(self):
        text = MJCF.replace("<worldbody>", '<asset><mesh name="m" builtin="sphere" params="2"/></asset><worldbody>') \
                   .replace('<geom size="0.1"/>', '<geom type="mesh" mesh="m"/>')
        verdicts, levels = self.check("crate.xml", text, "--target", "mujoco")
        self.assertIn("SML9302", levels)
        self.assertEqual(verdicts, {"mujoco": "takes"})

    def test_what_smurf_cannot_say(self):
        text = MJCF.replace('<joint name="lid"/>', '<joint name="lid" type="ball" armature="0.1"/>') \
                   .replace('size="0.1"', 'size="0.1" friction="0.5 0 0" condim="4"')
        _, levels = self.check("crate.xml", text)
        self.assertEqual(levels["SML9304"], "warning")
        done = subprocess.run([TOOL, "-", "--stdin-filename", "crate.xml", "--min-severity", "info"], input=text,
                              capture_output=True, text=True, check=False)
        self.assertIn("so the armature of joint `lid` is lost", done.stdout)
        self.assertIn("so a shape loses torsional and rolling `friction` and `condim`", done.stdout)

    def test_free_bodies_are_where_they_are(self):
        """With all values of a floating joint at zero, all free bodies are at one place."""
        bodies = "".join(f'<body name="{name}" pos="{at} 0 1"><freejoint/><geom type="box" size="0.1 0.1 0.1"/></body>'
                         for name, at in (("one", 0), ("other", 2)))
        _, levels = self.check("crates.xml", f"<mujoco><worldbody>{bodies}</worldbody></mujoco>")
        self.assertNotIn("SML1655", levels)

    def test_gazebo_reads_sdf_itself(self):
        verdicts, levels = self.check("cup.sdf", SDF, "--target", "gazebo")
        self.assertEqual(verdicts, {"gazebo": "takes"})
        self.assertNotIn("error", levels.values(), levels)

    def test_what_sdformat_refuses(self):
        verdicts, _ = self.check("cup.sdf", SDF.replace("<radius>0.1", "<radius>x"), "--target", "gazebo,mujoco")
        self.assertEqual(verdicts, {"gazebo": "refuses", "mujoco": "unknown"})


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
