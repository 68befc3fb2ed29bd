# SPDX-License-Identifier: BSD-3-Clause
"""Another build of the tools prints, writes and returns what the native one does, on all fixtures and the corpus.

usage: parity_test.py FOLDER_OF_TOOLS wasm PACKAGE [CORPUS]
       parity_test.py FOLDER_OF_TOOLS arm64 FOLDER_OF_PROGRAMS [CORPUS]
       parity_test.py FOLDER_OF_TOOLS windows FOLDER_OF_PROGRAMS [CORPUS]

SMURF_PARITY_SHARD=K/N compares the K-th of N parts only.
"""
import os
import pathlib
import subprocess
import sys
import tempfile

from builds import BUILDS, Native
from comparison import are_equal

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import formats  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
FIXTURES = ROOT / "build/fixtures"
PRESETS = ("ros2", "gazebo", "mujoco", "drake")


def lint_jobs(roots):
    for root in roots:
        yield from (("smurf-lint", ["--format=json", "--all", "."], folder) for folder in folders_of(root))
    yield from (("smurf-lint", ["--format=full", str(path.relative_to(FIXTURES))], FIXTURES)
                for kind in ("models", "scenes") for path in sorted((FIXTURES / kind).iterdir()))
    yield from (("smurf-lint", [f"--format={kind}", "models"], FIXTURES)
                for kind in ("concise", "sarif", "github", "gitlab", "junit", "html"))
    yield from (("smurf-lint", arguments, FIXTURES) for arguments in (
        ["--help"], ["--version"], ["--list-rules"], ["--list-rules=json"], ["--explain=SML1422"], ["--no-such-option"],
        ["no/such/path"], ["--target=all", "models"], ["--statistics", "models"], ["--diff", "rules"]))


def folders_of(root):
    """Folders of one model or scene each, and of fixtures, so that the findings of one do not affect another."""
    if root == FIXTURES:
        yield from sorted(path for path in (root / "rules").glob("*/*") if path.is_dir())
        yield from sorted(path for kind in ("models", "scenes", "load-check") for path in (root / kind).iterdir() if path.is_dir())
    else:
        yield from sorted({path.parent for path in root.rglob("*") if path.suffix in (".urdf", ".smurf", ".smurfs")})


def files_in(roots, suffix):
    return sorted(path for root in roots for path in root.rglob("*" + suffix) if path.is_file())


def conversion_jobs(roots, scratch, scene_formats):
    """Paths are relative: absolute ones have a drive in Windows."""
    def from_scratch(suffix):
        return [os.path.relpath(path, scratch) for path in files_in(roots, suffix)]

    for path in from_scratch(".smurfs"):
        yield from (("smurfs-flatten", [f"--format={kind}", path], scratch) for kind in scene_formats)
        yield "smurfs-flatten", ["--dialect=mars", "--links", "-o", "scene.json", path], scratch
    for path in from_scratch(".smurf") + from_scratch(".urdf"):
        yield "smurf2urdf", ["--prove", "--force", path], scratch
        yield "smurf2urdf", ["--canonical", "--collapse-fixed", "--force", "-o", "robot.urdf", path], scratch
    for path in from_scratch(".smurf"):
        yield from (("smurf2urdf", [f"--preset={preset}", "--force", path], scratch) for preset in PRESETS)
    for path in from_scratch(".urdf"):
        yield "urdf2smurf", ["--force", "--overwrite", "-o", "robot", path], scratch


def comparison_jobs(roots):
    for root in roots:
        paths = [str(path.relative_to(root)) for path in files_in([root], ".urdf")]
        yield from (("smurf-diff", ["--format=json", old, new], root) for old, new in zip(paths, paths[1:]))


def main():
    tools, kind, folder = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2], pathlib.Path(sys.argv[3]).resolve()
    BUILDS[kind].skip_without(tools, folder)
    roots = [FIXTURES]
    if len(sys.argv) > 4 and (pathlib.Path(sys.argv[4]) / "MANIFEST.tsv").is_file():
        roots.append(pathlib.Path(sys.argv[4]).resolve())
    else:
        print("there is no corpus; only the fixtures are compared")
    part, parts = map(int, os.environ.get("SMURF_PARITY_SHARD", "1/1").split("/"))
    native, other = Native(tools), BUILDS[kind](folder)
    help_page = subprocess.run([tools / "smurfs-flatten", "--format", "help"], capture_output=True, text=True, check=True)
    scene_formats = formats.listed(help_page.stdout)
    with tempfile.TemporaryDirectory(prefix="smurf-parity-") as scratch:
        scratch = pathlib.Path(scratch)
        jobs = [*lint_jobs(roots), *conversion_jobs(roots, scratch, scene_formats), *comparison_jobs(roots)]
        jobs = [job for job in jobs if job[0] in other.tools][part - 1 :: parts]
        sys.exit(not are_equal(native, other, jobs, scratch))


main()
