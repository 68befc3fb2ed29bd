# SPDX-License-Identifier: BSD-3-Clause
"""usda of models of the corpus, against their URDFs: every frame, mass, inertia, axis and limit.

Called as usd_corpus_test.py CASES CORPUS; ends with 77, which CTest shows as skipped, when there is
no corpus. Where usd-core of scripts/setup --python-readers is installed, its validators read all of them, and the
scenes of the fixtures.
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

from usd_stage import Robot, Stage, differences, parsed

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import cases  # noqa: E402

LEAST = 300  # number of written models
ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PYTHON = ROOT / "build/readers/python/bin/python"
VALIDATE = """
import sys
from pxr import Usd, UsdValidation
registry = UsdValidation.ValidationRegistry()
context = UsdValidation.ValidationContext(registry.GetOrLoadAllValidators())
for file in sys.stdin.read().split():
    for error in context.Validate(Usd.Stage.Open(file)):
        print(file, error.GetValidator().GetMetadata().name, error.GetMessage())
print("validated")
"""


def main():
    program, corpus = sys.argv[1], pathlib.Path(sys.argv[2])
    if not corpus.is_dir():
        print(f"no corpus at {corpus}")
        return 77
    with cases.Cases(program) as tools, tempfile.TemporaryDirectory() as scratch:
        return max(compare(tools, corpus, pathlib.Path(scratch)), validate(tools, pathlib.Path(scratch)))


def validate(tools, folder):
    """What the validators of OpenUSD say of the stages in the folder, and of those of the fixtures."""
    for scene in sorted((ROOT / "fixtures/scenes").rglob("*.smurfs")) + sorted((ROOT / "fixtures/models").rglob("*.smurf")):
        done = tools.run("smurfs-flatten", scene, "--format", "usda", "--quiet")
        if done.returncode == 0:
            (folder / f"fixture{len(list(folder.iterdir()))}.usda").write_text(done.stdout)
    files = sorted(folder.iterdir())
    done = subprocess.run([PYTHON, "-c", VALIDATE], input="\n".join(map(str, files)), capture_output=True, text=True,
                          check=False) if PYTHON.exists() else None
    if done is None or "No module named" in done.stderr:
        print("skipped: the validators of OpenUSD are not installed")
        return 0
    lines = done.stdout.splitlines()
    print(f"{len(files)} stages validated, {len(lines) - 1} complaints")
    print("\n".join(lines[:10]))
    return 0 if lines == ["validated"] else 1


def narrower_speeds(model):
    """[joint, degrees per second] of the speeds with which ros2_control commands joints, which narrow their limits."""
    speeds = []
    for joint in parsed(model).iterfind("ros2_control/joint"):
        for most in joint.iterfind("command_interface[@name='velocity']/param[@name='max']"):
            speeds.append((joint.get("name"), math.degrees(float(most.text))))
    return speeds


def compare(tools, corpus, folder):
    counts, failed = {"models": 0, "links": 0}, 0
    for model in sorted(corpus.rglob("*.urdf")):
        done = tools.run("smurfs-flatten", model, "--format", "usda", "--quiet")
        if done.returncode != 0:
            continue
        (folder / f"model{counts['models']}.usda").write_text(done.stdout)
        flat = json.loads(tools.run("smurfs-flatten", model, "--links", "--quiet").stdout)
        narrowed = narrower_speeds(model)
        problems = [problem for problem in differences(Stage(done.stdout), flat, lambda _: Robot(model))
                    if not any(f"{joint}: physxJoint:maxJointVelocity is {speed} " in problem for joint, speed in narrowed)]
        counts["models"] += 1
        counts["links"] += sum(len(instance["links"]) for instance in flat["instances"])
        if problems:
            failed += 1
            print(f"{model}: {problems[:3]} and {max(0, len(problems) - 3)} more")
    print(counts, f"{failed} failed")
    return 1 if failed or counts["models"] < LEAST else 0


if __name__ == "__main__":
    sys.exit(main())
