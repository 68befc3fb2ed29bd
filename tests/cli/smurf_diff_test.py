# SPDX-License-Identifier: BSD-3-Clause
"""smurf-diff as people and git use it."""
import json
import pathlib
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import cli  # noqa: E402

LINKS = """
  <link name="base"/>
  <link name="arm">
    <inertial><origin xyz="0 0 0.1"/><mass value="0.35"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.03"/></inertial>
    <visual name="arm_visual"><geometry><box size="0.1 0.1 0.2"/></geometry></visual>
    <collision><origin xyz="0 0 0.1"/><geometry><cylinder radius="0.05" length="0.2"/></geometry></collision>
    <collision><geometry><sphere radius="0.05"/></geometry></collision>
  </link>
  <link name="hand"/>
"""
JOINTS = """
  <joint name="elbow" type="revolute">
    <parent link="base"/><child link="arm"/><origin xyz="0 0 0.3"/><axis xyz="0 1 0"/>
    <limit lower="-1" upper="1.75" effort="10" velocity="2"/>
  </joint>
  <joint name="wrist" type="fixed"><parent link="arm"/><child link="hand"/></joint>
"""
ROBOT = f'<robot name="r">{LINKS}{JOINTS}</robot>\n'


XACRO = """<robot name="r" xmlns:xacro="x"><xacro:arg name="side" default="left"/>
<xacro:property name="mass" value="${1 if '$(arg side)' == 'left' else 2}"/>
<link name="base"><inertial>
<mass value="${mass}"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link></robot>
"""


class Diff(cli.CliTest):
    def told(self, old, new, *options):
        """The differences of two URDFs, as text without places."""
        self.write("old.urdf", old)
        self.write("new.urdf", new)
        done = self.expect(None, "old.urdf", "new.urdf", *options)
        lines = done.stdout.splitlines()
        self.assertEqual(done.returncode, 0 if lines[-1] == "no differences" else 1)
        self.assertTrue(all(len(line) <= 80 for line in lines), lines)
        return [line.split("   ")[0].split("  new.urdf")[0].split("  old.urdf")[0] for line in lines[:-1]]

    def edited(self, old, new, *options):
        self.assertIn(old, ROBOT)
        return self.told(ROBOT, ROBOT.replace(old, new), *options)

    def json(self, *arguments):
        return json.loads(self.expect(None, "--format", "json", *arguments).stdout)

    def copy(self, model, *names):
        for name in names:
            shutil.copytree(cli.FIXTURES / model, self.folder / name)

    def replace(self, path, old, new):
        text = self.read(path)
        self.assertIn(old, text)
        self.write(path, text.replace(old, new))


class Robots(Diff):
    def test_what_a_reviewer_reads(self):
        self.write("old.urdf", ROBOT)
        self.write("new.urdf", ROBOT.replace('upper="1.75"', 'upper="1.57"').replace('value="0.35"', 'value="0.4"'))
        self.assertEqual(self.expect(1, "old.urdf", "new.urdf").stdout, """\
link arm: mass 0.35 -> 0.4 kg (+14.3 %)                               new.urdf:4
joint elbow: upper limit 1.75 -> 1.57 rad (-10.3 %)                  new.urdf:13
2 differences: 2 changed
""")

    def test_the_model_of_a_folder(self):
        self.copy("models/arm", "old", "new")
        self.expect(0, "old", "new")
        self.replace("new/urdf/arm.urdf", 'name="arm"', 'name="leg"')
        self.assertIn("new/urdf/arm.urdf", self.expect(1, "old", "new/smurf/arm.smurf").stdout)

    def test_no_differences(self):
        for same in (ROBOT.replace("\n", "\n\n<!-- c -->"), ROBOT.replace('"', "'"), ROBOT.replace("0.35", "3.50e-1"),
                     f'<robot name="r">{JOINTS}{LINKS}</robot>', ROBOT.replace("<axis", '<dynamics damping="0"/><axis'),
                     ROBOT.replace('<origin xyz="0 0 0.3"/>', '<origin rpy="0 0 6.283185307179586" xyz="0 0 0.3"/>')):
            self.assertEqual(self.told(ROBOT, same), [])

    def test_values(self):
        for old, new, told in (
                ('xyz="0 1 0"', 'xyz="0 0 1"', "joint elbow: axis 0 1 0 -> 0 0 1"),
                ('xyz="0 0 0.3"', 'xyz="0 0 0.4"', "joint elbow: pose xyz 0 0 0.3 -> 0 0 0.4 m, moves 2 links"),
                ('"revolute"', '"prismatic"', "joint elbow: type revolute -> prismatic"),
                ('ixx="0.01"', 'ixx="0.015"', "link arm: inertia ixx 0.01 -> 0.015 kg m^2"),
                ('<origin xyz="0 0 0.1"/><mass', "<mass", "link arm: center of mass 0 0 0.1 -> 0 0 0 m"),
                ("<sphere", '<sphere x="1"', "collision 2 of link arm: sphere x none -> 1"),
                ('<axis xyz="0 1 0"/>', "", "joint elbow: axis 0 1 0 -> 1 0 0 (default)"),
                ('<box size="0.1 0.1 0.2"/>', '<sphere radius="0.2"/>',
                 "visual arm_visual of link arm: shape box size 0.1 0.1 0.2 m -> sphere radius"),
                ('name="r"', 'name="q"', "robot: name r -> q"),
                ("<axis", '<mimic joint="wrist" multiplier="2"/><axis',
                 "joint elbow: mimic none -> joint wrist, multiplier 2"),
                ("<axis", '<mimic joint="wrist"/><axis', "joint elbow: mimic joint none -> wrist"),
                ("</robot>", '<gazebo reference="arm"><mu1>1</mu1></gazebo></robot>', "gazebo arm added")):
            with self.subTest(new=new):
                self.assertEqual(self.edited(old, new)[:1], [told])
                self.assertEqual(len([line for line in self.edited(old, new) if line]), 1)

    def test_the_same_body_in_another_frame(self):
        inertial = '<origin xyz="0 0 0.1"/><mass value="0.35"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.03"/>'
        turned = ('<origin xyz="0 0 0.1" rpy="0 0 1.5707963267948966"/><mass value="0.35"/>'
                  '<inertia ixx="0.02" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.03"/>')
        self.assertEqual(self.edited(inertial, turned), [])

    def test_an_attribute_and_an_element_of_one_name(self):
        extension = '<transmission name="t" type="a"><type>{}</type><x>1</x><x>{}</x></transmission>'
        with_extension = ROBOT.replace("</robot>", extension.format("b", 2) + "</robot>")
        self.assertEqual(self.told(with_extension, with_extension.replace("<x>1", "\n<x>1")), [])
        self.assertEqual(self.told(with_extension, with_extension.replace("<type>b", "<type>c")), ["transmission t: type b -> c"])
        self.assertEqual(self.told(with_extension, with_extension.replace("<x>2", "<x>3")), ["transmission t: x 2 -> 3 (+50 %)"])

    def test_extensions_follow_renames(self):
        extension = ('<transmission name="t"><joint name="wrist"><x>1</x></joint><joint name="elbow"><x>2</x></joint></transmission>'
                     '<gazebo reference="arm"><y>arm</y></gazebo>')
        old = ROBOT.replace("</robot>", extension + "</robot>")
        self.assertEqual(self.told(old, old.replace('"wrist"', '"palm"')), ["joint wrist renamed to palm"])
        joints = ('<joint name="wrist"><x>1</x></joint>', '<joint name="elbow"><x>2</x></joint>')
        self.assertEqual(self.told(old, old.replace("".join(joints), "".join(reversed(joints)))), [])
        self.assertEqual(self.told(old, old.replace("<x>2", "<x>3")), ["transmission t: joint[elbow] x 2 -> 3 (+50 %)"])
        self.assertEqual(self.told(old, old.replace('"arm"', '"forearm"').replace(">arm<", ">forearm<")), ["link arm renamed to forearm"])

    def test_added_removed_and_renamed(self):
        hand = '<link name="hand"/>'
        wrist = '<joint name="wrist" type="fixed"><parent link="arm"/><child link="hand"/></joint>'
        self.assertEqual(self.edited("arm", "forearm"),
                         ["link arm renamed to forearm", "visual arm_visual of link forearm renamed to forearm_visual"])
        self.assertEqual(self.edited('"wrist"', '"palm"'), ["joint wrist renamed to palm"])
        self.assertEqual(self.edited('"base"', '"root"'), ["link base renamed to root"])
        without = ROBOT.replace(hand, "").replace(wrist, "")
        self.assertEqual(self.told(ROBOT, without), ["link hand removed", "joint wrist removed"])
        self.assertEqual(self.told(without, ROBOT), ["link hand added", "joint wrist added"])
        self.assertEqual(self.edited("<collision><geometry><sphere radius=\"0.05\"/></geometry></collision>", ""),
                         ["collision 2 of link arm removed"])

    def test_all_names_at_once(self):
        new = ROBOT
        for name in ("base", "arm", "hand", "elbow", "wrist"):
            new = new.replace(f'"{name}"', f'"left_{name}"')
        self.assertEqual(sorted(self.told(ROBOT, new)), sorted(
            f"{kind} {name} renamed to left_{name}" for kind, names in (("link", ("base", "arm", "hand")), ("joint", ("elbow", "wrist")))
            for name in names))

    def test_tolerance(self):
        self.assertEqual(self.edited("0.35", "0.3500001", "--tolerance", "1e-6"), [])
        self.assertEqual(self.edited("0.35", "0.3500001"), ["link arm: mass 0.35 -> 0.3500001 kg (+2.86e-05 %)"])
        self.assertEqual(self.edited('xyz="0 0 0.3"', 'xyz="0 0 0.301"', "--tolerance", "0.01"), [])
        self.assertEqual(self.edited("0.35", "0.3500000000000001", "--tolerance", "0"),
                         ["link arm: mass 0.35 -> 0.3500000000000001 kg (+3.17e-14 %)"])
        self.expect_complaint("--tolerance: '-1' is not a number of at least 0", "a", "b", "--tolerance=-1")

    def test_meshes_are_their_content(self):
        mesh = '<mesh filename="%s"/>'
        old, new = (ROBOT.replace('<box size="0.1 0.1 0.2"/>', mesh % name) for name in ("a.stl", "b.stl"))
        self.write("a.stl", "solid a\n")
        self.write("b.stl", "solid a\n")
        self.assertEqual(self.told(old, new), [])
        self.write("b.stl", "solid b\n")
        self.assertEqual(self.told(old, new), ["visual arm_visual of link arm: mesh filename a.stl -> b.stl"])
        self.assertEqual(len(self.told(old, ROBOT.replace('<box size="0.1 0.1 0.2"/>', mesh % "c.stl"))), 1)

    def test_a_file_of_the_same_name(self):
        robot = ROBOT.replace('<box size="0.1 0.1 0.2"/>', '<mesh filename="a.stl"/>')
        for folder in ("one", "two"):
            self.write(folder + "/arm.urdf", robot)
        change = "visual arm_visual of link arm: mesh filename is still a.stl, "
        self.write("one/a.stl", "solid a\n")
        for why in ("the new file cannot be read", "the contents differ"):
            done = self.expect(1, "one/arm.urdf", "two/arm.urdf")
            self.assertIn(change + why, " ".join(done.stdout.split()))
            self.write("two/a.stl", "solid b\n")
        done = self.run_tool("-", "two/arm.urdf", stdin=robot)
        self.assertIn(change + "the old file cannot be read", " ".join(done.stdout.split()))


class Models(Diff):
    def test_annotations(self):
        self.copy("models/arm", "old", "new")
        mains = ("old/smurf/arm.smurf", "new/smurf/arm.smurf")
        self.assertEqual(self.expect(0, *mains).stdout, "no differences\n")
        self.replace("new/smurf/arm_motors.yml", "maxEffort: 40.0", "maxEffort: 50.0")
        found = self.json(*mains)["differences"]
        self.assertEqual(len(found), 1, found)
        self.assertEqual({key: found[0][key] for key in ("change", "kind", "property", "old", "new", "unit", "default")},
                         {"change": "changed", "kind": "motor", "property": "maxEffort", "old": 40, "new": 50,
                          "unit": "N m", "default": "0"})
        self.assertEqual(found[0]["new_source"]["file"], "new/smurf/arm_motors.yml")

    def test_a_renamed_thing_is_one_difference(self):
        lint = pathlib.Path(cli.TOOL).parent / "smurf-lint"
        self.copy("models/arm", "old")
        for kind, old in (("link", "forearm"), ("joint", "joint3_elbow"), ("motor", "joint4_wrist"), ("sensor", "hand_imu"),
                          ("material", "rubber_black"), ("visual", "forearm_visual"), ("collision", "forearm_collision")):
            shutil.rmtree(self.folder / "new", ignore_errors=True)
            self.copy("models/arm", "new")
            subprocess.run([lint, "--rename", f"{kind}:{old}=brand_new", "new/smurf/arm.smurf"], cwd=self.folder, check=True,
                           capture_output=True)
            found = self.json("old/smurf/arm.smurf", "new/smurf/arm.smurf")["differences"]
            with self.subTest(kind=kind):
                self.assertEqual([(one["change"], one["old_name"], one["name"]) for one in found if one["change"] == "renamed"]
                                 [:1], [("renamed", old, "brand_new")], found)
                self.assertLessEqual({one["change"] for one in found}, {"renamed"}, found)
                self.assertEqual(len(found), 1, found)

    def test_an_old_name_of_a_renamed_thing_that_is_still_used(self):
        self.copy("models/arm", "old", "new")
        text = self.read("new/urdf/arm.urdf")
        self.write("new/urdf/arm.urdf", text.replace('"forearm"', '"lower_arm"'))
        mains = ("old/smurf/arm.smurf", "new/smurf/arm.smurf")
        kept = [one for one in self.json(*mains)["differences"] if one["change"] == "changed"]
        self.assertTrue(kept)
        for one in kept:
            self.assertNotEqual(one["old"], "lower_arm", one)
            if one["old"] == "forearm":
                self.assertEqual((one["new"], one["effect"]), ("forearm", "which was renamed to lower_arm"))
        self.assertRegex(self.expect(1, *mains).stdout, r"is\s+still\s+forearm,\s+which\s+was\s+renamed\s+to\s+lower_arm")

    def test_old_names_in_lists(self):
        self.copy("models/arm", "old", "new")
        text = self.read("new/urdf/arm.urdf")
        self.write("new/urdf/arm.urdf", text.replace('"joint4_wrist"', '"wrist"'))
        told = " ".join(self.expect(1, "old/smurf/arm.smurf", "new/smurf/arm.smurf").stdout.split())
        self.assertIn("sensor joint_positions: id still has an old name: joint4_wrist was renamed to wrist", told)
        self.assertIn("motor joint4_wrist: joint is still joint4_wrist, which was renamed to wrist", told)
        # The annotation of the joint has the old name, and was not renamed.
        self.assertNotIn("renamed to joint4_wrist", told)

    def test_a_model_and_its_urdf(self):
        smurf2urdf = pathlib.Path(cli.TOOL).parent / "smurf2urdf"
        self.copy("models/arm", "arm")
        subprocess.run([smurf2urdf, "--canonical", "-q", "arm/smurf/arm.smurf", "-o", "robot.urdf"], cwd=self.folder, check=True)
        self.assertEqual(self.expect(0, "arm/smurf/arm.smurf", "robot.urdf").stdout, "no differences\n")

    def test_the_canonical_form_keeps_the_shape(self):
        smurf2urdf = pathlib.Path(cli.TOOL).parent / "smurf2urdf"
        self.write("r.urdf", ROBOT.replace('<sphere radius="0.05"/>', '<sphere radius="0.05"/><material name="grey"/>'))
        subprocess.run([smurf2urdf, "--canonical", "--force", "-q", "r.urdf", "-o", "c.urdf"], cwd=self.folder, check=True)
        self.assertEqual(self.expect(0, "r.urdf", "c.urdf").stdout, "no differences\n")

    def test_inputs_that_cannot_be_compared(self):
        self.write("r.urdf", ROBOT)
        self.write("broken.urdf", "<robot><link")
        self.write("m.smurf", "files: [gone.yml, r.urdf]\n")
        self.write("s.smurfs", "entities: []\n")
        self.write("t.txt", "x")
        self.expect_complaint("cannot read 'gone.urdf': No such file or directory", "r.urdf", "gone.urdf")
        self.expect_complaint("'t.txt' is not a model, scene, URDF or annotation file", "t.txt", "r.urdf")
        self.expect_complaint("'s.smurfs' is a scene and 'r.urdf' a model; a scene can only be compared with a scene", "r.urdf", "s.smurfs")
        self.expect_complaint("two inputs are compared, not 1; see --help", "r.urdf")
        self.write("two/a.urdf", ROBOT)
        self.write("two/b.urdf", ROBOT)
        self.expect_complaint("'two' contains 2 files to choose from; name one, such as 'two/a.urdf'", "r.urdf", "two")
        self.expect_complaint("only one of them can be standard input", "-", "-")
        for broken, rule in (("broken.urdf", "SML1001"), ("m.smurf", "SML2001")):
            done = self.expect(2, "r.urdf", broken)
            self.assertEqual(done.stdout, "")
            self.assertIn(f"error[{rule}]", done.stderr)

    def test_annotations_that_cannot_be_read_are_not_equal(self):
        for name, effort in (("a", 40), ("b", 50)):
            self.write(f"{name}/r.urdf", ROBOT)
            self.write(f"{name}/m.smurf", "modelname: r\nfiles: [r.urdf, motors.yml]\n")
            self.write(f"{name}/motors.yml", f"motors:\n- {{name: m, joint: elbow, maxEffort: {effort}}}\n#{'x' * 2000}\n")
        models = "a/m.smurf", "b/m.smurf"
        self.assertIn("maxEffort 40 -> 50", self.expect(1, *models).stdout)
        shutil.copytree(self.folder / "a", self.folder / "c")
        for name in "ab":
            self.write(f"{name}/motors.yml", f"\x89PNG {name}".encode("latin-1"))
        for rule, arguments in (("SML0003", models), ("SML0003", ("c/m.smurf", "b/m.smurf")),
                                ("SML0002", ("--limit", "file-bytes=1900", "c/m.smurf", "c/m.smurf")),
                                ("SML0002", ("--limit", "repeated-bytes=1900", "c/m.smurf", "c/m.smurf"))):
            done = self.expect(2, *arguments)
            self.assertEqual(done.stdout, "")
            self.assertIn(f"error[{rule}]", done.stderr)

    def test_a_page_for_a_browser(self):
        self.write("old.urdf", ROBOT)
        self.write("new.urdf", ROBOT.replace('value="0.35"', 'value="0.4"'))
        self.assertEqual(self.expect(1, "old.urdf", "new.urdf", "--format", "html", "-o", "page.html").stdout, "")
        page = self.read("page.html")
        self.assertTrue(page.startswith("<!doctype html>"), page[:80])
        self.assertNotRegex(page, r"""<(?:script|link|img)[^>]*(?:src|href)=|@REPORT@|@SCRIPT_HASH@|VIEWER_""")
        self.assertEqual(self.expect(1, "old.urdf", "new.urdf", "--format", "html").stdout, page)
        piped = self.expect(1, "old.urdf", "-", "--stdin-filename", "new.urdf", "--format", "html", stdin=self.read("new.urdf")).stdout
        for key in ("new", "new_title"):
            piped = piped.replace(f'"{key}": "-"', f'"{key}": "new.urdf"')
        self.assertEqual(piped, page)
        self.assertEqual(self.expect(1, "old.urdf", "new.urdf", "--format", "html", "--quiet").stdout, "")
        self.assertIn('"differences": []', self.expect(0, "old.urdf", "old.urdf", "--format", "html").stdout)
        self.write("broken.urdf", "<robot")
        self.assertEqual(self.expect(2, "old.urdf", "broken.urdf", "--format", "html", "-o", "none.html").stdout, "")
        self.assertFalse((self.folder / "none.html").exists())

    def test_a_page_does_not_replace_a_mesh(self):
        self.write("old.urdf", ROBOT)
        self.write("new.urdf", ROBOT.replace('<box size="0.1 0.1 0.2"/>', '<mesh filename="a.stl"/>'))
        self.write("a.stl", "solid s\nfacet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet\nendsolid s\n")
        done = self.expect(2, "old.urdf", "new.urdf", "--format", "html", "-o", "a.stl")
        self.assertIn("a.stl", done.stderr)
        self.assertTrue(self.read("a.stl").startswith("solid"))

    def test_standard_input_output_and_silence(self):
        self.write("r.urdf", ROBOT)
        new = ROBOT.replace("0.35", "0.4")
        self.assertIn("mass", self.expect(1, "r.urdf", "-", "--stdin-filename", "r.urdf", stdin=new).stdout)
        self.assertIn("0.4 -> 0.35 kg", self.expect(1, "-", "r.urdf", stdin=new).stdout)
        self.assertEqual(self.expect(1, "-q", "r.urdf", "-", stdin=new).stdout, "")
        self.expect(1, "r.urdf", "-", "-o", "out.txt", stdin=new)
        self.assertIn("mass", self.read("out.txt"))
        self.expect(2, "r.urdf", "-", "-o", "r.urdf", stdin=new)
        self.assertEqual(self.read("r.urdf"), ROBOT)
        self.assertIn("\x1b[", self.expect(1, "r.urdf", "-", "--color", "always", stdin=new).stdout)


class Xacro(Diff):
    def test_two_sets_of_arguments(self):
        self.write("r.urdf.xacro", XACRO)
        done = self.expect(1, "r.urdf.xacro", "r.urdf.xacro", "side:=right")
        self.assertIn("mass", done.stdout)
        self.assertIn("r.urdf.xacro:2", done.stdout)  # the expression that makes the value
        self.expect(0, "r.urdf.xacro", "side:=a", "r.urdf.xacro", "side:=right")
        report = self.json("r.urdf.xacro", "side:=left", "r.urdf.xacro", "side:=right")
        self.assertIn("r.urdf.xacro side:=right", str(report))

    def test_a_xacro_and_the_urdf_that_is_made_of_it(self):
        self.write("r.urdf.xacro", XACRO)
        self.write("r.urdf", '<robot name="r"><link name="base"><inertial><mass value="1"/>'
                             '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link></robot>')
        self.expect(0, "r.urdf", "r.urdf.xacro")
        self.expect(1, "r.urdf", "r.urdf.xacro", "side:=right")

    def test_arguments_without_a_file_or_value(self):
        self.write("r.urdf.xacro", XACRO.replace(' default="left"', ""))
        self.assertIn("write it after the file", self.expect(2, "side:=left", "r.urdf.xacro", "r.urdf.xacro").stderr)
        self.assertIn("SML33", self.expect(2, "r.urdf.xacro", "side:=left", "r.urdf.xacro").stderr)


class Scenes(Diff):
    SCENE = """\
entities:
- {name: a, file: r.urdf, position: [1, 0, 0]}
- {name: b, file: r.urdf, parent: "a::hand", position: [0, 0, 1], anchor: parent}
- {name: inner, file: inner.smurfs, position: [5, 0, 0]}
physics: {gravity: {x: 0, y: 0, z: -9.81}}
"""
    INNER = "entities:\n- {name: c, file: r.urdf, rotation: [0, 0, 90]}\n- {name: d, file: r.urdf}\n"

    def scenes(self, edit=None, inner=None, robot=ROBOT):
        for folder in ("old", "new"):
            self.write(f"{folder}/s.smurfs", self.SCENE)
            self.write(f"{folder}/inner.smurfs", self.INNER)
            self.write(f"{folder}/r.urdf", ROBOT)
        for path, change in (("new/s.smurfs", edit), ("new/inner.smurfs", inner)):
            if change:
                self.replace(path, *change)
        self.write("new/r.urdf", robot)
        text = self.expect(None, "old/s.smurfs", "new/s.smurfs").stdout
        return [line.split("  ")[0] for line in text.splitlines()[:-1] if not line.startswith("  ")]

    def test_entities(self):
        self.assertEqual(self.scenes(), [])
        self.assertEqual(self.scenes(("[1, 0, 0]", "[1, 0, 2]")), ["entity a: placement xyz 1 0 0 -> 1 0 2 m, moves 2 entities"])
        self.assertEqual(self.scenes(("[5, 0, 0]", "[5, 0, 2]")), ["entity inner: placement xyz 5 0 0 -> 5 0 2 m, moves 2 entities"])
        self.assertEqual(self.scenes(inner=("[0, 0, 90]", "[90]")), [])
        self.assertEqual(self.scenes(inner=("[0, 0, 90]", "[180]")), ["entity inner/c: placement rpy 0 0 1.57079633 -> 0 0 3.14159265 rad"])
        self.assertEqual(self.scenes(inner=("name: d", "name: e")), ["entity inner/d renamed to inner/e"])
        self.assertEqual(self.scenes(("- {name: b,", "- {name: new, file: r.urdf}\n- {name: b,")), ["entity new added"])
        self.assertEqual(self.scenes(("-9.81", "-1.62")), ["scene: physics gravity 0 0 -9.81 -> 0 0 -1.62 m/s^2"])
        self.assertEqual(self.scenes(("anchor: parent", "anchor: none")), ["entity b: anchor parent -> none"])
        self.assertEqual(self.scenes(("name: a,", "name: a, type: urdf,")), [])

    def test_a_scene_that_is_included_twice(self):
        for folder, order in (("old", "ab"), ("new", "ba")):
            self.write(f"{folder}/s.smurfs", "entities:\n" + "".join(f"- {{name: {name}, file: inner.smurfs}}\n" for name in order))
            self.write(f"{folder}/inner.smurfs", self.INNER)
            self.write(f"{folder}/r.urdf", ROBOT)
        self.assertEqual(self.expect(0, "old/s.smurfs", "new/s.smurfs").stdout, "no differences\n")
        self.replace("new/s.smurfs", "name: a", "name: z")
        self.assertIn("entity a renamed to z", self.expect(1, "old/s.smurfs", "new/s.smurfs").stdout)
        self.replace("new/inner.smurfs", "name: d,", "name: d, position: [1, 1, 1],")
        text = self.expect(1, "old/s.smurfs", "new/s.smurfs").stdout
        self.assertTrue(text.endswith("2 differences: 1 renamed, 1 changed\n"), text)

    def test_models_of_a_scene(self):
        self.assertEqual(self.scenes(robot=ROBOT.replace("0.35", "0.4")), ["link arm: mass 0.35 -> 0.4 kg (+14.3 %)"])
        self.assertEqual(self.scenes(("hand", "palm"), robot=ROBOT.replace("hand", "palm")), ["link hand renamed to palm"])
        self.write("new/q.urdf", ROBOT)
        self.assertEqual(self.scenes(("a, file: r.urdf", "a, file: q.urdf")), [])
        self.write("new/q.urdf", ROBOT.replace("0.35", "0.4"))
        self.assertEqual(self.scenes(("a, file: r.urdf", "a, file: q.urdf")), ["entity a: file r.urdf -> q.urdf"])


@unittest.skipIf(shutil.which("git") is None, "git is not installed")
class Git(Diff):
    def git(self, *arguments):
        return subprocess.run(["git", "-c", "user.name=a", "-c", "user.email=a@b", *arguments], cwd=self.folder, check=True,
                              capture_output=True, text=True).stdout

    def setUp(self):
        super().setUp()
        self.git("init", "-q", ".")
        self.git("config", "diff.smurf.command", f"'{cli.TOOL}' --git")
        self.write(".gitattributes", "".join(f"*.{name} diff=smurf\n" for name in ("urdf", "smurf", "smurfs", "yml")))
        self.copy("models/arm", "arm")
        self.git("add", ".")
        self.git("commit", "-qm", "one")

    def test_git_diff(self):
        self.replace("arm/urdf/arm.urdf", 'mass value="0.6"', 'mass value="0.66"')
        self.replace("arm/smurf/arm_motors.yml", "maxEffort: 40.0", "maxEffort: 50.0")
        text = self.git("diff")
        self.assertRegex(text, r"(?s)^arm/smurf/arm_motors.yml\n  motor \w+: maxEffort 40 -> 50 N m \(\+25 %\)"
                               r".*\narm/urdf/arm.urdf\n  link forearm: mass 0.6 -> 0.66 kg \(\+10 %\)")
        self.git("commit", "-qam", "two")
        self.assertEqual(self.git("diff", "HEAD~1", "HEAD"), text)
        self.assertIn(text, self.git("log", "-p", "--ext-diff", "-1"))

    def test_files_that_come_and_go(self):
        self.git("rm", "-q", "arm/smurf/arm_lights.yml")
        self.replace("arm/smurf/arm.smurf", "- arm_lights.yml\n", "")
        self.git("mv", "arm/smurf/arm_poses.yml", "arm/smurf/poses.yml")
        self.replace("arm/smurf/arm.smurf", "arm_poses.yml", "poses.yml")
        self.write("arm/urdf/other.urdf", ROBOT)
        self.git("add", ".")
        text = self.git("diff", "--cached")
        self.assertIn("arm/smurf/arm_lights.yml (deleted)\n  light work_lamp removed", text)
        self.assertIn("arm/smurf/arm_poses.yml -> arm/smurf/poses.yml\n  no differences\n", text)
        self.assertIn("arm/urdf/other.urdf (new)\n", text)
        self.assertIn("error[SML2001] there is no file `arm/smurf/arm_lights.yml`", text)

    def test_what_cannot_be_compared_does_not_stop_git(self):
        self.write("arm/urdf/arm.urdf", "<robot><link")
        self.replace("arm/smurf/arm_motors.yml", "maxEffort: 40.0", "maxEffort: 50.0")
        text = self.git("diff")
        self.assertIn("arm/urdf/arm.urdf\n  cannot be compared\n", text)
        self.assertIn("error[SML1001]", text)
        self.assertIn("maxEffort 40 -> 50", text)

    def test_too_many_differences_are_refused(self):
        self.write("old.urdf", ROBOT)
        many = ROBOT.replace('mass value="0.35"', 'mass value="1"').replace('lower="-1"', 'lower="-2"')
        self.write("new.urdf", many.replace('velocity="2"', 'velocity="3"'))
        for output in ("text", "json", "html"):
            done = self.expect(2, "--format", output, "--limit", "differences=2", "old.urdf", "new.urdf")
            self.assertEqual(done.stdout, "")
            self.assertIn("'old.urdf' and 'new.urdf' have more than 2 differences; raise the limit with "
                          "`--limit differences=N`", " ".join(done.stderr.split()))
        self.assertIn("3 differences", self.expect(1, "--limit", "differences=3", "old.urdf", "new.urdf").stdout)

    def test_names_are_no_options(self):
        self.write(".gitattributes", "* diff=smurf\n")
        for name in ("--", "--version", "-q", "--git", "-ostolen.urdf", "--.urdf", "--output=stolen/a.urdf"):
            self.write(name, ROBOT)
        self.git("add", ".")
        self.git("commit", "-qm", "odd names")
        (self.folder / "stolen").mkdir()
        self.git("mv", "--", "--output=stolen/a.urdf", "--allow-outside")
        for name in ("--", "--version", "-q", "--git", "-ostolen.urdf", "--.urdf", "--allow-outside"):
            self.write(name, ROBOT.replace("0.35", "0.4"))
        self.git("add", ".")
        text = self.git("diff", "HEAD")
        self.assertEqual(list((self.folder / "stolen").iterdir()), [])
        self.assertFalse((self.folder / "stolen.urdf").exists())
        headings = [line for line in text.splitlines() if not line.startswith(" ")]
        self.assertEqual(headings, ["--", "--.urdf", "--output=stolen/a.urdf -> --allow-outside", "--git", "--version",
                                    "-ostolen.urdf", "-q"])

    def test_git_comes_last_of_the_options(self):
        git_passes = ("a.urdf", "/dev/null", ".", ".", "a.urdf", "0" * 40, "100644")
        self.expect(0, "--git", "--", *git_passes)
        for option in (("--quiet",), ("--tolerance", "1")):
            self.expect(0, *option, "--git", *git_passes)
            self.expect(2, "--git", *option, *git_passes)


class Plain(Diff):
    def test_names_are_escaped(self):
        nasty = "x&#10;\u202e::error::\u009b2J"
        text = "\n".join(self.told(ROBOT, ROBOT.replace('"hand"', f'"{nasty}"')))
        self.assertNotRegex(text, "[\u202e\u009b]")
        self.assertIn("renamed to x", text)


if __name__ == "__main__":
    cli.main()
