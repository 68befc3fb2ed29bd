# SPDX-License-Identifier: BSD-3-Clause
"""URDFs that smurf2urdf wrote, given to the programs they are meant for, against their sources.

A reader that loads the source must load every export of it, and have each link where it has it for
the source, at zero and at other joint positions, to 1e-9 m and rad. What a reader makes of a robot
is its own affair, so that each one is compared with itself. Prints a table; readers that are not
installed are named.

Usage: exports_test.py SMURF2URDF BUILD EXPORTS...    EXPORTS are written by export_pass.py
"""
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "support"))
import exported  # noqa: E402

NODE_MODULES = HERE.parent.parent / "build/readers/node_modules"
TOLERANCE = 1e-9  # m and rad
# libsdformat hands poses on as roll, pitch, yaw, which costs digits where the pitch is near 90
# degrees; collapsed joints have other angles than the two they are made of.
LOOSER = {("libsdformat", "collapsed"): 1e-7}
FILES_A_RUN = 50
EXPORTS = ("default", "canonical", "collapsed", "prefixed", "enriched")


def readers(build):
    """Command of each reader, None where it is not installed."""
    found = {name: [build / program] if (build / program).exists() else None
             for name, program in {"urdfdom": "urdfdom_poses", "libsdformat": "sdformat_urdf_poses",
                                   "DART": "dart_poses", "MuJoCo": "mujoco_urdf_poses"}.items()}
    has_node = shutil.which("node") and (NODE_MODULES / "urdf-loader").is_dir()
    found["urdf-loader"] = (["node", HERE / "urdf_poses.mjs", NODE_MODULES] if has_node else None)
    return found


def equals(files):
    """{file: the first one of the same text}; where meshes are named, the place counts as well."""
    first = {}
    texts = {file: pathlib.Path(file).read_bytes() for file in files}
    return {file: file if b"filename" in text else first.setdefault(text, file)
            for file, text in texts.items()}


def read_all(command, files):
    """{file: {(what, name): numbers}}; None for what is refused or crashes the reader."""
    twins = equals([str(file) for file in files])
    found, rest = {}, sorted(set(twins.values()))
    while rest:
        try:
            done = subprocess.run([*map(str, command), *rest[:FILES_A_RUN]], capture_output=True,
                                  timeout=600, check=False)
            output = done.stdout
        except subprocess.TimeoutExpired as late:
            output = late.stdout or b""
        found.update(parse(output.decode(errors="replace")))
        before = len(rest)
        rest = [file for file in rest if file not in found]
        if len(rest) == before:
            sys.exit(f"{command[0]} does not run")
    return {file: found[twin] for file, twin in twins.items()}


def parse(output):
    found, file = {}, None
    for line in output.split("\n"):
        words = line.split("\t")
        if words[0] == "file":
            file, poses = words[1], {}
            found[file] = None
        elif words[0] == "end" and file is not None:
            found[file] = poses
        elif words[0] in ("pose", "moved") and len(words) == 9 and words[-1]:
            poses[words[0], words[1]] = [float(number) for number in words[2:]]
    return found


def difference(one, other):
    """Metres or radians, the larger of the two; metres relative to distances above 1 m."""
    if not all(map(math.isfinite, one + other)):
        return 0 if str(one) == str(other) else math.inf
    size = max([1, *map(abs, one[:3])])
    same = sum(a * b for a, b in zip(one[3:], other[3:]))
    gap = math.dist(one[3:], [math.copysign(1, same) * part for part in other[3:]])
    return max(math.dist(one[:3], other[:3]) / size, 2 * gap)


def compare(export, source, name, tolerance):
    """The largest difference, or an error message."""
    if source is None:
        return 0
    if export is None:
        return "is refused"
    if name == "prefixed":
        bare = {(what, link.removeprefix(exported.PREFIX)): pose for (what, link), pose in export.items()}
        export = bare
    lost, new = set(source) - set(export), set(export) - set(source)
    if (lost and name != "collapsed") or not export:
        return f"has lost {sorted(lost)[:3]}"
    if name == "collapsed":  # libsdformat drops a link without mass; now it may have one
        export = {key: pose for key, pose in export.items() if key in source}
    elif new:
        return f"has the new {sorted(new)[:3]}"
    if not export:
        return 0
    worst = max(export, key=lambda key: difference(export[key], source[key]))
    largest = difference(export[worst], source[worst])
    if largest > tolerance:
        return f"has {worst} moved by {largest:.2g}: {export[worst]} was {source[worst]}"
    return largest


def check(reader, command, robots, failures):
    """A row of the table."""
    exports = {robot: {name: robot.export(name) for name in EXPORTS if not robot.failure(name)} for robot in robots}
    files = [file for robot in robots for file in [robot.source, *exports[robot].values()]]
    poses = read_all(command, files)
    loaded = [robot for robot in robots if poses[str(robot.source)]]
    cells = []
    for name in EXPORTS:
        good, largest = 0, 0.0
        for robot in loaded:
            if name not in exports[robot]:
                continue
            result = compare(poses[str(exports[robot][name])], poses[str(robot.source)], name,
                             LOOSER.get((reader, name), TOLERANCE))
            if isinstance(result, str):
                failures.append(f"{reader}: {name} export of {robot.model} "
                                f"({robot.source}) {result}")
            else:
                good, largest = good + 1, max(largest, result)
        cells.append(f"{good:4d} {largest:7.1e}")
    if not loaded:
        failures.append(f"{reader} loads no source at all")
    return f"{reader:12s} {len(loaded):7d} " + " ".join(f"{cell:>13s}" for cell in cells)


def check_mujoco_with_meshes(smurf2urdf, build, failures):
    """--preset mujoco: the meshes are found in their folder, where MuJoCo does not look by default."""
    if not (build / "mujoco_poses").exists():
        return
    model = HERE.parent.parent / "fixtures/models/arm/smurf/arm.smurf"
    with tempfile.TemporaryDirectory() as scratch:
        output = pathlib.Path(scratch).resolve() / "mujoco.urdf"
        subprocess.run([smurf2urdf, model, "-o", output, "--preset", "mujoco", "--quiet"], check=True, timeout=120)
        done = subprocess.run([build / "mujoco_poses", output], capture_output=True, text=True, timeout=120, check=False)
    if "pose\tforearm\t" not in done.stdout:
        failures.append(f"MuJoCo does not load the export of its preset: {done.stderr[-300:]}")


def main():
    smurf2urdf, build = [pathlib.Path(word).absolute() for word in sys.argv[1:3]]
    found = [robot for folder in sys.argv[3:] for robot in exported.robots(folder)]
    robots = [robot for robot in found if robot.is_readable]
    failures = [robot.failure(name) for robot in robots for name in EXPORTS if robot.failure(name)]
    print(f"{len(robots)} robots, {len(found) - len(robots)} that are not read; a cell: exports with all "
          "links where the reader has them in the source, largest difference")
    print(f"{'reader':12s} {'sources':>7s} " + " ".join(f"{name:>13s}" for name in EXPORTS))
    commands = readers(build)
    for reader, command in commands.items():
        if command is None:
            print(f"{reader:12s} skipped: it is not installed; see scripts/setup --readers")
        elif robots:
            print(check(reader, command, robots, failures), flush=True)
    check_mujoco_with_meshes(smurf2urdf, build, failures)
    if failures:
        sys.exit("\n".join(failures))
    sys.exit(77 if None in commands.values() or not robots else 0)


if __name__ == "__main__":
    main()
