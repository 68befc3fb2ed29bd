# SPDX-License-Identifier: BSD-3-Clause
"""What libsdformat 12.3 leaves out of random robots with fixed joints and links without mass, and which it refuses,
against the findings of smurf-lint (SML1453, SML1454) and its verdict.

Usage: gazebo_losses_test.py SMURF-LINT READER
"""
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile

ROBOTS = 400
ZERO = '<inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/>'
SOUND = '<inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>'
WRONG = SOUND.replace("0.01", "0.5", 1)
INERTIALS = {"mass": f'<inertial><origin xyz="0.1 0 0"/><mass value="1"/>{SOUND}</inertial>',
             "unread": f'<inertial><origin xyz="0.1 0 0"/><mass value="1 "/>{SOUND}</inertial>',
             "wrong": f'<inertial><mass value="1"/>{WRONG}</inertial>',
             "zero": f'<inertial><mass value="0"/>{ZERO}</inertial>', "none": ""}


class Robot:
    """Link 0 and moving links have a mass of their own, which a space may hide; others may have none."""

    def __init__(self, choice):
        count = choice.randint(2, 9)
        self.parents = [None] + [choice.randrange(link) for link in range(1, count)]
        self.kinds = ["root"] + [choice.choice(("fixed", "fixed", "moving", "kept")) for _ in range(1, count)]
        self.names = [f"l{number}" for number in choice.sample(range(100), count)]
        kinds_of_mass = {"root": ["mass"], "moving": ["mass"] * 10 + ["unread", "wrong"]}
        self.masses = [choice.choice(kinds_of_mass.get(kind, ("mass", "zero", "none", "none"))) for kind in self.kinds]

    def text(self):
        parts = []
        for link, name in enumerate(self.names):
            parts.append(f'<link name="{name}">{INERTIALS[self.masses[link]]}</link>')
            if link == 0:
                continue
            kind = "revolute" if self.kinds[link] == "moving" else "fixed"
            limit = '<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/>' if kind == "revolute" else ""
            parts.append(f'<joint name="j_{name}" type="{kind}"><parent link="{self.names[self.parents[link]]}"/>'
                         f'<child link="{name}"/>{limit}</joint>')
            if self.kinds[link] == "kept":
                parts.append(f'<gazebo reference="j_{name}"><preserveFixedJoint>true</preserveFixedJoint></gazebo>')
        return '<robot name="r">\n' + "\n".join(parts) + "\n</robot>\n"

    def body(self, link):
        while self.kinds[link] == "fixed":
            link = self.parents[link]
        return link

    def lost(self, links):
        """The links of which nothing is in these links of an SDF."""
        return sum(self.names[self.body(link)] not in links for link in range(len(self.names)))


def numbers_of(report):
    """How many links are lost, by the findings."""
    found = 0
    for finding in report["diagnostics"]:
        if finding["id"] == "SML1453":
            found += sum(int(re.search(r"has (\d+) links?", note)[1]) for note in finding["notes"] if "less" in note)
    return found


def main():
    lint, reader = sys.argv[1:3]
    if not pathlib.Path(reader).is_file():
        print("sdformat_robot was not built: libsdformat is not installed")
        return 77
    choice = random.Random(38)
    robots = [Robot(choice) for _ in range(ROBOTS)]
    wrong, lossy, refused = [], 0, 0
    with tempfile.TemporaryDirectory(prefix="smurf-losses-") as folder:
        files = []
        for number, robot in enumerate(robots):
            files.append(pathlib.Path(folder) / f"{number}.urdf")
            files[-1].write_text(robot.text(), encoding="utf-8")
        read = subprocess.run([reader], input="\n".join(map(str, files)) + "\n", capture_output=True, encoding="utf-8",
                              timeout=600, check=True).stdout
        answers = {pathlib.Path(one["file"]).name: one for one in map(json.loads, read.splitlines())}
        for robot, file in zip(robots, files):
            done = subprocess.run([lint, "--target", "gazebo:fortress", "--format", "json", file], capture_output=True,
                                  encoding="utf-8", timeout=600, check=False)
            report, answer = json.loads(done.stdout), answers[file.name]
            says_refused = next(iter(report["targets"].values()))["verdict"] == "refuses"
            is_refused = answer["verdict"] != "takes"
            refused += is_refused
            if says_refused != is_refused:
                wrong.append(f"{answer['verdict']} {answer['message']}, we say otherwise:\n{robot.text()}")
            if is_refused:
                continue
            links = {key.partition(":")[2] for key in answer["robot"] if key.startswith("links:")}
            lost = robot.lost(links)
            lossy += lost > 0
            if lost != numbers_of(report):
                wrong.append(f"{lost} links lost, we say {numbers_of(report)}:\n{robot.text()}")
    print(f"{ROBOTS} robots: {refused} refused, {lossy} with lost links, {len(wrong)} wrong")
    for one in wrong[:3]:
        print(one)
    assert refused > 20 and lossy > 50
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
