#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Are defects of masses, tensors and meshes found where the link beside them is right, and are clean twins silent?

usage: planted_defects_test.py SMURF_LINT [-v]

80 robots of a base, two mirrored arms and a wheel, each with one defect of 24 kinds; shapes are a box, a cylinder, or a mesh
in four formats. A defect counts as found if a warning or an error names its link. The same robots without a defect raise
nothing about masses and meshes.
"""
import json
import math
import pathlib
import struct
import subprocess
import sys
import tempfile

TOOL = sys.argv[1]
LEAST_FOUND = 74
MESHES = ("stl", "obj", "dae", "glb")
SIZE, DENSITY = (0.3, 0.08, 0.05), 800
CENTER = (0.14, 0.05, 0.02)  # of the arm, in the frame of its link
TURN = (0.2, -0.3, 0.4)  # rpy of the arm
FILL = {"stl": 1, "obj": 1, "dae": 1, "glb": 1, "box": 1, "cylinder": 1}


def rotation(rpy):
    (cr, sr), (cp, sp), (cy, sy) = ((math.cos(a), math.sin(a)) for a in rpy)
    return ((cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr),
            (sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr), (-sp, cp * sr, cp * cr))


def times(matrix, vector):
    return tuple(sum(row[k] * vector[k] for k in range(3)) for row in matrix)


def wedge(size):
    """A closed body without symmetry: a box, whose top is smaller and to one side."""
    x, y, z = (s / 2 for s in size)
    points = [(-x, -y, -z), (x, -y, -z), (x, y, -z), (-x, y, -z), (-x, -y, z), (0.4 * x, -y, z), (0.4 * x, 0.3 * y, z), (-x, 0.3 * y, z)]
    quads = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
    return points, [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]


def body_of(points, triangles):
    """Volume, centre, and the tensor about the centre at density 1, by tetrahedra from the origin."""
    volume, first, second = 0.0, [0.0] * 3, [[0.0] * 3 for _ in range(3)]
    for a, b, c in ([points[i] for i in t] for t in triangles):
        det = (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]))
        volume += det / 6
        total = [a[k] + b[k] + c[k] for k in range(3)]
        for i in range(3):
            first[i] += det / 24 * total[i]
            for k in range(3):
                second[i][k] += det / 120 * (a[i] * a[k] + b[i] * b[k] + c[i] * c[k] + total[i] * total[k])
    center = tuple(one / volume for one in first)
    moments = [[second[i][k] - volume * center[i] * center[k] for k in range(3)] for i in range(3)]
    trace = sum(moments[i][i] for i in range(3))
    return volume, center, [[(trace if i == k else 0) - moments[i][k] for k in range(3)] for i in range(3)]


def turned(tensor, matrix):
    return [[sum(matrix[i][a] * tensor[a][b] * matrix[k][b] for a in range(3) for b in range(3)) for k in range(3)] for i in range(3)]


class Part:
    """A link: its shape, the pose of it, and an inertial that fits."""

    def __init__(self, form, side=1, size=SIZE, density=DENSITY, center=CENTER, turn=TURN):
        self.form, self.side, self.scale, self.flip, self.repeat = form, side, 1.0, "", 1
        self.size, self.density = size, density
        self.origin = (center[0], side * center[1], center[2])
        self.turn = (side * turn[0], turn[1], side * turn[2])
        matrix = rotation(self.turn)
        if form in MESHES:
            points, triangles = wedge(size)
            if side < 0:
                points, triangles = [(x, -y, z) for x, y, z in points], [(a, c, b) for a, b, c in triangles]
            self.points, self.triangles = points, triangles
            volume, middle, tensor = body_of(points, triangles)
        else:
            x, y, z = size
            middle = (0, 0, 0)
            if form == "box":
                volume = x * y * z
                squares = [s * s / 12 for s in size]
            else:
                self.size = size = (y, y, x)
                volume = math.pi * y * y / 4 * x
                squares = [y * y / 16, y * y / 16, x * x / 12]
            tensor = [[volume * (sum(squares) - squares[i]) if i == k else 0 for k in range(3)] for i in range(3)]
        self.mass = density * volume
        self.com = tuple(o + m for o, m in zip(self.origin, times(matrix, middle)))
        full = turned(tensor, matrix)
        self.tensor = [density * v for v in (full[0][0], full[1][1], full[2][2], full[0][1], full[0][2], full[1][2])]

    def geometry(self, name, folder):
        x, y, z = self.size
        if self.form == "box":
            return f'<box size="{x:.7g} {y:.7g} {z:.7g}"/>'
        if self.form == "cylinder":
            return f'<cylinder radius="{x / 2:.7g}" length="{z:.7g}"/>'
        triangles = self.triangles
        if self.flip:
            triangles = [(a, c, b) if self.flip == "all" or i % 3 == 0 else (a, b, c) for i, (a, b, c) in enumerate(triangles)]
        WRITE[self.form](folder / f"{name}.{self.form}", self.points, triangles * self.repeat)
        scale = "" if self.scale == 1 else f' scale="{self.scale:g} {self.scale:g} {self.scale:g}"'
        return f'<mesh filename="{name}.{self.form}"{scale}/>'

    def text(self, name, folder):
        numbers = {"xyz": " ".join(f"{v:.8g}" for v in self.origin), "rpy": " ".join(f"{v:.8g}" for v in self.turn)}
        shape = f'<origin xyz="{numbers["xyz"]}" rpy="{numbers["rpy"]}"/><geometry>{self.geometry(name, folder)}</geometry>'
        t = self.tensor
        return (f'<link name="{name}"><inertial><origin xyz="{" ".join(f"{v:.8g}" for v in self.com)}"/><mass value="{self.mass:.8g}"/>'
                f'<inertia ixx="{t[0]:.8g}" ixy="{t[3]:.8g}" ixz="{t[4]:.8g}" iyy="{t[1]:.8g}" iyz="{t[5]:.8g}" izz="{t[2]:.8g}"/></inertial>\n'
                f"<visual>{shape}</visual><collision>{shape}</collision></link>\n")


def write_stl(path, points, triangles):
    path.write_bytes(b"\0" * 80 + struct.pack("<I", len(triangles)) + b"".join(
        struct.pack("<12fH", 0, 0, 0, *points[a], *points[b], *points[c], 0) for a, b, c in triangles))


def write_obj(path, points, triangles):
    path.write_text("".join("v {} {} {}\n".format(*point) for point in points) +
                    "".join("f {} {} {}\n".format(*(i + 1 for i in three)) for three in triangles))


def write_dae(path, points, triangles):
    numbers = " ".join(repr(c) for point in points for c in point)
    path.write_text(f"""<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="{3 * len(points)}">{numbers}</float_array>
<technique_common><accessor source="#a" count="{len(points)}" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="{len(triangles)}">
<input semantic="VERTEX" source="#v" offset="0"/><p>{" ".join(str(i) for three in triangles for i in three)}</p></triangles></mesh></geometry>
</library_geometries><library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"/></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>
""")


def write_glb(path, points, triangles):
    places = b"".join(struct.pack("<3f", x, z, -y) for x, y, z in points)  # y is up
    corners = b"".join(struct.pack("<3I", *three) for three in triangles)
    text = json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "buffers": [{"byteLength": len(places + corners)}],
        "bufferViews": [{"buffer": 0, "byteLength": len(places)},
                        {"buffer": 0, "byteOffset": len(places), "byteLength": len(corners)}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": len(points)},
                      {"bufferView": 1, "componentType": 5125, "type": "SCALAR", "count": 3 * len(triangles)}]}).encode()
    text += b" " * (-len(text) % 4)
    data = places + corners
    path.write_bytes(b"glTF" + struct.pack("<3I", 2, 28 + len(text) + len(data), len(text)) + b"JSON" + text +
                     struct.pack("<I", len(data)) + b"BIN\0" + data)


WRITE = {"stl": write_stl, "obj": write_obj, "dae": write_dae, "glb": write_glb}


def scaled(part, factor):
    part.tensor = [v * factor for v in part.tensor]


def order(part):
    xx, yy, zz, xy, xz, yz = part.tensor
    part.tensor = [xx, xz, zz, xy, yy, yz]


def about_origin(part):
    x, y, z = part.com
    m, t = part.mass, part.tensor
    part.tensor = [t[0] + m * (y * y + z * z), t[1] + m * (x * x + z * z), t[2] + m * (x * x + y * y),
                   t[3] - m * x * y, t[4] - m * x * z, t[5] - m * y * z]


def no_products(part):
    """The products of a part along its axes are 0."""
    part.__init__(part.form, part.side, center=CENTER, turn=(0, 0, 0))


def swapped(part):
    no_products(part)
    t = part.tensor
    part.tensor = [t[2], t[1], t[0], *t[3:]]


def set_com(part, com):
    part.com = com


def heavier(part, density):
    factor = density / part.density
    part.mass *= factor
    scaled(part, factor)


JOINT = (0.05, 0.12, 0.04)
ALL = ("box", "cylinder", *MESHES)
# Kind: forms, what it does to the left arm (to the right one: see below).
KINDS = {
    "inertia in kg mm2": (("box", "stl", "glb"), lambda p: scaled(p, 1e6)),
    "inertia in g mm2": (("cylinder", "obj", "dae"), lambda p: scaled(p, 1e9)),
    "inertia in lb in2": (("box", "stl", "dae"), lambda p: scaled(p, 1 / 2.926e-4)),
    "inertia in kg cm2": (("cylinder", "obj", "glb"), lambda p: scaled(p, 1e4)),
    "order of the entries": (MESHES, order),
    "sign of a moment": (("box", "stl", "obj"), lambda p: p.tensor.__setitem__(1, -p.tensor[1])),
    "tensor of another link": (("box", "dae", "glb"), lambda p: scaled(p, 60)),
    "a moment beyond rounding": (("cylinder", "stl", "obj"), lambda p: p.tensor.__setitem__(2, 1.1 * (p.tensor[0] + p.tensor[1]))),
    "mass in g": (("box", "stl", "glb"), lambda p: setattr(p, "mass", 1000 * p.mass)),
    "centre in mm": (("cylinder", "obj", "dae"), lambda p: set_com(p, tuple(1000 * v for v in p.com))),
    "sign of the centre": (("box", "stl", "dae"), lambda p: set_com(p, (-p.com[0], p.com[1], p.com[2]))),
    "all normals inward": (MESHES, lambda p: setattr(p, "flip", "all")),
    "some normals inward": (MESHES, lambda p: setattr(p, "flip", "some")),
    "mesh in mm": (MESHES, lambda p: setattr(p, "points", [tuple(1000 * v for v in q) for q in p.points])),
    "mesh 100 times too small": (MESHES, lambda p: setattr(p, "scale", 0.01)),
    "axes swapped": (("box", "stl", "obj"), swapped),
    "wheel about the wrong axis": (("cylinder", "stl", "dae"), None),
    "centre in the parent's frame": (("box", "stl", "obj"), lambda p: set_com(p, tuple(c + j for c, j in zip(p.com, JOINT)))),
    "signs of the products": (MESHES, lambda p: p.tensor.__setitem__(slice(3, 6), [-v for v in p.tensor[3:]])),
    "right arm a copy of the left one": (MESHES, None),
    "tensor about the origin": (("box", "stl", "obj"), about_origin),
    "triangles twice": (MESHES, lambda p: setattr(p, "repeat", 2)),
    "63300 kg/m3": (("stl", "dae", "obj"), lambda p: heavier(p, 63300)),
    "0.8 kg/m3": (("stl", "glb", "box"), lambda p: heavier(p, 0.8)),
}


def robot(form, defect, folder):
    folder.mkdir(parents=True)
    parts = {"base": Part("box", size=(0.3, 0.25, 0.08), density=700, center=(0, 0, 0), turn=(0, 0, 0)), "left_arm": Part(form), "right_arm": Part(form, -1),
             "tail": Part("box", size=(0.2, 0.06, 0.04), density=750, center=(-0.15, 0, 0), turn=(0, 0.1, 0)),
             "wheel": Part("cylinder", size=(0.04, 0.12, 0.12), density=900, center=(0, 0, 0), turn=(0, 0, 0))}
    if defect == "wheel about the wrong axis":
        t = parts["wheel"].tensor
        parts["wheel"].tensor = [t[2], t[1], t[0], *t[3:]]
    elif defect == "right arm a copy of the left one":
        parts["right_arm"].com, parts["right_arm"].tensor = parts["left_arm"].com, parts["left_arm"].tensor
    elif defect:
        KINDS[defect][1](parts["left_arm"])
    text = '<?xml version="1.0"?>\n<robot name="planted">\n' + "".join(part.text(name, folder) for name, part in parts.items())
    for name, (x, y, z) in (("left_arm", JOINT), ("right_arm", (JOINT[0], -JOINT[1], JOINT[2])), ("wheel", (-0.1, 0, -0.12)), ("tail", (-0.16, 0, 0))):
        text += (f'<joint name="{name}_joint" type="revolute"><parent link="base"/><child link="{name}"/><origin xyz="{x} {y} {z}"/>'
                 '<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="10" velocity="2"/></joint>\n')
    (folder / "r.urdf").write_text(text + "</robot>\n")
    done = subprocess.run([TOOL, "--isolated", "--format", "json", "r.urdf"], cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode in (0, 1), done.stderr
    return [one for one in json.loads(done.stdout)["diagnostics"] if one["id"] == "SML1442" or (one["id"][:5] in ("SML15", "SML16") and one["id"] != "SML1631")]


def place_of(defect):
    return {"wheel about the wrong axis": "wheel", "right arm a copy of the left one": "right_arm"}.get(defect, "left_arm")


def main():
    found, total, clean, missed = 0, 0, 0, []
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        for form in ALL:
            for one in robot(form, None, folder / "clean" / form):
                print(f"{form}, without a defect: {one['id']} {one['severity']} {one['message']}")
                clean += 1
        for defect, (forms, _) in KINDS.items():
            for form in forms:
                total += 1
                findings = robot(form, defect, folder / defect.replace("/", " ") / form)
                shown = [one for one in findings if one["severity"] in ("warning", "error") and place_of(defect) in json.dumps(one)]
                found += bool(shown)
                if not shown:
                    missed.append(f"{defect}, {form}: " + ("; ".join(f"{one['id']} {one['severity']} {one['message']}" for one in findings) or "silent"))
    print(f"{found} of {total} found; {clean} findings about clean twins")
    if "-v" in sys.argv or found < LEAST_FOUND:
        print("  " + "\n  ".join(missed))
    return 0 if found >= LEAST_FOUND and clean == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
