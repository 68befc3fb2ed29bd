# SPDX-License-Identifier: BSD-3-Clause
"""MJCF: what moves in MuJoCo. Heights of terrain, neighbours, floors, friction, fixed bases, groups of an OBJ."""
import struct
import zlib

import reader

BODY = ('<inertial><origin xyz="{at}"/><mass value="1"/>'
        '<inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial>')
# The box of `arm` reaches 10 mm into that of `plate`, and 5 mm into that of `base`.
ARM = """<robot name="arm">
<link name="base">""" + BODY.format(at="0 0 0") + """
  <collision><geometry><box size="0.2 0.2 0.1"/></geometry></collision></link>
<link name="plate">""" + BODY.format(at="0 0 0") + """
  <collision><geometry><box size="0.1 0.1 0.01"/></geometry></collision></link>
<link name="arm">""" + BODY.format(at="0 0 0.1") + """
  <collision><origin xyz="0 0 0.095"/><geometry><box size="0.1 0.1 0.2"/></geometry></collision></link>
<joint name="bolt" type="fixed"><parent link="base"/><child link="plate"/><origin xyz="0 0 0.05"/></joint>
<joint name="turn" type="revolute"><parent link="{parent}"/><child link="arm"/><origin xyz="0 0 {z}"/>
  <axis xyz="0 0 1"/><limit lower="-2" upper="2" effort="5" velocity="2"/></joint>
<ros2_control name="c" type="system"><joint name="turn">
  <command_interface name="position"><param name="min">-1</param><param name="max">1</param></command_interface>
</joint></ros2_control>
</robot>
"""
LEGGED = """<robot name="legged">
<link name="trunk">""" + BODY.format(at="0 0 0") + """
  <visual><geometry><box size="0.5 0.3 0.1"/></geometry></visual>
  <collision><geometry><box size="0.5 0.3 0.1"/></geometry></collision></link>
{legs}</robot>
"""
LEG = """<link name="leg{n}">""" + BODY.format(at="0 0 -0.2") + """
  <collision><origin xyz="0 0 -0.2"/><geometry>{shape}</geometry></collision></link>
<joint name="hip{n}" type="fixed"><parent link="trunk"/><child link="leg{n}"/><origin xyz="{x} {y} 0" rpy="{tilt} 0 0"/></joint>
"""
WORLD_ROOT = """<robot name="h"><link name="world"/>
<link name="base">""" + BODY.format(at="0 0 0") + """
  <collision><geometry><box size="0.1 0.1 0.1"/></geometry></collision></link>
<joint name="mount" type="{type}"><parent link="world"/><child link="base"/><origin xyz="0 0 0.9"/></joint></robot>
"""


def png(rows, depth=8, kind=0, palette=b"", interlaced=False):
    """A PNG; a pixel is a number or a tuple of channels."""
    def chunk(name, content):
        return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))

    def lines(some):
        text = b""
        for row in some:
            values = [part for pixel in row for part in (pixel if isinstance(pixel, tuple) else (pixel,))]
            if depth < 8:
                bits = "".join(f"{value:0{depth}b}" for value in values)
                bits += "0" * (-len(bits) % 8)
                text += b"\0" + bytes(int(bits[i:i + 8], 2) for i in range(0, len(bits), 8))
            else:
                text += b"\0" + b"".join(value.to_bytes(depth // 8, "big") for value in values)
        return text
    if interlaced:
        passes = ((0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2), (0, 1, 1, 2))
        parts = ([row[x::dx] for row in rows[y::dy]] for x, y, dx, dy in passes)
        text = b"".join(lines(part) for part in parts if part and part[0])
    else:
        text = lines(rows)
    head = struct.pack(">IIBBBBB", len(rows[0]), len(rows), depth, kind, 0, 0, interlaced)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + (chunk(b"PLTE", palette) if palette else b"")
            + chunk(b"IDAT", zlib.compress(text)) + chunk(b"IEND", b""))


def terrace(low, high):
    """The half with x < 0 has the value `low`, the other half `high`."""
    return [[low] * 4 + [high] * 4 for _ in range(8)]


@reader.needs_built("mujoco_run")
class MujocoTest(reader.ReaderTest):
    def mjcf(self, source, *arguments, losses=None):
        done = self.run_tool(source, "--format", "mjcf", "-o", "out.xml", *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        for text in losses or ():
            self.assertIn(text, done.stderr)
        if losses == ():
            self.assertNotIn("warning[", done.stderr)
        return done.stderr

    def run_mujoco(self, seconds=0, command=0, places=()):
        """The lines of mujoco_run as {kind: {name: numbers}}; contacts are a list of pairs of bodies."""
        known = {"contact": [], "depth": []}
        numbers = [number for place in places for number in place]
        for line in self.read_with(reader.BUILD / "mujoco_run", self.folder / "out.xml", seconds, command,
                                   *numbers).splitlines():
            kind, name, *rest = line.split("\t")
            if kind == "contact":
                known["contact"].append((name, rest[0]))
                known["depth"].append(float(rest[1]))
            elif kind == "height":
                known.setdefault(kind, {})[(float(name), float(rest[0]))] = float(rest[1])
            else:
                known.setdefault(kind, {})[name] = [float(number) for number in rest]
        return known


class Heightmaps(MujocoTest):
    def heights(self, image, losses=None):
        self.write("h.png", image)
        self.write("s.smurfs", """entities:
- {name: t, type: heightmap, file: h.png, position: [1, 2, 3], rotation: [1, 0, 0, 0], anchor: world,
   width: 8, length: 4, height: 1.5}
""")
        said = self.mjcf("s.smurfs", losses=losses)
        if losses is None:
            self.assertNotIn("SML8211", said)
        # Between the pixels of each half: the corners of the image are those of the terrain.
        low, high = self.run_mujoco(places=[(0, 2), (2, 2)])["height"].values()
        return low - 3, high - 3

    def test_white_has_the_height_and_black_has_none(self):
        for low, high in ((0, 200), (51, 204), (0, 255), (100, 255)):
            found = self.heights(png(terrace(low, high)))
            for value, height in zip((low, high), found):
                self.assertAlmostEqual(height, 1.5 * value / 255, delta=1e-6)

    def test_one_grey(self):
        for value in (0, 51, 255):
            low, high = self.heights(png(terrace(value, value)))
            self.assertAlmostEqual(low, 1.5 * value / 255, delta=1e-6)
            self.assertAlmostEqual(high, 1.5 * value / 255, delta=1e-6)

    def test_other_kinds_of_png(self):
        grey = bytes(value for i in range(4) for value in (60 * i,) * 3)
        for image, low, high in (
                (png(terrace(0x3300, 0xcc00), 16), 0x3300 / 0xffff, 0xcc00 / 0xffff),
                (png(terrace(1, 3), 2), 1 / 3, 1), (png(terrace(0, 1), 1), 0, 1), (png(terrace(3, 12), 4), 0.2, 0.8),
                (png(terrace((40, 255), (90, 0)), 8, 4), 40 / 255, 90 / 255),
                (png(terrace((40, 40, 40), (90, 90, 90)), 8, 2), 40 / 255, 90 / 255),
                (png(terrace((40, 40, 40, 9), (90, 90, 90, 9)), 8, 6), 40 / 255, 90 / 255),
                (png(terrace(1, 3), 8, 3, grey), 60 / 255, 180 / 255),
                (png(terrace(51, 204), interlaced=True), 0.2, 0.8)):
            found = self.heights(image)
            self.assertAlmostEqual(found[0], 1.5 * low, delta=1e-6)
            self.assertAlmostEqual(found[1], 1.5 * high, delta=1e-6)

    def test_colours_are_named(self):
        low, high = self.heights(png(terrace((0, 90, 0), (100, 0, 0)), 8, 2),
                                 losses=["heightmaps in colour or out of reach (`t`) are something else in the MJCF"])
        self.assertAlmostEqual(low, 0, delta=1e-6)
        self.assertAlmostEqual(high, 1.5 * 100 / 255, delta=1e-6)

    def test_a_damaged_image_is_lost(self):
        whole = png(terrace(0, 200))
        self.write("h.png", whole[:43] + b"\xff" * 6 + whole[49:])
        self.write("s.smurfs", "entities: [{name: t, type: heightmap, file: h.png, width: 8, length: 4, height: 1.5}]\n")
        self.mjcf("s.smurfs", losses=["its heightmap `h.png` is damaged"])


class Neighbours(MujocoTest):
    def test_the_first_joint_of_a_bolted_arm_moves(self):
        for parent, z in (("base", "0.05"), ("plate", "0")):
            self.write("arm.urdf", ARM.replace("{parent}", parent).replace("{z}", z))
            for scene in ("{name: A, file: arm.urdf, anchor: world}",
                          "{name: T, file: arm.urdf, anchor: world}\n"
                          "- {name: A, file: arm.urdf, parent: 'T::arm', anchor: parent, position: [0, 0, 1]}"):
                self.write("s.smurfs", f"entities:\n- {scene}\n")
                self.mjcf("s.smurfs")
                found = self.run_mujoco(seconds=2, command=0.5)
                self.assertEqual(found["contact"], [])
                for joint in found["joint"].values():
                    self.assertAlmostEqual(joint[1], 0.5, delta=0.01)

    def test_other_bodies_still_touch(self):
        self.write("arm.urdf", ARM.replace("{parent}", "plate").replace("{z}", "0"))
        self.write("s.smurfs", """entities:
- {name: A, file: arm.urdf, anchor: world}
- {name: B, file: arm.urdf, anchor: world, position: {x: 0.05, y: 0, z: 0.15}}
""")
        self.mjcf("s.smurfs")
        self.assertIn(("B/base", "A/arm"), {pair[::-1] for pair in self.run_mujoco()["contact"]}
                      | set(self.run_mujoco()["contact"]))

    def test_the_range_of_a_command_is_that_of_the_actuator(self):
        self.write("arm.urdf", ARM.replace("{parent}", "plate").replace("{z}", "0"))
        self.mjcf("arm.urdf")
        self.assertIn('ctrlrange="-1 1"', self.read("out.xml"))
        self.assertNotIn("param", self.mjcf("arm.urdf"))


class Floor(MujocoTest):
    def legged(self, shape, tilt=0):
        legs = "".join(LEG.format(n=n, shape=shape, x=x, y=y, tilt=tilt)
                       for n, (x, y) in enumerate(((0.2, 0.1), (0.2, -0.1), (-0.2, 0.1), (-0.2, -0.1))))
        self.write("legged.urdf", LEGGED.format(legs=legs))

    def test_a_single_robot_stands_on_the_floor(self):
        self.write("leg.stl", b"\0" * 80 + struct.pack("<I", 4) + b"".join(
            struct.pack("<12fH", 0, 0, 0, *a, *b, *c, 0) for a, b, c in (
                ((0, 0, 0), (9, 0, 0), (0, 9, 0)), ((0, 0, 0), (0, 9, 0), (0, 0, -90)),
                ((0, 0, 0), (0, 0, -90), (9, 0, 0)), ((9, 0, 0), (0, 0, -90), (0, 9, 0)))))
        for shape in ('<box size="0.04 0.04 0.4"/>', '<cylinder radius="0.02" length="0.4"/>', '<sphere radius="0.05"/>',
                      '<capsule radius="0.02" length="0.3"/>', '<mesh filename="leg.stl" scale="0.005 0.005 0.005"/>'):
            for tilt in (0, 0.3):
                self.legged(shape, tilt)
                said = self.mjcf("legged.urdf", "--ground", "--fail-on-loss", losses=())
                self.assertIn("above its own frame, so that it stands on the floor", said)
                found = self.run_mujoco(seconds=0.5)
                start = found["body"]["legged/trunk"][2]
                # Pointed legs that lean topple; none is thrown.
                self.assertLess(found["body"]["legged/trunk"][5], start + 0.01, shape)
                if not tilt:
                    self.assertAlmostEqual(found["body"]["legged/trunk"][5], start, delta=0.01, msg=shape)
                self.assertLess(max(found["depth"], default=0), 1e-6, shape)
                self.assertGreater(start, 0.1)

    def test_sdf_has_the_same_height(self):
        self.legged('<box size="0.04 0.04 0.4"/>')
        done = self.run_tool("legged.urdf", "--format", "sdf", "--ground")
        self.assertIn('<pose rotation_format="quat_xyzw">0 0 0.4 0 0 0 1</pose>', done.stdout)

    def test_a_robot_above_the_floor_is_not_moved(self):
        self.write("box.urdf", '<robot name="b"><link name="l">' + BODY.format(at="0 0 0") + '<collision>'
                   '<origin xyz="0 0 1"/><geometry><box size="1 1 1"/></geometry></collision></link></robot>')
        self.assertNotIn("floor", self.mjcf("box.urdf", "--ground"))

    def test_a_scene_says_how_deep_a_robot_is(self):
        self.legged('<box size="0.04 0.04 0.4"/>')
        self.write("s.smurfs", "entities:\n- {name: R, file: legged.urdf, position: [0, 0, 0.3]}\n"
                               "- {name: S, file: legged.urdf, position: [2, 0, 0.4]}\n")
        said = self.mjcf("s.smurfs", "--ground", losses=["warning[SML8211]: `R` starts 0.1 m below the floor", "raise the entity"])
        self.assertNotIn("`S`", said)
        self.assertNotIn("below the floor", self.mjcf("s.smurfs"))

    def test_links_that_are_fixed_to_the_world_may_be_below_it(self):
        self.write("arm.urdf", ARM.replace("{parent}", "plate").replace("{z}", "0"))
        self.write("s.smurfs", "entities:\n- {name: R, file: arm.urdf, anchor: world}\n")
        self.assertNotIn("below the floor", self.mjcf("s.smurfs", "--ground"))


class Friction(MujocoTest):
    def slide(self, of_box="", of_slope=""):
        """How far a box slides down a slope of 30 degrees in a second."""
        self.write("s.smurfs", f"""entities:
- {{name: slope, type: primitive, geometry: {{type: plane}}, movable: false, position: {{x: 0, y: 0, z: 0}},
   rotation: {{w: 0.9659258, x: 0, y: 0.258819, z: 0}}{of_slope}}}
- {{name: ice, type: primitive, geometry: {{type: box}}, extend: {{x: 1, y: 1, z: 0.2}}, movable: true, mass: 1,
   position: {{x: 0.05, y: 0, z: 0.0866}}, rotation: {{w: 0.9659258, x: 0, y: 0.258819, z: 0}}{of_box}}}
""")
        self.mjcf("s.smurfs")
        body = self.run_mujoco(seconds=1)["body"]["ice/link"]
        return sum((a - b) ** 2 for a, b in zip(body[:3], body[3:])) ** 0.5

    def test_a_small_friction_has_an_effect(self):
        self.assertLess(self.slide(), 0.01)
        self.assertGreater(self.slide(", cfriction1: 0.05"), 1)
        self.assertGreater(self.slide(of_slope=", cfriction1: 0.05"), 1)
        self.assertGreater(self.slide(", cfriction1: 0.05", ", cfriction1: 0.05"), 1)
        self.assertLess(self.slide(", cfriction1: 0.9"), 0.01)


class Bases(MujocoTest):
    def height(self, type_, *arguments, scene=None):
        self.write("h.urdf", WORLD_ROOT.format(type=type_))
        if scene:
            self.write("s.smurfs", scene)
        self.said = self.mjcf("s.smurfs" if scene else "h.urdf", *arguments)
        return self.run_mujoco(seconds=0.2)["body"][f"{'R' if scene else 'h'}/base"]

    def test_a_root_called_world_stays(self):
        base = self.height("fixed")
        self.assertAlmostEqual(base[5], 0.9, delta=1e-6)
        self.assertIn("roots named `world` without an anchor (`h`)", self.said)
        base = self.height("fixed", scene="entities: [{name: R, file: h.urdf, position: [0, 0, 1]}]\n")
        self.assertAlmostEqual(base[5], 1.9, delta=1e-6)

    def test_a_scene_and_an_option_may_free_it(self):
        self.assertLess(self.height("fixed", "--base", "floating")[5], 0.8)
        self.assertNotIn("roots named", self.said)
        free = self.height("fixed", scene="entities: [{name: R, file: h.urdf, anchor: none}]\n")
        self.assertLess(free[5], 0.8)
        self.assertNotIn("roots named", self.said)

    def test_a_floating_joint_below_the_world_is_free(self):
        self.assertLess(self.height("floating")[5], 0.8)
        self.assertNotIn("SML8206", self.said)

    def test_any_base_can_be_fixed(self):
        self.write("b.urdf", '<robot name="b"><link name="l">' + BODY.format(at="0 0 0") + "</link></robot>")
        self.mjcf("b.urdf")
        self.assertLess(self.run_mujoco(seconds=0.2)["body"]["b/l"][5], -0.1)
        self.mjcf("b.urdf", "--base", "fixed")
        self.assertEqual(self.run_mujoco(seconds=0.2)["body"]["b/l"][5], 0)


class Meshes(MujocoTest):
    def faces(self, obj):
        self.write("m.obj", obj)
        self.write("m.urdf", '<robot name="m"><link name="l"><collision><geometry><mesh filename="m.obj"/></geometry>'
                             "</collision></link></robot>")
        self.mjcf("m.urdf", losses=())
        return [mesh[0] for mesh in self.run_mujoco()["mesh"].values()]

    def test_all_groups_of_an_obj(self):
        cap = "v 0 0 0\nv 1 0 0\nv 0 1 0\n{}f 1 3 2\n{}v 0 0 1\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"
        for first, second in (("", ""), ("o cap\n", "o rest\n"), ("g cap\n", "g rest\n"), ("", "g rest\n"),
                              ("o whole\ng first\n", "")):
            self.assertEqual(self.faces(cap.format(first, second)), [4], (first, second))


if __name__ == "__main__":
    reader.main()
