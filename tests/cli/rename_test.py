# SPDX-License-Identifier: BSD-3-Clause
"""smurf-lint --rename: which files it changes, and when it refuses."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import cli  # noqa: E402
from cli import ARM_MOTORS as MOTORS, ARM_SMURF as SMURF, ARM_URDF as URDF  # noqa: E402

MANIFEST = """<package format="3"><name>bot</name><version>1.0.0</version><description>d</description>
<maintainer email="a@example.org">A</maintainer><license>BSD</license></package>
"""
ROBOT = '<robot name="a">\n<link name="chassis"/>\n<link name="tool"/>\n' \
        '<joint name="j" type="fixed"><parent link="chassis"/><child link="tool"/></joint>\n</robot>\n'
NAV2 = "bot_navigator:\n  ros__parameters:\n    robot_base_frame: chassis\n    odom_frame: odom\n"
RVIZ = "Visualization Manager:\n  Displays:\n  - Links:\n      tool: {Alpha: 1}\n  Global Options:\n    Fixed Frame: odom\n"
LAUNCH = """<launch>
  <node pkg="robot_state_publisher" exec="robot_state_publisher">
    <param name="robot_description" value="$(command 'xacro $(find-pkg-share bot)/urdf/a.urdf')" type="str"/>
  </node>
  <node pkg="nav2_bringup" exec="nav"><param from="$(find-pkg-share bot)/config/nav2.yaml"/></node>
</launch>
"""
SRDF = '<robot name="arm">\n  <passive_joint name="elbow"/>\n</robot>\n'
SCENE = "entities:\n- {name: one, file: arm/smurf/arm.smurf}\n" \
        "- {name: two, file: arm/smurf/arm.smurf, position: [1, 0, 0], parent: 'one::forearm'}\n"


class Rename(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.write("arm/smurf/arm.smurf", SMURF)
        self.write("arm/smurf/arm_motors.yml", MOTORS)
        self.write("arm/urdf/arm.urdf", URDF)

    def refused(self, message, *arguments):
        before = {path: path.read_bytes() for path in self.folder.rglob("*") if path.is_file()}
        done = self.expect(2, *arguments)
        self.assertIn(message, done.stderr)
        self.assertEqual(done.stdout, "")
        for path, text in before.items():
            self.assertEqual(path.read_bytes(), text, path)

    def test_all_files(self):
        done = self.expect(0, "--rename", "joint:elbow=elbow_left", "arm")
        self.assertEqual(done.stderr, "smurf-lint: wrote 2 files: renamed 'elbow' to 'elbow_left'\n")
        self.assertIn("no findings", done.stdout)
        self.assertEqual(self.read("arm/urdf/arm.urdf"), URDF.replace("elbow", "elbow_left"))
        self.assertEqual(self.read("arm/smurf/arm_motors.yml"),
                         MOTORS.replace("joint: elbow", "joint: elbow_left"))
        self.expect(0, "--rename=joint:elbow_left=elbow", "arm")
        self.assertEqual(self.read("arm/urdf/arm.urdf"), URDF)
        self.assertEqual(self.read("arm/smurf/arm_motors.yml"), MOTORS)

    def test_several(self):
        self.expect(0, "--rename", "joint:elbow=j", "--rename", "motor:elbow=m", "--rename",
                    "forearm=f", "arm/smurf/arm.smurf")
        self.assertEqual(self.read("arm/smurf/arm_motors.yml"),
                         MOTORS.replace("joint: elbow", "joint: j").replace("elbow", "m"))
        self.assertIn('<child link="f"/>', self.read("arm/urdf/arm.urdf"))

    def test_srdf_beside_the_urdf(self):
        self.write("arm/urdf/arm.srdf", SRDF)
        self.write("arm/urdf/other.srdf", SRDF.replace("arm", "other"))
        self.expect(0, "--rename", "joint:elbow=j", "arm")
        self.assertEqual(self.read("arm/urdf/arm.srdf"), SRDF.replace("elbow", "j"))
        self.assertIn("elbow", self.read("arm/urdf/other.srdf"))

    def test_scene(self):
        self.write("world.smurfs", SCENE)
        self.expect(0, "--rename", "link:forearm=f", "--rename", "entity:one=first", ".")
        self.assertEqual(self.read("world.smurfs"),
                         SCENE.replace("forearm", "f").replace("name: one", "name: first")
                         .replace("one::", "first::"))
        self.assertIn('<link name="f">', self.read("arm/urdf/arm.urdf"))

    def test_diff_changes_nothing(self):
        done = self.expect(1, "--diff", "--rename", "joint:elbow=j", "arm")
        self.assertIn("-  joint: elbow\n+  joint: j\n", done.stdout)
        self.assertEqual(self.read("arm/urdf/arm.urdf"), URDF)

    def test_models_that_share_a_robot(self):
        for i in range(20):
            self.write(f"arm/smurf/m{i}.smurf", f"modelname: m{i}\nfiles: [../urdf/arm.urdf, m{i}.yml]\n")
            self.write(f"arm/smurf/m{i}.yml", MOTORS)
        # A limit must not leave the old name in the files of the last models.
        limit = str(3 * len(URDF))
        self.refused(f"more than {limit} bytes of files that other models have read are read again; raise the limit with "
                     "`--limit repeated-bytes=N`", "--rename", "joint:elbow=j", "--limit", f"repeated-bytes={limit}", "arm")
        self.refused("raise the limit with `--limit file-bytes=N`",
                     "--rename", "joint:elbow=j", "--limit", f"file-bytes={len(URDF) - 1}", "arm/smurf/m0.smurf")
        done = self.expect(0, "--rename", "joint:elbow=j", "arm")
        self.assertIn("wrote 22 files", done.stderr)
        for i in range(20):
            self.assertEqual(self.read(f"arm/smurf/m{i}.yml"), MOTORS.replace("joint: elbow", "joint: j"))

    def test_standard_input(self):
        done = self.run_tool("--rename", "joint:elbow=j", "--stdin-filename", "x/a.urdf", "-",
                             stdin=URDF)
        self.assertEqual((done.returncode, done.stdout), (0, URDF.replace("elbow", "j")))
        self.assertIn("no findings", done.stderr)

    def test_refused(self):
        self.refused("there is no joint `elbwo`; did you mean `elbow`?",
                     "--rename", "joint:elbwo=x", "arm")
        self.refused("`elbow` is a motor and a joint", "--rename", "elbow=x", "arm")
        self.refused("there is a link `base` already", "--rename", "forearm=base", "arm")
        self.refused("is not KIND:NAME=NEW", "--rename", "elbow", "arm")
        self.refused("--rename and --fix cannot be combined", "--rename", "a=b", "--fix", "arm")

    def test_two_models(self):
        self.write("other/urdf/other.urdf", URDF)
        self.refused("there are two: the joint `elbow`", "--rename", "joint:elbow=x", ".")

    def test_a_model_beside_it_that_shares_the_urdf(self):
        self.write("arm/smurf/bare.smurf", "modelname: bare\nfiles:\n- ../urdf/arm.urdf\n")
        self.refused("bare.smurf' reads 'arm/urdf/arm.urdf' as well; name it, too",
                     "--rename", "joint:elbow=x", "arm/smurf/arm.smurf")
        self.expect(0, "--rename", "joint:elbow=x", "arm")

    def test_all_files_or_none(self):
        (self.folder / "arm/smurf/arm_motors.yml").unlink()
        self.write("elsewhere/arm_motors.yml", MOTORS)
        (self.folder / "arm/smurf/arm_motors.yml").symlink_to(self.folder / "elsewhere/arm_motors.yml")
        (self.folder / "arm/.git").mkdir()
        self.refused("", "--rename", "joint:elbow=x", "--allow-outside", "arm")


class RenameAround(cli.CliTest):
    """Files around two robots with the same names: nothing says whose they are."""

    def setUp(self):
        super().setUp()
        self.write("bot/package.xml", MANIFEST)
        self.write("bot/urdf/a.urdf", ROBOT)
        self.write("bot/urdf/b.urdf", ROBOT.replace('"a"', '"b"'))
        self.write("bot/config/nav2.yaml", NAV2)
        self.write("bot/rviz/bot.rviz", RVIZ)

    def texts(self):
        return [self.read(f"bot/{name}") for name in ("urdf/a.urdf", "urdf/b.urdf", "config/nav2.yaml", "rviz/bot.rviz")]

    def rename(self, code, name, *more, of="bot/urdf/a.urdf"):
        done = self.run_tool("--rename", f"link:{name}=x", *more, of)
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stderr

    def test_of_one_robot(self):
        (self.folder / "bot/urdf/b.urdf").unlink()
        self.assertNotIn("still named", self.rename(0, "chassis"))
        self.assertEqual(self.read("bot/config/nav2.yaml"), NAV2.replace("chassis", "x"))
        self.expect(0, "--rename", "link:x=base", "bot")
        self.assertNotIn("still named", self.rename(0, "tool", of="bot"))
        self.assertEqual(self.read("bot/rviz/bot.rviz"), RVIZ.replace("tool", "x"))

    def test_refused(self):
        before = self.texts()
        self.assertIn("nothing was renamed: the link `chassis` of 'bot/urdf/b.urdf' may be meant in 'bot/config/nav2.yaml' "
                      "(line 3); tie files to a robot", self.rename(2, "chassis"))
        self.assertEqual(self.texts(), before)
        # Both robots are loaded.
        self.assertIn("of 'bot/urdf/a.urdf' or that of 'bot/urdf/b.urdf' may be meant in",
                      self.rename(2, "chassis", of="bot"))
        self.assertEqual(self.texts(), before)

    def test_left_as_they_are(self):
        self.assertIn("`chassis` is still named in 'bot/config/nav2.yaml' (line 3)", self.rename(0, "chassis", "--force"))
        self.assertEqual(self.texts(), [ROBOT.replace("chassis", "x"), ROBOT.replace('"a"', '"b"'), NAV2, RVIZ])

    def test_what_is_only_remembered(self):
        self.assertIn("`tool` is still named in 'bot/rviz/bot.rviz' (line 4)", self.rename(0, "tool"))
        self.assertEqual(self.texts(), [ROBOT.replace("tool", "x"), ROBOT.replace('"a"', '"b"'), NAV2, RVIZ])

    def test_given_by_a_launch_file(self):
        self.write("bot/launch/a.launch.xml", LAUNCH)
        self.rename(0, "chassis")
        self.assertEqual(self.texts(), [ROBOT.replace("chassis", "x"), ROBOT.replace('"a"', '"b"'),
                                        NAV2.replace("chassis", "x"), RVIZ])

    def test_given_to_the_other_robot(self):
        self.write("bot/launch/b.launch.xml", LAUNCH.replace("a.urdf", "b.urdf"))
        self.rename(0, "chassis")
        self.assertEqual(self.read("bot/config/nav2.yaml"), NAV2)

    def test_given_by_the_configuration(self):
        self.write("bot/.smurf-lint.yaml", "companions:\n- robot: urdf/a.urdf\n  files: config/nav2.yaml\n")
        self.rename(0, "chassis")
        self.assertEqual(self.read("bot/config/nav2.yaml"), NAV2.replace("chassis", "x"))


if __name__ == "__main__":
    cli.main()
