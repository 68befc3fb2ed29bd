# SPDX-License-Identifier: BSD-3-Clause
"""Robots hang and fall in the load check's ODE as they do in MuJoCo and DART.

Each URDF is reduced to what all three know alike: masses and joints without limits, damping,
friction and shapes. Then 0.1, 0.25, 0.5 and 1 s of the same motion are compared: where the links
are while the root is held, how high the centre of mass is while nothing is, and that no energy
comes from nowhere. Motions of chains are chaotic, so that two good simulators drift apart, too:
where a link is compared, ODE may be as far from MuJoCo as DART is, times kFactor, and kPlace more.

usage: motion_test.py BUILD LEAST STEP FOLDER...; exits with 77 (skipped) without MuJoCo or DART,
or without the folders.
"""
import collections
import math
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

GRAVITY = 9.81
EXACT = 1e-9    # m; DART's steps are of first order as ODE's are
PLACE = {0.1: 1e-3, 0.25: 5e-3, 0.5: 0.02, 1.0: 0.1}  # m, by time: twice what was measured
FACTOR = 3
DROPPED = ("visual", "collision")
ENGINES = ("ode", "mujoco", "dart")


def mass_of(robot):
    return sum(float(mass.get("value")) for mass in robot.iter("mass"))


def reduced(path):
    """The mechanics of a URDF as an element, or why it is none that all three can move."""
    try:
        robot = ElementTree.parse(path).getroot()
    except ElementTree.ParseError:
        return "is no XML"
    if robot.tag != "robot":
        return "is no robot"
    links = robot.findall("link")
    joints = robot.findall("joint")
    children = {joint.find("child").get("link") for joint in joints if joint.find("child") is not None}
    names = [link.get("name") for link in links]
    if len(children) != len(joints) or len(names) != len(joints) + 1 or len(set(names)) != len(names):
        return "is no tree"
    if not any(joint.get("type") in ("revolute", "continuous", "prismatic") for joint in joints):
        return "does not move"
    if any(joint.get("type") in ("floating", "planar") for joint in joints):
        return "has a joint of several freedoms"
    for element in list(robot):
        if element.tag not in ("link", "joint"):
            robot.remove(element)
    for link in links:
        for element in [e for e in link if e.tag != "inertial"]:
            link.remove(element)
    for joint in joints:
        for element in [e for e in joint if e.tag not in ("origin", "parent", "child", "axis")]:
            joint.remove(element)
        if joint.get("type") == "revolute":
            joint.set("type", "continuous")
        if joint.get("type") == "prismatic":
            ElementTree.SubElement(joint, "limit", lower="-1000", upper="1000", effort="0", velocity="0")
    return robot


def held_by_a_joint(robot):
    """MuJoCo holds every root: what falls has a floating joint above it."""
    children = {joint.find("child").get("link") for joint in robot.findall("joint")}
    [root] = [l.get("name") for l in robot.findall("link") if l.get("name") not in children]
    ElementTree.SubElement(robot, "link", name="smurf_nowhere")
    joint = ElementTree.SubElement(robot, "joint", name="fall", type="floating")
    ElementTree.SubElement(joint, "parent", link="smurf_nowhere")
    ElementTree.SubElement(joint, "child", link=root)
    return robot


def motions(program, step, files):
    """By file, what a program says of it; files that it refuses are left out. One that makes it
    crash is left out, and the rest is read again."""
    found, left = {}, list(files)
    while left:
        done = subprocess.run(["nice", program, str(step), *map(str, left)], capture_output=True,
                              text=True, errors="replace", timeout=3000, check=False)
        current, motion, ended = None, None, []
        for line in done.stdout.splitlines():
            kind, *fields = line.split("\t")
            if kind == "file":
                current, motion = pathlib.Path(fields[0]), collections.defaultdict(dict)
            elif kind == "pose":
                motion[float(fields[0])][fields[1]] = [float(x) for x in fields[2:5]]
            elif kind in ("hang", "fall"):
                motion[kind][float(fields[0])] = [float(x) for x in fields[1:]]
            else:
                ended.append(current)
                if kind == "end":
                    found[current] = motion
        left = left[len(ended) + 1:] if len(ended) < len(left) else []
    return found


def farthest(one, other):
    """The distance of the links that both know."""
    return max((math.dist(one[link], other[link]) for link in one.keys() & other.keys()), default=0)


class Comparison:
    def __init__(self):
        self.wrong, self.worst = [], collections.defaultdict(float)

    def within(self, name, what, value, bound):
        self.worst[what] = max(self.worst[what], value)
        if not value <= bound:
            self.wrong.append(f"{name}: {what} {value:.3g}, at most {bound:.3g}")

    def robot(self, name, weight, motion):
        ode, mujoco, dart = (motion[engine] for engine in ENGINES)
        for time, bound in PLACE.items():
            self.within(name, f"energy of HANG after {time:g} s", abs(ode["hang"][time][0]) / weight, ENERGY)
            self.within(name, f"energy of the fall after {time:g} s", abs(ode["fall"][time][0]) / weight, HEIGHT)
            for engine, reference in (("mujoco", mujoco), ("dart", dart)):
                self.within(name, f"height against {engine} after {time:g} s",
                            abs(ode["fall"][time][1] - reference["fall"][time][1]), HEIGHT)
            apart = farthest(mujoco[time], dart[time])
            self.within(name, f"links against mujoco after {time:g} s",
                        max(0, farthest(ode[time], mujoco[time]) - FACTOR * apart), bound)


def main(build, least, step, *folders):
    programs = {engine: pathlib.Path(build) / f"{engine}_motion" for engine in ENGINES}
    folders = [pathlib.Path(folder) for folder in folders]
    if not all(program.exists() for program in programs.values()):
        print("skipped: MuJoCo or DART is not installed; see scripts/setup --readers")
        return 77
    if not all(folder.is_dir() for folder in folders):
        print(f"skipped: not all of {folders} are there")
        return 77
    left_out, robots = collections.Counter(), {}
    with tempfile.TemporaryDirectory() as scratch:
        for i, path in enumerate(sorted(p for f in folders for p in f.rglob("*.urdf"))):
            robot = reduced(path)
            if isinstance(robot, str):
                left_out[robot] += 1
                continue
            hang, fall = pathlib.Path(scratch) / f"{i}.urdf", pathlib.Path(scratch) / f"{i}_fall.urdf"
            ElementTree.ElementTree(robot).write(hang)
            ElementTree.ElementTree(held_by_a_joint(robot)).write(fall)
            robots[hang] = (path, fall, mass_of(robot) * GRAVITY)
        found = {engine: motions(program, step, robots) for engine, program in programs.items()}
        falls = motions(programs["mujoco"], step, [fall for _, fall, _ in robots.values()])
    comparison, compared = Comparison(), 0
    for hang, (path, fall, weight) in robots.items():
        refused = [engine for engine in ENGINES if hang not in found[engine]]
        if fall not in falls and not refused:
            refused = ["mujoco, falling"]
        if refused:
            left_out["refused by " + ", ".join(refused)] += 1
            continue
        found["mujoco"][hang]["fall"] = falls[fall]["fall"]
        comparison.robot(path.name, weight, {engine: found[engine][hang] for engine in ENGINES})
        compared += 1
    print(f"{compared} robots compared; left out: {dict(left_out)}")
    for what, value in sorted(comparison.worst.items()):
        print(f"  {what:40s} {value:.2g}")
    if compared < int(least):
        comparison.wrong.append(f"{compared} robots are fewer than {least}")
    print("\n".join(comparison.wrong))
    return 1 if comparison.wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
