# SPDX-License-Identifier: BSD-3-Clause
"""Worlds of SDF as scenes: what smurfs-flatten and smurf-lint make of known worlds, and, where they are, of those of which
the answers of libsdformat were recorded (../shared/imports): links, poses, masses, limits.

sdf_world_test.py SMURFS_FLATTEN SMURF_LINT
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

SHARED = pathlib.Path(__file__).resolve().parents[2].parent / "shared/imports"
LEAST_EQUAL = 0.95
FLATTEN, LINT = (str(pathlib.Path(one).absolute()) for one in sys.argv[1:3])

HALL = """<?xml version="1.0"?>
<sdf version="1.9"><world name="hall">
  <gravity>0 0 -1.62</gravity>
  <physics type="ode"><max_step_size>0.002</max_step_size></physics>
  <scene><background>0.1 0.2 0.3 1</background></scene>
  <light name="lamp" type="spot"><pose>1 2 3 0 0 0</pose><diffuse>1 0.5 0.25 1</diffuse>
    <spot><inner_angle>0.1</inner_angle><outer_angle>0.5</outer_angle><falloff>2</falloff></spot></light>
  <include><uri>model://sun</uri></include>
  <frame name="corner"><pose>10 0 0 0 0 1.5707963267948966</pose></frame>
  <model name="wall"><static>true</static><pose relative_to="corner">1 0 0 0 0 0</pose>
    <link name="brick"><pose>0 0 0.5 0 0 0</pose><collision name="c"><geometry><box><size>1 2 3</size></box></geometry></collision></link></model>
  <model name="ground"><static>true</static><link name="l">
    <collision name="c"><geometry><heightmap><uri>hills.png</uri><size>40 30 5</size><pos>0 0 2</pos></heightmap></geometry></collision>
    <visual name="v"><geometry><heightmap><uri>hills.png</uri><size>40 30 5</size><pos>0 0 2</pos></heightmap></geometry></visual></link></model>
  <include><uri>model://cart</uri><name>left</name><pose>0 1 0 0 0 0</pose></include>
  <include><uri>model://cart</uri><name>right</name><pose>0 -1 0 0 0 0</pose></include>
  <include><uri>model://cart</uri><name>parked</name><pose>5 0 0 0 0 0</pose><static>true</static></include>
  <model name="outer"><pose>0 0 7 0 0 0</pose><model name="inner"><pose>1 0 0 0 0 0</pose><link name="core"/></model></model>
</world></sdf>
"""
FILES = {
    "models/sun/model.config": '<model><name>sun</name><sdf version="1.6">model.sdf</sdf></model>',
    "models/sun/model.sdf": '<sdf version="1.6"><light name="sun" type="directional"><pose>0 0 10 0 0 0</pose>'
                            '<direction>0 0.6 -0.8</direction></light></sdf>',
    "models/cart/model.config": '<model><name>cart</name><sdf version="1.6">model.sdf</sdf></model>',
    "models/cart/model.sdf":
        '<sdf version="1.6"><model name="cart"><link name="body"><pose>0 0 0.25 0 0 0</pose><inertial><mass>4</mass></inertial>'
        '</link><link name="wheel"><pose>0 0.5 0.25 0 0 0</pose></link><joint name="axle" type="revolute"><parent>body</parent>'
        '<child>wheel</child><axis><xyz>0 1 0</xyz></axis></joint></model></sdf>',
    "hills.png": "",
}


class WorldTest(unittest.TestCase):
    def run_tool(self, tool, world, *options, files=None, name="hall.sdf"):
        with tempfile.TemporaryDirectory() as folder:
            for other, content in (FILES if files is None else files).items():
                pathlib.Path(folder, other).parent.mkdir(parents=True, exist_ok=True)
                pathlib.Path(folder, other).write_text(content, encoding="utf-8")
            pathlib.Path(folder, name).write_text(world, encoding="utf-8")
            return subprocess.run([tool, name, *options], capture_output=True, text=True, check=False, cwd=folder)

    def flat(self, world, *options, **settings):
        result = self.run_tool(FLATTEN, world, "--links", *options, **settings)
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(result.stdout)

    def assert_near(self, got, want):
        self.assertEqual(len(got), len(want))
        for one, other in zip(got, want):
            self.assertAlmostEqual(one, other, 9)

    def test_hall(self):
        scene = self.flat(HALL)
        entities = {one["name"]: one for one in scene["instances"]}
        self.assertEqual(list(entities), ["wall", "ground", "ground_heightmap", "left", "right", "parked", "outer"])
        self.assert_near(entities["wall"]["links"]["brick"]["position"], [10, 1, 0.5])
        self.assertEqual({name for name, one in entities.items() if one.get("anchor") == "world"},
                         {"wall", "ground", "ground_heightmap", "parked"})
        self.assert_near(entities["left"]["links"]["wheel"]["position"], [0, 1.5, 0.25])
        self.assert_near(entities["right"]["links"]["wheel"]["position"], [0, -0.5, 0.25])
        self.assertEqual(entities["left"]["model"], entities["right"]["model"])
        self.assert_near(entities["outer"]["links"]["inner::core"]["position"], [1, 0, 7])
        self.assert_near(entities["ground_heightmap"]["position"], [0, 0, 2])
        self.assertEqual([entities["ground_heightmap"]["properties"][one] for one in ("length", "width", "height")],
                         [40, 30, 5])
        self.assertEqual(entities["wall"]["source"], {"file": "hall.sdf", "line": 10})
        self.assert_near(scene["physics"]["gravity"], [0, 0, -1.62])
        self.assertAlmostEqual(scene["physics"]["step_size"], 0.002, 12)

    def test_lights(self):
        result = self.run_tool(FLATTEN, HALL, "--format", "sdf")
        self.assertEqual(result.returncode, 0, result.stderr)
        for part in ('<light name="lamp" type="spot">', "<outer_angle>0.5</outer_angle>", "<falloff>2</falloff>",
                     "<diffuse>1 0.5 0.25 1</diffuse>", '<light name="sun" type="directional">',
                     "<gravity>0 0 -1.62</gravity>"):
            self.assertIn(part, result.stdout)
        direction = re.findall("<direction>(.*)</direction>", result.stdout)[1]
        self.assert_near([float(one) for one in direction.split()], [0, 0.6, -0.8])

    def test_losses_at_their_places(self):
        world = '<sdf version="1.9"><world name="w">\n<spherical_coordinates/>\n<scene>\n<sky/></scene>\n' \
                '<plugin name="gz::sim::systems::Physics" filename="a"/>\n<plugin name="gz::sim::systems::Buoyancy" filename="b"/>\n' \
                '<model name="m"><link name="a"/></model>\n</world></sdf>'
        result = self.run_tool(LINT, world, "--format", "json", files={})
        found = [(one["line"], one["message"]) for one in json.loads(result.stdout)["diagnostics"]
                 if one["id"] == "SML9304"]
        self.assertEqual([line for line, _ in found], [2, 4, 6], result.stdout)
        self.assertIn("`spherical_coordinates`", found[0][1])
        self.assertIn("`sky`", found[1][1])
        self.assertIn("Buoyancy", found[2][1])

    def test_scene_places_sdf_and_mjcf(self):
        files = {"arm.sdf": '<sdf version="1.9"><model name="arm"><link name="base"/><link name="tip"><pose>0 0 1 0 0 0</pose>'
                            '</link><joint name="j" type="revolute"><parent>base</parent><child>tip</child>'
                            '<axis><xyz>0 1 0</xyz></axis></joint></model></sdf>',
                 "leg.xml": '<mujoco model="leg"><worldbody><body name="hip"><freejoint/><geom size=".1"/></body>'
                            '</worldbody></mujoco>'}
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for path, text in files.items():
                (folder / path).write_text(text, encoding="utf-8")
            (folder / "zoo.smurfs").write_text(
                "entities:\n- {name: arm, type: sdf, file: arm.sdf, position: [0, 0, 1]}\n"
                '- {name: leg, type: mjcf, file: leg.xml, position: [1, 0, 0], anchor: "arm::tip", parent: "arm::tip"}\n'
                "- {name: own, file: arm.sdf, position: [2, 0, 0]}\n", encoding="utf-8")
            done = subprocess.run([FLATTEN, "zoo.smurfs", "--links", "--format", "json"], capture_output=True, text=True,
                                  check=False, cwd=folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            found = {one["name"]: one for one in json.loads(done.stdout)["instances"]}
            self.assertEqual(set(found), {"arm", "leg", "own"})
            self.assert_near(found["leg"]["position"], [1, 0, 2])
            self.assert_near(found["own"]["links"]["tip"]["position"], [2, 0, 1])
            lint = subprocess.run([LINT, "zoo.smurfs", "--format", "concise"], capture_output=True, text=True, check=False,
                                  cwd=folder)
            self.assertEqual(lint.stdout.count("SML5019"), 3, lint.stdout)
            self.assertNotIn("SML5009", lint.stdout)

    def test_settings_that_no_scene_has(self):
        """Each is a loss at its place, unless Gazebo has the same without it."""
        world = '<sdf version="1.9"><world name="w">\n{}\n<model name="m"><link name="a"/></model></world></sdf>'
        usual = ["<magnetic_field>6e-06 2.3e-05 -4.2e-05</magnetic_field>", "<wind/>", '<atmosphere type="adiabatic"/>',
                 "<scene><ambient>0.4 0.4 0.4 1.0</ambient><shadows>true</shadows></scene>",
                 "<physics type='ode'><real_time_factor>1.0</real_time_factor><ode><solver><iters>50</iters></solver></ode></physics>"]
        others = ["<magnetic_field>0 0 1</magnetic_field>", "<wind><linear_velocity>1 0 0</linear_velocity></wind>",
                  "<atmosphere type='adiabatic'><pressure>9e4</pressure></atmosphere>", "<scene><ambient>1 1 1</ambient></scene>",
                  "<physics type='ode'><ode><solver><iters>9</iters></solver></ode></physics>",
                  "<light name='l' type='point'><intensity>3</intensity></light>", "<audio/>"]
        for text in usual + others:
            result = self.run_tool(LINT, world.format(text), "--format", "json", files={})
            found = [one["line"] for one in json.loads(result.stdout)["diagnostics"] if one["id"] == "SML9304"]
            self.assertEqual(found, [2] if text in others else [], text + result.stdout)

    def test_step_of_sdf_is_no_choice(self):
        world = '<sdf version="1.9"><world name="w"><model name="m"><link name="a"/></model></world></sdf>'
        result = self.run_tool(FLATTEN, world, "--format", "sdf", files={})
        self.assertIn("<max_step_size>0.001</max_step_size>", result.stdout)
        self.assertNotIn("step size", result.stderr)
        self.assertNotIn("MARS", result.stderr)

    def test_finding_in_an_included_model_is_one(self):
        result = self.run_tool(LINT, HALL, "--format", "concise")
        lines = [line for line in result.stdout.splitlines() if "SML9315" in line and "cart" in line]
        self.assertEqual(len(lines), len(set(lines)), result.stdout)
        self.assertTrue(any("models/cart/model.sdf" in line for line in lines), result.stdout)

    def test_joints_between_models(self):
        world = '<sdf version="1.10"><world name="w"><model name="a"><link name="l"/></model><model name="b">' \
                '<pose>0 0 2 0 0 0</pose><link name="l"/></model><joint name="j" type="{}"><parent>a::l</parent>' \
                '<child>b::l</child></joint></world></sdf>'
        scene = self.flat(world.format("fixed"), files={})
        self.assertEqual(scene["instances"][1]["anchor"], {"instance": "a", "link": "l"})
        self.assert_near(scene["instances"][1]["position"], [0, 0, 2])
        result = self.run_tool(LINT, world.format("ball"), "--format", "concise", files={})
        self.assertIn("between two entities", result.stdout)

    def test_targets_judge_the_models(self):
        """A world is no scene of SMURF, which no target reads."""
        result = self.run_tool(LINT, HALL, "--target", "gazebo", "--format", "concise")
        self.assertNotIn("SML7100", result.stdout)

    def test_models_have_no_files(self):
        for options in (["--format", "smurfs"], ["--format", "dmd"], ["--format", "sdf", "--form", "reference"]):
            result = self.run_tool(FLATTEN, HALL, *options)
            self.assertNotEqual(result.returncode, 0, options)
            self.assertEqual(result.stdout, "")
            self.assertIn("in no files of their own", result.stderr)

    def test_loss_of_a_setting_is_at_its_place(self):
        result = self.run_tool(FLATTEN, HALL, "--format", "urdf")
        place = re.search(r"environment is not in .*\n *--> (.*)", result.stderr)
        self.assertIsNotNone(place, result.stderr)
        self.assertEqual(place[1], "hall.sdf:5:4")

    def test_refused(self):
        result = self.run_tool(FLATTEN, HALL.replace('relative_to="corner"', 'relative_to="corer"'))
        self.assertNotEqual(result.returncode, 0)
        self.assertIn("`corer`", result.stderr)
        self.assertIn("hall.sdf:", result.stderr)

    def test_include_that_is_not_there(self):
        files = {name: text for name, text in FILES.items() if "cart" not in name}
        result = self.run_tool(FLATTEN, HALL, files=files)
        self.assertNotEqual(result.returncode, 0)
        self.assertIn("SML9312", result.stderr)

    def test_comment_suppresses(self):
        world = '<sdf version="1.9"><world name="w"><model name="m"><link name="a"/>{}</model></world></sdf>'
        for comment, is_found in (("", True), ("<!-- smurf-lint: ignore[SML9315] a test -->", False)):
            result = self.run_tool(LINT, world.format(comment), "--format", "concise", files={})
            self.assertEqual("SML9315" in result.stdout, is_found, result.stdout)

    def as_urdf(self, world):
        """The scene as one robot, with the names that libsdformat gives: MODEL::LINK."""
        flat = subprocess.run([FLATTEN, world, "--force"], capture_output=True, text=True, check=False)
        urdf = subprocess.run([FLATTEN, world, "--force", "--format", "urdf"], capture_output=True, text=True, check=False)
        if flat.returncode or urdf.returncode:
            return None
        names = {re.sub(r"\W", "_", one["name"]): one["name"] for one in json.loads(flat.stdout)["instances"]}

        def full(match):
            for short in sorted(names, key=len, reverse=True):
                if match[2].startswith(short + "__"):
                    return f'{match[1]}="{names[short]}::{match[2][len(short) + 2:]}"'
            return match[0]

        return re.sub(r'(name|link|joint)="([^"]*)"', full, urdf.stdout)

    @unittest.skipUnless(SHARED.is_dir(), "the recorded answers of libsdformat are not here")
    def test_recorded_worlds(self):
        """Poses in four configurations, masses, tensors, axes and limits of all links."""
        sys.path.insert(0, str(SHARED))
        import compare  # noqa: E402
        rows = [line.split("\t") for line in (SHARED / "entries.tsv").read_text(encoding="utf-8").splitlines()[1:]]
        same, others = 0, []
        for name, path in ((row[0], row[2]) for row in rows if row[1] == "sdf"):
            truth = compare.load(str(SHARED / "expected" / (name + ".json.gz")))
            if truth.get("kind") != "world":
                continue
            urdf = self.as_urdf(str(SHARED / "corpus" / path))
            found = compare.differences(urdf, truth) if urdf else ["not converted"]
            same += not found
            others += [(name, path, found[:3])] if found else []
        self.assertGreaterEqual(same, LEAST_EQUAL * (same + len(others)), others)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
