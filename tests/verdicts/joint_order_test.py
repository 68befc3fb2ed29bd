# SPDX-License-Identifier: BSD-3-Clause
"""smurf-lint --joint-order, compared with what readers build: joint_order_test.py SMURF_LINT [FOLDER]

The orders of small robots are in joint_orders.tsv; --record writes it with the readers that are installed. With a
FOLDER, all of its URDF files and many more small robots are compared with these readers, too.
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "cli"))
import cli  # noqa: E402
import executed  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
TABLE = HERE / "joint_orders.tsv"
ROBOTS = 24
MORE_ROBOTS = 300
FOLDER = None
# Names of targets, and of the folders of readers; those without a folder are in the environment.
READERS = {"mujoco:2.3": ("mujoco", "mujoco-2.3.7"), "mujoco:3.1": ("mujoco", "mujoco-3.1.6"), "mujoco:3.3": ("mujoco", "mujoco-3.3.7"),
           "mujoco:4.0": ("mujoco", ""), "pybullet": ("pybullet", ""), "drake": ("drake", ""), "pinocchio": ("pinocchio", ""),
           "newton": ("newton", ""), "dart:6.20": ("dart", "dartpy-6.20.0")}
WHEELS = {"pinocchio": "pin"}
INERTIAL = ('<inertial><mass value="1"/><inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial>')


class Numbers:
    """The same numbers with every version of Python."""

    def __init__(self, seed):
        self.state = seed + 1

    def below(self, bound):
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) % 2 ** 64
        return (self.state >> 33) % bound

    def one_of(self, values):
        return values[self.below(len(values))]

    def shuffled(self, values):
        left, mixed = list(values), []
        while left:
            mixed.append(left.pop(self.below(len(left))))
        return mixed


def small_robot(seed):
    """A tree in which the orders of names, of the file, depth first and breadth first differ."""
    numbers = Numbers(seed)
    count = 4 + numbers.below(10)
    names = numbers.shuffled(f"{one}{numbers.below(10)}{one.swapcase()}" for one in "abcdefghijklmnOPQRSTUVWXYZpqrst")
    links, joints, followed = names[:count], names[count:2 * count], ""
    if numbers.below(6) == 0:
        links[0] = "world"
    kinds = ["revolute", "revolute", "revolute", "prismatic", "continuous", "fixed", "fixed"]
    if numbers.below(5) == 0:
        kinds += ["planar", "floating"]
    parts = [f'<link name="{links[0]}">{INERTIAL if numbers.below(2) else ""}</link>']
    for place in range(1, count):
        parent = links[max(0, place - 1 - numbers.below(4))]
        kind = numbers.one_of(kinds)
        inner = '<limit lower="-1" upper="1" effort="9" velocity="1"/>' if kind in ("revolute", "prismatic") else ""
        if kind == "revolute" and followed and numbers.below(4) == 0:
            inner += f'<mimic joint="{followed}"/>'
        elif kind == "revolute":
            followed = joints[place]
        inner += "" if kind in ("fixed", "floating") else '<axis xyz="0 0 1"/>'
        parts += [f'<link name="{links[place]}">{INERTIAL}</link>',
                  f'<joint name="{joints[place]}" type="{kind}"><parent link="{parent}"/><child link="{links[place]}"/>'
                  f'<origin xyz="0.1 0 {place}"/>{inner}</joint>']
    parts = numbers.shuffled(parts)
    setting = '<mujoco><compiler fusestatic="false"/></mujoco>' if numbers.below(6) == 0 else ""
    return "\n".join(['<robot name="r">', setting, *parts, "</robot>\n"])


def commands():
    """{target: command} of the readers that are installed."""
    found = {}
    for target, (module, name) in READERS.items():
        folder = executed.PYTHON.parent.parent.parent / name
        if name and folder.is_dir():
            found[target] = ["env", f"PYTHONPATH={folder}", executed.PYTHON, HERE / "order_robot.py", module]
        elif not name and executed.python_version(WHEELS.get(module, module)):
            found[target] = [executed.PYTHON, HERE / "order_robot.py", module]
    return found


def built(command, files):
    """{file: order} of those that the reader loads."""
    readings = executed.run(command, files)
    return {file: reading["robot"] for file, reading in readings.items() if "robot" in reading}


def ours(file, targets):
    """{target: order}; None where it is not known. {} if there is no robot."""
    done = subprocess.run([cli.TOOL, "--joint-order", ",".join(targets), "--format=json", "--allow-outside", "--isolated", file],
                          capture_output=True, text=True, check=False)
    orders = json.loads(done.stdout)["orders"] if done.returncode == 0 else []
    return {one["reader"]: {key: one[key] for key in ("joints", "indices", "bodies")} if one["known"] else None for one in orders}


def write_robots(folder, count):
    files = []
    for seed in range(count):
        files.append(os.path.join(folder, f"{seed}.urdf"))
        pathlib.Path(files[-1]).write_text(small_robot(seed), encoding="utf-8")
    return files


def record():
    with tempfile.TemporaryDirectory() as folder:
        files = write_robots(folder, ROBOTS)
        rows = []
        for target, command in commands().items():
            orders = built(command, files)
            rows += [[str(seed), target, *(" ".join(map(str, orders[file][key])) for key in ("joints", "indices", "bodies"))]
                     for seed, file in enumerate(files) if file in orders]
    lines = ["# What readers built of the robots of joint_order_test.py; written by its --record, not to be edited.",
             "robot\treader\tjoints\tindices\tbodies", *("\t".join(row) for row in rows)]
    TABLE.write_text("\n".join(lines) + "\n", encoding="utf-8")


class JointOrder(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def compare(self, files):
        found = commands()
        absent = [target for target in READERS if target not in found]
        if not found:
            self.skipTest("no reader is installed")
        expected = {file: ours(file, found) for file in files}
        self.counts = {}
        for target, command in found.items():
            for file, order in built(command, files).items():
                mine = expected[file].get(target)
                self.counts[target, mine is not None] = self.counts.get((target, mine is not None), 0) + 1
                if mine is not None:
                    self.assertEqual(mine, order, f"{target} {file}")
        if absent:
            self.skipTest("not installed: " + ", ".join(absent))

    def test_recorded(self):
        files = write_robots(self.folder, ROBOTS)
        rows = [line.split("\t") for line in TABLE.read_text(encoding="utf-8").splitlines()[2:]]
        compared = dict.fromkeys(READERS, 0)
        expected = [ours(file, READERS) for file in files]
        for robot, target, joints, indices, bodies in rows:
            mine = expected[int(robot)][target]
            if mine is None:
                self.assertEqual(target, "drake")
                self.assertIn('type="floating"', small_robot(int(robot)))
                continue
            compared[target] += 1
            with self.subTest(robot=robot, target=target):
                self.assertEqual(mine, {"joints": joints.split(), "indices": list(map(int, indices.split())), "bodies": bodies.split()})
        self.assertGreater(min(compared.values()), ROBOTS // 2, compared)

    def test_no_reader(self):
        file = write_robots(self.folder, 1)[0]
        done = subprocess.run([cli.TOOL, "--joint-order", "", file], capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("names no target", done.stderr)

    def test_readers(self):
        self.compare(write_robots(self.folder, ROBOTS))

    def test_many(self):
        if not FOLDER:
            self.skipTest("no folder was given")
        public = sorted(str(path) for path in pathlib.Path(FOLDER).rglob("*.urdf"))
        self.counts = {}
        try:
            self.compare(write_robots(self.folder, MORE_ROBOTS) + public)
        finally:
            print(self.counts)


if __name__ == "__main__":
    cli.TOOL = sys.argv[1]
    arguments = sys.argv[2:]
    if arguments == ["--record"]:
        record()
        sys.exit(0)
    if arguments and os.path.isdir(arguments[0]):
        FOLDER = arguments.pop(0)
    unittest.main(argv=[sys.argv[0], *arguments])
