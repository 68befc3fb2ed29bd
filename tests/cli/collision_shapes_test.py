# SPDX-License-Identifier: BSD-3-Clause
"""--collision of smurfs-flatten and smurf2urdf: the shapes contain the meshes, the volumes that are told are true, and nothing
else of a robot changes.

Called with both tools: collision_shapes_test.py SMURFS_FLATTEN SMURF2URDF.

The meshes are brackets: a block of 3 x 2 x 1 with a slot of 1 x 1 x 1, so that the volumes of the hull, of the box and of the
parts are known. In place of CoACD and meshoptimizer, modules of their names do their work.
"""
import itertools
import json
import math
import pathlib
import random
import re
import struct
import sys
import unittest
import xml.etree.ElementTree as ElementTree

import cli

TO_URDF = None
RING = [(0, 0), (3, 0), (3, 2), (2, 2), (2, 1), (1, 1), (1, 2), (0, 2)]
VOLUME, BOX = 5, 6
SHAPES = ("hull", "boxes", "capsules", "parts", "lighter")
INSIDE = 1e-6
COACD = '''
import os, signal
class Mesh:
    pass
def run_coacd(mesh, threshold, max_convex_hull, seed, preprocess_mode):
    print("a line on standard output")
    mode = os.environ.get("FAKE_COACD", "")
    if mode == "fails": raise RuntimeError("no")
    if mode == "crashes": os.kill(os.getpid(), signal.SIGSEGV)
    if mode == "mumbles": os._exit(0)
    points, faces = mesh.vertices, mesh.indices
    assert max_convex_hull == 32 and max(map(max, faces)) == len(points) - 1
    def volume(a, b, c):
        return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
    assert sum(volume(*(points[i] for i in face)) for face in faces) > 0, "the mesh is inside out"
    low, high = [[pick(p[i] for p in points) for i in range(3)] for pick in (min, max)]
    def block(begin, end):
        ends = [[a + (b - a) * part for a, b, part in zip(low, high, parts)] for parts in (begin, end)]
        return [[ends[x][0], ends[y][1], ends[z][2]] for x in (0, 1) for y in (0, 1) for z in (0, 1)], None
    third = 1 / 3
    return [block((0, 0, 0), (third, 1, 1)), block((third, 0, 0), (2 * third, 0.5, 1)), block((2 * third, 0, 0), (1, 1, 1))]
'''

#: As much of NumPy as the script uses.
NUMPY = '''
float32, uint32 = float, int
class Array(list):
    def reshape(self, _): return Array(x for row in self for x in row)
    def copy(self): return Array(self)
    def tolist(self): return list(self)
    def __getitem__(self, key):
        found = list.__getitem__(self, key)
        return Array(found) if isinstance(key, slice) else found
def zeros(count, dtype): return Array([0] * count)
def ascontiguousarray(rows, dtype): return Array(rows)
'''
#: A bracket becomes the box around it.
MESHOPTIMIZER = '''
import os
def simplify(result, indices, places, target_index_count, target_error):
    assert target_index_count == 0 and target_error == 0.001, (target_index_count, target_error)
    mode = os.environ.get("FAKE_MESHOPTIMIZER", "")
    if mode == "fails": raise RuntimeError("no")
    if mode == "mumbles": os._exit(0)
    found = list(indices)
    if mode != "spares":
        ends = [sorted({p[i] for p in places}) for i in range(3)]
        corner = lambda i: [list(p) for p in places].index([ends[k][-1 if i >> k & 1 else 0] for k in range(3)])
        faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
        found = [corner(i) for a, b, c, d in faces for i in (a, b, c, a, c, d)]
    result[:len(found)] = found
    return len(found)
'''


def bracket():
    """Points and triangles, which face outward."""
    points = [(x, y, z) for z in (0, 1) for x, y in RING]
    n = len(RING)
    cap = [(0, 1, 4), (0, 4, 5), (0, 5, 7), (5, 6, 7), (1, 2, 3), (1, 3, 4)]
    faces = [(a, c, b) for a, b, c in cap] + [(a + n, b + n, c + n) for a, b, c in cap]
    for i in range(n):
        k = (i + 1) % n
        faces += [(i, k, k + n), (i, k + n, i + n)]
    return points, faces


def stl_of(points, faces):
    body = b"".join(struct.pack("<12fH", 0, 0, 0, *points[a], *points[b], *points[c], 0) for a, b, c in faces)
    return b" " * 80 + struct.pack("<I", len(faces)) + body


def obj_of(points, faces):
    return "".join("v {} {} {}\n".format(*p) for p in points) + "".join("f {} {} {}\n".format(*(i + 1 for i in f)) for f in faces)


TENSOR = '<inertia ixx="0.2" iyy="0.3" izz="0.4" ixy="0.01" ixz="0" iyz="0"/>'
URDF = f"""<robot name="bot">
  <link name="base">
    <inertial><origin xyz="0.1 0 0"/><mass value="2"/>{TENSOR}</inertial>
    <collision name="foot">
      <origin xyz="0.5 -1 2" rpy="0.3 -0.2 1.1"/>
      <geometry>
        <mesh filename="meshes/bracket.stl" scale="0.1 0.1 0.1"/>
      </geometry>
    </collision>
  </link>
  <link name="finger_left">
    <inertial><mass value="1"/>{TENSOR}</inertial>
    <collision><geometry><mesh scale="-0.1 0.2 0.05" filename="meshes/bracket.stl"/></geometry></collision>
    <collision name="pad"><geometry><box size="0.1 0.2 0.3"/></geometry></collision>
    <collision name="pin"><origin xyz="1 0 0"/><geometry><mesh filename="meshes/bracket.obj" scale="0.1 0.1 0.1"/></geometry></collision>
  </link>
  <link name="finger_right">
    <inertial><mass value="1"/></inertial>
    <collision name="tip"><geometry><mesh filename="meshes/bracket.stl" scale="0.1 0.1 0.1"/></geometry></collision>
  </link>
  <link name="plate">
    <inertial><mass value="1"/>{TENSOR}</inertial>
    <collision name="sheet"><geometry><mesh filename="meshes/sheet.obj"/></geometry></collision>
  </link>
""" + "".join(f"""  <joint name="j_{child}" type="revolute"><parent link="base"/><child link="{child}"/><origin xyz="{i} 1 3" rpy="0 0.5 0"/>
    <axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="5" velocity="2"/></joint>
""" for i, child in enumerate(("finger_left", "finger_right", "plate"))) + """  <gazebo reference="base">
    <sensor name="bump" type="contact"><contact><collision>base_fixed_joint_lump__foot_collision</collision></contact></sensor>
  </gazebo>
</robot>
"""
#: link, number of the collision, scale
MESHES = {("base", 0): (0.1, 0.1, 0.1), ("finger_left", 0): (-0.1, 0.2, 0.05), ("finger_left", 2): (0.1, 0.1, 0.1),
          ("finger_right", 0): (0.1, 0.1, 0.1)}


def numbers(text):
    return [float(word) for word in text.split()]


class Frame:
    """A pose of URDF."""

    def __init__(self, element):
        origin = element.find("origin")
        get = (lambda key: numbers(origin.get(key, "0 0 0"))) if origin is not None else lambda key: [0, 0, 0]
        self.at, (r, p, y) = get("xyz"), get("rpy")
        cr, sr, cp, sp, cy, sy = math.cos(r), math.sin(r), math.cos(p), math.sin(p), math.cos(y), math.sin(y)
        self.turn = [[cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
                     [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr], [-sp, cp * sr, cp * cr]]

    def out(self, p):
        return [sum(row[i] * p[i] for i in range(3)) + at for row, at in zip(self.turn, self.at)]

    def into(self, p):
        d = [a - b for a, b in zip(p, self.at)]
        return [sum(self.turn[k][i] * d[k] for k in range(3)) for i in range(3)]


class Hull:
    """The half-spaces of the triangles of an OBJ."""

    def __init__(self, text):
        self.points = [numbers(line[2:]) for line in text.splitlines() if line.startswith("v ")]
        faces = [[int(i) - 1 for i in line[2:].split()] for line in text.splitlines() if line.startswith("f ")]
        self.sides = []
        for a, b, c in ([self.points[i] for i in face] for face in faces):
            u, v = [[q - p for p, q in zip(a, other)] for other in (b, c)]
            n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
            size = math.sqrt(sum(x * x for x in n))
            n = [x / size for x in n]
            self.sides.append((n, sum(x * y for x, y in zip(n, a))))

    def outside(self, p):
        return max(sum(x * y for x, y in zip(n, p)) - d for n, d in self.sides)


def outside(shape, p, folder):
    """How far a point is outside of the shape, in its frame."""
    if shape.tag == "box":
        return max(abs(x) - size / 2 for x, size in zip(p, numbers(shape.get("size"))))
    if shape.tag == "mesh":
        assert shape.get("scale") is None, "the scale is in the mesh"
        return Hull((folder / shape.get("filename")).read_text()).outside(p)
    length = float(shape.get("length", 0))
    radius = float(shape.get("radius"))
    if shape.tag == "cylinder":
        return max(math.hypot(p[0], p[1]) - radius, abs(p[2]) - length / 2)
    return math.dist(p, (0, 0, max(-length / 2, min(length / 2, p[2])))) - radius


class CollisionShapesTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.leave_repository()
        points, faces = bracket()
        self.write("meshes/bracket.stl", stl_of(points, faces))
        self.write("meshes/bracket.obj", obj_of(points, faces))
        self.write("meshes/sheet.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n")
        self.write("bot.urdf", URDF)
        for module, text in {"coacd": COACD, "numpy": NUMPY, "meshoptimizer": MESHOPTIMIZER}.items():
            self.write(f"modules/{module}.py", text)
        self.environment = {"PYTHONPATH": str(self.folder / "modules")}
        self.flatten, self.to_urdf = cli.TOOL, TO_URDF
        self.addCleanup(setattr, cli, "TOOL", cli.TOOL)

    def convert(self, tool, *arguments, code=0, **environment):
        cli.TOOL = tool
        done = self.run_tool("bot.urdf", *arguments, environment={**self.environment, **environment})
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def written(self):
        return sorted(str(path.relative_to(self.folder)) for path in self.folder.rglob("*") if path.is_file())

    def links(self, path):
        return {link.get("name"): link for link in ElementTree.parse(self.folder / path).getroot().findall("link")}

    def shapes_for(self, links, link, number, made):
        """The collisions of the result in place of one: the first in its place, the others at the end of the link."""
        before = len(self.links("bot.urdf")[link].findall("collision"))
        collisions = links[link].findall("collision")
        more = collisions[before:]
        if len(self.links("bot.urdf")[link].findall("collision")) > 1:  # two meshes, the first one first
            half = len(more) // 2
            more = more[:half] if number == 0 else more[half:]
        self.assertEqual(len(more) + 1, made)
        return [collisions[number], *more]

    def test_shapes_contain_the_meshes(self):
        points = bracket()[0]
        for shapes in SHAPES:
            with self.subTest(shapes):
                (self.folder / shapes).mkdir()
                self.convert(self.to_urdf, "--collision", shapes, "-o", f"{shapes}/out.urdf")
                links = self.links(f"{shapes}/out.urdf")
                before = self.links("bot.urdf")
                for (link, number), scale in MESHES.items():
                    frame = Frame(before[link].findall("collision")[number])
                    made = {"hull": 1, "boxes": 1, "parts": 3, "capsules": 3, "lighter": 1}[shapes]  # URDF 1.0 has no capsules
                    collisions = self.shapes_for(links, link, number, made)
                    for point in points:
                        in_link = frame.out([x * s for x, s in zip(point, scale)])
                        gap = min(outside(each.find("geometry")[0], Frame(each).into(in_link), self.folder / shapes)
                                  for each in collisions)
                        self.assertLessEqual(gap, INSIDE, (link, number, point))
                pad = links["finger_left"].findall("collision")[1]
                self.assertEqual(pad.find("geometry/box").get("size"), "0.1 0.2 0.3")
                self.assertEqual(links["plate"].find("collision/geometry/mesh").get("filename"), "../meshes/sheet.obj")

    def test_nothing_else_of_a_urdf_changes(self):
        def rest(path):
            root = ElementTree.parse(self.folder / path).getroot()
            for link in root.findall("link"):
                for collision in link.findall("collision"):
                    link.remove(collision)
            for sensor in root.iter("contact"):
                sensor[:] = sensor[:1]
            return re.sub(r"\s+", " ", ElementTree.tostring(root, encoding="unicode"))
        for shapes in SHAPES:
            self.convert(self.to_urdf, "--collision", shapes, "-o", "out.urdf")
            self.assertEqual(rest("out.urdf"), rest("bot.urdf"), shapes)

    def test_names_are_unique_and_contact_sensors_know_all_parts(self):
        self.convert(self.to_urdf, "--collision", "parts", "-o", "out.urdf")
        root = ElementTree.parse(self.folder / "out.urdf").getroot()
        names = [each.get("name") for each in root.iter("collision") if each.get("name")]
        self.assertEqual(len(names), len(set(names)), names)
        self.assertEqual([each.text for each in root.find("gazebo").iter("collision")],
                         ["base_fixed_joint_lump__foot_collision", "base_fixed_joint_lump__foot_part_2_collision_1",
                          "base_fixed_joint_lump__foot_part_3_collision_2"])
        sdf = self.convert(self.flatten, "--collision", "parts", "-o", "out.sdf")
        sdf = ElementTree.parse(self.folder / "out.sdf").getroot()
        link = next(link for link in sdf.iter("link") if link.get("name") == "base")
        self.assertEqual([each.text for each in link.find("sensor/contact").iter("collision")],
                         [each.get("name") for each in link.findall("collision")])

    def test_equal_meshes_share_a_file(self):
        (self.folder / "out").mkdir()
        self.convert(self.to_urdf, "--collision", "hull", "-o", "out/bot.urdf")
        files = [path for path in self.written() if path.startswith("out/")]
        # bracket.stl has two sizes; bracket.obj is another file.
        self.assertEqual(files, ["out/bot.urdf", "out/bot_collisions/bracket_hull.obj", "out/bot_collisions/bracket_hull_2.obj",
                                 "out/bot_collisions/bracket_hull_3.obj"])

    def test_volumes_are_told(self):
        for shapes, words in {"hull": "the convex hull; 16 vertices become 8, volume +20 %",
                              "boxes": "a box around 16 vertices, volume +20 %",
                              "lighter": "a lighter mesh; 16 vertices become 8, volume +20 %",
                              "parts": "3 convex parts; 16 vertices become 24, volume +0 %"}.items():
            for tool in (self.to_urdf, self.flatten):
                done = self.convert(tool, "--collision", shapes, "-o", "out.urdf", "--report", "json=report.json")
                found = [one for one in json.loads(self.read("report.json"))["diagnostics"] if one["id"] == "SML8213"]
                self.assertEqual(len(found), 3, found)
                for one in found:
                    self.assertIn(words, one["message"])
                    self.assertEqual(one["severity"], "info")
                self.assertIn("(in 2 collisions)", found[0]["message"])
                self.assertEqual({one["line"] for one in found}, {7, 13, 15})

    def test_told_volumes_of_capsules_are_true(self):
        self.convert(self.to_urdf, "--collision", "*=keep", "--collision", "base=capsules", "-o", "out.urdf",
                     "--report", "json=report.json")
        told = next(one["message"] for one in json.loads(self.read("report.json"))["diagnostics"] if one["id"] == "SML8213")
        gain = float(re.search(r"volume \+([\d.]+) %", told)[1]) / 100
        shapes = self.links("out.urdf")["base"].findall("collision")
        dice = random.Random(1)
        middle = Frame(shapes[0]).at
        tube = shapes[0].find("geometry/cylinder")
        reach = float(tube.get("radius")) + float(tube.get("length")) / 2
        low, high = [x - reach for x in middle], [x + reach for x in middle]
        tries = 60000
        hits = 0
        for _ in range(tries):
            point = [dice.uniform(a, b) for a, b in zip(low, high)]
            hits += any(outside(each.find("geometry")[0], Frame(each).into(point), self.folder) <= 0 for each in shapes)
        volume = hits / tries * math.prod(b - a for a, b in zip(low, high))
        self.assertAlmostEqual(volume / (VOLUME * 1e-3), 1 + gain, delta=0.05 * (1 + gain))

    def test_masses_and_places_stay_in_all_formats(self):
        def facts(text, form):
            """What must not change: everything but shapes."""
            if form == "usda":
                return re.findall(r".*(?:physics:(?:mass|diagonalInertia|principalAxes|centerOfMass)|localPos|localRot).*", text)
            words = {"mjcf": ("body", "inertial", "joint"), "sdf": ("inertial", "joint")}[form]
            root = ElementTree.fromstring(text)
            found = []
            for each in root.iter():
                if each.tag in words:
                    found.append((each.tag, sorted(each.attrib.items()),
                                  ElementTree.tostring(each) if form == "sdf" else None))
            return found
        for form in ("mjcf", "sdf", "usda"):
            self.convert(self.flatten, "--format", form, "-o", "keep.out")
            before = facts(self.read("keep.out"), form)
            self.assertTrue(before)
            for shapes in SHAPES:
                done = self.convert(self.flatten, "--format", form, "-o", f"{shapes}.out", "--collision", shapes)
                self.assertEqual(facts(self.read(f"{shapes}.out"), form), before, (form, shapes))
                # That of finger_right comes from its collision.
                self.assertIn("SML8212", done.stderr)

    def test_only_needed_files_are_written(self):
        before = self.written()
        for form, code in (("usda", 0), ("html", None)):
            cli.TOOL = self.flatten
            done = self.run_tool("bot.urdf", "--format", form, "-o", f"out.{form}", "--collision", "hull")
            if done.returncode != 0 and "viewer" in done.stderr:
                continue  # built without the page
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual({path for path in self.written() if path not in before} - {"out.usda", "out.html"}, set())

    def test_patterns_choose_links(self):
        self.convert(self.to_urdf, "--collision", "boxes", "--collision", "finger_*=hull", "--collision", "finger_right=keep",
                     "-o", "out.urdf")
        kinds = {name: [each.find("geometry")[0].tag for each in link.findall("collision")]
                 for name, link in self.links("out.urdf").items()}
        self.assertEqual(kinds, {"base": ["box"], "finger_left": ["mesh", "box", "mesh"], "finger_right": ["mesh"],
                                 "plate": ["mesh"]})
        self.assertEqual(self.links("out.urdf")["finger_right"].find("collision/geometry/mesh").get("filename"),
                         "meshes/bracket.stl")
        done = self.convert(self.to_urdf, "--collision", "thumb_*=hull", "-o", "no.urdf", code=1)
        self.assertIn("has no link that fits `thumb_*` of --collision", done.stderr)
        done = self.convert(self.flatten, "--collision", "box", "-o", "no.sdf", code=2)
        self.assertIn("'box' is not one of keep, hull, boxes, capsules, parts, lighter", done.stderr)

    def test_a_flat_mesh_is_kept_and_named(self):
        done = self.convert(self.flatten, "--collision", "hull", "-o", "out.sdf")
        self.assertIn("the collision mesh `sheet.obj` is kept, although other shapes were asked for: "
                      "all its points lie in one plane", re.sub(r"\s+", " ", done.stderr))
        self.convert(self.flatten, "--collision", "hull", "-o", "no.sdf", "--fail-on-loss", code=1)

    def test_without_the_module_nothing_is_written(self):
        self.environment = {"PYTHONPATH": str(self.folder / "nowhere")}
        self.write("bin/python3", "#!/bin/sh\nexit 3\n")
        (self.folder / "bin/python3").chmod(0o755)
        before = self.written()
        for tool, (shapes, module) in itertools.product((self.to_urdf, self.flatten), {"parts": "coacd", "lighter": "meshoptimizer"}.items()):
            done = self.convert(tool, "--collision", shapes, "-o", "out.urdf", code=1, PATH=str(self.folder / "bin") + ":/bin:/usr/bin")
            self.assertIn(f"has no module `{module}`", done.stderr)
            self.assertIn(f"python3 -m pip install {module}", done.stderr)
            done = self.convert(tool, "--collision", shapes, "-o", "out.urdf", code=1, PATH=str(self.folder / "modules"))
            self.assertIn("there is no python3 on the PATH", done.stderr)
        self.assertEqual(self.written(), before)

    def test_a_module_in_the_current_folder_is_not_run(self):
        """The folder of a robot may be anybody's. Whether there is a CoACD elsewhere does not matter here."""
        for name in ("coacd", "resource", "numpy"):
            self.write(f"{name}.py", f"open({str(self.folder / 'ran')!r}, 'w')\n")
        cli.TOOL = self.to_urdf
        done = self.run_tool("bot.urdf", "--collision", "parts", "-o", "out.urdf", "--max-seconds", "60",
                             environment={"PYTHONPATH": str(self.folder / "nowhere")})
        self.assertIn("coacd", done.stderr.lower())
        self.assertFalse((self.folder / "ran").exists())

    def test_meshes_that_coacd_cannot_divide_are_kept_and_named(self):
        for mode, reason in {"fails": "CoACD failed", "crashes": "CoACD was ended by signal 11", "mumbles": "CoACD failed"}.items():
            done = self.convert(self.to_urdf, "--collision", "parts", "-o", "out.urdf", FAKE_COACD=mode)
            self.assertIn(reason, done.stderr)
            self.assertEqual(self.links("out.urdf")["base"].find("collision/geometry/mesh").get("filename"), "meshes/bracket.stl")
            self.assertFalse((self.folder / "out_collisions").exists())

    def test_meshes_that_cannot_be_lighter_are_kept_and_named(self):
        for mode, reason in {"fails": "meshoptimizer failed", "mumbles": "meshoptimizer failed",
                             "spares": "meshoptimizer finds no triangle to spare"}.items():
            done = self.convert(self.to_urdf, "--collision", "lighter", "-o", "out.urdf", FAKE_MESHOPTIMIZER=mode)
            self.assertIn(reason, re.sub(r"\s+", " ", done.stderr))
            self.assertEqual(self.links("out.urdf")["base"].find("collision/geometry/mesh").get("filename"), "meshes/bracket.stl")
            self.assertFalse((self.folder / "out_collisions").exists())

    def test_the_time_is_told_before(self):
        done = self.convert(self.flatten, "--collision", "parts", "-o", "out.sdf")
        self.assertIn("dividing up to 4 meshes into convex parts may take 1 minute", done.stderr.splitlines()[0])
        done = self.convert(self.flatten, "--collision", "parts", "-o", "out.sdf", "--quiet")
        self.assertEqual(done.stderr, "")

    def test_standard_output_has_no_folder_beside_it(self):
        done = self.convert(self.flatten, "--format", "sdf", "--collision", "hull", code=1)
        self.assertIn("name it with -o FILE", done.stderr)
        done = self.convert(self.flatten, "--format", "sdf", "--collision", "boxes")
        self.assertIn("<box>", done.stdout)
        done = self.convert(self.flatten, "--format", "usda", "--collision", "hull")
        self.assertIn("bracket_hull", done.stdout)

    def test_formats_without_collisions(self):
        done = self.convert(self.flatten, "--format", "json", "--collision", "hull", code=2)
        self.assertIn("--collision needs one of the formats", done.stderr)

    def test_a_failed_write_leaves_nothing(self):
        self.write("out_collisions", "a file in the place of the folder")
        before = self.written()
        for tool, name in ((self.to_urdf, "out.urdf"), (self.flatten, "out.sdf")):
            self.convert(tool, "--collision", "hull", "-o", name, code=2)
        (self.folder / "out_collisions").unlink()
        self.write("out.sdf/file", "a folder in the place of the result")
        self.convert(self.flatten, "--collision", "hull", "-o", "out.sdf", code=2)
        self.assertEqual([path for path in self.written() if path not in before], ["out.sdf/file"])

    def test_copies_of_assets_and_new_meshes(self):
        (self.folder / "scene").mkdir()
        for _ in range(2):  # the second run finds the files of the first
            self.convert(self.flatten, "--collision", "hull", "-o", "scene/out.sdf", "--copy-assets", "scene/assets", "--overwrite")
        uris = {each.text for each in ElementTree.parse(self.folder / "scene/out.sdf").getroot().iter("uri")}
        self.assertEqual(uris, {"out_collisions/bracket_hull.obj", "out_collisions/bracket_hull_2.obj",
                                "out_collisions/bracket_hull_3.obj", "assets/bot/sheet.obj"})
        for uri in uris:
            self.assertTrue((self.folder / "scene" / uri).is_file(), uri)

    def test_drake_gets_copies(self):
        self.write("meshes/sheet.obj", obj_of(*bracket()))
        self.convert(self.flatten, "--collision", "boxes", "--collision", "finger_*=hull", "-o", "cell.dmd.yaml", "--format", "dmd")
        links = self.links("cell_models/bot.urdf")
        self.assertEqual(links["base"].find("collision/geometry")[0].tag, "box")
        file = links["finger_right"].find("collision/geometry/mesh").get("filename")
        self.assertTrue((self.folder / "cell_models" / file).is_file(), file)
        self.assertIn("bot.urdf", self.read("cell.dmd.yaml"))

    def test_results_are_equal_in_every_run(self):
        texts = []
        for _ in range(2):
            self.convert(self.to_urdf, "--collision", "capsules", "--collision", "base=parts", "-o", "out.urdf")
            texts.append(self.read("out.urdf"))
        self.assertEqual(*texts)


if __name__ == "__main__":
    TO_URDF = str(pathlib.Path(sys.argv.pop(2)).absolute())
    cli.main()
