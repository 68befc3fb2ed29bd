# SPDX-License-Identifier: BSD-3-Clause
"""Contact sensors that find their collisions in Gazebo still do after every conversion.

libsdformat converts each URDF, or reads our SDF; every name in a contact sensor has to be that of a collision of
the same link, and of the same shape as for the source.

Usage: contact_sensors_test.py URDF2SMURF SMURF2URDF SMURFS-FLATTEN
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

TOOLS = {}
INERTIAL = ('<inertial><mass value="1"/><inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/>'
            "</inertial>")


def shape(size, name=""):
    return (f'<collision{name and f" name={chr(34)}{name}{chr(34)}"}><geometry><box size="{size} 0.01 0.01"/>'
            "</geometry></collision>")


def robot(collisions, sensors, joint="revolute", inertial=INERTIAL, more=""):
    """A palm with one shape of 0.9 m and a finger."""
    limit = '<limit lower="-1" upper="1" effort="1" velocity="1"/>' if joint == "revolute" else ""
    return (f'<robot name="hand"><link name="palm">{INERTIAL}{shape(0.9)}</link>'
            f'<link name="finger">{inertial}{collisions}</link>'
            f'<joint name="knuckle" type="{joint}"><parent link="palm"/><child link="finger"/>'
            f'<origin xyz="0 0 0.1" rpy="0.1 0.2 0.3"/><axis xyz="0 1 0"/>{limit}</joint>{more}'
            + "".join(f'<gazebo reference="{link}"><sensor name="{name}" type="contact"><contact>'
                      + "".join(f"<collision>{one}</collision>" for one in names.split())
                      + "</contact></sensor></gazebo>" for link, name, names in sensors) + "</robot>\n")


LUMP = "palm_fixed_joint_lump__"
ROBOTS = {
    "plain": robot(shape(0.1), [("finger", "touch", "finger_collision")]),
    "named": robot(shape(0.1, "pad"), [("finger", "touch", "finger_fixed_joint_lump__pad_collision")]),
    "own name": robot(shape(0.1, "finger_pad"), [("finger", "touch", "finger_pad_collision")]),
    "two": robot(shape(0.1) + shape(0.2), [("finger", "touch", "finger_collision"),
                                           ("finger", "again", "finger_collision_1")]),
    "both": robot(shape(0.1) + shape(0.2, "pad"),
                  [("finger", "touch", "finger_collision finger_fixed_joint_lump__pad_collision_1")]),
    "merged": robot(shape(0.1), [("finger", "touch", LUMP + "finger_collision_1")], "fixed"),
    "merged and named": robot(shape(0.1, "pad"), [("finger", "touch", LUMP + "pad_collision_1")], "fixed"),
    "merged, massless": robot(shape(0.1) + shape(0.2), [("finger", "touch", LUMP + "finger_collision_2")], "fixed", ""),
    "on the palm": robot(shape(0.1), [("palm", "touch", LUMP + "finger_collision_1")], "fixed"),
    "kept": robot(shape(0.1), [("finger", "touch", "finger_collision")], "fixed",
                  more='<gazebo reference="knuckle"><preserveFixedJoint>true</preserveFixedJoint></gazebo>'),
    "chain": robot(shape(0.1), [("tip", "touch", LUMP + "tip_collision_2")], "fixed",
                   more=f'<link name="tip">{INERTIAL}{shape(0.3)}</link><joint name="a" type="fixed">'
                        '<parent link="finger"/><child link="tip"/></joint>'),
    "sorted joints": robot(shape(0.1), [("tip", "touch", LUMP + "tip_collision_1")], "fixed",
                           more=f'<link name="tip">{INERTIAL}{shape(0.3)}</link><joint name="a" type="fixed">'
                                '<parent link="palm"/><child link="tip"/></joint>'),
}


def run(*command, folder):
    done = subprocess.run([str(word) for word in command], cwd=folder, capture_output=True, encoding="utf-8",
                          timeout=600, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{command}\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


def touched(file):
    """{sensor: sizes of the collisions that it names}; None for a name that its link does not have."""
    text = subprocess.run(["ign", "sdf", "-p", file], capture_output=True, encoding="utf-8", timeout=600,
                          check=False).stdout
    found = {}
    for link in ElementTree.fromstring(text).iter("link"):
        sizes = {one.get("name"): one.findtext("geometry/box/size").split()[0] for one in link.findall("collision")}
        for sensor in link.findall("sensor"):
            found[sensor.get("name")] = [sizes.get(one.text.strip()) for one in sensor.iter("collision")]
    return found


@unittest.skipUnless(shutil.which("ign"), "ign is not installed")
class ContactTest(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="smurf-contact-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def each(self, check):
        for name, text in ROBOTS.items():
            with self.subTest(name):
                (self.folder / "hand.urdf").write_text(text)
                expected = touched(self.folder / "hand.urdf")
                self.assertNotIn(None, [size for sizes in expected.values() for size in sizes], expected)
                check(expected)

    def model(self, *arguments):
        shutil.rmtree(self.folder / "m", ignore_errors=True)
        run(TOOLS["urdf2smurf"], "hand.urdf", "-o", "m", *arguments, folder=self.folder)
        return next((self.folder / "m").rglob("*.smurf"))

    def test_copies_of_urdf2smurf(self):
        def check(expected):
            model = self.model()
            urdf = next((self.folder / "m").rglob("*.urdf"))
            self.assertEqual(touched(urdf), expected)
            # The text in the annotations is that of the copy.
            for extensions in (self.folder / "m").rglob("*extensions*"):
                names = re.findall(r"<collision>(\w+)</collision>", urdf.read_text())
                self.assertEqual(re.findall(r"<collision>(\w+)</collision>", extensions.read_text()), names)
            for options in ([], ["--apply", "all", "--sensors", "gazebo"], ["--collapse-fixed"], ["--prefix", "left_"],
                            ["--base", "fixed"], ["--canonical"], ["--urdf-version", "1.0"]):
                run(TOOLS["smurf2urdf"], model, "-o", "out.urdf", "--prove", *options, folder=self.folder)
                found = touched(self.folder / "out.urdf")
                self.assertEqual({name: found.get(name) for name in expected}, expected, options)
        self.each(check)

    def test_sensors_of_annotations(self):
        """Without the elements of the URDF, the annotations alone make working sensors."""
        def check(expected):
            model = self.model()
            urdf = next((self.folder / "m").rglob("*.urdf"))
            urdf.write_text(re.sub('<gazebo reference="[^"]*"><sensor.*?</gazebo>', "", urdf.read_text()))
            run(TOOLS["smurf2urdf"], model, "-o", "out.urdf", "--sensors", "gazebo", "--prove", folder=self.folder)
            self.assertEqual(touched(self.folder / "out.urdf"), expected)
        self.each(check)

    def test_sdf_of_smurfs_flatten(self):
        def check(expected):
            for source in ("hand.urdf", self.model()):
                run(TOOLS["smurfs-flatten"], source, "-o", "out.sdf", folder=self.folder)
                self.assertEqual(touched(self.folder / "out.sdf"), expected)
        self.each(check)

    def test_collisions_on_several_links_are_named(self):
        text = robot(shape(0.1), [("palm", "touch", f"palm_collision {LUMP}finger_collision_1")], "fixed")
        (self.folder / "hand.urdf").write_text(text)
        said = run(TOOLS["smurfs-flatten"], "hand.urdf", "-o", "out.sdf", folder=self.folder)
        self.assertIn(f"collisions of contact sensors on several links (`{LUMP}finger_collision_1`)", said)

    def test_names_that_gazebo_does_not_have_are_kept(self):
        (self.folder / "hand.urdf").write_text(robot(shape(0.1, "pad"), [("finger", "touch", "pad")]))
        self.model()
        self.assertIn("<collision>pad</collision>", next((self.folder / "m").rglob("*.urdf")).read_text())


def main():
    if len(sys.argv) < 4:
        sys.exit(f"usage: {sys.argv[0]} URDF2SMURF SMURF2URDF SMURFS-FLATTEN [unittest option]...")
    for name in ("urdf2smurf", "smurf2urdf", "smurfs-flatten"):
        TOOLS[name] = pathlib.Path(sys.argv.pop(1)).absolute()
    result = unittest.main(module="__main__", exit=False).result
    sys.exit(1 if not result.wasSuccessful() else 77 if result.skipped else 0)


if __name__ == "__main__":
    main()
