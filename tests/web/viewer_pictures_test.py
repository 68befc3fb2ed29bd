# SPDX-License-Identifier: BSD-3-Clause
"""Compares pictures of the page of a scene with reviewed ones in tests/web/pictures.

Usage: viewer_pictures_test.py TOOL BUILD
With SMURF_UPDATE_SNAPSHOTS=1 it writes them instead: look at them before you commit them.
"""
import itertools
import os
import pathlib
import struct
import zlib

import viewer
from viewer import cli

PICTURES = pathlib.Path(__file__).resolve().parent / "pictures"
ARM = cli.FIXTURES / "models/arm/smurf/arm.smurf"
WINDOW = {"width": 400, "height": 600}  # the picture in it has 400 by 288 pixels
MOST_BYTES = 32_000
# Versions of Chromium draw edges differently by a pixel. A channel has values up to 255.
MOST_MEAN = 0.5  # difference of the channels of all pixels
CLEAR = 32  # a pixel differs when a channel does by more
MOST_SHARE = 0.005  # of pixels that differ
ROBOTS = """entities:
- {{name: left, file: "{arm}", position: [0, 0.5, 0], rotation: [0, 0, 60]}}
- {{name: right, file: "{arm}", position: [{x}, -0.5, 0], rotation: [0, 0, -30]}}
- {{name: tilted, file: "{arm}", position: [-0.5, 0, 0.25], rotation: [0, 40, 0]}}
- {{name: table, type: primitive, geometry: {{type: box}}, extend: {{x: 0.4, y: 0.4, z: 0.2}}, position: {{x: 0.5, y: 0, z: 0.1}},
   material: {{diffuseColor: {{r: 0.6, g: 0.4, b: 0.2, a: 1}}}}}}
"""
DRAWN = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done())))"


def unfiltered(lines, step):
    """The bytes of a PNG's rows, each of which begins with its filter. `step`: bytes of a pixel."""
    above = None
    for line in lines:
        kind, row = line[0], bytearray(line[1:])
        above = above or bytes(len(row))
        for i in range(len(row)):
            left = row[i - step] if i >= step else 0
            corner = above[i - step] if i >= step else 0
            if kind == 1:
                row[i] = (row[i] + left) % 256
            elif kind == 2:
                row[i] = (row[i] + above[i]) % 256
            elif kind == 3:
                row[i] = (row[i] + (left + above[i]) // 2) % 256
            elif kind == 4:
                nearest = min((left, above[i], corner), key=lambda value, i=i, p=left + above[i] - corner: abs(p - value))
                row[i] = (row[i] + nearest) % 256
        above = bytes(row)
        yield above


def read_png(path):
    """(width, height, red, green and blue of all pixels) of a PNG as Chromium writes it."""
    data = path.read_bytes()
    width, height, depth, kind = struct.unpack(">IIBB", data[16:26])
    assert depth == 8 and kind in (2, 6), f"{path} has another kind of pixels"
    at, packed = 8, b""
    while at < len(data):
        size, = struct.unpack(">I", data[at:at + 4])
        if data[at + 4:at + 8] == b"IDAT":
            packed += data[at + 8:at + 8 + size]
        at += size + 12
    step = {2: 3, 6: 4}[kind]
    lines = zlib.decompress(packed)
    length = width * step + 1
    rows = unfiltered((lines[i:i + length] for i in range(0, len(lines), length)), step)
    pixels = bytes(itertools.chain.from_iterable(rows))
    if step == 4:
        pixels = bytes(itertools.chain.from_iterable(pixels[i:i + 3] for i in range(0, len(pixels), 4)))
    return width, height, pixels


def difference(a, b):
    """(mean difference of the channels, share of the pixels that differ)."""
    assert a[:2] == b[:2], f"the sizes {a[:2]} and {b[:2]} differ"
    gaps = [abs(x - y) for x, y in zip(a[2], b[2])]
    clear = sum(max(gaps[i:i + 3]) > CLEAR for i in range(0, len(gaps), 3))
    return sum(gaps) / len(gaps), 3 * clear / len(gaps)


def is_same(found):
    mean, share = found
    return mean <= MOST_MEAN and share <= MOST_SHARE


class PicturesTest(viewer.ViewerTest):
    def draw(self, jobs):
        """The files of the pictures of {name: (page, scheme, script)}."""
        files = {name: self.folder / f"{name}.png" for name in jobs}
        self.browse(*({**WINDOW, "page": page, "scheme": scheme,
                       "steps": [script, DRAWN, {"shot": str(files[name]), "of": "#stage"}]}
                      for name, (page, scheme, script) in jobs.items()))
        return files

    def robots(self, name, x):
        self.write(f"{name}.smurfs", ROBOTS.format(arm=ARM, x=x))
        return self.page(f"{name}.smurfs", f"{name}.html")

    def compare(self, file, reference):
        """The difference from a reviewed picture, which is written instead if snapshots are updated."""
        if os.environ.get("SMURF_UPDATE_SNAPSHOTS") == "1":
            reference.write_bytes(file.read_bytes())
        self.assertTrue(reference.is_file(), f"{reference} is missing: run with SMURF_UPDATE_SNAPSHOTS=1")
        self.assertLess(reference.stat().st_size, MOST_BYTES)
        return difference(read_png(file), read_png(reference))

    def test_pictures_equal_the_reviewed_ones(self):
        arm, robots, moved = self.page(ARM, "arm.html"), self.robots("robots", 0), self.robots("moved", 0.2)
        bent = viewer.set_positions(0, {"joint2_shoulder": 0.2})
        jobs = {"arm-light": (arm, "light", ""), "arm-dark": (arm, "dark", ""), "robots-light": (robots, "light", ""),
                "robots-dark": (robots, "dark", ""),
                "sensors-light": (arm, "light", "smurfViewer.press('sensors'), document.getElementById('ground').click()"),
                "frames-dark": (arm, "dark", "for (const id of ['frames', 'axes', 'masses', 'inertias']) smurfViewer.press(id)")}
        wrong = {"robots-light": (moved, "light", ""), "arm-light": (arm, "light", bent)}
        files = self.draw({**jobs, **{f"{name} changed": job for name, job in wrong.items()}})
        for name in jobs:
            found = self.compare(files[name], PICTURES / f"{name}.png")
            print(f"{name}: mean difference {found[0]:.3f}, {100 * found[1]:.3f} % of the pixels differ")
            self.assertTrue(is_same(found), f"{name}: {found}; the picture is {files[name]}")
        for name in wrong:  # one robot stands 20 cm farther; a joint is bent by 11 degrees
            found = difference(read_png(files[f"{name} changed"]), read_png(PICTURES / f"{name}.png"))
            print(f"{name}, changed: mean difference {found[0]:.3f}, {100 * found[1]:.3f} % of the pixels differ")
            self.assertFalse(is_same(found), f"{name} looks the same when the robot is moved: {found}")


if __name__ == "__main__":
    viewer.main()
