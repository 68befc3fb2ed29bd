# SPDX-License-Identifier: BSD-3-Clause
"""The command line of urdf2smurf: layouts, refusals, and writing either all files or none."""
import pathlib
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import cli  # noqa: E402

ARM_FILES = ["smurf/arm.smurf", "smurf/arm_joint.yml", "smurf/arm_materials.yml", "urdf/arm.urdf"]


class ImportTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        shutil.copytree(cli.FIXTURES / "models" / "arm" / "urdf", self.folder / "in" / "urdf")
        shutil.copytree(cli.FIXTURES / "models" / "arm" / "meshes", self.folder / "in" / "meshes")

    def exported(self, *arguments):
        """What smurf2urdf makes of a model."""
        done = subprocess.run([pathlib.Path(cli.TOOL).with_name("smurf2urdf"), *arguments], capture_output=True, text=True,
                              cwd=self.folder, timeout=600, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def files(self, folder):
        root = self.folder / folder
        return sorted(str(p.relative_to(root)) for p in root.rglob("*") if p.is_file())


class Layout(ImportTest):
    def test_a_folder_as_phobos_makes_it(self):
        self.expect(0, "in/urdf/arm.urdf", "-o", "out/deep")
        self.assertEqual(self.files("out/deep"), ARM_FILES)
        self.assertIn("- ../urdf/arm.urdf\n", self.read("out/deep/smurf/arm.smurf"))
        urdf = self.read("out/deep/urdf/arm.urdf")
        self.assertIn('filename="../../../in/meshes/upper_arm.obj"', urdf)
        self.assertEqual(urdf.replace("../../../in/meshes/", "../meshes/"),
                         self.read("in/urdf/arm.urdf"))

    def test_flat(self):
        self.expect(0, "in/urdf/arm.urdf", "-o", "out", "--flat")
        self.assertEqual(self.files("out"), sorted(pathlib.Path(f).name for f in ARM_FILES))

    def test_in_place(self):
        before = self.read("in/urdf/arm.urdf")
        self.expect(0, "in/urdf/arm.urdf", "--in-place")
        self.assertEqual(self.files("in/urdf"), sorted(pathlib.Path(f).name for f in ARM_FILES))
        self.assertEqual(self.read("in/urdf/arm.urdf"), before)

    def test_in_place_with_annotations_elsewhere(self):
        self.expect(0, "in/urdf/arm.urdf", "--in-place", "-o", "smurf")
        self.assertIn("- ../in/urdf/arm.urdf\n", self.read("smurf/arm.smurf"))

    def test_standard_input(self):
        text = self.read("in/urdf/arm.urdf").replace("../meshes", "in/meshes")
        self.expect(0, "-", "--name", "bot", "-o", "out", stdin=text)
        self.assertIn("smurf/bot.smurf", self.files("out"))

    def test_dry_run_names_the_files(self):
        done = self.expect(0, "in/urdf/arm.urdf", "-o", "out", "--dry-run")
        self.assertEqual(sorted(done.stdout.split()), ["out/" + file for file in ARM_FILES])
        self.assertFalse((self.folder / "out").exists())

    def test_motors_for_all_joints_and_poses_from_an_srdf(self):
        self.write("arm.srdf", '<robot name="arm"><group_state name="up" group="arm">'
                               '<joint name="joint1_waist" value="1"/></group_state></robot>')
        self.expect(0, "in/urdf/arm.urdf", "-o", "out", "--motors", "all", "--srdf", "arm.srdf")
        self.assertIn("- name: joint1_waist\n", self.read("out/smurf/arm_motors.yml"))
        self.assertIn("- name: up\n  joints:\n    joint1_waist: 1\n",
                      self.read("out/smurf/arm_poses.yml"))

    def test_twice_gives_the_same_bytes(self):
        self.expect(0, "in/urdf/arm.urdf", "-o", "out")
        first = {file: self.read("out/" + file) for file in self.files("out")}
        self.expect(0, "in/urdf/arm.urdf", "-o", "out", "--overwrite")
        self.assertEqual(first, {file: self.read("out/" + file) for file in self.files("out")})


FINGERS = """<robot name="hand"><link name="palm"/><link name="left"/><link name="right"/>
<joint name="l" type="revolute"><parent link="palm"/><child link="left"/><axis xyz="0 0 1"/>
<limit lower="0" upper="1" effort="1" velocity="1"/></joint>
<joint name="r" type="revolute"><parent link="palm"/><child link="right"/><axis xyz="0 0 1"/>
<limit lower="-1" upper="0" effort="1" velocity="1"/><mimic joint="l" multiplier="-1"/></joint>
<transmission name="t"><type>transmission_interface/SimpleTransmission</type><joint name="l">
<hardwareInterface>hardware_interface/{}JointInterface</hardwareInterface></joint></transmission></robot>
"""

WHEELS = """<robot name="cart">
  <link name="base"/><link name="left"/><link name="right"/>
  <joint name="a" type="continuous"><parent link="base"/><child link="left"/><axis xyz="0 1 0"/></joint>
  <joint name="b" type="continuous"><parent link="base"/><child link="right"/><axis xyz="0 1 0"/>
    <limit effort="5" velocity="0"/></joint>
  <transmission name="ta"><type>transmission_interface/SimpleTransmission</type>
    <joint name="a"><hardwareInterface>hardware_interface/VelocityJointInterface</hardwareInterface></joint>
    <actuator name="ma"/></transmission>
  <transmission name="tb"><type>transmission_interface/SimpleTransmission</type>
    <joint name="b"><hardwareInterface>hardware_interface/VelocityJointInterface</hardwareInterface></joint>
    <actuator name="mb"/></transmission>
</robot>
"""


XACRO = """<robot name="$(arg name)" xmlns:xacro="x">
<link name="${'a'}"><visual><geometry><mesh filename="../meshes/upper_arm.obj"/></geometry></visual></link></robot>
"""


class Xacro(ImportTest):
    def test_the_model_lists_a_generated_urdf(self):
        self.write("in/urdf/crane.urdf.xacro", XACRO)
        done = self.expect(0, "in/urdf/crane.urdf.xacro", "name:=big", "-o", "out")
        self.assertEqual(self.files("out"), ["smurf/crane.smurf", "urdf/crane.urdf"])
        self.assertIn('<link name="a">', self.read("out/urdf/crane.urdf"))
        self.assertIn("../../in/meshes/upper_arm.obj", self.read("out/urdf/crane.urdf"))
        self.assertIn("modelname: big", self.read("out/smurf/crane.smurf"))
        told = " ".join(done.stderr.split())
        self.assertIn("out/urdf/crane.urdf was generated: after a change in in/urdf/crane.urdf.xacro, run urdf2smurf again",
                      told)

    def test_in_place(self):
        self.write("in/urdf/crane.xacro", XACRO)
        self.expect(0, "in/urdf/crane.xacro", "name:=big", "--in-place")
        self.assertIn('<link name="a">', self.read("in/urdf/crane.urdf"))
        self.assertIn('"../meshes/upper_arm.obj"', self.read("in/urdf/crane.urdf"))
        self.assertIn("- crane.urdf\n", self.read("in/urdf/crane.smurf"))

    def test_a_value_is_missing(self):
        self.write("in/urdf/crane.xacro", XACRO)
        done = self.run_tool("in/urdf/crane.xacro", "-o", "out")
        self.assertEqual(done.returncode, 1)
        self.assertIn("SML3313", done.stderr)
        self.assertFalse((self.folder / "out").exists())


class Motors(ImportTest):
    def said(self, *arguments):
        done = self.run_tool(*arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        for line in done.stderr.splitlines():
            self.assertLessEqual(len(line), 80)
        return " ".join(line.strip() for line in done.stderr.splitlines())

    def test_wheels_have_no_limits(self):
        self.write("cart.urdf", WHEELS)
        said = self.said("cart.urdf", "-o", "out")
        self.assertIn(" 3 motor values missing, which MARS reads as 0 (SML4103): the joints have no", said)
        motors = self.read("out/smurf/cart_motors.yml")
        self.assertEqual((motors.count("maxSpeed: 0"), motors.count("maxEffort: 5")), (1, 1))

    def test_a_finger_cannot_mimic_an_effort(self):
        self.write("hand.urdf", FINGERS.format("Effort"))
        self.assertIn(" 1 motor will not mimic as in the URDF", self.said("hand.urdf", "-o", "effort"))
        self.write("hand.urdf", FINGERS.format("Position"))
        self.assertNotIn("mimic", self.said("hand.urdf", "-o", "position"))

    def test_joints_of_ros_1_are_driven_in_ros_2(self):
        """ROS 2 does not read transmissions, so a joint that only they drive needs a ros2_control."""
        self.write("cart.urdf", WHEELS)
        self.run_tool("cart.urdf", "-o", "out")
        text = self.exported("out/smurf/cart.smurf", "--preset", "ros2")
        self.assertEqual(text.count('<command_interface name="velocity">'), 2, text)
        self.assertNotIn("<transmission", text)

    def test_the_robot_names_the_files_when_the_urdf_does_not(self):
        foot = '<robot name="{}"><link name="foot"/></robot>'
        for file, robot, name in (("model.urdf", "foot", "foot"), ("Robot.urdf", "foot", "foot"),
                                  ("left.urdf", "foot", "left"), ("model.urdf", "a/b", "a_b"),
                                  ("model.urdf", "", "model")):
            self.write(file, foot.format(robot))
            out = f"{file}_{len(robot)}"
            self.run_tool(file, "-o", out, "--force")
            self.assertTrue((self.folder / out / f"smurf/{name}.smurf").is_file(), (file, robot))
            self.assertTrue((self.folder / out / f"urdf/{name}.urdf").is_file(), (file, robot))
        self.assertEqual(self.run_tool("-", "-o", "piped", stdin=foot.format("foot")).returncode, 0)
        self.assertTrue((self.folder / "piped/smurf/foot.smurf").is_file())

    def test_says_that_there_are_none(self):
        self.assertEqual(self.said("in/urdf/arm.urdf", "-o", "out"),
                         "urdf2smurf: wrote 4 files to out/: 4 materials, 6 joints no motors: no transmission or "
                         "ros2_control of the URDF drives a joint; see --motors all")
        self.assertNotIn("no motors", self.said("in/urdf/arm.urdf", "-o", "out", "--overwrite", "--motors", "none"))
        self.assertIn(": 6 motors, ", self.said("in/urdf/arm.urdf", "-o", "all", "--motors", "all"))
        done = self.run_tool("in/urdf/arm.urdf", "-o", "q", "--quiet")
        self.assertEqual((done.returncode, done.stderr), (0, ""))


CONTACT = """<robot name="foot">
  <link name="foot"><collision name="foot"><geometry><sphere radius="0.1"/></geometry></collision></link>
  <link name="sole"><collision name="sole_hull"><geometry><sphere radius="0.1"/></geometry></collision></link>
  <joint name="j" type="continuous"><parent link="foot"/><child link="sole"/><dynamics damping="0.1"/></joint>
  <gazebo reference="sole"><sensor name="touch" type="contact"><contact><collision>sole_hull</collision></contact></sensor></gazebo>
</robot>
"""


class Readers(ImportTest):
    """The files that readers of the model open and understand."""

    def remark(self, *arguments):
        done = self.run_tool(*arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return " ".join(line.strip() for line in done.stderr.splitlines())

    def test_packages_become_paths(self):
        text = self.read("in/urdf/arm.urdf").replace("../meshes/", "package://in/meshes/", 1)
        self.write("in/urdf/arm.urdf", text)
        said = self.remark("in/urdf/arm.urdf", "-o", "out", "--package", "in=in")
        self.assertNotIn("package://", self.read("out/urdf/arm.urdf"))
        self.assertIn('filename="../../in/meshes/upper_arm.obj"', self.read("out/urdf/arm.urdf"))
        self.assertNotIn("URI", said)
        said = self.remark("in/urdf/arm.urdf", "--in-place", "--package", "in=in")
        self.assertIn(" 1 mesh path stays a URI, which MARS does not open: --in-place does not change the URDF", said)

    def test_packages_that_are_not_there_are_said(self):
        self.write("in/urdf/arm.urdf", self.read("in/urdf/arm.urdf").replace("../meshes/", "package://none/nowhere/"))
        said = self.remark("in/urdf/arm.urdf", "-o", "out")
        self.assertRegex(said, " [0-9]+ mesh paths stay URIs, which MARS does not open: no file was found")

    def test_what_mars_makes_of_the_urdf_is_said(self):
        self.write("foot.urdf", CONTACT)
        self.assertIn(" MARS reads the URDF differently (1 error): see smurf-lint out/smurf/foot.smurf",
                      self.remark("foot.urdf", "-o", "out"))
        self.assertEqual(self.exported("out/smurf/foot.smurf"), self.read("out/urdf/foot.urdf"))

    def test_the_style_of_phobos(self):
        self.write("foot.urdf", CONTACT)
        self.remark("foot.urdf", "-o", "mars")
        self.remark("foot.urdf", "-o", "phobos", "--style", "phobos")
        self.assertIn("  id:\n  - sole_hull\n", self.read("mars/smurf/foot_sensors.yml"))
        self.assertIn("  id:\n  - sole\n", self.read("phobos/smurf/foot_sensors.yml"))
        self.assertIn("\njoint:\n", self.read("mars/smurf/foot_joint.yml"))
        self.assertIn("\njoints:\n", self.read("phobos/smurf/foot_joints.yml"))


class Copies(ImportTest):
    def test_the_folder_stands_on_its_own(self):
        self.expect(0, "in/urdf/arm.urdf", "-o", "out", "--copy-meshes")
        copies = [file for file in self.files("out") if file.startswith("meshes/")]
        self.assertGreaterEqual(len(copies), 2)
        for copy in copies:
            self.assertEqual((self.folder / "out" / copy).read_bytes(), (self.folder / "in" / copy).read_bytes())
        self.assertEqual(self.read("out/urdf/arm.urdf"), self.read("in/urdf/arm.urdf"))
        self.expect_complaint("--copy-meshes and --in-place exclude each other: the URDF stays as it is",
                              "in/urdf/arm.urdf", "--in-place", "--copy-meshes")

    def test_names_from_packages_and_equal_names(self):
        text = self.read("in/urdf/arm.urdf").replace("../meshes/upper_arm.obj", "package://in/meshes/upper_arm.obj")
        self.write("in/urdf/arm.urdf", text.replace("../meshes/forearm.obj", "../meshes/deep/upper_arm.obj"))
        self.write("in/meshes/deep/upper_arm.obj", self.read("in/meshes/forearm.obj"))
        self.expect(0, "in/urdf/arm.urdf", "-o", "out", "--flat", "--copy-meshes", "--package", "in=in")
        urdf = self.read("out/arm.urdf")
        self.assertIn('filename="meshes/upper_arm.obj"', urdf)
        self.assertIn('filename="meshes/2/upper_arm.obj"', urdf)
        self.assertEqual(self.read("out/meshes/2/upper_arm.obj"), self.read("in/meshes/forearm.obj"))

    def test_files_that_meshes_name(self):
        mesh = self.read("in/meshes/forearm.obj")
        self.write("in/meshes/forearm.obj", "mtllib colours of it.mtl\n" + mesh)
        self.write("in/meshes/colours of it.mtl", "newmtl a\nmap_Kd ../wood.png\n")
        self.write("in/wood.png", "wood")
        self.expect(0, "in/urdf/arm.urdf", "-o", "out", "--copy-meshes")
        self.assertEqual(self.read("out/meshes/forearm.obj"), "mtllib colours_of_it.mtl\n" + mesh)
        self.assertEqual(self.read("out/meshes/colours_of_it.mtl"), "newmtl a\nmap_Kd wood.png\n")
        self.assertEqual(self.read("out/meshes/wood.png"), "wood")

    def test_nothing_from_outside(self):
        self.write("secret.stl", "solid s\nendsolid s\n")
        (self.folder / "project" / ".git").mkdir(parents=True)
        text = self.read("in/urdf/arm.urdf").replace("../meshes/upper_arm.obj", "../secret.stl")
        self.write("project/arm.urdf", text.replace("../meshes/", "meshes/"))
        shutil.copytree(self.folder / "in" / "meshes", self.folder / "project" / "meshes")
        copy = ("arm.urdf", "-o", "../out", "--copy-meshes")
        done = self.run_tool(*copy, cwd=self.folder / "project")
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
        self.assertIn("outside of the project", done.stderr)
        self.assertFalse((self.folder / "out").exists())
        self.run_tool(*copy, "--allow-outside", cwd=self.folder / "project")
        self.assertEqual(self.read("out/meshes/secret.stl"), self.read("secret.stl"))

    def test_what_is_there_stays(self):
        self.write("out/meshes/forearm.obj", "mine")
        done = self.run_tool("in/urdf/arm.urdf", "-o", "out", "--copy-meshes")
        self.assertEqual(done.returncode, 2)
        self.assertIn("cannot write 'out/meshes/forearm.obj': another file is there; see --overwrite; nothing was "
                      "written", done.stderr)
        self.assertEqual(self.files("out"), ["meshes/forearm.obj"])
        self.write("out/smurf/arm.smurf/in the way", "")
        done = self.run_tool("in/urdf/arm.urdf", "-o", "out", "--copy-meshes", "--overwrite")
        self.assertEqual(done.returncode, 2)
        self.assertEqual(self.read("out/meshes/forearm.obj"), "mine")


class Refusal(ImportTest):
    def complain(self, code, text, *arguments, **keywords):
        done = self.run_tool(*arguments, **keywords)
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertIn(text, done.stderr)
        self.assertEqual(done.stdout, "")

    def test_options_that_make_no_sense(self):
        self.expect_complaint("say where to write with -o DIR, or use --in-place",
                              "in/urdf/arm.urdf")
        self.expect_complaint("--flat and --in-place exclude each other", "in/urdf/arm.urdf",
                              "--flat", "--in-place")
        self.expect_complaint("--name is a file name without a folder", "in/urdf/arm.urdf",
                              "-o", "out", "--name", "../x")
        self.expect_complaint("a model consists of several files, so -o must name a folder", "in/urdf/arm.urdf",
                              "-o", "-")

    def test_input(self):
        self.expect_complaint("cannot read 'no.urdf': No such file or directory", "no.urdf", "-o",
                              "out")
        self.write("a.smurf", "modelname: a\nfiles: [in/urdf/arm.urdf]\n")
        self.expect_complaint("'a.smurf' is not a URDF", "a.smurf", "-o", "out")
        self.write("a.yml", "motors: []\n")
        self.expect_complaint("'a.yml' is not a URDF", "a.yml", "-o", "out")
        self.write("bad.srdf", "<robot>")
        self.expect_complaint("'bad.srdf' is not well-formed XML: line 1: the file ends inside the element `robot`", "in/urdf/arm.urdf", "-o", "out",
                              "--srdf", "bad.srdf")
        self.write("other.srdf", "<sdf><model/></sdf>")
        self.expect_complaint("'other.srdf' is no SRDF: its root element is 'sdf', not 'robot'", "in/urdf/arm.urdf",
                              "-o", "out", "--srdf", "other.srdf")

    def test_errors_and_missing_meshes(self):
        (self.folder / "in" / "meshes" / "forearm.obj").unlink()
        self.complain(0, "urdf2smurf: 1 error: see smurf-lint in/urdf/arm.urdf\n", "in/urdf/arm.urdf", "-o", "out")
        self.assertEqual(self.files("out"), ARM_FILES)
        self.complain(1, "has findings that reach --fail-on; see --force", "in/urdf/arm.urdf", "-o", "no",
                      "--fail-on", "error")
        self.write("in/urdf/arm.urdf", self.read("in/urdf/arm.urdf").replace('<mass value="', '<mass value="kg', 1))
        self.complain(1, "cannot be converted: a value cannot be read; see --force; nothing was written",
                      "in/urdf/arm.urdf", "-o", "no")
        self.assertFalse((self.folder / "no").exists())
        self.complain(0, "SML18", "in/urdf/arm.urdf", "-o", "no", "--force")

    def test_faults_in_materials_stop_nothing(self):
        urdf = self.read("in/urdf/arm.urdf")
        for extra in ('<material name="again"><color rgba="0 0 0 1"/></material>', '<material/>'):
            self.write("in/urdf/arm.urdf", urdf.replace("</visual>", extra + "</visual>", 1))
            self.complain(0, "see smurf-lint in/urdf/arm.urdf\n", "in/urdf/arm.urdf", "-o", "out", "--overwrite")
            self.assertIn(extra, self.read("out/urdf/arm.urdf"))

    def test_values_that_smurf_cannot_have_are_those_of_the_urdf(self):
        urdf = self.read("in/urdf/arm.urdf").replace("</robot>", '<gazebo reference="pedestal"><sensor name="s" type="ray"><ray><scan>'
            "<horizontal><samples>1e308</samples><min_angle>-1</min_angle><max_angle>1</max_angle></horizontal></scan></ray></sensor></gazebo></robot>")
        self.write("a.urdf", urdf.replace("../meshes", "in/meshes"))
        done = self.run_tool("a.urdf", "-o", "out")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("the result would have an error: SML4003 `bands` is 1e+308", done.stderr)
        self.assertNotIn("defect of this tool", done.stderr)
        self.assertFalse((self.folder / "out").exists())

    def test_existing_files_stay(self):
        self.write("out/smurf/arm_joint.yml", "mine\n")
        self.complain(2, "cannot write 'out/smurf/arm_joint.yml': File exists; see --overwrite; "
                         "nothing was written", "in/urdf/arm.urdf", "-o", "out")
        self.assertEqual(self.files("out"), ["smurf/arm_joint.yml"])
        self.assertEqual(self.read("out/smurf/arm_joint.yml"), "mine\n")
        self.expect(0, "in/urdf/arm.urdf", "-o", "out", "--overwrite")
        self.assertEqual(self.files("out"), ARM_FILES)

    def test_a_folder_in_the_way_takes_everything_back(self):
        self.write("out/smurf/arm.smurf/x", "")
        self.write("out/urdf/arm.urdf", "old\n")
        self.complain(2, "Is a directory", "in/urdf/arm.urdf", "-o", "out", "--overwrite")
        self.assertEqual(self.files("out"), ["smurf/arm.smurf/x", "urdf/arm.urdf"])
        self.assertEqual(self.read("out/urdf/arm.urdf"), "old\n")

    def test_a_file_where_a_folder_must_be(self):
        self.write("out", "")
        self.complain(2, "Not a directory", "in/urdf/arm.urdf", "-o", "out/deeper")


if __name__ == "__main__":
    cli.main()
