# SPDX-License-Identifier: BSD-3-Clause
"""The command line of smurf-load-check: verdicts, reports, curves, broken input."""
import csv
import io
import json
import math
import pathlib
import resource
import sys
import xml.etree.ElementTree
import zipfile

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import cli  # noqa: E402

LOAD_CHECK = cli.FIXTURES / "load-check"
GOOD = LOAD_CHECK / "SML6301-zero-outside-limits/good/robot.urdf"
NO_ZERO = LOAD_CHECK / "SML6301-zero-outside-limits/bad/robot.urdf"
BAD = LOAD_CHECK / "SML1512-not-positive-definite/bad/robot.urdf"
BALL = """<?xml version="1.0"?>
<robot name="ball">
  <link name="ball">
    <inertial><mass value="1"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>
    <collision><geometry><sphere radius="0.1"/></geometry></collision>
  </link>
</robot>
"""


class LoadCheckTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.write("good.urdf", GOOD.read_bytes())
        self.write("bad.urdf", BAD.read_bytes())
        self.write("no_zero.urdf", NO_ZERO.read_bytes())
        self.write("ball.urdf", BALL)

    def report(self, code, *arguments, **keywords):
        return json.loads(self.expect(code, *arguments, "--format", "json", **keywords).stdout)

    def stages(self, check):
        return {stage["stage"]: stage["verdict"] for stage in check["stages"]}


class Verdicts(LoadCheckTest):
    def test_a_sound_model_passes_all_stages(self):
        [check] = self.report(0, "good.urdf")["checks"]
        self.assertEqual(check["verdict"], "pass")
        self.assertEqual(self.stages(check), dict.fromkeys(
            ["BUILD", "POSE0", "STILL", "HANG", "DROP"], "pass"))

    def test_damping_is_said_to_be_ignored(self):
        joint = ('<joint name="j" type="continuous"><parent link="a"/><child link="b"/><axis xyz="0 1 0"/>'
                 '<dynamics damping="{}" friction="{}"/></joint>')
        links = "".join(f'<link name="{name}"><inertial><origin xyz="0 0 -0.1"/><mass value="1"/><inertia ixx="0.1" ixy="0" ixz="0" '
                        'iyy="0.1" iyz="0" izz="0.1"/></inertial></link>' for name in "ab")
        for damping, friction, is_said in ((0, 0, False), (0.5, 0, True), (0, 0.5, True)):
            self.write("damped.urdf", f'<robot name="r">{links}{joint.format(damping, friction)}</robot>')
            note = self.report(0, "damped.urdf")["checks"][0]["stages"][0]["note"]
            self.assertEqual(note.endswith("; damping and friction of 1 joint ignored, as MARS does"), is_said, note)
        self.write("damped.smurfs", "entities:\n- {name: A, type: urdf, file: damped.urdf, anchor: world}\n")
        self.assertIn("damping and friction of 1 joint ignored", self.expect(0, "damped.smurfs").stdout)

    def test_a_fault_has_its_stage_and_line_and_the_rest_is_checked(self):
        report = self.report(1, "bad.urdf")
        [check] = report["checks"]
        self.assertEqual(self.stages(check), {
            "BUILD": "fail", "POSE0": "pass", "STILL": "pass", "HANG": "pass", "DROP": "pass"})
        self.assertIn("1 stand-in", check["stages"][0]["note"])
        [found] = report["diagnostics"]
        self.assertEqual(found["id"], "SML1512")
        self.assertIn("<inertia", self.read("bad.urdf").splitlines()[found["line"] - 1])
        self.assertTrue(any("ODE refuses" in note for note in found["notes"]), found)

    def test_a_negative_mass_has_no_place_to_hide(self):
        """As a root, which would be a fixed base without mass, and beside a heavier link."""
        ball = BALL[BALL.index("<link"):BALL.index("</robot>")]
        joint = ('<joint name="j" type="{}"><parent link="a"/><child link="b"/><origin xyz="0 0 1"/>'
                 '<axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>')
        for masses in ((-1, 1), (-1, 5), (5, -1), (1, -1), (-1, -1)):
            for kind in ("revolute", "fixed"):
                links = "".join(ball.replace('"ball"', f'"{name}"').replace('mass value="1"', f'mass value="{mass}"')
                                for name, mass in zip("ab", masses))
                self.write("robot.urdf", f'<robot name="r">{links}{joint.format(kind)}</robot>')
                report = self.report(1, "robot.urdf")
                found = [d["id"] for d in report["diagnostics"]]
                self.assertEqual(found, ["SML1509"] * sum(mass < 0 for mass in masses), f"{masses} {kind}")
                self.assertEqual(self.stages(report["checks"][0])["BUILD"], "fail")

    def test_one_bad_link_does_not_hide_an_overlap_elsewhere(self):
        ball = BALL[BALL.index("<link"):BALL.index("</robot>")]
        joint = ('<joint name="{0}" type="revolute"><parent link="{1}"/><child link="{0}"/>'
                 '<origin xyz="0 0 {2}"/><axis xyz="0 1 0"/>'
                 '<limit lower="-1" upper="1" effort="1" velocity="1"/></joint>')
        self.write("robot.urdf", '<robot name="r">' + "".join(
            ball.replace('"ball"', f'"{name}"') for name in ["base", "near", "far"])
            + '<link name="light"/>' + joint.format("near", "base", 0.25)
            + joint.format("far", "near", -0.2) + joint.format("light", "far", 0.5) + "</robot>")
        report = self.report(1, "robot.urdf")
        self.assertEqual([d["id"] for d in report["diagnostics"]], ["SML6201", "SML1501"])
        self.assertNotIn("skipped", self.stages(report["checks"][0]).values())

    def test_a_joint_that_cannot_be_at_zero_starts_at_its_limit(self):
        report = self.report(0, "no_zero.urdf")
        [check] = report["checks"]
        self.assertEqual(self.stages(check), {
            "BUILD": "pass", "POSE0": "pass", "STILL": "warn", "HANG": "pass", "DROP": "pass"})
        [found] = report["diagnostics"]
        self.assertEqual((found["id"], found["severity"]), ("SML6301", "warning"))
        self.assertIn('upper="-0.2"', self.read("no_zero.urdf").splitlines()[found["line"] - 1])
        self.assertTrue(found["pointer"].startswith("/robot/joint[@name='shoulder']"))
        [still] = [stage for stage in check["stages"] if stage["stage"] == "STILL"]
        self.assertLess(still["figures"][0]["value"], 1e-9)

    def test_a_joint_that_mimics_leads_its_leader_to_a_position_that_both_may_have(self):
        text = self.read("good.urdf").replace(
            '<limit lower="-1" upper="1"', '<mimic joint="shoulder" multiplier="-1" offset="0.1"/>'
            '<limit lower="0.3" upper="1"')
        self.write("both.urdf", text)
        report = self.report(0, "both.urdf", "--stages", "still", "--trace", "t.csv")
        [found] = report["diagnostics"]
        self.assertEqual(found["id"], "SML6301")
        self.assertIn("mimics", found["message"])
        self.assertIn("0.3", found["notes"][0])

    def test_what_moves_names_the_joint_outside_its_limits(self):
        # The shoulder may be at 0.05 at most, so the wrist cannot be at 0.5 or more.
        text = self.read("good.urdf").replace('upper="0"', 'upper="0.05"').replace(
            '<limit lower="-1" upper="1"', '<mimic joint="shoulder"/><limit lower="1.5" upper="2"')
        self.write("torn.urdf", text)
        report = self.report(1, "torn.urdf", "--bounds", "hang-energy=1e-9")
        [check] = report["checks"]
        self.assertEqual(self.stages(check)["STILL"], "warn")
        self.assertEqual(self.stages(check)["HANG"], "fail")
        hang = [d for d in report["diagnostics"] if d["id"].startswith("SML64")]
        self.assertEqual(len(hang), 1, report["diagnostics"])
        self.assertIn("joint `wrist` starts 1.5 rad outside its limits, which is the likely cause",
                      hang[0]["notes"])

    def test_poses(self):
        poses = """poses:
- name: raised
  joints: {shoulder: -0.5, wrist: 0.25}
- name: torn
  joints: {shoulder: 0.5}
"""
        self.write("robot.smurf", "modelname: r\nfiles: [no_zero.urdf, poses.yml]\n")
        self.write("poses.yml", poses)
        report = self.report(0, "robot.smurf", "--pose", "raised", "--trace", "t.csv")
        self.assertEqual(report["diagnostics"], [])
        first = next(row for row in csv.DictReader(io.StringIO(self.read("t.csv")))
                     if row["stage"] == "HANG" and row["link"] == "hand")
        # The boom of 0.5 m is at (0.1, 0) and turned by -0.5 rad about y.
        self.assertAlmostEqual(float(first["z"]), 0.5 * math.sin(0.5), places=9)
        [found] = [d for d in self.report(0, "robot.smurf", "--pose", "torn", "--stages", "still")
                   ["diagnostics"]]
        self.assertEqual((found["id"], found["severity"]), ("SML6301", "warning"))
        self.assertIn("pose `torn`", found["message"])
        self.expect_complaint("'robot.smurf' has no pose 'rised'; did you mean 'raised'?",
                              "robot.smurf", "--pose", "rised")

    def test_the_shipped_models_pass(self):
        for path in ["models/arm/smurf/arm.smurf", "models/arm_phobos2/smurf/arm.smurf"]:
            [check] = self.report(0, cli.FIXTURES / path)["checks"]
            self.assertEqual(check["verdict"], "pass", check)

    def test_errors_in_the_file_are_reported_and_nothing_is_run(self):
        self.write("broken.urdf", BALL.replace('radius="0.1"', 'radius="wide"'))
        report = self.report(1, "broken.urdf")
        self.assertEqual(report["checks"][0]["stages"], [])
        self.assertEqual([d["id"] for d in report["diagnostics"]], ["SML1801"])

    def test_fail_on(self):
        heavy = LOAD_CHECK / "SML1525-mass-ratio/bad/robot.urdf"
        self.expect(0, heavy)
        self.expect(1, heavy, "--fail-on", "warning")
        self.expect(0, "bad.urdf", "--fail-on", "never")


class Xacro(LoadCheckTest):
    def test_a_robot_of_xacro(self):
        robot = GOOD.read_text().replace("<robot", '<robot xmlns:xacro="x"', 1)
        self.write("good.urdf.xacro", robot.replace("</robot>", '<xacro:if value="$(arg bad)"><link name="free"/></xacro:if></robot>'))
        [check] = self.report(0, "good.urdf.xacro", "bad:=false")["checks"]
        self.assertEqual(check["verdict"], "pass")
        self.assertEqual([one["id"] for one in self.report(1, "good.urdf.xacro", "bad:=true")["diagnostics"]], ["SML1204"])
        self.assertIn("SML3313", self.expect(1, "good.urdf.xacro").stdout)


class Scenes(LoadCheckTest):
    def test_two_robots_a_plane_and_what_stands_in_it(self):
        self.write("scene.smurfs", """entities:
- {name: A, file: good.urdf, anchor: world, position: [0, 0, 1]}
- {name: B, file: good.urdf, parent: "A::hand", anchor: parent, position: [0.3, 0, 0]}
- name: Floor
  type: primitive
  geometry: {type: plane}
  position: {x: 0, y: 0, z: 0}
  rotation: {w: 1, x: 0, y: 0, z: 0}
""")
        report = self.report(0, "scene.smurfs")
        scene = report["checks"][-1]
        self.assertEqual([c["kind"] for c in report["checks"]], ["model", "scene"])
        [figure] = scene["stages"][-1]["figures"]
        self.assertEqual(figure["name"], "anchor")
        self.assertLess(figure["value"], 1e-6)

    def test_an_entity_inside_another_one(self):
        self.write("scene.smurfs", """entities:
- {name: A, file: ball.urdf, position: [0, 0, 1]}
- {name: B, file: ball.urdf, position: [0, 0.15, 1]}
""")
        report = self.report(0, "scene.smurfs")
        [found] = report["diagnostics"]
        self.assertEqual((found["id"], found["file"], found["line"]),
                         ("SML6201", "scene.smurfs", 2))
        self.assertIn("50 mm", found["message"])

    def test_a_base_without_mass_falls_unless_it_is_anchored(self):
        table = '<robot name="table"><link name="top"/></robot>'
        self.write("table.urdf", table)
        arm = table.replace("/></robot>", '/><link name="arm"><inertial><mass value="1"/><inertia ixx="0.1" '
                            'iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial></link><joint name="j" '
                            'type="continuous"><parent link="top"/><child link="arm"/></joint></robot>')
        self.write("arm.urdf", arm)
        for file in ["table.urdf", "arm.urdf"]:
            entities = "".join(f"- {{name: {name}, file: {file}}}\n" for name in "AB")
            self.write("scene.smurfs", "entities:\n" + entities)
            report = self.report(1, "scene.smurfs", "--stages", "build")
            self.assertEqual([check["verdict"] for check in report["checks"]], ["pass", "fail"])
            [found] = report["diagnostics"]  # one for the model, not one per entity
            self.assertEqual((found["id"], found["file"]), ("SML1501", file))
            self.assertIn("anchor: world", found["help"])
            self.write("scene.smurfs", "entities:\n" + entities.replace("}", ", anchor: world}"))
            self.report(0, "scene.smurfs", "--stages", "build")

    def test_two_robots_a_plane_and_a_heightfield(self):
        for name in ["showcase", "terrain"]:
            report = self.report(0, cli.FIXTURES / f"scenes/{name}/{name}.smurfs")
            scene = report["checks"][-1]
            self.assertEqual(self.stages(scene)["ANCHOR"], "pass")
            self.assertNotIn("left out", scene["stages"][0]["note"])
            [figure] = scene["stages"][-1]["figures"]
            self.assertLessEqual(figure["value"], 1e-6)
            print(f"{name}: anchors move by {figure['value']:.2g} m")

    def test_the_terrain_carries_the_cart(self):
        scene = cli.FIXTURES / "scenes/terrain/terrain.smurfs"
        self.expect(0, scene, "--stages", "anchor", "--trace", "trace.csv")
        rows = [row for row in csv.DictReader(io.StringIO(self.read("trace.csv")))
                if row["stage"] == "ANCHOR" and row["link"].endswith("chassis")]
        self.assertEqual(len(rows), 501)
        heights = [float(row["z"]) for row in rows]
        # On the terrace of 0.3 m; if the rows of the image were swapped, it would be at 0.1 m.
        self.assertAlmostEqual(heights[-1], 0.38, delta=2e-3)
        self.assertNotEqual(heights[0], heights[-1])

    def heights(self, image):
        self.write("heights.png", image)
        self.write("scene.smurfs", """entities:
- {name: A, file: ball.urdf, position: [0, 0, 1]}
- {name: Hill, type: heightmap, file: heights.png, width: 1, length: 1, height: 0.1}
""")

    def test_heights_that_cannot_be_read(self):
        image = (cli.FIXTURES / "scenes/terrain/heightmaps/terraces.png").read_bytes()
        for broken in [b"no image", image[:70]]:
            self.heights(broken)
            report = self.report(1, "scene.smurfs")
            [found] = report["diagnostics"]
            self.assertEqual((found["id"], found["file"], found["line"]),
                             ("SML6107", "scene.smurfs", 3))
            self.assertEqual(self.stages(report["checks"][-1])["BUILD"], "fail")

    def test_meshes_of_packages_are_found_through_the_environment(self):
        mesh = (cli.FIXTURES / "models/arm/meshes/forearm_hull.stl").read_bytes()
        self.write("ws/stuff/meshes/hull.stl", mesh)
        self.write("ball.urdf", BALL.replace(
            '<sphere radius="0.1"/>', '<mesh filename="package://stuff/meshes/hull.stl"/>'))
        for variables, note in [({"ROS_PACKAGE_PATH": str(self.folder / "ws")}, "1 mesh as box"),
                                ({}, "1 mesh missing")]:
            done = self.expect(0, "ball.urdf", "--format", "json", environment=variables)
            self.assertIn(note, json.loads(done.stdout)["checks"][0]["stages"][0]["note"])
        # Without a shape, nothing was seen that could collide.
        self.assertEqual(json.loads(done.stdout)["checks"][0]["verdict"], "warn")
        self.assertIn("1 mesh missing, so nothing can collide", self.expect(0, "ball.urdf").stdout)


class Engine(LoadCheckTest):
    """If ODE reports problems, the stage does not pass."""

    def gripper(self):
        """An arm with two fingers that start closed, exactly at a stop."""
        finger = """<link name="{0}"><inertial><mass value="0.1"/><inertia ixx="1e-5" ixy="0" ixz="0"
iyy="1e-5" iyz="0" izz="1e-5"/></inertial></link><joint name="{0}" type="prismatic"><parent link="hand"/>
<child link="{0}"/><axis xyz="0 {1} 0"/><limit lower="0" upper="0.04" effort="1" velocity="1"/></joint>"""
        return self.read("no_zero.urdf").replace(
            "</robot>", finger.format("left", 1) + finger.format("right", -1) + "</robot>")

    def test_a_stage_in_which_the_solver_gives_up_is_tried_inside_the_stops(self):
        self.write("gripper.urdf", self.gripper())
        [check] = self.report(0, "gripper.urdf")["checks"]
        self.assertEqual(check["verdict"], "warn")
        print({stage["stage"]: stage.get("note") for stage in check["stages"]})


class Hostile(LoadCheckTest):
    def mesh(self, name, content):
        self.write(name, content)
        self.write("mesh.urdf", BALL.replace('<sphere radius="0.1"/>', f'<mesh filename="{name}"/>'))

    def test_only_formats_of_urdf_are_read(self):
        for name, content in {
                "m.smd": "version 1\nnodes\n0 \"a\" -1\nend\nskeleton\ntime 0\n0 0 0 0 0 0 0\nend\n",
                "m.off": "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
                "m.nff": "v\nf 0 0 0\np 3\n0 0 0\n1 0 0\n0 1 0\n",
                "m.dae": "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"}.items():
            self.mesh(name, content)
            report = self.report(1, "mesh.urdf", "--stages", "build")
            [found] = report["diagnostics"]
            self.assertEqual(found["id"], "SML6107", found)
            self.assertRegex(self.expect(1, "mesh.urdf", "--stages", "build").stdout,
                             "it is (of an unknown format|broken: a vertex has fewer)")

    def test_meshes_outside_of_the_project_are_a_warning_that_names_the_way_out(self):
        self.write("elsewhere/hull.stl",
                   (cli.FIXTURES / "models/arm/meshes/forearm_hull.stl").read_bytes())
        self.write("a/b/c/.git/HEAD", "")
        two = BALL.replace("</link>", "<collision><geometry><MESH/></geometry></collision>" * 2 + "</link>")
        self.write("a/b/c/ball.urdf", two.replace("<MESH/>", '<mesh filename="../../../elsewhere/hull.stl"/>'))
        report = self.report(0, "ball.urdf", cwd=self.folder / "a/b/c")
        [found] = report["diagnostics"]
        self.assertEqual((found["id"], found["severity"], found["message"]),
                         ("SML6107", "warning", "2 meshes were not looked at"))
        self.assertIn("--allow-outside", found["notes"][0])

    def test_more_shapes_than_can_be_paired_are_left_out(self):
        sphere = '<collision><geometry><sphere radius="1"/></geometry></collision>'
        self.write("spheres.urdf", BALL.replace("</link>", sphere * 1500 + "</link>"))
        report = self.report(1, "spheres.urdf", "--stages", "pose0")
        [found] = report["diagnostics"]
        self.assertEqual(found["id"], "SML6002")
        self.assertIn("1000", found["message"])
        self.assertEqual(report["checks"][0]["verdict"], "none")

    def test_heightmaps_share_their_pixels(self):
        image = (cli.FIXTURES / "scenes/terrain/heightmaps/terraces.png").read_bytes()
        self.write("heights.png", image)
        self.write("scene.smurfs", "entities:\n- {name: A, file: ball.urdf, position: [0, 0, 1]}\n" + "".join(
            f"- {{name: h{i}, type: heightmap, file: heights.png, width: 1, length: 1, height: 0.1, "
            f"position: [{2 * i}, 5, 0]}}\n" for i in range(3)))
        report = self.report(1, "scene.smurfs", "--limit", f"image-pixels={2 * 33 * 33}", "--stages", "pose0")
        [found] = report["diagnostics"]
        self.assertEqual((found["id"], found["line"]), ("SML6107", 5))
        self.assertIn("more than are left of 2178", self.expect(
            1, "scene.smurfs", "--limit", f"image-pixels={2 * 33 * 33}", "--stages", "pose0").stdout)


class Options(LoadCheckTest):
    def test_stages(self):
        [check] = self.report(0, "good.urdf", "--stages", "hang")["checks"]
        self.assertEqual(list(self.stages(check)), ["BUILD", "HANG"])
        self.expect_complaint("--stages: 'hank' is not one of build, pose0, still, hang, drop, anchor; "
                              "did you mean 'hang'?", "good.urdf", "--stages", "hank")

    def test_bounds(self):
        [check] = self.report(1, "good.urdf", "--bounds", "gap=0,drop-energy=1")["checks"]
        self.assertEqual(self.stages(check)["HANG"], "fail")
        self.expect_complaint("--bounds: 'gab' is not one of axis, mass-ratio, overlap, motion, gap, "
                              "twist, hang-energy, drop-energy, anchor; did you mean 'gap'?",
                              "good.urdf", "--bounds", "gab=1")
        self.expect_complaint("--bounds: '-1' is not a number of at least 0", "good.urdf",
                              "--bounds", "gap=-1")

    def test_tighter_bounds_show_what_rounding_does(self):
        arm = cli.FIXTURES / "models/arm/smurf/arm.smurf"
        lively = (LOAD_CHECK / "SML6401-joint-comes-apart/bad/robot.urdf").read_text()
        for old, new in [("0.09", "0.0306"), ('"0.001"', '"0.245"'), ("2e-07", "5.82e-07"),
                         ("7.6e-08", "2.53e-08"), ("0.0156 0.0078", "0.0812 0.0406")]:
            self.assertIn(old, lively)
            lively = lively.replace(old, new)
        self.write("lively.urdf", lively)
        for rule, path, bounds in [("SML6302", arm, "motion=0"),
                                   ("SML6402", "lively.urdf", "gap=1,twist=1,hang-energy=1e-6")]:
            found = self.report(1, path, "--bounds", bounds)["diagnostics"]
            self.assertEqual([d["id"] for d in found], [rule])

    def test_trace(self):
        self.expect(0, "ball.urdf", "--stages", "drop", "--trace", "trace.csv", "--time", "0.1")
        rows = list(csv.DictReader(io.StringIO(self.read("trace.csv"))))
        self.assertEqual(len(rows), 101)
        self.assertEqual((rows[0]["stage"], rows[0]["link"], rows[0]["z"]), ("DROP", "ball", "0"))
        self.assertLess(abs(float(rows[-1]["z"]) + 0.001), 0.01)

    def test_a_trace_has_a_limit(self):
        """A URDF of 60 kB caused a trace of some 100 MB, and needed four times as much memory."""
        links = "".join(f'<link name="l{i}"/><joint name="j{i}" type="fixed"><parent link="ball"/><child link="l{i}"/>'
                        "</joint>" for i in range(500))
        self.write("many.urdf", self.read("ball.urdf").replace("</robot>", links + "</robot>"))
        done = self.run_tool("many.urdf", "--stages", "drop", "--trace", "trace.csv", "--time", "2")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("the trace ends after 64000000 bytes, in 'many.urdf'; ask for less with --stages or --time",
                      done.stderr)
        self.assertIn("many.urdf: pass", done.stdout)
        rows = self.read("trace.csv").splitlines()
        self.assertLess(sum(map(len, rows)), 64_000_100)
        self.assertEqual((len(rows) - 1) % 501, 0)
        self.assertEqual(rows[-1].count(","), 10)
        if not cli.is_sanitized(cli.TOOL):
            self.assertLess(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss, 300 * 1024)

    def test_the_traces_of_a_run_have_a_limit(self):
        """Ten URDFs of 60 kB caused traces of 450 MB, and needed 1.4 GB of memory."""
        for i in range(10):
            self.write(f"{i}.urdf", self.read("ball.urdf").replace('"ball"', '"' + "n" * 60_000 + '"'))
        models = [f"{i}.urdf" for i in range(10)]
        runs = [self.run_tool(*models, "--stages", "drop", "--time", "0.75", "--trace", f"{jobs}.csv", "--jobs", str(jobs))
                for jobs in (1, 3)]
        for done in runs:
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertEqual(done.stderr.count("the trace ends after 64000000 bytes, in '1.urdf'"), 1, done.stderr)
            self.assertEqual(done.stderr.count("trace"), 1, done.stderr)
        self.assertEqual(self.read("1.csv"), self.read("3.csv"))
        rows = self.read("1.csv").splitlines()
        size = len(self.read("1.csv"))
        self.assertLessEqual(size, 64_000_000)
        self.assertGreater(size, 64_000_000 - 2 * len(rows[-1]))
        self.assertEqual([sum(row.startswith(f"{i}.urdf,") for row in rows) for i in range(3)],
                         [751, len(rows) - 752, 0])
        if not cli.is_sanitized(cli.TOOL):
            self.assertLess(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss, 300 * 1024)

    def test_what_ode_gives_up_on_is_a_finding(self):
        self.write("huge.urdf", self.read("good.urdf").replace('"0.001"', '"1e300"'))
        report = self.report(1, "huge.urdf")
        [found] = report["diagnostics"]
        self.assertEqual(self.stages(report["checks"][0]),
                         {"BUILD": "pass", "POSE0": "pass", "STILL": "fail"})
        self.assertEqual((found["id"], found["line"]), ("SML6001", 2))
        self.assertIn("stage STILL", found["message"])

    def test_a_check_that_takes_too_long_is_ended(self):
        report = self.report(1, "good.urdf", "--time", "3600", "--step", "1e-6", "--time-limit", "1")
        [found] = report["diagnostics"]
        self.assertEqual((found["id"], found["line"]), ("SML6002", 2))

    def test_a_joint_without_its_second_axis(self):
        self.write("robot.smurf", "modelname: r\nfiles: [good.urdf, joint.yml]\n")
        self.write("joint.yml", "joint:\n- name: shoulder\n  type: universal\n")
        [found] = self.report(1, "robot.smurf", "--stages", "build")["diagnostics"]
        self.assertEqual((found["id"], found["file"], found["line"]), ("SML6105", "joint.yml", 3))

    def test_reports_obey_the_schema(self):
        try:
            import jsonschema
        except ImportError:
            self.skipTest("python3-jsonschema is not installed")
        schema = json.loads((cli.ROOT / "schemas/load-report.schema.json").read_text())
        self.write("scene.smurfs", "entities:\n- {name: A, file: bad.urdf, anchor: world}\n")
        self.write("broken.urdf", BALL.replace('radius="0.1"', 'radius="wide"'))
        report = self.report(1, ".")
        self.assertEqual({c["verdict"] for c in report["checks"]}, {"pass", "warn", "fail"})
        jsonschema.validate(report, schema)

    def test_other_formats_are_those_of_report(self):
        self.expect_complaint("--format: 'sarif' is not one of full, json; --report sarif writes the findings in this format",
                              "--format", "sarif", "good.urdf")

    def test_tables_fit_a_terminal(self):
        for line in self.expect(1, ".").stdout.splitlines():
            if "|" not in line and not line.startswith("   = "):  # lines of files, and texts below them, may be long
                self.assertLessEqual(len(line), 80, line)

    def test_a_chain_that_takes_all_memory_is_no_calm_robot(self):
        ball = BALL[BALL.index("<link"):BALL.index("    <collision>")] + "</link>"
        parts = [ball.replace('"ball"', f'"l{i}"') for i in range(3000)]
        parts += [f'<joint name="j{i}" type="continuous"><parent link="l{i}"/><child link="l{i + 1}"/>'
                  f'<origin xyz="0.3 0 0"/><axis xyz="0 1 0"/></joint>' for i in range(2999)]
        self.write("chain.urdf", '<robot name="chain">' + "".join(parts) + "</robot>")
        [found] = self.report(1, "chain.urdf")["diagnostics"]
        self.assertEqual((found["id"], found["line"]), ("SML6002", 1))

    def test_the_same_bytes_every_time(self):
        for form in ["full", "json"]:
            first = self.expect(1, ".", "--format", form).stdout
            for jobs in "14":
                self.assertEqual(self.expect(1, ".", "--format", form, "-j", jobs).stdout, first)

    def test_several_models_are_counted(self):
        self.write("broken.urdf", BALL.replace('radius="0.1"', 'radius="wide"'))
        last = self.expect(1, ".").stdout.splitlines()[-1]
        self.assertEqual(last, "5 models: 2 passed, 1 with warnings, 2 failed")
        self.assertEqual(self.report(1, ".")["verdicts"], {"pass": 2, "warn": 1, "fail": 2, "none": 0})
        self.assertNotIn("passed", self.expect(0, "good.urdf").stdout)
        done = self.expect(1, "good.urdf", "ball.urdf", "--time", "3600", "--step", "1e-5",
                           "--time-limit", "1")
        self.assertEqual(done.stdout.splitlines()[-1], "2 models: 0 passed, 2 without verdict")
        self.assertIn("good.urdf: no verdict\n", done.stdout)

    def test_output(self):
        self.expect(0, "good.urdf", "-o", "report.txt")
        self.assertIn("good.urdf: pass; 3 moving bodies, 2 joints, 3 shapes\n", self.read("report.txt"))
        self.assertRegex(self.expect(0, "good.urdf", "--all").stdout, r"^good.urdf: pass\n  BUILD   pass(.*\n)+  DROP    pass ")
        self.assertEqual(self.expect(0, "good.urdf", "-q").stdout, "")

    def test_reports_for_other_programs(self):
        self.leave_repository()
        self.expect(1, "bad.urdf", "--report", "sarif=found.sarif", "--report", "github=found.txt")
        [result] = json.loads(self.read("found.sarif"))["runs"][0]["results"]
        self.assertEqual(result["ruleId"], "SML1512")
        self.assertIn("::error file=bad.urdf", self.read("found.txt"))

    def test_a_small_stack(self):
        if cli.is_sanitized(cli.TOOL):
            return
        small = (64 << 10, resource.getrlimit(resource.RLIMIT_STACK)[1])
        self.expect(0, "good.urdf", preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_STACK, small))

    def test_nothing_to_check(self):
        self.expect_complaint("cannot read 'none.urdf': No such file or directory", "none.urdf")

    def test_a_model_without_a_urdf_gets_no_verdict(self):
        for files, rule in {"files: []": "SML2003", "files: {}": "SML4001", "flies: [a.urdf]": "SML4004"}.items():
            self.write("a.smurf", f"modelname: a\n{files}\n")
            report = self.report(1, "a.smurf")
            self.assertEqual(report["checks"][0]["stages"], [])
            self.assertEqual([d["id"] for d in report["diagnostics"]], [rule])

    def test_what_lies_in_archives(self):
        def packed(**files):
            target = io.BytesIO()
            with zipfile.ZipFile(target, "w") as zipped:
                for name, text in files.items():
                    zipped.writestr(name.replace("_", "."), text)
            return target.getvalue()
        ball = {"ball_urdf": BALL, "ball_smurf": "modelname: ball\nfiles: [ball.urdf]\n"}
        self.write("ball.zsmurf", packed(**ball))
        self.write("scene.smurfs", "entities:\n- {name: a, type: zsmurf, file: ball.zsmurf, position: [0, 0, 1]}\n")
        self.write("all.zsmurfs", packed(**ball, all_smurfs="entities:\n- {name: a, type: smurf, file: ball.smurf}\n"))
        for path, model in {"scene.smurfs": "ball.zsmurf/ball.smurf", "all.zsmurfs": "all.zsmurfs/ball.smurf"}.items():
            report = self.report(0, path)
            self.assertIn(model, [check["file"] for check in report["checks"]])
            self.assertEqual({check["verdict"] for check in report["checks"]}, {"pass"})
        self.write("empty.zsmurfs", packed(x_smurf=""))
        self.expect_complaint("cannot read 'empty.zsmurfs': it contains no .smurfs", "empty.zsmurfs")


if __name__ == "__main__":
    cli.main()
