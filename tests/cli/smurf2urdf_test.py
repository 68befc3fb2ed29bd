# SPDX-License-Identifier: BSD-3-Clause
"""The command line of smurf2urdf: bytes, re-based paths, refusals, unchanged files."""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import unittest
import xml.parsers.expat as expat

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import cli  # noqa: E402

MESH_LINES = 3  # of the arm


class ExportTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        shutil.copytree(cli.FIXTURES / "models" / "arm", self.folder / "arm")

    def source(self):
        return self.read("arm/urdf/arm.urdf")

    def break_limit(self):
        self.write("arm/urdf/arm.urdf",
                   self.source().replace('lower="-0.4" upper="1.75"', 'lower="1.75" upper="-0.4"'))

    def break_type(self):
        """urdfdom refuses the file."""
        self.write("arm/urdf/arm.urdf", self.source().replace('type="revolute"', 'type="revolut"', 1))

    def run_with_messages(self, code, *arguments):
        done = self.run_tool(*arguments)
        self.assertEqual(done.returncode, code, done.stderr)
        return done


class Result(ExportTest):
    def test_beside_the_source_nothing_changes(self):
        self.expect(0, "arm/smurf/arm.smurf", "-o", "arm/urdf/copy.urdf")
        self.assertEqual(self.read("arm/urdf/copy.urdf"), self.source())

    def test_elsewhere_only_mesh_paths_change(self):
        (self.folder / "out" / "deep").mkdir(parents=True)
        self.expect(0, "arm/smurf/arm.smurf", "-o", "out/deep/arm.urdf")
        before, after = self.source().splitlines(), self.read("out/deep/arm.urdf").splitlines()
        changed = [(a, b) for a, b in zip(before, after) if a != b]
        self.assertEqual(len(before), len(after))
        self.assertEqual(len(changed), MESH_LINES)
        for old, new in changed:
            self.assertEqual(new, old.replace("../meshes/", "../../arm/meshes/"))
            mesh = new.split('"')[1]
            self.assertTrue((self.folder / "out" / "deep" / mesh).resolve().is_file(), mesh)

    def test_standard_output_is_the_current_folder(self):
        text = self.expect(0, "arm/smurf/arm.smurf").stdout
        self.assertIn('filename="arm/meshes/upper_arm.obj"', text)

    def test_absolute_output(self):
        target = self.folder / "out.urdf"
        self.expect(0, "arm/smurf/arm.smurf", "-o", target)
        self.assertIn('filename="arm/meshes/upper_arm.obj"', target.read_text())

    def test_twice_is_once(self):
        first = self.expect(0, "arm/smurf/arm.smurf").stdout
        self.write("first.urdf", first)
        self.assertEqual(self.expect(0, "first.urdf").stdout, first)

    def test_proof(self):
        done = self.run_with_messages(0, "arm/smurf/arm.smurf", "-o", "o.urdf", "--prove")
        self.assertIn("compared 10 links", done.stderr)
        self.assertIn("tinyxml2                    accepts", done.stderr)
        self.assertIn("urdfdom                     accepts", done.stderr)

    @unittest.skipUnless(shutil.which("check_urdf"), "check_urdf is not installed")
    def test_check_urdf_accepts(self):
        self.expect(0, "arm/smurf/arm.smurf", "-o", "o.urdf")
        done = subprocess.run(["check_urdf", "o.urdf"], cwd=self.folder, capture_output=True,
                              text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertNotIn("rror", done.stdout + done.stderr)


class Options(ExportTest):
    def change(self, section, old, new):
        path = f"arm/smurf/arm_{section}.yml"
        self.assertIn(old, self.read(path))
        self.write(path, self.read(path).replace(old, new))

    def export(self, *options):
        self.expect(0, "arm/smurf/arm.smurf", "-o", "arm/urdf/o.urdf", *options)
        return self.read("arm/urdf/o.urdf")

    def test_apply(self):
        self.change("motors", "maxEffort: 40.0", "maxEffort: 41.5")
        self.assertEqual(self.export("--apply", "materials,dynamics,mimic"), self.source())
        self.assertEqual(self.export("--apply", "limits"),
                         self.source().replace('effort="40"', 'effort="41.5"'))
        self.expect_complaint("--apply: 'limit' is not one of materials, limits, dynamics, mimic, "
                              "all; did you mean 'limits'?", "arm/smurf/arm.smurf", "--apply",
                              "limit")

    def test_applied_colours_are_proven_with_applied_mimics(self):
        self.change("materials", "diffuseColor: {r: 0.1, g: 0.3, b: 0.7",
                    "diffuseColor: {r: 0.1, g: 0.3, b: 0.5")
        changed = self.export("--apply", "all")
        self.assertIn('rgba="0.1 0.3 0.5 1"', changed)
        self.assertEqual(changed, self.export("--apply", "materials"))

    def test_everything_at_once_is_proven(self):
        done = self.run_with_messages(
            0, "arm/smurf/arm.smurf", "-o", "o.urdf", "--apply", "all", "--collapse-fixed",
            "--keep", "lidar", "--prefix", "left_", "--base", "fixed", "--comments", "strip",
            "--vendor", "strip", "--canonical", "--urdf-version", "1.0", "--prove")
        self.assertIn("urdfdom                     accepts", done.stderr)
        text = self.read("o.urdf")
        self.assertIn('<link name="left_lidar">', text)
        self.assertNotIn("tool_flange_mount", text)
        self.assertIn('filename="arm/meshes/upper_arm.obj"', text)

    def test_versions_that_urdfdom_does_not_know(self):
        self.assertIn('version="1.1"', self.export("--urdf-version", "1.1"))

    def test_what_a_preset_keeps(self):
        """MuJoCo reads its settings from an extension; their folders do not fit new paths."""
        self.write("arm/urdf/arm.urdf", self.source().replace(
            "</robot>", '  <mujoco><compiler meshdir="../meshes" strippath="true" discardvisual="true"/>'
            "</mujoco>\n</robot>"))
        self.assertIn('<mujoco><compiler strippath="false" discardvisual="true"/></mujoco>',
                      self.export("--preset", "mujoco"))
        self.assertIn('<mujoco><compiler meshdir="../meshes" strippath="true" discardvisual="true"/>',
                      self.export("--settings", "mujoco"))

    def test_packages(self):
        self.leave_repository()
        self.assertIn('filename="package://arm_description/meshes/upper_arm.obj"',
                      self.export("--mesh-uri", "package", "--package-name", "arm_description"))
        (self.folder / "other").mkdir()
        done = self.run_with_messages(1, "arm/smurf/arm.smurf", "--mesh-uri", "package",
                                      "--package-name", "x", "--package", "x=other")
        self.assertIn("outside of the package's folder", done.stderr)
        self.expect_complaint("--mesh-uri package needs --package-name", "arm/smurf/arm.smurf",
                              "--mesh-uri", "package")

    def test_keep_must_name_something(self):
        done = self.run_with_messages(1, "arm/smurf/arm.smurf", "--collapse-fixed", "--keep",
                                      "lider")
        self.assertIn("has no link or joint `lider` to keep; did you mean 'lidar'?", done.stderr)
        self.expect_complaint("--keep needs --collapse-fixed", "arm/smurf/arm.smurf",
                              "--keep", "lidar")

    def test_what_mujoco_refuses_is_no_preset_of_mujoco(self):
        self.write("m.dae", "<COLLADA/>")
        body = ('<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>'
                "</inertial>")
        self.write("r.urdf", f'<robot name="r"><link name="l">{body}<collision><geometry>'
                   '<mesh filename="m.dae"/></geometry></collision></link></robot>')
        self.assertEqual(self.run_tool("r.urdf", "-o", "out.urdf").returncode, 0)
        done = self.run_tool("r.urdf", "--preset", "mujoco", "-o", "mujoco.urdf")
        self.assertEqual(done.returncode, 1)
        self.assertIn("cannot be converted: MuJoCo refuses the file (SML1644 at ", done.stderr)
        self.assertFalse((self.folder / "mujoco.urdf").exists())
        self.write("p.urdf", self.read("r.urdf").replace("m.dae", "package://nowhere/m.stl"))
        done = self.run_tool("p.urdf", "--preset", "mujoco", "-o", "mujoco.urdf")
        self.assertEqual(done.returncode, 1)
        self.assertIn("treats `package://` as a part of the path", done.stderr)
        self.write("d.urdf", self.read("r.urdf").replace("m.dae", "nothing/m.stl").replace(
            "<link", '<mujoco><compiler meshdir="nothing"/></mujoco><link'))
        self.assertEqual(self.run_tool("d.urdf", "--preset", "mujoco", "-o", "mujoco.urdf").returncode, 1)
        done = self.run_tool("r.urdf", "--preset", "mujoco", "--force", "-o", "mujoco.urdf")
        self.assertEqual(done.returncode, 0)

    def test_meshes_for_a_reader_of_few_formats(self):
        """Drake makes convex hulls of OBJ, VTK and glTF only, and MuJoCo reads no ASCII STL."""
        corners = ("0 0 0", "1 0 0", "0 1 0", "0 0 1")
        faces = "".join("facet normal 0 0 0 outer loop " + "".join(f"vertex {corners[i]} " for i in face) +
                        "endloop endfacet\n" for face in ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)))
        self.write("part.stl", f"solid part\n{faces}endsolid part\n")
        body = ('<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>')
        self.write("r.urdf", f'<robot name="r"><link name="l">{body}<collision><geometry>'
                   '<mesh filename="part.stl"/></geometry></collision></link></robot>')
        for preset in ("drake", "mujoco", "pybullet"):
            done = self.run_tool("r.urdf", "--preset", preset, "-o", f"{preset}.urdf")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(f"copied as OBJ: 1 mesh to {preset}_meshes", done.stderr)
            self.assertIn(f'filename="{preset}_meshes/part.obj"', self.read(f"{preset}.urdf"))
            self.assertEqual(self.read(f"{preset}_meshes/part.obj").count("\nf "), 4)
        done = self.run_tool("r.urdf", "--preset", "drake")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("with -o FILE, meshes are copied", done.stderr)

    def test_what_moves_without_mass_is_no_preset_of_mujoco(self):
        self.write("r.urdf", '<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="continuous">'
                   '<parent link="a"/><child link="b"/><axis xyz="0 0 1"/></joint></robot>')
        self.run_with_messages(0, "r.urdf", "-o", "plain.urdf")
        done = self.run_with_messages(1, "r.urdf", "--preset", "mujoco", "-o", "mujoco.urdf")
        self.assertIn("cannot be converted: MuJoCo refuses a moving body without mass or collision", done.stderr)
        self.assertFalse((self.folder / "mujoco.urdf").exists())

    def test_the_preset_of_gazebo_has_the_sensors_of_gazebo(self):
        self.assertNotIn("<sensor", self.source())
        found = re.findall('<sensor name="(.*?)" type="(.*?)">', self.export("--preset", "gazebo"))
        self.assertEqual(dict(found), {"tool_force": "force_torque", "hand_imu": "imu", "finger_contact": "contact",
                                       "flange_camera": "camera", "lidar_scan": "gpu_lidar"})

    def test_losses(self):
        self.change("motors", "maxEffort: 40.0", "maxEffort: 41.5")
        self.export("--loss-report", "lost.json")
        losses = json.loads(self.read("lost.json"))["losses"]
        classes = {loss["pointer"]: loss["class"] for loss in losses}
        self.assertEqual(classes["/motors/0/p"], "not-expressible")
        self.assertEqual(classes["/motors/0/maxEffort"], "not-requested")
        self.assertNotIn("/motors/0/maxSpeed", classes)
        self.assertEqual(classes["/sensors/0"], "not-expressible")
        self.assertEqual(classes["/sensors/8"], "not-requested")
        self.assertTrue(all(loss["file"].startswith("arm/smurf/arm_") for loss in losses))
        done = self.run_with_messages(1, "arm/smurf/arm.smurf", "-o", "o.urdf", "--fail-on-loss")
        self.assertIn("SML8002", done.stderr)
        self.assertIn("has losses; nothing was written", done.stderr)
        self.assertFalse((self.folder / "o.urdf").exists())
        self.expect(0, "arm/urdf/arm.urdf", "-o", "o.urdf", "--fail-on-loss")

    def test_presets_are_the_options_that_they_show(self):
        for preset in ("ros2", "gazebo", "mujoco", "pybullet", "drake"):
            options = self.expect(0, "--show-preset", preset).stdout.split()
            meshes = re.compile(r'filename="[^"]*/(\w+)\.(stl|obj|dae)"')  # Drake gets copies as OBJ
            self.assertEqual(meshes.sub(r"\1", self.export("--preset", preset)), meshes.sub(r"\1", self.export(*options)))
        self.assertIn("<ros2_control", self.export("--preset", "ros2"))
        self.assertNotIn("<ros2_control",
                         self.export("--preset", "ros2", "--actuation", "none"))

    def test_a_motor_without_speed_is_converted(self):
        """A wheel has no velocity limit, so urdf2smurf writes such motors."""
        self.write("wheel.urdf", '<robot name="w"><link name="a"/><link name="b"/><joint name="j" type="continuous">'
                   '<parent link="a"/><child link="b"/></joint></robot>')
        self.write("wheel.smurf", "modelname: w\nfiles: [wheel.urdf, motors.yml]\n")
        self.write("motors.yml", "motors: [{name: j, joint: j, type: PID, p: 10, maxEffort: 1}]\n")
        self.assertIn('<ros2_control name="w"', self.run_with_messages(0, "wheel.smurf", "--preset", "ros2").stdout)

    def test_srdf(self):
        self.export("--srdf", "arm.srdf", "--prefix", "l_", "--loss-report", "lost.json")
        text = self.read("arm.srdf")
        self.assertIn('  <group_state name="home" group="all">\n'
                      '    <joint name="l_joint1_waist" value="0"/>\n', text)
        self.assertIn('<disable_collisions link1="l_pedestal" link2="l_turret" '
                      'reason="Adjacent"/>', text)
        self.assertNotIn("Never", text)
        self.assertNotIn("bitmask", self.read("lost.json"))
        self.change("collision", "link: hand, bitmask: 32769", "link: hand, bitmask: 32772")
        self.export("--srdf", "arm.srdf")
        self.assertIn('link2="hand" reason="Never"/>', self.read("arm.srdf").replace(
            'link1="hand" link2="', 'link2="hand" reason="Never"/> link2="'))
        self.expect_complaint("--srdf needs a separate file", "arm/smurf/arm.smurf", "--srdf",
                              "-")

    def test_dry_run(self):
        self.assertEqual(self.expect(0, "arm/smurf/arm.smurf", "--dry-run").stdout, "")


class Dialects(cli.CliTest):
    def test_models_of_old_and_new_phobos_are_the_same_robot(self):
        """SMURF of Phobos 0.7 and 2 differs in sections, keys and notation, not in the URDF."""
        texts = []
        for model in ("arm", "arm_phobos2"):
            shutil.copytree(cli.FIXTURES / "models" / model, self.folder / model / "robot")
            done = self.run_tool("robot/smurf/arm.smurf", "--apply", "all", "--canonical",
                                 "--actuation", "ros2_control", cwd=self.folder / model)
            self.assertEqual(done.returncode, 0, done.stderr)
            texts.append(done.stdout)
        self.assertEqual(*texts)


class Refusal(ExportTest):
    LOSS = "every URDF reader refuses the joint type, and the file"

    def test_what_is_no_xml(self):
        for text in ('<robot name="r"><link name="b\x1b[31m"/></robot>', '<robot name="r"><!x><link name="b"/></robot>',
                     '<robot name="r"><link name="b"/></robot></x>'):
            self.write("a.urdf", text)
            done = self.run_with_messages(1, "a.urdf")
            self.assertEqual(done.stdout, "")
            self.assertIn("the result would not be XML", done.stderr)
            self.assertEqual(self.run_with_messages(0, "--force", "a.urdf").stdout, text)

    def test_prefixes_without_a_declaration(self):
        robot = '<robot name="r"{}><link name="b"/>{}</robot>'
        for element, prefix in (("<drake:joint/>", "drake"), ('<x drake:a="1"/>', "drake"), ("<xacro:wheel/>", "xacro"),
                                ("<gazebo><xi:include/></gazebo>", "xi")):
            self.write("a.urdf", robot.format("", element))
            done = self.run_with_messages(1, "a.urdf")
            self.assertEqual(done.stdout, "")
            self.assertIn(f"because the prefix `{prefix}` is not declared; declare it, `<robot xmlns:{prefix}=\"...\">`, or remove such "
                          "elements; see --force; nothing was written", done.stderr)
            self.run_with_messages(0, "--force", "a.urdf")
            declared = robot.format(f' xmlns:{prefix}="http://x"', element)
            self.write("a.urdf", declared)
            self.assertEqual(self.run_with_messages(0, "--force", "a.urdf").stdout, declared)
            expat.ParserCreate(namespace_separator=" ").Parse(declared.encode(), True)
        self.write("a.urdf", robot.format("", "<gazebo><xi:include/></gazebo>"))
        self.run_with_messages(0, "--vendor", "strip", "a.urdf")  # what is removed needs no declaration

    def test_numbers_that_are_not_finite(self):
        for number in ("nan", "inf", "-Infinity"):
            self.write("a.urdf", f'<robot name="r"><link name="b"><inertial><mass value="{number}"/>'
                                 '<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link></robot>')
            done = self.run_with_messages(1, "a.urdf")
            self.assertEqual(done.stdout, "")
            self.assertIn("the result would contain a number that is not finite", done.stderr)

    def test_what_only_readers_of_urdf_accept_becomes_xml_for_all(self):
        for text, xml in (('<robot name="a & b"><link name="x&y"/></robot>', '<robot name="a &amp; b"><link name="x&amp;y"/></robot>'),
                          ('<robot name="a<b"><link name="b"/></robot>', '<robot name="a&lt;b"><link name="b"/></robot>'),
                          ('<robot name="a"version="1.0"><link name="b"/></robot>', '<robot name="a" version="1.0"><link name="b"/></robot>')):
            self.write("a.urdf", text)
            self.assertEqual(self.run_with_messages(0, "a.urdf").stdout, xml)
            self.assertEqual(self.run_with_messages(0, "--prefix", "p_", "a.urdf").stdout,
                             xml.replace('link name="', 'link name="p_'))

    def test_comments_and_declarations_become_xml_for_all(self):
        robot, other = '<robot name="r"><link name="b"/>{}</robot>', '<robot name="r">{}<link name="b"/></robot>'
        declaration = '<?xml version="1.0" encoding="UTF-8"?>'
        for text, xml in ((robot.format("<!-- a -- b -->"), robot.format("<!-- a - - b -->")),
                          (robot.format("<!------ a --->"), robot.format("<!--- - - - a - -->")),
                          (robot.format("<!-- & <!-- ]]> -->"), robot.format("<!-- & <!- - ]]> -->")),
                          ("<!----->" + other.format("<!---->"), "<!--- -->" + other.format("<!---->")),
                          ('\n <?xml version="1.0"?>' + other, '<?xml version="1.0"?>' + other),
                          ('\ufeff\n<?xml version="1.0"?>' + other, '\ufeff<?xml version="1.0"?>' + other),
                          ('<?xml version="1.0"?><?xml version="1.0"?>' + other, '<?xml version="1.0"?>' + other),
                          ("<?XML version='1.0'?>" + other, declaration + other),
                          ('<?xml encoding="utf-8" version="1.0"?>' + other, declaration + other),
                          ('<?xml encoding="utf-8"?>' + other, declaration + other),
                          ("<?xml?>" + other, declaration + other),
                          ('<?xml version="1.0" standalone="maybe"?>' + other, declaration + other),
                          ('<?xml version="1.0" encoding="ANSI"?>' + other, declaration + other),
                          ('<?xml version="1.0" encoding="us-ascii"?>' + robot.format("<!-- \u00e9 -->"),
                           declaration + robot.format("<!-- \u00e9 -->")),
                          (robot.format("<x>]]> &nbsp; \uffff</x>"), robot.format("<x>]]&gt; &amp;nbsp; \ufffd</x>"))):
            self.write("a.urdf", text.replace("{}", ""))
            done = self.run_with_messages(0, "a.urdf")
            self.assertEqual(done.stdout, xml.replace("{}", ""))
            expat.ParserCreate().Parse(done.stdout.encode(), True)

    def test_what_is_xml_for_all_stays(self):
        robot = '<robot name="r\u00e9"><link name="b"/><!-- - a - b- --><x><![CDATA[--&]]></x><!----></robot>'
        for prolog in ("<?xml version='1.1' encoding='utf-8' standalone = 'yes' ?>", '<?xml version="1.0"\n?><?x --&?>',
                       '<!DOCTYPE robot><!-- \u00e9 -->', '<?xml version="1.0" encoding="ISO-8859-15"?>', "<?x-a b?>"):
            self.write("a.urdf", prolog + robot)
            self.assertEqual(self.run_with_messages(0, "a.urdf").stdout, prolog + robot)

    def test_what_has_no_repair_is_refused(self):
        for text, why in (('<robot name="r"><link name="b"/><a\u00d7/></robot>', "XML does not allow the name `a\u00d7`"),
                          ('<robot name="r"><link name="b"/><a \u00d7="1"/></robot>', "XML does not allow the name `\u00d7`"),
                          ('<robot name="r"><link name="b"/><a \u00b7="1"/></robot>', "XML does not allow the name `\u00b7`"),
                          ('<!DOCTYPE a><!DOCTYPE b><robot name="r"><link name="b"/></robot>', "XML allows one document type")):
            self.write("a.urdf", text)
            done = self.run_with_messages(1, "a.urdf")
            self.assertEqual(done.stdout, "")
            self.assertIn(f"cannot be converted: the result would not be XML: {why}; see --force", done.stderr)
            self.assertEqual(self.run_with_messages(0, "--force", "a.urdf").stdout, text)
        self.write("a.urdf", '<robot name="r"><link name="b"/><a\u00e9\u00b7\u4e2d/></robot>')
        self.run_with_messages(0, "a.urdf")

    def test_what_does_not_load_is_refused_and_the_old_file_kept(self):
        self.break_type()
        self.write("o.urdf", "the old file")
        done = self.run_with_messages(1, "arm/smurf/arm.smurf", "-o", "o.urdf")
        self.assertIn("error[SML1401]", done.stderr)
        self.assertIn(f"= note: not converted: {self.LOSS}\n", done.stderr)
        self.assertTrue(done.stderr.endswith(f"smurf2urdf: 'arm/smurf/arm.smurf' cannot be converted: {self.LOSS}; "
                                             "see --force; nothing was written\n"), done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertEqual(self.read("o.urdf"), "the old file")

    def test_other_errors_are_counted(self):
        """The limits of a joint are the same in the URDF, whether they are correct or not."""
        self.break_limit()
        done = self.run_with_messages(0, "arm/smurf/arm.smurf", "-o", "arm/urdf/o.urdf", "--prove")
        self.assertEqual(self.read("arm/urdf/o.urdf"), self.source())
        self.assertRegex(done.stderr, r"\Asmurf2urdf: [1-9] errors?( and [1-9] warnings?)?: see smurf-lint "
                                      r"arm/smurf/arm.smurf\ncompared")
        self.assertIn("urdfdom                     accepts", done.stderr)
        done = self.run_with_messages(0, "arm/smurf/arm.smurf", "-o", "arm/urdf/o.urdf", "--report", "concise")
        self.assertIn("SML1407", done.stderr)
        self.write("arm/urdf/arm.xml", self.source())  # smurf-lint needs the name of a URDF
        done = self.run_with_messages(0, "arm/urdf/arm.xml", "-o", "arm/urdf/o.urdf")
        self.assertIn(": see smurf-lint --stdin-filename arm/urdf/arm.urdf - < arm/urdf/arm.xml\n", done.stderr)
        done = self.run_with_messages(1, "arm/smurf/arm.smurf", "--fail-on", "error")
        self.assertIn("has findings that reach --fail-on; see --force; nothing was written", done.stderr)

    def test_annotations_matter_when_they_are_taken_over(self):
        path = "arm/smurf/arm_motors.yml"
        self.write(path, self.read(path).replace("maxEffort: 40.0", "maxEffort: 40 Nm"))
        self.run_with_messages(0, "arm/smurf/arm.smurf")
        self.run_with_messages(0, "arm/smurf/arm.smurf", "--apply", "materials,dynamics")
        for options in (("--apply", "limits"), ("--actuation", "ros2_control")):
            done = self.run_with_messages(1, "arm/smurf/arm.smurf", *options)
            self.assertIn("cannot be converted: the options need annotations that have errors; see --force",
                          done.stderr)

    def test_values_matter_when_they_are_computed_with(self):
        self.write("arm/urdf/arm.urdf", self.source().replace('<mass value="', '<mass value="kg', 1))
        done = self.run_with_messages(0, "arm/smurf/arm.smurf", "-o", "arm/urdf/o.urdf")
        self.assertEqual(self.read("arm/urdf/o.urdf"), self.source())
        done = self.run_with_messages(1, "arm/smurf/arm.smurf", "--collapse-fixed")
        self.assertIn("cannot be converted: the options need a value that cannot be read", done.stderr)

    def test_force(self):
        self.break_type()
        done = self.run_with_messages(0, "arm/smurf/arm.smurf", "-o", "arm/urdf/o.urdf", "--force")
        self.assertEqual(self.read("arm/urdf/o.urdf"), self.source())
        self.assertIn("= note: converted because of --force, although ", done.stderr)

    def test_what_the_linter_is_told_to_let_pass(self):
        self.write("arm/urdf/arm.urdf", self.source().replace("<robot", "<!-- 100% -->\n<robot", 1))
        self.break_type()
        self.write(".smurf-lint.yaml", "ignore: [SML1401]\n")
        self.run_with_messages(0, "arm/smurf/arm.smurf", "-o", "arm/urdf/o.urdf")
        (self.folder / ".smurf-lint.yaml").unlink()
        comment = "<!-- smurf-lint: ignore-file[SML1401] the arm is bolted down -->"
        self.write("arm/urdf/arm.urdf", self.source().replace("</robot>", comment + "</robot>"))
        self.run_with_messages(0, "arm/smurf/arm.smurf", "-o", "arm/urdf/o.urdf")
        self.assertEqual(self.read("arm/urdf/o.urdf"), self.source())

    def test_what_is_no_urdf_is_never_written(self):
        self.write("arm/urdf/arm.urdf", "<robot name='a'>")
        done = self.run_with_messages(1, "arm/smurf/arm.smurf", "-o", "o.urdf", "--force")
        self.assertIn("SML1001", done.stderr)
        self.assertFalse((self.folder / "o.urdf").exists())

    def test_unreadable(self):
        self.expect_complaint("cannot read 'no.smurf': No such file or directory", "no.smurf")
        self.expect_complaint("no input file; see --help")

    def test_a_scene(self):
        self.write("hall.smurfs", "entities: []\n")
        self.expect_complaint("'hall.smurfs' is a scene; smurfs-flatten --format urdf exports it", "hall.smurfs")
        self.expect_complaint("'hall.smurfs' is a scene; smurfs-flatten --format urdf exports it", "-",
                              "--stdin-filename", "hall.smurfs", stdin="entities: []\n")

    def test_xacro(self):
        self.write("arm.urdf.xacro", '<robot name="$(arg name)" xmlns:xacro="x"><link name="${1 + 1}a"/></robot>')
        done = self.run_tool("arm.urdf.xacro", "name:=left")
        self.assertEqual(done.stdout, '<?xml version="1.0" ?>\n<robot name="left">\n  <link name="2a"/>\n</robot>\n')
        self.run_tool("arm.urdf.xacro", "name:=left", "--canonical", "-o", "arm.urdf")
        self.assertIn('<link name="2a"', self.read("arm.urdf"))
        done = self.run_with_messages(1, "arm.urdf.xacro")
        self.assertIn("error[SML3313]: the argument `name` has no value here", done.stderr)
        self.assertEqual(done.stdout, "")

    def test_comments_before_elements_of_xacro_go(self):
        """As xacro 2.1.1 does: but those stay that another element expands to, or that an empty line parts."""
        self.write("a.urdf.xacro", """<robot name="a" xmlns:xacro="x">
  <!-- kept -->

  <!-- gone -->
  <xacro:macro name="link" params="name"><!-- of a link --><link name="${name}"/><!-- after it --></xacro:macro>
  <!-- gone -->
  <xacro:if value="true"><!-- of if --></xacro:if>
  <!-- gone -->
  <xacro:link name="b"/>
  <xacro:link name="c"/>
  <!-- gone -->
  <xacro:include filename="b.xacro"/>
</robot>""")
        self.write("b.xacro", '<robot xmlns:xacro="x"><!-- of a file --></robot>')
        comments = re.findall("<!-- (.*?) -->", self.expect(0, "a.urdf.xacro").stdout)
        self.assertEqual(comments, ["kept", "of if", "of a link", "after it", "of a link", "after it", "of a file"])

    def test_packages_of_one_name(self):
        """Taken is the one that is nested least; of several, the one whose folder has its name."""
        self.write("robots/a.urdf.xacro", """<robot name="a" xmlns:xacro="x">
  <xacro:include filename="$(find parts)/p.xacro"/>
</robot>""")

        def taken_with(folder):
            self.write(folder + "/package.xml", "<package><name>parts</name></package>")
            self.write(folder + "/p.xacro", f'<robot xmlns:xacro="x"><link name="of:{folder}"/></robot>')
            return re.search('link name="of:(.*?)"', self.expect(0, "robots/a.urdf.xacro").stdout)[1]
        self.assertEqual(taken_with("x/y/z/w"), "x/y/z/w")
        self.assertEqual(taken_with("with_a_long_name/copies"), "with_a_long_name/copies")
        self.assertEqual(taken_with("others/and_a_longer_name"), "with_a_long_name/copies")
        self.assertEqual(taken_with("with_a_very_long_name/parts"), "with_a_very_long_name/parts")

    def test_limits_of_xacro(self):
        self.write("a.urdf.xacro", '<robot name="a" xmlns:xacro="x"><link name="${\'a\' * 100}"/></robot>')
        self.run_tool("a.urdf.xacro")
        done = self.run_with_messages(1, "a.urdf.xacro", "--limit", "xacro-text-bytes=99")
        self.assertIn("error[SML3312]: the text has more than 99 bytes", done.stderr)
        self.assertIn("--limit xacro-text-bytes=N", done.stderr)

    def test_files_that_are_no_models(self):
        self.expect_complaint("'arm/smurf/arm_motors.yml' is not a model; name the .smurf file that lists it",
                              "arm/smurf/arm_motors.yml")
        self.expect_complaint("'arm/meshes/upper_arm.obj' is not a model; name the .smurf or .urdf file that uses it",
                              "arm/meshes/upper_arm.obj")

    def test_missing_annotations_do_not_lose_the_robot(self):
        self.write("m.smurf", "modelname: m\nfiles: [gone.urdf, gone.yml]\n")
        done = self.run_with_messages(1, "m.smurf")
        self.assertEqual(done.stderr.count("= note: not converted: its URDF cannot be read"), 1)
        self.assertIn("smurf2urdf: 1 error: see smurf-lint m.smurf\n", done.stderr)

    def test_folders(self):
        """Scenes are ignored, and so are URDFs if there is a model."""
        self.write("arm/hall.smurfs", "entities: []\n")
        self.assertEqual(self.expect(0, "arm").stdout, self.expect(0, "arm/smurf/arm.smurf").stdout)
        self.assertEqual(self.expect(0, "arm/urdf/").stdout, self.expect(0, "arm/urdf/arm.urdf").stdout)
        shutil.copytree(self.folder / "arm", self.folder / "both" / "left")
        shutil.copytree(self.folder / "arm", self.folder / "both" / "right")
        self.expect_complaint("'both' contains 2 files to choose from; name one, such as "
                              "'both/left/smurf/arm.smurf'", "both")
        self.write("none/notes.txt", "")
        self.expect_complaint("no .smurf, .smurfs, .smurfa, .urdf or .xacro file in 'none'", "none")


class Told(ExportTest):
    def test_what_was_written_and_what_is_not_in_it(self):
        done = self.run_with_messages(0, "arm/smurf/arm.smurf", "-o", "arm/o.urdf")
        self.assertRegex(done.stderr, r"\Asmurf2urdf: wrote arm/o.urdf: 10 links, 9 joints\n  not in it: "
                                      r"\d+ entries \(2 in controllers, [^()]*\) and\s+\d+\s+values\s+of\s+other\s+entries\s+"
                                      r"\(\d+\s+in\s+collision, [^()]*\d+\s+in\s+motors,[^()]*\),\s+see\s+--loss-report\n\Z")
        self.assertLessEqual(max(map(len, done.stderr.splitlines())), 80)
        done = self.run_with_messages(0, "arm/smurf/arm.smurf", "-o", "arm/o.urdf", "--loss-report", "lost.json")
        done.stderr = " ".join(done.stderr.split())  # it is wrapped
        pointers = [loss["pointer"].split("/")[1:] for loss in json.loads(self.read("lost.json"))["losses"]]
        entries = [pointer[0] for pointer in pointers if len(pointer) <= 2]
        values = [pointer[0] for pointer in pointers if len(pointer) > 2]
        for lost, told in zip((entries, values), done.stderr.split(" and ")):
            self.assertEqual({section: int(count) for count, section in re.findall(r"(\d+) in ([a-z_]+)", told)},
                             {section: lost.count(section) for section in lost})
        self.assertIn(f": {len(entries)} entries (", done.stderr)
        self.assertIn(f" and {len(values)} values of other entries (", done.stderr)
        self.assertNotIn("see --loss-report", done.stderr)
        done = self.run_with_messages(0, "arm/smurf/arm.smurf", "--collapse-fixed", "-o", "arm/c.urdf")
        written = self.read("arm/c.urdf")
        self.assertIn(f"wrote arm/c.urdf: {written.count('<link ')} links, {written.count('<joint ')} joints\n", done.stderr)
        for silent in (("-q", "-o", "arm/o.urdf"), ("-o", "-"), ("--dry-run", "-o", "arm/o.urdf")):
            self.assertEqual(self.run_with_messages(0, "arm/smurf/arm.smurf", *silent).stderr, "")


if __name__ == "__main__":
    cli.main()
