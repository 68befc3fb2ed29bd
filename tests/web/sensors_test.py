# SPDX-License-Identifier: BSD-3-Clause
"""Tests the sensors on the page of a scene: their places, and the corners and rays of their views.

Usage: sensors_test.py TOOL BUILD
"""
import math

import viewer
from viewer import cli, set_positions

# A camera and an IMU of Gazebo, and a laser with one level.
URDF = """<robot name="r"><link name="base"><visual><geometry><box size="2 1 2"/></geometry></visual></link><link name="head"/>
<joint name="neck" type="revolute"><parent link="base"/><child link="head"/><origin xyz="0.5 0 0.25" rpy="0 0 0.5"/>
<axis xyz="0 1 0"/><limit lower="-2" upper="2" effort="1" velocity="1"/></joint>
<gazebo reference="head"><sensor name="eye" type="camera"><pose>0.1 0.2 0.3 0.1 -0.2 0.3</pose><camera>
<horizontal_fov>1.2</horizontal_fov><image><width>400</width><height>300</height></image>
<clip><near>0.25</near><far>0.75</far></clip></camera><update_rate>30</update_rate></sensor>
<material>Gazebo/Red</material></gazebo>
<gazebo reference="base"><sensor name="balance" type="imu"/><sensor name="laser" type="ray"><pose>0 0 1 0 0 0</pose><ray><scan>
<horizontal><samples>3</samples><min_angle>-0.5</min_angle><max_angle>1</max_angle></horizontal></scan>
<range><min>0.1</min><max>1.25</max></range></ray></sensor></gazebo>
<gazebo reference="neck"><sensor name="wrench" type="force_torque"/></gazebo></robot>"""
SENSORS = """sensors:
- {name: view, type: CameraSensor, link: head, width: 640, height: 480, opening_width: 60, opening_height: 40, rate: 50,
   position_offset: {x: 1, y: 0, z: 0}, orientation_offset: {roll: 0, pitch: 90, yaw: 0}}
- {name: single, type: RaySensor, link: head, max_distance: 0.5}
- {name: fan, type: RaySensor, link: head, width: 4, opening_width: 1, max_distance: 0.5}
- {name: spin, type: RotatingRaySensor, link: base, lasers: 2, opening_width: 1, opening_height: 0.4, vertical_offset: 0.3,
   max_distance: 1, horizontal_resolution: 0.5, rotation_offset: {roll: 0, pitch: 0, yaw: 90}}
- {name: levels, type: MultiLevelLaserRangeFinder, link: base, numRaysHorizontal: 2, numRaysVertical: 1,
   horizontalOpeningAngle: 1.5, verticalOpeningAngle: 0, maxDistance: 1}
- {name: places, type: NodePosition, id: [base, head]}
- {name: angles, type: JointPosition, id: [neck]}
- {name: fish, type: CameraSensor, link: base, opening_width: 200}
"""
SCENE = "entities:\n- {name: R, file: r.smurf, position: [1, 2, 3], rotation: [0, 0, 90]}\n"
# By name: the place of a sensor in the picture, and the ends of its lines.
READ = """Object.fromEntries((({ all, lines }) => {
  const points = lines.geometry.getAttribute("position").array;
  let next = 0;
  return all.map(({ sensor, drawing, entity, link, local }) => {
    const first = 3 * next;
    next += drawing.ends.length;
    return [`${sensor.name} ${link}`, {
      world: smurfViewer.motion.links[entity][link].clone().multiply(local).elements, points: [...points.slice(first, 3 * next)] }];
  });
})(smurfViewer.overlays.sensors))"""
FOCUSED = "document.activeElement.textContent"


def turn(axis, angle):
    a, b = [(1, 2), (2, 0), (0, 1)][axis]
    matrix = [[float(i == j) for j in range(4)] for i in range(4)]
    matrix[a][a] = matrix[b][b] = math.cos(angle)
    matrix[b][a] = math.sin(angle)
    matrix[a][b] = -matrix[b][a]
    return matrix


def product(*matrices):
    first, *rest = matrices
    for other in rest:
        first = [[sum(first[i][k] * other[k][j] for k in range(4)) for j in range(4)] for i in range(4)]
    return first


def pose(x, y, z, roll=0, pitch=0, yaw=0):
    matrix = product(turn(2, yaw), turn(1, pitch), turn(0, roll))
    for row, value in zip(matrix, (x, y, z)):
        row[3] = value
    return matrix


def at(matrix, point):
    return [sum(a * b for a, b in zip(row, (*point, 1))) for row in matrix[:3]]


def ray(across, up, length):
    return [length * math.cos(up) * math.cos(across), length * math.cos(up) * math.sin(across), length * math.sin(up)]


BASE = pose(1, 2, 3, yaw=math.pi / 2)
HEAD = product(BASE, pose(0.5, 0, 0.25, yaw=0.5), turn(1, 0.7))


class SensorsTest(viewer.ViewerTest):
    def setUp(self):
        super().setUp()
        self.write("r.urdf", URDF)
        self.write("sensors.yml", SENSORS)
        self.write("r.smurf", "modelname: r\nfiles: [r.urdf, sensors.yml]\n")
        self.write("s.smurfs", SCENE)

    def assert_drawn(self, read, world, points):
        """The sensor is at `world`, and has lines to `points`, which are given in its frame."""
        flat = [world[row][column] for column in range(4) for row in range(4)]
        self.assert_close(read["world"], flat, "the pose")
        found = [read["points"][i:i + 3] for i in range(0, len(read["points"]), 3)]
        for point in points:
            expected = at(world, point)
            gap = min(math.dist(one, expected) for one in found)
            self.assertLess(gap, 2e-6, f"no line ends at {expected}")
        return [math.dist(one, [row[3] for row in world[:3]]) for one in found]

    def test_fields_of_view_are_where_the_numbers_say(self):
        page = self.page("s.smurfs")
        read = self.browse({"page": page, "steps": ["smurfViewer.press('sensors')", set_positions(0, {"neck": 0.7}), READ]})[0]["results"][2]
        eye = product(HEAD, pose(0.1, 0.2, 0.3, 0.1, -0.2, 0.3))
        y = math.tan(0.6)
        corners = [(d, sy * d * y, sz * d * y * 0.75) for d in (0.25, 0.75) for sy in (1, -1) for sz in (1, -1)]
        self.assert_drawn(read["eye 1"], eye, corners)

        view = product(HEAD, pose(1, 0, 0, pitch=math.pi / 2))
        reach = 0.6 * 3  # of the diagonal of the box: this camera has no range
        corners = [(reach, sy * reach * math.tan(math.radians(30)), sz * reach * math.tan(math.radians(20)))
                   for sy in (1, -1) for sz in (1, -1)]
        self.assert_drawn(read["view 1"], view, corners)

        laser = product(BASE, pose(0, 0, 1))
        rays = [ray(angle, 0, length) for angle in (-0.5, 0.25, 1) for length in (0.1, 1.25)]
        lengths = self.assert_drawn(read["laser 0"], laser, rays)
        self.assertAlmostEqual(max(lengths), 1.25, 5)

        single = self.assert_drawn(read["single 1"], HEAD, [(0.5, 0, 0)])
        self.assertEqual(sum(length > 0.4 for length in single), 1)
        # The rays of MARS are a fourth of the opening apart.
        fan = self.assert_drawn(read["fan 1"], HEAD, [ray((i - 1.5) / 4, 0, 0.5) for i in range(4)])
        self.assertAlmostEqual(max(fan), 0.5, 5)
        spin = product(BASE, turn(2, math.pi / 2))
        self.assert_drawn(read["spin 0"], spin, [ray(across, up, 1) for across in (-0.5, 0.5) for up in (-0.1, -0.5)])
        self.assert_drawn(read["levels 0"], BASE, [(1, 0, 0), ray(-1.5, 0, 1)])

        for name, world in (("balance 0", BASE), ("wrench 1", HEAD), ("places 0", BASE), ("places 1", HEAD), ("fish 0", BASE)):
            self.assertLess(max(self.assert_drawn(read[name], world, [])), 0.3, name)
        self.assertEqual(len(read), 12)

    def test_sensors_are_switched_selected_and_named_with_the_keyboard(self):
        shown = "[smurfViewer.overlays.sensors.group.visible, document.getElementById('sensors').getAttribute('aria-pressed')]"
        facts = "document.getElementById('facts').textContent"
        labels = "[...document.querySelectorAll('.labels span')].map((label) => label.textContent)"
        chosen = """(({ all, lines }) => {
          const colors = lines.geometry.getAttribute("color").array;
          let next = 0;
          return all.filter(({ drawing }) => {
            const first = 3 * next;
            next += drawing.ends.length;
            return colors[first] > 0.9;
          }).map(({ sensor }) => sensor.name);
        })(smurfViewer.overlays.sensors)"""
        steps = [shown, {"key": "r"}, shown, {"key": "r"}, shown, {"key": "n"}, labels,
                 "document.querySelector('[role=treeitem]').focus()", *[{"key": "ArrowDown"}] * 2, FOCUSED, {"key": "Enter"},
                 shown, chosen, facts, labels, "smurfViewer.select(0, 1)", chosen, facts,
                 "smurfViewer.select(0, 1, undefined, smurfViewer.scene.models[0].sensors.find(({ name }) => name === 'eye'))", facts,
                 "document.getElementById('unseen').textContent", {"axe": True}, "location.hash"]
        results = self.browse({"page": self.page("s.smurfs"), "steps": steps})[0]["results"]
        self.assertEqual([results[0], results[2], results[4]], [[False, "false"], [True, "true"], [False, "false"]])
        self.assertEqual(results[6], ["base", "head"])
        self.assertEqual(results[10], "balanceimu in <gazebo>")
        self.assertEqual(results[12], [True, "true"])
        self.assertEqual(results[13], ["balance"])
        self.assertIn("On the linkbase", results[14])
        self.assertLess({"eye", "balance", "places", "head"}, set(results[15]))
        self.assertEqual(results[17], ["eye", "wrench", "view", "single", "fan", "places"])
        self.assertIn("Sensoreye (camera in <gazebo>)", results[18])
        for fact in ("Field of view68.755° wide, 54.325° high", "Nearest0.25 m", "Farthest0.75 m"):
            self.assertIn(fact, results[20])
        self.assertNotIn("Drawn", results[20])
        self.assertIn("2 sensors", results[21])
        self.assertIn("angles (JointPosition): it is on no link", results[21])
        self.assertIn("fish (CameraSensor): its field of view is not a rectangle", results[21])
        self.assertNotIn("grey box", self.visible(results[21]))
        self.assertEqual(results[22], [])
        self.assertIn("link=head", results[23])

    @staticmethod
    def visible(text):
        return text.replace("A grey box stands for a shape of known size.", "")

    def test_hidden_sensors_cost_nothing_and_many_are_drawn_in_less_detail(self):
        lidars = "".join(f"- {{name: s{i}, type: RotatingRaySensor, link: base}}\n" for i in range(57))  # and four of Gazebo
        ends = "smurfViewer.overlays.sensors.all.at(-1).drawing.ends.length"
        steps = ["smurfViewer.overlays.sensors.lines ?? null", "smurfViewer.select(0, 0)", "smurfViewer.press('sensors')", ends]
        counts = []
        for text in (lidars, lidars[:lidars.index("- {name: s56")]):
            self.write("sensors.yml", "sensors:\n" + text)
            results = self.browse({"page": self.page("s.smurfs"), "steps": steps})[0]["results"]
            self.assertIsNone(results[0])
            counts.append(results[3])
        self.assertLess(4 * counts[0], counts[1])

    def test_losses_name_what_is_not_shown(self):
        done = self.run_tool("s.smurfs", "--format", "html", "-o", "page.html")
        self.assertIn("elements in <gazebo> (`update_rate of eye`, `material`) are not in the HTML", done.stderr)
        self.assertIn(": 1 sensor\n", done.stderr)
        self.assertIn("also lost: 1 sensor setting\n", done.stderr)

    def test_hostile_sensors_are_drawn_or_left_out(self):
        hostile = '<img src=x onerror="window.hacked=1">'
        self.write("sensors.yml", "sensors:\n" + "".join(f"- {sensor}\n" for sensor in (
            viewer.json.dumps({"name": hostile, "type": hostile, "link": "head"}),
            "{name: huge, type: RotatingRaySensor, link: base, lasers: 2000000000, opening_width: 1.0e+300, max_distance: .inf}",
            "{name: none, type: RaySensor, link: base, width: -3, opening_width: .nan, max_distance: -1}",
            "{name: flat, type: CameraSensor, link: base, opening_width: 0}", "{name: lost, type: CameraSensor, link: nowhere}",
            "{type: NodeIMU, link: base}", "{name: __proto__, type: constructor, joint: neck}")))
        self.write("r.urdf", URDF.replace("<min_angle>-0.5", "<min_angle>1e300").replace("<far>0.75", "<far>-1"))
        steps = ["smurfViewer.press('sensors'), smurfViewer.press('names')", READ, "document.images.length",
                 "[...document.querySelectorAll('.labels span')].map((label) => label.textContent)"]
        results = self.browse({"page": self.page("s.smurfs"), "steps": steps})[0]["results"]
        self.assertTrue(all(math.isfinite(number) for one in results[1].values() for number in one["points"]))
        self.assertEqual(results[2], 0)
        self.assertIn(hostile, results[3])
        self.assertIn("NodeIMU, without name", results[3])


if __name__ == "__main__":
    viewer.main()
