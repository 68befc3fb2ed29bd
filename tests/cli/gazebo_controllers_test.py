# SPDX-License-Identifier: BSD-3-Clause
"""Motors in SDF are systems of Gazebo that command joints."""
import xml.etree.ElementTree as ElementTree

import cli


def link(name):
    return (f'<link name="{name}"><inertial><mass value="1"/>'
            '<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>')


def joint(name, parent, child):
    return (f'<joint name="{name}" type="revolute"><parent link="{parent}"/><child link="{child}"/>'
            '<axis xyz="0 0 1"/><limit lower="-2" upper="2" effort="50" velocity="3"/></joint>')


URDF = ('<robot name="arm">' + link("base") + link("upper") + link("lower") + link("hand") + joint("shoulder", "base", "upper") +
        joint("elbow", "upper", "lower") + joint("wrist", "lower", "hand") + "{}</robot>")
MOTORS = """motors:
  - {name: m1, joint: shoulder, type: PID, maxSpeed: 2, maxEffort: 40, p: 20}
  - {name: m2, joint: elbow, type: DC, maxSpeed: 2, maxEffort: 40}
"""


class GazeboControllersTest(cli.CliTest):
    def controllers(self, *arguments, extra=""):
        """By joint: the name of the system and its parameters."""
        self.write("arm.urdf", URDF.format(extra))
        self.write("arm.smurf", "modelname: arm\nfiles: [arm.urdf, motors.yml]\n")
        self.write("motors.yml", MOTORS)
        self.done = self.run_tool(arguments[0], "--format", "sdf", "-o", "out.sdf", *arguments[1:])
        self.assertEqual(self.done.returncode, 0, self.done.stderr)
        found = {}
        for plugin in ElementTree.parse(self.folder / "out.sdf").getroot().iter("plugin"):
            parts = {part.tag: part.text for part in plugin}
            if "joint_name" in parts:
                self.assertTrue(plugin.get("filename").startswith("gz-sim-"))
                found[parts.pop("joint_name")] = (plugin.get("name").rsplit(":", 1)[-1], parts)
        return found

    def test_motors_of_a_model(self):
        self.assertEqual(self.controllers("arm.smurf"), {
            "shoulder": ("JointPositionController", {"use_velocity_commands": "true", "cmd_max": "2"}),
            "elbow": ("JointController", {})})
        self.assertNotIn("2 motors", self.done.stderr)
        self.assertEqual(self.controllers("arm.urdf"), {})

    def test_options(self):
        found = self.controllers("arm.urdf", "--actuator", "auto")
        self.assertEqual(found, {name: ("JointPositionController", {"use_velocity_commands": "true", "cmd_max": "3"})
                                 for name in ("shoulder", "elbow", "wrist")})
        found = self.controllers("arm.urdf", "--actuator", "effort")
        self.assertEqual({system for system, _ in found.values()}, {"ApplyJointForce"})
        found = self.controllers("arm.urdf", "--actuator", "position", "--kp", "100", "--kv", "5", "--kp", "wrist=10")
        gains = {"p_gain": "100", "i_gain": "0", "d_gain": "5", "cmd_max": "50", "cmd_min": "-50"}
        self.assertEqual(found["elbow"], ("JointPositionController", gains))
        self.assertEqual(found["wrist"], ("JointPositionController", {**gains, "p_gain": "10"}))

    def test_a_joint_of_sdf_has_no_armature(self):
        self.write("arm.urdf", URDF.format(""))
        done = self.run_tool("arm.urdf", "--format", "sdf", "--actuator", "auto", "--armature", "1")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("--armature needs one of the formats mjcf", done.stderr)

    def test_a_plugin_that_commands_the_joints_stays_alone(self):
        plugin = '<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin"/></gazebo>'
        for robot in ("arm.smurf", "arm.urdf"):
            self.assertEqual(self.controllers(robot, "--actuator", "auto", extra=plugin), {})
        self.controllers("arm.smurf", extra=plugin)
        self.assertIn("2 motors", self.done.stderr)


if __name__ == "__main__":
    cli.main()
