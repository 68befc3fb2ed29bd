#!/usr/bin/env python3
"""Counts instructions of whole runs and compares them with a committed baseline.

instructions.py BIN BASELINE.json            fails (1) when a run takes over 3 % more than the baseline
instructions.py BIN BASELINE.json --update   writes the baseline

Counts do not depend on what else the machine does, but on the compiler, its library and the kind of
processor, for which the C library has variants of its functions. The baseline says which they were; with
others the comparison is skipped (77), as it is without valgrind. Valgrind hides AVX-512 from the program,
so that processors with and without it count the same.
"""
import json
import pathlib
import platform
import subprocess
import sys
import tempfile

from targets import HERE, instructions

TOLERANCE = 1.03


def conditions(binaries: pathlib.Path) -> dict:
    """The configuration to which the counts belong."""
    cache = binaries.parent / "CMakeCache.txt"
    found = [line.split("=", 1)[1] for line in cache.read_text().splitlines()
             if line.startswith("CMAKE_CXX_COMPILER:")] if cache.exists() else ["c++"]
    compiler = subprocess.run([found[0], "--version"], capture_output=True, text=True).stdout.splitlines()[0]
    library = subprocess.run([found[0], "-print-file-name=libstdc++.so"], capture_output=True, text=True).stdout
    flags = pathlib.Path("/proc/cpuinfo").read_text().split("flags", 1)[-1].split("\n", 1)[0].split()
    return {"compiler": compiler, "libstdc++": pathlib.Path(library.strip()).resolve().name,
            "libc": " ".join(platform.libc_ver()), "processor": [one for one in ("avx2",) if one in flags]}


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
    today, known = conditions(binaries), json.loads(baseline.read_text()) if baseline.exists() else {}
    with tempfile.TemporaryDirectory() as work:
        counts = count(binaries, pathlib.Path(work))
    if None in counts.values():
        print("SKIPPED: no valgrind; scripts/setup --dev installs it")
        return 77
    if "--update" in sys.argv:
        baseline.write_text(json.dumps({**today, "instructions": counts}, indent=2) + "\n")
        return 0
    for what, known_one in known.items():
        if what != "instructions" and known_one != today[what]:
            print(f"SKIPPED: the baseline is of {what} {known_one}, this is {today[what]}")
            return 77
    print(", ".join(f"{what} {one}" for what, one in today.items()))
    status = 0
    for name, number in counts.items():
        ratio = number / known["instructions"][name]
        print(f"{name}: {number / 1e6:.1f} million instructions, {100 * (ratio - 1):+.1f} %")
        if ratio > TOLERANCE:
            status = 1
    if status:
        print("over 3 % more than the baseline: make it faster, or say why in the commit that updates it with --update")
    return status


if __name__ == "__main__":
    sys.exit(main())
