# SPDX-License-Identifier: BSD-3-Clause
"""Tests the textures and the colours of annotations on the page of a scene.

Usage: textures_test.py TOOL BUILD
"""
import base64
import json
import re
import struct
import zlib

import viewer

# 8 by 8 pixels, all blue.
JPEG = base64.b64decode("/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDABALDA4MChAODQ4SERATGCgaGBYWGDEjJR0oOjM9PDkzODdASFxOQERXRTc4UG1RV19iZ2hnPk1xeX"
                        "BkeFxlZ2P/2wBDARESEhgVGC8aGi9jQjhCY2NjY2NjY2NjY2NjY2NjY2NjY2NjY2NjY2NjY2NjY2NjY2NjY2NjY2NjY2NjY2NjY2P/wAARCAAI"
                        "AAgDASIAAhEBAxEB/8QAFQABAQAAAAAAAAAAAAAAAAAAAAb/xAAUEAEAAAAAAAAAAAAAAAAAAAAA/8QAFQEBAQAAAAAAAAAAAAAAAAAABAb/xA"
                        "AUEQEAAAAAAAAAAAAAAAAAAAAA/9oADAMBAAIRAxEAPwCNAXgr/9k=")
HOSTILE = """"><img src=x onerror="window.hacked=1">.png"""
SVG = b'<svg xmlns="http://www.w3.org/2000/svg" onload="window.hacked=2"><script>window.hacked=3</script></svg>'
# The camera looks along x at boxes of 1 m, 2 m apart along y.
LOOK = "smurfViewer.stage.look([-40, 0, 0, 0, 0, 0]), smurfViewer.textures.ready"
# The colours in the picture at points of the world.
PIXELS = """((points) => {
  const { renderer, scene, camera, canvas } = smurfViewer.stage;
  smurfViewer.stage.grid.visible = false;
  camera.updateMatrixWorld();
  renderer.render(scene, camera);
  const gl = renderer.getContext();
  return points.map(([x, y, z]) => {
    const at = camera.position.clone().set(x, y, z).project(camera);
    const pixel = new Uint8Array(4);
    gl.readPixels((at.x + 1) / 2 * canvas.width, (at.y + 1) / 2 * canvas.height, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    return [...pixel.slice(0, 3)];
  });
})(%s)"""


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png(rows, width=None, height=None):
    """A PNG of rows of (r, g, b, a); with another size in its head when that is given."""
    head = struct.pack(">IIBBBBB", width or len(rows[0]), height or len(rows), 8, 6, 0, 0, 0)
    data = b"".join(b"\0" + bytes(part for pixel in row for part in pixel) for row in rows)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(data)) + chunk(b"IEND", b"")


RED, GREEN, YELLOW, CLEAR = (255, 0, 0, 255), (0, 255, 0, 255), (255, 255, 0, 255), (0, 0, 0, 0)


def escaped(text):
    return text.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")


def boxes(materials):
    """A robot with a box for each material: an element, or nothing."""
    links = "".join(f'<visual name="v{i}"><origin xyz="0 {2 * i} 0"/><geometry><box size="1 1 1"/></geometry>{material}</visual>'
                    for i, material in enumerate(materials))
    return f'<robot name="r"><link name="l">{links}</link></robot>'


def texture(name, more=""):
    return f'<material name="m_{abs(hash(name)) % 9999}">{more}<texture filename="{escaped(name)}"/></material>'


def jpeg_of_two_frames():
    """An image of 16,000 x 16,000 pixels after a marker without length, and a small one at the place that the marker's length would give."""
    frame = b"\xff\xc0\0\x11\x08%s%s"
    start = b"\xff\xd8\xff\xd0" + frame % (b"\x3e\x80", b"\x3e\x80")
    return start.ljust(4 + 0xffc0, b"\0") + frame % (b"\0\4", b"\0\4") + bytes(20)


# A square of 1 m that looks along -x, with the texture coordinates of that side of a box.
CORNERS = [(-0.5, 0.5, -0.5), (-0.5, -0.5, -0.5), (-0.5, -0.5, 0.5), (-0.5, 0.5, 0.5)]
PLACES = [(0, 0), (1, 0), (1, 1), (0, 1)]


def obj(places=PLACES, head=""):
    lines = [f"v {x} {y} {z}\n" for x, y, z in CORNERS] + [f"vt {u} {v}\n" for u, v in places]
    corners = (f"{i + 1}/{i + 1}" if places else f"{i + 1}" for i in range(4))
    return head + "".join(lines) + f"f {' '.join(corners)}\n"


def collada(diffuse="<color>1 1 1 1</color>"):
    def numbers(rows):
        return " ".join(str(number) for row in rows for number in row)

    return f'''<COLLADA version="1.4.1"><library_effects><effect id="e"><profile_COMMON><technique sid="t"><lambert>
<diffuse>{diffuse}</diffuse></lambert></technique></profile_COMMON></effect></library_effects>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="a" count="12">{numbers(CORNERS)}</float_array></source>
<source id="t"><float_array id="b" count="8">{numbers(reversed(PLACES))}</float_array><technique_common>
<accessor source="#b" count="4" stride="2"><param name="S"/><param name="T"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<polylist count="1"><input semantic="VERTEX" source="#v" offset="0"/><input semantic="TEXCOORD" source="#t" offset="1"/>
<vcount>4</vcount><p>0 3 1 2 2 1 3 0</p></polylist></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes></COLLADA>'''


def gltf(**look):
    """Its y axis is up, and rows of its images count from above."""
    points = b"".join(struct.pack("<3f", x, z, -y) for x, y, z in CORNERS)
    places = b"".join(struct.pack("<2f", u, 1 - v) for u, v in PLACES)
    data = points + places + bytes([0, 1, 2, 0, 2, 3])
    views, start = [], 0
    for size in (len(points), len(places), 6):
        views.append({"buffer": 0, "byteOffset": start, "byteLength": size})
        start += size
    kinds = ((5126, 4, "VEC3"), (5126, 4, "VEC2"), (5121, 6, "SCALAR"))
    return json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}],
        "materials": [{"pbrMetallicRoughness": look}], "bufferViews": views,
        "accessors": [{"bufferView": i, "componentType": kind, "count": count, "type": name}
                      for i, (kind, count, name) in enumerate(kinds)],
        "buffers": [{"byteLength": len(data), "uri": "data:;base64," + base64.b64encode(data).decode()}]})


def meshes(files):
    """A robot with a mesh for each (file, material)."""
    links = "".join(f'<visual name="v{i}"><origin xyz="0 {2 * i} 0"/><geometry><mesh filename="{file}"/></geometry>{material}</visual>'
                    for i, (file, material) in enumerate(files))
    return f'<robot name="r"><link name="l">{links}</link></robot>'


def main_color(pixel):
    """The colour without the effect of light."""
    return "".join(name for name, part in zip("rgb", pixel) if part > 0.6 * max(pixel))


class TexturesTest(viewer.ViewerTest):
    def test_pictures_are_on_their_shapes(self):
        (self.folder / "four.png").write_bytes(png([[RED, GREEN], [YELLOW, CLEAR]]))
        (self.folder / "blue.jpg").write_bytes(JPEG)
        gray = '<color rgba="0.5 0.5 0.5 1"/>'
        self.write("robot.urdf", boxes([texture("four.png"), texture("blue.jpg"), texture("four.png", gray), "", texture("blue.jpg", gray)]))
        page = self.page("robot.urdf")
        data, _ = self.data(page)
        self.assertEqual([(image["file"], image["type"]) for image in data["textures"]],
                         [("four.png", "image/png"), ("blue.jpg", "image/jpeg")])
        # The face that looks along -x has its left side, seen from outside, at +y.
        quarters = [[-0.5, y, z] for z in (0.25, -0.25) for y in (0.25, -0.25)]
        points = quarters + [[-0.5, 2, 0], [-0.5, 3.75, -0.25], [-0.5, 4.25, -0.25], [-0.5, 6, 0], [-0.5, 8, 0]]
        results = self.browse({"page": page, "steps": [LOOK, PIXELS % points]})[0]["results"]
        seen = [main_color(pixel) for pixel in results[1]]
        self.assertEqual(seen, ["r", "g", "rg", "rgb", "b", "rgb", "rg", "rgb", "b"], results[1])
        # The colour of a material is under a picture and multiplies it.
        self.assertLess(max(results[1][6]), 0.6 * max(results[1][2]))

    def test_pictures_are_on_meshes_with_texture_coordinates(self):
        (self.folder / "four.png").write_bytes(png([[RED, GREEN], [YELLOW, CLEAR]]))
        files = {"four.obj": obj(), "four.dae": collada(), "four.gltf": gltf(), "bare.obj": obj([])}
        for name, text in files.items():
            self.write(name, text)
        material = texture("four.png")
        self.write("robot.urdf", meshes([*((name, material) for name in files), ("four.obj", "")]))
        done = self.run_tool("robot.urdf", "--format", "html", "-o", "page.html", "--force")
        self.assertIn("`four.png`", done.stderr)
        page = self.folder / "page.html"
        data, _ = self.data(page)
        self.assertEqual([("texturePoints" in mesh, mesh["file"]) for mesh in data["meshes"]],
                         [(True, "four.obj"), (True, "four.dae"), (True, "four.gltf"), (False, "bare.obj"), (False, "four.obj")])
        self.assertEqual(data["unseen"], [{"file": "four.png", "why": "is on a mesh that has no texture coordinates", "shapes": 1}])
        points = [[-0.5, 2 * i + y, z] for i in range(5) for z in (0.25, -0.25) for y in (0.25, -0.25)]
        results = self.browse({"page": page, "steps": [LOOK, PIXELS % points]})[0]["results"]
        seen = [main_color(pixel) for pixel in results[1]]
        self.assertEqual(seen, 3 * ["r", "g", "rg", "rgb"] + 8 * ["rgb"], results[1])

    def test_textures_that_a_mesh_names_are_listed(self):
        image = "<texture texture='s' texcoord='c'/>"
        files = {"own.obj": obj(head="mtllib own.mtl\n"), "own.dae": collada(image), "own.gltf": gltf(baseColorTexture={"index": 0}),
                 "plain.dae": collada()}
        for name, text in files.items():
            self.write(name, text)
        self.write("own.mtl", "newmtl m\nmap_Kd wood.png\n")
        red = '<material name="red"><color rgba="1 0 0 1"/></material>'
        self.write("robot.urdf", meshes([*((name, "") for name in files), ("own.dae", red)]))
        done = self.run_tool("robot.urdf", "--format", "html", "-o", "page.html", "--force")
        unseen = self.data(self.folder / "page.html")[0]["unseen"]
        why = "has textures of its own, which are not shown"
        self.assertEqual(unseen, [{"file": name, "why": why, "shapes": 1} for name in ("own.dae", "own.gltf", "own.obj")])
        self.assertRegex(done.stderr, "3 textures|textures \\(")

    def test_what_is_no_picture_is_named(self):
        files = {"evil.png": SVG, "page.png": b"<script>window.hacked=4</script>", "huge.png": png([[RED]], 5000, 5000),
                 "damaged.png": png([[RED]], 4, 4), HOSTILE: png([[GREEN]]), "cut.jpg": JPEG[:100],
                 "empty.png": png([[RED]])[:20], "wide.jpg": jpeg_of_two_frames()}
        for name, content in files.items():
            (self.folder / name).write_bytes(content)
        self.write("flat.stl", "solid s\nfacet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet\nendsolid s\n")
        urdf = boxes([texture(name) for name in (*files, "absent.png")])
        urdf = urdf.replace("</link>", '<visual><origin xyz="0 -2 0"/><geometry><mesh filename="flat.stl"/></geometry>'
                            + texture(HOSTILE) + "</visual></link>")
        self.write("robot.urdf", urdf)
        done = self.run_tool("robot.urdf", "--format", "html", "-o", "page.html", "--force")
        page = self.folder / "page.html"
        names = ["evil.png", "page.png", "huge.png", "cut.jpg", "empty.png", "wide.jpg", "absent.png"]
        for name in names:
            self.assertRegex(done.stderr, rf"textures \(.*`{re.escape(name)}`.*\) are not in the HTML")
        policy = re.search('http-equiv="Content-Security-Policy"\\s*content="([^"]*)"', page.read_text())[1]
        self.assertRegex(policy, "^default-src 'none'; script-src 'sha256-[^ ]*'; style-src 'sha256-[^ ]*'; base-uri 'none'; form-action 'none'$")
        steps = [LOOK, "[...document.querySelectorAll('#unseen-list li')].map((row) => row.textContent)",
                 "[window.hacked, document.images.length, document.scripts.length]",
                 PIXELS % [[-0.5, 8, 0], [-0.5, 0, 0]], "document.getElementById('unseen-boxes').hidden"]
        results = self.browse({"page": page, "steps": steps})[0]["results"]
        unseen = dict(re.match(r'(.*(?:png|jpg)) (.*) \(1 shape\)', row).groups() for row in results[1])
        self.assertEqual(set(unseen), {*names, "damaged.png", HOSTILE})
        for name in ("evil.png", "page.png", "cut.jpg", "empty.png"):
            self.assertEqual(unseen[name], "is neither PNG nor JPEG")
        for name in ("huge.png", "wide.jpg"):
            self.assertEqual(unseen[name], "would make more than 16000000 pixels of textures")
        self.assertEqual(unseen["damaged.png"], "is damaged")
        self.assertEqual(unseen[HOSTILE], "is on a mesh that has no texture coordinates")
        self.assertEqual(results[2], [None, 0, 2])
        self.assertEqual([main_color(pixel) for pixel in results[3]], ["g", "rgb"])
        limited = self.run_tool("robot.urdf", "--format", "html", "-o", "limited.html", "--force", "--limit", "image-pixels=1")
        self.assertIn("damaged.png", limited.stderr)
        self.assertNotIn("damaged.png", done.stderr)

    def test_annotations_replace_colours_and_add_textures(self):
        (self.folder / "four.png").write_bytes(png([[GREEN]]))
        self.write("urdf/robot.urdf", boxes(['<material name="plain"><color rgba="1 0 0 1"/></material>', '<material name="other"/>',
                                             '<material name="plain"/>', '<material name="bare"/>'])
                   .replace('<link name="l">', '<material name="other"><color rgba="0 0 1 1"/></material><link name="l">'))
        self.write("robot.smurf", "modelname: r\nfiles: [urdf/robot.urdf, looks.yml]\n")
        self.write("looks.yml", """materials:
- {name: plain, diffuseColor: {r: 0, g: 1, b: 0, a: 1}, specularColor: {r: 1, g: 1, b: 1, a: 1}, transparency: 0.5}
- {name: bare, diffuseTexture: four.png}
- {name: unknown, diffuseColor: {r: 0, g: 1, b: 0, a: 1}}
visuals:
- {name: v2, materialName: other, shadowcaster: true}
""")
        done = self.run_tool("robot.smurf", "--format", "html", "-o", "page.html", "--force")
        self.assertIn(": 1 material\n", done.stderr)
        self.assertIn("also lost: 1 material setting, 1 visual setting\n", done.stderr)
        page = self.folder / "page.html"
        visuals = self.data(page)[0]["models"][0]["links"][0]["visuals"]
        self.assertEqual([one.get("color") for one in visuals], [[0, 1, 0, 0.5], [0, 0, 1, 1], [0, 0, 1, 1], None])
        self.assertEqual([one.get("texture") for one in visuals], [None, None, None, 0])
        results = self.browse({"page": page, "steps": [LOOK, PIXELS % [[-0.5, 6, 0]]]})[0]["results"]
        self.assertEqual(main_color(results[1][0]), "g")


if __name__ == "__main__":
    viewer.main()
