# SPDX-License-Identifier: BSD-3-Clause
"""tsv, dot and svg: tables and pictures, read by csv, Graphviz and librsvg."""
import csv
import json
import re
import xml.etree.ElementTree as ElementTree

import reader

SVG = "{http://www.w3.org/2000/svg}"
ODD_NAMES = """entities:
- {name: "tab\\there", type: thing, position: [1, 0, 0]}
- {name: "quote\\" back\\\\slash\\nline", type: thing, position: [2, 0, 0]}
- {name: "<&'>", type: thing, position: [3, 0, 0], anchor: world}
"""


class Tsv(reader.ReaderTest):
    def rows(self, scene):
        with open(self.write_scene(scene, "tsv"), newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file, delimiter="\t", quoting=csv.QUOTE_NONE))

    def test_poses(self):
        for scene in reader.SCENES.values():
            rows = self.rows(scene)
            instances = self.flat(scene)["instances"]
            self.assertEqual([row["path"] for row in rows], [i["path"] for i in instances])
            for row, instance in zip(rows, instances):
                position = [float(row[key]) for key in ("px", "py", "pz")]
                wxyz = [float(row[key]) for key in ("qw", "qx", "qy", "qz")]
                self.assert_same_pose(row["path"], position, wxyz, instance, tolerance=0)

    def test_attachments_and_joints(self):
        rows = {row["path"]: row for row in self.rows(reader.SCENES["nested"])}
        self.assertEqual(rows["Base"]["attachment"], "world")
        self.assertEqual(rows["Base"]["joint_positions"], "j1=0.5")
        self.assertEqual(rows["cell/Cup"]["attachment"], "cell/Table::top")

    def test_odd_names_keep_the_table(self):
        self.write("odd.smurfs", ODD_NAMES)
        self.assertEqual([row["path"] for row in self.rows("odd.smurfs")],
                         ["tab\\there", "quote\" back\\\\slash\\nline", "<&'>"])


class Dot(reader.ReaderTest):
    def graph(self, scene):
        file = self.write_scene(scene, "dot")
        graph = json.loads(self.read_with("dot", "-Tjson0", file))
        objects = {o["_gvid"]: o for o in graph["objects"]}
        edges = [(objects[e["tail"]]["name"], objects[e["head"]]["name"], e["label"],
                  e.get("style", "solid")) for e in graph["edges"]]
        return {o["name"]: o for o in objects.values()}, edges

    @reader.needs_program("dot")
    def test_attachments(self):
        nodes, edges = self.graph(reader.SCENES["nested"])
        self.assertEqual(set(edges), {
            (":world", "Base", "fixed", "solid"),
            ("Base", "cell/Table", "fixed to flange", "solid"),
            ("cell/Table", "cell/Cup", "fixed to top", "solid"),
            ("Base", "cell/Lamp", "placed at flange", "dashed"),
            (":world", "cell/Lamp", "fixed", "solid"),
            ("Base", "cell/sub/Box", "fixed to flange", "solid")})
        self.assertEqual(nodes["cluster cell/sub"]["label"], "cell/sub")
        self.assertEqual(nodes["cell/sub/Box"]["label"], "Box\\nbox")

    @reader.needs_program("dot")
    def test_odd_names(self):
        self.write("odd.smurfs", ODD_NAMES)
        nodes, edges = self.graph("odd.smurfs")
        self.assertEqual(len(nodes), 4)
        self.assertEqual([edge[3] for edge in edges], ["dashed", "dashed", "solid"])


class Svg(reader.ReaderTest):
    def svg(self, scene):
        file = self.write_scene(scene, "svg")
        png = self.folder / "out.png"
        self.read_with("rsvg-convert", file, "-o", png)
        self.assertTrue(png.read_bytes().startswith(b"\x89PNG"))
        return ElementTree.parse(file).getroot()

    @staticmethod
    def names(root):
        return [text.text for text in root.iter(SVG + "text") if text.get("class") == "name"]

    @reader.needs_program("rsvg-convert")
    def test_every_instance_has_its_name(self):
        for scene in reader.SCENES.values():
            root = self.svg(scene)
            for instance in self.flat(scene)["instances"]:
                self.assertTrue(any(name.startswith(instance["path"])
                                    for name in self.names(root)), instance["path"])

    @reader.needs_program("rsvg-convert")
    def test_axes_point_where_the_instance_does(self):
        self.write("one.smurfs", "entities:\n- {name: A, type: thing, rotation: [90]}\n")
        root = self.svg("one.smurfs")
        frame, aside = [g for g in root.iter(SVG + "g") if g.find(SVG + "title") is not None]
        self.assertEqual(frame.find(SVG + "title").text, "A: thing, free")
        for view, expected in ((frame, {"#d62828": (0, -26), "#2a9134": (-26, 0)}),  # y points down here
                               (aside, {"#2a9134": (-26, 0), "#1d5fd1": (0, -26)})):
            starts = {}
            for path in view.iter(SVG + "path"):
                if path.get("stroke-width") == "2":
                    x0, y0, x1, y1 = map(float, re.findall(r"-?[\d.]+", path.get("d")))
                    starts[path.get("stroke")] = (round(x1 - x0), round(y1 - y0))
            self.assertEqual(starts, expected)
        self.assertEqual(len(list(frame.iter(SVG + "circle"))), 2)  # z, towards the viewer
        self.assertEqual(len(list(aside.iter(SVG + "circle"))), 1)  # x, away from the viewer

    @reader.needs_program("rsvg-convert")
    def test_what_is_far_away_is_pointed_at(self):
        names = self.names(self.svg(reader.SCENES["example"]))
        self.assertIn("rainbow1 (1500, 300)", names)

    @reader.needs_program("rsvg-convert")
    def test_odd_names_and_nothing(self):
        self.write("odd.smurfs", ODD_NAMES)
        self.assertIn("<&'>", self.names(self.svg("odd.smurfs")))
        self.write("empty.smurfs", "entities: []\n")
        self.assertEqual(self.names(self.svg("empty.smurfs")), [])

    def outlines(self, root):
        """Width, height and colour of each shape, from above and from the side."""
        found = []
        for group in root.iter(SVG + "g"):
            if group.get("clip-path"):
                paths = [[[float(n) for n in point.split()] for point in re.findall(r"[-\d.]+ [-\d.]+", path.get("d"))]
                         for path in group.iter(SVG + "path")]
                found.append([tuple(round(max(p[i] for p in path) - min(p[i] for p in path), 1) for i in (0, 1))
                              + (element.get("fill"),) for path, element in zip(paths, group.iter(SVG + "path"))])
        return found

    @reader.needs_program("rsvg-convert")
    def test_outlines_of_meshes_and_of_the_other_side(self):
        corners = [(x, y, z) for x in (0, 1) for y in (0, 2) for z in (0, 3)]
        self.write("m.obj", "".join(f"v {x} {y} {z}\n" for x, y, z in corners) + "f 1 2 3\nf 6 7 8\nf 1 5 4\nf 2 3 7\n")
        self.write("r.urdf", '<robot name="r"><link name="l"><visual><geometry><mesh filename="m.obj" scale="2 1 1"/></geometry>'
                   "</visual></link></robot>")
        self.write("s.smurfs", "entities:\n- {name: a, type: urdf, file: r.urdf, position: [0, 0, 0]}\n"
                   "- {name: b, type: urdf, file: r.urdf, position: [5, 0, 0]}\n")
        above, aside = self.outlines(self.svg("s.smurfs"))
        metre = above[0][0] / 2
        for (width, height, _), (_, high, _) in zip(above, aside):
            self.assertAlmostEqual(height, 2 * metre, delta=0.1)
            self.assertAlmostEqual(width, 2 * metre, delta=0.1)
            self.assertAlmostEqual(high, 3 * metre, delta=0.1)
        self.assertEqual(len({color for *_, color in above}), 2)  # one for each robot
        self.assertEqual([color for *_, color in above], [color for *_, color in aside])
        self.write("m.obj", "v 0 0 0\n")
        self.assertIn("some meshes are not drawn", [text.text for text in self.svg("s.smurfs").iter(SVG + "text")])

    @reader.needs_program("rsvg-convert")
    def test_names_do_not_cover_each_other(self):
        """In one place, a hundred names do not fit; the labels do not overlap."""
        for step, all_are_there in ((1.5, True), (0.01, False)):
            self.write("s.smurfs", "entities:\n" + "".join(
                f"- {{name: robot_{i}, type: thing, position: [{i % 10 * step}, {i // 10 * step}, 0]}}\n" for i in range(100)))
            root = self.svg("s.smurfs")
            names = [text for text in root if text.get("class") == "name"]  # from above
            boxes = [(float(t.get("x")), float(t.get("y")), len(t.text) * 7.2) for t in names]
            for i, (x, y, width) in enumerate(boxes):
                for other_x, other_y, other_width in boxes[:i]:
                    self.assertFalse(abs(y - other_y) < 12 and x < other_x + other_width and other_x < x + width)
            self.assertEqual(len(names) == 100, all_are_there)
            texts = [text.text for text in root.iter(SVG + "text")]
            self.assertEqual("some names do not fit: point at the axes to read them" in texts, not all_are_there)

    @reader.needs_program("rsvg-convert")
    def test_many_shapes_are_seen_from_above_only(self):
        self.write("s.smurfs", "entities:\n" + "".join(
            f"- {{name: e{i}, type: thing, position: [{i % 80}, {i // 80}, 0]}}\n" for i in range(5001)))
        root = self.svg("s.smurfs")
        self.assertEqual(len(self.outlines(root)), 1)
        self.assertIn("too many shapes for a view from the side", [text.text for text in root.iter(SVG + "text")])


if __name__ == "__main__":
    reader.main()
