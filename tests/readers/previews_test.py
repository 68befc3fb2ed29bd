# SPDX-License-Identifier: BSD-3-Clause
"""gltf and usda: what they show, read by the validator of glTF and by a small reader of USD."""
import base64
import json
import math
import pathlib
import re
import struct
import subprocess

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


# A triangle; neither previews nor OpenUSD show COLLADA.
DAE = """<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="a" count="9">0 0 0 1 0 0 0 1 0</float_array><technique_common>
<accessor source="#a" count="3" stride="3"/></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"/></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>
"""


class PreviewTest(reader.ReaderTest):
    def write_meshes(self):
        """Four visuals with meshes, two of them with one file, and one with what is not read."""
        files = {"wedge.stl": binary_stl(), "text.stl": ascii_stl(), "wedge.obj": obj(),
                 "part.dae": DAE}
        for name, content in files.items():
            self.write("meshes/" + name, content)
        visuals = [("wedge.stl", "1 1 1"), ("wedge.stl", "0.5 -2 3"), ("text.stl", "1 1 1"),
                   ("wedge.obj", "2 2 2"), ("part.dae", "1 1 1")]
        self.write("meshes.urdf", "<robot name='r'><link name='l'>" + "".join(
            f"<visual><origin xyz='{i} 0 0' rpy='0 0 1.5707963267948966'/><geometry>"
            f"<mesh filename='meshes/{file}' scale='{scale}'/></geometry></visual>"
            for i, (file, scale) in enumerate(visuals)) + "</link></robot>")
        self.write("meshes.smurfs", "entities:\n"
                   "- {name: a, file: meshes.urdf, position: [0, 0, 10]}\n"
                   "- {name: b, file: meshes.urdf, rotation: [0, 0, 0.7071067811865476, "
                   "0.7071067811865476]}\n")
        return visuals[:4]

    def expected_bounds(self, entity, index, scale):
        """In the world, from the source alone."""
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
        """Every entity, and every link of every model, is where the flat JSON has it."""
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
                (primitive,) = document["meshes"][shape["mesh"]]["primitives"]
                points = self.points(document, primitive["attributes"]["POSITION"])
                self.assertEqual(len(points), 4)
                placed = [[a + b for a, b in zip(p, rotate(q, [c * s for c, s in zip(v, size)]))]
                          for v in points]
                self.assert_bounds(bounds(placed),
                                   self.expected_bounds(entity["name"], index, scale))
        self.assertEqual(len(document["meshes"]), 3)  # one a file
        done = self.run_tool("meshes.smurfs", "--format", "gltf")
        self.assertIn("the mesh `meshes/part.dae`, which is COLLADA, of which no triangles are "
                      "read, is not in the glTF", done.stderr)
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
        """The box has a surface of 6 and a volume of 1, whoever computes it from the triangles."""
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
                self.assertEqual((shape["type"], mesh["type"]), ("Mesh", "Mesh"))
                values = [float(n) for n in numbers.findall(mesh["points"])]
                points = list(zip(values[::3], values[1::3], values[2::3]))
                extent = [float(n) for n in numbers.findall(mesh["extent"])]
                self.assert_bounds((extent[:3], extent[3:]), bounds(points))
                self.assertEqual(mesh["faceVertexCounts"], "[3, 3, 3, 3]")
                indices = json.loads(mesh["faceVertexIndices"])
                self.assertEqual((len(indices), sorted(set(indices))), (12, [0, 1, 2, 3]))
                size = [float(n) for n in
                        numbers.findall(shape.get("xformOp:scale", "(1, 1, 1)"))]
                p, q = stage.pose(f"World/{entity}/l/shape_{index + 1}")
                placed = [[a + b for a, b in zip(p, rotate(q, [c * s for c, s in zip(v, size)]))]
                          for v in points]
                self.assert_bounds(bounds(placed), self.expected_bounds(entity, index, scale))
        self.assertEqual(prims["Meshes"]["type"], "class")
        self.assertNotIn("World/a/l/shape_5", prims)  # the COLLADA file

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


if __name__ == "__main__":
    reader.main()
