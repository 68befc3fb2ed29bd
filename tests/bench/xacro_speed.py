#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Processor time of expanding xacro files: xacro_speed.py BIN SHARED [XACRO]

User and system time of whole processes with their start, ms, the best of several runs; smurf2urdf expands robots of SHARED/xacro/corpus in copies of their
repositories, and smurf-lint checks the results there, with their meshes, without files of ROS that belong to robots. XACRO is the program
`xacro` of the Python package, which gets a stand-in for ament_index_python; the ratio is that of the same run.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROUNDS = 15
ROBOTS = [
    ("Universal Robots", "UniversalRobots+Universal_Robots_ROS2_Description", "urdf/ur.urdf.xacro", ["name:=ur", "ur_type:=ur5e"]),
    ("PR2", "PR2+pr2_common", "pr2_description/robots/pr2.urdf.xacro", []),
    ("two Frankas", "frankaemika+franka_description", "robots/multi_arm/multi_arm.urdf.xacro", []),
    ("Atlas", "openhumanoids+oh-distro", "software/models/atlas_v5/xacro/atlas_v5_convex_hull_fingers.xacro", []),
    ("RexROV", "uuvsimulator+uuv_simulator", "uuv_descriptions/robots/rexrov_sonar.xacro", []),
    ("1,201 links", "ros-simulation+gazebo_ros_pkgs", "gazebo_plugins/test2/large_models/large_model.urdf.xacro", []),
]
STAND_IN = """
P = %r
class PackageNotFoundError(KeyError): pass
def get_package_share_directory(name, print_warning=True):
    if name not in P: raise PackageNotFoundError(name)
    return P[name]
"""


def cost(command, folder, rounds=ROUNDS, **more):
    """Processor time in ms, and what was printed."""
    best = None
    for _ in range(rounds):
        process = subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, **more)
        printed = process.stdout.read()
        _, _, usage = os.wait4(process.pid, 0)
        process.returncode = 0
        time = 1e3 * (usage.ru_utime + usage.ru_stime)
        best = time if best is None else min(best, time)
    return best, printed


def stand_in(repository, folder):
    """A module that knows the packages of a repository."""
    packages = {}
    for manifest in repository.rglob("package.xml"):
        name = re.search(r"<name>\s*([^<\s]+)", manifest.read_text("utf8", "replace"))
        if name:
            packages[name[1]] = str(manifest.parent)
    (folder / "ament_index_python").mkdir()
    (folder / "ament_index_python/__init__.py").write_text("")
    (folder / "ament_index_python/packages.py").write_text(STAND_IN % packages)


def measure(binaries, shared, xacro, row, work):
    name, repository, entry, words = row
    folder = work / repository
    shutil.copytree(shared / "xacro/corpus" / repository, folder, symlinks=True)
    start, _ = cost([binaries / "smurf2urdf", "--version"], folder)
    ours, urdf = cost([binaries / "smurf2urdf", entry, *words], folder)
    place = (folder / entry).with_name("expanded-here.urdf")
    place.parent.chmod(0o755)
    place.write_bytes(urdf)
    lint, _ = cost([binaries / "smurf-lint", place], folder)
    lint_start, _ = cost([binaries / "smurf-lint", "--version"], folder)
    columns = [f"{ours:.1f}", f"{ours - start:.1f}", f"{lint - lint_start:.1f}"]
    if xacro:
        packages = work / ("for " + repository)
        packages.mkdir()
        stand_in(folder, packages)
        theirs, _ = cost([xacro, entry, *words], folder, 3, env={**os.environ, "PYTHONPATH": str(packages)})
        columns += [f"{theirs:.0f}", f"{theirs / ours:.0f}"]
    print(f"{name:18}" + "".join(f"{one:>18}" for one in columns), flush=True)
    return ours, theirs if xacro else 0.0


def main():
    binaries, shared = (pathlib.Path(one).resolve() for one in sys.argv[1:3])
    xacro = sys.argv[3] if len(sys.argv) > 3 else None
    print(f"{'':18}" + "".join(f"{one:>18}" for one in ("smurf2urdf", "without start", "lint of result", "xacro", "times less")))
    with tempfile.TemporaryDirectory() as work:
        times = [measure(binaries, shared, xacro, row, pathlib.Path(work).resolve()) for row in ROBOTS]
    if xacro:
        ours, theirs = (sum(column) for column in zip(*times))
        print(f"all together: {theirs / ours:.0f} times less processor time than xacro")


if __name__ == "__main__":
    main()
