#!/usr/bin/env python3
"""Counts instructions of whole runs and compares them with a committed baseline.

instructions.py BIN BASELINE.json            fails (1) when a run takes over 3 % more than the baseline
instructions.py BIN BASELINE.json --update   writes the baseline

Counts do not depend on what else the machine does, but on the compiler and its library: a baseline of
another compiler is skipped (77), as is a machine without valgrind.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

from targets import HERE, instructions

TOLERANCE = 1.03


def compiler() -> str:
    return subprocess.run(["c++", "--version"], capture_output=True, text=True).stdout.splitlines()[0]


def count(binaries: pathlib.Path, work: pathlib.Path) -> dict:
    for kind, size in (("model", 42), ("scene", 100)):
        subprocess.run([sys.executable, HERE / "generate.py", kind, str(size), work / kind], check=True)
    model, scene = str(work / "model/smurf/m.smurf"), str(work / "scene/world.smurfs")
    runs = {
        "lint a model of 42 links": ["smurf-lint", model],
        "lint a scene of 100 robots": ["smurf-lint", scene],
        "export a model of 42 links": ["smurf2urdf", model, "-o", str(work / "m.urdf")],
        "flatten a scene of 100 robots": ["smurfs-flatten", scene, "-o", str(work / "scene.json")],
    }
    return {name: instructions([str(binaries / run[0]), *run[1:]]) for name, run in runs.items()}


def main() -> int:
    binaries, baseline = map(pathlib.Path, sys.argv[1:3])
    with tempfile.TemporaryDirectory() as work:
        counts = count(binaries, pathlib.Path(work))
    if None in counts.values():
        print("skipped: no valgrind")
        return 77
    if "--update" in sys.argv:
        baseline.write_text(json.dumps({"compiler": compiler(), "instructions": counts}, indent=2) + "\n")
        return 0
    known = json.loads(baseline.read_text())
    if known["compiler"] != compiler():
        print(f"skipped: the baseline is of {known['compiler']}")
        return 77
    status = 0
    for name, today in counts.items():
        ratio = today / known["instructions"][name]
        print(f"{name}: {today / 1e6:.1f} million instructions, {100 * (ratio - 1):+.1f} %")
        if ratio > TOLERANCE:
            status = 1
    if status:
        print("over 3 % more than the baseline: make it faster, or say why in the commit that updates it with --update")
    return status


if __name__ == "__main__":
    sys.exit(main())
