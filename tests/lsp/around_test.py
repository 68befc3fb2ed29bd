# SPDX-License-Identifier: BSD-3-Clause
"""Launch files, and files of navigation and RViz, over real standard streams: hover, jumps, completion, references and
renaming, with and without the robot open. around_test.py SMURF-LSP [unittest option]..."""
import pathlib
import shutil
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import client  # noqa: E402
from client import apply, path_of, text_in  # noqa: E402

TOOL = None
MANIFEST = """<package format="3"><name>bot</name><version>1.0.0</version><description>d</description>
<maintainer email="a@example.org">A</maintainer><license>BSD</license><buildtool_depend>ament_cmake</buildtool_depend>
<export><build_type>ament_cmake</build_type></export></package>
"""
XACRO = """<?xml version="1.0"?>
<robot name="bot" xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:arg name="side" default="left"/>
<link name="chassis"/>
<link name="$(arg side)_arm"/>
<link name="camera"/>
<joint name="turn" type="fixed"><parent link="chassis"/><child link="$(arg side)_arm"/></joint>
<joint name="hold" type="fixed"><parent link="chassis"/><child link="camera"/></joint>
</robot>
"""
NAV2 = """amcl:
  ros__parameters:
    base_frame_id: chassis
    odom_frame_id: odom
bt_navigator:
  ros__parameters:
    robot_base_frame: "chassis"  # of the robot
    global_frame: map
local_costmap:
  local_costmap:
    ros__parameters:
      scan:
        sensor_frame: camera
"""
RVIZ = """Visualization Manager:
  Displays:
    - Class: rviz_default_plugins/RobotModel
      Links:
        All Links Enabled: true
        camera:
          Alpha: 1
        chassis:
          Alpha: 1
    - Class: rviz_default_plugins/TF
      Frames:
        chassis:
          Value: true
      Tree:
        odom:
          chassis:
            camera: {}
  Global Options:
    Fixed Frame: chassis
"""
LUA = 'options = {\n  tracking_frame = "chassis",\n  published_frame = "odom",\n}\n'
PYTHON = """from launch import LaunchDescription
from launch.substitutions import Command, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    robot = Command(['xacro ', PathJoinSubstitution([FindPackageShare('bot'), 'urdf', 'bot.urdf.xacro']), ' side:=left'])
    return LaunchDescription([
        Node(package='robot_state_publisher', executable='robot_state_publisher',
             parameters=[{'robot_description': ParameterValue(robot, value_type=str)}]),
        Node(package='tf2_ros', executable='static_transform_publisher',
             arguments=['--frame-id', 'camera', '--child-frame-id', 'lens']),
        Node(package='driver', executable='driver', parameters=[{'frame_id': 'camera', 'name': 'camera'}]),
    ])
"""
XML = """<launch>
  <arg name="base" default="chassis"/>
  <node pkg="tf2_ros" exec="static_transform_publisher" args="0 0 0 0 0 0 camera camera_2"/>
  <node pkg="tf2_ros" exec="static_transform_publisher" args="--frame-id $(var base) --child-frame-id lidar"/>
</launch>
"""
YAML = """launch:
- node:
    pkg: tf2_ros
    exec: static_transform_publisher
    args: '0 0 0 0 0 0 camera camera_3'
"""
FILES = {"package.xml": MANIFEST, "urdf/bot.urdf.xacro": XACRO, "config/nav2.yaml": NAV2, "rviz/bot.rviz": RVIZ,
         "cartographer/bot.lua": LUA, "launch/bot.launch.py": PYTHON, "launch/other.launch.xml": XML,
         "launch/more.launch.yaml": YAML}
OTHER = '<robot name="other">\n<link name="chassis"/>\n<link name="other_tool"/>\n' \
        '<joint name="j" type="fixed"><parent link="chassis"/><child link="other_tool"/></joint>\n</robot>\n'


class Around(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="smurf-lsp-")).resolve()
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        for name, text in FILES.items():
            self.write(name, text)
        self.client = client.Client(TOOL, [self.folder])
        self.addCleanup(self.client.end)

    def tearDown(self):
        self.assertEqual(self.client.stop(), 0)
        self.assertEqual(self.client.stderr, b"")

    def write(self, name, text):
        path = self.folder / "bot" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    def open(self, name, text=None):
        self.client.open(self.folder / "bot" / name, text)

    def at(self, method, name, word, into=1, **more):
        path = self.folder / "bot" / name
        text = self.client.texts[str(path)]
        self.assertIn(word, text)
        return self.client.at(f"textDocument/{method}", path, text.index(word) + into, **more)

    def hover(self, name, word, into=1):
        found = self.at("hover", name, word, into)
        return found["contents"]["value"] if found else None

    def labels(self, name, word, into=1):
        return sorted(one["label"] for one in self.at("completion", name, word, into)["items"])

    def places(self, found):
        return sorted((str(pathlib.Path(path_of(one["uri"])).relative_to(self.folder / "bot")),
                       text_in(pathlib.Path(path_of(one["uri"])).read_text(), one["range"])) for one in found)

    def renamed(self, name, word, to, into=1):
        """The new texts of the files that a rename changes."""
        changes = self.at("rename", name, word, into, newName=to)["changes"]
        return {str(pathlib.Path(path_of(one)).relative_to(self.folder / "bot")):
                apply(pathlib.Path(path_of(one)).read_text(), edits) for one, edits in changes.items()}

    def check_link(self, name, word, into=1, link="chassis"):
        """Whether a place names a link of the robot."""
        self.assertTrue(self.hover(name, word, into).startswith(f"link `{link}`"), name)
        self.assertEqual(self.places(self.at("definition", name, word, into)), [("urdf/bot.urdf.xacro", link)])
        self.assertLessEqual({"chassis", "left_arm", "camera"}, set(self.labels(name, word, into)))
        # A name that is just begun is completed, too.
        path = str(self.folder / "bot" / name)
        text = self.client.texts[path]
        at = text.index(word) + into
        begin = at - next(i for i in range(20) if not (text[at - i - 1].isalnum() or text[at - i - 1] == "_"))
        self.client.edit(path, begin, begin + len(link), "")
        self.assertIn(link, [one["label"] for one in self.client.at("textDocument/completion", path, begin)["items"]])
        self.client.edit(path, begin, begin, link)

    def test_each_file_alone(self):
        """No robot is open: the robots of the file are loaded for it."""
        for name, word, into, link in (
                ("config/nav2.yaml", "chassis", 2, "chassis"), ("config/nav2.yaml", '"chassis"', 3, "chassis"),
                ("config/nav2.yaml", "sensor_frame: camera", 15, "camera"),
                ("rviz/bot.rviz", "Fixed Frame: chassis", 14, "chassis"), ("rviz/bot.rviz", "camera:", 2, "camera"),
                ("cartographer/bot.lua", '"chassis"', 2, "chassis"),
                ("launch/bot.launch.py", "'camera'", 2, "camera"),
                ("launch/bot.launch.py", "'frame_id': 'camera'", 14, "camera"),
                ("launch/other.launch.xml", "camera ", 2, "camera"),
                ("launch/other.launch.xml", "chassis", 2, "chassis"),
                ("launch/more.launch.yaml", "camera ", 2, "camera")):
            with self.subTest(name=name, word=word):
                self.open(name)
                self.check_link(name, word, into, link)
                self.client.close(self.folder / "bot" / name)

    def test_beside_the_robot(self):
        self.open("urdf/bot.urdf.xacro")
        self.assertTrue(self.hover("urdf/bot.urdf.xacro", '"chassis"', 2).startswith("link"))
        self.open("config/nav2.yaml")
        self.check_link("config/nav2.yaml", "chassis")

    def test_no_names(self):
        self.open("config/nav2.yaml")
        self.open("launch/bot.launch.py")
        self.open("launch/other.launch.xml")
        self.assertIsNone(self.hover("config/nav2.yaml", "odom\n"))
        self.assertEqual(self.labels("config/nav2.yaml", "amcl"), [])
        self.assertIsNone(self.hover("launch/bot.launch.py", "'lens'"))
        self.assertIsNone(self.hover("launch/bot.launch.py", "'name': 'camera'", 10))
        self.assertEqual(self.labels("launch/bot.launch.py", "'driver'"), [])
        self.assertIsNone(self.hover("launch/other.launch.xml", "camera_2", 7))
        self.assertEqual(self.labels("launch/other.launch.xml", "tf2_ros"), [])

    def test_references(self):
        self.open("urdf/bot.urdf.xacro")
        found = self.at("references", "urdf/bot.urdf.xacro", '"camera"', 2, context={"includeDeclaration": True})
        self.assertEqual(self.places(found), sorted([
            ("urdf/bot.urdf.xacro", "camera"), ("urdf/bot.urdf.xacro", "camera"), ("config/nav2.yaml", "camera"),
            ("rviz/bot.rviz", "camera"), ("rviz/bot.rviz", "camera"), ("launch/bot.launch.py", "camera"),
            ("launch/bot.launch.py", "camera"), ("launch/other.launch.xml", "camera"),
            ("launch/more.launch.yaml", "camera")]))

    def test_rename_in_all_files(self):
        self.open("urdf/bot.urdf.xacro")
        changed = self.renamed("urdf/bot.urdf.xacro", '"chassis"', "body", 2)
        self.assertEqual(changed, {name: FILES[name].replace("chassis", "body") for name in (
            "urdf/bot.urdf.xacro", "config/nav2.yaml", "rviz/bot.rviz", "cartographer/bot.lua",
            "launch/other.launch.xml")})
        # And from there.
        self.open("launch/bot.launch.py")
        changed = self.renamed("launch/bot.launch.py", "'camera'", "eye", 2)
        self.assertEqual(changed["launch/bot.launch.py"],
                         PYTHON.replace("-id', 'camera'", "-id', 'eye'").replace("frame_id': 'camera'", "frame_id': 'eye'"))
        self.assertEqual(changed["launch/other.launch.xml"], XML.replace("camera ", "eye "))
        self.assertEqual(changed["launch/more.launch.yaml"], YAML.replace("camera ", "eye "))
        for name, text in changed.items():
            self.write(name, text)
        self.client.notify("workspace/didChangeWatchedFiles", {"changes": []})
        self.client.close(self.folder / "bot/urdf/bot.urdf.xacro")
        self.client.close(self.folder / "bot/launch/bot.launch.py")
        self.open("rviz/bot.rviz")
        back = self.renamed("rviz/bot.rviz", "eye", "camera")
        self.assertEqual(back, {name: FILES[name] for name in changed})

    def test_names_that_a_program_would_read_differently(self):
        self.open("urdf/bot.urdf.xacro")
        for name in ("two words", "a'b", 'a\\b'):
            with self.assertRaisesRegex(client.RequestError, "nothing was renamed: .*(read as|letters)"):
                self.at("rename", "urdf/bot.urdf.xacro", '"camera"', 2, newName=name)

    def test_a_child_that_would_become_a_link(self):
        self.open("urdf/bot.urdf.xacro")
        with self.assertRaisesRegex(client.RequestError, "launch.*`lens` would refer to something else"):
            self.at("rename", "urdf/bot.urdf.xacro", '"camera"', 2, newName="lens")

    def test_a_file_that_robots_share(self):
        """Nothing says whose nav2.yaml is: no other robot is changed, and nothing is left behind."""
        self.write("urdf/other.urdf", OTHER)
        self.open("urdf/bot.urdf.xacro")
        with self.assertRaisesRegex(client.RequestError, "other.urdf' may be meant in .*lua.*nav2.yaml'"):
            self.at("rename", "urdf/bot.urdf.xacro", '"chassis"', 2, newName="body")
        # What RViz only remembers is left as it is.
        changed = self.renamed("urdf/bot.urdf.xacro", '"camera"', "eye", 2)
        self.assertNotIn("urdf/other.urdf", changed)
        self.assertIn("rviz/bot.rviz", changed)
        # The configuration says it.
        self.write(".smurf-lint.yaml", "companions:\n- robot: urdf/bot.urdf.xacro\n  files: [config/nav2.yaml, "
                   "cartographer/bot.lua, rviz/bot.rviz, launch/other.launch.xml]\n")
        self.client.notify("workspace/didChangeWatchedFiles", {"changes": []})
        changed = self.renamed("urdf/bot.urdf.xacro", '"chassis"', "body", 2)
        self.assertEqual(sorted(changed), ["cartographer/bot.lua", "config/nav2.yaml", "launch/other.launch.xml",
                                           "rviz/bot.rviz", "urdf/bot.urdf.xacro"])

    def test_files_of_a_launch_file(self):
        self.open("launch/bot.launch.py")
        name = "launch/bot.launch.py"
        self.assertEqual(self.hover(name, "bot.urdf.xacro").replace("\\", ""), str(self.folder / "bot/urdf/bot.urdf.xacro"))
        self.assertEqual([path_of(one["uri"]) for one in self.at("definition", name, "bot.urdf.xacro")],
                         [str(self.folder / "bot/urdf/bot.urdf.xacro")])
        self.assertEqual([path_of(one["uri"]) for one in self.at("definition", name, "'bot'", 2)],
                         [str(self.folder / "bot/package.xml")])

    def test_arguments_of_the_xacro(self):
        name = "launch/bot.launch.py"
        self.open(name)
        self.assertIn("argument `side` of the xacro", self.hover(name, "side:="))
        self.assertEqual(self.places(self.at("definition", name, "side:=")), [("urdf/bot.urdf.xacro", "side")])
        self.assertEqual(self.labels(name, "side:="), ["side"])
        path = self.folder / "bot" / name
        self.client.replace(path, PYTHON.replace(" side:=left", " s"))
        self.assertEqual([one["textEdit"]["newText"] for one in self.at("completion", name, " s'", 2)["items"]], ["side:="])

    def test_a_controller_alone(self):
        text = ("controller_manager:\n  ros__parameters:\n    base:\n      type: diff_drive_controller/DiffDriveController\n"
                "base:\n  ros__parameters:\n    left_wheel_names: [turn]\n    base_frame_id: chassis\n")
        self.write("config/controllers.yaml", text)
        self.open("config/controllers.yaml")
        self.assertTrue(self.hover("config/controllers.yaml", "chassis").startswith("link `chassis`"))
        self.assertIn("chassis", self.labels("config/controllers.yaml", "chassis"))
        self.assertTrue(self.hover("config/controllers.yaml", "turn").startswith("joint `turn`"))

    def test_while_it_is_broken(self):
        """No crash, and no names of what cannot be read."""
        for name in ("launch/bot.launch.py", "launch/other.launch.xml", "launch/more.launch.yaml", "config/nav2.yaml",
                     "rviz/bot.rviz", "cartographer/bot.lua"):
            self.open(name)
            text = FILES[name]
            path = self.folder / "bot" / name
            for size in range(0, len(text), 23):
                self.client.replace(path, text[:size])
                for method in ("hover", "completion", "definition"):
                    self.client.at(f"textDocument/{method}", path, size)


if __name__ == "__main__":
    TOOL = sys.argv.pop(1)
    unittest.main()
