# SPDX-License-Identifier: BSD-3-Clause
"""Slips in the files of ROS around a robot, each beside its cure. ros_slips_test.py SMURF-LINT"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import cli  # noqa: E402
import companions_test as lamp  # noqa: E402


class SlipTest(lamp.Lamp):
    def test_every_parameter_file_is_yaml(self):
        """Also one of which nothing but this is known, such as that of a filter."""
        text = "filter:\n  ros__parameters:\n    frequency: 30.0\n"
        self.write("lamp_description/config/filter.yaml", text)
        self.assertNotIn("SML0010", self.expect(0, ".").stdout)
        self.write("lamp_description/config/filter.yaml", text.replace("  ros__", "\tros__"))
        done = self.expect(1, ".")
        self.assertIn("lamp_description/config/filter.yaml:2:1", done.stdout)
        self.assertIn("the program of ROS that reads this file ends", done.stdout)
        self.write("lamp_description/config/filter.yaml", text.replace("30.0", "{{ rate }}: a"))
        self.assertNotIn("SML0010", self.expect(0, ".").stdout)  # a template

    def test_a_manifest_is_xml(self):
        """Colcon stops at it; an empty one only marks a folder."""
        manifest = (self.folder / "lamp_description/package.xml").read_text(encoding="utf-8")
        self.assertNotIn("SML4401", self.run_tool(".").stdout)
        self.write("lamp_description/package.xml", manifest.replace("</package>", ""))
        done = self.expect(1, "--target", "ros,mujoco", ".").stdout
        self.assertIn("error[SML4401]: package.xml is not well-formed: ", done)
        self.assertIn("lamp_description/package.xml:", done)
        self.assertEqual(done.count("SML4401]"), 1, done)
        self.assertIn("mujoco  loads\n", done)
        self.write("lamp_description/package.xml", "")
        self.assertNotIn("SML4401", self.run_tool(".").stdout)

    def test_a_default_below_its_use(self):
        """The robot is checked with it, although xacro stops."""
        (self.folder / "lamp_description/urdf/lamp.urdf").unlink()
        default, late = '<xacro:arg name="side" default="left"/>', '<link name="$(arg side)_eye"/>'
        text = lamp.URDF.replace("<robot ", '<robot xmlns:xacro="x" ')
        late = late + '<joint name="eye" type="fixed"><parent link="base"/><child link="$(arg side)_eye"/></joint>'
        self.write("lamp_description/urdf/lamp.urdf.xacro", text.replace("</robot>", default + late + "</robot>"))
        self.assertNotIn("SML3313", self.expect(0, ".").stdout)
        self.write("lamp_description/urdf/lamp.urdf.xacro", text.replace("</robot>", late + default + "</robot>"))
        done = self.expect(0, ".")
        self.assertIn("warning[SML3313]: the argument `side` is used above its default", done.stdout)
        self.assertIn("with `side:=left`", done.stdout)

    def test_a_virtual_joint_of_a_robot_on_a_link_world(self):
        on_world = lamp.URDF.replace('<link name="base"/>', '<link name="world"/><joint name="stand" type="fixed"><parent link="world"/>'
                                '<child link="base"/></joint><link name="base"/>')
        self.write("lamp_description/urdf/lamp.urdf", on_world)
        joint = '<virtual_joint name="v" type="fixed" parent_frame="{}" child_link="base"/></robot>'
        for frame, level in ("world", "info"), ("map", "warning"):
            self.write("lamp_moveit_config/config/lamp.srdf", lamp.SRDF.replace("</robot>", joint.format(frame)))
            self.assertIn(f"{level}[SML3506]", self.expect(0, "--min-severity", "info", ".").stdout)

    def test_wheels_that_turn_against_each_other(self):
        wheel = """<link name="{0}"/><joint name="{0}_joint" type="continuous"><parent link="base"/><child link="{0}"/>
        <origin xyz="0 {1} 0"/><axis xyz="0 {2} 0"/></joint>"""
        controllers = lamp.CONTROLLERS.replace("trajectory:\n      type: joint_trajectory_controller/JointTrajectoryController",
                                          "drive:\n      type: diff_drive_controller/DiffDriveController")
        self.write("lamp_moveit_config/config/ros2_controllers.yaml", controllers[:controllers.index("trajectory:\n  ros")] + """drive:
  ros__parameters:
    left_wheel_names: [left_joint]
    right_wheel_names: [right_joint]
    wheel_separation: 0.4
    wheel_radius: 0.1
""")
        for axis, is_found in (1, False), (-1, True):
            wheels = wheel.format("left", 0.2, 1) + wheel.format("right", -0.2, axis)
            self.write("lamp_description/urdf/lamp.urdf", lamp.URDF.replace("</robot>", wheels + "</robot>"))
            self.assertEqual("point in opposite directions" in self.expect(None, ".").stdout, is_found)

    def test_a_pair_that_moveit_checks(self):
        body = '<collision><origin xyz="0 0 {}"/><geometry><box size="0.1 0.1 0.1"/></geometry></collision>'
        text = lamp.URDF.replace('<link name="base"/>', '<link name="base"/><link name="tip">' + body.format(0.08) + "</link>"
                            '<joint name="bend" type="continuous"><parent link="arm"/><child link="tip"/></joint><link name="foot">' + body.format(0) +
                            '</link><joint name="stand" type="fixed"><parent link="base"/><child link="foot"/></joint>')
        self.write("lamp_description/urdf/lamp.urdf", text)
        pair = '<disable_collisions link1="{}" link2="{}" reason="Adjacent"/></robot>'
        self.assertNotIn("warning[SML1655]", self.expect(None, ".").stdout)  # no list of pairs
        self.write("lamp_moveit_config/config/lamp.srdf", lamp.SRDF.replace("</robot>", pair.format("arm", "tip")))
        self.assertIn("so every plan starts in a collision", self.expect(None, ".").stdout)
        self.write("lamp_moveit_config/config/lamp.srdf", lamp.SRDF.replace("</robot>", pair.format("foot", "tip")))
        self.assertNotIn("SML1655", self.expect(None, ".").stdout)


if __name__ == "__main__":
    cli.main()
