# SPDX-License-Identifier: BSD-3-Clause
"""What MuJoCo refuses in sections of MJCF is an error here, and what it reads is none. mjcf_refusals_test.py SMURF_LINT

Each row was run with MuJoCo 4.0.0: it refuses the first text, and loads the second.
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
from refusal_rows import RefusalRows  # noqa: E402

TOOL = pathlib.Path(sys.argv.pop(1)).resolve()
MODEL = """<mujoco><compiler/><option/><asset/><worldbody><body name="b"><joint name="j"/><geom name="g" size="1"/><site name="s"/>
</body></worldbody><contact/><equality/><tendon/><actuator/><sensor/></mujoco>"""
ROWS = [  # the place, what is refused and why, what loads
    ("contact", '<exclude body1="b"/>', "has no `body2`", '<exclude body1="b" body2="world"/>'),
    ("sensor", "<jointpos/>", "has no `joint`", '<jointpos joint="j"/>'),
    ("sensor", '<framepos objtype="body"/>', "needs `objtype` and `objname`", '<framepos objtype="body" objname="b"/>'),
    ("sensor", '<framepos objtype="bodies" objname="b"/>', "no value of `objtype`", '<framepos objtype="xbody" objname="b"/>'),
    ("sensor", "<rangefinder/>", "needs `site`, or `camera`", '<rangefinder site="s"/>'),
    ("equality", '<connect body1="b"/>', "needs `site1` and `site2`, or `body1` and `anchor`",
     '<connect body1="b" anchor="0 0 0"/>'),
    ("equality", '<weld body1="b" relpose="0 0 0"/>', "has 3 of 7 numbers", '<weld body1="b" relpose="0 0 0 1 0 0 0"/>'),
    ("tendon", '<fixed limited="true"><joint joint="j" coef="1"/></fixed>', "`range` is not set",
     '<fixed limited="true" range="0 1"><joint joint="j" coef="1"/></fixed>'),
    ("actuator", '<motor joint="j" ctrllimited="true" ctrlrange="1 0"/>', "does not rise", '<motor joint="j" ctrlrange="1 0"/>'),
    ("actuator", '<motor joint="j" forcelimited="true"/>', "`forcerange` is not set",
     '<motor joint="j" forcelimited="true" forcerange="-1 1"/>'),
    ("actuator", '<motor joint="j" class="c"/>', "there is no class `c`", '<motor joint="j" class="main"/>'),
    ("asset", '<texture type="2d" builtin="flat" width="1"/>', "has no name", '<texture type="skybox" builtin="flat" width="1" height="6"/>'),
    ("asset", '<texture name="t" type="2d" builtin="flat" width="0" height="1"/>', "width of a built-in texture is not positive",
     '<texture name="t" type="2d" builtin="flat" width="1" height="1"/>'),
    ("asset", '<material name="m" texture="t"/>', "there is no texture `t`", '<material name="m"/>'),
    ("asset", '<mesh name="m"/>', "has no triangles", '<mesh name="m" vertex="0 0 0 1 0 0 0 1 0 0 0 1"/>'),
    ("asset", '<material name="m"/><material name="m"/>', "there is another material", '<material name="m"/><material name="n"/>'),
    ("asset", '<mesh file="a/x.stl"/><mesh file="b/x.stl"/>', "there is another mesh", '<material name="m"/>'),
    ("contact", '<exclude name="a" body1="b" body2="world"/><exclude name="a" body1="b" body2="world"/>', "there is another exclude",
     '<exclude name="a" body1="b" body2="world"/>'),
    ("option", 'gravity="0 0 1e999"', "is not a number", 'gravity="0 0 1e-999"'),
    ("option", 'gravity="0 0 0x"', "is not a number", 'gravity="0 0 0x1"'),
    ("option", 'iterations="1.5"', "is not an integer", 'iterations="15"'),
    ("option", 'iterations="9999999999"', "is too large", 'iterations="+15"'),
    ("option", 'gravity="0 0"', "has 2 of 3 numbers", 'gravity="0 0 -0x1p3"'),
    ("compiler", 'autolimits="yes"', "no value of `autolimits`", 'autolimits="false"'),
    ('geom name="g"', 'hfield="h"', "there is no hfield `h`", 'hfield=""'),
    ('body name="b"', "><camera target=\"q\"/", "there is no body `q`", "><camera target=\"b\"/"),
    ('geom name="g"', 'mass="1 2"', "more than 1 number", 'mass="nan"'),
    ('geom name="g"', 'condim="2"', "`condim` is 1, 3, 4 or 6", 'condim="6"'),
    ('site name="s"', 'size="0"', "a size of the site is not positive", 'size="1 0 0"'),
    ('site name="s"', 'size="-1"', "a size of the site is not positive", 'size="nan"'),
]


class Refusals(RefusalRows, unittest.TestCase):
    ROWS = ROWS

    def errors(self, place, text):
        whole = f"<{place}>{text}</{place}>" if text.startswith("<") else f"<{place} {text}"
        old = f"<{place}/>" if text.startswith("<") else f"<{place}"
        self.assertEqual(MODEL.count(old), 1)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "robot.xml")
            file.write_text(MODEL.replace(old, whole))
            done = subprocess.run([TOOL, "--format", "json", file], capture_output=True, text=True)
        return [one["message"] for one in json.loads(done.stdout)["diagnostics"] if one["severity"] == "error"]

    def test_names_in_a_file_that_is_not_there(self):
        """The missing file is the cause, and no name in it is a fault of its own."""
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "robot.xml")
            file.write_text('<mujoco><default><default class="c"/></default><include file="nothing.xml"/><sensor>'
                            '<jointpos joint="j"/></sensor><keyframe><key qpos="1 2"/></keyframe></mujoco>')
            done = subprocess.run([TOOL, "--format", "json", file], capture_output=True, text=True)
        found = [one["message"] for one in json.loads(done.stdout)["diagnostics"] if one["severity"] != "info"]
        self.assertEqual(len(found), 1, found)
        self.assertIn("cannot read", found[0])

    def test_as_mujoco(self):
        try:
            import mujoco
        except ImportError:
            self.skipTest("there is no module mujoco")
        for place, *texts in ((row[0], row[1], row[3]) for row in ROWS):
            for text, loads in zip(texts, (False, True)):
                whole = f"<{place}>{text}</{place}>" if text.startswith("<") else f"<{place} {text}"
                old = f"<{place}/>" if text.startswith("<") else f"<{place}"
                with self.subTest(text):
                    try:
                        mujoco.MjModel.from_xml_string(MODEL.replace(old, whole))
                        self.assertTrue(loads)
                    except ValueError as error:
                        self.assertFalse(loads, error)


unittest.main()
