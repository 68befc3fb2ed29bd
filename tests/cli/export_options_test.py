# SPDX-License-Identifier: BSD-3-Clause
"""The options of smurf2urdf on every model of an export pass.

smurf2urdf proves each result: link poses, total mass, centre of mass and inertia, and limits. So
what is left to check is that it finds nothing to refuse, and that a second time changes nothing.
Prints the largest differences that --prove found, and for --collapse-fixed what this test computes
on its own.

Usage: export_options_test.py EXPORTS    EXPORTS is written by export_pass.py
"""
import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree

import mass_properties

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import exported  # noqa: E402

TOLERANCE = 1e-12  # relative, or m and rad


class Largest:
    """The largest difference by what was compared."""

    def __init__(self):
        self.figures, self.robots = {}, 0

    def note(self, what, figure):
        self.figures[what] = max(self.figures.get(what, 0), figure)

    def note_proof(self, text):
        for what, figure in re.findall(r"^  ([a-z ]+?) {2,}([-+.e0-9]+)", text, re.MULTILINE):
            self.note(what, float(figure))

    def note_masses(self, source, collapsed):
        """Only for files that Python's strict reader accepts and that contain plain numbers."""
        try:
            before, after = mass_properties.total(source), mass_properties.total(collapsed)
        except (ElementTree.ParseError, ValueError, AttributeError, RecursionError, KeyError):
            return
        self.note("masses, computed here", mass_properties.difference(before, after))
        self.robots += 1


def judge(robot, largest):
    """The failures of a model."""
    failures = []
    for name in exported.OPTIONS:
        for run in (name, f"{name} again") if name in exported.STABLE else (name,):
            failure = robot.failure(run) if run in robot.runs else f"{robot.source}: {run}: was not tried"
            if failure:
                failures.append(failure)
                break
            largest.note_proof(robot.runs[run]["messages"])
        else:
            if name in exported.STABLE and robot.export(name).read_bytes() != robot.again(name).read_bytes():
                failures.append(f"{robot.source} {exported.OPTIONS[name]}: a second time changes the result")
    if robot.export("collapsed").is_file():
        largest.note_masses(robot.source, robot.export("collapsed"))
    return failures


def main():
    robots = [robot for robot in exported.robots(sys.argv[1]) if robot.is_readable]
    largest = Largest()
    failures = [failure for robot in robots for failure in judge(robot, largest)]
    print(f"{len(robots)} models, {len(exported.OPTIONS)} exports of each; largest differences:")
    print(f"  masses of {largest.robots} robots were computed here as well")
    for what, figure in largest.figures.items():
        print(f"  {what:28s}{figure:.2g}")
        # The tool compares places far from the origin relative to their distance.
        if figure > TOLERANCE and "distance" not in what:
            failures.append(f"{what}: {figure} is more than {TOLERANCE}")
    if not largest.robots:
        failures.append("no mass was computed")
    exported.end(failures)


if __name__ == "__main__":
    main()
