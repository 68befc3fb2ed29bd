# SPDX-License-Identifier: BSD-3-Clause
"""The results of export_pass.py, for the tests that judge them."""
import json
import os
import pathlib
import re
import sys

PREFIX = "i_"  # its bytes add up to a multiple of 8: joints move as without it (robot_poses.hpp)
OPTIONS = {
    "default": [],
    "canonical": ["--canonical"],
    "collapsed": ["--collapse-fixed"],
    "stripped": ["--vendor", "strip", "--comments", "strip"],
    "plain": ["--collapse-fixed", "--vendor", "strip", "--comments", "strip", "--canonical"],
    "prefixed": ["--prefix", PREFIX],
    "enriched": ["--apply", "all", "--sensors", "gazebo", "--actuation", "ros2_control"],
}
# A second export with these options changes nothing; the others add up.
STABLE = ("default", "canonical", "collapsed", "stripped", "plain")


def listed_urdf(path):
    """The URDF that a .smurf lists; a URDF itself; the path where there is none."""
    if path.suffix != ".smurf":
        return path
    paths = re.findall(r"[\w./-]+\.urdf", path.read_text(errors="replace"))
    return pathlib.Path(os.path.normpath(path.parent / paths[0])) if paths else path


def sources(folder):
    """Every .urdf, and every .smurf that lists one."""
    for path in sorted(folder.rglob("*")):
        if path.suffix.lower() == ".urdf" or (path.suffix == ".smurf" and listed_urdf(path).is_file() and listed_urdf(path) != path):
            yield path


class Robot:
    """A model, and what became of it."""

    def __init__(self, folder):
        self.folder = folder
        record = json.loads((folder / "runs.json").read_text())
        self.source, self.model = pathlib.Path(record["source"]), pathlib.Path(record["model"])
        self.is_urdf = "proved" in record["runs"]
        self.is_readable = record.get("is_readable", True)
        self.is_sound, self.runs, self.record = record["is_sound"], record["runs"], record

    def failure(self, run):
        """The messages of a run that failed, or None."""
        done = self.runs[run]
        return None if done["code"] == 0 else f"{self.source}: {run}: exit code {done['code']}: {done['messages'][-300:]}"

    def export(self, name):
        return self.folder / "out" / f"{name}.urdf"

    def again(self, name):
        return self.folder / "again" / f"{name}.urdf"


def end(failures):
    """Ends the test; shows some failures, because one cause may have hundreds."""
    print("\n".join(failures[:20]))
    sys.exit(f"{len(failures)} failures" if failures else 0)


def robots(folder):
    """Ends the test with 77, which CTest shows as skipped, where the pass was skipped."""
    if not pathlib.Path(folder).is_dir():
        print(f"skipped: there is no {folder}")
        sys.exit(77)
    count = int((pathlib.Path(folder) / "count").read_text())
    return [Robot(pathlib.Path(folder) / f"{number:04}") for number in range(count)]
