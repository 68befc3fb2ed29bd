# SPDX-License-Identifier: BSD-3-Clause
"""Mass, centre of mass and inertia of a whole URDF with its joints at zero, computed without the
tested tools."""
import math
import xml.etree.ElementTree as ElementTree


def numbers(element, attribute, default):
    text = element.get(attribute) if element is not None else None
    return [float(word) for word in text.split()] if text else list(default)


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def transpose(a):
    return [list(column) for column in zip(*a)]


def turned(a, v):
    return [sum(a[i][k] * v[k] for k in range(3)) for i in range(3)]


def pose_of(element):
    """(position, rotation) of the <origin> of an element."""
    origin = element.find("origin")
    r, p, y = numbers(origin, "rpy", (0, 0, 0))
    cr, sr, cp, sp, cy, sy = (f(angle) for angle in (r, p, y) for f in (math.cos, math.sin))
    rotation = [[cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
                [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
                [-sp, cp * sr, cp * cr]]
    return numbers(origin, "xyz", (0, 0, 0)), rotation


def composed(outer, inner):
    position = [a + b for a, b in zip(outer[0], turned(outer[1], inner[0]))]
    return position, product(outer[1], inner[1])


def link_poses(robot):
    joints = {joint.find("child").get("link"): joint for joint in robot.findall("joint")}
    poses = {}

    def pose(link):
        if link not in poses:
            joint = joints.get(link)
            poses[link] = (([0, 0, 0], [[1, 0, 0], [0, 1, 0], [0, 0, 1]]) if joint is None else
                           composed(pose(joint.find("parent").get("link")), pose_of(joint)))
        return poses[link]

    return {link.get("name"): pose(link.get("name")) for link in robot.findall("link")}


def bodies(robot):
    """(mass, centre, inertia about it), in the frame of the root."""
    poses = link_poses(robot)
    for link in robot.findall("link"):
        inertial = link.find("inertial")
        if inertial is None:
            continue
        position, rotation = composed(poses[link.get("name")], pose_of(inertial))
        values = inertial.find("inertia")
        ixx, ixy, ixz, iyy, iyz, izz = (float(values.get(key, 0)) if values is not None else 0
                                        for key in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"))
        tensor = [[ixx, ixy, ixz], [ixy, iyy, iyz], [ixz, iyz, izz]]
        mass = inertial.find("mass")
        yield (float(mass.get("value")) if mass is not None else 0.0, position,
               product(product(rotation, tensor), transpose(rotation)))


def total(path):
    """(mass, centre, inertia about it)."""
    parts = list(bodies(ElementTree.parse(path).getroot()))
    mass = math.fsum(part[0] for part in parts)
    centre = [math.fsum(m * c[i] for m, c, _ in parts) / mass if mass else 0.0 for i in range(3)]
    inertia = [[0.0] * 3 for _ in range(3)]
    for m, c, tensor in parts:
        d = [a - b for a, b in zip(c, centre)]
        square = sum(a * a for a in d)
        for i in range(3):
            for j in range(3):
                inertia[i][j] += tensor[i][j] + m * ((square if i == j else 0) - d[i] * d[j])
    return mass, centre, inertia


def difference(one, other):
    """The largest relative difference of two robots; of centres in metres, below 1 m."""
    flat = lambda robot: sum(robot[2], [])  # noqa: E731
    norm = lambda values: math.sqrt(math.fsum(a * a for a in values))  # noqa: E731
    gap = [a - b for a, b in zip(flat(one), flat(other))]
    return max(abs(one[0] - other[0]) / (abs(one[0]) or 1),
               math.dist(one[1], other[1]) / max(1, norm(one[1])),
               norm(gap) / (norm(flat(one)) or 1))
