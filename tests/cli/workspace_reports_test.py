# SPDX-License-Identifier: BSD-3-Clause
"""Reports of workspaces as students have them: which robots are fine, one block for a cause, launch files in all their forms.

workspace_reports_test.py SMURF-LINT
"""
import json
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import cli  # noqa: E402

JOINTS = ("shoulder", "elbow", "wrist", "hand")
MASS = '<inertial><mass value="0.5"/><inertia ixx="0.00013" ixy="0" ixz="0" iyy="0.00013" iyz="0" izz="0.00013"/></inertial>'
OPEN_ARGUMENT = '  <gazebo reference="base"><material>Gazebo/$(arg side)</material></gazebo>\n'


def robot(name, joints=JOINTS, more="", limits='lower="-1" upper="1"', mass=MASS):
    text, parent = f'<robot name="{name}" xmlns:xacro="http://www.ros.org/wiki/xacro">\n{more}  <link name="base"/>\n', "base"
    for joint in joints:
        text += (f'  <link name="{joint}_link">{mass}</link>\n  <joint name="{joint}" type="revolute">\n    <parent link="{parent}"/>'
                 f'<child link="{joint}_link"/><axis xyz="0 0 1"/>\n    <limit {limits} effort="1" velocity="1"/>\n  </joint>\n')
        parent = joint + "_link"
    return text + "</robot>\n"


def srdf(name, *joints):
    lines = "".join(f'    <joint name="{one}"/>\n' for one in joints)
    return f'<robot name="{name}">\n  <group name="arm">\n{lines}  </group>\n</robot>\n'


def controllers(joints=JOINTS, kind="    jtc: {type: joint_trajectory_controller/JointTrajectoryController}\n"):
    return (f"controller_manager:\n  ros__parameters:\n{kind}    update_rate: 100\n"
            f"jtc:\n  ros__parameters:\n    joints: [{', '.join(joints)}]\n    command_interfaces: [position]\n    state_interfaces: [position]\n")


def python_launch(body):
    return ("from launch import LaunchDescription\nfrom launch_ros.actions import Node\n"
            f"def generate_launch_description():\n{body}\n    return LaunchDescription([node])\n")


class WorkspaceReports(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.enter_workspace()
        self.write("bot_description/package.xml", cli.package("bot_description", "xacro", "controller_manager"))

    def report(self, *words):
        return json.loads(self.run_tool("--format", "json", "--min-severity", "info", *words).stdout)

    def ids(self, *words):
        return [one["id"] for one in self.report(*words)["diagnostics"]]

    # The first line: which robots are fine.

    def test_a_robot_that_is_not_expanded_is_not_fine(self):
        self.write("bot_description/urdf/a.urdf.xacro", robot("a", more=OPEN_ARGUMENT))
        self.write("bot_description/urdf/b.urdf.xacro", robot("b"))
        head = self.expect(0, ".").stdout.split("\n\n")[0].replace("\n", " ")
        self.assertEqual(head, "2 robots: 1 is fine (bot_description/urdf/b.urdf.xacro), 1 is not checked "
                               "(bot_description/urdf/a.urdf.xacro)")

    def test_an_error_in_a_launch_file_is_no_error_of_each_robot(self):
        for name in "ab":
            self.write(f"bot_description/urdf/{name}.urdf", robot(name))
        self.write("bot_description/urdf/c.urdf", robot("c").replace('<axis xyz="0 0 1"/>', '<axis xyz="0 0 0"/>', 1))
        self.write("bot_description/launch/all.launch.py", python_launch("    node = Node(package='xacro', executable='xacro'"))
        found = self.expect(1, ".").stdout
        self.assertIn("SML4213", found)
        self.assertRegex(found.split("\n\n")[0].replace("\n", " "), r"^3 robots: 2 are fine \(\S+/a.urdf and \S+/b.urdf\), 1 has ")

    def test_an_error_in_controllers_is_one_of_the_robot_that_has_them(self):
        self.write("bot_description/urdf/a.urdf", robot("a"))
        self.write("bot_description/urdf/b.urdf", robot("b", ["left", "right"]))
        self.write("bot_description/config/controllers.yaml", controllers(["shoulder", "elbw", "wrist", "hand"]))
        head = self.expect(1, ".").stdout.split("\n\n")[0].replace("\n", " ")
        self.assertRegex(head, r"^2 robots: 1 is fine \(\S+/b.urdf\), 1 has errors \(\S+/a.urdf\)$")

    # One cause is one block.

    def blocks(self, *words):
        return [line for line in self.run_tool(*words).stdout.splitlines() if line.startswith(("error[", "warning["))]

    def test_numbers_and_remedies_make_no_second_block(self):
        text = robot("a")
        for i, limits in enumerate(('lower="1.5" upper="-1.5"', 'lower="0" upper="-1e-2"', 'lower="2" upper="0"')):
            text = text.replace('lower="-1" upper="1"', limits, 1)
        self.write("bot_description/urdf/a.urdf", text)
        self.assertEqual(len(self.blocks(".")), 1)
        self.assertIn("... and the same for `elbow` and `wrist` in this file", self.run_tool(".").stdout)

    def test_what_other_fixes_write_is_named(self):
        self.write("bot_description/urdf/a.urdf", robot("a", ["left_hip", "left_knee", "left_foot", "left_toes"]))
        self.write("bot_description/config/controllers.yaml", controllers(["lefthip", "leftknee", "left_foot", "left_toes"]))
        found = self.expect(1, ".").stdout
        self.assertEqual(len(self.blocks(".")), 1)
        self.assertIn("did you mean `left_hip`?", found)
        self.assertIn("... and the same for `leftknee` (`left_knee`) in this file", found)

    def test_two_files_with_one_cause_are_one_block(self):
        for name in "ab":
            self.write(f"bot_description/urdf/{name}.urdf", robot(name, ["shoulder", name], limits='lower="0.5" upper="-0.5"'))
        self.assertEqual(len(self.blocks(".")), 1)
        self.assertIn("... and the same in 1 more file: bot_description/urdf/b.urdf", self.run_tool(".").stdout)

    def test_misspelt_names_in_two_files_are_both_shown(self):
        self.write("bot_description/urdf/a.urdf", robot("a"))
        self.write("bot_description/config/one_controllers.yaml", controllers(["shoulder", "elbw", "wrist", "hand"]))
        self.write("bot_description/config/two_controllers.yaml", controllers(["shoulder", "elbow", "wrst", "hand"]))
        found = self.expect(1, ".").stdout
        self.assertIn("`elbw`", found)
        self.assertIn("`wrst`", found)

    def test_a_model_without_links_is_not_reported_beside_the_file_that_it_lacks(self):
        model = '<model name="m%d">\n<include>\n<uri>model://chair%d</uri>\n</include>\n</model>\n'
        self.write("worlds/hall.sdf", '<sdf version="1.9">\n<world name="w">\n' + "".join(model % (i, i) for i in range(3)) + "</world>\n</sdf>\n")
        self.assertEqual(set(self.ids("worlds/hall.sdf")), {"SML9312"})

    # Launch files.

    def test_a_launch_file_with_the_ending_of_xml_may_be_python(self):
        self.write("bot_description/urdf/bot.urdf.xacro", robot("bot"))
        good = python_launch("    node = Node(package='rviz2', executable='rviz2')")
        self.write("bot_description/launch/show.launch", good)
        self.assertNotIn("SML4213", self.ids("."))
        self.write("bot_description/launch/show.launch", good.replace("'rviz2')", "'rviz2'"))
        self.assertIn("SML4213", self.ids("."))
        self.write("bot_description/launch/show.launch", "<launch>\n  <node pkg='rviz2' exec='rviz2'>\n</launch>\n")
        self.assertIn("SML4213", self.ids("."))

    def test_the_type_of_a_controller_may_be_in_the_call_of_its_spawner(self):
        self.write("bot_description/urdf/bot.urdf", robot("bot"))
        inner = "    jtc:\n      ros__parameters:\n        type: joint_trajectory_controller/JointTrajectoryController\n"
        self.write("bot_description/config/controllers.yaml", controllers(kind=inner))
        self.write("bot_description/launch/a.launch.py", python_launch(
            "    node = Node(package='controller_manager', executable='spawner', arguments=['jtc'])"))
        found = self.expect(1, ".").stdout
        self.assertIn("controller `jtc` has no `type`", found)
        self.assertIn("delete this `ros__parameters`", found)
        self.write("bot_description/launch/a.launch.py", python_launch(
            "    node = Node(package='controller_manager', executable='spawner',\n"
            "                arguments=['jtc', '--controller-type', 'joint_trajectory_controller/JointTrajectoryController'])"))
        self.assertNotIn("SML3704", self.ids("."))

    def test_a_launch_file_of_ros_1_gives_arguments_to_a_description_with_a_namespace(self):
        self.write("bot_description/urdf/bot.urdf.xacro", robot("bot", more=OPEN_ARGUMENT))
        self.write("bot_description/launch/spawn.launch", """<launch>
  <arg name="side" default="left"/>
  <arg name="model" value="$(find bot_description)/urdf/bot.urdf.xacro"/>
  <param name="/$(arg side)/robot_description" command="
    $(find xacro)/xacro --inorder '$(arg model)'
    side:=$(arg side)"/>
</launch>
""")
        self.assertIn("checked `bot_description/urdf/bot.urdf.xacro` with `side:=left`, from `bot_description/launch/spawn.launch`",
                      self.expect(0, ".").stdout)

    def moveit(self, chain):
        """Two robots with the same joints in two packages, and a configuration of the second that only a launch file ties to it."""
        self.write("bot_description/urdf/bot.urdf.xacro", robot("bot", limits='lower="-1" upper="1"'))
        self.write("arm_description/package.xml", cli.package("arm_description"))
        self.write("arm_description/urdf/arm.urdf.xacro", robot("arm", ["shoulder", "elbow", "wrist", "thumb"], more=OPEN_ARGUMENT))
        self.write("arm_moveit_config/package.xml", cli.package("arm_moveit_config"))
        self.write("arm_moveit_config/config/limits.yaml", "joint_limits:\n  thmb: {has_velocity_limits: true, max_velocity: 0.5}\n")
        self.write("arm_moveit_config/srdf/x.srdf", srdf("other", "shoulder", "elbow", "wrst"))
        self.write("arm_moveit_config/launch/go.launch.py", f"""import os
from ament_index_python.packages import get_package_share_directory
from moveit_configs_utils import MoveItConfigsBuilder
def generate_launch_description():
    side = "left"
    config = (
        MoveItConfigsBuilder("arm")
        {chain}
        .to_moveit_configs()
    )
""")

    def test_the_builder_of_moveit_ties_files_to_a_robot_and_gives_arguments(self):
        self.moveit('.robot_description(file_path=os.path.join(get_package_share_directory("arm_description"), "urdf", "arm.urdf.xacro"),'
                    ' mappings={"side": "left"})\n        .robot_description_semantic("srdf/x.srdf")\n'
                    '        .joint_limits(file_path="config/limits.yaml")')
        found = self.run_tool(".").stdout
        self.assertIn("checked `arm_description/urdf/arm.urdf.xacro` with `side:=left`, from `arm_moveit_config/launch/go.launch.py`", found)
        messages = " ".join(one["message"] for one in self.report(".")["diagnostics"])
        self.assertIn("`wrst`", messages)
        self.assertIn("`thmb`", messages)
        self.assertEqual(self.report(".")["summary"].get("not_compared", []), [])

    def test_a_file_that_the_builder_names_and_nobody_has(self):
        self.moveit('.robot_description(file_path=get_package_share_directory("arm_description") + "/urdf/arm.urdf.xacro",'
                    ' mappings={"side": "left"})\n        .robot_description_semantic(file_path="srdf/y.srdf")')
        self.write("arm_moveit_config/package.xml", cli.package("arm_moveit_config", "arm_description"))
        self.write("arm_moveit_config/CMakeLists.txt", "cmake_minimum_required(VERSION 3.8)\nproject(arm_moveit_config)\n"
                   "find_package(ament_cmake REQUIRED)\ninstall(DIRECTORY srdf config launch DESTINATION share/${PROJECT_NAME})\nament_package()\n")
        self.assertIn("`arm_moveit_config/srdf/y.srdf` does not exist", " ".join(one["message"] for one in self.report(".")["diagnostics"]))

    # Companions.

    def test_an_srdf_with_the_name_of_an_older_robot_belongs_to_the_only_one(self):
        self.write("bot_description/urdf/bot.urdf.xacro", robot("bot"))
        self.write("bot_description/config/bot.srdf", srdf("bot_urdf", "shoulder", "elbow", "wrist", "hand"))
        self.write("bot_description/config/kinematics.yaml", "armm:\n  kinematics_solver: kdl_kinematics_plugin/KDLKinematicsPlugin\n")
        report = self.report(".")
        self.assertEqual(report["summary"].get("not_compared", []), [])
        self.assertEqual(report["summary"]["companions"], {"SRDF": 1, "kinematics.yaml": 1})
        self.assertIn("`armm`", " ".join(one["message"] for one in report["diagnostics"]))

    def test_why_a_file_without_names_is_not_compared(self):
        for name in "ab":
            self.write(f"bot_description/urdf/{name}.urdf.xacro", robot(name))
        self.write("bot_description/config/kinematics.yaml", "arm:\n  kinematics_solver: kdl_kinematics_plugin/KDLKinematicsPlugin\n")
        self.assertIn("it names no joint, and no SRDF beside it belongs to a robot here", self.expect(0, ".").stdout)

    def test_interfaces_that_another_value_of_an_argument_offers(self):
        hardware = ('  <ros2_control name="h" type="system"><hardware><plugin>mock_components/GenericSystem</plugin></hardware>'
                    '<joint name="shoulder"><command_interface name="%s"/><state_interface name="position"/></joint></ros2_control>\n')
        self.write("bot_description/config/controllers.yaml", controllers(["shoulder"]).replace("command_interfaces: [position]", "command_interfaces: [velocity]"))
        self.write("bot_description/urdf/bot.urdf", robot("bot", ["shoulder"], more=hardware % "position"))
        self.assertIn("error[SML3705]", self.expect(1, ".").stdout)
        self.write("bot_description/urdf/bot.urdf.xacro", robot(
            "bot", ["shoulder"], more='  <xacro:arg name="kind" default="position"/>\n' + hardware % "$(arg kind)"))
        self.assertNotIn("error[SML3705]", self.expect(None, ".").stdout)
        self.assertIn("SML3705", self.ids("."))

    # Other languages.

    def test_the_file_of_a_model_may_be_a_urdf(self):
        self.write("models/bot/bot.urdf", robot("bot"))
        self.write("models/bot/model.config", "<?xml version='1.0'?>\n<model><name>bot</name><version>1.0</version><sdf version='1.6'>bot.urdf</sdf></model>\n")
        self.write("worlds/hall.sdf", '<sdf version="1.9"><world name="w"><include><uri>model://bot</uri></include></world></sdf>\n')
        self.assertNotIn("SML9311", self.ids("."))

    def test_the_version_of_a_robot_is_not_that_of_urdf(self):
        self.write("bot_description/urdf/bot.urdf", robot("bot").replace("</robot>", "  <version>2025-09-17</version>\n</robot>"))
        self.assertNotIn("SML1106", self.ids("."))
        self.write("bot_description/urdf/bot.urdf", robot("bot").replace("</robot>", "  <version>1.0</version>\n</robot>"))
        self.assertIn("SML1106", self.ids("."))

    def test_a_static_building_is_large_and_weighs_nothing(self):
        corner = "facet normal 0 0 1\nouter loop\nvertex %s\nvertex %s\nvertex %s\nendloop\nendfacet\n"
        points = ("0 0 0", "90 0 0", "0 90 0", "0 0 9")
        faces = "".join(corner % tuple(points[i] for i in face) for face in ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)))
        self.write("models/hall/hall.stl", f"solid hall\n{faces}endsolid hall\n")
        text = ('<sdf version="1.9">%s<model name="hall">%s<link name="l"><inertial><mass>1</mass></inertial>'
                '<collision name="c"><geometry>%s</geometry></collision></link></model>%s</sdf>\n')
        mesh, box = "<mesh><uri>hall.stl</uri></mesh>", "<box><size>125 125 0.1</size></box>"
        self.write("models/hall/model.sdf", text % ("", "<static>true</static>", mesh, ""))
        self.assertNotIn("SML1630", self.ids("models/hall/model.sdf"))
        self.write("models/hall/model.sdf", text % ("", "", mesh, ""))
        self.assertIn("SML1630", self.ids("models/hall/model.sdf"))
        self.write("worlds/w.sdf", text % ('<world name="w">', "<static>true</static>", box, "</world>"))
        self.assertNotIn("SML1520", self.ids("worlds/w.sdf"))
        self.write("worlds/w.sdf", text % ('<world name="w">', "", box, "</world>"))
        self.assertIn("SML1520", self.ids("worlds/w.sdf"))

    def test_two_dashes_in_a_comment_of_an_sdf_are_no_error(self):
        text = '<?xml version="1.0"?>\n<!-- gz --help -->\n%s\n'
        self.write("a.sdf", text % '<sdf version="1.9"><model name="m"><link name="l"/></model></sdf>')
        self.assertIn("warning[SML1004]", self.expect(0, "a.sdf").stdout)
        self.write("a.urdf", text % '<robot name="m"><link name="l"/></robot>')
        self.assertIn("error[SML1004]", self.expect(1, "a.urdf").stdout)

    def test_what_follows_from_text_that_is_not_expanded(self):
        mesh = '<visual><geometry><mesh filename="file://$(find bot_description)/a.stl"/></geometry></visual>'
        self.write("bot_description/urdf/bot.urdf", f'<robot name="bot"><link name="a">{mesh}</link></robot>\n')
        self.assertEqual({"SML1009"}, {one for one in self.ids(".") if one.startswith(("SML10", "SML16"))})
        part = ('  <xacro:macro name="leg" params="name"><transmission name="{name}_t"><type>SimpleTransmission</type><joint name="{name}_hip"/>'
                '<actuator name="m"/></transmission></xacro:macro>\n  <xacro:leg name="shoulder"/>\n')
        self.write("bot_description/urdf/bot.urdf", robot("bot"))
        self.write("bot_description/urdf/bot.urdf.xacro", robot("bot", more=part))
        found = self.ids("bot_description/urdf/bot.urdf.xacro")
        self.assertIn("SML3408", found)
        self.assertNotIn("SML1443", found)

    def test_a_parameter_without_its_end(self):
        self.write("bot_description/urdf/bot.urdf", robot("bot"))
        self.write("bot_description/config/joint_limits.yaml", "joint_limits:\n  hand: {has_velocity_limits: true, max_velocity: 0.5, has_jerk: false}\n")
        self.assertIn("did you mean `has_jerk_limits`?", self.expect(0, ".").stdout)


if __name__ == "__main__":
    cli.main()
