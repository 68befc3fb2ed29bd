# SPDX-License-Identifier: BSD-3-Clause
"""smurf-lint on the files of ROS beside a robot: which it finds, and what it renames in them."""
import json
import pathlib
import sys
import textwrap

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import cli  # noqa: E402

URDF = """<?xml version="1.0"?>
<robot name="lamp">
  <link name="base"/>
  <link name="arm">
    <inertial>
      <mass value="0.5"/>
      <inertia ixx="0.00013" ixy="0" ixz="0" iyy="0.00013" iyz="0" izz="0.00013"/>
    </inertial>
  </link>
  <joint name="shoulder" type="revolute">
    <parent link="base"/>
    <child link="arm"/>
    <axis xyz="0 1 0"/>
    <limit lower="-1" upper="1" effort="10" velocity="2"/>
  </joint>
  <ros2_control name="hardware" type="system">
    <hardware>
      <plugin>lamp/Hardware</plugin>
    </hardware>
    <joint name="shoulder">
      <command_interface name="position"/>
      <state_interface name="position"/>
    </joint>
  </ros2_control>
</robot>
"""
SRDF = """<robot name="lamp">
  <group name="arm">
    <chain base_link="base" tip_link="arm"/>
  </group>
  <group_state name="up" group="arm">
    <joint name="shoulder" value="0.5"/>
  </group_state>
</robot>
"""
CONTROLLERS = """# the controllers of the lamp
controller_manager:
  ros__parameters:
    update_rate: 100
    trajectory:
      type: joint_trajectory_controller/JointTrajectoryController
trajectory:
  ros__parameters:
    joints: ["shoulder"]
    command_interfaces: [position]
    state_interfaces: [position]
    constraints:
      shoulder: {goal: 0.1}  # shoulder
"""
LIMITS = "joint_limits:\n  shoulder:\n    has_velocity_limits: true\n    max_velocity: 1.5\n"
KINEMATICS = "arm:\n  kinematics_solver: kdl_kinematics_plugin/KDLKinematicsPlugin\n"
MOVEIT = """moveit_simple_controller_manager:
  controller_names: [trajectory]
  trajectory:
    action_ns: follow_joint_trajectory
    type: FollowJointTrajectory
    joints: [shoulder]
"""


class Lamp(cli.CliTest):
    """A robot in one package, and its companions in another."""

    def setUp(self):
        super().setUp()
        self.enter_workspace()
        self.write("lamp_description/package.xml", cli.package("lamp_description"))
        self.write("lamp_description/urdf/lamp.urdf", URDF)
        self.write("lamp_moveit_config/package.xml", cli.package("lamp_moveit_config", "lamp_description"))
        self.files = {"lamp.srdf": SRDF, "joint_limits.yaml": LIMITS, "kinematics.yaml": KINEMATICS,
                      "moveit_controllers.yaml": MOVEIT, "ros2_controllers.yaml": CONTROLLERS}
        for name, text in self.files.items():
            self.write("lamp_moveit_config/config/" + name, text)


class Companions(Lamp):
    def companion(self, name):
        return self.read("lamp_moveit_config/config/" + name)

    def test_a_clean_robot_has_no_findings(self):
        self.assertEqual(self.expect(0, ".").stdout, "no findings in 8 files (1 model), checked with 1 SRDF, "
                         "1 controllers.yaml, 1 joint_limits.yaml, 1 kinematics.yaml and 1 moveit_controllers.yaml\n")

    def test_the_report_for_programs_counts_them(self):
        report = json.loads(self.expect(0, "--format", "json", ".").stdout)
        self.assertEqual(report["summary"]["companions"], {"SRDF": 1, "controllers.yaml": 1, "joint_limits.yaml": 1, "kinematics.yaml": 1,
                                                           "moveit_controllers.yaml": 1})
        self.write("alone.urdf", URDF)
        self.assertNotIn("companions", json.loads(self.expect(0, "--format", "json", "alone.urdf").stdout)["summary"])

    def test_a_xacro_that_was_found_is_compared_with_its_companions(self):
        (self.folder / "lamp_description/urdf/lamp.urdf").unlink()
        self.write("lamp_description/urdf/lamp.urdf.xacro", URDF.replace("<robot ", '<robot xmlns:xacro="x" '))
        self.write("lamp_moveit_config/config/lamp.srdf", SRDF.replace('value="0.5"', 'value="5"'))
        done = self.expect(0, ".")
        self.assertIn("SML3513", done.stdout)
        self.assertIn("checked with 1 SRDF", done.stdout)

    def test_interfaces_of_a_xacro_that_was_found_depend_on_its_arguments(self):
        (self.folder / "lamp_description/urdf/lamp.urdf").unlink()
        self.write("lamp_description/urdf/lamp.urdf.xacro", URDF.replace("<robot ", '<robot xmlns:xacro="x" '))
        self.write("lamp_moveit_config/config/ros2_controllers.yaml", CONTROLLERS.replace("command_interfaces: [position]", "command_interfaces: [velocity]")
                   .replace("state_interfaces: [position]", "state_interfaces: [position, velocity]"))
        self.write(".smurf-lint.yaml", "companions:\n- robot: lamp_description/urdf/lamp.urdf.xacro\n  files: [lamp_moveit_config/config/ros2_controllers.yaml]\n")
        self.assertIn("info[SML3705]", self.expect(0, "--min-severity", "info", ".").stdout)
        self.assertIn("error[SML3705]", self.expect(1, "lamp_description/urdf/lamp.urdf.xacro").stdout)

    def test_one_of_several_robots_is_excused(self):
        self.write("lamp_moveit_config/config/ros2_controllers.yaml", CONTROLLERS.replace('["shoulder"]', '["shoulder", "joint_2"]'))
        robot = URDF.replace("</robot>", '<link name="tip"/><joint name="joint_1" type="fixed"><parent link="arm"/><child link="tip"/></joint></robot>')
        self.write("lamp_description/urdf/lamp.urdf", robot)
        self.assertIn("warning[SML3701]", self.expect(0, ".").stdout)
        self.write("other_description/other.urdf", '<robot name="other"><link name="base"/></robot>')
        self.assertIn("info[SML3701]", self.expect(0, "--min-severity", "info", ".").stdout)
        # A robot without ros2_control is a mistake if it is the only one.
        self.assertNotIn("SML3615", self.run_tool("--target", "ros2_control", ".").stdout)
        self.assertIn("SML3615", self.run_tool("--target", "ros2_control", "other_description/other.urdf").stdout)

    def test_arguments_are_excused_for_targets_as_well(self):
        (self.folder / "lamp_description/urdf/lamp.urdf").unlink()
        self.write("lamp_description/urdf/lamp.urdf.xacro", URDF.replace("<robot ", '<robot xmlns:xacro="x" ').replace(
            "<plugin>lamp/Hardware", "<plugin>gz_ros2_control/GazeboSimSystem"))
        # Another description has the plugin, so that arguments may choose it.
        self.write("lamp_description/urdf/sim.xacro", '<robot xmlns:xacro="x"><gazebo><plugin filename="gz_ros2_control-system" name="x"/></gazebo></robot>')
        self.assertIn("info[SML3613]", self.expect(None, "--min-severity", "info", "--target", "ros2_control", ".").stdout)
        self.assertIn("error[SML3613]", self.expect(1, "--target", "ros2_control", "lamp_description/urdf/lamp.urdf.xacro").stdout)

    def test_files_in_a_package_that_depends_on_the_description(self):
        self.write("lamp_moveit_config/config/lamp.srdf", SRDF.replace('"shoulder"', '"sholder"'))
        self.write("lamp_moveit_config/config/joint_limits.yaml", LIMITS.replace("1.5", "1"))
        for path in (".", "lamp_description/urdf/lamp.urdf"):
            done = self.expect(1, path)
            self.assertIn("SML3501", done.stdout)
            self.assertIn("SML3801", done.stdout)
            self.assertIn("did you mean `shoulder`?", done.stdout)

    def test_the_other_link_of_a_pair_is_no_suggestion(self):
        for name, wanted in (("amr", "did you mean `arm`?"), ("bsae", "correct the name: write `arm`")):
            pair = '<disable_collisions link1="base" link2="%s" reason="Never"/>' % name
            self.write("lamp_moveit_config/config/lamp.srdf", SRDF.replace("</robot>", pair + "</robot>"))
            found = json.loads(self.run_tool("--select", "SML3501", "--format", "json", ".").stdout)["diagnostics"]
            self.assertEqual([one["help"] for one in found], [wanted])

    def test_a_package_that_does_not_depend_on_it_is_another_robot(self):
        self.write("lamp_moveit_config/package.xml", cli.package("lamp_moveit_config"))
        self.write("lamp_moveit_config/config/joint_limits.yaml", LIMITS.replace("1.5", "1"))
        self.assertNotIn("SML3801", self.expect(0, "lamp_description").stdout)

    def test_an_srdf_alone_is_compared_with_its_robot(self):
        self.write("lamp_moveit_config/config/lamp.srdf", SRDF.replace('"shoulder"', '"sholder"'))
        done = self.expect(1, "lamp_moveit_config/config/lamp.srdf")
        self.assertIn("joint `sholder`", done.stdout)
        self.assertIn("checked with 1 SRDF, compared with `lamp_description/urdf/lamp.urdf`", done.stdout)
        self.assertIn("1 error", done.stdout)

    def test_an_srdf_without_a_robot_says_so(self):
        self.write("other.srdf", SRDF.replace("lamp", "other").replace('group="arm"', 'group="amr"'))
        done = self.expect(1, "--min-severity", "info", "other.srdf")
        self.assertIn("SML3500", done.stdout)
        self.assertIn("in 1 file, an SRDF without its robot", done.stdout)
        self.assertIn("did you mean `arm`?", done.stdout)

    def test_files_of_another_robot_are_left_alone(self):
        self.write("lamp_moveit_config/config/joint_limits.yaml",
                   LIMITS.replace("shoulder", "other_joint").replace("1.5", "1"))
        self.assertNotIn("other_joint", self.expect(0, ".").stdout)

    def test_a_part_of_a_robot_has_no_unknown_joints(self):
        part = URDF[:URDF.index("  <link")] + URDF[URDF.index("  <ros2_control"):]
        self.write("lamp_description/urdf/control.urdf", part)
        self.assertNotIn("SML3604", self.expect(None, "lamp_description/urdf/control.urdf").stdout)
        self.write("lamp_description/urdf/control.urdf", URDF.replace("<hardware>", "<xacro:if value=\"0\"/>\n    <hardware>"))
        done = self.expect(1, "lamp_description/urdf/control.urdf")
        self.assertIn("SML1009", done.stdout)
        self.assertNotIn("SML3602", done.stdout)

    def test_templates_are_left_alone(self):
        self.write("lamp_moveit_config/config/ros2_controllers.yaml", "{{ x }}: [\n" + CONTROLLERS)
        self.expect(0, ".")

    def test_rename_changes_all_files_and_back(self):
        self.expect(0, "--rename", "joint:shoulder=hinge", ".")
        for name, text in self.files.items():
            self.assertEqual(self.companion(name),
                             text.replace("shoulder", "hinge").replace("# hinge", "# shoulder"), name)
        self.expect(0, "--rename", "joint:hinge=shoulder", ".")
        for name, text in self.files.items():
            self.assertEqual(self.companion(name), text, name)
        self.assertEqual(self.read("lamp_description/urdf/lamp.urdf"), URDF)

    def test_launch_files_that_still_name_it_are_listed(self):
        self.write("lamp_moveit_config/launch/demo.launch.py", "# shoulder\nJOINTS = ['shoulder', 'shoulder_2']\n")
        self.write("lamp_description/launch/show.launch.xml", '<launch><arg name="model" default="tip:=shoulder"/></launch>\n')
        self.write("lamp_description/rviz/lamp.rviz", "Visualization Manager:\n  Target: shoulder\n")
        self.write("lamp_moveit_config/launch/tf.launch", '<launch><node args="0 0 0 0 0 0 shoulder lamp"/><node doc="the shoulder of"/></launch>\n')
        done = self.run_tool("--rename", "joint:shoulder=hinge", ".")
        self.assertEqual(done.returncode, 0)
        places = ("'lamp_description/launch/show.launch.xml' (line 1)", "'lamp_description/rviz/lamp.rviz' (line 2)",
                  "'lamp_moveit_config/launch/demo.launch.py' (line 2)", "'lamp_moveit_config/launch/tf.launch' (line 1)")
        self.assertEqual(done.stderr.count("is still named in"), 1)
        for place in places:
            self.assertIn(place, done.stderr)
        self.assertRegex(done.stderr, r"`shoulder` is still named in '.*' \(line \d\), .* and '.*' \(line \d\); change it there")

    def test_settings_of_other_programs_that_still_name_it_are_listed(self):
        self.write("lamp_moveit_config/config/servo.yaml", "planning_frame: base\nee_frame_name: basement  # base\n")
        self.write("lamp_description/config/words.yaml", "title: the arms\n")
        done = self.run_tool("--rename", "link:base=foot", ".")
        self.assertEqual(done.returncode, 0)
        self.assertIn("`base` is still named in 'lamp_moveit_config/config/servo.yaml' (line 1); change it there", done.stderr)

    def test_xacro_files_that_were_not_loaded_and_still_name_it_are_listed(self):
        self.write("lamp_moveit_config/config/lamp.urdf.xacro",
                   '<robot xmlns:xacro="x" name="lamp2">\n  <xacro:include filename="other.xacro"/>\n  <joint name="shoulder"/>\n'
                   "  ${keys['shoulder']}\n</robot>\n")
        self.write("lamp_description/urdf/other_lamp.xacro",
                   '<robot xmlns:xacro="x">\n<xacro:macro name="other">\n  <joint name="shoulder" type="fixed"/>\n</xacro:macro>\n</robot>\n')
        done = self.run_tool("--rename", "joint:shoulder=hinge", "lamp_description/urdf/lamp.urdf", "lamp_moveit_config/config/lamp.srdf")
        self.assertIn("`shoulder` is still named in 'lamp_moveit_config/config/lamp.urdf.xacro' (line 3); change it there", done.stderr)

    def test_controllers_of_moveit_in_ros_1_are_renamed(self):
        lists = "controller_list:\n  - name: arm\n    joints:\n      - shoulder\n  - name: hand\n    joints: []\n"
        self.write("lamp_moveit_config/config/fake_controllers.yaml", lists)
        self.expect(0, "--rename", "joint:shoulder=hinge", ".")
        self.assertEqual(self.companion("fake_controllers.yaml"), lists.replace("shoulder", "hinge"))

    def test_controllers_of_ros_1_are_renamed(self):
        lists = """lamp:
  hardware_interface:
    joints:
      - shoulder
    sim_control_mode: 1
  joint_state_controller: {type: joint_state_controller/JointStateController}
  controller_list:
    - name: arm
      joints: [shoulder]
arm:
  type: effort_controllers/JointTrajectoryController
  joints: [shoulder, other]
  gains:
    shoulder: {p: 1}
"""
        for text in (lists, lists[lists.index("arm:\n  type"):]):
            self.write("lamp_moveit_config/config/ros_controllers.yaml", text)
            self.expect(0, "--rename", "joint:shoulder=hinge", ".")
            self.assertEqual(self.companion("ros_controllers.yaml"), text.replace("shoulder", "hinge"))
            self.expect(0, "--rename", "joint:hinge=shoulder", ".")
            self.assertEqual(self.companion("ros_controllers.yaml"), text)

    def test_controllers_of_moveit_without_a_manager_are_renamed(self):
        text = textwrap.dedent(MOVEIT[MOVEIT.index("\n") + 1:]) + "# controller_manager:\n#   ros__parameters:\n"
        self.write("lamp_moveit_config/config/moveit_controllers.yaml", text)
        self.expect(0, "--rename", "joint:shoulder=hinge", ".")
        self.assertEqual(self.companion("moveit_controllers.yaml"), text.replace("shoulder", "hinge"))

    def test_the_tip_of_a_solver_is_renamed(self):
        self.write("lamp_moveit_config/config/kinematics.yaml", KINEMATICS + "  tip_link: arm\n")
        self.expect(0, "--rename", "link:arm=boom", ".")
        self.assertEqual(self.companion("kinematics.yaml"), KINEMATICS + "  tip_link: boom\n")

    def test_an_srdf_in_xacro(self):
        (self.folder / "lamp_moveit_config/config/lamp.srdf").unlink()
        macro = SRDF.replace('<robot name="lamp">', '<robot xmlns:xacro="x">\n<xacro:macro name="groups" params="name">') \
            .replace("</robot>", "</xacro:macro>\n</robot>")
        self.write("lamp_moveit_config/config/groups.srdf.xacro", macro)
        self.write("lamp_moveit_config/config/lamp.srdf.xacro",
                   '<robot xmlns:xacro="x" name="$(arg name)">\n  <xacro:arg name="name" default="lamp"/>\n'
                   '  <xacro:include filename="groups.srdf.xacro"/>\n  <xacro:groups name="arm"/>\n</robot>\n')
        self.assertIn("checked with 1 SRDF", self.expect(0, ".").stdout)
        self.write("lamp_moveit_config/config/groups.srdf.xacro", macro.replace('"shoulder"', '"sholder"'))
        for paths in ((".",), ("lamp_description/urdf/lamp.urdf",), ("lamp_moveit_config/config/lamp.srdf.xacro", "name:=lamp")):
            done = self.expect(1, *paths)
            self.assertIn("groups.srdf.xacro:", done.stdout)
            self.assertIn("did you mean `shoulder`?", done.stdout)

    def test_rename_in_an_srdf_in_xacro(self):
        (self.folder / "lamp_moveit_config/config/lamp.srdf").unlink()
        groups = SRDF.replace('<robot name="lamp">', '<robot xmlns:xacro="x">\n<xacro:macro name="groups">').replace("</robot>", "</xacro:macro>\n</robot>")
        root = ('<robot xmlns:xacro="x" name="lamp">\n  <xacro:include filename="groups.xacro"/>\n  <xacro:groups/>\n'
                '  <passive_joint name="shoulder"/>\n</robot>\n')
        self.write("lamp_moveit_config/config/groups.xacro", groups)
        self.write("lamp_moveit_config/config/lamp.srdf.xacro", root)
        (self.folder / "lamp_description/urdf/lamp.urdf").unlink()
        self.write("lamp_description/urdf/lamp.urdf.xacro", URDF.replace("<robot ", '<robot xmlns:xacro="x" '))
        self.expect(0, "--rename", "joint:shoulder=hinge", "lamp_description/urdf/lamp.urdf.xacro")
        self.assertEqual(self.companion("groups.xacro"), groups.replace("shoulder", "hinge"))
        self.assertEqual(self.companion("lamp.srdf.xacro"), root.replace("shoulder", "hinge"))

    def test_a_file_of_several_robots_is_judged_with_the_one_that_it_fits(self):
        self.write("lamp_description/urdf/fixed.urdf", URDF.replace('"shoulder"', '"stiff"').replace('name="lamp"', 'name="fixed"'))
        more = URDF.replace('<command_interface name="position"/>', '<command_interface name="velocity"/>')
        self.write("lamp_description/urdf/fast.urdf", more.replace('name="lamp"', 'name="fast"'))
        self.assertIn("SML3705", self.expect(1, "lamp_description/urdf/fast.urdf").stdout)
        self.assertNotIn("SML3705", self.expect(0, ".").stdout)

    def test_rename_of_a_group(self):
        self.expect(0, "--rename", "group:arm=manipulator", ".")
        self.assertIn('group="manipulator"', self.companion("lamp.srdf"))
        self.assertEqual(self.companion("kinematics.yaml"), KINEMATICS.replace("arm:", "manipulator:"))

    def test_the_configuration_ties_a_file_to_a_robot(self):
        other = CONTROLLERS.replace("shoulder", "left_shoulder").replace("[position]", "[effort]", 1)
        self.write("elsewhere/params.yaml", other)
        self.expect(0, ".")
        self.write(".smurf-lint.yaml", "companions:\n- robot: lamp_description/urdf/lamp.urdf\n  files: elsewhere/params.yaml\n")
        done = self.expect(1, "lamp_description/urdf/lamp.urdf")
        self.assertIn("2 controllers.yaml", done.stdout)
        self.assertIn("SML3706", done.stdout)
        self.assertIn("- robot: ", self.expect(0, "--show-config", ".").stdout)

    def test_a_file_that_is_tied_to_a_robot_is_not_judged_with_others(self):
        self.write("lamp_description/urdf/bulb.urdf", URDF.replace('name="lamp"', 'name="bulb"'))
        self.write(".smurf-lint.yaml", "companions:\n- robot: lamp_description/urdf/bulb.urdf\n"
                   "  files: [lamp_moveit_config/config/ros2_controllers.yaml]\n")
        self.assertNotIn("controllers.yaml", self.expect(0, "lamp_description/urdf/lamp.urdf").stdout.replace("moveit_controllers", ""))
        self.assertIn("1 controllers.yaml", self.expect(0, "lamp_description/urdf/bulb.urdf").stdout)

    def test_wrong_ties_are_findings(self):
        for text, message in (("companions: 1\n", "must be a list of robots"), ("companions: [{files: [a]}]\n", "has no `robot`"),
                              ("companions: [{robot: nobody.urdf}]\n", "there is no file"),
                              ("companions: [{robot: lamp_description/urdf/lamp.urdf, file: a}]\n", "known are `robot` and `files`")):
            self.write(".smurf-lint.yaml", text)
            self.assertIn(message, self.expect(1, ".").stdout)

    def test_a_rename_that_leaves_names_behind_is_refused(self):
        self.write("lamp_moveit_config/config/ros2_controllers.yaml", "# {% if x %}\n{{ x }}: [\n" + CONTROLLERS)
        done = self.expect(2, "--rename", "joint:shoulder=hinge", ".")
        self.assertIn("ros2_controllers.yaml' still names `shoulder` in line 11", done.stderr)
        self.assertIn("--force", done.stderr)
        self.assertEqual(self.companion("lamp.srdf"), SRDF)
        done = self.run_tool("--rename", "joint:shoulder=hinge", "--force", ".")
        self.assertEqual(done.returncode, 0)
        self.assertIn("still names", done.stderr)
        self.assertEqual(self.companion("lamp.srdf"), SRDF.replace("shoulder", "hinge"))

    def test_a_rename_in_a_macro_of_another_robot_is_refused(self):
        macro = URDF.replace('<robot name="lamp">', '<robot xmlns:xacro="x">\n<xacro:macro name="lamp">').replace("</robot>", "</xacro:macro>\n</robot>")
        self.write("lamp_description/urdf/lamp.xacro", macro)
        (self.folder / "lamp_description/urdf/lamp.urdf").unlink()
        for name in ("lamp", "lamp2"):
            self.write(f"lamp_description/urdf/{name}.urdf.xacro",
                       f'<robot xmlns:xacro="x" name="{name}">\n  <xacro:include filename="lamp.xacro"/>\n  <xacro:lamp/>\n</robot>\n')
        self.write("lamp_moveit_config/config/lamp2.srdf", SRDF.replace('"lamp"', '"lamp2"'))
        done = self.expect(2, "--rename", "joint:shoulder=hinge", "lamp_description/urdf/lamp.urdf.xacro")
        self.assertIn("lamp2.srdf' still names `shoulder` in line 6", done.stderr)
        self.assertIn("lamp2.urdf.xacro' includes a changed file; name it, too", done.stderr)
        self.write("lamp_description/urdf/lamp3.urdf.xacro",
                   '<robot xmlns:xacro="x" name="lamp3">\n  <xacro:include filename="lamp.xacro"/>\n  <xacro:lamp/>\n</robot>\n')
        done = self.expect(2, "--rename", "joint:shoulder=hinge", "lamp_description/urdf/lamp.urdf.xacro")
        self.assertRegex(done.stderr, "lamp2.urdf.xacro' and '.*lamp3.urdf.xacro' include changed files; name them, too")
        self.expect(0, "--rename", "joint:shoulder=hinge", ".")
        self.assertIn('"hinge"', self.companion("lamp2.srdf"))

    def test_rename_of_names_behind_a_prefix(self):
        for name, text in self.files.items():
            self.write("lamp_moveit_config/config/" + name, text.replace("shoulder", "left_shoulder"))
        xacro = URDF.replace('"shoulder"', '"${side}_shoulder"').replace(
            '<robot name="lamp">', '<robot name="lamp" xmlns:xacro="x">\n  <xacro:macro name="body" params="side">') \
            .replace("</robot>", "  </xacro:macro>\n  <xacro:body side=\"left\"/>\n</robot>")
        (self.folder / "lamp_description/urdf/lamp.urdf").unlink()
        self.write("lamp_description/urdf/lamp.urdf.xacro", xacro)
        self.expect(0, "--rename", "joint:left_shoulder=left_hinge", ".")
        self.assertEqual(self.read("lamp_description/urdf/lamp.urdf.xacro"), xacro.replace("_shoulder", "_hinge"))
        for name, text in self.files.items():
            self.assertEqual(self.companion(name), text.replace("shoulder", "left_hinge").replace("# left_hinge", "# left_shoulder"), name)
        self.expect(0, "--rename", "joint:left_hinge=left_shoulder", ".")
        self.assertEqual(self.read("lamp_description/urdf/lamp.urdf.xacro"), xacro)
        # The prefix is written in the call.
        self.expect(0, "--rename", "joint:left_shoulder=right_shoulder", ".")
        self.assertEqual(self.read("lamp_description/urdf/lamp.urdf.xacro"), xacro.replace('"left"', '"right"'))
        done = self.expect(2, "--rename", "joint:right_shoulder=hinge", ".")
        self.assertIn("; choose a name like `right_NEW`" if "right_NEW" in done.stderr else "`rightNEW`", done.stderr)

    def test_rename_of_names_that_macros_get(self):
        xacro = URDF.replace('"shoulder"', '"${hinge}"').replace('name="hardware"', 'name="${hinge}_drive"').replace(
            '<robot name="lamp">', '<robot name="lamp" xmlns:xacro="x">\n  <xacro:property name="prefix" value=""/>\n'
            '  <xacro:macro name="body" params="hinge">').replace(
            "</robot>", '  </xacro:macro>\n  <xacro:body hinge="${prefix}shoulder"/>\n</robot>')
        (self.folder / "lamp_description/urdf/lamp.urdf").unlink()
        self.write("lamp_description/urdf/lamp.urdf.xacro", xacro)
        self.expect(0, "--rename", "joint:shoulder=knee", ".")
        self.assertEqual(self.read("lamp_description/urdf/lamp.urdf.xacro"), xacro.replace("}shoulder", "}knee"))
        self.expect(0, "--rename", "joint:knee=shoulder", ".")
        self.assertEqual(self.read("lamp_description/urdf/lamp.urdf.xacro"), xacro)

    def test_a_part_of_a_name_that_other_names_have_stays(self):
        xacro = URDF.replace('"shoulder"', '"${side}_shoulder"').replace('link name="arm"', 'link name="${side}_arm"') \
            .replace('child link="arm"', 'child link="${side}_arm"').replace('name="hardware"', 'name="${side}"') \
            .replace('  <link name="base"/>\n', "") \
            .replace('<robot name="lamp">', '<robot name="lamp" xmlns:xacro="x">\n  <link name="base"/>\n  <xacro:macro name="body" params="side">') \
            .replace("</robot>", '  </xacro:macro>\n  <xacro:body side="left"/>\n  <xacro:body side="right"/>\n</robot>')
        (self.folder / "lamp_description/urdf/lamp.urdf").unlink()
        self.write("lamp_description/urdf/lamp.urdf.xacro", xacro)
        done = self.expect(2, "--rename", "joint:left_shoulder=left_hinge", "lamp_description/urdf/lamp.urdf.xacro")
        self.assertIn("also names the joint `right_shoulder`", done.stderr)
        done = self.expect(2, "--rename", "link:left_arm=first_arm", "lamp_description/urdf/lamp.urdf.xacro")
        self.assertIn("also names the", done.stderr)
        self.assertEqual(self.read("lamp_description/urdf/lamp.urdf.xacro"), xacro)

    def test_robots_that_share_a_part_are_renamed_together(self):
        (self.folder / "lamp_description/urdf/lamp.urdf").unlink()
        part = URDF.replace('  <link name="base"/>\n', "").replace('<robot name="lamp">', '<robot xmlns:xacro="x">')
        self.write("lamp_description/urdf/arm.xacro", part)
        robots = {name: f'<robot xmlns:xacro="x" name="{name}">\n  <link name="base"/>\n  <xacro:include filename="arm.xacro"/>\n</robot>\n'
                  for name in ("lamp", "lamp2")}
        for name, text in robots.items():
            self.write(f"lamp_description/urdf/{name}.urdf.xacro", text)
        self.expect(0, "--rename", "link:base=foot", ".")
        for name, text in robots.items():
            self.assertEqual(self.read(f"lamp_description/urdf/{name}.urdf.xacro"), text.replace('"base"', '"foot"'))
        self.assertIn('<parent link="foot"/>', self.read("lamp_description/urdf/arm.xacro"))
        # Without the part in common, they are two things.
        for name, text in robots.items():
            self.write(f"lamp_description/urdf/{name}.urdf.xacro", text.replace('  <xacro:include filename="arm.xacro"/>\n', ""))
        self.assertIn("there are two", self.expect(2, "--rename", "link:base=foot", ".").stderr)

    def test_rename_of_joints_in_texts(self):
        more = CONTROLLERS.replace("[position]", "[position]", 1) + """    speed_scaling: {state_interface: shoulder/position}
    ik: {chain_tip: arm, chain_root: base_link}
chained:
  ros__parameters:
    joints: [pid/shoulder, "shoulder_2"]
"""
        planners = "planner_configs: {A: {type: geometric::EST}}\narm:\n  planner_configs: [A]\n  projection_evaluator: joints(shoulder,shoulder)\n"
        self.write("lamp_moveit_config/config/ros2_controllers.yaml", more)
        self.write("lamp_moveit_config/config/ompl_planning.yaml", planners)
        self.expect(0, "--rename", "joint:shoulder=hinge", ".")
        self.assertEqual(self.companion("ros2_controllers.yaml"), more.replace("shoulder", "hinge").replace("# hinge", "# shoulder")
                         .replace("hinge_2", "shoulder_2"))
        self.assertEqual(self.companion("ompl_planning.yaml"), planners.replace("shoulder", "hinge"))
        self.expect(0, "--rename", "link:arm=boom", ".")
        self.assertIn("chain_tip: boom, chain_root: base_link", self.companion("ros2_controllers.yaml"))

    def test_the_parameter_file_of_a_gazebo_plugin(self):
        plugin = ('  <gazebo>\n    <plugin filename="gz_ros2_control-system" name="control">\n'
                  "      <parameters>$(find lamp_bringup)/settings/all.yaml</parameters>\n    </plugin>\n  </gazebo>\n</robot>")
        (self.folder / "lamp_description/urdf/lamp.urdf").unlink()
        self.write("lamp_bringup/package.xml", cli.package("lamp_bringup"))
        self.write("lamp_description/urdf/lamp.urdf.xacro", URDF.replace("<robot ", '<robot xmlns:xacro="x" ').replace("</robot>", plugin))
        done = self.expect(0, ".")
        self.assertIn("all.yaml`, which does not exist", done.stdout)
        self.write("lamp_bringup/settings/all.yaml", "talker:\n  ros__parameters: {rate: 1}\n")
        self.assertIn("has no section `controller_manager`", self.expect(0, ".").stdout)
        self.write("lamp_bringup/settings/all.yaml", CONTROLLERS.replace("rate: 100", "rate: 0"))
        self.assertIn("SML3707", self.expect(1, ".").stdout)

    def test_meshes_of_a_package_in_a_folder_of_another_name(self):
        arm = URDF.replace('<link name="base"/>', '<link name="base"><visual><geometry><mesh filename="package://lamp_meshes/foot.stl"/></geometry>'
                           "</visual></link>")
        self.write("lamp_description/urdf/lamp.urdf", arm)
        self.write("lamp_moveit_config/config/lamp.urdf.xacro", '<robot xmlns:xacro="x" name="lamp">\n'
                   '  <xacro:include filename="$(find lamp_description)/urdf/lamp.urdf"/>\n</robot>\n')
        self.write("shapes/package.xml", cli.package("lamp_meshes"))
        path = "lamp_moveit_config/config/lamp.urdf.xacro"
        self.assertIn("file not found: `package://lamp_meshes/foot.stl`", self.expect(1, path).stdout)
        self.write("shapes/foot.stl", "solid foot\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0.1 0 0\nvertex 0 0.1 0.1\n"
                   "endloop\nendfacet\nendsolid foot\n")
        self.assertNotIn("SML1604", self.expect(None, path).stdout)

    def test_robots_that_were_not_expanded_are_counted(self):
        (self.folder / "lamp_description/urdf/lamp.urdf").unlink()
        self.write("lamp_description/urdf/lamp.urdf.xacro", URDF.replace('name="lamp"', 'name="$(arg name)" xmlns:xacro="x"'))
        done = self.expect(0, "--target", "gazebo", ".")
        self.assertIn("1 robot was not checked, because arguments have no value; `smurf-lint --init`", done.stdout)
        self.assertRegex(done.stdout, r"gazebo +not known")
        self.expect(0, "--init")
        done = self.expect(0, ".")
        self.assertIn("1 robot was not checked, because arguments have no value; --min-severity info shows which", done.stdout)
        self.assertRegex(done.stdout, r"ros +not known")
        (self.folder / ".smurf-lint.yaml").unlink()
        self.assertNotIn("was not checked", self.expect(0, "lamp_description/urdf/lamp.urdf.xacro", "name:=lamp").stdout)

    def test_variants_of_a_robot_have_one_title(self):
        (self.folder / "lamp_description/urdf/lamp.urdf").unlink()
        self.write("lamp_description/urdf/lamp.urdf.xacro", URDF.replace('name="lamp"', 'name="lamp" xmlns:xacro="x"').replace(
            '<mass value="0.5"/>', '<mass value="$(arg mass)"/>').replace('"0 1 0"', '"$(arg axis)"'))
        self.write("other.urdf", "<robot/>\n")
        self.write(".smurf-lint.yaml", "xacro:\n- file: lamp_description/urdf/lamp.urdf.xacro\n  arguments: {mass: [-1, -2], axis: 0 0 0}\n")
        done = self.expect(1, ".")
        self.assertEqual(done.stdout.count("lamp.urdf.xacro: "), 1, done.stdout)
        self.assertIn("with mass:=-1", done.stdout)
        self.assertIn("... and the same in 1 more robot\n", done.stdout)

    def test_controllers_that_a_package_exports(self):
        text = CONTROLLERS.replace("    update_rate: 100\n", "    update_rate: 100\n    glow:\n      type: lamp_description/Glow\n") + "glow:\n  ros__parameters: {}\n"
        self.write("lamp_moveit_config/config/ros2_controllers.yaml", text)
        self.assertNotIn("SML3704", self.expect(0, ".").stdout)  # the package exports nothing
        plugins = '<library path="glow">\n  <class name="lamp_description/{}" type="lamp::Glow" base_class_type="controller_interface::ControllerInterface"/>\n</library>\n'
        self.write("lamp_description/controllers.xml", plugins.format("GlowController"))
        done = self.expect(None, ".")
        self.assertIn("controller `glow` has the unknown type `lamp_description/Glow`", done.stdout)
        self.assertIn("`lamp_description/GlowController`", done.stdout)
        self.write("lamp_description/controllers.xml", plugins.format("Glow"))
        self.assertNotIn("SML3704", self.expect(0, ".").stdout)

    def test_targets(self):
        self.write("lamp_moveit_config/config/lamp.srdf", SRDF.replace('tip_link="arm"', 'tip_link="amr"'))
        done = self.expect(1, "--target", "moveit", ".")
        self.assertIn("drops the member of the group", done.stdout)
        self.write("lamp_description/urdf/lamp.urdf", URDF.replace("<plugin>", "<plugn>").replace("</plugin>", "</plugn>"))
        done = self.expect(1, "--target", "ros2_control", ".")
        self.assertIn("loads no hardware at all", done.stdout)
        self.assertIn("fails to load", done.stdout)


if __name__ == "__main__":
    cli.main()
