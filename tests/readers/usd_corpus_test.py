# SPDX-License-Identifier: BSD-3-Clause
"""usda of models of the corpus, against their URDFs: every frame, mass, inertia, axis and limit.

Called as usd_corpus_test.py CASES CORPUS; ends with 77, which CTest shows as skipped, when there is
no corpus.
"""
import json
import math
import pathlib
import sys
from xml.etree import ElementTree

from usd_stage import Robot, Stage, differences

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import cases  # noqa: E402

LEAST = 300  # number of written models


def main():
    program, corpus = sys.argv[1], pathlib.Path(sys.argv[2])
    if not corpus.is_dir():
        print(f"no corpus at {corpus}")
        return 77
    with cases.Cases(program) as tools:
        return compare(tools, corpus)


def narrower_speeds(model):
    """[joint, degrees per second] of the speeds with which ros2_control commands joints, which narrow their limits."""
    speeds = []
    for joint in ElementTree.parse(model).getroot().iterfind("ros2_control/joint"):
        for most in joint.iterfind("command_interface[@name='velocity']/param[@name='max']"):
            speeds.append((joint.get("name"), math.degrees(float(most.text))))
    return speeds


def compare(tools, corpus):
    counts, failed = {"models": 0, "links": 0}, 0
    for model in sorted(corpus.rglob("*.urdf")):
        done = tools.run("smurfs-flatten", model, "--format", "usda", "--quiet")
        if done.returncode != 0:
            continue
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
