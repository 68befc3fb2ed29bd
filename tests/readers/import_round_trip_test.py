# SPDX-License-Identifier: BSD-3-Clause
"""SDF -> SMURF -> SDF and MJCF -> SMURF -> MJCF: a robot that was taken in and written again is the same robot. It is
read again and compared with what libsdformat and MuJoCo made of the first file, where their answers were recorded
(../shared/imports): poses, masses, tensors, axes, limits; and the annotations that SMURF has are counted.

import_round_trip_test.py FOLDER_OF_PROGRAMS [-v]    -v prints each difference
"""
import collections
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ET

import rebuilt_mjcf

SHARED = pathlib.Path(__file__).resolve().parents[2].parent / "shared/imports"
BIN = pathlib.Path(sys.argv[1]).absolute()
MOVED = pathlib.Path(__file__).resolve().parent / "moved_mjcf.py"
PYTHON = pathlib.Path(__file__).resolve().parents[2] / "build/readers/python/bin/python"
VERBOSE = "-v" in sys.argv
LEAST_BUILT = 0.97
LEAST_MOVED = 0.55
MOST_WAY = 1e-4  # m; a reference of joints beside zero changes how softly MuJoCo holds their limits
LEAST_EQUAL = {"sdf": 1, "mjcf": 0.98}
# What differs is said: a part of the message, by the kind of the difference.
SAID = {"mass": "so the mass of its bodies is unknown"}
# What explains another motion, in the findings on the MJCF; contacts are off.
OTHER_MOTION = re.compile(
    r"no tendons|so (it|this one|this) is lost|settings of MuJoCo for joints|without giving way|force against gravity|"
    r"a program moves|floats has no joint|spring of a joint with several axes|the mass of its bodies is unknown|"
    r"and the coupling, are lost|closes a loop|acts on the free joint")

ROBOT = """<mujoco model="bot"><worldbody>
  <body name="base" pos="0 0 1"><joint name="a" axis="0 0 1" range="-90 90" armature=".02"/>
    <geom type="box" size=".1 .1 .1" contype="2" conaffinity="2"/><site name="imu" pos=".1 0 0" euler="0 0 90"/>
    <body name="arm" pos="0 0 .2"><joint name="b" axis="0 1 0"/><geom type="capsule" size=".03" fromto="0 0 0 .3 0 0"/>
      <site name="tip" pos=".3 0 0"/><camera name="eye" pos=".1 0 0" fovy="60" resolution="320 240"/>
      <body name="hand" pos=".3 0 0"><joint name="c" axis="0 1 0" armature=".03" damping=".1"/>
      <geom size=".05"/></body></body>
    <body name="rod" pos="0 0 -.2"><joint name="d" axis="0 1 0" stiffness="3" springref="20"/>
      <geom type="capsule" size=".02" fromto="0 0 0 .3 0 0"/></body>
  </body></worldbody>
  <contact><exclude body1="base" body2="hand"/></contact>
  <equality><connect name="tie" body1="rod" body2="hand" anchor=".3 0 0"/></equality>
  <actuator><position name="m" joint="a" kp="20" kv="1" ctrlrange="-1 1" forcerange="-5 5"/></actuator>
  <sensor><accelerometer name="acc" site="imu"/><gyro name="gyr" site="imu"/><force name="f" site="tip"/>
    <rangefinder name="ray" site="tip" cutoff="3"/><jointpos name="jp" joint="b"/></sensor>
  <keyframe><key name="home" qpos=".1 .2 .3 .4"/></keyframe></mujoco>
"""
SEVERAL = """<mujoco model="bot"><worldbody><body name="torso"><joint name="x" type="slide" axis="1 0 0"/>
  <joint name="turn" axis="0 1 0" pos="0 0 .5"/><geom size=".1"/>
  <body name="leg" pos="0 0 -.3"><joint name="knee" axis="0 1 0"/>
    <body name="shell" pos="0 0 -.1"><geom size=".05"/></body></body></body></worldbody></mujoco>
"""
LOOP = """<sdf version="1.9"><model name="linkage"><link name="base"/>
  <link name="left"><pose>0 0 1 0 0 0</pose></link><link name="right"><pose>1 0 1 0 0 0</pose></link>
  <joint name="a" type="revolute"><parent>base</parent><child>left</child><axis><xyz>0 1 0</xyz></axis></joint>
  <joint name="b" type="revolute"><parent>base</parent><child>right</child><axis><xyz>0 1 0</xyz></axis></joint>
  <joint name="c" type="revolute"><pose relative_to="right">0 0 1 0 0 0</pose><parent>left</parent><child>right</child>
    <axis><xyz>0 1 0</xyz></axis></joint></model></sdf>
"""
NESTED = """<sdf version="1.9"><model name="outer"><link name="base"/>
  <model name="arm"><pose>0 0 1 0 0 0.5</pose><link name="upper"/><link name="fore"><pose>1 0 0 0 0 0</pose></link>
    <joint name="elbow" type="revolute"><parent>upper</parent><child>fore</child><axis><xyz>0 1 0</xyz></axis></joint>
    <model name="hand"><link name="palm"><pose>2 0 0 0 0 0</pose></link></model></model>
  <joint name="shoulder" type="revolute"><parent>base</parent><child>arm::upper</child><axis><xyz>0 0 1</xyz></axis></joint>
  <joint name="wrist" type="revolute"><parent>arm::fore</parent><child>arm::hand::palm</child><axis><xyz>0 0 1</xyz></axis>
  </joint></model></sdf>
"""
SURFACE = """<sdf version="1.9"><model name="box"><link name="one">
  <collision name="a"><geometry><sphere><radius>1</radius></sphere></geometry>{0}</collision>
  <collision name="b"><geometry><sphere><radius>2</radius></sphere></geometry>{1}</collision>
  <visual name="v"><cast_shadows>false</cast_shadows><geometry><sphere><radius>1</radius></sphere></geometry></visual></link>
  </model></sdf>
"""
RUBBER = ("<surface><friction><ode><mu>0.25</mu><mu2>0.5</mu2></ode></friction><contact><collide_bitmask>6</collide_bitmask>"
          "</contact></surface><laser_retro>3</laser_retro>")
JOINTS = """<sdf version="1.9"><model name="zoo"><link name="base"/><link name="arm"><pose>0.5 0 0 0 0 0</pose></link>
  <link name="fork"><pose>1 0 0 0 0 0</pose></link><link name="ball"><pose>1.5 0 0 0 0 0</pose></link>
  <link name="nut"><pose>2 0 0 0 0 0</pose></link>
  <joint name="hold" type="revolute"><parent>world</parent><child>base</child><axis><xyz>0 0 1</xyz></axis></joint>
  <joint name="a" type="revolute"><pose>-0.5 0 0 0 0 0</pose><parent>base</parent><child>arm</child>
    <axis><xyz>0 1 0</xyz></axis></joint>
  <joint name="u" type="universal"><parent>arm</parent><child>fork</child><axis><xyz>1 0 0</xyz></axis>
    <axis2><xyz>0 1 0</xyz><limit><lower>-1</lower><upper>1</upper></limit></axis2></joint>
  <joint name="b" type="ball"><parent>fork</parent><child>ball</child></joint>
  <joint name="s" type="screw"><parent>ball</parent><child>nut</child><axis><xyz>1 0 0</xyz></axis>
    <thread_pitch>50</thread_pitch></joint></model></sdf>
"""


def run(program, *arguments):
    return subprocess.run([BIN / program, *map(str, arguments)], capture_output=True, text=True, check=False, timeout=120)


def through_smurf(path, folder, kind):
    """The file after it was a SMURF model, and what was said; none, with the reason, if one step refuses."""
    model, out = folder / "model", folder / ("again." + kind)
    done = first = run("urdf2smurf", path, "-o", model, "--force")
    mains = sorted(model.rglob("*.smurf"))
    if done.returncode or not mains:
        return None, "urdf2smurf: " + done.stderr.strip()[-200:]
    done = run("smurfs-flatten", mains[0], "--format", kind, "-o", out, "--force")
    if done.returncode or not out.exists():
        return None, "smurfs-flatten: " + done.stderr.strip()[-200:]
    if kind == "sdf":  # the model alone, as it was
        models = re.findall(r"^    <model.*?^    </model>\n", out.read_text(encoding="utf-8"), re.S | re.M)
        out.write_text('<sdf version="1.9">\n' + "".join(models[:1]) + "</sdf>\n", encoding="utf-8")
    return out, first.stderr + done.stderr


def as_urdf(path, folder):
    """What is read again; the names without that of the entity, which MJCF puts before them."""
    out = folder / "again.urdf"
    done = run("smurf2urdf", path, "-o", out, "--force")
    if not out.exists():
        return None, done.stderr.strip()[-200:]
    text = out.read_text(encoding="utf-8")
    entity = re.search(r'<link name="([^"/]*)/', text) if path.suffix == ".mjcf" else None
    # The world that the robot had stands in the new one.
    return re.sub(f'="{re.escape(entity[1])}/(?!world")', '="', text) if entity else text, ""


def lost_excludes(path, folder, truth):
    """Pairs of bodies that do not touch, and do in the file that is written."""
    pairs = {frozenset(one) for one in truth.get("excluded", [])}
    text = path.read_text(encoding="utf-8")
    bodies = {name.split("/", 1)[-1] for name in re.findall(r'<body name="([^"]*)"', text)}
    found = {frozenset(name.split("/", 1)[-1] for name in one)
             for one in re.findall(r'<exclude body1="([^"]*)" body2="([^"]*)"', text)}
    touch = {re.match(r'[^"]*', part)[0].split("/", 1)[-1] for part in text.split('<body name="')[1:]
             if re.search(r'class="(collision|solid)"', part)}
    return [("exclude", " ".join(sorted(one))) for one in pairs - found if one <= bodies & touch]


class RoundTripTest(unittest.TestCase):
    def again(self, text, kind):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            path = folder / ("robot." + {"mjcf": "xml", "sdf": "sdf"}[kind])
            path.write_text(text, encoding="utf-8")
            out, why = through_smurf(path, folder, kind)
            self.assertIsNotNone(out, why)
            return ET.fromstring(out.read_text(encoding="utf-8"))

    def test_mjcf(self):
        robot = self.again(ROBOT, "mjcf")
        found = collections.Counter(one.tag for part in ("sensor", "actuator", "equality") for one in robot.find(part))
        self.assertEqual(found["accelerometer"], 1)
        self.assertEqual(found["gyro"], 1)
        self.assertEqual(found["force"], 1)
        self.assertEqual(found["rangefinder"], 1)
        self.assertEqual(found["jointpos"], 1)
        self.assertGreaterEqual(found["connect"], 1)
        camera = robot.find(".//camera")
        self.assertAlmostEqual(float(camera.get("fovy")), 60, 6)
        excluded = [{one.get("body1").split("/")[-1], one.get("body2").split("/")[-1]} for one in robot.iter("exclude")]
        self.assertIn({"base", "hand"}, excluded)
        armatures = {one.get("name").split("/")[-1]: one.get("armature") for one in robot.iter("joint")}
        # That of a motor, and that of a joint without one, which has other settings, too.
        self.assertEqual({name: one for name, one in armatures.items() if one}, {"a": "0.02", "c": "0.03"})
        springs = [(one.get("stiffness"), round(float(one.get("springref")), 6)) for one in robot.iter("joint")
                   if one.get("stiffness")]
        self.assertEqual(springs, [("3", 0.349066)])  # 20 degrees
        masks = {one.get("contype") for one in robot.find("worldbody").iter("geom") if one.get("class") == "collision"}
        self.assertEqual(masks, {"1", "2"})

    def test_joints_of_one_body(self):
        """No link between them gets a mass, and a body whose mass is that of fixed ones needs none."""
        robot = self.again(SEVERAL, "mjcf")
        bodies = {one.get("name").split("/")[-1]: one for one in robot.iter("body")}
        self.assertEqual(set(bodies) - {"world"}, {"torso", "leg", "shell"})
        joints = {one.get("name").split("/")[-1]: one for one in bodies["torso"].findall("joint")}
        self.assertEqual(list(joints), ["x", "turn"])
        self.assertEqual([float(one) for one in joints["turn"].get("pos").split()], [0, 0, 0.5])
        self.assertIsNone(bodies["leg"].find("inertial"))
        self.assertIsNotNone(bodies["shell"].find("inertial"))

    def test_sdf(self):
        robot = self.again(LOOP, "sdf")
        self.assertEqual({one.get("name") for one in robot.iter("joint")}, {"a", "b", "c"})
        loop = robot.find(".//joint[@name='c']")
        self.assertEqual([float(one) for one in loop.find("pose").text.split()][:3], [0, 0, 1])

    def test_joints_of_sdf(self):
        """Joints that a URDF says with links that have no mass are one joint again, and no link is invented."""
        robot = self.again(JOINTS, "sdf").find("model")
        self.assertEqual({one.get("name") for one in robot.findall("link")}, {"base", "arm", "fork", "ball", "nut"})
        joints = {one.get("name"): one for one in robot.findall("joint")}
        self.assertEqual({name: one.get("type") for name, one in joints.items()},
                         {"hold": "revolute", "a": "revolute", "u": "universal", "b": "ball", "s": "screw"})
        self.assertEqual(joints["hold"].find("parent").text, "world")
        self.assertEqual([float(one) for one in joints["a"].find("pose").text.split()][:3], [-0.5, 0, 0])
        self.assertEqual(joints["u"].find("axis2/xyz").text, "0 1 0")
        self.assertEqual(float(joints["u"].find("axis2/limit/upper").text), 1)
        self.assertEqual(float(joints["s"].find("thread_pitch").text), 50)

    def test_nested_models(self):
        """Links called `arm::upper` are in a model again, with the joints between them."""
        robot = self.again(NESTED, "sdf").find("model")
        self.assertEqual({one.get("name") for one in robot.findall("link")}, {"base"})
        arm, = robot.findall("model")
        self.assertEqual((arm.get("name"), {one.get("name") for one in arm.findall("link")}), ("arm", {"upper", "fore"}))
        elbow, = arm.findall("joint")
        self.assertEqual((elbow.get("name"), elbow.find("parent").text, elbow.find("child").text), ("elbow", "upper", "fore"))
        hand, = arm.findall("model")
        self.assertEqual([one.get("name") for one in hand.iter("link")], ["palm"])
        ends = {one.get("name"): (one.find("parent").text, one.find("child").text) for one in robot.findall("joint")}
        self.assertEqual(ends, {"shoulder": ("base", "arm::upper"), "wrist": ("arm::fore", "arm::hand::palm")})

    def test_a_name_that_no_model_can_have(self):
        """`base` is a link, so no model is called so; that the name changes is said."""
        with tempfile.TemporaryDirectory() as name:
            path = pathlib.Path(name) / "r.urdf"
            path.write_text('<robot name="r"><link name="base"/><link name="base::tip"/><joint name="j" type="continuous">'
                            '<parent link="base"/><child link="base::tip"/></joint></robot>', encoding="utf-8")
            done = run("smurfs-flatten", path, "--format", "sdf")
            self.assertIn('<link name="base_tip_link">', done.stdout)
            self.assertIn("reserved names of links and joints (`base::tip as base_tip_link`)", done.stderr)

    def test_surfaces(self):
        robot = self.again(SURFACE.format(RUBBER, RUBBER), "sdf")
        for what, expected in (("collision//mu", "0.25"), ("collision//mu2", "0.5"), ("collision//collide_bitmask", "6"),
                               ("collision/laser_retro", "3")):
            self.assertEqual([one.text for one in robot.findall(".//" + what)], [expected] * 2, what)
        self.assertEqual([one.text for one in robot.findall(".//visual/cast_shadows")], ["false"])
        with tempfile.TemporaryDirectory() as name:
            path = pathlib.Path(name) / "r.sdf"
            path.write_text(SURFACE.format(RUBBER, ""), encoding="utf-8")
            self.assertIn("those of `one` differ, so they are lost", run("smurf-lint", path).stdout)
            self.assertNotIn("<surface>", run("smurf2urdf", path).stdout)

    def test_friction_and_motors_of_mjcf(self):
        """Friction that is not written is 1 in MuJoCo, and not that of MARS. A `general` actuator may be a servo."""
        text = ROBOT.replace('<geom size=".05"/>', '<geom size=".05" friction="0.3"/>').replace(
            '<position name="m" joint="a" kp="20" kv="1"', '<general name="m" joint="a" biastype="affine" gainprm="20" '
            'biasprm="0 -20 -1"')
        robot = self.again(text, "mjcf")
        touching = [float(one.get("friction").split()[0]) for one in robot.find("worldbody").iter("geom")
                    if one.get("class") == "collision" or one.get("friction")]
        self.assertEqual(sorted(touching), [0.3, 1, 1, 1])
        motor, = robot.find("actuator")
        self.assertEqual((motor.get("gainprm").split()[0], motor.get("biasprm").split()), ("20", ["0", "-20", "-1"]))

    def test_frames_of_sensors(self):
        """Frames beside those of links, relative to another one, and of an inertia."""
        text = ROBOT.replace('<jointpos name="jp"', """<framepos name="p" objtype="site" objname="tip" reftype="site" refname="imu"/>
            <framequat name="q" objtype="site" objname="imu"/><framequat name="q2" objtype="site" objname="imu"/>
            <framelinvel name="v" objtype="body" objname="arm"/><jointpos name="jp\"""")
        robot = self.again(text, "mjcf")
        sites = {one.get("name"): one for one in robot.iter("site")}
        position, = robot.findall("sensor/framepos")
        self.assertEqual([float(one) for one in sites[position.get("objname")].get("pos").split()], [0.3, 0, 0])
        self.assertEqual([float(one) for one in sites[position.get("refname")].get("pos").split()], [0.1, 0, 0])
        turn = [float(one) for one in sites[position.get("refname")].get("quat").split()]
        self.assertAlmostEqual(turn[3], math.sqrt(0.5), 9)
        self.assertEqual(len(robot.findall("sensor/framequat")), 2)  # that of the IMU, and another one
        speed, = robot.findall("sensor/framelinvel")
        self.assertAlmostEqual(float(sites[speed.get("objname")].get("pos").split()[0]), 0.15, 9)

    def test_laws_of_motors(self):
        """A law is kept where a chosen one would be another, on a follower, too; a ratio is about the inertia of MuJoCo."""
        text = SEVERAL.replace("</mujoco>", """<equality><joint joint1="knee" joint2="turn"/></equality><actuator>
            <position joint="turn" kp="1e4" kv="900" forcerange="-2 7" armature="2" damping="3" gear="2"/>
            <position joint="knee" kp="30" dampratio="1"/><motor joint="x" ctrlrange="0 3"/></actuator></mujoco>""")
        robot = self.again(text, "mjcf")
        motors = {one.get("joint").split("/")[-1]: one for one in robot.find("actuator")}
        self.assertEqual(motors["turn"].get("biasprm").split(), ["0", "-40000", "-3600"])
        self.assertEqual(motors["turn"].get("forcerange").split(), ["-4", "14"])
        self.assertIsNone(motors["turn"].get("ctrlrange"))
        self.assertEqual(motors["x"].get("ctrlrange").split(), ["0", "3"])
        joints = {one.get("name").split("/")[-1]: one for one in robot.find("worldbody").iter("joint")}
        self.assertEqual((joints["turn"].get("armature"), joints["turn"].get("damping")), ("8", "12"))
        self.assertAlmostEqual(float(motors["knee"].get("biasprm").split()[2]), -0.78479562, 7)  # MuJoCo 4.0

    def test_what_is_named(self):
        """Each of these changes how MuJoCo moves the robot, or what it measures."""
        text = ROBOT.replace('armature=".02"', 'armature=".02" solreflimit=".1 1"').replace(
            '<body name="arm"', '<body name="arm" gravcomp="1"').replace(
            '<connect name="tie"', '<connect name="tie" solref=".1 1"').replace(
            '<jointpos name="jp"', '<jointpos name="jp" noise=".1"').replace(
            'kv="1" ctrl', 'kv="1" timeconst=".1" ctrl').replace('qpos=".1 .2 .3 .4"', 'qpos=".1 .2 .3 .4" ctrl=".5" qvel="1 0 0 0"')
        with tempfile.TemporaryDirectory() as name:
            path = pathlib.Path(name) / "robot.xml"
            path.write_text(text, encoding="utf-8")
            said = run("smurf-lint", path, "--format", "concise", "--all").stdout
        for what in ("a joint loses `solreflimit`", "a body loses `gravcomp`", "an equality loses `solref`", "a sensor loses `noise`",
                     "they are lost: `timeconst`", "so `qvel` and `ctrl` are lost"):
            with self.subTest(what):
                self.assertIn(what, said)

    def recorded(self, kind):
        sys.path.insert(0, str(SHARED))
        import compare  # noqa: E402
        rows = [line.split("\t") for line in (SHARED / "entries.tsv").read_text(encoding="utf-8").splitlines()[1:]]
        counts, others = collections.Counter(), []
        for name, path in ((row[0], row[2]) for row in rows if row[1] == kind):
            truth = compare.load(str(SHARED / "expected" / (name + ".json.gz")))
            if truth.get("refused") or (kind == "sdf" and truth.get("kind") != "model"):
                continue
            with tempfile.TemporaryDirectory() as folder:
                folder = pathlib.Path(folder)
                out, said = through_smurf(SHARED / "corpus" / path, folder, kind)
                urdf, why = None, said
                if out is not None:
                    urdf, why = as_urdf(out, folder)
                found = compare.differences(urdf, truth) if urdf else [("fails", why)]
                if urdf and kind == "mjcf":
                    found += lost_excludes(out, folder, truth)
                silent = {one[0] for one in found if SAID.get(one[0], "nothing says it") not in said}
            counts["fails" if not urdf else "equal" if not found else "silent" if silent else "said"] += 1
            others += [(name, path, found)] if found else []
        if VERBOSE:
            for name, path, found in others:
                print(name, path, len(found), found[:3])
        print(kind, dict(counts))
        self.assertGreaterEqual(counts["equal"], LEAST_EQUAL[kind] * sum(counts.values()), others)
        self.assertEqual(counts["silent"] + counts["fails"], 0, others)

    @unittest.skipUnless(SHARED.is_dir(), "the recorded answers of the readers are not here")
    @unittest.skipUnless(PYTHON.exists(), "MuJoCo for Python is not installed")
    def test_built_mjcf(self):
        """Actuators, sensors, friction and settings of joints, as MuJoCo builds them of the file that is written; and how
        it moves in a second with the same commands."""
        rows = [line.split("\t") for line in (SHARED / "entries.tsv").read_text(encoding="utf-8").splitlines()[1:]]
        sys.path.insert(0, str(SHARED))
        import compare  # noqa: E402
        with tempfile.TemporaryDirectory() as name:
            written = []
            for entry, path in ((row[0], SHARED / "corpus" / row[2]) for row in rows if row[1] == "mjcf"):
                truth = compare.load(str(SHARED / "expected" / (entry + ".json.gz")))
                folder = pathlib.Path(name) / entry
                folder.mkdir()
                out, _ = (None, "") if truth.get("refused") else through_smurf(path, folder, "mjcf")
                if out is not None:
                    prefix = re.search(r'<body name="([^"/]*/)', out.read_text(encoding="utf-8"))
                    written.append((entry, path, truth, out, prefix[1] if prefix else ""))
            self.are_built_again(written)
            self.move_as_before(written)

    @staticmethod
    def ask_mujoco(program, arguments):
        done = subprocess.run([PYTHON, program, SHARED, *arguments], capture_output=True, text=True, check=True, timeout=600)
        return [json.loads(line) for line in done.stdout.splitlines()]

    def are_built_again(self, written):
        aspects, equal, refused = collections.Counter(), 0, []
        answers = self.ask_mujoco(rebuilt_mjcf.__file__, [out for _, _, _, out, _ in written])
        for (entry, _, truth, _, prefix), again in zip(written, answers, strict=True):
            if "refused" in again:
                refused.append((entry, again["refused"]))
                continue
            found = rebuilt_mjcf.differences(truth, again, prefix)
            aspects.update({one[0] for one in found})
            equal += not found
            if VERBOSE and found:
                print(entry, len(found), found[:3])
        print(f"built: {equal} of {len(written)} equal; entries that differ: {dict(aspects)}")
        self.assertEqual(refused, [])
        self.assertGreaterEqual(equal, LEAST_BUILT * len(written))

    def move_as_before(self, written):
        counts, silent = collections.Counter(), []
        answers = self.ask_mujoco(MOVED, [word for _, path, _, out, prefix in written for word in (path, out, prefix)])
        for (entry, path, _, _, _), answer in zip(written, answers, strict=True):
            is_equal = not answer.get("values") and answer.get("way", 1) < MOST_WAY
            said = "" if is_equal else run("smurf-lint", path, "--format", "concise", "--all").stdout
            kind = "skipped" if "skipped" in answer else "equal" if is_equal else "said"
            if kind == "said" and not OTHER_MOTION.search(said):
                kind = "silent"
                silent.append((entry, answer))
            counts[kind] += 1
            if VERBOSE and not is_equal:
                print(entry, answer)
        print("moved:", dict(counts))
        self.assertEqual(silent, [])
        self.assertGreaterEqual(counts["equal"], LEAST_MOVED * len(written))

    @unittest.skipUnless(SHARED.is_dir(), "the recorded answers of the readers are not here")
    def test_recorded_sdf(self):
        self.recorded("sdf")

    @unittest.skipUnless(SHARED.is_dir(), "the recorded answers of the readers are not here")
    def test_recorded_mjcf(self):
        self.recorded("mjcf")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
