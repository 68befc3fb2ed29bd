# SPDX-License-Identifier: BSD-3-Clause
"""Do meshes weigh what trimesh says, volume, centre and inertia, and does it read exported glTF?

Usage: mesh_referee_test.py SMURF-LINT SMURFS-FLATTEN [CORPUS]

Closed shapes that trimesh writes in each of its formats, and the closed meshes of fixtures and CORPUS. A link has a mass and
no inertia, so that smurfs-flatten writes the one of its mesh into the MJCF. COLLADA and glTF may have other axes than URDF:
of them, what does not depend on axes is compared.
"""
import csv
import io
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PYTHON = ROOT / "build/readers/python/bin/python"
SKIPPED = 77
MOST = 1e-6  # relative; trimesh computes with what it has merged, in the single precision of the files
ROUNDED = 5e-3  # of the size of the mesh: smurf-lint prints the centre of shapes rounded, and where it is far away
MASS = 1.5  # kg
ENDINGS = (".stl", ".obj", ".dae", ".glb", ".gltf")
LARGEST = 2_000_000  # bytes
MOST_FILES = 400


def shapes():
    """{name: mesh}, closed and without symmetry about the origin."""
    import numpy
    import trimesh
    dice = numpy.random.default_rng(7)
    found = {"box": trimesh.creation.box((0.2, 0.3, 0.6)), "ring": trimesh.creation.torus(0.3, 0.1),
             "capsule": trimesh.creation.capsule(0.4, 0.1), "pipe": trimesh.creation.annulus(0.1, 0.2, 0.5)}
    for i in range(6):
        found[f"hull{i}"] = trimesh.convex.convex_hull(dice.normal(size=(30, 3)) * dice.uniform(0.05, 2))
    for mesh in found.values():
        mesh.apply_transform(trimesh.transformations.random_rotation_matrix(dice.uniform(size=3)))
        mesh.apply_translation(dice.normal(size=3))
    return found


def write_shapes(folder):
    for name, mesh in shapes().items():
        for form, ending in (("stl", "stl"), ("stl_ascii", "ascii.stl"), ("obj", "obj"), ("dae", "dae"), ("glb", "glb")):
            data = mesh.export(file_type=form)
            path = folder / f"{name}.{ending}"
            path.write_bytes(data if isinstance(data, bytes) else data.encode())
            yield path


def stored(folders):
    files = [path for folder in folders for path in sorted(folder.rglob("*"))
             if path.suffix.lower() in ENDINGS and path.is_file() and path.stat().st_size <= LARGEST]
    return files[::max(1, len(files) // MOST_FILES)]


def of_trimesh(path):
    """Volume, centre, and inertia about it per kg; None for what is not closed or not read."""
    import trimesh
    try:
        mesh = trimesh.load(path, force="mesh")
        if not mesh.is_volume or mesh.volume <= 0:
            return None
        mesh.density = 1 / mesh.volume
        return mesh.volume, mesh.center_mass, mesh.moment_inertia
    except Exception:  # pylint: disable=broad-except  # any exception of its many readers
        return None


def run(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    return done.stdout


def of_smurf(lint, flatten, path, folder):
    """As of_trimesh."""
    import numpy
    robot, out = folder / "robot.urdf", folder / "out.xml"
    robot.write_text(f"""<robot name="r"><link name="base"/><link name="l"><inertial><mass value="{MASS}"/></inertial>
<collision><geometry><mesh filename="{path}"/></geometry></collision></link>
<joint name="j" type="continuous"><parent link="base"/><child link="l"/><axis xyz="0 0 1"/></joint></robot>""")
    rows = csv.DictReader(io.StringIO(run(lint, "--isolated", "--allow-outside", "--masses", robot, "--csv")))
    row = next(row for row in rows if row["link"] == "l")
    if row["volume_of"] != "shapes":
        return None
    out.unlink(missing_ok=True)
    run(flatten, robot, "--allow-outside", "--format", "mjcf", "-o", out)
    if not out.exists():
        return None
    inertial = next(body for body in ET.parse(out).iter("body") if body.get("name").endswith("/l")).find("inertial")
    if "fullinertia" in inertial.attrib:
        xx, yy, zz, xy, xz, yz = map(float, inertial.get("fullinertia").split())
        tensor = numpy.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    else:
        tensor = numpy.diag(list(map(float, inertial.get("diaginertia").split())))
    centre = re.search(r"or that of the shapes, `([^`]*)`", run(lint, "--isolated", "--allow-outside", robot))
    return float(row["volume_m3"]), centre and numpy.array(list(map(float, centre[1].split()))), tensor / MASS


def difference(own, theirs, is_turned):
    """The largest relative one of volume and inertia; infinite if the centres are apart."""
    import numpy
    if own[1] is not None:
        size = numpy.sqrt(numpy.trace(theirs[2])) + numpy.linalg.norm(theirs[1])
        lengths = [numpy.linalg.norm(each[1]) for each in (own, theirs)]
        apart = abs(lengths[0] - lengths[1]) if is_turned else numpy.abs(own[1] - theirs[1]).max()
        if apart > ROUNDED * size:
            return float("inf")
    own, theirs = ((each[0], numpy.linalg.eigvalsh(each[2]) if is_turned else each[2]) for each in (own, theirs))
    return max(abs(own[0] - theirs[0]) / theirs[0], numpy.abs(own[1] - theirs[1]).max() / numpy.abs(theirs[1]).max())


def compare_meshes(lint, flatten, folder, folders):
    failures, worst, counts, centres = [], 0, {}, 0
    for path in [*write_shapes(folder), *stored(folders)]:
        theirs = of_trimesh(path)
        own = of_smurf(lint, flatten, path, folder)
        ending = path.suffix.lower()
        if own is None or theirs is None:
            if path.parent == folder:
                failures.append(f"{path.name}: closed, but not for {'smurf-lint' if own is None else 'trimesh'}")
            continue
        counts[ending] = counts.get(ending, 0) + 1
        centres += own[1] is not None
        error = difference(own, theirs, ending in (".dae", ".glb", ".gltf"))
        worst = max(worst, error)
        if error > MOST:
            failures.append(f"{path}: differs by {error:.2g}")
    print(f"{counts} closed meshes, {centres} centres; the largest difference is {worst:.2g}")
    return failures


def compare_gltf(flatten, folder):
    """The poses of links in glTF, whose y points upwards, as trimesh reads them, against the flat JSON."""
    import numpy
    import trimesh
    upright = numpy.array([[1, 0, 0, 0], [0, 0, 1, 0], [0, -1, 0, 0], [0, 0, 0, 1]])
    failures, count = [], 0
    for scene in sorted(ROOT.glob("fixtures/scenes/*/*.smurfs")) + sorted(ROOT.glob("fixtures/models/*/smurf/*.smurf")):
        out = folder / f"{scene.stem}.gltf"
        run(flatten, scene, "--format", "gltf", "-o", out)
        flat = json.loads(run(flatten, scene, "--links"))
        graph = trimesh.load(out, force="scene").graph
        above = graph.transforms.parents

        def ancestors(node):
            while node in above:
                node = above[node]
                yield node
        for instance in flat["instances"]:
            for link, pose in instance.get("links", {}).items():
                # trimesh numbers nodes of the same name.
                nodes = [node for node in graph.nodes if re.fullmatch(re.escape(link) + r"(_\d+)?", node)
                         and any(re.fullmatch(re.escape(instance["path"]) + r"(_\d+)?", one) for one in ancestors(node))]
                places = [(numpy.linalg.inv(upright) @ graph.get(node)[0])[:3, 3] for node in nodes]
                count += 1
                if not any(numpy.abs(place - pose["position"]).max() < MOST for place in places):
                    failures.append(f"{scene.name}: {instance['name']}/{link} is at {places}, not {pose['position']}")
    print(f"{count} links in glTF")
    return failures if count else [*failures, "no link was found in glTF"]


def main(lint, flatten, corpus="/nowhere"):
    try:
        import trimesh  # noqa: F401  # pylint: disable=unused-import
    except ImportError:
        if "--again" in sys.argv or not PYTHON.exists():
            print("skipped: trimesh of scripts/setup --python-readers is not installed")
            return SKIPPED
        return subprocess.run([PYTHON, __file__, lint, flatten, corpus, "--again"], check=False).returncode
    folders = [ROOT / "build/fixtures", *(path for path in [pathlib.Path(corpus)] if path.is_dir())]
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary).resolve()
        failures = compare_meshes(lint, flatten, folder, folders) + compare_gltf(flatten, folder)
    print("\n".join(failures[:20]))
    return 1 if failures else 0


sys.exit(main(*[word for word in sys.argv[1:4] if word != "--again"]))
