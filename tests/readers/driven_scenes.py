# SPDX-License-Identifier: BSD-3-Clause
"""Random scenes of robots, and what a reader must build of them.

The truth is computed here with 4x4 matrices, from the numbers that are written into the files. Frames: `links` and `driven` are poses
in the world (m), rows of 4x4 matrices; `bodies` are the mass (kg), the centre of mass and the inertia about it (kg m^2) along the axes
of the link. Lengths are in m, angles in rad.
"""
import json
import math
import pathlib
import sys
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "cli"))
from flatten_property_test import about, axis, euler, identity, product, quaternion, translation, vector, words  # noqa: E402

MOVING = ("revolute", "revolute", "continuous", "prismatic")


def turned(rotation, tensor):
    """R I R^T of 3x3 parts."""
    return [[sum(rotation[i][k] * tensor[k][m] * rotation[j][m] for k in range(3) for m in range(3))
             for j in range(3)] for i in range(3)]


def unit(direction):
    """PyBullet takes the length of an axis for a factor."""
    length = math.sqrt(sum(c * c for c in direction))
    return [c / length for c in direction]


def inverse(pose):
    turn = [[pose[j][i] for j in range(3)] for i in range(3)]
    return [[*turn[i], -sum(turn[i][k] * pose[k][3] for k in range(3))] for i in range(3)] + [[0, 0, 0, 1]]


def random_inertia(dice):
    """Moments of a body that exists, turned at random."""
    a, b, c = (dice.uniform(0.002, 0.02) for _ in range(3))
    return turned(euler(*vector(dice, 3)), [[a + b, 0, 0], [0, b + c, 0], [0, 0, a + c]])


class Link:
    def __init__(self, dice, name, has_mass):
        self.name = name
        self.mass = dice.uniform(0.5, 5) if has_mass else 0
        self.centre, self.turn, self.tensor = vector(dice, 0.1), dice.choice([[0, 0, 0], vector(dice, 1)]), random_inertia(dice)

    def body(self):
        if not self.mass:
            return None
        tensor = turned(euler(*self.turn), self.tensor)
        return [self.mass, *self.centre, *(number for row in tensor for number in row)]

    def urdf(self):
        t = self.tensor
        inertial = (f'<inertial><origin xyz="{words(self.centre)}" rpy="{words(self.turn)}"/><mass value="{self.mass!r}"/>'
                    f'<inertia ixx="{t[0][0]!r}" ixy="{t[0][1]!r}" ixz="{t[0][2]!r}" iyy="{t[1][1]!r}" iyz="{t[1][2]!r}" '
                    f'izz="{t[2][2]!r}"/></inertial>') if self.mass else ""
        return f'<link name="{self.name}">{inertial}<visual><geometry><sphere radius="0.05"/></geometry></visual></link>\n'


class Joint:
    def __init__(self, dice, name, parent, child, kind):
        self.name, self.parent, self.child, self.kind = name, parent, child, kind
        self.place, self.turn, self.axis = vector(dice, 0.5), dice.choice([[0, 0, 0], vector(dice, 3)]), unit(axis(dice))
        self.lower, self.upper = -dice.uniform(0.2, 2), dice.uniform(0.2, 2.5)
        self.effort, self.speed, self.damping = dice.uniform(1, 100), dice.uniform(1, 10), dice.uniform(0, 2)
        self.leader = None  # its name and the multiplier

    def at(self, position):
        pose = product(translation(*self.place), euler(*self.turn))
        if self.kind == "prismatic":
            return product(pose, translation(*(position * c for c in self.axis)))
        return pose if self.kind == "fixed" else product(pose, about(self.axis, position))

    def urdf(self):
        text = (f'<joint name="{self.name}" type="{self.kind}"><parent link="{self.parent}"/><child link="{self.child}"/>'
                f'<origin xyz="{words(self.place)}" rpy="{words(self.turn)}"/>')
        if self.kind != "fixed":
            limits = "" if self.kind == "continuous" else f'lower="{self.lower!r}" upper="{self.upper!r}" '
            text += (f'<axis xyz="{words(self.axis)}"/><limit {limits}effort="{self.effort!r}" velocity="{self.speed!r}"/>'
                     f'<dynamics damping="{self.damping!r}"/>')
        if self.leader:
            text += f'<mimic joint="{self.leader[0]}" multiplier="{self.leader[1]!r}"/>'
        return text + "</joint>\n"


class Motor:
    """Exports resist a wrong speed with the whole effort at a tenth of the largest speed; a position is left at p times its error."""

    def __init__(self, dice):
        self.kind, self.p = dice.choice(["position", "velocity"]), dice.uniform(2, 30)
        self.effort, self.speed = dice.uniform(1, 80), dice.uniform(0.5, 8)

    def yaml(self, joint):
        return {"name": joint, "joint": joint, "type": self.kind, "p": self.p, "maxEffort": self.effort, "maxSpeed": self.speed}

    def drive(self):
        """Stiffness (N m/rad or N/m), damping (N m s/rad or N s/m), largest effort (N m or N)."""
        damping = self.effort / (0.1 * self.speed)
        return [self.p * damping if self.kind == "position" else 0, damping, self.effort]


class Robot:
    def __init__(self, dice, name):
        self.name, self.links, self.joints, leaders = name, [Link(dice, "l0", True)], [], []
        for i in range(1, dice.randint(2, 7)):
            kind = dice.choice([*MOVING, "fixed"])
            self.links.append(Link(dice, f"l{i}", kind != "fixed" or dice.random() < 0.6))
            joint = Joint(dice, f"j{i}", f"l{dice.randrange(max(0, i - 2), i)}", f"l{i}", kind)
            self.joints.append(joint)
            if kind in ("continuous", "prismatic") and leaders and dice.random() < 0.4:
                joint.leader = (dice.choice(leaders), dice.choice([-1.0, 0.5, 2.0]))
                joint.lower, joint.upper = -9.0, 9.0
            elif kind != "fixed":
                leaders.append(joint.name)
        self.free = {j.name: dice.uniform(j.lower, j.upper) for j in self.joints if j.name in leaders}
        self.bent = {name: position / 2 for name, position in self.free.items()}
        self.motors = {name: Motor(dice) for name in sorted(self.free) if dice.random() < 0.5}

    def position(self, joint, positions):
        if joint.leader:
            leader = next(one for one in self.joints if one.name == joint.leader[0])
            return joint.leader[1] * self.position(leader, positions)
        return positions.get(joint.name, 0)

    def poses(self, positions):
        poses = {"l0": identity()}
        for joint in self.joints:
            poses[joint.child] = product(poses[joint.parent], joint.at(self.position(joint, positions)))
        return poses

    def files(self):
        urdf = "".join(part.urdf() for part in [*self.links, *self.joints])
        return {f"{self.name}.urdf": f'<robot name="{self.name}">\n{urdf}</robot>\n',
                f"{self.name}.smurf": f"modelname: {self.name}\nfiles: [" + ", ".join(
                    [f"{self.name}.urdf", f"{self.name}_poses.yml", f"{self.name}_motors.yml"]) + "]\n",
                f"{self.name}_motors.yml": json.dumps({"motors": [motor.yaml(name) for name, motor in self.motors.items()]}),
                f"{self.name}_poses.yml": f"poses:\n- {{name: bent, joints: {json.dumps(self.bent)}}}\n"}


def numbers_of(element, attribute, default):
    text = None if element is None else element.get(attribute)
    return default if text is None else [float(word) for word in text.split()]


class RealRobot(Robot):
    """The links and joints of a URDF, without its shapes. Names of links and joints are numbered, the root is l0."""

    def __init__(self, dice, name, path):
        self.name, self.links, self.joints = name, [], []
        root = ElementTree.parse(path).getroot()
        joints = {one.find("child").get("link"): one for one in root.iter("joint") if one.find("child") is not None}
        names, joint_names = {}, {}

        def add(link):
            names[link.get("name")] = f"l{len(names)}"
            self.links.append(self.link_of(dice, names[link.get("name")], link.find("inertial")))
            for child in root.iter("link"):
                joint = joints.get(child.get("name"))
                if joint is not None and joint.find("parent").get("link") == link.get("name"):
                    joint_names[joint.get("name")] = f"j{len(names)}"
                    self.joints.append((joint, names[link.get("name")], f"l{len(names)}"))
                    add(child)
        add(next(link for link in root.iter("link") if link.get("name") not in joints))
        self.joints = [self.joint_of(dice, joint_names, *one) for one in self.joints]
        self.free = {j.name: dice.uniform(j.lower, j.upper) for j in self.joints if j.kind != "fixed" and not j.leader}
        self.bent = {name: self.free[name] / 2 for name in self.free}
        self.motors = {}

    @staticmethod
    def link_of(dice, name, inertial):
        link = Link(dice, name, inertial is not None)
        if inertial is not None:
            origin, inertia = inertial.find("origin"), inertial.find("inertia")
            link.mass = float(inertial.find("mass").get("value"))
            link.centre, link.turn = numbers_of(origin, "xyz", [0.0] * 3), numbers_of(origin, "rpy", [0.0] * 3)
            link.tensor = [[float(inertia.get("i" + "".join(sorted(a + b)))) for b in "xyz"] for a in "xyz"]
        return link

    @staticmethod
    def joint_of(dice, names, element, parent, child):
        joint = Joint(dice, names[element.get("name")], parent, child, element.get("type"))
        origin, limit, mimic = (element.find(tag) for tag in ("origin", "limit", "mimic"))
        joint.place, joint.turn = numbers_of(origin, "xyz", [0.0] * 3), numbers_of(origin, "rpy", [0.0] * 3)
        joint.axis = unit(numbers_of(element.find("axis"), "xyz", [1.0, 0.0, 0.0])) if joint.kind != "fixed" else [1, 0, 0]
        if limit is not None and joint.kind in ("revolute", "prismatic"):
            joint.lower, joint.upper = float(limit.get("lower", 0)), float(limit.get("upper", 0))
        if mimic is not None:
            joint.leader = (names[mimic.get("joint")], float(mimic.get("multiplier", 1)))
            joint.lower, joint.upper = -9.0, 9.0
        return joint


class Entity:
    def __init__(self, dice, name, robot, others):
        self.name, self.robot = name, robot
        self.start = robot.bent if dice.random() < 0.4 else {}
        numbers = [dice.gauss(0, 1) for _ in range(4)]
        length = math.sqrt(sum(number * number for number in numbers))
        self.turn, self.place = [number / length for number in numbers], vector(dice, 5)
        self.own = product(translation(*self.place), quaternion(*self.turn))
        self.anchor = dice.choice(["none", "world", "parent"] if others else ["none", "world"])
        self.parent = None  # an entity and one of its links
        if self.anchor == "parent":
            other = dice.choice(others)
            self.parent = (other, dice.choice(other.robot.links).name)

    def yaml(self):
        entity = {"name": self.name, "file": f"{self.robot.name}.smurf", "position": self.place,
                  "rotation": dict(zip("wxyz", self.turn))}
        if self.anchor != "none":
            entity["anchor"] = self.anchor
        if self.parent:
            entity["parent"] = f"{self.parent[0].name}::{self.parent[1]}"
        if self.start:
            entity["pose"] = "bent"
        return entity


def world_poses(entities, positions_of):
    found = {}
    for entity in entities:
        base = product(found[f"{entity.parent[0].name}/{entity.parent[1]}"], entity.own) if entity.parent else entity.own
        for link, pose in entity.robot.poses(positions_of(entity)).items():
            found[f"{entity.name}/{link}"] = product(base, pose)
    return found


def truth_of(entities, dice):
    """With every joint at its start, and with one joint of each robot (and its followers) moved."""
    driven = {}
    for entity in entities:
        moved = dice.choice(sorted(entity.robot.free)) if entity.robot.free else None
        driven[entity.name] = {**entity.start, **({moved: entity.robot.free[moved]} if moved else {})}
    joints = {f"{entity.name}/{joint.name}": (entity, joint) for entity in entities for joint in entity.robot.joints
              if joint.kind != "fixed"}
    return {
        "links": world_poses(entities, lambda entity: entity.start),
        "driven": world_poses(entities, lambda entity: driven[entity.name]),
        "bodies": {f"{entity.name}/{link.name}": link.body() for entity in entities for link in entity.robot.links},
        "starts": {name: entity.robot.position(joint, entity.start) for name, (entity, joint) in joints.items()},
        "drive": {name: entity.robot.position(joint, driven[entity.name]) for name, (entity, joint) in joints.items()},
        # A follower that turns without end may have the limits that follow from its leader.
        "limits": {name: None if joint.kind == "continuous" else [joint.lower, joint.upper]
                   for name, (_, joint) in joints.items() if joint.kind != "continuous" or not joint.leader},
        "damping": {name: joint.damping for name, (_, joint) in joints.items()},
        # With the damping of the joint, which the drives of USD have as well.
        "drives": {name: [stiffness, damping + joint.damping, effort] for name, (entity, joint) in joints.items()
                   if joint.name in entity.robot.motors
                   for stiffness, damping, effort in [entity.robot.motors[joint.name].drive()]},
    }


def write_scene(folder, dice, path=None):
    """The path of the scene; `truth.json` beside it is what truth_of() returns. `path` is a URDF for all its robots."""
    folder.mkdir(parents=True)
    robots = [RealRobot(dice, f"r{i}", path) if path else Robot(dice, f"r{i}") for i in range(1 if path else dice.randint(1, 3))]
    entities = []
    for i in range(dice.randint(1, 2 if path else 4)):  # PyBullet has no more than 128 joints
        entities.append(Entity(dice, f"e{i}", dice.choice(robots), entities[:]))
    files = {name: text for robot in robots for name, text in robot.files().items()}
    files["scene.smurfs"] = json.dumps({"entities": [entity.yaml() for entity in entities]})
    files["truth.json"] = json.dumps(truth_of(entities, dice))
    for name, text in files.items():
        (folder / name).write_text(text)
    return folder / "scene.smurfs"
