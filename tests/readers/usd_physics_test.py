# SPDX-License-Identifier: BSD-3-Clause
"""usda: computes with a reader of our own what a simulator would load.

OpenUSD's own checks are in no registry that the tests install from. previews_test gives the same stages to a
reader of others.
"""
import json
import math

import frames
import reader
import simulators_test
from usd_stage import Robot, Stage, differences

BODY = ('<inertial><origin xyz="0.1 0.2 0.3" rpy="0.4 0.5 0.6"/><mass value="{m}"/><inertia ixx="0.02"'
        ' iyy="0.03" izz="0.04" ixy="0.001" ixz="0.002" iyz="-0.003"/></inertial>')
# Every kind of joint, axes in all directions, chains of massless frames and of mimic joints.
KINDS = """<robot name="kinds">
<link name="base">""" + BODY.format(m=3) + """<visual name="hull"><geometry><box size="1 2 3"/></geometry></visual>
  <collision name="bumper"><geometry><mesh filename="m.stl" scale="1 2 3"/></geometry></collision></link>
<link name="shape_1"/><link name="tool tip"/>
<joint name="flange" type="fixed"><parent link="base"/><child link="shape_1"/><origin xyz="1 0 0" rpy="0 0 1"/></joint>
<joint name="tip" type="fixed"><parent link="shape_1"/><child link="tool tip"/><origin xyz="0 1 0" rpy="1 0 0"/></joint>
<link name="a">""" + BODY.format(m=2) + """<collision name="pad"><geometry><sphere radius="0.5"/></geometry></collision></link>
<joint name="a" type="revolute"><parent link="tool tip"/><child link="a"/><origin xyz="0 0 1" rpy="0.5 0 0"/>
  <axis xyz="-1 0 0"/><limit lower="-3.5" upper="1" effort="5" velocity="2"/><dynamics damping="0.5" friction="0.1"/></joint>
<link name="b">""" + BODY.format(m=1) + """</link>
<joint name="b" type="revolute"><parent link="a"/><child link="b"/><axis xyz="-0.6 0 -0.8"/>
  <limit lower="-3" upper="3" effort="0" velocity="0"/><mimic joint="a" multiplier="-2" offset="0.25"/></joint>
<link name="c">""" + BODY.format(m=1) + """</link>
<joint name="c" type="continuous"><parent link="b"/><child link="c"/><axis xyz="0 -3 0"/><mimic joint="b" multiplier="0.5"
  offset="-1"/></joint>
<link name="d">""" + BODY.format(m=1) + """</link>
<joint name="d" type="prismatic"><parent link="a"/><child link="d"/><axis xyz="0.00000001 0 -1"/>
  <limit lower="-0.5" upper="2" effort="7" velocity="0.5"/></joint>
<link name="e">""" + BODY.format(m=1) + """</link>
<joint name="e" type="prismatic"><parent link="d"/><child link="e"/><mimic joint="c"/><limit lower="0" upper="1" effort="1"
  velocity="1"/></joint>
<link name="f">""" + BODY.format(m=1) + """</link>
<joint name="f" type="planar"><parent link="base"/><child link="f"/><origin xyz="1 2 3" rpy="1 0 0"/><axis xyz="0 1 0"/></joint>
<link name="g">""" + BODY.format(m=1) + """</link>
<joint name="g" type="floating"><parent link="base"/><child link="g"/><origin xyz="3 2 1"/></joint>
<link name="h">""" + BODY.format(m=1) + """</link>
<joint name="h" type="fixed"><parent link="a"/><child link="h"/><origin xyz="0 0 0.5" rpy="0 1 0"/></joint>
</robot>
"""
MODEL = "modelname: kinds\nfiles: [kinds.urdf, kinds_all.yml]\n"
ANNOTATIONS = """motors:
- {name: motor, joint: a, type: PID, maxEffort: 4, maxSpeed: 3, p: 10}
- {name: wheel, joint: d, type: DC, maxEffort: 6, maxSpeed: 2}
collision:
- {name: bumper, link: base, cfriction1: 0.25}
- {name: pad, link: a, cfriction1: 0.75}
poses:
- {name: bent, joints: {a: 0.5, d: 0.25}}
"""
SCENE = """entities:
- {name: One, file: kinds.smurf, position: [1, 2, 3], rotation: [10, 20, 30], pose: bent}
- {name: Two, file: kinds.smurf, parent: "One::tool tip", anchor: parent, position: [0, 1, 0], rotation: [0, -90, 0]}
- {name: Three, file: kinds.smurf, anchor: world, position: [9, 9, 9], rotation: [1, 2, 3]}
- {name: Ball, type: primitive, geometry: {type: sphere}, position: {x: 2, y: 0, z: 3}, mass: 4, cfriction1: 0.5}
- {name: Floor, type: primitive, geometry: {type: plane}, movable: false}
"""
TRIANGLE = """solid m
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 0 1 0
endloop
endfacet
endsolid m
"""
LIGHTS = """lights:
- {name: sun, directional: true, position: {x: 1, y: 2, z: 3}, lookat: {x: 3, y: 3, z: 1}}
- {name: sun, type: 1, position: {x: 0, y: 0, z: 5}, lookat: {x: 0, y: 0, z: 6}, diffuse: {r: 1, g: 0, b: 1, a: 1}}
- {name: "a spot", type: 2, position: {x: -1, y: 0, z: 2}, lookat: {x: -1, y: 0, z: 1}, angle: 40, exponent: 3}
entities:
- {name: lights, type: primitive, geometry: {type: box}}
"""
FILES = {"zoo.urdf": simulators_test.ZOO, "zoo.smurf": simulators_test.ZOO_MODEL,
         "zoo_poses.yml": simulators_test.ZOO_POSES, "zoo.smurfs": simulators_test.ZOO_SCENE,
         "kinds.urdf": KINDS, "kinds.smurf": MODEL, "kinds_all.yml": ANNOTATIONS, "kinds.smurfs": SCENE,
         "m.stl": TRIANGLE, "lit.smurfs": LIGHTS}


class UsdPhysicsTest(reader.ReaderTest):
    def setUp(self):
        super().setUp()
        for name, text in FILES.items():
            self.write(name, text)

    def stage(self, scene="kinds.smurfs"):
        return Stage(self.write_scene(scene, "usda").read_text())

    def robot_of(self, flat):
        models = {model["id"]: model for model in flat["models"]}
        return lambda instance: Robot(self.folder / models[instance["model"]]["urdf"])

    def test_frames_masses_and_limits_are_those_of_the_urdf(self):
        for scene in [*reader.SCENES.values(), "zoo.smurfs", "kinds.urdf"]:
            flat = self.flat(scene)
            self.assertEqual(differences(self.stage(scene), flat, self.robot_of(flat)), [], scene)

    def test_motors_have_their_own_limits(self):
        flat = self.flat("kinds.smurfs")
        problems = differences(self.stage(), flat, self.robot_of(flat))
        unit = math.degrees(1)
        for path in ("One", "Two", "Three"):
            for problem in (f"a: physxJoint:maxJointVelocity is {3 * unit} instead of {2 * unit}",
                            "a: drive:angular:physics:maxForce is 4.0 instead of 5.0",
                            "d: physxJoint:maxJointVelocity is 2.0 instead of 0.5",
                            "d: drive:linear:physics:maxForce is 6.0 instead of 7.0"):
                problems.remove(f"{path}: {problem}")
        self.assertEqual(problems, [])

    def drive(self, joint, kind):
        prim = self.stage().prims["World/One/joints/" + joint]
        prefix = f"drive:{kind}:physics:"
        self.assertIn("PhysicsDriveAPI:" + kind, prim["apiSchemas"])
        return {key[len(prefix):]: value if key.endswith("type") else float(value)
                for key, value in prim.items() if key.startswith(prefix)}

    def assert_drive(self, found, **expected):
        self.assertEqual(found.pop("type"), '"force"')
        self.assertEqual(set(found), set(expected))
        for key, value in expected.items():
            self.assertAlmostEqual(found[key], value, delta=1e-9, msg=key)

    def test_drives(self):
        # Full effort at a tenth of the largest speed: 10 * 4 / 3 N m s/rad, and 10 times that per rad.
        speed = 10 * 4 / 3
        self.assert_drive(self.drive("a", "angular"), stiffness=math.radians(10 * speed),
                          damping=math.radians(speed + 0.5), maxForce=4,
                          targetPosition=math.degrees(0.5))
        self.assert_drive(self.drive("d", "linear"), stiffness=0, damping=10 * 6 / 2, maxForce=6)
        self.assert_drive(self.drive("b", "angular"), stiffness=0, damping=0)
        motors = {path: json.loads(prim["smurf:motor"]) for path, prim in self.stage().prims.items()
                  if "smurf:motor" in prim and path.startswith("World/One/")}
        self.assertEqual(motors, {"World/One/joints/a": "motor", "World/One/joints/d": "wheel"})

    def test_start_positions(self):
        starts = {path: float(value) for path, prim in self.stage().prims.items()
                  for key, value in prim.items() if key.startswith("state:")}
        self.assertNotIn("World/Two/joints/a", starts)  # at zero
        self.assertAlmostEqual(starts["World/One/joints/a"], math.degrees(0.5))
        self.assertAlmostEqual(starts["World/One/joints/b"], math.degrees(-2 * 0.5 + 0.25))
        self.assertAlmostEqual(starts["World/One/joints/d"], 0.25)

    def test_followers(self):
        """position + gearing * position of the leader + offset = 0, and no leader follows another."""
        prims = self.stage().prims
        follower = "physxMimicJoint:rotX:"
        for joint, multiplier, offset in (("b", -2, 0.25), ("c", -1, 0.5 * 0.25 - 1)):
            prim = prims["World/One/joints/" + joint]
            self.assertIn("PhysxMimicJointAPI:rotX", prim["apiSchemas"])
            self.assertEqual((prim[follower + "referenceJoint"], prim[follower + "referenceJointAxis"]),
                             ("World/One/joints/a", '"rotX"'))
            self.assertAlmostEqual(float(prim[follower + "gearing"]), -multiplier)
            self.assertAlmostEqual(float(prim[follower + "offset"]), -math.degrees(offset))
        self.assertNotIn("PhysxMimicJointAPI:rotX", prims["World/One/joints/e"]["apiSchemas"])
        done = self.run_tool("kinds.urdf", "--format", "usda", "-o", "out.usda")
        self.assertIn("the joint `e` is free to move, since there is no moving leader of the same kind, in the "
                      "USD", done.stderr)

    def test_articulations_and_anchors(self):
        """Robots that are fixed to each other are one articulation, in which each does not collide with itself."""
        stage = self.stage()
        self.assertEqual(stage.having("PhysicsArticulationRootAPI"), ["World/One", "World/Three"])
        self.assertEqual([stage.prims[path]["physxArticulation:enabledSelfCollisions"] for path in ("World/One", "World/Three")],
                         ["1", "0"])
        groups = [path for path, prim in stage.prims.items() if prim["type"] == "PhysicsCollisionGroup"]
        self.assertEqual(groups, ["World/One/joints/own_collisions", "World/Two/joints/own_collisions"])
        for path in groups:
            group = stage.prims[path]
            self.assertEqual((group["collection:colliders:includes"], group["physics:filteredGroups"]),
                             (path.removesuffix("/joints/own_collisions"), path))
        self.assertNotIn("World/One/joints/anchor", stage.prims)
        two = stage.prims["World/Two/joints/anchor"]
        self.assertEqual((two["type"], two["physics:body0"], two["physics:body1"]),
                         ("PhysicsFixedJoint", "World/One/base", "World/Two/base"))
        self.assertNotIn("physics:excludeFromArticulation", two)
        three = stage.prims["World/Three/joints/anchor"]
        self.assertEqual((three["type"], three.get("physics:body0"), three["physics:body1"]),
                         ("PhysicsFixedJoint", None, "World/Three/base"))
        for name in ("Two", "Three"):
            first, second = stage.joint_frames(f"World/{name}/joints/anchor")
            self.assertLess(math.dist(first[0], second[0]), 1e-9)
            self.assertGreater(abs(sum(a * b for a, b in zip(first[1], second[1]))), 1 - 1e-12)

    def test_colliders(self):
        stage = self.stage()
        solids = {path: stage.prims[path] for path in stage.having("PhysicsCollisionAPI")
                  if not path.startswith(("World/Two", "World/Three"))}
        self.assertEqual(set(solids), {"World/One/base/collision_1", "World/One/a/shape_1",
                                       "World/Ball/shape_1", "World/Floor/shape_1"})
        mesh = solids["World/One/base/collision_1"]
        self.assertIn("PhysicsMeshCollisionAPI", mesh["apiSchemas"])
        self.assertEqual((mesh["physics:approximation"], mesh["purpose"], mesh["references"]),
                         ('"convexHull"', '"guide"', "Meshes/m"))
        self.assertEqual(json.loads(mesh["smurf:name"]), "bumper")
        self.assertNotIn("purpose", solids["World/One/a/shape_1"])  # there is no visual
        self.assertNotIn("PhysicsCollisionAPI", stage.prims["World/One/base/shape_1"]["apiSchemas"])
        for path, friction in (("World/One/base/collision_1", 0.25), ("World/One/a/shape_1", 0.75),
                               ("World/Ball/shape_1", 0.5)):
            material = stage.prims[solids[path]["material:binding:physics"]]
            self.assertEqual({float(material[f"physics:{kind}Friction"]) for kind in ("static", "dynamic")},
                             {friction})

    def test_primitives(self):
        stage = self.stage()
        ball = stage.prims["World/Ball"]
        self.assertEqual(ball["apiSchemas"], ["PhysicsRigidBodyAPI", "PhysicsMassAPI"])
        self.assertEqual(float(ball["physics:mass"]), 4)
        self.assertEqual(stage.prims["World/Floor"]["apiSchemas"], [])

    def test_impossible_inertias(self):
        """Moments of 0 are computed from shapes; all others are kept."""
        self.write("thin.urdf", KINDS.replace('ixx="0.02" iyy="0.03" izz="0.04"', 'ixx="0" iyy="0" izz="0"')
                   .replace('ixy="0.001" ixz="0.002" iyz="-0.003"', 'ixy="0" ixz="0" iyz="0"'))
        stage = Stage(self.write_scene("thin.urdf", "usda", "--force").read_text())
        self.assertEqual(stage.numbers("World/kinds/base", "physics:diagonalInertia"), [3.25, 2.5, 1.25])
        self.write("flat.urdf", KINDS.replace('izz="0.04"', 'izz="9"'))
        flat = self.flat_forced("flat.urdf")
        stage = Stage(self.write_scene("flat.urdf", "usda", "--force").read_text())
        self.assertEqual(differences(stage, flat, self.robot_of(flat)), [])

    def flat_forced(self, scene):
        done = self.run_tool(scene, "--links", "--quiet", "--force")
        return json.loads(done.stdout)

    def test_lights(self):
        stage = self.stage("lit.smurfs")
        for name, kind, place, direction in (
                ("sun", "DistantLight", [1, 2, 3], [2 / 3, 1 / 3, -2 / 3]),
                ("sun_2", "SphereLight", [0, 0, 5], [0, 0, 1]),
                ("a_spot", "SphereLight", [-1, 0, 2], [0, 0, -1])):
            path = "World/lights_2/" + name
            self.assertEqual(stage.prims[path]["type"], kind)
            position, rotation = stage.pose(path)
            self.assertEqual(position, place)
            self.assertLess(math.dist(frames.rotate(rotation, [0, 0, -1]), direction), 1e-12)
        self.assertEqual(stage.numbers("World/lights_2/sun_2", "inputs:color"), [1, 0, 1])
        spot = stage.prims["World/lights_2/a_spot"]
        self.assertEqual((spot["apiSchemas"], spot["inputs:shaping:cone:angle"], spot["inputs:shaping:focus"]),
                         (["ShapingAPI"], "40", "3"))

    def test_gravity(self):
        scene = self.stage("zoo.smurfs").prims["Physics"]
        self.assertEqual(scene["type"], "PhysicsScene")
        self.assertAlmostEqual(float(scene["physics:gravityMagnitude"]), math.hypot(0.5, 3))
        self.assertEqual(self.stage().prims["Physics"]["physics:gravityMagnitude"], "9.81")


if __name__ == "__main__":
    reader.main()
