# SPDX-License-Identifier: BSD-3-Clause
"""The tools as WebAssembly say, write and return what the native ones do, on all fixtures and the corpus.

usage: parity_test.py FOLDER_OF_TOOLS PACKAGE [CORPUS]
"""
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

from built import skip_without

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
FIXTURES = ROOT / "fixtures"
SCENE_FORMATS = ("json", "tsv", "dot", "svg", "sdf", "mjcf", "urdf", "dmd", "gltf", "usda")
PRESETS = ("ros2", "gazebo", "mujoco", "drake")
MOST_SHOWN = 20
ENVIRONMENT = {"PATH": os.environ["PATH"], "NO_COLOR": "1"}


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
    """Folders of one model or scene each, and of fixtures: what a finding of one does not change that of another."""
    if root == FIXTURES:
        yield from sorted(path for path in (root / "rules").glob("*/*") if path.is_dir())
        yield from sorted(path for kind in ("models", "scenes", "load-check") for path in (root / kind).iterdir() if path.is_dir())
    else:
        yield from sorted({path.parent for path in root.rglob("*") if path.suffix in (".urdf", ".smurf", ".smurfs")})


def files_in(roots, suffix):
    return sorted(path for root in roots for path in root.rglob("*" + suffix) if path.is_file())


def conversion_jobs(roots, scratch):
    for path in files_in(roots, ".smurfs"):
        yield from (("smurfs-flatten", [f"--format={kind}", str(path)], scratch) for kind in SCENE_FORMATS)
        yield "smurfs-flatten", ["--dialect=mars", "--links", "-o", "scene.json", str(path)], scratch
    for path in files_in(roots, ".smurf") + files_in(roots, ".urdf"):
        yield "smurf2urdf", ["--prove", "--force", str(path)], scratch
        yield "smurf2urdf", ["--canonical", "--collapse-fixed", "--force", "-o", "robot.urdf", str(path)], scratch
    for path in files_in(roots, ".smurf"):
        yield from (("smurf2urdf", [f"--preset={preset}", "--force", str(path)], scratch) for preset in PRESETS)
    for path in files_in(roots, ".urdf"):
        yield "urdf2smurf", ["--force", "--overwrite", "-o", "robot", str(path)], scratch


def sum_of(data):
    return hashlib.sha256(data).hexdigest()


def run_native(tools, job):
    tool, arguments, folder = job
    done = subprocess.run([tools / tool, *arguments], cwd=folder, env=ENVIRONMENT, capture_output=True, check=False,
                          stdin=subprocess.DEVNULL)
    return [done.returncode, sum_of(done.stdout), sum_of(done.stderr)]


def written(folder):
    """What is in a folder, which is emptied."""
    found = {}
    for path in sorted(folder.rglob("*")):
        if path.is_file():
            found[str(path.relative_to(folder))] = sum_of(path.read_bytes())
    for path in folder.iterdir():
        shutil.rmtree(path) if path.is_dir() else path.unlink()
    return found


class Package:
    """One process that runs one job after the other."""

    def __init__(self, package):
        script = pathlib.Path(__file__).with_name("run_jobs.mjs")
        self.process = subprocess.Popen(["node", script, package], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def run(self, job):
        tool, arguments, folder = job
        self.process.stdin.write(json.dumps({"tool": tool, "args": arguments, "folder": str(folder)}) + "\n")
        self.process.stdin.flush()
        return json.loads(self.process.stdout.readline())


def show(tools, package, job):
    """Where the two differ, for whoever has to find out why."""
    tool, arguments, folder = job
    program = [str(package / "bin" / f"{tool}.mjs")]
    outputs = []
    for command in ([tools / tool], ["node", *program]):
        done = subprocess.run([*command, *arguments], cwd=folder, env=ENVIRONMENT, capture_output=True, check=False,
                              stdin=subprocess.DEVNULL)
        outputs.append([f"exit code {done.returncode}", *(done.stdout + done.stderr).decode(errors="replace").splitlines()])
    for native, wasm in zip(*outputs):
        if native != wasm:
            print(f"    native {native[:300]}\n    wasm   {wasm[:300]}")
            return


def main():
    tools, package = (pathlib.Path(path).resolve() for path in sys.argv[1:3])
    skip_without(tools, package)
    roots = [FIXTURES]
    if len(sys.argv) > 3 and (pathlib.Path(sys.argv[3]) / "MANIFEST.tsv").is_file():
        roots.append(pathlib.Path(sys.argv[3]).resolve())
    else:
        print("there is no corpus; only the fixtures are compared")
    process = Package(package)
    different = 0
    with tempfile.TemporaryDirectory(prefix="smurf-wasm-") as scratch:
        scratch = pathlib.Path(scratch)
        jobs = [*lint_jobs(roots), *conversion_jobs(roots, scratch)]
        for job in jobs:
            native = [run_native(tools, job), written(scratch)]
            wasm = [process.run(job), written(scratch)]
            if native == wasm:
                continue
            different += 1
            if different <= MOST_SHOWN:
                print("differs:", job[0], *job[1], "in", job[2])
                if native[0] == wasm[0]:
                    print("    in what was written:", native[1], wasm[1])
                show(tools, package, job)
                written(scratch)
    print(f"{len(jobs) - different} of {len(jobs)} runs are equal")
    sys.exit(different > 0)


main()
