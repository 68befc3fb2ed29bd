# SPDX-License-Identifier: BSD-3-Clause
"""gltf and usda: previews, read by the validator of glTF and by an own small reader of USD."""
import base64
import json
import pathlib
import re
import struct

import reader

HERE = pathlib.Path(__file__).resolve().parent


def multiply(a, b):
    """Quaternions w, x, y, z."""
    w, x, y, z = a
    v, i, j, k = b
    return [w * v - x * i - y * j - z * k, w * i + x * v + y * k - z * j,
            w * j - x * k + y * v + z * i, w * k + x * j - y * i + z * v]


def compose(a, b):
    """Of two poses: position, then quaternion."""
    (p, q), (r, s) = a, b
    turned = multiply(multiply(q, [0, *r]), [q[0], -q[1], -q[2], -q[3]])[1:]
    return [x + y for x, y in zip(p, turned)], multiply(q, s)


class PreviewTest(reader.ReaderTest):
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

    @reader.needs_npm("gltf-validator")
    def test_the_validator_finds_nothing(self):
        self.write("shapes.smurfs", "entities:\n" + "".join(
            f"- {{name: {shape}, type: primitive, geometry: {{type: {shape}}}, material: "
            "{diffuseColor: {r: 1, g: 0.5, b: 0, a: 0.5}}, extend: {x: 0.5, y: 1, z: 0.5}}\n"
            for shape in ("plane", "box", "sphere", "cylinder", "capsule")))
        self.write("empty.smurfs", "entities: []\n")
        for scene in [*reader.SCENES.values(), "shapes.smurfs", "empty.smurfs"]:
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
    PRIM = re.compile(r'def (\w+) "(\w+)"$')
    NUMBERS = re.compile(r"\((.*)\)$")

    def prims(self, scene):
        """Path of the prim -> its type and attributes; fails where braces or prims do not fit."""
        lines = self.write_scene(scene, "usda").read_text().splitlines()
        self.assertEqual(lines[0], "#usda 1.0")
        prims, path = {}, []
        for line in map(str.strip, lines[lines.index(")") + 1:]):
            if match := self.PRIM.match(line):
                path.append(match[2])
                self.assertNotIn("/".join(path), prims)
                prims["/".join(path)] = {"type": match[1]}
            elif line == "}":
                path.pop()
            elif line and line != "{":
                name, value = line.split(" = ", 1)
                prims["/".join(path)][name.split()[-1]] = value
        self.assertEqual(path, [])
        return prims

    def pose(self, prim):
        self.assertTrue(prim["xformOpOrder"].startswith(
            '["xformOp:translate", "xformOp:orient"'), prim)
        return tuple(list(map(float, self.NUMBERS.match(prim[key])[1].split(", ")))
                     for key in ("xformOp:translate", "xformOp:orient"))

    def test_prims_stand_where_the_links_do(self):
        for scene in reader.SCENES.values():
            prims, poses = self.prims(scene), {}
            for path, prim in prims.items():
                if "smurf:path" in prim:
                    poses[json.loads(prim["smurf:path"]), ""] = self.pose(prim)
                elif "smurf:link" in prim:
                    entity = prims[path.rsplit("/", 1)[0]]
                    poses[json.loads(entity["smurf:path"]), json.loads(prim["smurf:link"])] = \
                        compose(self.pose(entity), self.pose(prim))
            self.assert_all(poses, scene)

    def test_world_and_shapes(self):
        prims = self.prims(reader.SCENES["showcase"])
        self.assertEqual(prims["World"]["type"], "Xform")
        kinds = {prim["type"] for prim in prims.values()}
        self.assertLessEqual({"Cube", "Sphere", "Cylinder"}, kinds)


if __name__ == "__main__":
    reader.main()
