# SPDX-License-Identifier: BSD-3-Clause
"""MJCF: a converted robot runs. Motors hold the start and arrive, links that the SRDF names do not touch, loops stay closed."""
import json
import subprocess
import unittest
import xml.etree.ElementTree as tree

import reader

cli = reader.cli

ROOT = cli.ROOT
PYTHON = ROOT / "build/readers/python/bin/python"
DRIVE = ROOT / "tests/readers/mujoco_drive.py"
CORPUS = ROOT.parent / "shared/corpus/urdf/Gepetto__example-robot-data"
ARMS = ("ur5_robot", "panda", "z1", "kinova", "romeo", "baxter")
LEAST = 0.95  # of the motors arrive


def body(name, moment, mass=0.3, at="0 0 0", shape=""):
    return (f'<link name="{name}"><inertial><origin xyz="{at}"/><mass value="{mass}"/><inertia ixx="{moment}" iyy="{moment}" '
            f'izz="{moment}" ixy="0" ixz="0" iyz="0"/></inertial>{shape}</link>')


def joint(name, parent, child, effort=300, velocity=10, origin="0 0 0", axis="0 0 1", kind="revolute"):
    return (f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/><origin xyz="{origin}"/>'
            f'<axis xyz="{axis}"/><limit lower="-2" upper="2" effort="{effort}" velocity="{velocity}"/></joint>')


def control(*joints, command="position"):
    commands = "".join(f'<joint name="{one}"><command_interface name="{command}"/></joint>' for one in joints)
    return f'<ros2_control name="rc" type="system">{commands}</ros2_control>'


def box(x, y, z, at="0 0 0"):
    return f'<collision><origin xyz="{at}"/><geometry><box size="{x} {y} {z}"/></geometry></collision>'


class Motors(reader.ReaderTest):
    def drive(self, *worlds, hold=0):
        if not PYTHON.exists():
            self.skipTest("MuJoCo for Python is not installed")
        done = subprocess.run([str(PYTHON), str(DRIVE), f"hold={hold}", *map(str, worlds)], capture_output=True,
                              encoding="utf-8", timeout=1200, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return [json.loads(line) for line in done.stdout.splitlines()]

    def world(self, robot, *arguments, name="robot"):
        file = self.folder / f"{name}.urdf"
        file.write_text(f'<robot name="{name}">{robot}</robot>')
        output = self.folder / f"{name}.mjcf.xml"
        done = self.run_tool(file, "--format", "mjcf", "-o", output, "--base", "fixed", "--force", *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return output, done.stderr

    def assert_arrives(self, world, motors):
        for run in self.drive(world, hold=1):
            self.assertTrue(run["is_finite"], run)
            self.assertEqual((run["motors"], run["missed"]), (motors, {}), run)

    def test_light_link_with_a_strong_motor(self):
        robot = body("base", 0.03, 5) + joint("j", "base", "flange") + body("flange", 0.001) + control("j")
        world, _ = self.world(robot)
        self.assert_arrives(world, 1)
        # The rest of the damping is at the joint, and lets it reach its largest speed.
        self.assertIn('damping="30"', world.read_text())

    def test_placeholder_of_a_mass_with_a_strong_motor(self):
        """MuJoCo takes the acceleration for a failure. Frames at the link have no mass in the MJCF, so they do not help."""
        frames = "".join(f'<link name="{name}"/><joint name="to_{name}" type="fixed"><parent link="flange"/><child link="{name}"/></joint>'
                         for name in ("tool0", "sensor"))
        robot = body("base", 0.03, 5) + joint("j", "base", "flange", 105) + body("flange", 1e-9, 1e-6) + frames + control("j")
        world, _ = self.world(robot)
        self.assertIn('armature="1.04e-07"', world.read_text())
        self.assert_arrives(world, 1)

    def test_strong_motor_of_a_heavy_link_is_as_before(self):
        robot = body("base", 0.03, 5) + joint("j", "base", "arm", 50, 5) + body("arm", 2, 10) + control("j")
        world, _ = self.world(robot)
        self.assertIn('gainprm="2000" biasprm="0 -2000 -100"', world.read_text())
        self.assertIn('damping="0"', world.read_text())

    def test_heavy_trunk_on_a_weak_motor(self):
        """The stiffness against its weight would throw it from side to side at full effort."""
        robot = (body("base", 0.03, 5) + joint("waist", "base", "trunk", 35, 30, axis="1 0 0").replace('"-2" upper="2"', '"-0.52" upper="0.52"') +
                 body("trunk", 0.8, 20, "0 0 0.15") + control("waist"))
        self.assert_arrives(self.world(robot)[0], 1)

    def test_no_limits_and_a_tiny_finger(self):
        robot = (body("base", 0.03, 5) + joint("a", "base", "palm", 0, 0, axis="0 1 0") + body("palm", 1e-5, 0.05, "0.02 0 0") +
                 joint("b", "palm", "tip", 0, 0, origin="0.04 0 0", axis="0 1 0") + body("tip", 4e-7, 0.002, "0.01 0 0") +
                 control("a", "b"))
        self.assert_arrives(self.world(robot)[0], 2)

    def test_speeds_of_a_light_wheel(self):
        robot = (body("base", 0.03, 5) + joint("j", "base", "wheel", 30, 20, kind="continuous") + body("wheel", 1e-4) +
                 control("j", command="velocity"))
        world, _ = self.world(robot)
        self.assertIn("armature=", world.read_text())

    def test_light_finger_with_followers(self):
        """The equality of a follower was unstable with the damping of its leader: NaN."""
        robot = (body("base", 0.03, 5) + joint("a", "base", "left", 50, 0.6, "0.05 0 0") + body("left", 2e-5, 0.02, "0.02 0 0") +
                 "".join(joint(one, "base", one, 50, 0.6, f"0 {0.05 * (i + 1)} 0").replace("</joint>", '<mimic joint="a"/></joint>') +
                         body(one, 2e-5, 0.02, "0.02 0 0") for i, one in enumerate(("b", "c", "d"))) + control("a"))
        self.assert_arrives(self.world(robot)[0], 1)

    def test_light_joints_without_limits(self):
        """The rest of their damping was negative."""
        robot = (body("base", 0.03, 5) + joint("a", "base", "one", 1000, 0) + body("one", 4e-7, 0.01) +
                 joint("b", "one", "two", 1000, 0, "0 0 0.1") + body("two", 4e-7, 0.01))
        world, _ = self.world(robot, "--actuator", "auto")
        self.assertNotIn('damping="-', world.read_text())
        self.assert_arrives(world, 2)

    def test_gains_of_controllers(self):
        """Too weak, too slow, undamped and too stiff ones: all arrive."""
        robot = (body("base", 0.03, 5) + joint("a", "base", "one", axis="0 1 0") + body("one", 0.05, 4, "0.2 0 0") +
                 joint("b", "one", "two", 100, origin="0.4 0 0", axis="0 1 0") + body("two", 0.02, 2, "0.1 0 0") +
                 joint("c", "two", "tip", 50, origin="0.2 0 0", axis="1 0 0") + body("tip", 0.008, 0.5) + control("a", "b", "c"))
        for number, gains in enumerate((("{p: 1.0, d: 0.0}",) * 3, ("{p: 1.0e+5, i: 1.0, d: 0.01}",) * 3,
                                        ("{p: 50.0, d: 500.0}", "{p: 3000.0, d: 30.0}", "{p: 10.0, d: 1.0}"))):
            lines = "".join(f"      {name}: {one}\n" for name, one in zip("abc", gains))
            file = self.folder / f"controllers{number}.yaml"
            file.write_text("controller_manager:\n  ros__parameters:\n    arm:\n"
                            "      type: joint_trajectory_controller/JointTrajectoryController\n"
                            "arm:\n  ros__parameters:\n    joints: [a, b, c]\n    command_interfaces: [effort]\n"
                            "    state_interfaces: [position]\n    gains:\n" + lines)
            world, said = self.world(robot, "--controllers", file)
            self.assertIn("gains of controllers", said)
            self.assert_arrives(world, 3)

    def test_zero_and_placeholder_inertias(self):
        shape = box(0.2, 0.2, 0.2)
        robot = (body("base", 0.03, 5) + joint("j", "base", "head", 20, 100) + body("head", 0, 1.3, shape=shape) +
                 joint("k", "head", "hat", 20, 100, "0 0 0.3") + body("hat", 1, 0.6, shape=box(0.1, 0.1, 0.1)) + control("j", "k"))
        world, said = self.world(robot)
        self.assertNotIn("e-14", world.read_text())
        self.assertIn("moments of inertia of 0 and placeholders (`head`, `hat`)", said)
        self.assertRegex(world.read_text(), 'mass="1.3" fullinertia="0.0086666')
        self.assertRegex(world.read_text(), 'mass="0.6" fullinertia="0.001')
        self.assert_arrives(world, 2)

    def test_options(self):
        robot = (body("base", 0.03, 5) + joint("arm_1", "base", "a", 50, 5) + body("a", 2, 10) +
                 joint("arm_2", "a", "b", 50, 5) + body("b", 2, 10))
        world, _ = self.world(robot, "--actuator", "position", "--kp", "100", "--kp", "*_2=200", "--kv", "7", "--armature", "arm_1=0.5")
        text = world.read_text()
        self.assertIn('gainprm="100" biasprm="0 -100 -7"', text)
        self.assertIn('gainprm="200" biasprm="0 -200 -7"', text)
        self.assertEqual(text.count('armature="0.5"'), 1)
        self.assertIn("<motor ", self.world(robot, "--actuator", "effort")[0].read_text())
        done = self.run_tool(self.folder / "robot.urdf", "--format", "sdf1.6", "--kp", "1")
        self.assertEqual(done.returncode, 2)
        self.assertIn("need one of the formats sdf, mjcf, usda", done.stderr)

    def test_pairs_of_the_srdf_and_overlaps(self):
        shape = box(0.1, 0.1, 0.1)
        robot = (body("base", 0.03, 5, shape=shape) + joint("a", "base", "one", origin="0.08 0 0") + body("one", 1, shape=shape) +
                 joint("b", "one", "two", origin="-0.02 0 0") + body("two", 1, shape=shape) + control("a", "b"))
        text, said = self.world(robot)
        self.assertIn("1 pair of links", said)
        self.assertIn("--exclude-overlaps", said)
        self.assertNotIn("robot/two", self.excluded(text))
        text, _ = self.world(robot, "--exclude-overlaps")
        self.assertIn({"robot/base", "robot/two"}, self.excluded(text))
        (self.folder / "robot.srdf").write_text(
            '<robot name="robot"><disable_collisions link1="two" link2="base" reason="Default"/></robot>')
        text, said = self.world(robot)
        self.assertIn({"robot/base", "robot/two"}, self.excluded(text))
        self.assertNotIn("overlap", said)
        self.assertNotIn({"robot/base", "robot/two"}, self.excluded(self.world(robot, "--self-collision", "neighbours")[0]))
        self.assertIn({"robot/one", "robot/two"}, self.excluded(self.world(robot, "--self-collision", "none")[0]))
        self.assertIn('filterparent="disable"', self.world(robot, "--self-collision", "all")[0].read_text())

    @staticmethod
    def excluded(world):
        return [{one.get("body1"), one.get("body2")} for one in tree.parse(world).iter("exclude")]

    def test_loop_in_gazebo(self):
        robot = (body("base", 0.03, 5) + joint("a", "base", "left", axis="0 1 0") + body("left", 0.08, 1, "0 0 0.5") +
                 joint("b", "left", "top", origin="0 0 1", axis="0 1 0") + body("top", 0.08, 1, "0.5 0 0") +
                 joint("c", "base", "right", origin="1 0 0", axis="0 1 0") + body("right", 0.08, 1, "0 0 0.5") +
                 '<gazebo><joint name="d" type="revolute"><parent>top</parent><child>right</child><pose>0 0 1 0 0 0</pose>'
                 '<axis><xyz>0 1 0</xyz></axis></joint></gazebo>')
        world, said = self.world(robot)
        text = world.read_text()
        self.assertIn('<connect name="robot/d" body1="robot/top" body2="robot/right" anchor="1 0 0"/>', text)
        self.assertNotIn("`d`", said)
        if not PYTHON.exists():
            self.skipTest("MuJoCo for Python is not installed")
        done = subprocess.run([str(PYTHON), "-c", SWING, str(world)], capture_output=True, encoding="utf-8", timeout=300, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        gap, swing, off = map(float, done.stdout.split())
        self.assertLess(gap, 2e-3)  # m
        self.assertGreater(swing, 0.3)  # rad
        self.assertLess(off, 1e-9)  # rad, from MuJoCo's own model

    def test_loop_of_a_second_parent(self):
        robot = (body("base", 0.03, 5) + joint("a", "base", "left") + body("left", 0.08, 1) +
                 joint("b", "base", "right", origin="0.2 0 0") + body("right", 0.08, 1) +
                 joint("t", "left", "tool", origin="0.1 0 0") + body("tool", 0.08, 1) +
                 joint("u", "right", "tool", origin="-0.097 0 0"))
        world, said = self.world(robot)
        self.assertIn('site1="robot/u/parent" site2="robot/u/child"', world.read_text())
        self.assertIn("is open at the start by 3 mm", said)
        for column in ("usda", "gltf"):
            done = self.run_tool(self.folder / "robot.urdf", "--format", column, "--force", "--fail-on-loss", "-o",
                                 self.folder / f"lost.{column}")
            self.assertNotEqual(done.returncode, 0, column)

    @unittest.skipUnless(CORPUS.is_dir(), "the corpus is not there")
    def test_arms_of_the_corpus(self):
        worlds = []
        for name in ARMS:
            for file in CORPUS.rglob(f"{name}.urdf"):
                output = self.folder / f"{name}.xml"
                done = self.run_tool(file, "--format", "mjcf", "-o", output, "--base", "fixed", "--force", "--quiet",
                                     "--allow-outside", "--actuator", "auto", "--package", f"example-robot-data={CORPUS}")
                self.assertEqual(done.returncode, 0, done.stderr)
                worlds.append(output)
                break
        self.assertGreater(len(worlds), 3)
        runs = self.drive(*worlds, hold=10)
        motors = sum(run["motors"] for run in runs)
        missed = {(run["file"].rsplit("/", 1)[-1], run["factor"]): run["missed"] for run in runs if run["missed"]}
        self.assertTrue(all(run["is_finite"] for run in runs), runs)
        count = sum(len(one) for one in missed.values())
        print(f"{motors - count} of {motors} motors arrive; missed: {missed}")
        self.assertGreaterEqual(1 - count / motors, LEAST, missed)


# Lets the four-bar fall for a second, and the same robot written by hand with a connect.
SWING = """
import re, sys
import mujoco, numpy
text = open(sys.argv[1]).read()
own = '''<mujoco><compiler angle="radian"/><option timestep="0.001" gravity="0 0 -9.81" integrator="implicit"/><worldbody><body>
<inertial pos="0 0 0" mass="5" diaginertia="0.03 0.03 0.03"/>
<body name="l"><inertial pos="0 0 0.5" mass="1" diaginertia="0.08 0.08 0.08"/><joint axis="0 1 0" range="-2 2" limited="true"/>
<body name="t" pos="0 0 1"><inertial pos="0.5 0 0" mass="1" diaginertia="0.08 0.08 0.08"/><joint axis="0 1 0" range="-2 2" limited="true"/></body></body>
<body name="r" pos="1 0 0"><inertial pos="0 0 0.5" mass="1" diaginertia="0.08 0.08 0.08"/><joint axis="0 1 0" range="-2 2" limited="true"/></body>
</body></worldbody><equality><connect body1="t" body2="r" anchor="1 0 0"/></equality></mujoco>'''
worlds = [mujoco.MjModel.from_xml_path(sys.argv[1]), mujoco.MjModel.from_xml_string(own)]
states = [mujoco.MjData(model) for model in worlds]
mujoco.mj_resetDataKeyframe(worlds[0], states[0], 0)
gap = 0
for data in states:
    data.qvel[:] = [0.5, -0.5, 0.5]
for step in range(600):
    for model, data in zip(worlds, states):
        mujoco.mj_step(model, data)
    top, right = (states[0].body(name) for name in ("robot/top", "robot/right"))
    ends = [body.xpos + body.xmat.reshape(3, 3) @ at for body, at in ((top, [1, 0, 0]), (right, [0, 0, 1]))]
    gap = max(gap, numpy.linalg.norm(ends[0] - ends[1]))
print(gap, abs(states[0].qpos[0]), numpy.abs(states[0].qpos - states[1].qpos).max())
"""

if __name__ == "__main__":
    reader.main()
