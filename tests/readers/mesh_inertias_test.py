# SPDX-License-Identifier: BSD-3-Clause
"""Are the volumes and inertias of closed meshes those that MuJoCo computes with `inertia="exact"`?

Usage: mesh_inertias_test.py SMURF-LINT SMURFS-FLATTEN

300 convex meshes, and 200 with lumps and holes, as binary STL and OBJ, some scaled. A link has a mass and no inertia, so
that smurfs-flatten writes the one of its mesh into the MJCF.
"""
import csv
import io
import math
import pathlib
import random
import struct
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SKIPPED = 77
MOST = 1e-9  # relative to the volume, or to the largest moment
CONVEX, ANY = 300, 200


def surface(rows, columns, is_ring, place):
    """Points and triangles of a ball of rings with two poles, or of a torus."""
    points = [place(r, c) for r in range(rows) for c in range(columns)]

    def at(r, c):
        return r % rows * columns + c % columns
    triangles = []
    for r in range(rows if is_ring else rows - 1):
        for c in range(columns):
            a, b, d, e = at(r, c), at(r, c + 1), at(r + 1, c), at(r + 1, c + 1)
            triangles += [(a, d, b), (b, d, e)]
    if not is_ring:
        for row, turn in ((0, 1), (rows - 1, -1)):
            for c in range(1, columns - 1):
                triangles.append((at(row, 0), at(row, c), at(row, c + 1))[::turn])
    return points, triangles


def single(value):
    return struct.unpack("<f", struct.pack("<f", value))[0]


def random_mesh(dice, is_convex):
    rows, columns = dice.randint(3, 14), dice.randint(3, 14)
    is_ring = not is_convex and dice.random() < 0.4
    size = 10 ** dice.uniform(-2, 1)
    stretch = [size * dice.uniform(0.2, 1) for _ in range(3)]
    shift = [size * dice.uniform(-2, 2) for _ in range(3)]
    shear = dice.uniform(-0.5, 0.5)

    def place(r, c):
        v = 2 * math.pi * r / rows if is_ring else math.pi * (r + 1) / (rows + 1)
        u = 2 * math.pi * c / columns
        radius = 1 + 0.4 * math.cos(v) if is_ring else math.sin(v)
        height = -0.4 * math.sin(v) if is_ring else math.cos(v)
        lump = 1 if is_convex else dice.uniform(0.7, 1)
        x, y, z = (lump * each for each in (radius * math.cos(u), radius * math.sin(u), height))
        return tuple(single(s * k + t) for s, k, t in zip((x + shear * z, y, z), stretch, shift))

    return surface(rows, columns, is_ring, place)


def stl(points, triangles):
    text = b"\0" * 80 + struct.pack("<I", len(triangles))
    for corners in triangles:
        text += struct.pack("<3f", 0, 0, 0) + b"".join(struct.pack("<3f", *points[i]) for i in corners) + b"\0\0"
    return text


def obj(points, triangles):
    lines = [f"v {x:.9g} {y:.9g} {z:.9g}" for x, y, z in points]
    return "\n".join(lines + ["f {} {} {}".format(*(i + 1 for i in corners)) for corners in triangles] + [""]).encode()


def write_robot(folder, dice):
    """robot.urdf, with a link for each mesh; returns (file, scale) of each."""
    meshes, text = [], '<robot name="parts"><link name="base"/>'
    for number in range(CONVEX + ANY):
        points, triangles = random_mesh(dice, number < CONVEX)
        file = f"m{number}.{dice.choice(('stl', 'obj'))}"
        (folder / file).write_bytes((stl if file.endswith("stl") else obj)(points, triangles))
        scale = dice.choice(("1 1 1", "0.5 0.5 0.5", "0.25 2 0.125"))
        meshes.append((file, scale))
        text += f"""<link name="l{number}"><inertial><mass value="1.5"/></inertial>
<collision><geometry><mesh filename="{file}" scale="{scale}"/></geometry></collision></link>
<joint name="j{number}" type="continuous"><parent link="base"/><child link="l{number}"/><axis xyz="0 0 1"/></joint>
"""
    (folder / "robot.urdf").write_text(text + "</robot>")
    return meshes


def moments_of(inertial):
    """The principal moments, ascending."""
    if "fullinertia" not in inertial.attrib:
        return sorted(float(each) for each in inertial.get("diaginertia").split())
    xx, yy, zz, xy, xz, yz = (float(each) for each in inertial.get("fullinertia").split())
    import numpy
    return list(numpy.linalg.eigvalsh([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]))


def of_mujoco(mujoco, folder, meshes):
    """Volume, and principal moments per kg, ascending, of each mesh. Its axes are not compared: they differ by 1e-8 from
    those of an exact computation, because small products count as 0."""
    assets = "".join(f'<mesh name="m{i}" file="{file}" scale="{scale}" inertia="exact"/>'
                     for i, (file, scale) in enumerate(meshes))
    bodies = "".join(f'<body name="b{i}"><freejoint/><geom type="mesh" mesh="m{i}" density="1"/></body>'
                     for i in range(len(meshes)))
    (folder / "exact.xml").write_text(f'<mujoco><compiler meshdir="{folder}"/><asset>{assets}</asset>'
                                      f"<worldbody>{bodies}</worldbody></mujoco>")
    model = mujoco.MjModel.from_xml_path(str(folder / "exact.xml"))
    for i in range(len(meshes)):
        body = model.body(f"b{i}")
        volume = float(body.mass[0])
        yield volume, sorted(float(moment) / volume for moment in body.inertia)


def run(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    if done.returncode > 1:
        sys.exit(f"{command[0]}: {done.stderr}")
    return done.stdout


def main(lint, flatten):
    try:
        import mujoco
    except ImportError:
        python = ROOT / "build/readers/python/bin/python"
        if "--again" in sys.argv or not python.exists():
            return SKIPPED
        return subprocess.run([python, __file__, lint, flatten, "--again"], check=False).returncode
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        meshes = write_robot(folder, random.Random(42))
        rows = csv.DictReader(io.StringIO(run(lint, "--isolated", "--masses", folder / "robot.urdf", "--csv")))
        volumes = {row["link"]: row for row in rows}
        run(flatten, folder / "robot.urdf", "--format", "mjcf", "-o", folder / "out.xml")
        bodies = {body.get("name").split("/")[-1]: body for body in ET.parse(folder / "out.xml").iter("body")}
        worst = [0, 0]
        failures = []
        for i, (volume, exact) in enumerate(of_mujoco(mujoco, folder, meshes)):
            row = volumes[f"l{i}"]
            if row["volume_of"] != "shapes":
                failures.append(f"{meshes[i]}: not closed")
                continue
            own = [each / 1.5 for each in moments_of(bodies[f"l{i}"].find("inertial"))]
            errors = [abs(float(row["volume_m3"]) - volume) / volume,
                      max(abs(a - b) for a, b in zip(own, exact)) / max(exact)]
            worst = [max(pair) for pair in zip(worst, errors)]
            if max(errors) > MOST:
                failures.append(f"{meshes[i]}: {errors}, {own}, {exact}")
    print(f"{len(meshes)} meshes, {len(failures)} differ; the largest differences are {worst[0]:.2g} of the volume "
          f"and {worst[1]:.2g} of the inertia")
    for failure in failures[:20]:
        print(failure)
    return 1 if failures else 0


sys.exit(main(*sys.argv[1:3]))
