# SPDX-License-Identifier: BSD-3-Clause
"""URDFs as three physics engines know them alike: masses, joints without limits, damping and
friction, and shapes that need no file."""
import collections
import copy
import math
import xml.etree.ElementTree as ElementTree

FREE = ("revolute", "continuous", "prismatic")
RADIUS = 0.05   # m; of the ball in place of a mesh, which the files do not come with
DENSITY = 1000  # kg/m^3; of the balls whose masses replace impossible ones
DEPTH = 100     # m; of the ground


class Unfit(Exception):
    """The reason why a file is not a robot that all three engines can move."""


def joints_of(robot):
    return [(j.find("parent").get("link"), j.find("child").get("link"), j) for j in robot.findall("joint")]


def root_of(robot):
    """The name of the one root."""
    names = [link.get("name") for link in robot.findall("link")]
    try:
        children = {child for _, child, _ in joints_of(robot)}
    except AttributeError:
        raise Unfit("has a joint without parent or child") from None
    roots = [name for name in names if name not in children]
    if len(roots) != 1 or len(set(names)) != len(names) or len(names) != len(robot.findall("joint")) + 1:
        raise Unfit("is no tree")
    return roots[0]


def read(path):
    """The robot without elements that only some engines support."""
    try:
        robot = ElementTree.parse(path).getroot()
    except ElementTree.ParseError:
        raise Unfit("is no XML") from None
    if robot.tag != "robot":
        raise Unfit("is no robot")
    root_of(robot)
    rename_world(robot)
    for element in list(robot):
        if element.tag not in ("link", "joint"):
            robot.remove(element)
    for link in robot.findall("link"):
        reduce_link(link)
    for joint in robot.findall("joint"):
        if joint.get("type") not in (*FREE, "fixed"):
            raise Unfit("has a joint of several freedoms")
        reduce_joint(joint)
    return robot


def rename_world(robot):
    """MuJoCo treats a link of that name as the world, which cannot fall."""
    for element in robot.iter():
        for key in ("name", "link"):
            if element.tag in ("link", "parent", "child") and element.get(key) == "world":
                element.set(key, "smurf_world")


def reduce_link(link):
    for element in list(link):
        shapes = [] if element.tag != "collision" else element.findall("geometry/*")
        if shapes and shapes[0].tag == "mesh":
            element.find("geometry").clear()
            ElementTree.SubElement(element.find("geometry"), "sphere", radius=str(RADIUS))
        elif element.tag != "inertial" and not (shapes and shapes[0].tag in ("box", "sphere", "cylinder")):
            link.remove(element)
    for collision in link.findall("collision"):
        collision.attrib.clear()
        for element in collision:
            if element.tag not in ("origin", "geometry"):
                collision.remove(element)


def reduce_joint(joint):
    for element in [e for e in joint if e.tag not in ("origin", "parent", "child", "axis")]:
        joint.remove(element)
    if joint.get("type") == "revolute":
        joint.set("type", "continuous")
    if joint.get("type") == "prismatic":
        ElementTree.SubElement(joint, "limit", lower="-1000", upper="1000", effort="0", velocity="0")


def moves(robot):
    return any(joint.get("type") in FREE for joint in robot.findall("joint"))


def mass_of(robot):
    return sum(float(mass.get("value")) for mass in robot.iter("mass"))


def has_possible_inertia(inertial):
    """Uses the leading minors of the inertia, and of the tensor for the triangle inequality."""
    try:
        mass = float(inertial.find("mass").get("value"))
        xx, xy, xz, yy, yz, zz = (float(inertial.find("inertia").get(k))
                                  for k in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"))
    except (AttributeError, TypeError, ValueError):
        return False

    def is_positive(a, b, c):
        return a > 0 and a * b - xy * xy > 0 and (
            a * (b * c - yz * yz) - xy * (xy * c - yz * xz) + xz * (xy * yz - b * xz) > 0)

    half = (xx + yy + zz) / 2
    xy, xz, yz = -xy, -xz, -yz  # half the trace minus the inertia is the second moment of mass
    return mass > 0 and is_positive(half - xx, half - yy, half - zz)


def put_ball(link, mass):
    """The mass of a ball of water that replaces the link's own inertial; 1 kg if there is none."""
    origin = link.find("inertial/origin")
    for inertial in link.findall("inertial"):
        link.remove(inertial)
    inertial = ElementTree.SubElement(link, "inertial")
    if origin is not None:
        inertial.append(origin)
    moment = 0.4 * mass * (3 * mass / (4 * math.pi * DENSITY)) ** (2 / 3)
    ElementTree.SubElement(inertial, "mass", value=repr(mass))
    ElementTree.SubElement(inertial, "inertia", ixx=repr(moment), iyy=repr(moment), izz=repr(moment),
                           ixy="0", ixz="0", iyz="0")


def repaired(robot):
    """Replaces impossible masses by masses that every engine accepts."""
    robot = copy.deepcopy(robot)
    links = {link.get("name"): link for link in robot.findall("link")}
    body_of = {root_of(robot): root_of(robot)}
    left = collections.deque(joints_of(robot))
    while left:  # a tree: every joint's parent is reached
        parent, child, joint = left.popleft()
        if parent not in body_of:
            left.append((parent, child, joint))
            continue
        body_of[child] = body_of[parent] if joint.get("type") == "fixed" else child
    heavy = set()
    for name, link in links.items():
        mass = link.find("inertial/mass")
        value = 0.0 if mass is None else float(mass.get("value"))
        if value <= 0:
            for inertial in link.findall("inertial"):
                link.remove(inertial)
            continue
        heavy.add(body_of[name])
        if not has_possible_inertia(link.find("inertial")):
            put_ball(link, value)
    for name in set(body_of.values()) - heavy:
        put_ball(links[name], 1.0)
    return robot


def for_mujoco(robot, falls, ground=None):
    """MuJoCo holds every root: what falls has a floating joint above it. Shapes are in the way
    of what hangs, and their volumes must not become masses."""
    robot = copy.deepcopy(robot)
    extension = ElementTree.SubElement(robot, "mujoco")
    ElementTree.SubElement(extension, "compiler", inertiafromgeom="false")
    if not falls:
        return robot
    root = root_of(robot)
    nowhere = ElementTree.SubElement(robot, "link", name="smurf_nowhere")
    if ground is not None:
        collision = ElementTree.SubElement(nowhere, "collision")
        ElementTree.SubElement(collision, "origin", xyz=f"0 0 {ground - DEPTH / 2!r}")
        geometry = ElementTree.SubElement(collision, "geometry")
        ElementTree.SubElement(geometry, "box", size=f"{DEPTH} {DEPTH} {DEPTH}")
    joint = ElementTree.SubElement(robot, "joint", name="fall", type="floating")
    ElementTree.SubElement(joint, "parent", link="smurf_nowhere")
    ElementTree.SubElement(joint, "child", link=root)
    return robot
