# SPDX-License-Identifier: BSD-3-Clause
"""SRDFs that are for other arguments of a xacro robot than those with which it is expanded."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import cli  # noqa: E402

MASS = '<inertial><mass value="0.5"/><inertia ixx="0.00013" ixy="0" ixz="0" iyy="0.00013" iyz="0" izz="0.00013"/></inertial>'
ARM = f"""<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="arm">
  <xacro:arg name="dof" default="7"/>
  <xacro:arg name="hand" default="none"/>
  <xacro:include filename="$(find arm_description)/urdf/$(arg dof)dof.xacro"/>
  <xacro:macro name="part" params="parent name">
    <link name="${{name}}">{MASS}</link>
    <joint name="${{name}}_joint" type="revolute">
      <parent link="${{parent}}"/>
      <child link="${{name}}"/>
      <axis xyz="0 0 1"/>
      <limit lower="-1" upper="1" effort="10" velocity="2"/>
    </joint>
  </xacro:macro>
  <link name="base"/>
  <xacro:links/>
  <xacro:if value="${{'$(arg hand)' == 'two_finger'}}">
    <xacro:part parent="base" name="finger"/>
  </xacro:if>
</robot>
"""
MACRO = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="links">
    <xacro:part parent="base" name="lower"/>
    <xacro:part parent="lower" name="{}"/>
    <xacro:part parent="{}" name="wrist"/>
  </xacro:macro>
</robot>
"""
SRDF = """<robot name="arm">
  <group name="all">
    <chain base_link="base" tip_link="wrist"/>
  </group>
  <disable_collisions link1="base" link2="lower" reason="Adjacent"/>
  <disable_collisions link1="lower" link2="{}" reason="Adjacent"/>
  <disable_collisions link1="{}" link2="wrist" reason="Adjacent"/>
  <disable_collisions link1="base" link2="wrist" reason="Never"/>
</robot>
"""


class CompanionVariants(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.enter_workspace()
        self.write("arm_description/package.xml", cli.package("arm_description"))
        self.write("arm_description/urdf/arm.urdf.xacro", ARM)
        for dof, name in ((6, "bicep"), (7, "elbow")):
            self.write(f"arm_description/urdf/{dof}dof.xacro", MACRO.format(name, name))
            self.write(f"arm_moveit_config/config/{dof}dof/arm.srdf", SRDF.format(name, name))
        self.write("arm_moveit_config/package.xml", cli.package("arm_moveit_config", "arm_description"))

    def all_ways(self, expected, name="6dof/arm.srdf"):
        """The report for the folder, for the robot, and for the SRDF."""
        paths = (".", "arm_description/urdf/arm.urdf.xacro", "arm_moveit_config/config/" + name)
        return [self.expect(expected, "--min-severity", "info", path).stdout for path in paths]

    def test_an_srdf_of_a_variant_is_compared_with_it(self):
        for text in self.all_ways(0):
            self.assertIn("no findings", text)
            self.assertIn("SRDF", text)

    def test_a_mistake_in_an_srdf_of_a_variant(self):
        self.write("arm_moveit_config/config/6dof/arm.srdf", SRDF.format("bicep", "bicep").replace('tip_link="wrist"', 'tip_link="wrst"'))
        for text in self.all_ways(1):
            self.assertEqual(text.count("SML3501]"), 1, text)
            self.assertIn("did you mean `wrist`?", text)
            self.assertIn("compared with `", text)
            self.assertIn("with dof:=6", text)

    def test_files_beside_the_srdf_are_for_the_variant(self):
        limits = "joint_limits:\n  bicep_joint:\n    has_velocity_limits: true\n    max_velocity: {}\n"
        self.write("arm_moveit_config/config/6dof/joint_limits.yaml", limits.format("1.5"))
        for text in self.all_ways(0):
            self.assertIn("no findings", text)

    def test_values_with_which_a_xacro_compares(self):
        self.write("arm_moveit_config/config/hand/arm.srdf", SRDF.format("elbow", "elbow").replace(
            "</robot>", '  <disable_collisions link1="base" link2="finger" reason="Adjacent"/>\n</robot>'))
        for text in self.all_ways(0, "hand/arm.srdf"):
            self.assertIn("no findings", text)

    def test_arguments_that_cannot_be_guessed(self):
        self.write("arm_description/urdf/9dof.xacro", MACRO.format("shin", "shin"))
        self.write("arm_moveit_config/config/6dof/arm.srdf", SRDF.format("shin", "shin"))
        for text in self.all_ways(0):
            self.assertEqual(text.count("SML3501]"), 1, text)
            self.assertRegex(text, "info.SML3501.: the SRDF does not fit `.*urdf/arm.urdf.xacro`, as it is expanded here: it has no `shin`")
            self.assertIn("set the arguments", text)

    def test_arguments_of_the_configuration(self):
        self.write("arm_description/urdf/9dof.xacro", MACRO.format("shin", "shin"))
        self.write("arm_moveit_config/config/6dof/arm.srdf", SRDF.format("shin", "shin"))
        self.write(".smurf-lint.yaml", "xacro:\n- file: arm_description/urdf/arm.urdf.xacro\n  arguments: {dof: [7, 9]}\n")
        for text in self.all_ways(0):
            self.assertIn("no findings", text)

    def test_a_rename_covers_all_variants(self):
        self.run_tool("--rename", "link:base=root", "--force", ".")
        for dof in (6, 7):
            self.assertIn('base_link="root"', self.read(f"arm_moveit_config/config/{dof}dof/arm.srdf"))

    def test_the_fitting_robot_of_several(self):
        (self.folder / "arm_description/urdf/arm.urdf.xacro").unlink()
        for name, links in (("a", "lower elbow wrist"), ("b", "lower bicep wrist")):
            robot, parent = '<robot name="arm">\n  <link name="base"/>\n', "base"
            for link in links.split():
                robot += (f'  <link name="{link}">{MASS}</link>\n  <joint name="{link}_joint" type="revolute">\n    <parent link="{parent}"/>'
                          f'<child link="{link}"/><axis xyz="0 0 1"/>\n    <limit lower="-1" upper="1" effort="10" velocity="2"/>\n  </joint>\n')
                parent = link
            self.write(f"arm_description/urdf/{name}.urdf", robot + "</robot>\n")
        for path in (".", "arm_moveit_config/config/6dof/arm.srdf", "arm_moveit_config/config/7dof/arm.srdf"):
            self.assertIn("no findings", self.expect(0, "--min-severity", "info", path).stdout)

    def test_capitals_of_the_name(self):
        names = ("base", "lower", "elbow", "wrist")
        joints = "".join(f'<joint name="{b}_joint" type="revolute"><parent link="{a}"/><child link="{b}"/><axis xyz="0 0 1"/>'
                         '<limit lower="-1" upper="1" effort="10" velocity="2"/></joint>' for a, b in zip(names, names[1:]))
        links = '<link name="base"/>' + "".join(f'<link name="{name}">{MASS}</link>' for name in names[1:])
        self.write("hand/package.xml", cli.package("hand"))
        self.write("hand/hand.urdf", f'<robot name="Hand">{links}{joints}</robot>')
        self.write("hand/other.urdf", '<robot name="other"><link name="base"/></robot>')
        self.write("hand/hand.srdf", SRDF.format("elbow", "elbow").replace('"arm"', '"hand"'))
        for path in ("hand", "hand/hand.srdf", "hand/hand.urdf"):
            self.assertIn("SML3502", self.expect(None, path).stdout, path)


if __name__ == "__main__":
    cli.main()
