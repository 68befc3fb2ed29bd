# SPDX-License-Identifier: BSD-3-Clause
"""Robots whose one mesh or texture is named in some way, or has some content, by place: visual, collision, both, texture.

A case is a folder with a package in it. A cell of paths_executed.tsv says `refuses`, `crashes`, `lost` (the robot is
there without the shape), `kept`, or, where the reader says how large the shape is, its box in mm: `100x200x400`.
"""
import dataclasses
import json
import math
import re
import struct

import robot as robots

PACKAGE = "robot_hand"
HERE = "{HERE}"  # the absolute path of the package
BODY = '<inertial><mass value="1"/><inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial>'
BOX = (0.1, 0.2, 0.4)

# Kind: the text of the path, the file that is there, the folder of the package, the name in its package.xml.
PATHS = {
    "plain": "../meshes/cube.stl", "from-above": "meshes/cube.stl", "missing": "../meshes/gone.stl",
    "package": "package://robot_hand/meshes/cube.stl", "package-missing": "package://robot_hand/meshes/gone.stl",
    "package-unknown": "package://nowhere/meshes/cube.stl",
    "package-three-slashes": "package:///meshes/cube.stl", "package-one-slash": "package:/robot_hand/meshes/cube.stl",
    "package-bare": "package://robot_hand",
    "file": "file://{HERE}/meshes/cube.stl", "file-missing": "file:///gone/cube.stl", "file-relative": "file://../meshes/cube.stl",
    "file-short": "file:../meshes/cube.stl", "absolute": "{HERE}/meshes/cube.stl", "absolute-missing": "/gone/cube.stl",
    "model": "model://robot_hand/meshes/cube.stl", "http": "http://127.0.0.1:9/cube.stl",
    "backslash": "..\\meshes\\cube.stl", "case": "../meshes/Cube.stl", "find": "file://$(find robot_hand)/meshes/cube.stl",
}
BESIDE = {"beside": "cube.stl", "package-three-slashes-beside": "package:///cube.stl", "package-file-beside": "package://cube.stl"}
DEEP = ("package", "package-three-slashes", "from-above")  # for a URDF far below its package
PLACES = ("visual", "collision", "both", "texture")


@dataclasses.dataclass
class Case:
    text: str
    files: dict
    folder: str = PACKAGE
    place: str = "collision"
    is_twin: bool = False
    urdf: str = "urdf/robot.urdf"


def document(shapes, after="", material=""):
    return (f'<robot name="r">{material}<link name="base">{BODY}</link><link name="hand">{BODY}{shapes}</link>'
            '<joint name="j" type="revolute"><parent link="base"/><child link="hand"/><origin xyz="0 0 1"/><axis xyz="0 0 1"/>'
            f'<limit lower="-1" upper="1" effort="1" velocity="1"/></joint>{after}</robot>\n')


def shapes_of(place, path):
    mesh = f'<geometry><mesh filename="{path}"/></geometry>'
    if place == "texture":
        return ('<visual><geometry><box size="0.1 0.1 0.1"/></geometry><material name="m">'
                f'<texture filename="{path}"/></material></visual>')
    places = ("visual", "collision") if place == "both" else (place,)
    return "".join(f"<{one}>{mesh}</{one}>" for one in places)


def box(size):
    corners, triangles = [], []
    x, y, z = size
    corners = [(a * x, b * y, c * z) for a in (-.5, .5) for b in (-.5, .5) for c in (-.5, .5)]
    for a, b, c, d in ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)):
        triangles += [(a, b, c), (a, c, d)]
    return corners, triangles


def many(count):
    """A ball of so many triangles."""
    rows = 2
    while 4 * rows * (rows - 1) < count:
        rows += 1
    columns = 2 * rows
    corners = [(0.1 * math.sin(math.pi * i / rows) * math.cos(2 * math.pi * k / columns),
                0.1 * math.sin(math.pi * i / rows) * math.sin(2 * math.pi * k / columns),
                0.1 * math.cos(math.pi * i / rows)) for i in range(rows + 1) for k in range(columns)]
    triangles = []
    for i in range(rows):
        for k in range(columns):
            a, b = i * columns + k, i * columns + (k + 1) % columns
            c, d = a + columns, b + columns
            triangles += [(a, c, d)] if i < rows - 1 else []
            triangles += [(a, d, b)] if i > 0 else []
    return corners, triangles


def glb(corners, triangles):
    points = b"".join(struct.pack("<3f", *corner) for corner in corners)
    indices = b"".join(struct.pack("<3H", *three) for three in triangles)
    data = points + indices
    low, high = ([function(corner[i] for corner in corners) for i in range(3)] for function in (min, max))
    scene = json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}], "buffers": [{"byteLength": len(data)}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": len(points)},
                        {"buffer": 0, "byteOffset": len(points), "byteLength": len(indices)}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": len(corners), "type": "VEC3", "min": low, "max": high},
                      {"bufferView": 1, "componentType": 5123, "count": 3 * len(triangles), "type": "SCALAR"}]}).encode()
    scene += b" " * (-len(scene) % 4)
    data += b"\0" * (-len(data) % 4)
    return (b"glTF" + struct.pack("<II", 2, 28 + len(scene) + len(data)) + struct.pack("<I", len(scene)) + b"JSON" + scene +
            struct.pack("<I", len(data)) + b"BIN\0" + data)


def dae(size, change=lambda text: text):
    return change(robots.dae(*box(size)).replace(b'count="8"', b'count="8"'))


def contents():
    """{kind: (name of the file, its bytes)}"""
    flat = ([(0, 0, 0), (.1, 0, 0), (.1, .2, 0), (0, .2, 0)], [(0, 1, 2), (0, 2, 3)])
    tilted = ([(0, 0, 0), (.1, 0, .1), (.1, .2, .1), (0, .2, 0)], [(0, 1, 2), (0, 2, 3)])
    centimetres = lambda text: text.replace(b'name="meter" meter="1"', b'name="centimeter" meter="0.01"')
    return {
        "stl": ("cube.stl", robots.binary_stl(*box(BOX))), "obj": ("cube.obj", robots.obj(*box(BOX))),
        "ascii-stl": ("cube.stl", robots.ascii_stl(*box(BOX))),
        "dae": ("cube.dae", dae(BOX)), "dae-centimetres": ("cube.dae", dae([100 * x for x in BOX], centimetres)),
        "dae-inches": ("cube.dae", dae([x / .0254 for x in BOX],
                                       lambda text: text.replace(b'name="meter" meter="1"', b'name="inch" meter="0.0254"'))),
        "dae-y-up": ("cube.dae", dae(BOX, lambda text: text.replace(b"Z_UP", b"Y_UP"))),
        "dae-zero-behind": ("cube.dae", dae(BOX) + b"\0"),
        "dae-zero-inside": ("cube.dae", dae(BOX, lambda text: text.replace(b"</library_visual_scenes>",
                                                                           b"</library_visual_scenes>\0" + b" " * 5000))),
        "glb": ("cube.glb", glb(*box(BOX))), "glb-cut": ("cube.glb", glb(*box(BOX))[:200]),
        "flat": ("cube.stl", robots.binary_stl(*flat)), "flat-tilted": ("cube.stl", robots.binary_stl(*tilted)),
        "flat-obj": ("cube.obj", robots.obj(*flat)),
        "one-triangle": ("cube.stl", robots.binary_stl(flat[0], flat[1][:1])),
        "one-triangle-obj": ("cube.obj", robots.obj(flat[0], flat[1][:1])),
        "no-triangle": ("cube.stl", robots.binary_stl([], [])),
        "doubled": ("cube.stl", robots.binary_stl(box(BOX)[0], box(BOX)[1] * 2)),
        "200000-faces": ("cube.stl", robots.binary_stl(*many(200_100))),
        "cut": ("cube.stl", robots.binary_stl(*box(BOX))[:300]),
    }


KEEPS = '<mujoco><compiler discardvisual="false"/></mujoco>'
COMPILERS = {"discardvisual": 'discardvisual="false"', "meshdir": 'meshdir="../meshes"', "meshdir-wrong": 'meshdir="gone"',
             "strippath": 'strippath="false"', "strippath-meshdir": 'strippath="false" meshdir="../meshes"'}


def package_xml(name):
    return (f'<?xml version="1.0"?>\n<package format="3"><name>{name}</name><version>1.0.0</version><description>d</description>'
            '<maintainer email="a@b.c">a</maintainer><license>BSD</license></package>\n').encode()


def all_cases():
    """{name: Case}; files are named from the folder of the package."""
    cases = {}
    cube = robots.binary_stl(*box(BOX))
    package = {"package.xml": package_xml(PACKAGE)}

    def add(name, place, path, files, folder=PACKAGE, after="", urdf="urdf/robot.urdf"):
        cases[name] = Case(document(shapes_of(place, path), after), {**package, **files}, folder, place, urdf=urdf)

    for place in PLACES:
        ending = "png" if place == "texture" else "stl"
        files = {f"meshes/cube.{ending}": robots.meshes()["cube.png"] if place == "texture" else cube}
        if place != "texture":
            files["meshes/cube.obj"] = robots.obj(*box(BOX))  # for Drake
        beside = {name.replace("meshes/", "urdf/"): content for name, content in files.items()}
        for kind, path in PATHS.items():
            add(f"{place}~{kind}", place, path.replace("stl", ending), files)
        for kind, path in BESIDE.items():
            add(f"{place}~{kind}", place, path.replace("stl", ending), beside)
        for kind in ("package", "package-three-slashes"):
            add(f"{place}~{kind}-other-folder", place, PATHS[kind].replace("stl", ending), files, "robot-hand")
        for kind in DEEP:
            add(f"{place}~{kind}-deep", place, PATHS[kind].replace("stl", ending), files, urdf="arms/hand/left/2024/urdf/v2/robot.urdf")
    for kind, (name, content) in contents().items():
        for place in ("visual", "collision"):
            add(f"{place}:{kind}", place, f"../meshes/{name}", {f"meshes/{name}": content})
        add(f"kept-visual:{kind}", "visual", f"../meshes/{name}", {f"meshes/{name}": content}, after=KEEPS)
    for kind, attributes in COMPILERS.items():
        for path in ("../meshes/cube.stl", "cube.stl", "meshes/cube.stl"):
            add(f"compiler:{kind}:{path}", "collision", path, {"meshes/cube.stl": cube},
                after=f"<mujoco><compiler {attributes}/></mujoco>")
    mirrored = shapes_of("collision", "../meshes/cube.stl").replace("/></geometry>", ' scale="1 -1 1"/></geometry>')
    cases["collision:mirrored"] = Case(document(mirrored), {**package, "meshes/cube.stl": cube, "meshes/cube.obj": robots.obj(*box(BOX))})
    add_robots(cases)
    return cases


def add_robots(cases):
    """Without meshes: only whether the robot loads is recorded."""
    shape = '<collision><geometry><box size="0.1 0.1 0.1"/></geometry></collision>'
    plain = document(shape)

    def add(name, old, new):
        assert old in plain, name
        cases[f"robot:{name}"] = Case(plain.replace(old, new), {"package.xml": package_xml(PACKAGE)})

    hand = f'<link name="hand">{BODY}'

    def tensor(moments, products=(0, 0, 0)):
        names = dict(zip(("ixx", "iyy", "izz", "ixy", "ixz", "iyz"), (*moments, *products)))
        values = " ".join(f'{name}="{value!r}"' for name, value in names.items())
        return f'<link name="hand"><inertial><mass value="1"/><inertia {values}/></inertial>'

    add("plain", hand, hand)
    add("plate", hand, tensor((0.01, 0.02, 0.03)))
    add("plate-rounded", hand, tensor((0.1, 0.2, 0.30000000000000004)))
    add("plate-rounded-down", hand, tensor((0.1, 0.7, 0.7999999999999999)))
    # moments 0.01, 0.02, 0.03, turned by 0.3 about x and 0.5 about z
    turned = turned_tensor((0.01, 0.02, 0.03), 0.3, 0.5)
    add("plate-turned", hand, tensor(turned[:3], turned[3:]))
    add("plate-turned-rounded", hand, tensor([round(x, 9) for x in turned[:3]], [round(x, 9) for x in turned[3:]]))
    add("triangle", hand, tensor((0.01, 0.01, 0.05)))
    add("triangle-balanced", "</robot>", "</robot>")
    cases["robot:triangle-balanced"].text = cases["robot:triangle"].text.replace(
        "</robot>", '<mujoco><compiler balanceinertia="true"/></mujoco></robot>')
    add("parent-text", '<parent link="base"/>', "<parent>base</parent>")
    add("child-text", '<child link="hand"/>', "<child>hand</child>")
    add("both-text", '<parent link="base"/><child link="hand"/>', "<parent>base</parent><child>hand</child>")
    add("mass-text", '<mass value="1"/>', "<mass>1</mass>")
    foot = (f'<link name="foot">{BODY}</link><joint name="f" type="fixed"><parent link="hand"/><child link="foot"/>'
            '<mimic joint="j"/></joint></robot>')
    add("mimic-fixed", "</robot>", foot)
    add("mimic-both-fixed", "</robot>", foot.replace('<mimic joint="j"/>', "").replace(
        "</robot>", f'<link name="toe">{BODY}</link><joint name="t" type="fixed"><parent link="foot"/><child link="toe"/>'
        '<mimic joint="f"/></joint></robot>'))
    add("follows-fixed", "</robot>", foot.replace('<mimic joint="j"/>', "").replace(
        "</robot>", f'<link name="toe">{BODY}</link><joint name="t" type="revolute"><parent link="foot"/><child link="toe"/>'
        '<axis xyz="1 0 0"/><limit lower="-1" upper="1" effort="1" velocity="1"/><mimic joint="f"/></joint></robot>'))
    for kind in ("fixed", "revolute", "floating", "continuous"):
        limit = '<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/>' if kind in ("revolute", "continuous") else ""
        add(f"world-{kind}", "</robot>", f'<link name="world"/><joint name="w" type="{kind}"><parent link="world"/>'
            f'<child link="base"/>{limit}</joint></robot>')
    add("digit-name", 'name="hand"', 'name="1_hand"')
    cases["robot:digit-name"].text = cases["robot:digit-name"].text.replace('<child link="hand"/>', '<child link="1_hand"/>')


def turned_tensor(moments, about_x, about_z):
    cx, sx, cz, sz = math.cos(about_x), math.sin(about_x), math.cos(about_z), math.sin(about_z)
    rotation = ((cz, -sz * cx, sz * sx), (sz, cz * cx, -cz * sx), (0, sx, cx))
    full = [[sum(rotation[i][k] * moments[k] * rotation[j][k] for k in range(3)) for j in range(3)] for i in range(3)]
    return [full[0][0], full[1][1], full[2][2], full[0][1], full[0][2], full[1][2]]


def write(cases, folder, text_of=lambda text: text):
    """{name: path of the URDF}"""
    paths = {}
    for number, (name, case) in enumerate(cases.items()):
        package = folder / f"{number:03}" / case.folder
        for file, content in case.files.items():
            (package / file).parent.mkdir(parents=True, exist_ok=True)
            (package / file).write_bytes(content)
        paths[name] = package / case.urdf
        paths[name].parent.mkdir(parents=True, exist_ok=True)
        paths[name].write_bytes(text_of(case.text.replace(HERE, str(package)).encode("utf-8", "surrogateescape")))
    return paths


def numbers_in(value):
    return [one for one in value if isinstance(one, (int, float)) and not isinstance(one, bool)] if isinstance(value, list) else []


def floats_in(value):
    return [float(one) for one in re.findall(r"-?[\d.]+(?:e-?\d+)?", str(value))]


def extent_in(robot, place):
    """Of the USD that Isaac's converter writes: the extent of the points, times the scale of their prim."""
    path = next((key[:-len(":extent")] for key in robot if key.startswith(f"{place}s:") and key.endswith(":extent")), None)
    if path is None:
        return []
    scale = floats_in(robot.get(f"{path}:xformOp:scale", "1 1 1"))
    return [value * scale[i % 3] for i, value in enumerate(floats_in(robot[f"{path}:extent"]))]


def size_of(reader, robot, place):
    """The box of the shape, in mm; none if the reader does not say."""
    if reader in ("Pinocchio", "Bullet"):
        corners = next((numbers_in(value) for key, value in robot.items() if key.startswith(f"sizes:{place}s")), [])
    elif reader == "Newton":
        corners = next((numbers_in(value)[-6:] for key, value in robot.items()
                        if key.startswith(f"{place}s:") and len(numbers_in(value)) > 12), [])
    elif reader == "Isaac":
        corners = extent_in(robot, place)
    else:
        return ""
    if len(corners) != 6:
        return ""
    return "x".join(f"{1000 * (high - low):.4g}" for low, high in zip(corners[:3], corners[3:]))


def cell_of(reader, case, reading):
    if reading["verdict"] in ("refuses", "crashes"):
        return reading["verdict"]
    if "<mesh " not in case.text:  # a texture, or no file at all
        return "loads"
    robot = reading["robot"]
    wanted = ("visual", "collision") if case.place == "both" else (case.place,)
    cells = []
    for place in wanted:
        is_there = any(key.startswith((f"{place}s:", f"{place}:")) for key in robot)
        cells.append((size_of(reader, robot, place) or "kept") if is_there else "lost")
    return cells[0] if len(set(cells)) == 1 else "+".join(cells)
