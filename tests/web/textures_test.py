# SPDX-License-Identifier: BSD-3-Clause
"""Tests the textures and the colours of annotations on the page of a scene.

Usage: textures_test.py TOOL BUILD
"""
import base64
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
    """One of 16,000 x 16,000 pixels behind a marker without length, and a small one where the marker's length would lead."""
    frame = b"\xff\xc0\0\x11\x08%s%s"
    start = b"\xff\xd8\xff\xd0" + frame % (b"\x3e\x80", b"\x3e\x80")
    return start.ljust(4 + 0xffc0, b"\0") + frame % (b"\0\4", b"\0\4") + bytes(20)


def main_color(pixel):
    """The colour without what the light makes of it."""
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
        self.assertEqual(unseen[HOSTILE], "is on a mesh, whose texture coordinates are not read")
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
        self.assertIn("1 material, 1 material setting, 1 visual setting", done.stderr)
        page = self.folder / "page.html"
        visuals = self.data(page)[0]["models"][0]["links"][0]["visuals"]
        self.assertEqual([one.get("color") for one in visuals], [[0, 1, 0, 0.5], [0, 0, 1, 1], [0, 0, 1, 1], None])
        self.assertEqual([one.get("texture") for one in visuals], [None, None, None, 0])
        results = self.browse({"page": page, "steps": [LOOK, PIXELS % [[-0.5, 6, 0]]]})[0]["results"]
        self.assertEqual(main_color(results[1][0]), "g")


if __name__ == "__main__":
    viewer.main()
