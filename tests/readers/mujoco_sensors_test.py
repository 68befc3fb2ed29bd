# SPDX-License-Identifier: BSD-3-Clause
"""mjcf: sensors, cameras and textures of a model, as libmujoco loads them at the start of the scene."""
import json
import math
import re
import struct
import zlib
import xml.etree.ElementTree as ElementTree

import frames
import reader

BODY = ('<inertial><mass value="1"/><inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/>'
        '</inertial>')
URDF = """<robot name="seer">
<link name="base">""" + BODY + """<collision><geometry><box size="1 1 1"/></geometry></collision></link>
<link name="head">""" + BODY + """</link>
<joint name="neck" type="revolute"><parent link="base"/><child link="head"/><origin xyz="0 0 1" rpy="0.1 0.2 0.3"/>
  <axis xyz="0 0 1"/><limit lower="-2" upper="2" effort="5" velocity="1"/></joint>
<link name="lens"/>
<joint name="mount" type="fixed"><parent link="head"/><child link="lens"/><origin xyz="0.1 0 0" rpy="0 0.5 0"/></joint>
<link name="foot">""" + BODY + """</link>
<joint name="ankle" type="fixed"><parent link="base"/><child link="foot"/><origin xyz="0 0 -1"/></joint>
<gazebo reference="lens">
  <sensor name="eye" type="camera"><pose>1 2 3 0.1 0.2 0.3</pose><update_rate>30</update_rate>
    <camera><horizontal_fov>1.2</horizontal_fov><image><width>800</width><height>600</height></image>
      <clip><near>0.1</near></clip></camera></sensor>
  <sensor name="far" type="ray"><pose>0 0 0.5 0 0 0.25</pose><ray><scan><horizontal><samples>1</samples></horizontal></scan>
    <range><max>30</max></range></ray></sensor>
  <sensor name="fan" type="ray"><ray><scan><horizontal><samples>9</samples><min_angle>-1</min_angle>
    <max_angle>1</max_angle></horizontal></scan></ray></sensor>
  <visual><cast_shadows>0</cast_shadows></visual>
</gazebo>
<gazebo reference="head"><sensor name="balance" type="imu"><pose>0.1 0 0 0 0 1.5</pose></sensor></gazebo>
<gazebo reference="ankle"><sensor name="weight" type="force_torque"/></gazebo>
<gazebo reference="neck"><sensor name="pull" type="force_torque"><force_torque>
  <measure_direction>parent_to_child</measure_direction></force_torque></sensor></gazebo>
</robot>
"""
MODEL = "modelname: seer\nfiles: [seer.urdf, seer_all.yml]\n"
ANNOTATIONS = """motors:
- {name: neck_motor, joint: neck, type: PID, maxEffort: 4, maxSpeed: 3, p: 10}
sensors:
- {name: eye, type: CameraSensor, link: lens, width: 10, height: 10, opening_width: 10}
- {name: view, type: CameraSensor, link: head, rate: 40, width: 640, height: 480, opening_width: 60, opening_height: 45,
   position_offset: {x: 0.03, y: 0, z: 0.08}, orientation_offset: {roll: 0, pitch: 30, yaw: 90}}
- {name: wide, type: CameraSensor, link: head, width: 200, height: 100, opening_angle: 90}
- {name: imu, type: NodeIMU, id: [head]}
- {name: step, type: Joint6DOF, link: foot}
- {name: angle, type: JointPosition, link: head, joints: [neck], rate: 10}
- {name: speed, type: JointVelocity, link: head, id: [neck]}
- {name: effort, type: JointTorque, link: head, id: [neck]}
- {name: place, type: NodePosition, id: [head, lens]}
- {name: turn, type: NodeRotation, id: [head]}
- {name: way, type: NodeVelocity, id: [head]}
- {name: spin, type: NodeAngularVelocity, id: [head]}
- {name: nothing, type: JointPosition, link: head, id: [mount]}
- {name: touch, type: NodeContact, link: head, collisions: [c]}
- {name: scan, type: RotatingRaySensor, link: head}
- {name: ray, type: RaySensor, link: head, max_distance: 7, draw_rays: true}
- {name: rays, type: RaySensor, link: head, width: 3}
poses:
- {name: bent, joints: {neck_motor: 0.5}}
"""
SCENE = """entities:
- {name: One, file: seer.smurf, pose: bent, anchor: world, position: [1, 2, 3], rotation: [10, 20, 30]}
- {name: Two, file: seer.smurf, anchor: world, position: [5, 0, 0]}
"""
FORWARD, LEFT, UP = range(3)


class MujocoSensorTest(reader.ReaderTest):
    def setUp(self):
        super().setUp()
        for name, text in (("seer.urdf", URDF), ("seer.smurf", MODEL), ("seer_all.yml", ANNOTATIONS),
                           ("seer.smurfs", SCENE)):
            self.write(name, text)

    def measured(self):
        """(kind, name) -> numbers."""
        file = self.write_scene("seer.smurfs", "mjcf")
        lines = [line.split("\t") for line in
                 self.read_with(reader.BUILD / "mujoco_sensors", file).splitlines()]
        return {(kind, name): [float(n) for n in numbers] for kind, name, *numbers in lines}

    def link(self, name, entity="One"):
        instance = next(i for i in self.flat("seer.smurfs")["instances"] if i["path"] == entity)
        pose = instance["links"][name]
        return pose["position"], [pose["orientation"][c] for c in "wxyz"]

    def assert_mount(self, found, link, xyz, rpy, axes):
        """`axes`: for each column of MuJoCo's rotation, the axis of the sensor and its sign."""
        position, rotation = frames.compose(self.link(link), (xyz, frames.from_rpy(*rpy)))
        self.assertLess(math.dist(found[:3], position), 1e-9)
        columns = frames.columns(rotation)
        for column, (axis, sign) in enumerate(axes):
            actual = found[3 + column:12:3]
            self.assertLess(math.dist(actual, [sign * c for c in columns[axis]]), 1e-9)

    @reader.needs_built("mujoco_sensors")
    def test_cameras_look_where_those_of_the_model_do(self):
        measured = self.measured()
        axes = [(LEFT, -1), (UP, 1), (FORWARD, -1)]  # right, up, backward
        eye = measured["camera", "One/eye"]
        self.assert_mount(eye, "lens", [1, 2, 3], [0.1, 0.2, 0.3], axes)
        self.assertAlmostEqual(math.tan(math.radians(eye[12]) / 2), math.tan(0.6) * 600 / 800)
        view = measured["camera", "One/view"]
        self.assert_mount(view, "head", [0.03, 0, 0.08], [0, math.radians(30), math.radians(90)], axes)
        self.assertEqual(view[12], 45)
        wide = measured["camera", "One/wide"]
        self.assert_mount(wide, "head", [0, 0, 0], [0, 0, 0], axes)
        self.assertAlmostEqual(math.tan(math.radians(wide[12]) / 2), 0.5)
        self.assertEqual(len([kind for kind, _ in measured if kind == "camera"]), 6)

    @reader.needs_built("mujoco_sensors")
    def test_sites_are_where_the_sensors_are(self):
        measured = self.measured()
        same = [(FORWARD, 1), (LEFT, 1), (UP, 1)]
        self.assert_mount(measured["site", "One/balance"], "head", [0.1, 0, 0], [0, 0, 1.5], same)
        self.assert_mount(measured["site", "One/imu"], "head", [0, 0, 0], [0, 0, 0], same)
        self.assert_mount(measured["site", "One/weight"], "foot", [0, 0, 0], [0, 0, 0], same)
        self.assert_mount(measured["site", "One/step"], "foot", [0, 0, 0], [0, 0, 0], same)
        # A ray goes along z: x of the site is down, z forward.
        forward = [(UP, -1), (LEFT, 1), (FORWARD, 1)]
        self.assert_mount(measured["site", "One/far"], "lens", [0, 0, 0.5], [0, 0, 0.25], forward)
        self.assert_mount(measured["site", "One/ray"], "head", [0, 0, 0], [0, 0, 0], forward)

    @reader.needs_built("mujoco_sensors")
    def test_values(self):
        measured = self.measured()
        values = {name.removeprefix("One/"): numbers[1:] for (kind, name), numbers in measured.items()
                  if kind == "sensor" and name.startswith("One/")}
        self.assertEqual(set(values), {
            *(f"{imu}/{part}" for imu in ("balance", "imu")
              for part in ("acceleration", "angular_velocity", "orientation")),
            *(f"{wrench}/{part}" for wrench in ("weight", "step") for part in ("force", "torque")),
            "far", "ray", "angle/neck", "speed/neck", "effort/neck", "place/head", "place/lens", "turn/head",
            "way/head", "spin/head"})
        self.assertEqual(values["angle/neck"], [0.5])
        for name in ("speed/neck", "effort/neck"):  # the motor of the joint
            self.assertAlmostEqual(values[name][0], 0)
        head = self.link("head")
        self.assertLess(math.dist(values["place/head"], head[0]), 1e-9)
        self.assertLess(math.dist(values["place/lens"], self.link("lens")[0]), 1e-9)
        for name, turned in (("turn/head", head[1]), ("imu/orientation", head[1]),
                             ("balance/orientation",
                              frames.multiply(head[1], frames.from_rpy(0, 0, 1.5)))):
            self.assertLess(frames.apart(([0] * 3, values[name]), ([0] * 3, turned)), 1e-9)
        # The foot hangs on the ankle and pulls with its weight, in the axes of the foot.
        foot = self.link("foot")[1]
        weight = frames.rotate(frames.conjugate(foot), [0, 0, -9.81])
        for name in ("weight/force", "step/force"):
            self.assertLess(min(math.dist(values[name], [s * c for c in weight]) for s in (1, -1)), 1e-6)

    def test_cutoff(self):
        root = ElementTree.fromstring(self.write_scene("seer.smurfs", "mjcf").read_text())
        self.assertEqual([e.get("cutoff") for e in root.iter("rangefinder")], ["30", "7", "30", "7"])

    def losses(self, *arguments):
        self.run_tool("seer.smurfs", "--format", "mjcf", "-o", "out.xml", "--report", "json=r.json", *arguments)
        return [d["message"] for d in json.loads(self.read("r.json"))["diagnostics"]
                if d["id"].startswith("SML82")]

    def test_what_is_not_measured_is_named(self):
        losses = "\n".join(self.losses())
        # lost: the second eye (the URDF has one), nothing, touch, scan and rays
        self.assertIn("5 sensors", losses)
        gazebo = re.search(r"elements in <gazebo> \((.*)\) are not in the MJCF", losses)[1]
        self.assertEqual(gazebo, "`update_rate of eye`, `image of eye`, `clip of eye`, `fan`, `visual`, `pull`")
        self.assertIn("7 sensor settings", losses)  # rate, width, height and draw_rays

    def test_annotations_of_a_model_that_is_named_are_lost(self):
        """MuJoCo then reads the URDF, which has no motors and sensors of SMURF."""
        losses = "\n".join(self.losses("--form", "reference"))
        self.assertIn("1 motor, 17 sensors", losses)


def png(width, height):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    rows = b"".join(b"\0" + b"\xff\0\0" * width for _ in range(height))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


class MujocoTextureTest(reader.ReaderTest):
    SHAPE = '<visual name="{name}"><geometry><box size="1 1 1"/></geometry>{material}</visual>'

    def setUp(self):
        super().setUp()
        self.write("bark.png", png(4, 2))
        self.write("textures/leaf.PNG", png(3, 3))
        self.write("photo.jpg", b"no PNG")
        materials = {
            "own": '<material name="bark"><texture filename="bark.png"/></material>',
            "painted": '<material name="m"><color rgba="0.25 0.5 1 1"/><texture filename="bark.png"/></material>',
            "named": '<material name="leaf"/>', "photo": '<material name="photo"/>',
            "gone": '<material name="gone"><texture filename="gone.png"/></material>', "plain": ""}
        self.write("tree.urdf", '<robot name="tree"><material name="leaf"><texture filename="textures/leaf.PNG"/>'
                   '</material><material name="photo"><texture filename="photo.jpg"/></material><link name="l">' +
                   "".join(self.SHAPE.format(name=n, material=m) for n, m in materials.items()) + "</link></robot>")

    def textures(self, *arguments):
        file = self.write_scene("tree.urdf", "mjcf", "--force", *arguments)
        lines = [line.split("\t") for line in
                 self.read_with(reader.BUILD / "mujoco_sensors", file).splitlines()]
        return {line[1].removeprefix("tree/"): list(map(float, line[2:])) for line in lines if line[0] == "texture"}

    @reader.needs_built("mujoco_sensors")
    def test_pictures(self):
        expected = {"own": [4, 2, 1, 1, 1], "painted": [4, 2, 0.25, 0.5, 1], "named": [3, 3, 1, 1, 1]}
        self.assertEqual(self.textures(), expected)
        self.assertEqual(self.textures("--copy-assets", "copies"), expected)

    def test_others_are_lost(self):
        done = self.run_tool("tree.urdf", "--format", "mjcf", "--force", "-o", "out.xml")
        self.assertIn("textures (`photo.jpg`, `gone.png`) are not in the MJCF", done.stderr)


if __name__ == "__main__":
    reader.main()
