# SPDX-License-Identifier: BSD-3-Clause
"""The options of smurf2urdf on every URDF of a folder.

smurf2urdf proves each result: link poses, total mass, centre of mass and inertia, and limits. So
what is left to check is that it finds nothing to refuse, and that a second time changes nothing.
Prints the largest differences that --prove found, and for --collapse-fixed what this test computes
on its own.

Usage: export_options_test.py SMURF2URDF FOLDER
"""
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

import mass_properties

OPTIONS = [
    ["--collapse-fixed"],
    ["--canonical"],
    ["--vendor", "strip", "--comments", "strip"],
    ["--collapse-fixed", "--vendor", "strip", "--comments", "strip", "--canonical"],
]
ONCE = [["--prefix", "p_"]]  # these options add up if they are repeated


TOLERANCE = 1e-12  # relative, or m and rad
compared = 0  # robots whose masses this test could compute
largest = {}  # difference by what was compared


def note_proof(text):
    for what, figure in re.findall(r"^  ([a-z ]+?) {2,}([-+.e0-9]+)", text, re.MULTILINE):
        largest[what] = max(largest.get(what, 0), float(figure))


def export(tool, source, target, options):
    """None, or the reason of a failure."""
    done = subprocess.run([tool, str(source), "-o", str(target), "--force", "--quiet", "--prove",
                           *options], capture_output=True, text=True, timeout=60, check=False)
    if done.returncode == 0:
        note_proof(done.stderr)
    return None if done.returncode == 0 else f"{source} {options}: {done.stderr[-300:]}"


def note_masses(source, collapsed):
    """Only for files that Python's strict reader accepts and that contain plain numbers."""
    try:
        before, after = mass_properties.total(source), mass_properties.total(collapsed)
    except (ElementTree.ParseError, ValueError, AttributeError, RecursionError, KeyError):
        return
    what = "masses, computed here"
    largest[what] = max(largest.get(what, 0), mass_properties.difference(before, after))
    global compared
    compared += 1


def main():
    tool, root = sys.argv[1], pathlib.Path(sys.argv[2])
    if not root.is_dir():
        print(f"skipped: there is no {root}")
        sys.exit(77)
    failures, count = [], 0
    with tempfile.TemporaryDirectory() as name:
        first, second = pathlib.Path(name, "first.urdf"), pathlib.Path(name, "second.urdf")
        for source in sorted(root.rglob("*.urdf")):
            if export(tool, source, first, []) is not None:
                continue  # the model cannot be read
            count += 1
            for options in OPTIONS + ONCE:
                failure = export(tool, source, first, options)
                if failure is None and options == ["--collapse-fixed"]:
                    note_masses(source, first)
                if failure is None and options not in ONCE:
                    failure = export(tool, first, second, options)
                    if failure is None and first.read_bytes() != second.read_bytes():
                        failure = f"{source} {options}: a second time changes the result"
                if failure is not None:
                    failures.append(failure)
    print(f"{count} URDFs, {len(OPTIONS) + len(ONCE)} exports of each; largest differences:")
    print(f"  masses of {compared} robots were computed here as well")
    for what, figure in largest.items():
        print(f"  {what:28s}{figure:.2g}")
        # The tool compares places far from the origin relative to their distance.
        if figure > TOLERANCE and "distance" not in what:
            failures.append(f"{what}: {figure} is more than {TOLERANCE}")
    if count == 0:
        failures.append("no URDF was tried")
    sys.exit("\n".join(failures) or 0)


if __name__ == "__main__":
    main()
