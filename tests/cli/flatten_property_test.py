# SPDX-License-Identifier: BSD-3-Clause
"""Compares random nested scenes with an independent computation with plain 4x4 matrices.

Also checks that flatten(flatten(x)) == flatten(x), that every run gives the same bytes, and the cost
of 1,000 robots of 40 links.
"""
import json
import math
import pathlib
import random
import resource
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import cli  # noqa: E402

SCENES = 200
JOINTS = 6


def processor_time():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def identity():
    return [[float(i == j) for j in range(4)] for i in range(4)]


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def translation(x, y, z):
    return [[1, 0, 0, x], [0, 1, 0, y], [0, 0, 1, z], [0, 0, 0, 1]]


def about(axis, angle):
    """Rodrigues' formula; radians."""
    length = math.sqrt(sum(c * c for c in axis))
    x, y, z = (c / length for c in axis)
    s, c, t = math.sin(angle), math.cos(angle), 1 - math.cos(angle)
    return [[t * x * x + c, t * x * y - s * z, t * x * z + s * y, 0],
            [t * x * y + s * z, t * y * y + c, t * y * z - s * x, 0],
            [t * x * z - s * y, t * y * z + s * x, t * z * z + c, 0], [0, 0, 0, 1]]


def euler(x, y, z):
    return product(about([0, 0, 1], z), product(about([0, 1, 0], y), about([1, 0, 0], x)))


def quaternion(w, x, y, z):
    return about([x, y, z], 2 * math.atan2(math.hypot(x, y, z), w)) if x or y or z else identity()


def matrix(pose):
    q = pose["orientation"]
    return product(translation(*pose["position"]), quaternion(q["w"], q["x"], q["y"], q["z"]))


def difference(a, b):
    return max(abs(a[i][j] - b[i][j]) for i in range(4) for j in range(4))


class Robot:
    """A chain of random joints, as URDF text and as a function from positions to link poses."""

    def __init__(self, dice, joints=JOINTS):
        self.joints = []
        for _ in range(joints):
            kind = dice.choice(["revolute", "continuous", "prismatic", "fixed"])
            self.joints.append((kind, vector(dice, 1), vector(dice, 3), axis(dice)))
        self.positions = {f"j{i}": dice.uniform(-1, 1)
                          for i, joint in enumerate(self.joints) if joint[0] != "fixed"}

    def urdf(self):
        links = "".join(f'<link name="l{i}"><inertial><mass value="1"/><inertia ixx="1" ixy="0" '
                        f'ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>\n'
                        for i in range(len(self.joints) + 1))
        joints = ""
        for i, (kind, xyz, rpy, direction) in enumerate(self.joints):
            joints += (f'<joint name="j{i}" type="{kind}"><parent link="l{i}"/>'
                       f'<child link="l{i + 1}"/><origin xyz="{words(xyz)}" rpy="{words(rpy)}"/>')
            if kind != "fixed":
                joints += f'<axis xyz="{words(direction)}"/>'
                joints += '<limit effort="1" velocity="1"'
                joints += "/>" if kind == "continuous" else ' lower="-2" upper="2"/>'
            joints += "</joint>\n"
        return f'<robot name="chain">\n{links}{joints}</robot>\n'

    def links(self, positions):
        at = identity()
        poses = [at]
        for i, (kind, xyz, rpy, direction) in enumerate(self.joints):
            at = product(at, product(translation(*xyz), euler(*rpy)))
            q = positions.get(f"j{i}", 0)
            if kind == "prismatic":
                length = math.sqrt(sum(c * c for c in direction))
                at = product(at, translation(*(q * c / length for c in direction)))
            elif kind != "fixed":
                at = product(at, about(direction, q))
            poses.append(at)
        return poses


def vector(dice, size):
    return [dice.uniform(-size, size) for _ in range(3)]


def axis(dice):
    return dice.choice([[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, -1], vector(dice, 1)])


def words(numbers):
    return " ".join(map(repr, numbers))


class World:
    """One random scene: its files, and the expected poses."""

    def __init__(self, seed):
        self.dice = random.Random(seed)
        self.robots = [Robot(self.dice) for _ in range(2)]
        self.files = {}
        self.expected = {}  # path -> (pose, positions, robot)
        for i, robot in enumerate(self.robots):
            self.files[f"r{i}.urdf"] = robot.urdf()
            self.files[f"r{i}.smurf"] = f"modelname: r{i}\nfiles: [r{i}.urdf, r{i}_poses.yml]\n"
            self.files[f"r{i}_poses.yml"] = f"poses:\n- {{name: p, joints: {robot.positions}}}\n"
        self.number = 0
        self.scene("", identity(), 0)

    def rotation(self):
        """Possible notations, and their meaning."""
        dice = self.dice
        kind = dice.randrange(5)
        if kind == 0:
            return None, identity()
        if kind == 1:
            angle = dice.choice([90, -45, 180, dice.uniform(-400, 400)])
            return dice.choice([[angle], angle]), about([0, 0, 1], math.radians(angle))
        if kind == 2:
            angles = [dice.choice([0, 90, dice.uniform(-180, 180)]) for _ in range(3)]
            return angles, euler(*map(math.radians, angles))
        numbers = [dice.uniform(-1, 1) for _ in range(4)]
        length = math.sqrt(sum(n * n for n in numbers))
        numbers = [n / length for n in numbers]
        mapping = {key: n for key, n in zip("wxyz", numbers)}
        return numbers if kind == 3 else mapping, quaternion(*numbers)

    def place(self, local):
        """An entity in this scene, or in an enclosing one, whose link can be a parent."""
        path, (pose, positions, robot) = self.dice.choice(local)
        link = self.dice.randrange(JOINTS + 1)
        return (f"{path.split('/')[-1]}::l{link}",
                product(pose, robot.links(positions)[link]))

    def scene(self, prefix, frame, depth, around=()):
        dice = self.dice
        file = f"s{len(self.files)}.smurfs"
        self.files[file] = ""
        entities, local = [], list(around)
        for _ in range(dice.randint(1, 4)):
            self.number += 1
            name = f"e{self.number}"
            entity = {"name": name, "position": vector(dice, 10)}
            notation, turn = self.rotation()
            if notation is not None:
                entity["rotation"] = notation
            own = product(translation(*entity["position"]), turn)
            base = frame
            if local and dice.random() < 0.5:
                entity["parent"], base = self.place(local)
                entity["anchor"] = "parent"
            pose = product(base, own)
            if depth < 3 and dice.random() < 0.35:
                entity["file"] = self.scene(prefix + name + "/", pose, depth + 1, local)
            else:
                which = dice.randrange(2)
                entity["file"] = f"r{which}.smurf"
                positions = {}
                if dice.random() < 0.6:
                    entity["pose"] = "p"
                    positions = self.robots[which].positions
                self.expected[prefix + name] = (pose, positions, self.robots[which])
                local.append((prefix + name, self.expected[prefix + name]))
            entities.append(entity)
        dice.shuffle(entities)  # the order of entities does not matter
        self.files[file] = json.dumps({"entities": entities}, indent=1)
        self.files["main.smurfs"] = self.files[file]  # the outermost scene comes last
        return file


class Properties(cli.CliTest):
    def flat(self, scene, *arguments):
        done = self.run_tool(scene, "--quiet", *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_random_scenes(self):
        instances = 0
        for seed in range(SCENES):
            world = World(seed)
            for path, text in world.files.items():
                self.write(path, text)
            text = self.flat("main.smurfs", "--links")
            flat = {i["path"]: i for i in json.loads(text)["instances"]}
            self.assertEqual(set(flat), set(world.expected), f"seed {seed}")
            for path, (pose, positions, robot) in world.expected.items():
                message = f"seed {seed}: {path}"
                self.assertLess(difference(matrix(flat[path]), pose), 1e-9, message)
                for i, X_EL in enumerate(robot.links(positions)):
                    link = matrix(flat[path]["links"][f"l{i}"])
                    self.assertLess(difference(link, product(pose, X_EL)), 1e-9, message)
            instances += len(flat)
            if seed % 10 == 0:
                self.check_fixed_point(flat)
        self.assertGreater(instances, 3 * SCENES)

    def check_fixed_point(self, flat):
        """A flattened scene is flat, and flattening it again gives the same result."""
        self.write("once.smurfs", self.flat("main.smurfs", "--format", "smurfs"))
        self.write("twice.smurfs", self.flat("once.smurfs", "--format", "smurfs"))
        self.assertEqual(self.read("once.smurfs"), self.read("twice.smurfs"))
        again = {i["path"]: i for i in json.loads(self.flat("once.smurfs"))["instances"]}
        self.assertEqual(list(again), list(flat))
        for path, instance in again.items():
            for key in ("position", "orientation", "anchor", "joint_positions", "type"):
                self.assertEqual(instance[key], flat[path][key], path)

    def test_the_same_bytes_on_every_run(self):
        for path, text in World(1).files.items():
            self.write(path, text)
        for form in self.formats():
            first = self.flat("main.smurfs", "--format", form)
            self.assertEqual(self.flat("main.smurfs", "--format", form), first, form)

    def test_a_thousand_robots_of_forty_links(self):
        robot = Robot(random.Random(7), joints=39)
        self.write("r.urdf", robot.urdf())
        self.write("r.smurf", "modelname: r\nfiles: [r.urdf]\n")

        def seconds(count):
            self.write("many.smurfs", "entities:\n" + "".join(
                f"- {{name: e{i}, file: r.smurf, position: [{i}, 0, 0]}}\n" for i in range(count)))
            start = processor_time()
            flat = json.loads(self.flat("many.smurfs"))
            self.assertEqual((len(flat["models"]), len(flat["instances"])), (1, count))
            return processor_time() - start

        one, many = min(seconds(1) for _ in range(5)), min(seconds(1000) for _ in range(3))
        print(f"1 robot: {one * 1e3:.0f} ms; 1,000 robots: {many * 1e3:.0f} ms", file=sys.stderr)
        # One robot is read, solved and written in its time, less the start of the program; a thousand are only written.
        self.assertLess(many, 300 * one)


if __name__ == "__main__":
    cli.main()
