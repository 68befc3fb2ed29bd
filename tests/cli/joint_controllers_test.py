# SPDX-License-Identifier: BSD-3-Clause
"""Motors of exported robots follow the controllers of ros2_control that belong to the robot, or that the user names."""
import re
import unittest
import xml.etree.ElementTree as tree

import cli


def link(name, moment=0.1, mass=1, at="0 0 0"):
    return (f'<link name="{name}"><inertial><origin xyz="{at}"/><mass value="{mass}"/><inertia ixx="{moment}" iyy="{moment}" '
            f'izz="{moment}" ixy="0" ixz="0" iyz="0"/></inertial></link>')


def joint(name, child, effort=100, velocity=5, axis="0 0 1", extra=""):
    return (f'<joint name="{name}" type="revolute"><parent link="base"/><child link="{child}"/><axis xyz="{axis}"/>'
            f'<limit lower="-2" upper="2" effort="{effort}" velocity="{velocity}"/>{extra}</joint>')


def control(**interfaces):
    joints = "".join(f'<joint name="{one}">' + "".join(f'<command_interface name="{each}"/>' for each in all_) + "</joint>"
                     for one, all_ in interfaces.items())
    return f'<ros2_control name="rc" type="system"><hardware><plugin>mock/Mock</plugin></hardware>{joints}</ros2_control>'


ALL = ("position", "velocity", "effort")
ARM = link("base") + joint("j1", "a") + link("a") + joint("j2", "b") + link("b")


def controllers(**sections):
    """A parameter file; each section is (class, the lines of its parameters)."""
    text = "controller_manager:\n  ros__parameters:\n    update_rate: 100\n"
    for name, (type_, _) in sections.items():
        text += f"    {name}:\n      type: {type_}\n"
    for name, (_, lines) in sections.items():
        text += f"{name}:\n  ros__parameters:\n" + "".join(f"    {line}\n" for line in lines)
    return text


def trajectory(interface, *gains, joints="[j1, j2]"):
    lines = [f"joints: {joints}", f"command_interfaces: [{interface}]", "state_interfaces: [position, velocity]"]
    return "joint_trajectory_controller/JointTrajectoryController", lines + (["gains:"] if gains else []) + [f"  {one}" for one in gains]


def forward(interface, joints="[j1, j2]"):
    return "forward_command_controller/ForwardCommandController", [f"joints: {joints}", f"interface_name: {interface}"]


GAINS = ("j1: {p: 40.0, i: 1.0, d: 4.0}", "j2: {p: 30.0, i: 0.0, d: 3.0}")


class JointControllers(cli.CliTest):
    def write(self, robot, config=None):
        """A package with a robot and its controllers."""
        self.write_file("package.xml", cli.package("arm_description"))
        self.write_file("urdf/arm.urdf", f'<robot name="arm">{robot}</robot>')
        if config is not None:
            self.write_file("config/controllers.yaml", config)

    def write_file(self, path, text):
        file = self.folder / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        return file

    def convert(self, *arguments, file="urdf/arm.urdf", form="mjcf"):
        output = self.folder / f"out.{form}"
        done = self.run_tool(file, "--format", form, "-o", output, "--base", "fixed", *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return output.read_text(), done.stderr

    @staticmethod
    def motor(text, name):
        root = tree.fromstring(text)
        found = [one for one in root.find("actuator") if one.get("joint") == f"arm/{name}"]
        return found[0] if found else None

    def kind(self, text, name):
        one = self.motor(text, name)
        if one is None or one.tag == "motor":
            return one if one is None else "effort"
        return "position" if float(one.get("biasprm").split()[1]) else "velocity"

    def test_gains_of_an_effort_controller(self):
        self.write(ARM + control(j1=ALL, j2=["effort"]), controllers(arm=trajectory("effort", *GAINS)))
        text, said = self.convert()
        self.assertEqual(self.motor(text, "j1").get("biasprm"), "0 -40 -4")
        self.assertEqual(self.motor(text, "j2").get("biasprm"), "0 -30 -3")
        self.assertIn("<!-- as `arm` commands, from config/controllers.yaml -->", text)
        self.assertIn("follow `config/controllers.yaml`: `arm` commands positions, with its gains, of 2 joints", said)
        self.assertNotIn("gains of controllers", said)
        self.assertNotIn("gains of motors", said)
        text, said = self.convert("--controllers", "none")
        self.assertEqual((self.kind(text, "j1"), self.kind(text, "j2")), ("position", "effort"))
        self.assertNotIn("controllers.yaml", said + text)

    def test_effort_without_gains_is_a_motor(self):
        self.write(ARM + control(j1=ALL, j2=ALL), controllers(arm=forward("effort")))
        for options in ((), ("--actuator", "auto")):
            text, said = self.convert(*options)
            self.assertEqual((self.kind(text, "j1"), self.kind(text, "j2")), ("effort", "effort"), said)

    def test_wheels_of_a_base(self):
        self.write(ARM + control(j1=["velocity", "effort"], j2=["velocity", "effort"]), controllers(base=(
            "diff_drive_controller/DiffDriveController",
            ["left_wheel_names: [j1]", "right_wheel_names: [j2]", "wheel_separation: 0.4", "wheel_radius: 0.1"])))
        text, said = self.convert("--actuator", "auto")
        self.assertEqual((self.kind(text, "j1"), self.kind(text, "j2")), ("velocity", "velocity"))
        self.assertIn("`base` commands speeds of 2 joints", said)

    def test_pid_controller_of_speeds(self):
        self.write(ARM + control(j1=["effort"], j2=["effort"]), controllers(pid=(
            "pid_controller/PidController",
            ["dof_names: [j1]", "command_interface: effort", "reference_and_state_interfaces: [velocity]", "gains:",
             "  j1: {p: 7.0, i: 0.0, d: 0.0}"])))
        text, _ = self.convert("--actuator", "auto")
        self.assertEqual(self.motor(text, "j1").get("biasprm"), "0 0 -7")
        self.assertEqual(self.kind(text, "j2"), "position")
        self.assertIn("<!-- without controller -->", text)

    def test_first_of_two_controllers(self):
        self.write(ARM + control(j1=ALL, j2=ALL), controllers(speeds=forward("velocity", "[j1]"), arm=trajectory("position")))
        text, said = self.convert()
        self.assertEqual((self.kind(text, "j1"), self.kind(text, "j2")), ("velocity", "position"))
        self.assertIn("`arm` commands positions of 1 joint; the first controller of a joint counts", said)

    def test_interface_that_the_robot_lacks(self):
        self.write(ARM + control(j1=["position"], j2=["position"]), controllers(rush=forward("velocity"), arm=trajectory("position")))
        text, said = self.convert()
        self.assertEqual(self.kind(text, "j1"), "position")
        self.assertNotIn("`rush`", text + said)

    def test_joints_without_motor(self):
        self.write(ARM, controllers(arm=trajectory("position", joints="[j1]")))
        text, _ = self.convert()
        self.assertEqual((self.kind(text, "j1"), self.kind(text, "j2")), ("position", None))

    def test_options_override_the_file(self):
        self.write(ARM + control(j1=ALL, j2=ALL), controllers(arm=trajectory("effort", *GAINS)))
        text, said = self.convert("--actuator", "velocity")
        self.assertEqual(self.kind(text, "j1"), "velocity")
        self.assertNotIn("follow", said)
        text, _ = self.convert("--kp", "j1=90")
        self.assertEqual(self.motor(text, "j1").get("biasprm"), "0 -90 -4")
        self.assertEqual(self.motor(text, "j2").get("biasprm"), "0 -30 -3")
        text, _ = self.convert("--actuator", "effort")
        self.assertEqual(self.kind(text, "j1"), "effort")

    def test_smurf_motors_that_state_gains(self):
        self.write(ARM, controllers(arm=trajectory("effort", *GAINS)))
        self.write_file("smurf/arm.smurf", "modelname: arm\nfiles:\n- ../urdf/arm.urdf\n- arm_motors.yml\n")
        self.write_file("smurf/arm_motors.yml", "motors:\n"
                        "- {name: j1, joint: j1, type: PID, maxEffort: 100.0, maxSpeed: 5.0, kp: 55.0, kv: 5.5}\n"
                        "- {name: j2, joint: j2, type: PID, p: 20.0, maxEffort: 100.0, maxSpeed: 5.0}\n")
        text, said = self.convert(file="smurf/arm.smurf")
        self.assertEqual(self.motor(text, "j1").get("biasprm"), "0 -55 -5.5")
        self.assertEqual(self.motor(text, "j2").get("biasprm"), "0 -30 -3")
        self.assertIn("with its gains, of 1 joint", said)

    def test_gains_out_of_bounds_are_named(self):
        heavy = link("base") + joint("j1", "a", axis="0 1 0") + link("a", 1, 10, "0.3 0 0") + joint("j2", "b") + link("b", 1e-3)
        gains = ("j1: {p: 40.0, d: 4.0}", "j2: {p: 1000000.0, d: 1.0}")
        self.write(heavy + control(j1=ALL, j2=ALL), controllers(arm=trajectory("effort", *gains)))
        text, said = self.convert()
        self.assertIn("gains of controllers (`j1`, `j2`): the MJCF has other ones", said)
        # Holds 10 kg at 0.3 m to 1.5 % of 0.3 rad; and a force that is stable at 2 ms.
        self.assertGreater(-float(self.motor(text, "j1").get("biasprm").split()[1]), 9.81 * 10 * 0.3 / (0.016 * 0.3))
        self.assertLessEqual(-float(self.motor(text, "j2").get("biasprm").split()[1]), 1.0001e-3 / (4 * 0.001 ** 2))

    def test_named_file(self):
        self.write(ARM + control(j1=["position"], j2=["position"]))
        file = self.write_file("elsewhere/gains.yaml", controllers(arm=trajectory("effort", *GAINS)))
        self.assertNotIn("gains.yaml", self.convert()[0])
        text, _ = self.convert("--controllers", file)
        self.assertEqual(self.motor(text, "j1").get("biasprm"), "0 -40 -4")

    def test_named_file_that_does_not_fit(self):
        self.write(ARM)
        other = self.write_file("other.yaml", controllers(arm=trajectory("effort", joints="[x1, x2]")))
        plain = self.write_file("plain.yaml", "a: 1\n")
        for file, reason in ((other, "command no joint of it"), (plain, "is no parameter file with controllers"),
                             (self.folder / "absent.yaml", "cannot read")):
            output = self.folder / "lost.xml"
            done = self.run_tool("urdf/arm.urdf", "--format", "mjcf", "-o", output, "--controllers", file)
            self.assertNotEqual(done.returncode, 0, file)
            self.assertIn(reason, done.stderr)
            self.assertFalse(output.exists())
        done = self.run_tool("urdf/arm.urdf", "--format", "sdf1.6", "--controllers", other)
        self.assertIn("need one of the formats sdf, mjcf, usda", done.stderr)

    def test_prefix_of_launch_files(self):
        joints = '["$(var prefix)j1", "$(var prefix)j2"]'
        self.write(ARM + control(j1=ALL, j2=ALL), controllers(arm=trajectory("velocity", joints=joints)))
        text, _ = self.convert("--controllers", "config/controllers.yaml")
        self.assertEqual(self.kind(text, "j1"), "velocity")

    def test_names_that_a_comment_cannot_have(self):
        self.write(ARM, controllers(**{"a---b": trajectory("velocity")}))
        text, _ = self.convert("--controllers", "config/controllers.yaml")
        self.assertIn("<!-- as `a-b` commands", text)
        self.assertEqual(self.kind(text, "j1"), "velocity")

    def test_drives_of_usd(self):
        self.write(ARM + control(j1=ALL, j2=ALL), controllers(arm=trajectory("effort", *GAINS)))
        text, said = self.convert(form="usda")
        self.assertIn('custom string smurf:controller = "as `arm` commands, from config/controllers.yaml"', text)
        stiffness = [float(one) for one in re.findall(r"physics:stiffness = (\S+)", text)]
        self.assertAlmostEqual(stiffness[0], 40 * 3.14159265 / 180, 5)
        self.assertIn("follow `config/controllers.yaml`", said)

    def test_light_joint_without_limits_has_no_negative_damping(self):
        self.write(link("base") + joint("j1", "a", 1000, 0) + link("a", 4e-7, 0.01))
        text, _ = self.convert("--actuator", "auto")
        self.assertEqual([one for one in re.findall(r'damping="([^"]+)"', text) if float(one) < 0], [])

    def test_joint_that_the_root_does_not_reach(self):
        self.write(link("base") + joint("j1", "a") + link("a") + link("other") + link("c") +
                   joint("j2", "c").replace('"base"', '"other"'))
        text, _ = self.convert("--actuator", "auto", "--force")
        self.assertEqual((self.kind(text, "j1"), self.kind(text, "j2")), ("position", None))

    def test_leader_of_a_light_finger_has_an_armature(self):
        """MuJoCo solves the equality of its followers without the damping, which made them unstable."""
        self.write(link("base") + joint("j1", "a", 50, 0.6) + link("a", 2e-5, 0.02) +
                   joint("j2", "b", 50, 0.6, extra='<mimic joint="j1"/>') + link("b", 2e-5, 0.02))
        text, _ = self.convert("--actuator", "auto")
        root = tree.fromstring(text)
        leader = next(one for one in root.iter("joint") if one.get("name") == "arm/j1")
        self.assertGreater(float(leader.get("armature")), 1)
        self.assertEqual(float(leader.get("damping")), 0)


if __name__ == "__main__":
    cli.main()
