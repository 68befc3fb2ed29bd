# SPDX-License-Identifier: BSD-3-Clause
"""SDF -> SMURF -> SDF and MJCF -> SMURF -> MJCF: a robot that was taken in and written again is the same robot. It is
read again and compared with what libsdformat and MuJoCo made of the first file, where their answers were recorded
(../shared/imports): poses, masses, tensors, axes, limits; and the annotations that SMURF has are counted.

import_round_trip_test.py FOLDER_OF_PROGRAMS [-v]    -v prints each difference
"""
import collections
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ET

SHARED = pathlib.Path(__file__).resolve().parents[2].parent / "shared/imports"
BIN = pathlib.Path(sys.argv[1]).absolute()
VERBOSE = "-v" in sys.argv
LEAST_EQUAL = {"sdf": 0.78, "mjcf": 0.97}
MOST_SILENT = {"sdf": 3, "mjcf": 0}  # nested models: links named `a::b`
# What differs is said: a part of the message, by the kind of the difference.
SAID = {"inertia": "placeholders", "mass": "so the mass of its bodies is unknown", "dynamics": "gains of motors"}

ROBOT = """<mujoco model="bot"><worldbody>
  <body name="base" pos="0 0 1"><joint name="a" axis="0 0 1" range="-90 90" armature=".02"/>
    <geom type="box" size=".1 .1 .1" contype="2" conaffinity="2"/><site name="imu" pos=".1 0 0" euler="0 0 90"/>
    <body name="arm" pos="0 0 .2"><joint name="b" axis="0 1 0"/><geom type="capsule" size=".03" fromto="0 0 0 .3 0 0"/>
      <site name="tip" pos=".3 0 0"/><camera name="eye" pos=".1 0 0" fovy="60" resolution="320 240"/>
      <body name="hand" pos=".3 0 0"><joint name="c" axis="0 1 0"/><geom size=".05"/></body></body>
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
        self.assertEqual([one.get("armature") for one in robot.iter("joint") if one.get("armature")], ["0.02"])
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
        self.assertLessEqual(counts["silent"] + counts["fails"], MOST_SILENT[kind], others)

    @unittest.skipUnless(SHARED.is_dir(), "the recorded answers of the readers are not here")
    def test_recorded_sdf(self):
        self.recorded("sdf")

    @unittest.skipUnless(SHARED.is_dir(), "the recorded answers of the readers are not here")
    def test_recorded_mjcf(self):
        self.recorded("mjcf")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
