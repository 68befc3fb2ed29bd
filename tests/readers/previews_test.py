# SPDX-License-Identifier: BSD-3-Clause
"""gltf, usda and obj: their contents, read by the validator of glTF, a small reader of USD and assimp; meshes in mjcf."""
import base64
import json
import math
import pathlib
import re
import struct
import subprocess
import xml.etree.ElementTree as ElementTree

import reader
import usd_physics_test
from frames import compose, rotate
from usd_stage import Stage

HERE = pathlib.Path(__file__).resolve().parent


def bounds(points):
    return [min(p[i] for p in points) for i in range(3)], \
           [max(p[i] for p in points) for i in range(3)]


# A wedge, far from the origin and with three sides of different lengths.
WEDGE = [(1, 2, 3), (2.5, 2, 3), (1, 4, 3), (1, 2, 3.75)]
FACES = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]


def binary_stl():
    return b" " * 80 + struct.pack("<I", len(FACES)) + b"".join(
        struct.pack("<12fH", 0, 0, 0, *(c for i in face for c in WEDGE[i]), 0) for face in FACES)


def ascii_stl():
    return "solid wedge\n" + "".join(
        "facet normal 0 0 0\nouter loop\n" + "".join("vertex %g %g %g\n" % WEDGE[i] for i in face) +
        "endloop\nendfacet\n" for face in FACES) + "endsolid wedge\n"


def obj():
    return "".join("v %g %g %g\n" % p for p in WEDGE) + \
        "".join("f " + " ".join(str(i + 1) for i in face) + "\n" for face in FACES)


def dae(nodes="", faces=FACES):
    """The wedge in half metres, with y up, which is ignored; the last face is red."""
    points = " ".join(f"{2 * c:g}" for p in WEDGE for c in p)
    triangles = "".join(
        f'<triangles count="{len(faces)}" material="{name}"><input semantic="VERTEX" source="#v" offset="0"/><p>'
        + " ".join(str(i) for face in faces for i in face) + "</p></triangles>"
        for name, faces in (("plain", faces[:-1]), ("red", faces[-1:])) if faces)
    return f"""<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="0.5"/><up_axis>Y_UP</up_axis></asset>
<library_effects><effect id="e"><profile_COMMON><technique sid="t"><phong><diffuse><color>1 0 0 1</color></diffuse></phong>
</technique></profile_COMMON></effect></library_effects>
<library_materials><material id="m"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="a" count="12">{points}</float_array><technique_common>
<accessor source="#a" count="4" stride="3"/></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>{triangles}</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node>{nodes}<instance_geometry url="#g"><bind_material><technique_common>
<instance_material symbol="red" target="#m"/></technique_common></bind_material></instance_geometry></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>
"""


def gltf():
    """The wedge, with its points in a separate file; y is up in the file."""
    return json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0, 0, 1, 0.5]}, "alphaMode": "BLEND"}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                      {"bufferView": 1, "componentType": 5123, "count": 3 * len(FACES), "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 6 * len(FACES)}],
        "buffers": [{"byteLength": 48 + 6 * len(FACES), "uri": "wedge.bin"}]})


def gltf_data():
    return b"".join(struct.pack("<3f", x, z, -y) for x, y, z in WEDGE) + b"".join(struct.pack("<3H", *face) for face in FACES)


LOOKAT = "<lookat>0 0 0 1 0 0 0 0 1</lookat>"  # not supported


class PreviewTest(reader.ReaderTest):
    def write_meshes(self):
        """Visuals with meshes, two of them with the same file, and one with unsupported contents."""
        files = {"wedge.stl": binary_stl(), "text.stl": ascii_stl(), "wedge.obj": obj(),
                 "wedge.dae": dae(), "wedge.gltf": gltf(), "wedge.bin": gltf_data(), "part.dae": dae(LOOKAT)}
        for name, content in files.items():
            self.write("meshes/" + name, content)
        visuals = [("wedge.stl", "1 1 1"), ("wedge.stl", "0.5 -2 3"), ("text.stl", "1 1 1"),
                   ("wedge.obj", "2 2 2"), ("wedge.dae", "1 3 1"), ("wedge.gltf", "1 1 2"), ("part.dae", "1 1 1")]
        self.write("meshes.urdf", "<robot name='r'><link name='l'>" + "".join(
            f"<visual><origin xyz='{i} 0 0' rpy='0 0 1.5707963267948966'/><geometry>"
            f"<mesh filename='meshes/{file}' scale='{scale}'/></geometry></visual>"
            for i, (file, scale) in enumerate(visuals)) + "</link></robot>")
        self.write("meshes.smurfs", "entities:\n"
                   "- {name: a, file: meshes.urdf, position: [0, 0, 10]}\n"
                   "- {name: b, file: meshes.urdf, rotation: [0, 0, 0.7071067811865476, "
                   "0.7071067811865476]}\n")
        return visuals[:-1]

    def expected_bounds(self, entity, index, scale):
        """In the world, computed from the source only."""
        x, y, z = map(float, scale.split())
        poses = {"a": ([0, 0, 10], [1, 0, 0, 0]), "b": ([0, 0, 0], [0, 0, math.sqrt(0.5),
                                                                    math.sqrt(0.5)])}
        quarter = [math.sqrt(0.5), 0, 0, math.sqrt(0.5)]
        p, q = compose(poses[entity], ([index, 0, 0], quarter))
        return bounds([[a + b for a, b in zip(p, rotate(q, [v[0] * x, v[1] * y, v[2] * z]))]
                       for v in WEDGE])

    def assert_bounds(self, actual, expected):
        for side, other in zip(actual, expected):
            self.assertLess(math.dist(side, other), 1e-9)

    def assert_all(self, poses, scene):
        """Every entity, and every link of every model, has the pose of the flat JSON."""
        count = 0
        for instance in self.flat(scene)["instances"]:
            expected = {(instance["path"], ""): instance}
            for link, pose in instance.get("links", {}).items():
                expected[instance["path"], link] = pose
            for key, pose in expected.items():
                self.assert_same_pose(key, *poses[key], pose)
                count += 1
        self.assertEqual(count, len(poses))
        self.assertGreater(count, 3)


class Gltf(PreviewTest):
    def document(self, scene):
        return json.loads(self.write_scene(scene, "gltf").read_text())

    def test_nodes_stand_where_the_links_do(self):
        for scene in reader.SCENES.values():
            nodes = self.document(scene)["nodes"]
            root = nodes[-1]
            self.assertEqual(root["rotation"], [-0.7071067811865476, 0, 0, 0.7071067811865476])
            poses = {}

            def pose(node):
                x, y, z, w = node.get("rotation", [0, 0, 0, 1])
                return node.get("translation", [0, 0, 0]), [w, x, y, z]

            for entity in (nodes[i] for i in root["children"]):
                poses[entity["name"], ""] = pose(entity)
                for link in (nodes[i] for i in entity.get("children", [])):
                    if "mesh" not in link:
                        poses[entity["name"], link["name"]] = compose(pose(entity), pose(link))
            self.assert_all(poses, scene)

    def buffer(self, document):
        return base64.b64decode(document["buffers"][0]["uri"].split(",")[1])

    def points(self, document, accessor):
        accessor = document["accessors"][accessor]
        start = document["bufferViews"][accessor["bufferView"]]["byteOffset"]
        data = self.buffer(document)[start:start + 12 * accessor["count"]]
        return list(struct.iter_unpack("<3f", data))

    def points_of_mesh(self, document, mesh):
        """The points that its triangles use."""
        points = []
        for primitive in mesh["primitives"]:
            accessor = document["accessors"][primitive["indices"]]
            view = document["bufferViews"][accessor["bufferView"]]
            start = view["byteOffset"] + accessor.get("byteOffset", 0)
            self.assertEqual(accessor["componentType"], 5123)
            indices = struct.unpack_from(f"<{accessor['count']}H", self.buffer(document), start)
            all_points = self.points(document, primitive["attributes"]["POSITION"])
            points += [all_points[i] for i in indices]
        self.assertEqual(len(points), 3 * len(FACES))
        return points

    def test_meshes_fill_the_box_of_their_files(self):
        visuals = self.write_meshes()
        document = self.document("meshes.smurfs")
        nodes = document["nodes"]
        for entity in (n for n in nodes if n["name"] in ("a", "b")):
            (link,) = (nodes[i] for i in entity["children"])
            shapes = [nodes[i] for i in link["children"]]
            self.assertEqual(len(shapes), len(visuals))
            for index, (shape, (_, scale)) in enumerate(zip(shapes, visuals)):
                poses = [(n.get("translation", [0, 0, 0]),
                          [n.get("rotation", [0, 0, 0, 1])[k] for k in (3, 0, 1, 2)])
                         for n in (entity, link, shape)]
                p, q = compose(compose(poses[0], poses[1]), poses[2])
                size = shape.get("scale", [1, 1, 1])
                points = self.points_of_mesh(document, document["meshes"][shape["mesh"]])
                placed = [[a + b for a, b in zip(p, rotate(q, [c * s for c, s in zip(v, size)]))]
                          for v in points]
                self.assert_bounds(bounds(placed),
                                   self.expected_bounds(entity["name"], index, scale))
        self.assertEqual(len(document["meshes"]), 5)  # one a file
        self.assertEqual(len(document["meshes"][3]["primitives"]), 2)  # one a colour
        colors = [document["materials"][p["material"]]["pbrMetallicRoughness"]["baseColorFactor"]
                  for mesh in document["meshes"][3:] for p in mesh["primitives"]]
        self.assertEqual(colors[1:], [[1, 0, 0, 1], [0, 0, 1, 0.5]])
        done = self.run_tool("meshes.smurfs", "--format", "gltf")
        self.assertIn("the mesh `meshes/part.dae` is not in the glTF: the file is placed by <lookat>, which is not read",
                      done.stderr)
        self.assertEqual(done.stderr.count("not in the glTF"), 1)

    def test_meshes_are_read_where_copies_come_from(self):
        self.write_meshes()
        plain = self.document("meshes.smurfs")
        self.run_tool("meshes.smurfs", "--format", "gltf", "-o", "copied.gltf", "--quiet",
                      "--copy-assets", "assets")
        self.assertEqual(json.loads(self.read("copied.gltf")), plain)

    @reader.needs_npm("gltf-validator")
    def test_the_validator_finds_nothing(self):
        self.write("shapes.smurfs", "entities:\n" + "".join(
            f"- {{name: {shape}, type: primitive, geometry: {{type: {shape}}}, material: "
            "{diffuseColor: {r: 1, g: 0.5, b: 0, a: 0.5}}, extend: {x: 0.5, y: 1, z: 0.5}}\n"
            for shape in ("plane", "box", "sphere", "cylinder", "capsule")))
        self.write("empty.smurfs", "entities: []\n")
        self.write_meshes()
        for scene in [*reader.SCENES.values(), "shapes.smurfs", "meshes.smurfs", "empty.smurfs"]:
            file = self.write_scene(scene, "gltf")
            report = json.loads(self.read_with("node", HERE / "gltf_report.mjs",
                                               reader.NODE_MODULES, file))
            self.assertEqual((report["issues"]["numErrors"], report["issues"]["numWarnings"]),
                             (0, 0), report["issues"])

    def test_triangles_face_outwards(self):
        """The box has a surface of 6 and a volume of 1, computed from the triangles."""
        self.write("box.smurfs", "entities:\n- {name: b, type: primitive, geometry: {type: box}}\n")
        document = self.document("box.smurfs")
        data = base64.b64decode(document["buffers"][0]["uri"].split(",")[1])

        def values(accessor, form, size):
            view = document["bufferViews"][document["accessors"][accessor]["bufferView"]]
            chunk = data[view["byteOffset"]:view["byteOffset"] + view["byteLength"]]
            return list(struct.iter_unpack(form, chunk[:len(chunk) // size * size]))

        points = values(0, "<3f", 12)
        indices = [i for i, in values(2, "<H", 2)]
        volume = 0
        for a, b, c in zip(*[(points[i] for i in indices[k::3]) for k in range(3)]):
            volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                       a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
        self.assertAlmostEqual(volume, 1)


class Usda(PreviewTest):
    def stage(self, scene):
        return Stage(self.write_scene(scene, "usda").read_text())

    def test_prims_stand_where_the_links_do(self):
        for scene in reader.SCENES.values():
            stage = self.stage(scene)
            poses = {key: stage.pose(path) for key, path in stage.links().items()}
            poses |= {(json.loads(prim["smurf:path"]), ""): stage.pose(path)
                      for path, prim in stage.prims.items() if "smurf:path" in prim}
            self.assert_all(poses, scene)

    def test_meshes_fill_the_box_of_their_files(self):
        visuals = self.write_meshes()
        stage = self.stage("meshes.smurfs")
        prims = stage.prims
        numbers = re.compile(r"[-+.\de]+")
        for entity in "ab":
            for index, (_, scale) in enumerate(visuals):
                shape = prims[f"World/{entity}/l/shape_{index + 1}"]
                mesh = prims[shape["references"]]
                if mesh["references"]:  # with the colours of the file
                    mesh = prims[mesh["references"]]
                self.assertEqual((shape["type"], mesh["type"]), ("Mesh", "Mesh"))
                values = [float(n) for n in numbers.findall(mesh["points"])]
                points = list(zip(values[::3], values[1::3], values[2::3]))
                extent = [float(n) for n in numbers.findall(mesh["extent"])]
                self.assert_bounds((extent[:3], extent[3:]), bounds(points))
                self.assertEqual(mesh["faceVertexCounts"], "[3, 3, 3, 3]")
                indices = json.loads(mesh["faceVertexIndices"])
                self.assertEqual((len(indices), sorted(set(indices))), (12, list(range(len(points)))))
                size = [float(n) for n in
                        numbers.findall(shape.get("xformOp:scale", "(1, 1, 1)"))]
                p, q = stage.pose(f"World/{entity}/l/shape_{index + 1}")
                placed = [[a + b for a, b in zip(p, rotate(q, [c * s for c, s in zip(v, size)]))]
                          for v in points]
                self.assert_bounds(bounds(placed), self.expected_bounds(entity, index, scale))
        self.assertEqual(prims["Meshes"]["type"], "class")
        self.assertNotIn("World/a/l/shape_7", prims)  # unsupported contents
        colored = [prims[prims[f"World/a/l/shape_{i}"]["references"]] for i in (5, 6)]
        self.assertEqual(colored[0]["primvars:displayColor"],
                         '[(0.5, 0.5, 0.5), (1, 0, 0)] (interpolation = "uniform")')
        self.assertEqual(colored[0]["primvars:displayColor:indices"], "[0, 0, 0, 1]")
        self.assertEqual(colored[1]["primvars:displayColor"], "[(0, 0, 1)]")
        self.assertEqual(colored[1]["primvars:displayOpacity"], "[0.5]")

    @reader.needs_npm("tinyusdz")
    def test_another_reader_checks_the_types(self):
        self.write_meshes()
        for name, text in usd_physics_test.FILES.items():
            self.write(name, text)
        files = []
        for scene in [*reader.SCENES.values(), "meshes.smurfs", "kinds.smurfs", "zoo.smurfs", "lit.smurfs"]:
            files.append(self.folder / f"{len(files)}.usda")
            self.write_scene(scene, "usda").rename(files[-1])
        self.read_with("node", HERE / "usd_parse.mjs", reader.NODE_MODULES, *files)
        for damage in ("float physics:lowerLimit = (1, 2)", 'quatf physics:localRot0 = "x"'):
            name = damage.split(" = ")[0]
            text = files[-3].read_text()
            self.write("damaged.usda", re.sub(f"{name} = .*", damage, text, count=1))
            done = subprocess.run(["node", HERE / "usd_parse.mjs", reader.NODE_MODULES, "damaged.usda"], cwd=self.folder,
                                  capture_output=True, check=False)
            self.assertEqual(done.returncode, 1)

    def test_world_and_shapes(self):
        prims = self.stage(reader.SCENES["showcase"]).prims
        self.assertEqual(prims["World"]["type"], "Xform")
        kinds = {prim["type"] for prim in prims.values()}
        self.assertLessEqual({"Cube", "Sphere", "Cylinder"}, kinds)


class Obj(PreviewTest):
    def objects(self, scene):
        """The corners of the triangles of each object."""
        points, found = [], {}
        for line in self.write_scene(scene, "obj").read_text().splitlines():
            kind, *fields = line.split(" ")
            if kind == "v":
                points.append([float(field) for field in fields[:3]])
            elif kind == "o":
                (name,) = fields
                found[name] = []
            elif kind == "f":
                self.assertEqual(len(fields), 3)
                found[name].append([points[int(field) - 1] for field in fields])
        return found

    def test_meshes_fill_the_box_of_their_files(self):
        visuals = self.write_meshes()
        objects = self.objects("meshes.smurfs")
        self.assertEqual(set(objects), {"a::l", "b::l"})
        for name, triangles in objects.items():
            self.assertEqual(len(triangles), len(visuals) * len(FACES))
            for index, (_, scale) in enumerate(visuals):
                part = triangles[index * len(FACES):(index + 1) * len(FACES)]
                found = bounds([corner for triangle in part for corner in triangle])
                for side, other in zip(found, self.expected_bounds(name[0], index, scale)):
                    self.assertLess(math.dist(side, other), 1e-6)

    def test_triangles_face_outwards(self):
        """The same for a mirrored mesh."""
        self.write("meshes/wedge.stl", binary_stl())
        for scale, volume in (("1 1 1", 0.375), ("1 -2 1", 0.75), ("-1 -1 -1", 0.375)):
            self.write("one.urdf", "<robot name='r'><link name='l'><visual><geometry><mesh filename='meshes/wedge.stl' "
                       f"scale='{scale}'/></geometry></visual></link></robot>")
            self.write("one.smurfs", "entities:\n- {name: a, file: one.urdf}\n"
                       "- {name: b, type: primitive, geometry: {type: box}, position: [5, 0, 0]}\n")
            for name, expected in (("a::l", volume), ("b", 1)):
                found = sum(a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                            a[2] * (b[0] * c[1] - b[1] * c[0]) for a, b, c in self.objects("one.smurfs")[name]) / 6
                self.assertAlmostEqual(found, expected, places=6)

    def test_names(self):
        self.write("odd.smurfs", "entities:\n- {name: \"two words \\\\\", type: primitive, geometry: {type: box}}\n"
                   "- {name: \"::error::x\", type: primitive, geometry: {type: box}}\n")
        self.assertEqual(set(self.objects("odd.smurfs")), {"two_words__", "_:error::x"})

    @reader.needs_program("assimp")
    def test_another_reader_sees_what_the_preview_shows(self):
        """The same triangles within the same box; the y axis of glTF is up."""
        self.write_meshes()
        for scene in [*reader.SCENES.values(), "meshes.smurfs"]:
            facts = {}
            for form in ("obj", "gltf"):
                text = self.read_with("assimp", "info", self.write_scene(scene, form), "-ptv", "-tri")
                sides = re.findall(r"^(?:Minimum|Maximum) point\s+\((\S+) (\S+) (\S+)\)", text, re.M)
                low, high = [[float(one) for one in side] for side in sides]
                if form == "gltf":
                    low, high = [low[0], -high[2], low[1]], [high[0], -low[2], high[1]]
                facts[form] = int(re.search(r"^Faces:\s+(\d+)", text, re.M)[1]), low, high
            self.assertGreater(facts["obj"][0], 10)
            self.assertEqual(facts["obj"][0], facts["gltf"][0])
            for side in (1, 2):
                self.assertLess(math.dist(facts["obj"][side], facts["gltf"][side]), 1e-4, scene)


class Mjcf(PreviewTest):
    """Meshes that MuJoCo does not read."""

    def world(self):
        for name, content in {"wedge.dae": dae(), "wedge.gltf": gltf(), "wedge.bin": gltf_data(), "flat.dae": dae(faces=FACES[:1]),
                              "part.dae": dae(LOOKAT)}.items():
            self.write("meshes/" + name, content)
        part = "<{0}><geometry><mesh filename='meshes/{1}' scale='1 {2} 1'/></geometry></{0}>"
        self.write("r.urdf", "<robot name='r'><link name='l'>" + "".join(
            part.format("visual", name, 2) + part.format("collision", name, 1)
            for name in ("wedge.dae", "wedge.gltf", "flat.dae", "part.dae")) + "</link></robot>")
        return self.write_scene("r.urdf", "mjcf")

    def test_triangles_are_in_the_file(self):
        root = ElementTree.parse(self.world()).getroot()
        meshes = root.findall("asset/mesh")
        self.assertEqual([mesh.get("scale") for mesh in meshes], ["1 2 1"] * 2 + ["1 1 1"] * 2)
        self.assertEqual(len([geom for geom in root.iter("geom") if geom.get("mesh")]), 4)
        for mesh in meshes:
            values = [float(n) for n in mesh.get("vertex").split()]
            self.assert_bounds(bounds(list(zip(values[::3], values[1::3], values[2::3]))), bounds(WEDGE))
            self.assertEqual(len(mesh.get("face").split()), 3 * len(FACES))
        done = self.run_tool("r.urdf", "--format", "mjcf")
        self.assertIn("2 meshes (`meshes/flat.dae` and 1 more) are not in the MJCF: each file is flat, which MuJoCo refuses",
                      done.stderr)
        self.assertIn("2 meshes (`meshes/part.dae` and 1 more) are not in the MJCF: each file is placed by <lookat>",
                      done.stderr)

    @reader.needs_npm("@mujoco/mujoco")
    def test_mujoco_reads_it(self):
        lines = self.read_with("node", HERE / "mujoco_poses.mjs", reader.NODE_MODULES, self.world())
        self.assertIn("r/l", lines)

    @reader.needs_built("mujoco_poses")
    def test_an_older_mujoco_reads_it(self):
        self.assertIn("r/l", self.read_with(reader.BUILD / "mujoco_poses", self.world()))


if __name__ == "__main__":
    reader.main()
