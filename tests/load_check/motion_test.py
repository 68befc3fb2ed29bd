# SPDX-License-Identifier: BSD-3-Clause
"""Robots hang, fall and drop in the load check's ODE as they do in MuJoCo and DART.

All three get what motion_urdf.py leaves of a URDF; masses that one of them refuses are replaced
for all. 0.1, 0.25, 0.5 and 1 s of the same motion are compared: where the links are while the root
is held, how high the centre of mass is while nothing is, and that no energy comes from nowhere;
with MuJoCo also when a drop reaches the ground and how high the centre of mass is then. Motions of
chains are chaotic, so that two good simulators drift apart, too: where a link is compared, ODE may
be as far from MuJoCo as DART is, times FACTOR, and PLACE more.

usage: motion_test.py BUILD LEAST STEP FOLDER...; exits with 77 (skipped) without MuJoCo or DART,
or without the folders.
"""
import collections
import hashlib
import math
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

import motion_urdf

GRAVITY = 9.81
EXACT = 1e-6    # m; DART's steps are of first order, like those of ODE
TIMES = (0.1, 0.25, 0.5, 1.0)
PLACE = 1e-3    # m; the largest difference on a hundred real robots was 1e-4
DROP_ENERGY = 1e-3  # m; measured: none
DROP_HEIGHT = 0.25  # m; a collapsing robot moves differently with soft contacts: up to 0.2
FACTOR = 3
CONTACT_STEPS = 2.5  # between the first contacts of two engines
SECONDS = 120
ENGINES = ("ode", "mujoco", "dart")


class Refused(Exception):
    pass


class Bench:
    """Runs one robot in one engine, in a separate process."""

    def __init__(self, build, step, scratch):
        self.build, self.step, self.scratch = pathlib.Path(build), step, pathlib.Path(scratch)

    def run(self, engine, robot, *ground):
        path = self.scratch / "robot.urdf"
        ElementTree.ElementTree(robot).write(path)
        try:
            done = subprocess.run([self.build / f"{engine}_motion", self.step, path, *map(repr, ground)],
                                  capture_output=True, text=True, errors="replace", timeout=SECONDS,
                                  check=False)
        except subprocess.TimeoutExpired:
            raise Refused(f"{engine} does not end") from None
        lines = done.stdout.splitlines()
        if done.returncode != 0:
            raise Refused(f"{engine} crashes")
        if lines[-1] != "end":
            raise Refused(f"{engine} fails to load it")
        motion = collections.defaultdict(dict)
        for line in lines[:-1]:
            kind, *fields = line.split("\t")
            if kind == "pose":
                motion[float(fields[0])][fields[1]] = [float(x) for x in fields[2:5]]
            elif kind in ("ground", "contact"):
                motion[kind] = float(fields[0])
            elif len(fields) > 1:
                motion[kind][float(fields[0])] = [float(x) for x in fields[1:]]
        return motion

    def motions(self, robot):
        """By engine."""
        ode = self.run("ode", robot)
        ground = [ode["ground"]] if "ground" in ode else []
        mujoco = self.run("mujoco", motion_urdf.for_mujoco(robot, False))
        mujoco.update(self.run("mujoco", motion_urdf.for_mujoco(robot, True, *ground), *ground))
        return {"ode": ode, "mujoco": mujoco, "dart": self.run("dart", robot)}


def farthest(one, other):
    """The distance of the links that are in both."""
    return max((math.dist(one[link], other[link]) for link in one.keys() & other.keys()), default=0)


class Comparison:
    def __init__(self, step):
        self.step, self.wrong, self.worst = step, [], collections.defaultdict(float)

    def within(self, name, what, value, bound):
        if not value <= self.worst[what]:
            self.worst[what] = value
        if not value <= bound:
            self.wrong.append(f"{name}: {what} {value:.3g}, at most {bound:.3g}")

    def robot(self, name, weight, motion):
        ode, mujoco, dart = (motion[engine] for engine in ENGINES)
        for time in TIMES:
            # Steps of first order are half a step ahead: GRAVITY * step * time / 2 in height.
            ahead = GRAVITY * self.step * time
            self.within(name, f"energy of HANG after {time:g} s", ode["hang"][time][0] / weight, ahead)
            self.within(name, f"energy of the fall after {time:g} s",
                        abs(ode["fall"][time][0]) / weight, ahead)
            self.within(name, f"height against mujoco after {time:g} s",
                        abs(ode["fall"][time][1] - mujoco["fall"][time][1]), ahead)
            self.within(name, f"height against dart after {time:g} s",
                        abs(ode["fall"][time][1] - dart["fall"][time][1]), EXACT)
            self.within(name, f"links against mujoco after {time:g} s",
                        max(0, farthest(ode[time], mujoco[time])
                            - FACTOR * farthest(mujoco[time], dart[time])), PLACE)
        if "ground" in ode:
            self.drop(name, weight, ode, mujoco)

    def drop(self, name, weight, ode, mujoco):
        self.within(name, "steps to the first contact against mujoco",
                    abs(ode.get("contact", math.inf) - mujoco.get("contact", -math.inf)) / self.step,
                    CONTACT_STEPS)
        self.within(name, "energy of DROP", ode["drop"][1.0][0] / weight, DROP_ENERGY)
        self.within(name, "energy of DROP in mujoco", mujoco["drop"][1.0][0] / weight, DROP_ENERGY)
        for time in TIMES:
            self.within(name, f"height of DROP against mujoco after {time:g} s",
                        abs(ode["drop"][time][1] - mujoco["drop"][time][1]), DROP_HEIGHT)


def distinct(folders):
    """The URDFs, without copies of the same content."""
    seen = set()
    for path in sorted(p for folder in folders for p in pathlib.Path(folder).rglob("*.urdf")):
        digest = hashlib.sha256(path.read_bytes()).digest()
        if digest not in seen:
            seen.add(digest)
            yield path


def moved(bench, path):
    """The motions of a robot, its mass, and whether its masses are as written."""
    robot = motion_urdf.read(path)
    if not motion_urdf.moves(robot):
        raise motion_urdf.Unfit("does not move")
    try:
        return bench.motions(robot), motion_urdf.mass_of(robot), True
    except (Refused, ValueError):
        pass
    try:
        robot = motion_urdf.repaired(robot)
    except ValueError:
        raise motion_urdf.Unfit("has masses that are no numbers") from None
    return bench.motions(robot), motion_urdf.mass_of(robot), False


def main(build, least, step, *folders):
    if not all((pathlib.Path(build) / f"{engine}_motion").exists() for engine in ENGINES):
        print("skipped: MuJoCo or DART is not installed; see scripts/setup --readers")
        return 77
    if not all(pathlib.Path(folder).is_dir() for folder in folders):
        print(f"skipped: not all of {folders} are there")
        return 77
    left_out, comparison, as_written = collections.Counter(), Comparison(float(step)), []
    with tempfile.TemporaryDirectory() as scratch:
        bench = Bench(build, step, scratch)
        for path in distinct(folders):
            try:
                motions, mass, is_as_written = moved(bench, path)
            except (motion_urdf.Unfit, Refused) as reason:
                left_out[str(reason)] += 1
                continue
            as_written.append(is_as_written)
            comparison.robot(path.name, mass * GRAVITY, motions)
    print(f"{len(as_written)} robots compared, {sum(as_written)} with masses as written; "
          f"left out: {dict(left_out)}")
    for what, value in sorted(comparison.worst.items()):
        print(f"  {what:45s} {value:.2g}")
    if len(as_written) < int(least):
        comparison.wrong.append(f"{len(as_written)} robots are fewer than {least}")
    print("\n".join(comparison.wrong))
    return 1 if comparison.wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
