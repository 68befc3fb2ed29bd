# SPDX-License-Identifier: BSD-3-Clause
"""SDF, MJCF and URDF: what the readers of the simulators make of them, against the flat JSON."""
import json
import pathlib
import re
import struct
import xml.etree.ElementTree as ElementTree

import reader

HERE = pathlib.Path(__file__).resolve().parent
# Every kind of joint, a mimic, a massless root and a link of a joint's name.
ZOO = """<?xml version="1.0"?>
<robot name="zoo" xmlns:ext="http://example.org/ext">
  <ext:note text="kept"/>
  <material name="blue"><color rgba="0 0 1 1"/></material>
  <link name="base"/>
  <link name="body">
    <inertial><origin xyz="0.1 0 0" rpy="0.3 0.2 0.1"/><mass value="2"/>
      <inertia ixx="0.02" ixy="0.001" ixz="0" iyy="0.03" iyz="0" izz="0.04"/></inertial>
    <visual><geometry><cylinder radius="0.1" length="0.4"/></geometry><material name="blue"/></visual>
    <collision><origin rpy="0 1.5707963267948966 0"/>
      <geometry><sphere radius="0.1"/></geometry></collision>
  </link>
  <link name="arm"><inertial><mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
  <link name="slider"><inertial><mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
  <link name="wheel"><inertial><mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
  <link name="tip"/>
  <joint name="mount" type="fixed"><parent link="base"/><child link="body"/>
    <origin xyz="0 0 0.2"/></joint>
  <joint name="arm" type="revolute"><parent link="body"/><child link="arm"/>
    <origin xyz="0.2 0 0" rpy="0.1 0.2 0.3"/><axis xyz="0 0.6 0.8"/>
    <limit lower="-1" upper="2" effort="5" velocity="1"/>
    <dynamics damping="0.5" friction="0.1"/></joint>
  <joint name="lift" type="prismatic"><parent link="arm"/><child link="slider"/>
    <origin xyz="0 0 0.3"/><axis xyz="0 0 2"/>
    <limit lower="0" upper="1" effort="5" velocity="1"/></joint>
  <joint name="turn" type="continuous"><parent link="slider"/><child link="wheel"/>
    <origin xyz="0 0.1 0"/><axis xyz="1 0 0"/><mimic joint="arm" multiplier="-2" offset="0.25"/>
    <limit effort="1" velocity="1"/></joint>
  <joint name="end" type="fixed"><parent link="wheel"/><child link="tip"/>
    <origin xyz="0.1 0 0.1" rpy="0.5 0 0"/></joint>
</robot>
"""
ZOO_MODEL = "modelname: zoo\nfiles: [zoo.urdf, zoo_poses.yml]\n"
ZOO_POSES = "poses:\n- {name: bent, joints: {arm: 0.7, lift: 0.25}}\n"
ZOO_SCENE = """physics: {gravity: {x: 0.5, y: 0, z: -3}, ode: {stepsize: 2, cfm: 1.0e-8, erp: 0.3}}
lights:
- {name: lamp, type: 2, position: {x: 0, y: 0, z: 3}, lookat: {x: 1, y: 0, z: 0}, angle: 60}
entities:
- {name: One, file: zoo.smurf, position: [0, 0, 1], rotation: [10, 89.9999999, 30], pose: bent}
- {name: "Two to Go", file: zoo.smurf, parent: "One::tip", anchor: parent, position: [0, 1, 0],
   rotation: [0, -90, 0]}
- {name: Three, file: zoo.urdf, parent: "Two to Go::wheel", anchor: parent, rotation: [45]}
- {name: Four, file: zoo.smurf, position: [5, 5, 0], anchor: world, pose: bent}
- {name: Box, type: primitive, geometry: {type: box}, position: {x: -3, y: 0, z: 2}, mass: 4}
- {name: Floor, type: primitive, geometry: {type: plane}, movable: false,
   position: {x: 0, y: 0, z: -5}}
"""


def safe(path):
    return re.sub(r"[^A-Za-z0-9_]", "_", path.replace("/", "__"))


class SimulatorTest(reader.ReaderTest):
    def setUp(self):
        super().setUp()
        self.write("zoo.urdf", ZOO)
        self.write("zoo.smurf", ZOO_MODEL)
        self.write("zoo_poses.yml", ZOO_POSES)
        self.write("zoo.smurfs", ZOO_SCENE)
        self.scenes = [*reader.SCENES.values(), self.folder / "zoo.smurfs"]

    def lines(self, *command):
        return [line.split("\t") for line in self.read_with(*command).splitlines()]

    @staticmethod
    def poses(lines):
        return {line[1]: list(map(float, line[2:])) for line in lines if line[0] == "pose"}

    def assert_links(self, poses, flat, name_of, without=(), tolerance=1e-9):
        """Every link of every model has the pose of the flat JSON; links in `without` may be absent."""
        count = 0
        for instance in flat["instances"]:
            for link, pose in instance.get("links", {}).items():
                name = name_of(instance["path"], link)
                if name in poses:
                    self.assert_same_pose(name, poses[name][:3], poses[name][3:], pose, tolerance)
                    count += 1
                else:
                    self.assertIn(link, without, f"{name} is not in {sorted(poses)}")
        return count


class Sdf(SimulatorTest):
    def sdf(self, scene, *arguments, form="sdf"):
        return self.lines(reader.BUILD / "sdf_poses", self.write_scene(scene, form, *arguments))

    @staticmethod
    def unscoped(poses):
        """Without the outer model around things that are fixed to each other."""
        return {re.sub(r"^\w+__and_what_is_fixed_to_it::", "", name): pose
                for name, pose in poses.items()}

    @reader.needs_built("sdf_poses")
    def test_links_stand_where_they_do(self):
        for scene in self.scenes:
            poses = self.unscoped(self.poses(self.sdf(scene)))
            count = self.assert_links(poses, self.flat(scene), lambda i, l: f"{safe(i)}::{l}")
            self.assertGreater(count, 3)

    @reader.needs_built("sdf_poses")
    def test_old_readers(self):
        for scene in self.scenes:
            poses = self.unscoped(self.poses(self.sdf(scene, form="sdf1.6")))
            flat = self.flat(scene)
            massless = {link for i in flat["instances"] for link in i.get("links", {})} - {"base"}
            self.assertGreater(self.assert_links(poses, flat, lambda i, l: f"{safe(i)}::{l}",
                                                 without=massless), 3)

    @reader.needs_built("sdf_poses")
    def test_references(self):
        for scene in self.scenes:
            poses = self.unscoped(self.poses(self.sdf(scene, "--form", "reference")))
            roots = {f"{safe(i['path'])}::{next(iter(i['links']))}": next(iter(i["links"].values()))
                     for i in self.flat(scene)["instances"] if i.get("links")}
            found = [name for name in roots if name in poses]
            for name in found:
                self.assert_same_pose(name, poses[name][:3], poses[name][3:], roots[name])
            self.assertGreater(len(found), 2)

    @reader.needs_built("sdf_poses")
    def test_world_and_joints(self):
        lines = self.sdf(self.folder / "zoo.smurfs")
        self.assertIn(["gravity", "0.5", "0", "-3"], lines)
        self.assertIn(["step", "0.002"], lines)
        self.assertIn(["light", "lamp"], lines)
        joints = {re.sub(r"^\w+__and_what_is_fixed_to_it::", "", line[1]): line[2:]
                  for line in lines if line[0] == "joint"}
        self.assertEqual(joints["Four::anchor_to_world"], ["world", "base"])
        self.assertEqual(joints["anchor_of_Two_to_Go"], ["One::wheel", "Two_to_Go::base"])
        self.assertEqual(joints["One::arm_joint"], ["body", "arm"])  # `arm` is a link, too

    @reader.needs_built("sdf_poses")
    def test_reserved_names(self):
        self.write("zoo.urdf", ZOO.replace('"base"', '"world"').replace('"tip"', '"a::b"'))
        lines = self.sdf(self.folder / "zoo.urdf")
        poses = self.poses(lines)
        self.assertNotIn("zoo::world_link", poses)  # a link without anything is the world itself
        self.assertIn(["joint", "zoo::mount", "world", "body"], lines)
        self.assertIn("zoo::a_b_link", poses)

    @reader.needs_built("sdf_poses")
    def test_names_that_look_like_flags(self):
        """libsdformat reads a name `true` as `1`, but not at the end of a scoped name."""
        self.write("zoo.urdf", ZOO.replace('"base"', '"true"').replace('"tip"', '"False"'))
        self.write("zoo.smurfs", ZOO_SCENE.replace("One::tip", "One::False"))
        self.assertTrue(self.sdf(self.folder / "zoo.smurfs"))

    @reader.needs_built("sdf_poses")
    def test_reserved_names_of_other_parts(self):
        text = ZOO.replace('joint name="mount"', 'joint name="world"').replace('joint="arm"', 'joint="a::m"')
        text = text.replace('joint name="arm"', 'joint name="a::m"').replace("<visual>", '<visual name="v::1">')
        text = text.replace("<collision>", '<collision name="__c">').replace(
            "</robot>", '<gazebo reference="body"><sensor name="s::1" type="imu"/></gazebo></robot>')
        self.write("zoo.urdf", text)
        for form in ("sdf", "sdf1.6"):
            lines = self.sdf(self.folder / "zoo.urdf", form=form)
            names = {line[1] for line in lines if line[0] in ("joint", "sensor")}
            self.assertLessEqual({"zoo::a_m", "zoo::world_0", "zoo::body::s_1"}, names, form)

    @reader.needs_program("ign")
    def test_ign_accepts_them(self):
        for scene in self.scenes:
            for form in ("expand", "reference"):
                file = self.write_scene(scene, "sdf", "--form", form)
                self.assertIn("Valid", self.read_with("ign", "sdf", "-k", file, cwd=self.folder))


class Mjcf(SimulatorTest):
    @reader.needs_built("mujoco_poses")
    def test_bodies_stand_where_the_links_do(self):
        for scene in self.scenes:
            file = self.write_scene(scene, "mjcf")
            poses = self.poses(self.lines(reader.BUILD / "mujoco_poses", file))
            count = self.assert_links(poses, self.flat(scene), lambda i, l: f"{i}/{l}")
            self.assertGreater(count, 3)

    @reader.needs_built("mujoco_poses")
    def test_world(self):
        file = self.write_scene(self.folder / "zoo.smurfs", "mjcf")
        lines = self.lines(reader.BUILD / "mujoco_poses", file)
        self.assertIn(["gravity", "0.5", "0", "-3"], lines)
        self.assertEqual(self.poses(lines)["Box/link"], [-3, 0, 2, 1, 0, 0, 0])

    @reader.needs_npm("@mujoco/mujoco")
    def test_later_versions(self):
        for scene in [reader.SCENES["nested"], self.folder / "zoo.smurfs"]:
            file = self.write_scene(scene, "mjcf")
            lines = self.lines("node", HERE / "mujoco_poses.mjs", reader.NODE_MODULES, file)
            self.assert_links(self.poses(lines), self.flat(scene), lambda i, l: f"{i}/{l}")


CORNERS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
SIDES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]


def stl(corners=CORNERS, sides=tuple(SIDES), count=None):
    facets = [struct.pack("<12fH", 0, 0, 0, *corners[a], *corners[b], *corners[c], 0) for a, b, c in sides]
    return bytes(80) + struct.pack("<I", len(sides) if count is None else count) + b"".join(facets)


def stl_text():
    points = "".join("facet normal 0 0 0\nouter loop\n" + "".join("vertex %g %g %g\n" % CORNERS[i] for i in side)
                     + "endloop\nendfacet\n" for side in SIDES)
    return f"solid s\n{points}endsolid s\n".encode()


def obj(corners=CORNERS, sides=tuple(SIDES)):
    lines = ["v %g %g %g" % corner for corner in corners]
    return "\n".join(lines + ["f %d %d %d" % tuple(i + 1 for i in side) for side in sides] + [""]).encode()


FLAT = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)]
# MuJoCo refuses the whole world for one mesh that it does not read.
MESHES_OF_MUJOCO = {"binary.stl": stl(), "inside_out.stl": stl(sides=[side[::-1] for side in SIDES]),
                    "open.stl": stl(sides=SIDES[:2]), "good.obj": obj(), "text.stl": stl_text()}
OTHER_MESHES = {"empty.stl": b"", "cut.stl": stl()[:-20], "longer.stl": stl() + bytes(2),
                "none.stl": stl(sides=[]), "flat.stl": stl(FLAT, SIDES[:2]),
                "one.stl": stl(sides=SIDES[:1]), "pointer.stl": b"version https://git-lfs.github.com/spec/v1\n",
                "tiny.stl": stl([tuple(1e-6 * x for x in corner) for corner in CORNERS]), "flat.obj": obj(FLAT, SIDES[:2]),
                "one.obj": obj(sides=SIDES[:1]), "page.obj": b"<html></html>\n"}


class MeshesOfMjcf(SimulatorTest):
    def write_robot(self, name, content):
        (self.folder / name).write_bytes(content)
        shape = f'<geometry><mesh filename="{name}"/></geometry>'
        self.write(f"{name}.urdf", f'<robot name="m"><link name="l"><inertial><mass value="1"/><inertia ixx="1" iyy="1" '
                   f'izz="1" ixy="0" ixz="0" iyz="0"/></inertial><visual>{shape}</visual>'
                   f'<collision>{shape}</collision></link></robot>')

    def world(self, name):
        """The world, which both versions of MuJoCo load, and its losses of shapes."""
        file = self.write_scene(f"{name}.urdf", "mjcf", "--force", "--loss-report", "lost.json")
        self.lines(reader.BUILD / "mujoco_poses", file)
        names = [mesh.get("file") for mesh in ElementTree.parse(file).iter("mesh")]
        lines = self.lines("node", HERE / "mujoco_poses.mjs", reader.NODE_MODULES, file, *filter(None, names))
        self.assertTrue(lines)
        return names, [loss["message"] for loss in json.loads(self.read("lost.json"))["losses"]
                       if loss["id"] == "SML8205"]

    @reader.needs_built("mujoco_poses")
    @reader.needs_npm("@mujoco/mujoco")
    def test_each_is_read_or_named(self):
        for name, content in {**MESHES_OF_MUJOCO, **OTHER_MESHES}.items():
            with self.subTest(name):
                self.write_robot(name, content)
                names, losses = self.world(name)
                self.assertEqual(len(names), 1 if name in MESHES_OF_MUJOCO else 0)
                self.assertEqual(bool(losses), name in OTHER_MESHES, losses)

    @reader.needs_built("mujoco_poses")
    def test_files_that_are_no_pictures(self):
        """MuJoCo refuses the world for them, too."""
        texture = '<visual><geometry><box size="1 1 1"/></geometry><material name="m"><texture filename="{}"/>' \
                  '</material></visual>'
        terrain = "entities:\n- {{name: T, type: heightmap, file: {}, position: [0, 0, 0], anchor: world, " \
                  "width: 2.0, length: 2.0, height: 0.5}}\n"
        picture = (reader.cli.FIXTURES / "scenes/terrain/heightmaps/terraces.png").read_bytes()
        for name, content in {"good.png": picture, "jpeg.png": b"\xff\xd8\xff\xe0", "cut.png": picture[:-20]}.items():
            (self.folder / name).write_bytes(content)
            self.write("t.urdf", f'<robot name="t"><link name="l">{BODY}{texture.format(name)}</link></robot>')
            self.write("t.smurfs", terrain.format(name))
            for scene in ("t.urdf", "t.smurfs"):
                file = self.write_scene(scene, "mjcf", "--loss-report", "lost.json")
                self.lines(reader.BUILD / "mujoco_poses", file)
                named = [loss["message"] for loss in json.loads(self.read("lost.json"))["losses"] if "PNG" in loss["message"]]
                self.assertEqual((f'file="{name}"' in self.read("out.mjcf"), bool(named)),
                                 (name == "good.png", name != "good.png"), (scene, named))

    @reader.needs_built("mujoco_poses")
    @reader.needs_built("sdf_poses")
    def test_axes_and_followers_that_readers_refuse(self):
        joint = ('<joint name="j" type="continuous"><parent link="a"/><child link="b"/><axis xyz="{}"/>'
                 '<mimic joint="j"/></joint>')
        for axis, written in {"0 0 0": "1 0 0", "0 0 1e-9": "0 0 1", "0 3e-200 0": "0 1 0", "0 0 2": "0 0 2"}.items():
            self.write("x.urdf", f'<robot name="x"><link name="a">{BODY}</link><link name="b">{BODY}</link>'
                       + joint.format(axis) + "</robot>")
            for form, program in {"mjcf": "mujoco_poses", "sdf": "sdf_poses"}.items():
                file = self.write_scene("x.urdf", form, "--force", "--loss-report", "lost.json")
                self.lines(reader.BUILD / program, file)
                self.assertIn(f'axis="{written}"' if form == "mjcf" else f"<xyz>{written}</xyz>", file.read_text())
                is_named = any("since the axis is zero" in loss["message"]
                               for loss in json.loads(self.read("lost.json"))["losses"])
                self.assertEqual(is_named, axis == "0 0 0")

    @reader.needs_built("mujoco_poses")
    @reader.needs_npm("@mujoco/mujoco")
    def test_text_becomes_triangles(self):
        for name, is_named in {"binary.stl": True, "text.stl": False}.items():
            self.write_robot(name, MESHES_OF_MUJOCO[name])
            self.assertEqual(self.world(name)[0], [name if is_named else None])

    @reader.needs_built("mujoco_poses")
    def test_meshes_of_old_scenes(self):
        """MuJoCo reads those that are there; of the others, the warning gives the reason."""
        (self.folder / "rock.obj").write_bytes(obj())
        old = "nodelist:\n- {{name: rock, index: 1, filename: {}}}\n"
        self.write("s.smurfs", "entities:\n- {name: Old, file: old.yml}\n")
        for name, losses in {"rock.obj": [], "gone.obj": ["the mesh `gone.obj` is not in the MJCF: the file is not there"]}.items():
            self.write("old.yml", old.format(name))
            file = self.write_scene("s.smurfs", "mjcf", "--loss-report", "lost.json")
            self.lines(reader.BUILD / "mujoco_poses", file)
            geoms = [geom.get("mesh") for geom in ElementTree.parse(file).iter("geom") if geom.get("mesh")]
            self.assertEqual(len(geoms), 1 if name == "rock.obj" else 0)
            self.assertEqual([loss["message"] for loss in json.loads(self.read("lost.json"))["losses"]], losses)


class AttachedMjcf(SimulatorTest):
    def attached(self, scene):
        file = self.write_scene(scene, "mjcf", "--form", "reference")
        root = ElementTree.parse(file).getroot()
        return file, root, [model.get("file") for model in root.findall("asset/model")]

    @reader.needs_npm("@mujoco/mujoco")
    def test_bodies_stand_where_the_links_do(self):
        for scene in [reader.SCENES["example"], reader.SCENES["nested"],
                      self.folder / "zoo.smurfs"]:
            file, _, models = self.attached(scene)
            lines = self.lines("node", HERE / "mujoco_poses.mjs", reader.NODE_MODULES, file,
                               *models)
            count = self.assert_links(self.poses(lines), self.flat(scene),
                                      lambda i, l: f"{i}/{l}")
            self.assertGreater(count, 3)

    def test_what_hangs_on_links_is_welded(self):
        _, root, models = self.attached(self.folder / "zoo.smurfs")
        self.assertEqual(models, ["zoo.urdf", "zoo.urdf"])  # of the .smurf, and alone
        welds = {(weld.get("body1"), weld.get("body2")) for weld in root.iter("weld")}
        self.assertEqual(welds, {("One/tip", "Two to Go"), ("Two to Go/wheel", "Three")})

    def test_meshes_are_a_loss(self):
        done = self.run_tool(reader.SCENES["showcase"], "--format", "mjcf", "--form", "reference",
                             "-o", "out", "--report", "json=r.json")
        self.assertEqual(done.returncode, 0)
        messages = [d["message"] for d in json.loads(self.read("r.json"))["diagnostics"]
                    if d["id"] == "SML8205"]
        self.assertTrue(any("which MuJoCo looks for beside the URDF" in m for m in messages))


class Urdf(SimulatorTest):
    def without_joint_poses(self, scene):
        """A URDF has no joint positions, so the scene is read without them."""
        scene = pathlib.Path(scene)
        text = re.sub(r"\n *pose: \w+|, pose: \w+", "", scene.read_text())
        if scene.parent != self.folder:
            text = text.replace("file: ", f"file: {scene.parent}/")
        self.write("straight.smurfs", text)
        return self.folder / "straight.smurfs"

    @reader.needs_npm("urdf-loader")
    def test_links_stand_where_they_do(self):
        for scene in self.scenes:
            straight = self.without_joint_poses(scene)
            file = self.write_scene(straight, "urdf")
            lines = self.lines("node", HERE / "urdf_poses.mjs", reader.NODE_MODULES, file)
            count = self.assert_links(self.poses(lines), self.flat(straight),
                                      lambda i, l: f"{safe(i)}__{l}")
            self.assertGreater(count, 3)

    @reader.needs_built("dart_poses")
    def test_links_stand_where_they_do_in_dart(self):
        # In DART, a joint that follows another one is also at zero.
        self.write("zoo.urdf", ZOO.replace(' offset="0.25"', ""))
        for scene in self.scenes:
            straight = self.without_joint_poses(scene)
            lines = self.lines(reader.BUILD / "dart_poses", self.write_scene(straight, "urdf"))
            self.assertEqual((lines[0][0], lines[-1]), ("file", ["end"]))
            flat = self.flat(straight)
            count = self.assert_links(self.poses(lines), flat, lambda i, l: f"{safe(i)}__{l}")
            self.assertEqual(count, sum(len(i.get("links", {})) for i in flat["instances"]))
            self.assertGreater(count, 3)

    @reader.needs_program("check_urdf")
    def test_urdfdom_accepts_them(self):
        for scene in self.scenes:
            file = self.write_scene(scene, "urdf")
            self.assertIn("Successfully Parsed", self.read_with("check_urdf", file))

    @reader.needs_program("check_urdf")
    def test_names_are_prefixed_everywhere(self):
        root = ElementTree.parse(self.write_scene(self.folder / "zoo.smurfs", "urdf")).getroot()
        joint = root.find("joint[@name='Two_to_Go__turn']")
        self.assertEqual(joint.find("mimic").get("joint"), "Two_to_Go__arm")
        self.assertEqual(root.find("link[@name='One__body']/visual/material").get("name"),
                         "One__blue")
        self.assertEqual(root.find("joint[@name='One__placement']").get("type"), "floating")
        self.assertEqual(root.find("joint[@name='Four__placement']").get("type"), "fixed")
        self.assertEqual(len(root.findall("{http://example.org/ext}note")), 4)
        names = [(e.tag, e.get("name")) for e in root if e.get("name")]
        self.assertEqual(len(names), len(set(names)))


BODY = ('<inertial><mass value="1"/><inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" '
        'iyz="0"/></inertial>')


class RefusedOutputs(SimulatorTest):
    """Results that their own reader refused."""

    @reader.needs_program("check_urdf")
    def test_a_prefix_that_two_models_bind_differently(self):
        for name, uri in (("a", "http://wiki.ros.org/xacro"), ("b", "http://www.ros.org/wiki/xacro")):
            self.write(f"{name}.urdf", f'<robot name="{name}" xmlns:xacro="{uri}"><link name="l">{BODY}'
                                       f'</link><note xacro:x="{name}"/></robot>')
        self.write("s.smurfs", "entities:\n- {name: A, type: urdf, file: a.urdf}\n"
                               "- {name: B, type: urdf, file: b.urdf}\n")
        file = self.write_scene("s.smurfs", "urdf")
        self.assertIn("Successfully Parsed", self.read_with("check_urdf", file))
        notes = ElementTree.parse(file).getroot().findall("note")
        self.assertEqual([note.attrib for note in notes],
                         [{"{http://wiki.ros.org/xacro}x": "a"}, {"{http://www.ros.org/wiki/xacro}x": "b"}])

    @reader.needs_built("urdfdom_poses")
    def test_capsules_and_colours_of_primitives(self):
        self.write("s.smurfs", "entities:\n- {name: C, type: primitive, geometry: {type: capsule}, "
                               "extend: {x: 0.1, y: 0.5, z: 0}, position: {x: 0, y: 0, z: 1}, "
                               "material: {diffuseColor: {r: 1, g: 0, b: 0, a: 1}}}\n")
        root = ElementTree.parse(self.write_scene("s.smurfs", "urdf")).getroot()
        shapes = [next(iter(shape)).tag for shape in root.iter("geometry")]
        self.assertEqual(shapes, ["cylinder", "sphere", "sphere"] * 2)
        heights = [float(part.find("origin").get("xyz").split()[2]) for part in root.iter("collision")]
        self.assertEqual(heights, [0, 0.25, -0.25])
        self.assertEqual({color.get("rgba") for color in root.iter("color")}, {"1 0 0 1"})

    def test_capsules_of_models(self):
        """Readers of URDF 1.0 refuse the version of the model; without it, they would leave the capsule out."""
        capsule = '<collision><geometry><capsule radius="0.1" length="0.5"/></geometry></collision>'
        self.write("new.urdf", f'<robot name="n" version="1.1"><link name="l">{BODY}{capsule}</link></robot>')
        self.write("plain.urdf", f'<robot name="p"><link name="l">{BODY}</link></robot>')
        for models, version in ((("plain", "plain"), None), (("plain", "new"), "1.1"), (("new", "plain"), "1.1")):
            self.write("s.smurfs", "entities:\n" + "".join(
                f"- {{name: E{i}, type: urdf, file: {model}.urdf}}\n" for i, model in enumerate(models)))
            file = self.write_scene("s.smurfs", "urdf")
            self.assertEqual(ElementTree.parse(file).getroot().get("version"), version)

    @reader.needs_built("mujoco_poses")
    def test_inertias(self):
        joint = '<joint name="{0}" type="{1}"><parent link="b"/><child link="{0}"/></joint>'
        link = ('<link name="{}"><inertial><mass value="{}"/><inertia ixx="{}" iyy="{}" izz="{}" '
                'ixy="0" ixz="0" iyz="0"/></inertial></link>')
        self.write("k.urdf", f'<robot name="k"><link name="b">{BODY}</link>'
                   + link.format("tiny", "1e-7", *["3e-22"] * 3) + joint.format("tiny", "fixed")
                   + link.format("moves", "1e-7", *["3e-22"] * 3) + joint.format("moves", "continuous")
                   + link.format("flat", "1", "0.0001", "0.0001", "0.000201")
                   + joint.format("flat", "continuous") + "</robot>")
        file = self.write_scene("k.urdf", "mjcf")
        poses = self.poses(self.lines(reader.BUILD / "mujoco_poses", file))
        self.assertEqual(set(poses), {"k/b", "k/tiny", "k/moves", "k/flat"})
        changed, = self.losses_of("k.urdf", "mjcf", "SML8211", "inertias")
        self.assertIn("(`moves`, `flat`)", changed)

    def losses_of(self, scene, form, rule, start):
        self.run_tool(scene, "--format", form, "-o", "out", "--report", "json=r.json")
        return [d["message"] for d in json.loads(self.read("r.json"))["diagnostics"]
                if d["id"] == rule and d["message"].startswith(start)]


class Contents(SimulatorTest):
    """Data for simulators in addition to links and joints."""
    URDF = f"""<robot name="g">
<gazebo><static>false</static><plugin name="p" filename="libp.so"><a>1</a></plugin></gazebo>
<link name="b">{BODY}
  <visual><geometry><box size="1 1 1"/></geometry>
    <material name="r"><color rgba="1 0 0 1"/></material></visual>
  <collision><geometry><box size="1 1 1"/></geometry></collision>
  <collision><geometry><box size="1 2 1"/></geometry></collision>
  <collision name="hey"><geometry><box size="1 1 1"/></geometry></collision></link>
<link name="c">{BODY}<visual name="cv"><geometry><box size="1 1 1"/></geometry></visual></link>
<joint name="j" type="revolute"><parent link="b"/><child link="c"/><axis xyz="0 0 1"/>
  <limit lower="-1" upper="1" effort="3" velocity="2"/><dynamics damping="0.3" friction="0.4"/></joint>
<link name="cam"/>
<joint name="cj" type="fixed"><parent link="c"/><child link="cam"/><origin xyz="1 0 0"/></joint>
<gazebo reference="b"><mu1>0.5</mu1><mu2>0.4</mu2><kp>100</kp><kd>2</kd><minDepth>0.001</minDepth>
  <maxVel>0.1</maxVel><material>Gazebo/Red</material><selfCollide>true</selfCollide>
  <turnGravityOff>true</turnGravityOff><dampingFactor>0.1</dampingFactor><laserRetro>1</laserRetro>
  <maxContacts>4</maxContacts><fdir1>1 0 0</fdir1><visual><cast_shadows>false</cast_shadows></visual>
  <sensor name="bump" type="contact"><contact><collision>b_collision</collision></contact></sensor>
</gazebo>
<gazebo reference="cam"><sensor name="camera" type="camera"><pose>0 0 1 0 0 0</pose><camera/></sensor>
  <sensor name="cam2" type="camera"><camera/></sensor></gazebo>
<gazebo reference="j"><stopCfm>0.1</stopCfm><stopErp>0.2</stopErp><provideFeedback>true</provideFeedback>
  <springStiffness>3</springStiffness><springReference>0.1</springReference>
  <implicitSpringDamper>1</implicitSpringDamper><fudgeFactor>0.5</fudgeFactor>
  <sensor name="ft" type="force_torque"><force_torque/></sensor></gazebo>
</robot>
"""

    def converted(self, file):
        """The model as libsdformat prints it: {(path of names and tags): text}."""
        root = ElementTree.fromstring(self.read_with("ign", "sdf", "-p", file, cwd=self.folder))
        found = {}

        def walk(element, path):
            for child in element:
                step = path + (child.get("name") or child.tag,)
                text = (child.text or "").strip()
                if not len(child) and child.tag not in self.OTHERWISE:
                    found[step] = [float(word) if re.fullmatch(r"[-+.\de]+", word) else
                                   {"true": 1.0, "false": 0.0}.get(word, word) for word in text.split()]
                walk(child, step)
        walk(root.find(".//model"), ())
        return found

    # Other tests compare poses; here, a joint has no pose, but a link has one.
    OTHERWISE = {"pose", "a"}

    @reader.needs_program("ign")
    def test_as_gazebo_converts_them(self):
        self.write("g.urdf", self.URDF)
        theirs = self.converted("g.urdf")
        ours = self.converted(self.write_scene("g.urdf", "sdf"))
        for path, value in theirs.items():
            if path[1:2] == ("b_fixed_joint_lump__hey_collision_2",):
                continue  # its name differs, and libsdformat does not set its friction
            self.assertEqual(ours.get(path, "is missing"), value, path)

    @reader.needs_program("ign")
    def test_sensors_of_annotations(self):
        self.write("g.urdf", self.URDF)
        self.write("g.smurf", "modelname: g\nfiles: [g.urdf, g_sensors.yml, g_collision.yml]\n")
        self.write("g_collision.yml", "collision:\n- {name: hey, link: b, bitmask: 6}\n")
        self.write("g_sensors.yml", "sensors:\n- {name: touch, type: NodeContact, link: b, id: [hey]}\n"
                   "- {name: turn, type: NodeIMU, link: cam, id: [cam], rate: 10}\n")
        root = ElementTree.parse(self.write_scene("g.smurf", "sdf")).getroot()
        self.read_with("ign", "sdf", "-k", "out.sdf", cwd=self.folder)
        sensors = {sensor.get("name"): sensor for sensor in root.iter("sensor")}
        named = sensors["touch"].find("contact/collision").text
        collisions = {shape.get("name"): shape for shape in root.iter("collision")}
        self.assertEqual(collisions[named].find("surface/contact/collide_bitmask").text, "6")
        self.assertEqual(sensors["turn"].find("pose").get("relative_to"), "cam")
        self.assertEqual(sensors["turn"].find("update_rate").text, "100")

    @reader.needs_built("sdf_poses")
    def test_sensors_of_lumped_links_keep_their_place(self):
        self.write("g.urdf", self.URDF)
        for form in ("sdf", "sdf1.6"):
            lines = self.lines(reader.BUILD / "sdf_poses", self.write_scene("g.urdf", form))
            poses = {line[1]: [float(n) for n in line[2:5]] for line in lines if line[0] == "sensor"}
            self.assertEqual(poses["g::c::camera"], [1, 0, 1])
            self.assertEqual(poses["g::c::cam2"], [1, 0, 0])
            self.assertIn("g::b::bump", poses)

    @reader.needs_built("mujoco_actuators")
    def test_motors_move_their_joints(self):
        joint = ('<joint name="{0}" type="revolute"><parent link="b"/><child link="{0}"/>'
                 '<axis xyz="0 0 1"/><limit lower="-2" upper="2" effort="{1}" velocity="2"/></joint>')
        names = ("PID", "DC", "direct_effort", "transmitted")
        self.write("m.urdf", f'<robot name="m"><link name="b">{BODY}</link>'
                   + "".join(f'<link name="{n}">{BODY}</link>' + joint.format(n, 3) for n in names)
                   + '<transmission name="t"><type>transmission_interface/SimpleTransmission</type>'
                   '<joint name="transmitted"><hardwareInterface>hardware_interface/'
                   'PositionJointInterface</hardwareInterface></joint><actuator name="a"/></transmission>'
                   "</robot>")
        self.write("m.smurf", "modelname: m\nfiles: [m.urdf, m_motors.yml, m_poses.yml]\n")
        self.write("m_motors.yml", "motors:\n" + "".join(
            f"- {{name: {n}_motor, joint: {n}, type: {n}, maxEffort: 4, maxSpeed: 2, p: 10}}\n"
            for n in names[:3]))
        self.write("m_poses.yml", "poses:\n- {name: bent, joints: {PID: 0.5}}\n")
        self.write("s.smurfs", "entities:\n- {name: M, file: m.smurf, anchor: world, pose: bent}\n")
        lines = self.lines(reader.BUILD / "mujoco_actuators", self.write_scene("s.smurfs", "mjcf"))
        self.assertEqual([line[2] for line in lines if line[0] == "stand"], ["1"])
        found = {line[1]: [float(n) for n in line[2:]] for line in lines if line[0] == "actuator"}
        self.assertEqual(set(found), {"M/PID_motor", "M/DC_motor", "M/direct_effort_motor",
                                      "M/transmitted"})
        for name, (still, moved, force) in found.items():
            self.assertLess(abs(still), 1e-6, name)
            self.assertGreater(moved, 0.1, name)
            if name != "M/direct_effort_motor":  # its command is its force
                self.assertEqual(force, 3 if name == "M/transmitted" else 4)

    @reader.needs_built("mujoco_actuators")
    def test_bitmasks_and_what_is_seen(self):
        self.write("b.urdf", f'<robot name="b"><link name="l">{BODY}<collision name="low"><geometry>'
                   '<box size="1 1 1"/></geometry></collision><collision name="high"><geometry>'
                   '<box size="1 1 1"/></geometry></collision></link></robot>')
        self.write("b.smurf", "modelname: b\nfiles: [b.urdf, b_collision.yml]\n")
        self.write("b_collision.yml", "collision:\n- {name: high, link: l, bitmask: 6, cfriction1: 0.3}\n")
        lines = self.lines(reader.BUILD / "mujoco_actuators", self.write_scene("b.smurf", "mjcf"))
        geoms = {line[1]: line[2:] for line in lines if line[0] == "geom"}
        self.assertEqual(geoms, {"b/low": ["0", "65535", "0.8"], "b/high": ["0", "6", "0.3"]})

    @reader.needs_built("mujoco_actuators")
    def test_viewers_show_every_body(self):
        """The viewers of MuJoCo show the groups 0 to 2, so collisions are in 3 only beside a visual that is written."""
        link = ('<link name="{0}">' + BODY + '<visual name="{0}_look"><geometry>{1}</geometry></visual>'
                '<collision name="{0}_hull"><geometry><box size="1 1 1"/></geometry></collision></link>')
        self.write("v.urdf", '<robot name="v">' + link.format("seen", '<box size="1 1 1"/>')
                   + link.format("unread", '<mesh filename="gone.dae"/>')
                   + '<joint name="j" type="fixed"><parent link="seen"/><child link="unread"/></joint></robot>')
        self.write("s.smurfs", "entities:\n- {name: V, type: urdf, file: v.urdf}\n" + "".join(
            f"- {{name: {kind}, type: primitive, geometry: {{type: {kind}}}, extend: {{x: 0.1, y: 0.5, z: 0.5}}}}\n"
            for kind in ("box", "sphere", "cylinder", "capsule", "plane")))
        lines = self.lines(reader.BUILD / "mujoco_actuators", self.write_scene("s.smurfs", "mjcf", "--force"))
        groups = [(line[1], int(line[2])) for line in lines if line[0] == "geom"]
        self.assertEqual(dict(groups), {"V/seen_look": 2, "V/seen_hull": 3, "V/unread_hull": 0, "box": 0, "sphere": 0,
                                        "cylinder": 0, "capsule": 0, "plane": 0})

    @reader.needs_built("mujoco_poses")
    @reader.needs_built("sdf_poses")
    def test_a_scene_without_settings_is_the_same_world_to_all(self):
        """Readers have defaults of their own; with the 10 ms of MARS, many robots are unstable in MuJoCo."""
        self.write("s.smurfs", "entities:\n- {name: B, type: primitive, geometry: {type: box}}\n")
        for form, program in {"sdf": "sdf_poses", "sdf1.6": "sdf_poses", "mjcf": "mujoco_poses"}.items():
            lines = self.lines(reader.BUILD / program, self.write_scene("s.smurfs", form))
            settings = {line[0]: [float(n) for n in line[1:]] for line in lines if line[0] in ("gravity", "step")}
            self.assertEqual(settings, {"gravity": [0, 0, -9.81], "step": [0.001]}, form)


class Losses(SimulatorTest):
    def losses(self, form, *arguments):
        done = self.run_tool("zoo.smurfs", "--format", form, "-o", "out", "--report", "json=r.json",
                             *arguments)
        report = json.loads(self.read("r.json"))
        return done.returncode, [d["message"] for d in report["diagnostics"]
                                 if d["id"].startswith("SML82")]

    def test_losses_have_names(self):
        code, losses = self.losses("urdf")
        self.assertEqual(code, 0)
        self.assertIn("start positions (`One`, `Four`) are not in the URDF",
                      losses)
        self.assertIn("the gravity is not in the URDF", losses)
        self.assertEqual(self.losses("json"), (0, []))

    def test_a_start_position_becomes_the_zero(self):
        """No reader of SDF starts a joint at a position, so commands and limits are relative to the start."""
        for form, name in {"sdf": "SDF", "sdf1.6": "SDF 1.6"}.items():
            _, losses = self.losses(form)
            self.assertIn(f"start positions (`One`, `Four`) are something else in the {name}: they become the zero of the "
                          "joints, and limits are shifted accordingly", losses)
            axis = ElementTree.parse(self.folder / "out").getroot().find(".//model[@name='Four']/joint[@name='arm_joint']/axis")
            self.assertEqual([float(axis.findtext(f"limit/{end}")) for end in ("lower", "upper")], [-1 - 0.7, 2 - 0.7])
        self.write("zoo.smurfs", ZOO_SCENE.replace(", pose: bent", ""))
        self.assertNotIn("start positions", " ".join(self.losses("sdf")[1]))

    def test_strict_refuses(self):
        code, losses = self.losses("sdf", "--fail-on-loss")
        self.assertEqual(code, 1)
        self.assertIn("the joint `turn` is free to move, since Gazebo before Harmonic ignores `mimic`, in the SDF",
                      losses)
        self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    reader.main()
