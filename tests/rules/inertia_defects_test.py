# SPDX-License-Identifier: BSD-3-Clause
"""Are wrong inertials found whatever the shape, and is the cause named?

usage: inertia_defects_test.py SMURF_LINT [-v]

Ten parts of a robot, each as a box, a cylinder and a closed mesh in four formats, with one mistake: of units, of the
size of the shape, of a tensor. The same parts without a mistake raise nothing.
"""
import json
import math
import pathlib
import re
import struct
import subprocess
import sys
import tempfile

TOOL = sys.argv[1]
# Size in m and density in kg/m3.
PARTS = {
    "upper_arm": (0.3, 0.06, 0.08, 900), "finger": (0.05, 0.02, 0.015, 1200), "base": (0.6, 0.4, 0.2, 300),
    "tyre": (0.2, 0.2, 0.05, 1100), "plate": (0.4, 0.3, 0.02, 2700), "head": (0.15, 0.12, 0.18, 500),
    "foot": (0.2, 0.1, 0.04, 1500), "rod": (0.8, 0.03, 0.04, 1600), "gripper": (0.1, 0.08, 0.06, 2000),
    "torso": (0.3, 0.25, 0.5, 400)}
FORMS = ["box", "cylinder", "stl", "obj", "dae", "glb"]
FILL = 0.9  # of the moments of a full shape: mass is nearer to the middle


def sphere(size, rows=12, columns=16):
    """Points and triangles of an ellipsoid that faces outward."""
    points = []
    for row in range(1, rows):
        v = math.pi * row / rows
        for column in range(columns):
            u = 2 * math.pi * column / columns
            points.append((math.sin(v) * math.cos(u), math.sin(v) * math.sin(u), math.cos(v)))
    points += [(0, 0, 1), (0, 0, -1)]
    triangles = []
    for row in range(rows - 2):
        for column in range(columns):
            a, b = row * columns + column, row * columns + (column + 1) % columns
            triangles += [(a, a + columns, b + columns), (a, b + columns, b)]
    top, last = len(points) - 2, (rows - 2) * columns
    for column in range(columns):
        other = (column + 1) % columns
        triangles += [(top, column, other), (top + 1, last + other, last + column)]
    return [tuple(c * s / 2 for c, s in zip(point, size)) for point in points], triangles


def write_stl(path, points, triangles):
    data = b" " * 80 + struct.pack("<I", len(triangles))
    for triangle in triangles:
        corners = [c for corner in triangle for c in points[corner]]
        data += struct.pack("<12fH", 0, 0, 0, *corners, 0)
    path.write_bytes(data)


def write_obj(path, points, triangles):
    lines = ["v %.9g %.9g %.9g" % point for point in points]
    lines += ["f %d %d %d" % tuple(corner + 1 for corner in triangle) for triangle in triangles]
    path.write_text("\n".join(lines) + "\n")


def write_dae(path, points, triangles):
    numbers = " ".join("%.9g" % c for point in points for c in point)
    corners = " ".join(str(corner) for triangle in triangles for corner in triangle)
    path.write_text(f"""<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="{3 * len(points)}">{numbers}
</float_array><technique_common><accessor source="#a" count="{len(points)}" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="{len(triangles)}">
<input semantic="VERTEX" source="#v" offset="0"/><p>{corners}</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"/></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>
""")


def write_glb(path, points, triangles):
    corners = b"".join(struct.pack("<3I", *triangle) for triangle in triangles)
    places = b"".join(struct.pack("<3f", x, z, -y) for x, y, z in points)  # the y axis is up
    data = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 1}, "indices": 0}]}],
            "buffers": [{"byteLength": len(corners) + len(places)}],
            "bufferViews": [{"buffer": 0, "byteLength": len(corners)},
                            {"buffer": 0, "byteOffset": len(corners), "byteLength": len(places)}],
            "accessors": [
                {"bufferView": 0, "componentType": 5125, "type": "SCALAR", "count": 3 * len(triangles)},
                {"bufferView": 1, "componentType": 5126, "type": "VEC3", "count": len(points)}]}
    text = json.dumps(data).encode()
    text += b" " * (-len(text) % 4)
    size = 28 + len(text) + len(corners) + len(places)
    path.write_bytes(b"glTF" + struct.pack("<3I", 2, size, len(text)) + b"JSON" + text +
                     struct.pack("<I", len(corners + places)) + b"BIN\0" + corners + places)


WRITE = {"stl": write_stl, "obj": write_obj, "dae": write_dae, "glb": write_glb}


def body(form, size, density):
    """Mass and moments of a part."""
    x, y, z = size
    if form == "box":
        volume, squares = x * y * z, [s * s / 12 for s in size]
    elif form == "cylinder":
        volume, squares = math.pi * x * x * z / 4, [x * x / 16, x * x / 16, z * z / 12]
    else:
        volume, squares = math.pi * x * y * z / 6, [s * s / 20 for s in size]
    mass = density * volume
    moments = [FILL * mass * (sum(squares) - square) for square in squares]
    return mass, moments


def shape(form, name, size, folder):
    x, y, z = size
    if form == "box":
        return f'<box size="{x:.6g} {y:.6g} {z:.6g}"/>'
    if form == "cylinder":
        return f'<cylinder radius="{x / 2:.6g}" length="{z:.6g}"/>'
    WRITE[form](folder / f"{name}.{form}", *sphere(size))
    return f'<mesh filename="{name}.{form}"/>'


# Mistake -> what it does to the part, and what a finding must say.
UNITS = {
    "mass in g": (lambda p: p.update(mass=p["mass"] * 1000), "mass in grams"),
    "inertia in g mm2": (lambda p: p.update(tensor=[v * 1e9 for v in p["tensor"]]), "in g mm2"),
    "inertia in kg mm2": (lambda p: p.update(tensor=[v * 1e6 for v in p["tensor"]]), "in kg mm2"),
    "shape in mm": (lambda p: p.update(size=[s * 1000 for s in p["size"]]), "in millimetres"),
    "shape 10 times too small": (lambda p: p.update(size=[s / 10 for s in p["size"]]), "10 times too small"),
    "shape 25.4 times too small": (lambda p: p.update(size=[s / 25.4 for s in p["size"]]), r"25\.4 times too small"),
}


def offset_tensor(part):
    (cx, cy, cz), m = part["center"], -part["mass"]
    t = part["tensor"]
    part["tensor"] = [t[0] + m * (cy * cy + cz * cz), t[1] + m * (cx * cx + cz * cz), t[2] + m * (cx * cx + cy * cy),
                      t[3] - m * cx * cy, t[4] - m * cx * cz, t[5] - m * cy * cz]


def add_offset(part):
    part["center"] = [s * 0.4 for s in part["size"]]
    offset_tensor(part)


def largest(tensor):
    return max(range(3), key=lambda i: tensor[i])


def times(part, place, factor):
    part["tensor"][place] *= factor


def lower_triangle(part):
    # Fills the slots ixx ixy ixz iyy iyz izz with xx xy yy xz yz zz.
    xx, yy, zz, xy, xz, yz = part["tensor"]
    part["tensor"] = [xx, xz, zz, xy, yy, yz]


def rod(part):
    smallest = min(range(3), key=lambda i: part["tensor"][i])
    part["tensor"][smallest] = 0


TENSORS = {
    "order of entries": (lower_triangle, "order of a lower triangle"),
    "sign of a moment": (lambda p: times(p, 1, -1), "sign of `iyy`"),
    "decimal point": (lambda p: times(p, largest(p["tensor"]), 10), "decimal point"),
    "subtracted offset": (add_offset, "subtracted twice|about the origin"),
    "rod without thickness": (rod, "rod|decimal point"),
    "a moment of a thousand": (lambda p: times(p, 0, 1000), "decimal point of `ixx`"),
}


def robot(form, mistake, folder):
    folder.mkdir()
    text = '<robot name="r">\n<link name="world_frame"/>\n'
    for name, (x, y, z, density) in PARTS.items():
        size = [x, x if form == "cylinder" else y, z]
        mass, moments = body(form, size, density)
        part = {"mass": mass, "tensor": moments + [0, 0, 0], "size": size, "center": [0, 0, 0]}
        if mistake:
            mistake(part)
        t = part["tensor"]
        text += f"""<link name="{name}"><inertial><origin xyz="{' '.join('%.6g' % c for c in part['center'])}"/>
<mass value="{part['mass']:.6g}"/>
<inertia ixx="{t[0]:.6g}" ixy="{t[3]:.6g}" ixz="{t[4]:.6g}" iyy="{t[1]:.6g}" iyz="{t[5]:.6g}" izz="{t[2]:.6g}"/></inertial>
<collision><geometry>{shape(form, name, part['size'], folder)}</geometry></collision></link>
<joint name="{name}_joint" type="revolute"><parent link="world_frame"/><child link="{name}"/><axis xyz="0 0 1"/>
<limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
"""
    (folder / "r.urdf").write_text(text + "</robot>\n")
    done = subprocess.run([TOOL, "--isolated", "--format", "json", "r.urdf"], cwd=folder, capture_output=True, text=True)
    assert done.returncode in (0, 1), done.stderr
    return json.loads(done.stdout)["diagnostics"]


def is_about_mass(finding):
    return finding["id"].startswith("SML15") or finding["id"] in ("SML1630", "SML1646")


def judge(mistakes, folder, at_least_found, at_least_named):
    failures = 0
    for form in FORMS:
        found = named = 0
        missed = []
        for number, (title, (mistake, words)) in enumerate(mistakes.items()):
            findings = [one for one in robot(form, mistake, folder / f"{form}-{number}") if is_about_mass(one)]
            for name in PARTS:
                own = [one for one in findings if f"`{name}`" in one["message"] or name in str(one.get("labels", ""))]
                own += [one for one in findings if one["id"] == "SML1630"]  # one for all files
                texts = " ".join(str(one) for one in own)
                found += bool(own)
                is_named = re.search(words, texts) is not None
                named += is_named
                if not is_named:
                    missed.append(f"{title}, {name}: " + (str(own[0].get("help", "no help")) if own else "silent"))
        print(f"{form}: {found} of 60 found, {named} named")
        if "-v" in sys.argv:
            print("   " + "\n   ".join(missed))
        failures += found < at_least_found or named < at_least_named
    return failures


def main():
    failures = 0
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        for form in FORMS:
            clean = [one for one in robot(form, None, folder / f"{form}-clean") if is_about_mass(one)]
            for one in clean:
                print(f"{form}, without a mistake: {one['rule']} {one['message']}")
            failures += len(clean)
        (folder / "units").mkdir()
        failures += judge(UNITS, folder / "units", 58, 50)
        (folder / "tensors").mkdir()
        failures += judge(TENSORS, folder / "tensors", 58, 50)
    return 1 if failures else 0


sys.exit(main())
