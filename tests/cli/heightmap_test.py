# SPDX-License-Identifier: BSD-3-Clause
"""Heights of images in MJCF: every way to pack a PNG, and damaged ones. What MuJoCo makes of them: mujoco_dynamics_test.

Usage: heightmap_test.py SMURFS-FLATTEN
"""
import random
import re
import struct
import zlib

import cli


def chunk(name, content):
    return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))


def png(lines, width, height, packer, kind=0, depth=8, parts=1):
    """`lines`: the filtered rows."""
    packed = packer.compress(lines) + packer.flush()
    size = -(-len(packed) // parts)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, depth, kind, 0, 0, 0))
            + b"".join(chunk(b"IDAT", packed[at:at + size]) for at in range(0, len(packed), size))
            + chunk(b"IEND", b""))


def filtered(rows, kinds, pixel=1):
    """The rows of bytes with the filters of PNG."""
    text = b""
    above = bytes(len(rows[0]))
    for row, kind in zip(rows, kinds):
        line = bytearray()
        for i, value in enumerate(row):
            a = row[i - pixel] if i >= pixel else 0
            b = above[i]
            c = above[i - pixel] if i >= pixel else 0
            distances = [abs(b - c), abs(a - c), abs(a + b - 2 * c)]
            guess = (0, a, b, (a + b) // 2, (a, b, c)[distances.index(min(distances))])[kind]
            line.append((value - guess) % 256)
        text += bytes([kind]) + bytes(line)
        above = row
    return text


class HeightmapTest(cli.CliTest):
    def heights(self, image, *arguments):
        """Height and lift of the field, or the complaint."""
        self.write("h.png", image)
        self.write("s.smurfs", "entities: [{name: t, type: heightmap, file: h.png, anchor: world, width: 8, length: 4, "
                               "height: 255, position: [0, 0, 0]}]\n")
        done = self.run_tool("s.smurfs", "--format", "mjcf", *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        size = re.search(r'size="2 4 ([^ ]*) [^ ]*"', done.stdout)
        return (float(size[1]), float(re.search(r'hfield="t" name="t" pos="0 0 ([^"]*)"', done.stdout)[1])) if size else done.stderr

    def assert_heights(self, image, low, high):
        found = self.heights(image)
        self.assertAlmostEqual(found[0], high - low, delta=1e-9)
        self.assertAlmostEqual(found[1], low, delta=1e-9)

    def test_every_way_to_pack(self):
        source = random.Random(1)
        for width, height in ((1, 1), (3, 2), (40, 30), (300, 200)):
            low, high = source.randrange(100), source.randrange(150, 256)
            rows = [bytes(source.choice((low, high, source.randrange(low, high + 1))) for _ in range(width))
                    for _ in range(height)]
            low, high = min(map(min, rows)), max(map(max, rows))
            lines = filtered(rows, [source.randrange(5) for _ in rows])
            for level in (0, 1, 9):
                for strategy in (zlib.Z_DEFAULT_STRATEGY, zlib.Z_FIXED, zlib.Z_HUFFMAN_ONLY, zlib.Z_RLE):
                    packer = zlib.compressobj(level, zlib.DEFLATED, 15, 8, strategy)
                    image = png(lines, width, height, packer, parts=source.randrange(1, 4))
                    if low == high:
                        self.assertEqual(self.heights(image)[1], low)
                    else:
                        self.assert_heights(image, low, high)

    def test_sixteen_bits(self):
        rows = [struct.pack(">4H", 257 * 10, 257 * 10 + 128, 257 * 200, 257 * 99)] * 3
        image = png(filtered(rows, (4, 3, 1), pixel=2), 4, 3, zlib.compressobj(), depth=16)
        self.assert_heights(image, 10, 200)

    def test_damage_is_named_and_never_stops_the_tool(self):
        source = random.Random(2)
        rows = [bytes(source.randrange(256) for _ in range(30)) for _ in range(20)]
        image = png(filtered(rows, [4] * 20), 30, 20, zlib.compressobj())
        self.assertIn("its heightmap `h.png` is damaged", self.heights(image[:60] + image[90:]))
        for _ in range(150):
            broken = bytearray(image)
            for _ in range(source.randrange(1, 4)):
                broken[source.randrange(8, len(broken))] = source.randrange(256)
            self.heights(bytes(broken[:source.choice((len(broken), source.randrange(8, len(broken))))]))

    def test_too_many_pixels(self):
        rows = [bytes(range(100))] * 100
        image = png(filtered(rows, [0] * 100), 100, 100, zlib.compressobj())
        self.assert_heights(image, 0, 99)
        self.assertIn("its heightmap `h.png` has more than 9999 pixels",
                      self.heights(image, "--limit", "image-pixels=9999"))
        huge = png(b"\0" * 100, 0x7fffffff, 0x7fffffff, zlib.compressobj())
        self.assertIn("its heightmap `h.png` has more than", self.heights(huge))


if __name__ == "__main__":
    cli.main()
