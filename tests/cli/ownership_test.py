# SPDX-License-Identifier: BSD-3-Clause
"""Which robot a companion is compared with: for reasons, whichever way it is named; and what is not compared is said.

ownership_test.py SMURF-LINT [SHARED-FOLDER]: with that folder, companions of public repositories are tried, too.
"""
import collections
import json
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import cli  # noqa: E402

SHARED = pathlib.Path(sys.argv.pop(2)) if len(sys.argv) > 2 and not sys.argv[2].startswith("-") else None
JOINTS = ("shoulder", "elbow", "wrist", "hand")
MASS = '<inertial><mass value="0.5"/><inertia ixx="0.00013" ixy="0" ixz="0" iyy="0.00013" iyz="0" izz="0.00013"/></inertial>'


def robot(name, joints=JOINTS, root="base"):
    text, parent = f'<robot name="{name}" xmlns:xacro="http://www.ros.org/wiki/xacro">\n  <link name="{root}"/>\n', root
    for joint in joints:
        text += (f'  <link name="{joint}_link">{MASS}</link>\n  <joint name="{joint}" type="revolute">\n    <parent link="{parent}"/>'
                 f'<child link="{joint}_link"/><axis xyz="0 0 1"/>\n    <limit lower="-1" upper="1" effort="1" velocity="1"/>\n  </joint>\n')
        parent = joint + "_link"
    return text + "</robot>\n"


def controllers(*joints):
    return ("controller_manager:\n  ros__parameters:\n    jtc: {type: joint_trajectory_controller/JointTrajectoryController}\n"
            f"jtc:\n  ros__parameters:\n    joints: [{', '.join(joints)}]\n    command_interfaces: [position]\n    state_interfaces: [position]\n")


class Ownership(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.enter_workspace()
        self.write("bot_description/package.xml", cli.package("bot_description"))
        self.write("bot_description/urdf/bot.urdf.xacro", robot("bot"))
        self.config = "bot_description/config/controllers.yaml"

    def report(self, *words):
        return json.loads(self.run_tool("--format", "json", "--min-severity", "info", *words).stdout)

    def found(self, *words):
        return {(one["id"], one["message"]) for one in self.report(*words)["diagnostics"] if one["id"].startswith("SML37")}

    def test_the_answer_is_the_same_whichever_way_the_file_is_named(self):
        self.write(self.config, controllers("shoulder", "elbw", "wrist", "hand"))
        ways = [("--only-listed", self.config), (self.config,), ("bot_description/urdf/bot.urdf.xacro",), ("bot_description",), (".",)]
        for way in ways:
            self.assertEqual(len(self.found(*way)), 1, way)
            self.assertIn("`elbw`", self.found(*way).pop()[1], way)
        done = self.expect(1, self.config)
        self.assertNotIn("1 model", done.stdout)
        self.assertIn("checked with 1 controllers.yaml, compared with `bot_description/urdf/bot.urdf.xacro`", done.stdout)

    def test_one_joint_is_enough(self):
        self.write("bot_description/urdf/bot.urdf.xacro", robot("bot", ["slide"]))
        self.write(self.config, controllers("slidee"))
        self.assertIn("did you mean `slide`?", self.expect(1, ".").stdout)

    def test_the_flow_form_and_any_name(self):
        text = json.dumps({"controller_manager": {"ros__parameters": {"jtc": {"type": "joint_trajectory_controller/JointTrajectoryController"}}},
                           "jtc": {"ros__parameters": {"joints": ["shoulder", "elbw", "wrist"], "command_interfaces": ["position"]}}})
        self.write("bot_description/config/tournament.yaml", text)
        self.assertIn("`elbw`", self.expect(1, ".").stdout)

    def test_a_file_that_is_no_yaml_is_an_error(self):
        for old, new in (("    joints", "\tjoints"), ("hand]", "hand"), ("  ros__parameters:\n    joints", " ros__parameters:\n      - joints")):
            self.write(self.config, controllers(*JOINTS).replace(old, new))
            self.assertIn("SML0010", self.expect(1, ".").stdout, new)
        self.write(self.config, controllers(*JOINTS).replace("    joints", "\tjoints").replace("hand]", "{{ hand }}]"))
        self.assertRegex(self.expect(0, ".").stdout, "not compared: `.*controllers.yaml`: it is a template")

    def test_what_a_launch_file_fills_in_makes_no_yaml_of_a_tab(self):
        text = controllers(*JOINTS).replace("hand]", "hand, $(arg more)]")
        self.write(self.config, text)
        self.expect(0, ".")
        self.write(self.config, text.replace("    joints", "\tjoints"))
        self.assertIn("SML0010", self.expect(1, ".").stdout)

    def test_limits_in_degrees(self):
        text = "joint_limits:\n  hnd: {has_velocity_limits: true, max_velocity: !degrees %s}\n"
        limits = "bot_description/config/joint_limits.yaml"
        self.write(limits, text % "57.0")
        self.assertIn("did you mean `hand`?", self.expect(0, ".").stdout)
        self.write(limits, (text % "57").replace("hnd", "hand"))
        self.expect(0, ".")
        self.write(limits, (text % "58.0").replace("hnd", "hand"))
        self.assertIn("joint `hand` may move with 1.01229, faster than the 1 of the URDF", self.expect(0, ".").stdout)
        self.write(limits, (text % "58.0").replace("  hnd", "\thnd"))
        self.assertIn("SML0010", self.expect(1, ".").stdout)

    def test_a_key_that_is_written_twice(self):
        self.write(self.config, controllers(*JOINTS).replace("    joints", "    joints: [nobody]\n    joints").replace("elbow", "elbw"))
        found = self.run_tool(".").stdout
        self.assertIn("warning[SML0011]", found)
        self.assertIn("`elbw`", found)
        self.assertNotIn("nobody`", found)

    def test_parameters_of_a_node_that_is_written_twice_are_joined(self):
        text = controllers("shoulder", "elbw", "wrist")
        self.write(self.config, text.replace("    command_interfaces", "jtc:\n  ros__parameters:\n    command_interfaces"))
        found = self.expect(1, ".").stdout
        self.assertNotIn("SML0011", found)
        self.assertIn("`elbw`", found)
        self.assertNotIn("SML3702", found)

    def test_an_install_folder_is_no_second_robot(self):
        self.write("install/COLCON_IGNORE", "")
        self.write("install/bot_description/urdf/bot.urdf.xacro", robot("bot"))
        self.write(self.config, controllers("shoulder", "elbw", "wrist", "hand"))
        report = self.report(".")
        self.assertEqual(report["summary"]["models"], 1)

    def test_a_better_robot_owns_the_file(self):
        self.write("bot_description/urdf/six.urdf.xacro", robot("six", [*JOINTS, "thumb", "index"]))
        self.write(self.config, controllers(*JOINTS, "thumb", "indx"))
        self.assertEqual({one[1].split("`")[3] for one in self.found(".")}, {"indx"})

    def test_robots_that_nothing_tells_apart(self):
        self.write("bot_description/urdf/twin.urdf.xacro", robot("twin"))
        self.write(self.config, controllers("shoulder", "elbw", "wrist", "hand"))
        self.assertEqual(len(self.found(".")), 1)

    def test_what_is_not_compared_is_said(self):
        self.write("bot_description/config/other.yaml", controllers("one", "two", "three"))
        done = self.expect(0, ".")
        self.assertRegex(done.stdout, "not compared: `.*other.yaml`: none of its 3 names is known here; tie it")
        left = self.report(".")["summary"]["not_compared"]
        self.assertEqual([(one["path"], one["kind"]) for one in left], [("bot_description/config/other.yaml", "controllers.yaml")])

    def test_strict_makes_an_error_of_what_is_not_compared(self):
        self.expect(0, "--strict", ".")
        self.write("bot_description/config/other.yaml", controllers("one", "two", "three"))
        self.expect(0, ".")
        self.assertIn("error: not compared: `bot_description/config/other.yaml`", self.expect(1, "--strict", ".").stdout)
        self.expect(0, "--strict", "--exit-zero", ".")
        for words, level in (((), "warning"), (("--strict",), "error")):
            log = json.loads(self.run_tool("--format", "sarif", *words, ".").stdout)
            [note] = log["runs"][0]["invocations"][0]["toolExecutionNotifications"]
            self.assertEqual(note["level"], level)
            self.assertIn("none of its 3 names is known here", note["message"]["text"])
            self.assertEqual(note["locations"][0]["physicalLocation"]["artifactLocation"]["uri"], "bot_description/config/other.yaml")

    def test_a_controller_whose_type_is_in_its_own_section(self):
        for kind in ("joint_trajectory_controller/JointTrajectoryController", "bot_controllers/Own"):
            self.write(self.config, f"jtc:\n  ros__parameters:\n    type: {kind}\n    joints: [shoulder, elbw]\n    command_interfaces: [position]\n")
            self.assertIn("did you mean `elbow`?", self.expect(1, ".").stdout, kind)

    def test_a_plugin_of_a_urdf_that_is_not_named_as_xacro(self):
        for name in ("a", "b"):
            plugin = ('<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
                      f"<parameters>$(find bot_description)/config/{name}.yaml</parameters></plugin></gazebo></robot>")
            self.write(f"bot_description/urdf/{name}.urdf", robot(name, [f"{name}_joint", "hand"]).replace("</robot>", plugin))
            self.write(f"bot_description/config/{name}.yaml", controllers(f"{name}_jint", "hand"))
        names = {one[1].split("`")[3] for one in self.found(".")}
        self.assertEqual(names, {"a_jint", "b_jint"})

    def test_the_path_of_a_missing_parameter_file_is_relative(self):
        plugin = ('<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
                  "<parameters>$(find bot_description)/config/gone.yaml</parameters></plugin></gazebo></robot>")
        self.write("bot_description/urdf/bot.urdf.xacro", robot("bot").replace("</robot>", plugin))
        self.assertIn("the parameter file `bot_description/config/gone.yaml`", self.run_tool(".").stdout)

    def test_a_robot_that_cannot_be_expanded_is_compared_by_its_text(self):
        text = robot("bot").replace('name="elbow"', 'name="${prefix}elbow"')
        include = '<xacro:arg name="prefix" default=""/><xacro:include filename="$(find nowhere_description)/x.xacro"/><link name="base"/>'
        self.write("bot_description/urdf/bot.urdf.xacro", text.replace('<link name="base"/>', include))
        self.write(self.config, controllers(*JOINTS))
        self.assertEqual(self.found("."), set())
        self.write(self.config, controllers("shoulder", "elbw", "wrist", "hand"))
        done = self.run_tool(".")
        self.assertIn("no file of the robot writes the joint `elbw`", done.stdout)
        self.assertIn("did you mean `elbow`?", done.stdout)
        self.assertIn("not compared: `bot_description/config/controllers.yaml`", done.stdout)
        # A name that nobody writes, or that another robot writes, may be one of another variant.
        self.write(self.config, controllers("shoulder", "elbw", "wrist", "gripper"))
        self.assertEqual(self.found("."), set())
        self.write(self.config, controllers("shoulder", "elbw", "wrist", "hand"))
        self.write("bot_description/urdf/other.urdf.xacro", robot("other", ["elbw"]))
        self.assertFalse(any("writes" in one[1] for one in self.found(".")))

    def test_init_adds_no_finding(self):
        text = robot("bot", root="$(arg prefix)base").replace('name="', 'name="$(arg prefix)').replace('name="$(arg prefix)bot"', 'name="bot"')
        text = text.replace('link="', 'link="$(arg prefix)').replace("$(arg prefix)$(arg prefix)", "$(arg prefix)")
        text = text.replace("<link", '<xacro:arg name="prefix" default=""/><link', 1)
        self.write("bot_description/urdf/bot.urdf.xacro", text)
        self.write("bot_description/launch/d.launch.py", "DeclareLaunchArgument('prefix', default_value='\"\"')\n"
                   "Command(['xacro ', 'bot.urdf.xacro', ' prefix:=', LaunchConfiguration('prefix')])\n")
        self.write(self.config, controllers(*JOINTS))
        before = self.found(".")
        self.assertEqual(before, set())
        self.run_tool("--init")
        self.assertEqual(self.found("."), before)

    def test_an_argument_that_the_robot_does_not_have(self):
        text = robot("bot", root="$(arg model)_base").replace("<link", '<xacro:arg name="model" default="mk1"/><link', 1)
        self.write("bot_description/urdf/bot.urdf.xacro", text)
        path = "bot_description/urdf/bot.urdf.xacro"
        self.expect(0, path, "model:=mk2")
        for words in ((path, "modle:=mk2"), (".", "modle:=mk2")):
            done = self.expect(1, *words)
            self.assertIn("has no argument `modle`", done.stdout)
            self.assertIn("did you mean `model`?", done.stdout)
        self.assertIn("write one of its arguments: `model`", self.expect(1, path, "speed:=2").stdout)
        self.write(".smurf-lint.yaml", f'xacro:\n- file: {path}\n  arguments: {{modl: "mk2"}}\n')
        self.assertRegex(self.expect(1, ".").stdout, r"has no argument `modl`\n *--> .smurf-lint.yaml:3:15")
        self.write(".smurf-lint.yaml", f'xacro:\n- file: {path}\n  arguments: {{model: "mk2"}}\n')
        self.expect(0, ".")
        # Another robot may have it.
        self.write("bot_description/urdf/other.urdf.xacro", robot("other", root="$(arg speed)_base"))
        self.expect(0, ".", "speed:=2")

    def test_a_file_that_the_plugin_of_another_robot_names(self):
        for name in ("a", "b"):
            plugin = ('<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
                      f"<parameters>$(find bot_description)/config/{name}.yaml</parameters></plugin></gazebo></robot>")
            self.write(f"bot_description/urdf/{name}.urdf.xacro", robot(name, ["slide", f"{name}_joint"]).replace("</robot>", plugin))
            self.write(f"bot_description/config/{name}.yaml", controllers("slide", f"{name}_joint"))
        before = self.read("bot_description/config/b.yaml")
        self.expect(0, "--rename", "joint:slide=rail", "bot_description/urdf/a.urdf.xacro")
        self.assertIn("joints: [rail, a_joint]", self.read("bot_description/config/a.yaml"))
        self.assertEqual(self.read("bot_description/config/b.yaml"), before)
        self.assertEqual(self.found("."), set())

    def test_names_that_lack_a_prefix(self):
        text = robot("bot", [f"left_{one}_joint" for one in JOINTS])
        self.write("bot_description/urdf/bot.urdf.xacro", text)
        self.write(self.config, controllers(*(f"{one}_joint" for one in JOINTS)))
        done = self.run_tool(".").stdout
        self.assertEqual(done.count("[SML3701]"), 1)
        self.assertIn("such as `shoulder_joint`, lack the prefix `left_` of the joints of the robot", done)
        self.write(self.config, controllers(*(f"left_{one}_joint" for one in JOINTS)))
        self.assertEqual(self.found("."), set())

    def test_hardware_of_gazebo_whose_plugin_nobody_writes(self):
        hardware = ('<ros2_control name="bot" type="system"><hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>'
                    '<joint name="hand"><command_interface name="position"/><state_interface name="position"/></joint></ros2_control></robot>')
        self.write("bot_description/urdf/bot.urdf.xacro", robot("bot").replace("</robot>", hardware))
        self.assertIn("warning[SML3613]", self.run_tool(".").stdout)
        self.write("bot_description/urdf/sim.xacro", '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:macro name="sim"><gazebo>'
                   '<plugin filename="gz_ros2_control-system" name="x"/></gazebo></xacro:macro></robot>')
        self.assertIn("info[SML3613]", self.run_tool(".").stdout)

    def test_values_of_launch_files(self):
        self.write("bot_description/urdf/bot.urdf.xacro", robot("bot", root="$(arg model)_base"))
        self.write("bot_description/launch/d.launch.py",
                   'DeclareLaunchArgument("model", default_value="mk3")\nCommand(["xacro ", "bot.urdf.xacro", " model:=", LaunchConfiguration("model")])\n')
        self.write(self.config, controllers("shoulder", "elbw", "wrist", "hand"))
        done = self.expect(1, ".")
        self.assertIn("checked `bot_description/urdf/bot.urdf.xacro` with `model:=mk3`, from `bot_description/launch/d.launch.py`", done.stdout)
        self.assertIn("`elbw`", done.stdout)
        self.assertNotIn("not checked", done.stdout)
        self.expect(0, "--init")
        self.assertIn('model: "mk3"', self.read(".smurf-lint.yaml"))
        done = self.run_tool(".")
        self.assertNotIn("SML33", done.stdout)
        self.assertNotIn("not checked", done.stdout)

    def test_a_launch_file_ties_a_file_to_a_robot(self):
        """The package with both does not name that of the robot."""
        self.write("bringup/package.xml", cli.package("bringup"))
        self.write("bringup/config/c.yaml", controllers("elbw"))
        self.assertIn("not compared: `bringup/config/c.yaml`", self.expect(0, ".").stdout)
        python = ("def generate_launch_description():\n    urdf = Command(['xacro ', PathJoinSubstitution([FindPackageShare('bot_description'), 'urdf',"
                  " 'bot.urdf.xacro'])])\n    return LaunchDescription([\n        Node(package='robot_state_publisher', parameters=[{'robot_description':"
                  " ParameterValue(urdf, value_type=str)}]),\n        Node(package='controller_manager', parameters=[PathJoinSubstitution("
                  "[FindPackageShare('bringup'), 'config', 'c.yaml'])])])\n")
        xml = ('<launch>\n  <param name="robot_description" command="xacro $(find bot_description)/urdf/bot.urdf.xacro"/>\n'
               '  <rosparam file="$(find bringup)/config/c.yaml"/>\n</launch>\n')
        outer = '<launch>\n  <include file="$(find bringup)/launch/inner.launch"/>\n  <rosparam file="$(find bringup)/config/c.yaml"/>\n</launch>\n'
        inner = xml.replace('  <rosparam file="$(find bringup)/config/c.yaml"/>\n', "")
        yaml = ("launch:\n- node:\n    pkg: robot_state_publisher\n    param:\n    - {name: robot_description, value: "
                "\"$(command 'xacro $(find-pkg-share bot_description)/urdf/bot.urdf.xacro')\"}\n"
                "- node:\n    pkg: controller_manager\n    param:\n    - {from: $(find-pkg-share bringup)/config/c.yaml}\n")
        for files in ({"d.launch.py": python}, {"d.launch": xml}, {"d.launch.yaml": yaml}, {"d.launch": outer, "inner.launch": inner}):
            shutil.rmtree(self.folder / "bringup/launch", ignore_errors=True)
            for name, text in files.items():
                self.write(f"bringup/launch/{name}", text)
            done = self.expect(1, ".").stdout
            self.assertIn("`elbw`", done, files)
            self.assertIn(f"`bringup/launch/{next(iter(files))}` gives this file to the robot", done)
            self.assertNotIn("not compared", done)
        # Of two robots in one launch file, the one that has the names.
        self.write("bot_description/urdf/other.urdf.xacro", robot("other", ["finger", "thumb"]))
        self.write("bringup/launch/d.launch", xml.replace("</launch>", '  <group ns="b"><param name="robot_description" command="xacro '
                   '$(find bot_description)/urdf/other.urdf.xacro"/></group>\n</launch>'))
        self.write("bringup/config/c.yaml", controllers("finger", "thumb"))
        self.assertEqual(self.found("."), set())

    def test_the_setup_assistant_ties_files_and_gives_arguments(self):
        self.write("bot_description/urdf/bot.urdf.xacro", robot("bot", root="$(arg model)_base"))
        self.write("moveit/package.xml", cli.package("moveit"))
        self.write("moveit/config/joint_limits.yaml", "joint_limits:\n  elbw: {has_velocity_limits: true, max_velocity: 1.0}\n")
        setup = ("moveit_setup_assistant_config:\n  URDF: {package: bot_description, relative_path: urdf/bot.urdf.xacro, "
                 'xacro_args: "model:=mk4"}\n')
        self.write("moveit/.setup_assistant", setup)
        done = self.expect(0, ".").stdout
        self.assertIn("checked `bot_description/urdf/bot.urdf.xacro` with `model:=mk4`, from `moveit/.setup_assistant`", done)
        self.assertIn("`elbw`", done)
        self.assertIn("`moveit/.setup_assistant` gives this file to the robot", done)

    def test_values_that_only_go_together(self):
        """Those of one launch file, in another package."""
        text = robot("bot", root="$(arg name)_base").replace("<link", '<xacro:arg name="arm" default="none"/><xacro:include '
                     'filename="$(arg arm).xacro"/><link', 1)
        self.write("bot_description/urdf/bot.urdf.xacro", text)
        self.write("bot_description/urdf/mk5.xacro", '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"/>\n')
        self.write("bringup/package.xml", cli.package("bringup"))
        self.write("bringup/launch/d.launch", '<launch><param name="robot_description" command="xacro $(find bot_description)/urdf/'
                   'bot.urdf.xacro name:=b arm:=mk5"/></launch>\n')
        self.write(self.config, controllers("shoulder", "elbw", "wrist", "hand"))
        done = self.expect(1, ".").stdout
        self.assertIn("with `name:=b arm:=mk5`, from `bringup/launch/d.launch`", done)
        self.assertIn("`elbw`", done)

    def test_a_default_below_the_first_use(self):
        """xacro evaluates the name of the robot first; every launch file gives it."""
        text = robot("$(arg name)").replace("<link", '<xacro:arg name="name" default="bot"/><link', 1)
        self.write("bot_description/urdf/bot.urdf.xacro", text)
        self.write(self.config, controllers("shoulder", "elbw", "wrist", "hand"))
        done = self.expect(1, ".").stdout
        self.assertIn("with `name:=bot`, from `bot_description/urdf/bot.urdf.xacro`", done)
        self.assertIn("`elbw`", done)
        self.assertIn("SML3313", self.expect(1, "bot_description/urdf/bot.urdf.xacro").stdout)

    def test_controllers_in_a_package_that_is_not_related(self):
        """All of their names are those of a robot below the folder; other files may be for another robot of the family."""
        self.write("sim/package.xml", cli.package("sim"))
        self.write("sim/config/c.yaml", controllers("shoulder", "elbw", "wrist", "hand"))
        self.assertIn("`elbw`", self.expect(1, ".").stdout)
        self.write("sim/config/c.yaml", controllers("shoulder", "elbow", "wrist", "finger"))
        self.write("sim/config/joint_limits.yaml", "joint_limits:\n  elbow: {has_velocity_limits: true, max_velocity: 9.0}\n")
        done = self.expect(0, ".").stdout
        self.assertIn("not compared: `sim/config/c.yaml`", done)
        self.assertIn("`sim/config/joint_limits.yaml`", done)
        self.assertNotIn("SML3803", done)

    def test_the_reason_is_about_robots_that_may_have_the_file(self):
        self.write("far/package.xml", cli.package("far"))
        self.write("far/urdf/far.urdf.xacro", robot("far", ["left", "right"], root="$(arg side)"))
        self.write("sim/package.xml", cli.package("sim"))
        self.write("sim/config/c.yaml", controllers("finger", "thumb"))
        self.assertRegex(self.expect(0, ".").stdout, "not compared: `sim/config/c.yaml`: (none of its 2 names is known|no robot was found)")

    def test_a_few_names_that_only_a_missing_package_writes(self):
        text = robot("bot").replace("<link", '<xacro:include filename="$(find gripper_description)/g.xacro"/><link', 1)
        self.write("bot_description/urdf/bot.urdf.xacro", text)
        self.write(self.config, controllers("shoulder", "elbow", "wrist", "hand", "knuckle"))
        self.assertNotIn("SML37", self.run_tool(".").stdout)
        self.write("bot_description/urdf/bot.urdf.xacro", text.replace("</robot>", "") + robot("bot", ["foot"], "hand_link").split("\n", 2)[2])
        self.write(self.config, controllers("shoulder", "elbow", "wrst", "hand", "foot", "knuckle"))
        done = self.run_tool(".").stdout
        self.assertIn("`wrst`", done)
        self.assertNotIn("`knuckle`", done)


@unittest.skipUnless(SHARED and (SHARED / "xacro/corpus").is_dir(), "there is no shared corpus")
class Corpus(cli.CliTest):
    """One joint is misspelt in companions of public repositories whose joints stand in a robot of the repository."""

    def setUp(self):
        super().setUp()
        self.enter_workspace()

    def lint(self, folder):
        done = subprocess.run([cli.TOOL, "--isolated", "--no-ignore-files", "--format", "json", "--exit-zero", "."], cwd=folder,
                              capture_output=True, text=True, errors="replace", check=False)
        return json.loads(done.stdout)

    def test_a_misspelt_joint(self):
        shown = collections.Counter()
        for repository in sorted((SHARED / "xacro/corpus").iterdir()):
            files = [path for path in sorted(repository.rglob("*")) if path.is_file()]
            robots = "".join(path.read_text(errors="replace") for path in files if path.suffix in (".urdf", ".xacro"))
            tried = []
            for path in files:
                text = path.read_text(errors="surrogateescape") if path.suffix == ".yaml" else ""
                names = re.search(r"^ *joints:\s*\n\s*- *\"?([A-Za-z]\w{3,})", text, re.M)
                is_companion = "ros__parameters" in text and "command_interfaces" in text or "controller_names" in text
                if is_companion and names and re.search(r"[}\"']" + names[1] + r"[\"'$]", robots):
                    tried.append((path.relative_to(repository), text, names[1]))
            if not tried:
                continue
            copy = self.folder / "r"
            shutil.copytree(repository, copy, symlinks=True)
            before = sum(self.lint(copy)["summary"].get("companions", {}).values())
            for name, text, joint in tried[:2]:
                wrong = joint[:-1] + ("qx" if joint.endswith("q") else "q")
                path = copy / name
                path.write_text(re.sub(r"(?<!\w)" + joint + r"(?!\w)", wrong, text), errors="surrogateescape")
                report = self.lint(copy)
                path.write_text(text, errors="surrogateescape")
                shown["files"] += 1
                is_shown = any(wrong in one["message"] and one["severity"] != "info" for one in report["diagnostics"])
                left = {one["path"] for one in report["summary"].get("not_compared", [])}
                # The robots of some repositories need packages that are not there. The file is then named with the reason.
                shown["shown"] += is_shown
                shown["told"] += is_shown or str(name) in left
                shown["kept"] += sum(report["summary"].get("companions", {}).values()) >= before
            shutil.rmtree(copy)
        self.assertGreater(shown["files"], 10)
        self.assertGreaterEqual(shown["kept"], 0.95 * shown["files"], shown)
        self.assertGreaterEqual(shown["told"], 0.95 * shown["files"], shown)
        self.assertGreaterEqual(shown["shown"], 0.6 * shown["files"], shown)


if __name__ == "__main__":
    cli.main()
