# SPDX-License-Identifier: BSD-3-Clause
"""The first day with smurf-lint: --init sets up a folder, --watch follows it, and a page says that it was written."""
import json
import re
import signal
import subprocess
import sys
import time

import cli

URDF = """<robot name="a">
  <link name="base"><visual><geometry><mesh filename="package://arm_meshes/base.stl"/></geometry></visual>
    <collision><geometry><mesh filename="package://elsewhere/base.stl"/></geometry></collision></link>
  <gazebo reference="base"/>
</robot>
"""
MACRO = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:macro name="m" params=""/></robot>\n'
ROOT = ('<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:include filename="part.xacro"/>'
        '<link name="l"/></robot>\n')


class Init(cli.CliTest):
    def files(self):
        return sorted(str(path.relative_to(self.folder)) for path in self.folder.rglob("*") if path.is_file())

    def test_a_folder(self):
        self.write("urdf/a.urdf", URDF)
        self.write("urdf/r.urdf.xacro", ROOT)
        self.write("urdf/part.xacro", MACRO)
        self.write("parts/arm_meshes/readme.txt", "")
        done = self.expect(0, "--init")
        self.assertIn("found 1 URDF, 2 xacro files with 1 robot\n", done.stdout)
        self.assertIn("wrote .smurf-lint.yaml: targets gazebo, ros, 1 package\n", done.stdout)
        self.assertIn("no git repository: no hook and no workflow\n", done.stdout)
        self.assertIn("the folder of the package elsewhere is not here", done.stdout)
        written = self.read(".smurf-lint.yaml")
        self.assertIn("targets: [gazebo, ros]\n", written)
        self.assertIn("packages:\n  arm_meshes: parts/arm_meshes\n", written)
        self.assertIn("#  elsewhere: ../elsewhere\n", written)
        # smurf-lint reads it without a finding about it, and finds the file.
        self.write("parts/arm_meshes/base.stl", "solid a\nendsolid a\n")
        report = self.expect(None, "--min-severity", "info", "urdf/a.urdf").stdout
        self.assertNotIn("SML90", report)
        self.assertNotIn("cannot find any file of the package `arm_meshes`", report)
        self.assertIn("\ngazebo ", report)

    def test_companions_are_judged_by_their_readers(self):
        self.write("arm.urdf", cli.ARM_URDF.replace("</robot>", '<ros2_control name="arm" type="system"/>\n</robot>'))
        self.write("config/arm.srdf", '<robot name="arm"/>\n')
        self.assertIn("targets moveit, ros, ros2_control", self.expect(0, "--init").stdout)

    def test_what_launch_files_start_are_targets(self):
        self.write("package.xml", cli.package("arm"))
        self.write("arm.urdf", cli.ARM_URDF)
        self.write("launch/arm.launch.py", "Node(package='robot_state_publisher', executable='robot_state_publisher')\n"
                                           "Node(package='controller_manager', executable='ros2_control_node')\n")
        self.assertIn("targets ros, ros2_control", self.expect(0, "--init").stdout)

    def test_a_repository(self):
        self.write(".git/HEAD", "ref: refs/heads/main\n")
        self.write("arm.urdf", cli.ARM_URDF)
        self.write("smurf/arm.smurf", cli.ARM_SMURF.replace("../urdf", ".."))
        self.write("smurf/arm_motors.yml", cli.ARM_MOTORS)
        done = self.expect(0, "--init")
        self.assertEqual([name for name in self.files() if not name.startswith(".git/")],
                         [".github/workflows/smurf-lint.yml", ".pre-commit-config.yaml", ".smurf-lint.yaml", "arm.urdf",
                          "smurf/arm.smurf", "smurf/arm_motors.yml"])
        self.assertIn("id: smurf2urdf-check", self.read(".pre-commit-config.yaml"))
        self.assertIn("uses: smurf-tools/smurf@v", self.read(".github/workflows/smurf-lint.yml"))
        self.assertIn("targets: [mars]", self.read(".smurf-lint.yaml"))
        self.assertEqual(done.stdout.count("\nwrote "), 3)

    def test_arguments_in_launch_files(self):
        """UR: a default that is not one of the choices, and an argument that is used above its definition."""
        self.write("urdf/arm.urdf.xacro", '<robot name="$(arg name)" xmlns:xacro="http://www.ros.org/wiki/xacro">\n'
                   '  <xacro:arg name="name" default="arm"/>\n  <xacro:arg name="size" default="none"/>\n'
                   '  <xacro:arg name="fine" default="a"/>\n  <link name="$(arg size)"/>\n</robot>\n')
        self.write("launch/view.launch.py", 'DeclareLaunchArgument(\n    "size", description="x", choices=["s", "m"])\n'
                   'DeclareLaunchArgument("fine", choices=["a", "b"])\n'
                   'Command(["xacro ", find("urdf/arm.urdf.xacro"), " ", "name:=", "my_arm", " ", "size:=", size])\n')
        self.assertIn("1 robot with arguments", self.expect(0, "--init").stdout)
        self.assertTrue(self.read(".smurf-lint.yaml").endswith(
            'xacro:\n- file: urdf/arm.urdf.xacro\n  arguments:\n    name: "my_arm"\n    size: ["s", "m"]\n'))
        self.assertNotIn("SML33", self.expect(None, ".").stdout)

    def test_targets_make_no_error(self):
        """A release that has what the robot names; and what is an error for every release keeps its severity."""
        hardware = ('<ros2_control name="arm" type="system"><hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware></ros2_control>'
                    '<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin"/></gazebo>')
        self.write("arm.urdf", cli.ARM_URDF.replace("</robot>", hardware + "</robot>"))
        self.write("frames [1].urdf", '<robot name="f"><link name="a"/><gazebo reference="a"/></robot>\n')
        self.write("frames.urdf", '<robot name="f"><link name="a"/><gazebo reference="a"/></robot>\n')

        def errors():
            report = json.loads(self.run_tool("--format", "json", "--exit-zero", ".").stdout)
            return sorted((one["id"], one["file"]) for one in report["diagnostics"] if one["severity"] == "error")
        before = errors()
        done = self.expect(0, "--init").stdout
        written = self.read(".smurf-lint.yaml")
        release = re.search(r"targets: \[(gazebo:\w+), ros, ros2_control\]\n", written)
        self.assertIn('  "/frames.urdf": {severity: {SML1916: warning}}\n', written)
        self.assertIn("by `paths` in .smurf-lint.yaml", done)
        self.assertEqual([one for one in errors() if one not in before and one[1] != "frames [1].urdf"], [])
        self.assertIn(release[1], self.run_tool(".").stdout)

    def test_nothing_is_replaced(self):
        self.write(".git/HEAD", "ref: refs/heads/main\n")
        self.write("arm.urdf", cli.ARM_URDF)
        self.write(".smurf-lint.yaml", "targets: [drake]\n")
        self.write(".pre-commit-config.yaml", "repos: []\n")
        done = self.expect(0, "--init")
        self.assertEqual(self.read(".smurf-lint.yaml"), "targets: [drake]\n")
        self.assertEqual(self.read(".pre-commit-config.yaml"), "repos: []\n")
        self.assertIn("left .smurf-lint.yaml as it is\n", done.stdout)
        self.assertIn("add this to its `repos`:\n- repo: https://github.com/smurf-tools/smurf\n", done.stdout)
        self.assertTrue((self.folder / ".github/workflows/smurf-lint.yml").exists())
        before = {name: self.read(name) for name in self.files()}
        self.expect(0, "--init")
        self.assertEqual(before, {name: self.read(name) for name in self.files()})

    def test_another_folder_and_mistakes(self):
        self.write("robots/arm.urdf", cli.ARM_URDF)
        self.expect(0, "--init", "robots")
        self.assertTrue((self.folder / "robots/.smurf-lint.yaml").exists())
        self.write("empty/readme.txt", "")
        done = self.expect(2, "--init", "empty")
        self.assertIn("nothing was written", done.stderr)
        self.assertIn("is not a folder", self.expect(2, "--init", "robots/arm.urdf").stderr)
        self.assertIn("sets up one folder", self.expect(2, "--init", "a", "b").stderr)


class Watch(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.running = None

    def tearDown(self):
        if self.running and self.running.poll() is None:
            self.running.kill()
            self.running.wait()
        super().tearDown()

    def start(self, *arguments):
        self.out = open(self.folder / "out.log", "w+")
        self.running = subprocess.Popen([cli.TOOL, "--watch", *arguments], cwd=self.folder, stdout=self.out,
                                        stderr=subprocess.STDOUT)

    def wait_for(self, text, times=1):
        for _ in range(600):
            if self.read("out.log").count(text) >= times:
                return self.read("out.log")
            self.assertIsNone(self.running.poll(), self.read("out.log"))
            time.sleep(0.05)
        self.fail(f"{text!r} not {times} times in\n{self.read('out.log')}")

    def stop(self):
        self.running.send_signal(signal.SIGINT)
        self.assertEqual(self.running.wait(timeout=600), 0)
        self.out.close()

    def test_changes_are_checked_until_the_end(self):
        self.write("arm.urdf", cli.ARM_URDF)
        self.start("arm.urdf")
        self.wait_for("waiting for changes")
        self.write("arm.urdf", cli.ARM_URDF.replace('<mass value="1"/>', '<mass value="-1"/>'))
        said = self.wait_for("waiting for changes", 2)
        self.assertIn("arm.urdf has changed\n", said)
        self.assertIn("SML1509", said)
        self.write("arm.urdf", cli.ARM_URDF)
        said = self.wait_for("waiting for changes", 3)
        self.assertEqual(said.count("error[SML1509]"), 1)
        self.stop()

    def test_files_of_a_folder_and_missing_ones(self):
        mesh = '<visual><geometry><mesh filename="m.obj"/></geometry></visual>'
        self.write("robots/arm.urdf", cli.ARM_URDF.replace('<link name="base"/>', f'<link name="base">{mesh}</link>'))
        self.start("robots")
        self.assertIn("SML1604", self.wait_for("waiting for changes"))
        self.write("robots/m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
        said = self.wait_for("waiting for changes", 2)
        self.assertEqual(said.count("SML1604]"), 1)
        self.write("robots/new.urdf", cli.ARM_URDF.replace('<mass value="1"/>', '<mass value="-1"/>'))
        self.assertIn("new.urdf", self.wait_for("waiting for changes", 3))
        self.stop()

    def test_what_writes_is_refused(self):
        self.write("arm.urdf", cli.ARM_URDF)
        for option in ("--fix", "--diff", "--generate-baseline"):
            self.assertIn("--watch only reports", self.expect(2, "--watch", option, "arm.urdf").stderr)
        self.assertIn("not standard input", self.expect(2, "--watch", "-").stderr)


class Mistakes(cli.CliTest):
    def test_each_says_what_to_do(self):
        self.expect_complaint("--limit: there is no limit 'yaml-dept'; did you mean 'yaml-depth'?; --limit help lists them",
                              "--limit", "yaml-dept=3", "x.urdf")
        self.assertIn("did you mean 'isaac'?", self.expect(2, "--target", "isaacs", "x.urdf").stderr)
        (self.folder / "loop.urdf").symlink_to("loop.urdf")
        self.expect_complaint("cannot read 'loop.urdf': is a link to a file that is missing, or lies outside of the project", "loop.urdf")


class Written(cli.CliTest):
    def test_a_page_says_that_it_was_written(self):
        self.write("arm.urdf", cli.ARM_URDF)
        done = self.expect(0, "--format", "html=report.html", "arm.urdf")
        self.assertRegex(done.stderr, r"\Asmurf-lint: wrote report.html: (no findings|found .*) in 1 file \(1 model\)\n\Z")
        self.assertEqual(done.stdout, "")
        self.assertEqual(self.expect(0, "--quiet", "--format", "html=report.html", "arm.urdf").stderr, "")
        self.assertEqual(self.expect(0, "--format", "json=report.json", "arm.urdf").stderr, "")
        both = self.expect(0, "--format", "full", "--format", "html=report.html", "arm.urdf")
        self.assertNotIn("wrote", both.stderr)


if __name__ == "__main__":
    if sys.platform == "win32":
        sys.exit(77)
    cli.main()
