# SPDX-License-Identifier: BSD-3-Clause
"""The command line of smurfs-flatten: results, refusals, paths, explanations."""
import io
import json
import math
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import xml.etree.ElementTree
import zipfile

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import cli  # noqa: E402

BOX = """<?xml version="1.0"?>
<robot name="box">
  <link name="base"/>
  <link name="lid"/>
  <joint name="glue" type="fixed">
    <parent link="base"/>
    <child link="lid"/>
    <origin xyz="0 0 0.1"/>
  </joint>
</robot>
"""
SCENE = """entities:
- {name: A, file: models/box.urdf, position: [1, 2, 3]}
- {name: B, file: models/box.urdf, parent: "A::lid", anchor: parent, rotation: [90]}
"""
BROKEN = SCENE.replace("A::lid", "A::lit")
# Sound, but MARS overwrites the inner anchor.
OUTER = "entities:\n- {name: in, file: inner.smurfs}\n"
INNER = "entities:\n- {name: A, file: models/box.urdf, anchor: world}\n"


class FlattenTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.write("models/box.urdf", BOX)
        self.write("scene.smurfs", SCENE)
        self.write("broken.smurfs", BROKEN)
        self.write("outer.smurfs", OUTER)
        self.write("inner.smurfs", INNER)

    def flat(self, *arguments):
        return json.loads(self.expect(0, *arguments).stdout)


class Result(FlattenTest):
    def test_joint_pose_sets_are_keyframes_of_mjcf(self):
        """In each robot alone, with the commands that hold it; a joint that is not named is at zero, as in SMURF. So are
        states of an SRDF, those of all groups with one name in one key."""
        joint = ('<joint name="{0}" type="revolute"><parent link="a"/><child link="{0}_link"/><axis xyz="0 0 1"/>'
                 '<limit lower="-2" upper="2" effort="9" velocity="1"/></joint><link name="{0}_link"><inertial><mass value="1"/>'
                 '<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>')
        self.write("r.urdf", f'<robot name="r"><link name="a"/>{joint.format("hip")}{joint.format("knee")}</robot>')
        self.write("r_poses.yml", "poses:\n- {name: sit, joints: {hip: 0.5, knee: -1.5}}\n- {name: lean, joints: {knee: 0.25}}\n")
        self.write("r.smurf", "modelname: r\nfiles: [r.urdf, r_poses.yml]\n")
        self.write("two.smurfs", "entities:\n- {name: A, file: r.smurf, anchor: world, pose: sit}\n- {name: B, file: r.smurf, anchor: world}\n")
        self.expect(0, "-q", "--format", "mjcf", "--actuator", "position", "-o", "two.xml", "two.smurfs")
        keys = xml.etree.ElementTree.parse(self.folder / "two.xml").findall("keyframe/key")
        self.assertEqual([(key.get("name"), key.get("qpos"), key.get("ctrl")) for key in keys],
                         [("initial", "0.5 -1.5 0 0", "0.5 -1.5 0 0"),
                          ("A/sit", "0.5 -1.5 0 0", "0.5 -1.5 0 0"), ("A/lean", "0 0.25 0 0", "0 0.25 0 0"),
                          ("B/sit", "0.5 -1.5 0.5 -1.5", "0.5 -1.5 0.5 -1.5"), ("B/lean", "0.5 -1.5 0 0.25", "0.5 -1.5 0 0.25")])
        self.write("r.srdf", '<robot name="r"><group name="g"><joint name="hip"/></group><group name="k"><joint name="knee"/></group>'
                   '<group_state name="up" group="g"><joint name="hip" value="1"/></group_state>'
                   '<group_state name="up" group="k"><joint name="knee" value="-1"/><joint name="hip" value="1 2"/></group_state></robot>')
        self.expect(0, "-q", "--format", "mjcf", "-o", "r.xml", "r.urdf", "--base", "fixed")
        keys = xml.etree.ElementTree.parse(self.folder / "r.xml").findall("keyframe/key")
        self.assertEqual([(key.get("name"), key.get("qpos")) for key in keys], [("initial", "0 0"), ("r/up", "1 -1")])
        (self.folder / "r.srdf").rename(self.folder / "states.xml")
        self.expect(0, "-q", "--format", "mjcf", "-o", "r.xml", "r.urdf", "--base", "fixed", "--srdf", "states.xml")
        self.assertEqual(len(xml.etree.ElementTree.parse(self.folder / "r.xml").findall("keyframe/key")), 2)
        entities = "".join(f"- {{name: e{i}, file: r.smurf, anchor: world}}\n" for i in range(400))
        self.write("many.smurfs", "entities:\n" + entities)
        done = self.run_tool("many.smurfs", "--format", "mjcf", "--actuator", "position", "-o", "many.xml")
        self.assertIn("2 joint pose sets of `r.smurf` are not in the MJCF: keyframes", done.stderr)
        self.assertEqual(len(xml.etree.ElementTree.parse(self.folder / "many.xml").findall("keyframe/key")), 1)

    def test_a_body_of_mjcf_has_at_most_six_joints(self):
        solid = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
        links = "".join(f'<link name="l{i}">{solid if i in (0, 8) else ""}</link>' for i in range(9))
        joints = "".join(f'<joint name="j{i}" type="continuous"><parent link="l{i}"/><child link="l{i + 1}"/><axis xyz="0 0 1"/></joint>'
                         for i in range(8))
        self.write("chain.urdf", f'<robot name="chain">{links}{joints}</robot>')
        self.expect(0, "-q", "--force", "--format", "mjcf", "-o", "chain.xml", "chain.urdf")
        bodies = xml.etree.ElementTree.parse(self.folder / "chain.xml").iter("body")
        self.assertEqual([count for body in bodies if (count := len(body.findall("joint")))], [1, 6, 2])  # the first is free

    def test_instances(self):
        flat = self.flat("scene.smurfs")
        self.assertEqual(flat["schema_version"], "1.0")
        self.assertEqual(flat["scene"], "scene.smurfs")
        self.assertEqual(flat["models"], [{"id": "box", "type": "urdf", "file": "models/box.urdf",
                                           "urdf": "models/box.urdf"}])
        a, b = flat["instances"]
        self.assertEqual(a["position"], [1, 2, 3])
        self.assertEqual(b["position"], [1, 2, 3.1])
        self.assertEqual(b["parent"], {"instance": "A", "link": "lid"})
        self.assertAlmostEqual(b["orientation"]["z"], math.sqrt(0.5), places=15)
        self.assertNotIn("links", a)

    def test_links(self):
        links = self.flat("scene.smurfs", "--links")["instances"][1]["links"]
        self.assertEqual(list(links), ["base", "lid"])
        self.assertAlmostEqual(links["lid"]["position"][2], 3.2, places=15)

    def test_single_model(self):
        flat = self.flat("models/box.urdf")
        self.assertEqual([i["name"] for i in flat["instances"]], ["box"])

    def test_the_same_bytes_from_anywhere(self):
        first = self.expect(0, "scene.smurfs").stdout
        self.assertEqual(self.expect(0, "./models/../scene.smurfs").stdout, first)
        self.assertEqual(self.expect(0, self.folder / "scene.smurfs").stdout, first)
        self.assertEqual(
            self.expect(0, "scene.smurfs", environment={"LC_ALL": "de_DE.UTF-8"}).stdout, first)

    def test_standard_input(self):
        done = self.expect(0, "-", "--stdin-filename", "scene.smurfs", stdin=SCENE)
        self.assertEqual(done.stdout, self.expect(0, "scene.smurfs").stdout)

    def test_fixtures(self):
        for name, count in [("example/example", 5), ("showcase/showcase", 5)]:
            done = self.run_tool(cli.FIXTURES / f"scenes/{name}.smurfs")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertNotRegex(done.stderr, r"(?m)^(warning|error)")
            flat = json.loads(done.stdout)
            self.assertEqual(len(flat["instances"]), count)
            self.assertEqual(len({i["path"] for i in flat["instances"]}), count)


class Xacro(FlattenTest):
    ROBOT = '<robot name="r" xmlns:xacro="x"><link name="$(arg root)"/></robot>'

    def test_a_robot_of_xacro_is_a_scene(self):
        self.write("r.urdf.xacro", self.ROBOT)
        flat = json.loads(self.expect(0, "r.urdf.xacro", "root:=base", "--links").stdout)
        self.assertEqual(list(flat["instances"][0]["links"]), ["base"])
        self.assertIn('<link name="base"', self.run_tool("r.urdf.xacro", "root:=base", "--format", "sdf").stdout)
        done = self.run_tool("r.urdf.xacro")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("SML3313", done.stderr)

    def test_an_entity_cannot_be_a_xacro(self):
        self.write("r.urdf.xacro", self.ROBOT)
        for entity in ("type: urdf, file: r.urdf.xacro", "file: r.urdf.xacro"):
            self.write("s.smurfs", "entities: [{name: e, " + entity + "}]\n")
            done = self.run_tool("s.smurfs")
            self.assertEqual(done.returncode, 1)
            self.assertIn("no reader of scenes expands xacro", done.stderr)
            self.assertIn("smurf2urdf r.urdf.xacro -o r.urdf", done.stderr)


class Output(FlattenTest):
    REFUSED = "'broken.smurfs' cannot be converted: some poses are unknown; nothing was written"

    def test_paths_are_relative_to_the_output(self):
        (self.folder / "out").mkdir()
        for output in ["out/flat.json", self.folder / "out/flat.json"]:
            done = self.expect(0, "scene.smurfs", "-o", output)
            self.assertEqual(done.stdout, "")
            text = self.read("out/flat.json")
            self.assertNotIn(str(self.folder), text)
            flat = json.loads(text)
            self.assertEqual(flat["models"][0]["urdf"], "../models/box.urdf")
            self.assertEqual(flat["instances"][0]["source"], {"file": "../scene.smurfs", "line": 2})

    def test_errors_leave_the_old_file(self):
        self.write("flat.json", "old")
        done = self.run_tool("broken.smurfs", "-o", "flat.json")
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stdout, "")
        self.assertEqual(self.read("flat.json"), "old")
        self.assertIn("error[SML5101]", done.stderr)
        self.assertIn("broken.smurfs:3:44", done.stderr)
        self.assertIn("did you mean `A::lid`?", done.stderr)

    def test_errors_that_leave_poses_known_are_counted(self):
        self.write("heavy.urdf", '<robot name="r"><link name="l"><inertial><mass value="-1"/><inertia '
                   'ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link></robot>')
        self.write("heavy.smurfs", "entities: [{name: H, file: heavy.urdf, position: [1, 2, 3]}]\n")
        done = self.run_tool("heavy.smurfs")
        self.assertEqual((done.returncode, done.stderr),
                         (0, "smurfs-flatten: 1 error: see smurf-lint heavy.smurfs\n"))
        self.assertEqual(json.loads(done.stdout)["instances"][0]["position"], [1, 2, 3])
        self.assertEqual(self.run_tool("heavy.smurfs", "--quiet").stderr, "")
        done = self.run_tool("heavy.smurfs", "--fail-on", "error")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("'heavy.smurfs' has findings that reach --fail-on; see --force; nothing was "
                      "written", done.stderr)
        done = self.run_tool("broken.smurfs", "--force")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn(self.REFUSED, done.stderr)

    def test_what_only_mars_fails_on_is_written_for_others(self):
        """MARS does not load a primitive in an included scene, but its pose is known."""
        self.write("inner.smurfs", "entities:\n- {name: box, type: primitive, geometry: {type: box}, "
                   "extend: {x: 1, y: 1, z: 1}, mass: 2, position: {x: 3}}\n")
        done = self.run_tool("outer.smurfs")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("SML5207", done.stderr)
        self.assertEqual(json.loads(done.stdout)["instances"][0]["position"], [3, 0, 0])

    def test_the_extension_of_the_output_chooses_the_format(self):
        self.run_tool("scene.smurfs", "-o", "scene.sdf")
        self.assertTrue(self.read("scene.sdf").startswith("<?xml"))
        self.run_tool("scene.smurfs", "-o", "scene.world")
        self.assertEqual(self.read("scene.world"), self.read("scene.sdf"))
        self.run_tool("scene.smurfs", "-o", "flat")
        self.assertEqual(len(json.loads(self.read("flat"))["instances"]), 2)
        self.expect_complaint("no format has the extension '.xml'; for MuJoCo, add --format mjcf", "scene.smurfs", "-o", "scene.xml")
        self.expect_complaint("no format has the extension '.usd'; smurfs-flatten writes OpenUSD as text: name a .usda file",
                              "scene.smurfs", "-o", "scene.usd")
        self.run_tool("scene.smurfs", "-o", "flat.sdf", "--format", "json")
        self.assertEqual(len(json.loads(self.read("flat.sdf"))["instances"]), 2)

    def test_files_that_are_no_scenes(self):
        self.write("box.obj", "v 0 0 0\n")
        self.expect_complaint("'box.obj' is not a model; name the .smurf or .urdf file that uses it", "box.obj")

    def test_directives_beside_the_robot_are_written_again(self):
        for _ in range(2):
            done = self.run_tool("models/box.urdf", "--format", "dmd", "-o", "models/box.dmd.yaml")
            self.assertEqual(done.returncode, 0, done.stderr)

    def test_an_srdf_that_cannot_be_read_stops_it(self):
        def complain(reason):
            self.expect_complaint(reason, "models/box.urdf", "--format", "mjcf", "--srdf", "box.srdf")

        complain("cannot read 'box.srdf': No such file or directory")
        self.write("box.srdf", '<robot name="box">\n<disable_collisions')
        complain("'box.srdf' is not well-formed XML: line 2: the start tag of `disable_collisions` is never closed by `>`")
        self.write("box.srdf", "<sdf/>")
        complain("'box.srdf' is no SRDF: its root element is 'sdf', not 'robot'")
        self.write("box.srdf", '<robot name="box"/>')
        told = self.run_tool("models/box.urdf", "--format", "mjcf", "--srdf", "box.srdf", "-o", "box.xml").stderr
        self.assertIn("`box.srdf` disables no pair of links of `models/box.urdf`", told)

    def test_what_a_robot_loses_refuses_the_scene(self):
        """An unreadable value, a robot without a tree, or a named pose makes the result wrong; a motor does not."""
        self.write("models/box.smurf", "modelname: box\nfiles: [box.urdf, box_poses.yml, box_motors.yml]\n")
        self.write("models/box_poses.yml", "poses:\n- {name: open, joints: {glue: 0}}\n")
        self.write("models/box_motors.yml", "motors:\n- {name: m, joint: glew}\n")
        self.write("one.smurfs", "entities: [{name: A, file: models/box.smurf}]\n")
        self.assertEqual(self.run_tool("one.smurfs").returncode, 0)
        for path, old, new, loss in [
                ("models/box.urdf", 'xyz="0 0 0.1"', 'xyz="0 0 O.1"', "a value cannot be read"),
                ("models/box.urdf", '<child link="lid"/>', '<child link="lod"/>', "its links and joints do not form a valid robot"),
                ("models/box_poses.yml", "glue: 0", "glue: far", "a named pose is not understood")]:
            text = self.read(path)
            self.write(path, text.replace(old, new))
            done = self.run_tool("one.smurfs")
            self.assertEqual((done.returncode, done.stdout), (1, ""), loss)
            self.assertIn(f"= note: not converted: {loss}\n", done.stderr)
            self.assertIn(f"'one.smurfs' cannot be converted: {loss}", done.stderr)
            self.write(path, text)

    def test_what_decides_no_pose_can_be_forced(self):
        """Also for a robot that is given as it is: its findings have their places, as those of a scene have."""
        text = self.read("models/box.urdf").replace('<link name="base"/>', '<link name="base"><visual><geometry><box size="1 1 1"/>'
                                                    '</geometry><material name="m"/></visual></link>')
        self.write("twice.urdf", text.replace('<material name="m"/>', '<material name="m"/><material name="n"/>'))
        done = self.run_tool("twice.urdf", "--format", "mjcf", "-o", "twice.xml")
        self.assertEqual(done.returncode, 0, done.stderr)
        for old, new, can_be_forced in [("</robot>", "</robot>\n\0", True), ('size="1 1 1"', 'size="1 1"', True),
                                        ('xyz="0 0 0.1"', 'xyz="0 0 0.1 0"', False)]:
            self.assertIn(old, text)
            self.write("broken.urdf", text.replace(old, new))
            done = self.run_tool("broken.urdf", "--format", "mjcf", "-o", "broken.xml")
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertEqual("a value cannot be read; see --force; nothing was written" in done.stderr, can_be_forced, done.stderr)
            done = self.run_tool("broken.urdf", "--format", "mjcf", "-o", "broken.xml", "--force")
            self.assertEqual(done.returncode, 0 if can_be_forced else 1, done.stderr)
            self.assertIn("although a value cannot be read" if can_be_forced else "cannot be converted: a value cannot be read", done.stderr)

    def test_a_comment_tells_no_pose(self):
        self.write("broken.smurfs", "# smurf-lint: ignore-file[SML5101] known\n" + BROKEN)
        for options in ((), ("--force",)):
            done = self.run_tool("broken.smurfs", *options)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertIn(self.REFUSED, done.stderr)

    def test_warnings_do_not_refuse_unless_told(self):
        done = self.run_tool("outer.smurfs")
        self.assertEqual(done.returncode, 0)
        self.assertIn("warning[SML5201]", done.stderr)
        self.assertEqual(json.loads(done.stdout)["instances"][0]["anchor"], "world")
        done = self.run_tool("outer.smurfs", "--fail-on", "warning")
        self.assertEqual((done.returncode, done.stdout), (1, ""))

    def test_a_form_that_names_files_is_judged_by_what_it_writes(self):
        links = "".join(f'<link name="l{i}"/><joint name="j{i}" type="fixed"><parent link="base"/><child link="l{i}"/></joint>'
                        for i in range(100))
        self.write("large.urdf", '<robot name="r"><link name="base"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" '
                   f'ixy="0" ixz="0" iyz="0"/></inertial></link>{links}</robot>')
        self.write("many.smurfs", "entities:\n" + "".join(
            f"- {{name: e{i}, type: urdf, file: large.urdf, position: [{i}, 0, 0]}}\n" for i in range(50)))
        limit = "--limit", "scene-bytes=200000"
        done = self.run_tool("many.smurfs", "--format", "sdf", "--form", "expand", *limit)
        self.assertEqual(done.returncode, 1)
        self.assertIn("SML5022", done.stderr)
        done = self.run_tool("many.smurfs", "--format", "sdf", "--form", "reference", *limit)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertLess(len(done.stdout), 200000)

    def test_says_what_it_wrote(self):
        wrote = "smurfs-flatten: wrote flat.json: 2 instances of 1 model\n"
        self.assertEqual(self.run_tool("scene.smurfs", "-o", "flat.json").stderr, wrote)
        self.assertEqual(self.run_tool("scene.smurfs", "-o", "flat.json", "--quiet").stderr, "")
        self.assertEqual(self.run_tool("scene.smurfs").stderr, "")
        told = self.run_tool("scene.smurfs", "-o", "d.dmd").stderr
        self.assertIn("wrote d.dmd: 2 instances of 1 model\n", told)
        self.assertIn('package_map().Add("scene", ".")', " ".join(told.split()))
        # It would widen what later runs may read.
        self.assertFalse((self.folder / "package.xml").exists())
        self.assertIn("cannot write 'no/flat.json': there is no folder 'no'",
                      self.run_tool("scene.smurfs", "-o", "no/flat.json").stderr)

    def test_a_scene_with_misspelt_entities_is_refused(self):
        self.write("empty.smurfs", "entites:\n- {name: A, file: models/box.urdf}\n")
        done = self.run_tool("empty.smurfs", "-o", "e.sdf", "-q")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("error[SML4005]", done.stderr)
        self.assertIn("see --force; nothing was written", done.stderr)
        self.assertEqual(self.run_tool("empty.smurfs", "-o", "e.sdf", "--force").returncode, 0)
        for text in ("entities: []", "physics: {gravity: {x: 0, y: 0, z: -1}}"):
            self.write("empty.smurfs", text)
            self.assertEqual(self.run_tool("empty.smurfs", "-o", "e.sdf", "-q").returncode, 0)

    def test_a_floor_on_request(self):
        self.write("free.smurfs", "entities:\n- {name: A, file: models/box.urdf}\n")
        for name, floors in (("w.sdf", ('<model name="ground">', "<plane>")),
                             ("w.mjcf", ('<geom class="solid" type="plane" size="50 50 1" name="ground"/>',))):
            done = self.run_tool("free.smurfs", "-o", name)
            self.assertTrue(done.stderr.endswith("1 instance of 1 model; robots fall, see --ground\n"), done.stderr)
            for floor in floors:
                self.assertNotIn(floor, self.read(name))
            done = self.run_tool("free.smurfs", "-o", name, "--ground")
            self.assertTrue(done.stderr.endswith("1 instance of 1 model\n"), done.stderr)
            for floor in floors:
                self.assertEqual(self.read(name).count(floor), 2 if floor == "<plane>" else 1)
        self.write("fixed.smurfs", "entities:\n- {name: A, file: models/box.urdf, anchor: world}\n")
        self.assertNotIn("--ground", self.run_tool("fixed.smurfs", "-o", "w.sdf").stderr)
        self.expect_complaint("--ground needs one of the formats sdf, sdf1.6, mjcf", "free.smurfs", "--ground", "--format", "json")
        self.expect_complaint("--ground needs --form expand", "free.smurfs", "--ground", "--format", "sdf", "--form", "reference")

    def test_a_folder_with_one_scene(self):
        self.write("world/deep/only.smurfs", SCENE.replace("models/", "../../models/"))
        self.assertEqual(len(self.flat("world")["instances"]), 2)
        self.expect_complaint("'.' contains 5 files to choose from; name one, such as 'broken.smurfs'", ".")

    def test_quiet(self):
        self.assertEqual(len(self.flat("outer.smurfs", "-q")["instances"]), 1)

    def test_report(self):
        done = self.run_tool("outer.smurfs", "--report", "json=report.json")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        report = json.loads(self.read("report.json"))
        self.assertEqual([d["id"] for d in report["diagnostics"]], ["SML5201"])
        self.assertEqual(report["diagnostics"][0]["pointer"], "/entities/0/anchor")
        self.assertEqual(report["summary"]["scenes"], 2)


class Explain(FlattenTest):
    def test_chain(self):
        done = self.expect(0, "scene.smurfs", "--explain-pose", "B")
        lines = done.stdout.splitlines()
        self.assertEqual([line.split("  ")[0] for line in lines],
                         ["scene.smurfs:2:10", "models/box.urdf:5:16", "scene.smurfs:3:10",
                          "in the world"])
        self.assertIn("joint `glue`", lines[1])
        self.assertTrue(lines[-1].endswith("xyz 1 2 3.1  rpy 0 0 90 deg"), lines[-1])

    def test_unknown_instance(self):
        outer = cli.FIXTURES / "scenes/nested/outer.smurfs"
        self.expect_complaint("'cell' is an included scene; name one of its entities, such as 'cell/Table'",
                              outer, "--quiet", "--explain-pose", "cell")
        self.expect_complaint("the scene has no instance 'BB'; did you mean 'B'?",
                              "scene.smurfs", "--explain-pose", "BB")
        self.expect_complaint("the scene has no instance 'B::box'; name the instance alone, without a link: 'B'",
                              "scene.smurfs", "--explain-pose", "B::box")
        self.expect_complaint("the scene has no instance 'table'; its instances are A, B",
                              "scene.smurfs", "--explain-pose", "table")


    def test_a_reader_in_place_of_its_format(self):
        for reader, form in (("gazebo", "sdf"), ("MuJoCo", "mjcf"), ("isaac", "usda"), ("drake", "dmd")):
            done = self.expect(2, "scene.smurfs", "--format", reader)
            self.assertTrue(done.stderr.endswith(f"; did you mean '{form}'?\n"), done.stderr)


class Dialects(FlattenTest):
    SCENE = """entities:
- {name: A, file: models/box.urdf, position: [1, 2, 3], rotation: [0, 0, 0.7]}
- {name: B, file: models/box.urdf}
- {name: C, type: light, position: [0, 0, 4]}
"""

    def setUp(self):
        super().setUp()
        self.write("models/box.smurf", "modelname: box\nfiles: [box.urdf]\n")
        self.write("differ.smurfs", self.SCENE.replace(".urdf", ".smurf"))

    def compare(self, *arguments):
        done = self.run_tool(*arguments, "--compare-dialects", "--quiet")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def test_table(self):
        table = self.compare("differ.smurfs")
        self.assertLessEqual(max(map(len, table.splitlines())), 80)
        self.assertIn("2 of 3 entities differ between dialects (m, deg, in the world)", table)
        self.assertRegex(table, r"A\n  spec, mars, mars2 +1 +2 +3 +0 +0 +0\.7\n"
                                r"  phobos +1 +2 +3 +0 +0 +40\.107\n"
                                r"      39\.4 deg away: reads the angles as radians\n")
        self.assertNotIn("\nB\n", table)

    def test_the_same_to_all(self):
        self.write("same.smurfs", "entities:\n- {name: A, file: models/box.smurf}\n")
        self.assertEqual(self.compare("same.smurfs"),
                         "all dialects give every entity the same pose\n")

    def test_json(self):
        report = json.loads(self.compare("differ.smurfs", "--format", "json"))
        self.assertEqual(report["entities"], 3)
        a, c = report["different"]
        self.assertEqual((a["path"], a["source"]), ("A", {"file": "differ.smurfs", "line": 2}))
        self.assertEqual(a["readings"]["spec"]["position"], [1, 2, 3])
        self.assertAlmostEqual(a["readings"]["phobos"]["orientation"]["w"], math.cos(0.35))
        self.assertEqual([name for name, r in c["readings"].items() if r["is_loaded"]], ["spec"])

    def test_flatten_as_another_reader(self):
        done = self.run_tool("differ.smurfs", "--dialect", "mars2")
        self.assertEqual([i["name"] for i in json.loads(done.stdout)["instances"]], ["A", "B"])
        self.assertIn("warning[SML8208]", done.stderr)
        done = self.run_tool("differ.smurfs", "--dialect", "mars2", "--fail-on-loss")
        self.assertEqual((done.returncode, done.stdout), (1, ""))

    def test_findings_do_not_depend_on_the_dialect(self):
        spec, mars = (self.run_tool("outer.smurfs", "--dialect", name) for name in ("spec", "mars"))
        self.assertEqual(spec.stderr, mars.stderr)
        self.assertEqual(json.loads(spec.stdout)["instances"][0]["anchor"], "world")
        self.assertEqual(json.loads(mars.stdout)["instances"][0]["anchor"], "none")

    def test_explanations(self):
        def explain(dialect, name="A", scene="differ.smurfs"):
            done = self.run_tool(scene, "--explain-pose", name, "--dialect", dialect, "--quiet")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            return done.stdout.splitlines()
        self.assertEqual(explain("mars"), explain("spec"))
        *_, world, note = explain("phobos")
        self.assertTrue(world.endswith("xyz 1 2 3  rpy 0 0 40.1070457 deg"), world)
        self.assertEqual(note, "phobos reads the angles as radians")
        steps = explain("mars", "in/A", "outer.smurfs")
        self.assertEqual([s.split()[1] for s in steps[:2]], ["include", "entity"])
        self.assertEqual(steps[-1], "mars loses the anchor")
        self.expect_complaint("'C' is not in the scene of the dialect mars2, which stops at a `file` "
                              "that is not a .smurf, .smurfs or .yml",
                              "differ.smurfs", "--explain-pose", "C", "--dialect", "mars2", "--quiet")


OLD_XML = """<?xml version="1.0"?>
<SceneFile>
  <materiallist><material><id>1</id><name>red</name>
    <diffuseFront><r>1</r><g>0</g><b>0</b><a>1</a></diffuseFront></material></materiallist>
  <nodelist>
    <node name="a"><index>1</index><filename>PRIMITIVE</filename><origname>box</origname>
      <extend><x>1</x><y>2</y><z>3</z></extend><position><x>5</x><y>0</y><z>0</z></position>
      <material_id>1</material_id></node>
    <node name="b"><index>2</index><relativeid>1</relativeid><filename>PRIMITIVE</filename>
      <origname>sphere</origname><extend><x>0.5</x></extend>
      <position><x>0</x><y>0</y><z>1</z></position></node>
    <node name="c"><index>3</index><filename>rock.obj</filename></node>
  </nodelist>
  <lightlist><light><name>sun</name></light></lightlist>
</SceneFile>
"""
OLD_YAML = """
materiallist: [{id: 1, name: red, diffuseFront: {r: 1, g: 0, b: 0, a: 1}}]
nodelist:
- {name: a, index: 1, filename: PRIMITIVE, origname: box, extend: {x: 1, y: 2, z: 3},
   position: {x: 5, y: 0, z: 0}, material_id: 1}
- {name: b, index: 2, relativeid: 1, filename: PRIMITIVE, origname: sphere, extend: {x: 0.5},
   position: {x: 0, y: 0, z: 1}}
- {name: c, index: 3, filename: rock.obj}
lightlist: [{name: sun}]
"""


def archive(files):
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w", zipfile.ZIP_DEFLATED) as zipped:
        for name, text in files.items():
            zipped.writestr(name, text)
    return data.getvalue()


class Fixed(FlattenTest):
    def test_what_cannot_move_is_shown_as_fixed(self):
        part = "- {{name: {0}, type: primitive, geometry: {{type: {1}}}, extend: {{x: 1, y: 1, z: 1}}{2}}}\n"
        self.write("s.smurfs", "entities:\n" + part.format("falls", "box", ", anchor: world") +
                   part.format("stays", "box", ", movable: false") + part.format("floor", "plane", ""))
        dot = self.run_tool("s.smurfs", "--format", "dot").stdout
        self.assertEqual(re.findall(r'-> "(\w+)" \[label="(\w+)"', dot),
                         [("falls", "free"), ("stays", "fixed"), ("floor", "fixed")])
        svg = self.run_tool("s.smurfs", "--format", "svg").stdout
        self.assertEqual(sorted(set(re.findall(r"(\w+): primitive, ([\w ]+)", svg))),
                         [("falls", "free"), ("floor", "fixed to the world"), ("stays", "fixed to the world")])
        # Only a body that moves has a mass.
        usda = self.run_tool("s.smurfs", "--format", "usda").stdout
        self.assertEqual(usda.count("PhysicsRigidBodyAPI"), 1)

    def test_terrain_is_shown_as_fixed(self):
        shutil.copy(cli.FIXTURES / "scenes/terrain/heightmaps/terraces.png", self.folder / "t.png")
        self.write("old.yml", "nodelist: [{name: rock, index: 1, filename: PRIMITIVE, origname: box, extend: {x: 1, y: 1}}]\n")
        self.write("s.smurfs", "entities:\n- {name: hills, type: heightmap, file: t.png, width: 2.0, length: 2.0, height: 0.5}\n"
                   "- {name: rocks, file: old.yml}\n")
        dot = self.run_tool("s.smurfs", "--format", "dot").stdout
        self.assertEqual(re.findall(r'-> "(\w+)" \[label="(\w+)"', dot), [("hills", "fixed"), ("rocks", "fixed")])
        svg = self.run_tool("s.smurfs", "--format", "svg").stdout
        self.assertEqual(sorted(set(re.findall(r"(\w+): (?:heightmap|yml), ([\w ]+)", svg))),
                         [("hills", "fixed to the world"), ("rocks", "fixed to the world")])


class OldScenes(FlattenTest):
    def nodes(self, file, scene="entities:\n- {name: Old, file: FILE, position: [1, 0, 0]}\n"):
        self.write("old.smurfs", scene.replace("FILE", file))
        done = self.run_tool("old.smurfs", "--format", "gltf")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("the mesh", done.stderr)  # rock.obj, which glTF cannot name
        document = json.loads(done.stdout)
        entity = next(n for n in document["nodes"] if "extras" in n)
        return document, entity, [document["nodes"][i] for i in entity["children"]]

    def test_every_kind(self):
        self.write("old.yml", OLD_YAML)
        self.write("old.scene", OLD_XML)
        self.write("old.scn", archive({"old.scene": OLD_XML}))
        results = []
        for file in ("old.yml", "old.scene", "old.scn"):
            document, entity, (box, sphere) = self.nodes(file)
            self.assertEqual(entity["translation"], [1, 0, 0])  # only the node of index 1 exists
            self.assertNotIn("translation", box)
            self.assertEqual(box["scale"], [1, 2, 3])
            self.assertEqual(sphere["translation"], [0, 0, 1])
            self.assertEqual(document["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"],
                             [1, 0, 0, 1])
            results.append([box, sphere])
        self.assertEqual(results[0], results[1])
        self.assertEqual(results[0], results[2])

    def test_a_primitive_has_the_shape_of_its_physicmode(self):
        """As in MARS: `geometry` gives a box its size and place, and a cylinder nothing."""
        self.write("p.smurfs", "entities:\n"
                   "- {name: A, type: primitive, physicmode: cylinder, geometry: {type: cylinder}, extend: {x: 0.5, y: 2, z: 0}}\n"
                   "- {name: B, type: primitive, physicmode: box, extend: {x: 1, y: 2, z: 3}}\n")
        sdf = xml.etree.ElementTree.fromstring(self.run_tool("p.smurfs", "--format", "sdf").stdout)
        cylinder, box = sdf.findall(".//collision/geometry")
        self.assertEqual((cylinder.findtext("cylinder/radius"), cylinder.findtext("cylinder/length")), ("0.5", "2"))
        self.assertEqual(box.findtext("box/size"), "1 2 3")

    def test_every_missing_file_is_named(self):
        self.write("old.yml", "nodelist:\n- {name: a, index: 1, filename: a.obj}\n- {name: b, index: 2, filename: b.obj}\n"
                   "- {name: hill, index: 3, filename: terrain, t_srcname: h.png, t_width: 5, t_height: 5, t_scale: 1}\n")
        self.write("old.smurfs", "entities:\n- {name: Old, file: old.yml}\n")
        for format in ("mjcf", "gltf", "usda"):
            said = self.run_tool("old.smurfs", "--format", format).stderr
            for file in ("a.obj", "b.obj", "h.png" if format == "mjcf" else "the heightmap"):
                self.assertIn(file, said, format)
        self.assertIn("smurfs-flatten: 3 errors: see smurf-lint old.smurfs", self.run_tool("old.smurfs", "--format", "sdf").stderr)

    def test_heights(self):
        self.write("old/old.yml", "nodelist:\n"
                   "- {name: ground, index: 1, filename: terrain, physicmode: heightfield, t_srcname: t.png, t_width: 10,"
                   " t_height: 20, t_scale: 2}\n"
                   "- {name: hill, index: 2, filename: terrain, physicmode: terrain, t_srcname: t.png, t_width: 5, t_height: 5,"
                   " t_scale: 1, position: {x: 0, y: 9, z: 0}}\n")
        shutil.copy(cli.FIXTURES / "scenes/terrain/heightmaps/terraces.png", self.folder / "old/t.png")
        self.write("old.smurfs", "entities:\n- {name: Old, file: old/old.yml, position: [0, 0, 1]}\n")
        sdf = xml.etree.ElementTree.fromstring(self.run_tool("old.smurfs", "--format", "sdf").stdout)
        self.assertEqual([(map.findtext("uri"), map.findtext("size")) for map in sdf.findall(".//collision/geometry/heightmap")],
                         [("old/t.png", "20 10 2"), ("old/t.png", "5 5 1")])
        mjcf = xml.etree.ElementTree.fromstring(self.run_tool("old.smurfs", "--format", "mjcf").stdout)
        # The darkest pixel has a fifth of the height, the brightest four fifths.
        self.assertEqual([(field.get("name"), field.get("size").rsplit(" ", 1)[0]) for field in mjcf.findall("asset/hfield")],
                         [("Old", "10 5 1.2000000000000002"), ("Old/heights_1", "2.5 2.5 0.6000000000000001")])
        self.assertEqual([(geom.get("hfield"), geom.get("pos")) for geom in mjcf.findall("worldbody/geom")],
                         [("Old", "0 0 1.4"), ("Old/heights_1", "0 9 1.2")])

    def test_lights(self):
        self.write("old.yml", OLD_YAML)
        self.write("old.smurfs", "entities:\n- {name: Old, file: old.yml}\n")
        done = self.run_tool("old.smurfs", "--quiet")
        self.assertEqual(json.loads(done.stdout)["lights"], [{"name": "sun"}])

    def test_lights_shine_in_other_formats(self):
        light = ("lightlist: [{name: sun, type: 2, angle: 60, position: {x: 1, y: 2, z: 3},"
                 " diffuse: {r: 1, g: 0.5, b: 0, a: 1}}]\n")
        self.write("old.yml", OLD_YAML.replace("lightlist: [{name: sun}]\n", light))
        self.write("rock.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        self.write("old.smurfs", "entities:\n- {name: Old, file: old.yml}\n")
        sdf = xml.etree.ElementTree.fromstring(self.run_tool("old.smurfs", "--format", "sdf").stdout)
        light = sdf.find("world/light")
        self.assertEqual((light.get("name"), light.get("type"), light.findtext("diffuse")),
                         ("sun", "spot", "1 0.5 0 1"))
        self.assertTrue(light.findtext("pose").startswith("1 2 3"), light.findtext("pose"))
        done = self.run_tool("old.smurfs", "--format", "urdf")
        self.assertIn("1 light of `Old` is not in the URDF", done.stderr)
        # Flattened again, a light is still one light.
        self.write("flat.smurfs", self.run_tool("old.smurfs", "--format", "smurfs").stdout)
        self.assertEqual(len(self.flat("flat.smurfs")["lights"]), 1)

    def test_what_does_not_come_along_is_named(self):
        moving = OLD_YAML.replace("name: a,", "name: a, movable: true,").replace(
            "{name: c, index: 3, filename: rock.obj}", "{name: c, index: 3, movable: false}")
        self.write("old.yml", moving + "jointlist: [{index: 1}, {index: 2}]\nmotorlist: [{index: 1}]\n")
        self.write("old.smurfs", "entities:\n- {name: Old, file: old.yml}\n")
        done = self.run_tool("old.smurfs", "--format", "mjcf", "--report", "json")
        found = {(d["id"], d["message"]) for d in json.loads(done.stderr)["diagnostics"]}
        for loss in [("SML8209", "moving parts of `Old` stand still in the MJCF: `a`"),
                     ("SML8205", "the part of `Old` whose shape is not known, `c`, is not in the MJCF"),
                     ("SML8207", "more of `Old` is not in the MJCF: 2 joints, 1 motor")]:
            self.assertIn(loss, found)

    def test_broken(self):
        for data, reason in [(b"PK no", "is not a zip archive"),
                             (archive({"other.scene": OLD_XML}), "contains no `old.scene`"),
                             (archive({"../old.scene": OLD_XML}), "is not inside it")]:
            self.write("old.scn", data)
            self.write("old.smurfs", "entities:\n- {name: Old, file: old.scn}\n")
            done = self.run_tool("old.smurfs")
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertIn(reason, done.stderr)
            self.assertIn("old.smurfs:2:21", done.stderr)


class Archives(FlattenTest):
    FILES = {"scenes/all.smurfs": SCENE.replace("models/", "../models/"), "models/box.urdf": BOX}

    def test_a_scene_in_an_archive(self):
        self.write("all.zsmurfs", archive(self.FILES))
        flat = self.flat("all.zsmurfs")
        self.assertEqual([i["position"] for i in flat["instances"]], [[1, 2, 3], [1, 2, 3.1]])
        self.assertEqual(flat["scene"], "all.zsmurfs/scenes/all.smurfs")
        self.assertEqual([p.name for p in self.folder.iterdir() if "all" in p.name],
                         ["all.zsmurfs"])  # nothing was unpacked

    def test_mistakes(self):
        self.write("a.zsmurfs", b"no")
        self.expect_complaint("cannot read 'a.zsmurfs': it is not a zip archive", "a.zsmurfs")
        self.write("a.zsmurfs", archive({"x.smurf": ""}))
        self.expect_complaint("cannot read 'a.zsmurfs': it contains no .smurfs", "a.zsmurfs")
        self.write("a.zsmurfs", archive({"x.smurfs": "", "y.smurfs": ""}))
        self.expect_complaint("cannot read 'a.zsmurfs': it contains several .smurfs, none of which "
                              "has the name of the archive", "a.zsmurfs")


    def test_entities_in_archives(self):
        """A model, a scene, and an archive in an archive, each read in place."""
        model = archive({"box.smurf": "modelname: box\nfiles: [urdf/box.urdf]\n",
                         "urdf/box.urdf": BOX})
        self.write("parts/box.zsmurf", model)
        self.write("cell.zsmurfs", archive({
            "cell.smurfs": "entities:\n- {name: In, file: deep/box.zsmurf, position: [0, 0, 1]}\n",
            "deep/box.zsmurf": model}))
        self.write("top.smurfs", """entities:
- {name: A, file: parts/box.zsmurf, position: [1, 2, 3]}
- {name: B, type: zsmurf, file: parts/box.zsmurf, parent: 'A::lid'}
- {name: C, file: cell.zsmurfs, position: [5, 0, 0]}
""")
        flat = self.flat("top.smurfs", "--quiet")
        self.assertEqual({i["path"]: i["position"] for i in flat["instances"]},
                         {"A": [1, 2, 3], "B": [1, 2, 3.1], "C/In": [5, 0, 1]})
        self.assertEqual([m["urdf"] for m in flat["models"]],
                         ["parts/box.zsmurf/urdf/box.urdf",
                          "cell.zsmurfs/deep/box.zsmurf/urdf/box.urdf"])
        self.assertEqual(flat["instances"][2]["source"],
                         {"file": "cell.zsmurfs/cell.smurfs", "line": 2})
        done = self.run_tool("top.smurfs")
        self.assertEqual(done.stderr.count("[SML5011]"), 1, done.stderr)
        self.assertIn("3 more findings like this one: `A`, `B` and `C`", done.stderr)
        done = self.run_tool("top.smurfs", "--dialect", "mars", "--quiet")
        self.assertEqual(json.loads(done.stdout)["instances"], [])

    def test_what_is_wrong_inside_is_shown_inside(self):
        self.write("top.smurfs", "entities:\n- {name: A, file: box.zsmurf}\n")
        self.write("box.zsmurf", archive({"box.smurf": "modelname: box\nfiles: [box.urdf]\n",
                                          "box.urdf": BOX.replace('"fixed"', '"fixt"')}))
        done = self.run_tool("top.smurfs")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("--> box.zsmurf/box.urdf:", done.stderr)
        for content, reason in [(b"no", "it is not a zip archive"), (archive({"a": ""}), "it contains no .smurf")]:
            self.write("box.zsmurf", content)
            done = self.run_tool("top.smurfs")
            self.assertEqual(done.returncode, 1)
            self.assertIn(f"cannot read `box.zsmurf`: {reason}", done.stderr)
            self.assertNotIn("SML5011", done.stderr)
            self.assertIn("top.smurfs:2:19", done.stderr)
        (self.folder / "box.zsmurf").unlink()
        self.assertIn("there is no file `box.zsmurf`", self.run_tool("top.smurfs").stderr)

    def test_an_archive_of_itself_ends(self):
        """Each level names the enclosing archive."""
        self.write("a.zsmurfs", archive({"a.smurfs": "entities: [{name: A, file: ../a.zsmurfs}]\n"}))
        self.write("top.smurfs", "entities: [{name: T, file: a.zsmurfs}]\n")
        done = self.run_tool("top.smurfs")
        self.assertEqual(done.returncode, 1)
        self.assertIn("SML5020", done.stderr)


class Assets(FlattenTest):
    MESH = "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n" \
           "vertex 0 1 0\nendloop\nendfacet\nendsolid s\n"
    URDF = """<?xml version="1.0"?>
<robot name="r"><link name="l">
  <visual><geometry><mesh filename="MESH.stl"/></geometry></visual>
  <visual><geometry><mesh filename="more/MESH.stl"/></geometry></visual>
</link></robot>
"""

    def setUp(self):
        super().setUp()
        for folder in ("models/", "models/more/"):
            self.write(folder + "m.stl", self.MESH)
        self.write("models/r.urdf", self.URDF.replace("MESH", "m"))

    def meshes(self, output):
        return re.findall(r"<uri>(.*?)</uri>", self.read(output))

    def test_copies(self):
        done = self.run_tool("models/r.urdf", "--format", "sdf", "-o", "out/world.sdf",
                             "--copy-assets", "out/files", "--quiet")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(self.meshes("out/world.sdf"), ["files/r/m.stl", "files/r/2/m.stl"])
        for file in self.meshes("out/world.sdf"):
            self.assertEqual(self.read("out/" + file), self.MESH)

    def test_from_an_archive(self):
        self.write("r.zsmurf", archive({"r.smurf": "modelname: r\nfiles: [r.urdf]\n",
                                        "r.urdf": self.URDF.replace("MESH", "m"),
                                        "m.stl": self.MESH, "more/m.stl": self.MESH}))
        done = self.run_tool("r.zsmurf", "--format", "sdf", "-o", "out/world.sdf",
                             "--copy-assets", "out/files", "--quiet")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        for file in self.meshes("out/world.sdf"):
            self.assertEqual(self.read("out/" + file), self.MESH)
        # Without copies, a simulator finds no files; for reading, no copies are needed.
        loss = ("SML8210", "readers of the SDF do not look into the archive for "
                "`r.zsmurf/m.stl`, `r.zsmurf/more/m.stl`")
        self.assertIn(loss, self.found("r.zsmurf", "--format", "sdf"))
        self.assertIn(("SML8210", "readers of the SDF do not look into the archive for "
                       "`r.zsmurf/r.urdf`"),
                      self.found("r.zsmurf", "--format", "sdf", "--form", "reference"))
        for arguments in (["sdf", "--copy-assets", "out/files", "-o", "out/world.sdf"], ["gltf"]):
            self.assertNotIn("SML8210", dict(self.found("r.zsmurf", "--format", *arguments)))

    def found(self, *arguments):
        report = self.run_tool(*arguments, "--report", "json").stderr
        return [(d["id"], d["message"]) for d in json.loads(report)["diagnostics"]]

    def test_only_files_that_the_result_names_are_copied(self):
        self.write("models/t.png", "")
        self.write("models/seen.urdf", '<robot name="r"><link name="l"><visual><geometry><box size="1 1 1"/></geometry>'
                   '<material name="m"><texture filename="t.png"/></material></visual>'
                   '<visual><geometry><mesh filename="m.stl"/></geometry></visual></link></robot>')
        for output, copies in (("sdf", ["m.stl", "t.png"]), ("sdf1.6", ["m.stl"]), ("urdf", ["m.stl", "t.png"]),
                               ("dmd", []), ("gltf", []), ("usda", []), ("json", []), ("tsv", []), ("dot", []), ("svg", [])):
            with self.subTest(format=output):
                shutil.rmtree(self.folder / "out", ignore_errors=True)
                (self.folder / "out").mkdir()
                done = self.run_tool("models/seen.urdf", "--format", output, "-o", "out/world", "--copy-assets", "out/files")
                found = sorted(path.name for path in (self.folder / "out/files").rglob("*") if path.is_file())
                self.assertEqual(found, copies)
                self.assertEqual("names no files to copy" in done.stderr, not copies)

    def test_files_of_packages_are_named_by_their_copies(self):
        """The reader of the result need not know the package, and the path need not exist elsewhere."""
        self.write("models/package.xml", "<package><name>stuff</name></package>")
        for name in ("package://stuff/m.stl", str(self.folder / "models/m.stl"), (self.folder / "models/m.stl").as_uri()):
            self.write("models/r.urdf", '<robot name="r"><link name="l"><visual><geometry>'
                       f'<mesh filename="{name}"/></geometry></visual></link></robot>')
            for output, pattern in (("urdf", 'filename="(.*?)"'), ("sdf", "<uri>(.*?)</uri>")):
                shutil.rmtree(self.folder / "out", ignore_errors=True)
                done = self.run_tool("models/r.urdf", "--format", output, "-o", "out/world", "--copy-assets", "out/files")
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual(re.findall(pattern, self.read("out/world")), ["files/r/m.stl"], (name, output))
                self.assertEqual(self.read("out/files/r/m.stl"), self.MESH)

    def test_a_refused_scene_copies_nothing(self):
        done = self.run_tool("broken.smurfs", "--format", "sdf", "--copy-assets", "files")
        self.assertEqual(done.returncode, 1)
        self.assertFalse((self.folder / "files").exists())

    def files(self):
        return {str(path.relative_to(self.folder)): path.is_dir() or path.read_text()
                for path in self.folder.rglob("*")}

    def assert_untouched(self, *arguments):
        before = self.files()
        done = self.run_tool("models/r.urdf", "--format", "sdf", "--copy-assets", "out/files", "--quiet", *arguments)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(self.files(), before)

    def test_all_is_written_or_nothing(self):
        """Writing fails at the second copy, then at the scene itself."""
        self.write("out/files/r/2/m.stl/in the way", "")
        self.assert_untouched("--overwrite", "-o", "out/world.sdf")
        shutil.rmtree(self.folder / "out")
        self.assert_untouched("-o", "none/world.sdf")
        for place in ("m.stl", "2/m.stl"):
            self.write("out/files/r/" + place, "old")
        self.assert_untouched("--overwrite", "-o", "none/world.sdf")

    def test_a_file_of_many_names_is_one_file(self):
        for name in "ab":
            (self.folder / "models" / name).symlink_to(".")
        places = ["/".join("ab"[i >> bit & 1] for bit in range(4)) for i in range(16)]
        self.write("models/r.urdf", '<robot name="r"><link name="l">' + "".join(
            f'<visual><geometry><mesh filename="{place}/m.stl"/></geometry></visual>' for place in places)
            + "</link></robot>")
        for name, part in (("usda", "point3f[] points"), ("gltf", '"componentType": 5126')):
            text = self.run_tool("models/r.urdf", "--format", name, "--quiet").stdout
            self.assertEqual(text.count(part), 1, text)
        done = self.run_tool("models/r.urdf", "--format", "sdf", "-o", "out/world.sdf", "--copy-assets", "out/files",
                             "--quiet")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(self.meshes("out/world.sdf"), ["files/r/m.stl"] * 16)
        self.assertEqual([path.name for path in (self.folder / "out/files").rglob("*.stl")], ["m.stl"])

    def test_what_is_repeated_has_a_limit(self):
        self.write("models/m.stl", "solid s\n" + self.MESH.split("\n", 1)[1].rsplit("endsolid", 1)[0] * 1000
                   + "endsolid s\n")
        for name in "ab":
            self.write(f"models/{name}.urdf", self.URDF.replace("MESH", "m"))
        self.write("s.smurfs", "entities:\n" + "".join(
            f"- {{name: {name}, type: urdf, file: models/{name}.urdf}}\n" for name in "ab"))
        copy = ("s.smurfs", "--format", "sdf", "-o", "world.sdf", "--copy-assets", "files", "--quiet")
        done = self.run_tool(*copy, "--limit", "scene-bytes=50000")
        self.assertEqual(done.returncode, 2)
        self.assertIn("copies of files that are copied already have more than 50000 bytes; raise the limit with "
                      "`--limit scene-bytes=N`; nothing was written", done.stderr)
        self.assertFalse((self.folder / "files").exists())
        self.assertFalse((self.folder / "world.sdf").exists())
        self.assertEqual(self.run_tool(*copy).returncode, 0)
        for name in ("usda", "gltf", "obj"):
            done = self.run_tool("s.smurfs", "--format", name, "--limit", "scene-bytes=5000")
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertIn("SML5022", done.stderr)
            self.assertIn("with this mesh, the meshes written for the scene exceed 5000 bytes",
                          done.stderr)

    POINTS = struct.pack("<12f", 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1) + bytes([0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3])

    @staticmethod
    def gltf(buffer, *images):
        return json.dumps({
            "asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                          {"bufferView": 1, "componentType": 5121, "count": 12, "type": "SCALAR"}],
            "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
            "images": [{"uri": image} for image in images], "buffers": [{"byteLength": 60, "uri": buffer}]}, indent=1)

    COLLADA = ('<COLLADA version="1.4.1"><library_images><image id="i"><init_from> ../tex/a%20b.png </init_from></image>'
               '<image id="j"><init_from>file:///tmp/none.png</init_from></image></library_images></COLLADA>')

    def copy_neighbours(self, *options):
        """Copies meshes that name other files, and deletes the originals."""
        data = "data:image/png;base64,iVBORw0KGgo="
        self.write("models/a/m.gltf", self.gltf("in%20it.bin", "wood.png", "gone.png", data))
        self.write("models/b/m.gltf", self.gltf("in%20it.bin", "../a/wood.png"))
        self.write("models/b/m.dae", self.COLLADA)
        self.write("models/b/m.obj", "mtllib  colours.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                   "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")
        self.write("models/b/colours.mtl", "newmtl a\nmap_Kd wood.png\nmap_Ks ../a/wood.png\n")
        for name in ("a/in it.bin", "b/in it.bin"):
            (self.folder / "models" / name).write_bytes(self.POINTS)
        for name in ("a/wood.png", "b/wood.png", "tex/a b.png"):
            self.write("models/" + name, name)
        self.write("models/r.urdf", '<robot name="r"><link name="l">' + "".join(
            f'<visual><geometry><mesh filename="{mesh}"/></geometry></visual>'
            for mesh in ("a/m.gltf", "b/m.gltf", "b/m.dae", "b/m.obj")) + "</link></robot>")
        done = self.run_tool("models/r.urdf", "--format", "sdf", "-o", "out/world.sdf", "--copy-assets", "out/files", "--quiet",
                             *options)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return data

    def test_copies_of_the_files_that_meshes_name(self):
        data = self.copy_neighbours()
        copies = (self.folder / "out/files/r")
        self.assertEqual(sorted(str(path.relative_to(copies)) for path in copies.rglob("*") if path.is_file()),
                         ["2/in_it.bin", "2/m.gltf", "2/wood.png", "colours.mtl", "in_it.bin", "m.dae", "m.gltf", "m.obj",
                          "tex/a_b.png", "wood.png"])

        def uris(name, part):
            return [item["uri"] for item in json.loads(self.read("out/files/r/" + name))[part]]

        self.assertEqual(uris("m.gltf", "images"), ["wood.png", "gone.png", data])
        self.assertEqual(uris("m.gltf", "buffers"), ["in_it.bin"])
        self.assertEqual(uris("2/m.gltf", "images"), ["../wood.png"])
        self.assertEqual(self.read("out/files/r/m.dae"), self.COLLADA.replace("../tex/a%20b.png", "tex/a_b.png"))
        self.assertEqual(self.read("out/files/r/tex/a_b.png"), "tex/a b.png")
        self.assertEqual(self.read("out/files/r/colours.mtl"), "newmtl a\nmap_Kd 2/wood.png\nmap_Ks wood.png\n")
        self.assertEqual(self.read("out/files/r/2/wood.png"), "b/wood.png")

    def test_copies_are_read_without_their_originals(self):
        self.copy_neighbours()
        shutil.rmtree(self.folder / "models")
        meshes = [mesh for mesh in self.meshes("out/world.sdf") if not mesh.endswith(".dae")]
        self.write("out/copy.urdf", '<robot name="r"><link name="l">' + "".join(
            f'<visual><geometry><mesh filename="{mesh}"/></geometry></visual>' for mesh in meshes) + "</link></robot>")
        done = self.run_tool("copy.urdf", "--format", "usda", "--quiet", cwd=self.folder / "out")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout.count("int[] faceVertexCounts = [3, 3, 3, 3]"), 3, done.stdout)

    def test_second_run_finds_the_same_copies(self):
        for _ in range(2):
            self.copy_neighbours()

    def test_no_copy_of_what_lies_outside(self):
        """Files named by a mesh are only copied from places where a model may name files, and only images and buffers."""
        project = self.folder / "p/q/r"
        (project / ".git").mkdir(parents=True)
        self.write("secret.png", "secret")
        self.write("p/q/r/r.urdf", '<robot name="r"><link name="l"><visual><geometry><mesh filename="m.gltf"/></geometry>'
                   "</visual></link></robot>")
        (project / "m.bin").write_bytes(self.POINTS)
        (project / "link.png").symlink_to(self.folder / "secret.png")
        copy = ("r.urdf", "--format", "sdf", "-o", "w.sdf", "--copy-assets", "files", "--quiet")
        for image in ("../../../secret.png", "link.png"):
            (project / "m.gltf").write_text(self.gltf("m.bin", image))
            done = self.run_tool(*copy, cwd=project)
            self.assertEqual(done.returncode, 2)
            self.assertIn("it lies outside of the project", done.stderr)
            self.assertFalse((project / "files").exists())
        for image in (str(self.folder / "secret.png"), (self.folder / "secret.png").as_uri(), "http://host/a.png"):
            (project / "m.gltf").write_text(self.gltf("m.bin", image))
            self.assertEqual(self.run_tool(*copy, "--allow-outside", cwd=project).returncode, 0)
            self.assertEqual(json.loads((project / "files/r/m.gltf").read_text())["images"], [{"uri": image}])
            shutil.rmtree(project / "files")
        (project / "main.py").write_text("mine")
        (project / "m.gltf").write_text(self.gltf("m.bin", "main.py"))
        done = self.run_tool(*copy, cwd=project)
        self.assertIn("/main.py': its name is not that of a mesh or image; nothing was written", done.stderr)
        self.assertFalse((project / "files").exists())

    def test_material_libraries_that_name_each_other(self):
        self.write("models/m.obj", "mtllib m.obj\nmtllib n.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        self.write("models/n.mtl", "map_Kd n.mtl\nmap_Kd m.obj\n")
        self.write("models/r.urdf", '<robot name="r"><link name="l"><visual><geometry><mesh filename="m.obj"/></geometry></visual>'
                   "</link></robot>")
        done = self.run_tool("models/r.urdf", "--format", "sdf", "-o", "out/world.sdf", "--copy-assets", "out/files", "--quiet")
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_references_name_models_only(self):
        self.expect_complaint("--copy-assets copies the files that models name, and needs --form expand",
                              "scene.smurfs", "--form", "reference", "--copy-assets", "d",
                              "--format", "sdf")


class ColorsOfAnnotations(FlattenTest):
    """MARS merges `materials` over the materials of the URDF, and `materialName` of `visuals` replaces the name."""

    def setUp(self):
        super().setUp()
        visual = '<visual name="{0}"><geometry><box size="1 1 1"/></geometry><material name="{1}"/></visual>'
        self.write("r.urdf", '<robot name="r"><material name="a"><color rgba="1 0 0 1"/></material><material name="b">'
                   '<color rgba="0 0 1 1"/></material><link name="l">' + visual.format("one", "a") + visual.format("two", "b") +
                   visual.format("three", "b") + "</link></robot>")
        self.write("r.smurf", "modelname: r\nfiles: [r.urdf, r.yml]\n")
        self.write("r.yml", "materials:\n- {name: a, diffuseColor: {r: 0, g: 1, b: 0, a: 1}, transparency: 0.5, shininess: 2}\n"
                   "- {name: none, diffuseColor: {r: 0, g: 1, b: 0, a: 1}}\nvisuals:\n- {name: three, materialName: a}\n")

    def test_diffuse_colours(self):
        patterns = {"sdf": "<diffuse>(.*?)</diffuse>", "sdf1.6": "<diffuse>(.*?)</diffuse>", "mjcf": 'rgba="(.*?)"'}
        for name, pattern in patterns.items():
            done = self.run_tool("r.smurf", "--format", name, "--force")
            self.assertEqual(re.findall(pattern, done.stdout), ["0 1 0 0.5", "0 0 1 1", "0 1 0 0.5"], name)
        done = self.run_tool("r.smurf", "--format", "gltf", "--force")
        self.assertEqual([m["pbrMetallicRoughness"]["baseColorFactor"] for m in json.loads(done.stdout)["materials"]],
                         [[0, 1, 0, 0.5], [0, 0, 1, 1]])
        done = self.run_tool("r.smurf", "--format", "usda", "--force")
        self.assertEqual(re.findall(r"displayColor = \[\((.*?)\)\]", done.stdout), ["0, 1, 0", "0, 0, 1", "0, 1, 0"])

    def test_what_is_not_kept_is_named(self):
        for name in ("sdf", "mjcf", "gltf", "usda", "html"):
            done = self.run_tool("r.smurf", "--format", name, "-o", "out", "--force")
            if "cannot be written" not in done.stderr:  # the page was not built
                self.assertIn(": 1 material\n", done.stderr, name)
                self.assertIn("also lost: 1 material setting", done.stderr, name)
        for name in ("urdf", "dmd"):
            done = self.run_tool("r.smurf", "--format", name, "-o", "out", "--force")
            self.assertIn("2 materials\n", done.stderr, name)
            self.assertIn("also lost: 1 visual setting", done.stderr, name)


class MeshesWithNeighbours(FlattenTest):
    """A glTF file may have its points in another file, which is only read where the model may name files."""

    def mesh(self, uri):
        self.write("a/b/project/meshes/m.gltf", json.dumps({
            "asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
            "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36, "uri": str(uri)}]}))

    def flatten(self, *options):
        return self.run_tool("r.urdf", "--format", "gltf", *options, cwd=self.folder / "a/b/project").stderr

    def test_no_others_are_read(self):
        points = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)
        (self.folder / "a/b/project/.git").mkdir(parents=True)
        self.write("a/b/project/r.urdf", '<robot name="r"><link name="l"><visual><geometry><mesh filename="meshes/m.gltf"/>'
                   "</geometry></visual></link></robot>")
        for place in ("a/b/project/meshes/in it.bin", "a/b/project/beside.bin", "secret.bin"):
            path = self.folder / place
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(points)
        for uri in ("in%20it.bin", "../beside.bin"):
            self.mesh(uri)
            self.assertNotIn("is not in the glTF", self.flatten())
        self.mesh("../../../../secret.bin")
        self.assertIn("which cannot be read: it lies outside of the project", self.flatten())
        self.assertNotIn("is not in the glTF", self.flatten("--allow-outside"))
        (self.folder / "a/b/project/meshes/link.bin").symlink_to(self.folder / "secret.bin")
        self.mesh("link.bin")
        self.assertIn("which cannot be read: it lies outside of the project", self.flatten())
        for uri in (self.folder / "secret.bin", (self.folder / "secret.bin").as_uri()):
            self.mesh(uri)
            for options in ((), ("--allow-outside",)):
                self.assertIn("which is not a file beside it", self.flatten(*options))
        self.mesh("gone.bin")
        self.assertIn("has its points in `gone.bin`, which does not exist", self.flatten())


class NotFinite(FlattenTest):
    """Finite numbers for which poses, sizes or directions overflow."""
    URDF = """<?xml version="1.0"?>
<robot name="r">
  <link name="a">
    <visual><origin xyz="{xyz} 0 0" rpy="{rpy} 1 0"/><geometry><box size="{size} 1 1"/></geometry></visual>
    <visual><geometry><cylinder radius="{size}" length="{size}"/></geometry></visual>
    <visual><geometry><mesh filename="m.stl" scale="{size} {size} 1"/></geometry></visual>
    <inertial><mass value="{mass}"/><inertia ixx="{mass}" iyy="{mass}" izz="{mass}" ixy="0" ixz="0" iyz="0"/></inertial>
  </link>
  <link name="b"><inertial><mass value="{mass}"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="j" type="revolute"><parent link="a"/><child link="b"/><origin xyz="{xyz} 1 0" rpy="0 0 {rpy}"/>
    <axis xyz="{axis} {axis} 0"/><limit lower="-{limit}" upper="{limit}" effort="1" velocity="1"/></joint>
</robot>
"""
    SCENE = """entities:
- {{name: A, type: urdf, file: r.urdf, position: [{place}, 0, 0], rotation: [{angle}, 1, 0]}}
- {{name: B, type: urdf, file: r.urdf, parent: "A::b", position: [{place}, 1, 1], rotation: [0, {angle}, 0]}}
- {{name: C, type: primitive, geometry: {{type: sphere}}, extend: {{x: {extent}, y: {extent}, z: 1}}}}
physics: {{gravity: {{x: {gravity}, y: {gravity}, z: 0}}, stepsize: {step}}}
"""
    IN_URDF = ("xyz", "rpy", "size", "mass", "axis", "limit")
    IN_SCENE = ("place", "angle", "extent", "gravity", "step")
    RUNS = [("--links",), ("--dialect", "mars"), ("--dialect", "phobos"), ("--explain-pose", "B"), ("--compare-dialects",)]

    def test_no_result_has_one(self):
        self.write("m.stl", Assets.MESH.replace("vertex 1", "vertex 3e38"))
        usual = dict.fromkeys(self.IN_URDF + self.IN_SCENE, "1")
        runs = [("--format", name) for name in self.formats()] + self.RUNS
        for key in usual:
            for value in ("1e38", "1e308", "1.7e308", "1e-308", "5e-324", "1e400", "nan", "inf"):
                values = {**usual, key: value}
                self.write("r.urdf", self.URDF.format(**values))
                self.write("s.smurfs", self.SCENE.format(**values))
                for run in runs:
                    done = self.run_tool("s.smurfs", "--force", "--quiet", *run)
                    self.assertIn(done.returncode, (0, 1, 2))
                    if value not in ("nan", "inf", "1e400"):
                        found = re.search(r"(?<![\w.])[+-]?(nan|inf(inity)?)(?!\w)", done.stdout, re.IGNORECASE)
                        self.assertIsNone(found, (key, value, run, done.stdout))
                    elif done.returncode == 0 and "--explain-pose" not in run:
                        numbers = re.findall(r"(?<![\w.\"'])[+-]?(?:nan|inf(?:inity)?)(?![\w\"'])", done.stdout)
                        self.assertEqual(numbers, [], (key, value, run, done.stdout))


class NumbersOfAnnotations(FlattenTest):
    """Only URDFs and scenes were checked for numbers that are too large for computations."""
    URDF = ('<robot name="r"><link name="a"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'
            '</inertial><collision name="c"><geometry><box size="1 1 1"/></geometry></collision></link><link name="b"><inertial>'
            '<mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link><joint name="j" '
            'type="revolute"><parent link="a"/><child link="b"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint></robot>')
    ENTRIES = ("motors: [{{name: m, joint: j, type: PID, maxEffort: {0}, maxSpeed: 1, p: 2}}]",
               "motors: [{{name: m, joint: j, type: PID, maxEffort: 1, maxSpeed: {0}}}]",
               "motors: [{{name: m, joint: j, type: PID, maxEffort: 1, maxSpeed: 1, p: {0}}}]",
               "collision: [{{name: c, link: a, cfriction1: {0}}}]",
               "joint: [{{name: j, springDamping: {0}}}]",
               "sensors: [{{name: s, type: CameraSensor, link: a, width: {0}, opening_width: {0}}}]",
               "sensors: [{{name: s, type: CameraSensor, link: a, position_offset: {{x: {0}}}}}]",
               "sensors: [{{name: s, type: CameraSensor, link: a, orientation_offset: {{roll: {0}, pitch: {0}}}}}]",
               "sensors: [{{name: s, type: CameraSensor, link: a, orientation_offset: {{x: {0}, w: {0}}}}}]",
               "sensors: [{{name: s, type: RotatingRaySensor, link: a, horizontal_resolution: {0}, opening_height: {0}}}]",
               "sensors: [{{name: s, type: RotatingRaySensor, link: a, opening_width: {0}}}]",
               "sensors: [{{name: s, type: RaySensor, link: a, max_distance: {0}}}]",
               "sensors: [{{name: s, type: NodeIMU, link: a, rate: {0}}}]")

    def test_no_result_has_one(self):
        self.write("r.urdf", self.URDF)
        self.write("r.smurf", "modelname: r\nfiles: [r.urdf, r.yml]\n")
        export = [pathlib.Path(cli.TOOL).with_name("smurf2urdf"), "r.smurf", "--force", "--sensors", "gazebo", "--apply", "all"]
        for entry in self.ENTRIES:
            for value in (".nan", "-.inf", "1e308", "1e-320"):
                self.write("r.yml", entry.format(value) + "\n")
                runs = [("r.smurf", "--force", "--quiet", "--format", name) for name in ("mjcf", "sdf", "usda")]
                results = [self.run_tool(*run) for run in runs]
                results.append(subprocess.run(export, capture_output=True, text=True, cwd=self.folder, timeout=600, check=False))
                for done in results:
                    self.assertEqual(done.returncode, 0, (entry, value, done.stderr))
                    self.assertNotRegex(done.stdout, r"(?i)(?<![\w.])[+-]?(nan|inf(inity)?)(?!\w)", (entry, value))

    def test_colors_lie_between_0_and_1(self):
        visual = '<visual><geometry><box size="1 1 1"/></geometry><material name="m"><color rgba="0 0 1 1"/></material></visual></link>'
        self.write("r.urdf", self.URDF.replace("</link>", visual, 1))
        self.write("r.smurf", "modelname: r\nfiles: [r.urdf, r.yml]\n")
        for keys, expected in (("diffuseColor: {r: 204, g: -1, b: 0.5}", "1 0 0.5 1"), ("transparency: 1e308", "0 0 1 0"),
                               ("diffuseColor: {r: 1e308}, transparency: -2", "1 0 0 1")):
            self.write("r.yml", f"materials: [{{name: m, {keys}}}]\n")
            # libsdformat makes the colours of a URDF brighter: it divides them by 0.8.
            for form, pattern, color in (("sdf", "<diffuse>(.*?)</diffuse>", expected.replace("0.5", "0.625")),
                                         ("mjcf", 'rgba="(.*?)"', expected)):
                done = self.run_tool("r.smurf", "--force", "--quiet", "--format", form)
                self.assertIn(color, re.findall(pattern, done.stdout), (keys, form))

    def test_each_has_a_finding(self):
        """Except for limits, where the largest number means "no limit"."""
        self.write("r.urdf", self.URDF)
        self.write("r.smurf", "modelname: r\nfiles: [r.urdf, r.yml]\n")
        lint = [pathlib.Path(cli.TOOL).with_name("smurf-lint"), "r.smurf", "--select", "SML4003", "--format", "json"]
        for entry in self.ENTRIES:
            self.write("r.yml", entry.format("1e308") + "\n")
            done = subprocess.run(lint, capture_output=True, text=True, cwd=self.folder, timeout=600, check=False)
            found = json.loads(done.stdout)["diagnostics"]
            is_limit = "maxEffort: {0}" in entry or "maxSpeed: {0}" in entry
            self.assertEqual(len(found), 0 if is_limit else entry.count("{0}"), (entry, done.stdout))


class OfGazebo(FlattenTest):
    """Elements of <gazebo> are copied, or become other elements."""
    BODY = ('<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
            '<collision><geometry><box size="1 1 1"/></geometry></collision>'
            '<visual><geometry><box size="1 1 1"/></geometry></visual>')

    def written(self, elements, name, reference="a"):
        self.write("r.urdf", f'<robot name="r"><link name="a">{self.BODY}</link><link name="b">{self.BODY}</link>'
                   '<joint name="j" type="revolute"><parent link="a"/><child link="b"/><limit lower="-1" upper="1" '
                   f'effort="1" velocity="1"/></joint><gazebo reference="{reference}">{elements}</gazebo>'
                   f"<gazebo>{elements}</gazebo></robot>")
        self.write("s.smurfs", "entities:\n- {name: e, type: urdf, file: r.urdf}\n")
        return self.run_tool("s.smurfs", "--quiet", "--format", name, "--loss-report", "lost.json")

    def test_every_reader_takes_it_for_xml(self):
        parts = {"<x>&foo; &amp; &#65;</x>": "<x>&foo; & A</x>", "<x> ]]> ]]]]>> </x>": "<x> ]]> ]]]]>> </x>",
                 "<x>a\uffff\ufffe\ufffdb</x>": "<x>a\ufffd\ufffd\ufffdb</x>", '<x a="&b;]]>"/>': '<x a="&b;]]>" />',
                 "<x><![CDATA[&c;<]]></x>": "<x>&c;<</x>", "<x><!-- &d; --></x>": "<x />"}
        for part, expected in parts.items():
            for name in ("sdf", "sdf1.6", "urdf"):
                done = self.written(f'<plugin name="p" filename="q">{part}</plugin>', name)
                self.assertEqual(done.returncode, 0, done.stderr)
                found = list(xml.etree.ElementTree.fromstring(done.stdout).iter("x"))
                self.assertEqual(len(found), 2, done.stdout)
                for element in found:
                    element.tail = None
                    text = xml.etree.ElementTree.tostring(element, encoding="unicode")
                    self.assertEqual(text.replace("&amp;", "&").replace("&lt;", "<").replace("&gt;", ">"), expected)

    def test_values_of_another_type_are_lost(self):
        for reference, elements in (
                ("a", "<mu1>nan</mu1><mu2>inf</mu2><kp>-inf</kp><kd>Infinity</kd><maxVel>1e999</maxVel><minDepth>x</minDepth>"
                      "<fdir1>1 nan 0</fdir1><laserRetro>nan</laserRetro><maxContacts>inf</maxContacts>"
                      "<dampingFactor>nan</dampingFactor><selfCollide>nan</selfCollide>"),
                ("j", "<springStiffness>nan</springStiffness><springReference>inf</springReference><stopCfm>nan</stopCfm>"
                      "<stopErp>inf</stopErp><fudgeFactor>nan</fudgeFactor><provideFeedback>nan</provideFeedback>"
                      "<implicitSpringDamper>inf</implicitSpringDamper><cfmDamping>nan</cfmDamping>")):
            count = elements.count("</")
            done = self.written(elements, "sdf", reference)
            self.assertEqual(done.returncode, 0, done.stderr)
            own = done.stdout.replace(elements.replace("><", ">\n<"), "")
            own = re.sub(r"<(mu1|mu2|kp|kd|[a-z]+[A-Z]\w*|fdir1)>[^<]*</\1>", "", own)  # of the model as written
            self.assertIsNone(re.search(r">[^<]*\b(nan|inf|Infinity|1e999|x)\b[^<]*<", own), own)
            losses = json.loads(self.read("lost.json"))["losses"]
            self.assertTrue(any(f"{count} elements in <gazebo>" in loss["message"] or "elements in <gazebo>" in
                                loss["message"] for loss in losses), losses)


class Mistakes(FlattenTest):
    def test_unreadable(self):
        self.expect_complaint("cannot read 'none.smurfs': No such file or directory",
                              "none.smurfs")

    def test_unknown_words(self):
        for option in ["--format", "--dialect"]:
            done = self.expect(2, "scene.smurfs", option, "spek")
            self.assertEqual(done.stdout, "")
        self.assertEqual(self.expect(2, "scene.smurfs", "--format", "usd").stderr.count("did you mean 'usda'?"), 1)

    def test_loss_report(self):
        self.write("r.urdf", '<robot name="r"><link name="l"/><gazebo><static>true</static></gazebo></robot>')
        done = self.run_tool("r.urdf", "--format", "mjcf", "-o", "r.mjcf", "--loss-report", "lost.json")
        self.assertEqual(done.returncode, 0)
        losses = json.loads(self.read("lost.json"))["losses"]
        self.assertEqual([(loss["class"], loss["line"]) for loss in losses], [("lost-part", 1)])
        self.assertEqual(losses[0]["message"], "elements in <gazebo> (`static`) are not in the MJCF")

    def test_strict_refuses_what_a_urdf_loses(self):
        """Each part alone, because one loss is enough to refuse."""
        parts = {"<gazebo><plugin name='p' filename='p.so'/></gazebo>": ("mjcf", "gltf", "usda"),
                 "<gazebo reference='none'><mu1>1</mu1></gazebo>": ("sdf", "sdf1.6", "mjcf", "gltf", "usda"),
                 "<transmission name='t'/>": ("sdf", "sdf1.6", "mjcf", "gltf", "usda"),
                 "<own/>": ("sdf", "sdf1.6", "mjcf", "gltf", "usda")}
        for part, formats in parts.items():
            self.write("r.urdf", f'<robot name="r"><link name="l">{OfGazebo.BODY}</link>{part}</robot>')
            for form in ("sdf", "sdf1.6", "mjcf", "urdf", "gltf", "usda"):
                done = self.run_tool("r.urdf", "--format", form, "-o", "out", "--fail-on-loss", "--quiet")
                self.assertEqual(done.returncode, 1 if form in formats else 0, (part, form, done.stderr))

    def test_help(self):
        text = self.expect(0, "--help").stdout
        self.assertIn("sdf1.6, mjcf, urdf,", text)
        page = self.expect(0, "--format", "help").stdout.splitlines()
        self.assertIn("  dmd     Drake model directives", page)
        self.assertLessEqual(max(map(len, page)), 80)
        for option in ["--format", "--links", "--dialect", "--explain-pose", "--fail-on-loss", "--output"]:
            self.assertIn(option, text)


if __name__ == "__main__":
    cli.main()
