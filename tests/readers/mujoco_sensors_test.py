# SPDX-License-Identifier: BSD-3-Clause
"""mjcf: sensors, cameras and textures of a model, as libmujoco loads them at the start of the scene."""
import json
import math
import pathlib
import re
import struct
import zlib
import xml.etree.ElementTree as ElementTree

import frames
import reader

HERE = pathlib.Path(__file__).resolve().parent
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
            "far", "ray", *(f"fan/{i}" for i in range(9)), *(f"rays/{i}" for i in range(3)), "angle/neck", "speed/neck", "effort/neck", "place/head", "place/lens", "turn/head",
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
        self.assertEqual({e.get("name"): e.get("cutoff") for e in root.iter("rangefinder")
                          if e.get("name").split("/")[-1] in ("far", "ray", "0")},
                         {"One/far": "30", "One/fan/0": None, "One/ray": "7", "One/rays/0": "100",
                          "Two/far": "30", "Two/fan/0": None, "Two/ray": "7", "Two/rays/0": "100"})

    def losses(self, *arguments):
        self.run_tool("seer.smurfs", "--format", "mjcf", "-o", "out.xml", "--report", "json=r.json", *arguments)
        return ["\n".join([d["message"], *d.get("notes", [])]) for d in json.loads(self.read("r.json"))["diagnostics"]
                if d["id"].startswith("SML82")]

    def test_what_is_not_measured_is_named(self):
        losses = "\n".join(self.losses())
        # lost: the second eye (it is also in the URDF), nothing, touch (there is no such collision) and scan (11520
        # rays)
        self.assertIn("4 sensors", losses)
        gazebo = re.search(r"elements in <gazebo> \((.*)\) are not in the MJCF", losses)[1]
        self.assertEqual(gazebo, "`update_rate of eye`, `image of eye`, `clip of eye`, `visual`, `pull`")
        self.assertIn("7 sensor settings", losses)  # rate, width, height and draw_rays

    @reader.needs_built("mujoco_sensors")
    def test_torques_of_motors_that_options_add(self):
        """A joint without a motor has no torque to measure, until an option gives it a motor."""
        start = ANNOTATIONS.index("sensors:")
        self.write("seer_all.yml", ANNOTATIONS[start:ANNOTATIONS.index("poses:")])
        self.write("seer.smurfs", SCENE.replace("pose: bent, ", ""))
        found = {}
        for kind in ("none", "auto"):
            arguments = ["--actuator", kind] if kind != "none" else []
            file = self.write_scene("seer.smurfs", "mjcf", *arguments)
            found[kind] = [line.split("\t") for line in
                           self.read_with(reader.BUILD / "mujoco_sensors", file, "1").splitlines()
                           if line.startswith("sensor\tOne/effort")]
        self.assertEqual(found["none"], [])
        self.assertEqual([line[1] for line in found["auto"]], ["One/effort/neck"])
        self.assertIn("5 sensors", "\n".join(self.losses()))
        self.assertIn("4 sensors", "\n".join(self.losses("--actuator", "auto")))

    def test_annotations_of_a_model_that_is_named_are_lost(self):
        """MuJoCo then reads the URDF, which has no motors and sensors of SMURF."""
        losses = "\n".join(self.losses("--form", "reference"))
        self.assertIn("1 motor, 17 sensors", losses)


class MujocoScansAndContacts(reader.ReaderTest):
    """A robot of 2 kg stands on two feet before a wall, whose near side is at x = 2.9 m."""
    FOOT = ('<link name="{0}"><inertial><mass value="0.5"/><inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/>'
            '</inertial><collision name="{0}_sole"><origin xyz="0 0 0.1"/><geometry><box size="0.4 0.2 0.2"/></geometry>'
            '</collision></link><joint name="{0}_leg" type="fixed"><parent link="base"/><child link="{0}"/>'
            '<origin xyz="0 {1} 0"/></joint>')
    URDF = ('<robot name="r"><link name="base">' + BODY + "</link>" + FOOT.format("left", 0.3) + FOOT.format("right", -0.3) +
            '<link name="head"/><joint name="neck" type="fixed"><parent link="base"/><child link="head"/>'
            '<origin xyz="0 0 0.5"/></joint><gazebo reference="head"><sensor name="fan" type="gpu_lidar"><lidar><scan>'
            "<horizontal><samples>3</samples><min_angle>-0.5</min_angle><max_angle>0.5</max_angle></horizontal>"
            "<vertical><samples>2</samples><min_angle>-0.25</min_angle><max_angle>0</max_angle></vertical></scan>"
            '<range><max>30</max></range></lidar></sensor><sensor name="many" type="ray"><ray><scan><horizontal>'
            "<samples>1001</samples><min_angle>-1</min_angle><max_angle>1</max_angle></horizontal></scan></ray></sensor>"
            '<sensor name="aside" type="ray"><ray><scan><horizontal><samples>1</samples><min_angle>1</min_angle>'
            "<max_angle>1</max_angle></horizontal></scan></ray></sensor></gazebo>"
            '<gazebo reference="left"><sensor name="step" type="contact"><contact><collision>left_sole</collision></contact>'
            '</sensor></gazebo><gazebo reference="head"><sensor name="bump" type="contact"/></gazebo></robot>')
    SENSORS = """sensors:
- {name: turning, type: RotatingRaySensor, link: head, lasers: 2, opening_height: 0.25, vertical_offset: 0.125,
   opening_width: 1, horizontal_resolution: 0.5}
- {name: turned, type: RotatingRaySensor, link: head, lasers: 2, opening_height: 0.25, vertical_offset: 0.125,
   opening_width: 1, horizontal_resolution: 0.5, rotation_offset: {roll: 0, pitch: 0, yaw: 180}, max_distance: 12}
- {name: line, type: RaySensor, link: head, width: 2, opening_width: 1}
- {name: levels, type: MultiLevelLaserRangeFinder, link: head, numRaysHorizontal: 2, horizontalOpeningAngle: 0.5,
   numRaysVertical: 2, verticalOpeningAngle: 0.5}
- {name: soles, type: NodeContactForce, link: base, collisions: [left_sole, right_sole]}
- {name: foot, type: NodeContact, link: right, id: [right]}
"""
    SCENE = """entities:
- {name: R, type: smurf, file: r.smurf, position: [0, 0, 0]}
- {name: Wall, type: primitive, geometry: {type: box}, position: {x: 3, y: 0, z: 0.5}, extend: {x: 0.2, y: 20, z: 4},
   movable: false}
- {name: Ground, type: primitive, geometry: {type: plane}, position: {x: 0, y: 0, z: 0}, extend: {x: 20, y: 20, z: 1},
   movable: false}
"""

    def setUp(self):
        super().setUp()
        self.write("r.urdf", self.URDF)
        self.write("r.smurf", "modelname: r\nfiles: [r.urdf, r.yml]\n")
        self.write("r.yml", self.SENSORS)
        self.write("s.smurfs", self.SCENE)

    def check(self, *command):
        def read(file, steps):
            lines = [line.split("\t") for line in self.read_with(*command, file, str(steps)).splitlines()]
            return {line[1].removeprefix("R/"): [float(n) for n in line[3:]] for line in lines if line[0] == "sensor"}

        file = self.write_scene("s.smurfs", "mjcf")
        start = read(file, 0)
        ground = 0.5 / math.sin(0.25)

        def wall(across, up=0):
            return 2.9 / math.cos(across) / math.cos(up)

        expected = {"fan": [ground] * 3 + [wall(0.5), 2.9, wall(0.5)],
                    "turning": [ground] * 2 + [wall(0.5)] * 2,
                    "turned": [ground] * 2 + [-1] * 2,  # MuJoCo: -1 means none
                    "line": [wall(0.25)] * 2,
                    "levels": [ground] * 2 + [wall(0.5, 0.25), wall(0, 0.25)]}
        for name, distances in expected.items():
            for i, distance in enumerate(distances):
                self.assertAlmostEqual(start[f"{name}/{i}"][0], distance, places=6, msg=f"{name}/{i}")
        self.assertEqual({name.split("/")[0] for name in start}, {*expected, "step", "soles", "foot"})
        standing = read(file, 2000)
        for name in ("step", "soles/left", "soles/right", "foot"):
            self.assertAlmostEqual(standing[name][0], 9.81, delta=0.01, msg=name)

    @reader.needs_built("mujoco_sensors")
    def test_distances_and_weight(self):
        self.check(reader.BUILD / "mujoco_sensors")

    @reader.needs_npm("@mujoco/mujoco")
    def test_later_versions(self):
        self.check("node", HERE / "mujoco_sensors.mjs", reader.NODE_MODULES)

    def test_too_many_rays_are_a_loss(self):
        done = self.run_tool("s.smurfs", "--format", "mjcf", "-o", "out.xml")
        self.assertIn("`many`, `aside`, `bump`", done.stderr)


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
