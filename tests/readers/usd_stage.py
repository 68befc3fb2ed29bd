# SPDX-License-Identifier: BSD-3-Clause
"""A small reader of OpenUSD text, and checks of a stage with robots.

It knows the lines that smurfs-flatten writes, and computes all frames itself: from the poses of the
prims, and from the URDF.
"""
import json
import math
import pathlib
import re
import xml.etree.ElementTree as ElementTree

import frames

PRIM = re.compile(r'(?:def (\w+)|(class)) "(\w+)"( \()?$')
JOINTS = {"fixed": "PhysicsFixedJoint", "revolute": "PhysicsRevoluteJoint",
          "continuous": "PhysicsRevoluteJoint", "prismatic": "PhysicsPrismaticJoint",
          "planar": "PhysicsJoint", "floating": "PhysicsJoint"}
LEAST = 1e-14  # of a moment of inertia and a mass


class Stage:
    """`prims`: path -> type, apiSchemas, references, and attributes by name, as text."""

    def __init__(self, text):
        lines = [line.strip() for line in text.splitlines()]
        assert lines[0] == "#usda 1.0", lines[0]
        end = lines.index(")")
        self.metadata = dict(line.split(" = ", 1) for line in lines[2:end])
        self.prims, path, is_head = {}, [], False
        for line in lines[end + 1:]:
            if match := PRIM.match(line):
                assert not is_head
                path.append(match[3])
                assert "/".join(path) not in self.prims, path
                prim = self.prims["/".join(path)] = {"type": match[1] or match[2],
                                                     "apiSchemas": [], "references": None}
                is_head = match[4] is not None
            elif line == ")":
                is_head = False
            elif line == "}":
                path.pop()
            elif line and line != "{":
                name, value = line.split(" = ", 1)
                name = name.split()[-1]
                assert name not in prim or is_head, line
                if name == "apiSchemas":
                    value = json.loads(value)
                elif value.startswith("<"):
                    value = value[2:-1]
                prim[name] = value
        assert not path and not is_head, path

    def numbers(self, path, name):
        return [float(n) for n in self.prims[path][name].strip("()").split(", ")]

    def pose(self, path):
        """The pose in the world, including all parent prims."""
        prim = self.prims[path]
        above = self.pose(path.rsplit("/", 1)[0]) if "/" in path else ([0, 0, 0], [1, 0, 0, 0])
        if "xformOpOrder" not in prim:
            return above
        assert prim["xformOpOrder"].startswith('["xformOp:translate", "xformOp:orient"'), prim
        return frames.compose(above, (self.numbers(path, "xformOp:translate"),
                                      self.numbers(path, "xformOp:orient")))

    def having(self, schema):
        return [path for path, prim in self.prims.items() if schema in prim["apiSchemas"]]

    def links(self):
        """(path of the entity, name of the link) -> path of the prim."""
        links, entity = {}, ""
        for path, prim in self.prims.items():
            if "smurf:path" in prim:
                entity = json.loads(prim["smurf:path"])
            elif "smurf:link" in prim:
                links[entity, json.loads(prim["smurf:link"])] = path
        return links

    def joint_frames(self, path):
        """The frames of the joint in both bodies, as poses in the world."""
        prim, found = self.prims[path], []
        for end in "01":
            body = prim.get("physics:body" + end)
            local = (self.numbers(path, "physics:localPos" + end),
                     self.numbers(path, "physics:localRot" + end))
            found.append(local if body is None else frames.compose(self.pose(body), local))
        return found


def triple(element, name, default="0 0 0"):
    text = default if element is None else element.get(name, default)
    return [float(n) for n in text.split()]


def origin(element):
    found = element.find("origin")
    return triple(found, "xyz"), frames.from_rpy(*triple(found, "rpy"))


def mass_of(link):
    mass = link.find("inertial/mass")
    return 0 if mass is None else float(mass.get("value", 0))


def parsed(file):
    """The root of a URDF; it may begin with blanks, which strict readers refuse."""
    return ElementTree.fromstring(pathlib.Path(file).read_bytes().lstrip())


class Robot:
    def __init__(self, file):
        root = parsed(file)
        for element in root.iter():
            if isinstance(element.tag, str):
                element.tag = element.tag.rpartition("}")[2]  # without its name space
        self.links = {link.get("name"): link for link in root.findall("link")}
        self.joints = {joint.get("name"): joint for joint in root.findall("joint")}

    def is_frame(self, joint):
        return joint.get("type") == "fixed" and \
            mass_of(self.links[joint.find("child").get("link")]) <= 0

    def position(self, joint, given):
        mimic = joint.find("mimic")
        if mimic is None or mimic.get("joint") not in self.joints:
            return given.get(joint.get("name"), 0)
        leader = self.position(self.joints[mimic.get("joint")], given)
        return float(mimic.get("multiplier", 1)) * leader + float(mimic.get("offset", 0))


def differences(stage, flat, robot_of, tolerance=1e-9):
    """The differences from the URDFs; `robot_of` returns the robot of an instance of the flat JSON."""
    problems = structure(stage)
    links = stage.links()
    for instance in flat["instances"]:
        if "links" not in instance:
            continue
        robot, name = robot_of(instance), instance["path"]
        prims = {link: links.get((name, link)) for link in instance["links"]}
        if None in prims.values():
            problems.append(f"{name} has not all links")
            continue
        for link, pose in instance["links"].items():
            expected = pose["position"], [pose["orientation"][c] for c in "wxyz"]
            if frames.apart(stage.pose(prims[link]), expected) > tolerance:
                problems.append(f"{name}::{link} is somewhere else")
        problems += [f"{name}: {problem}" for problem in
                     joint_problems(stage, instance, robot, prims, tolerance)]
        problems += [f"{name}::{link}: {problem}" for link, prim in prims.items()
                     for problem in mass_problems(stage.prims[prim], stage, prim,
                                                  robot.links[link], tolerance)]
    return problems


def structure(stage):
    """The requirements of UsdPhysics that the stage breaks."""
    problems = []
    units = {"kilogramsPerUnit": "1", "metersPerUnit": "1", "upAxis": '"Z"'}
    if {key: stage.metadata.get(key) for key in units} != units:
        problems.append("units")
    bodies = set(stage.having("PhysicsRigidBodyAPI"))
    for body in bodies:
        above = body.split("/")[:-1]
        if any("/".join(above[:i]) in bodies for i in range(1, len(above) + 1)):
            problems.append(f"{body} is in another body")
    if sorted(bodies) != sorted(stage.having("PhysicsMassAPI")):
        problems.append("a body has no mass")
    for root in stage.having("PhysicsArticulationRootAPI"):
        joints = [p for p, prim in stage.prims.items()
                  if p.startswith(root + "/") and prim["type"].startswith("Physics")]
        if not joints:
            problems.append(f"{root} is an articulation without joints")
    for path, prim in stage.prims.items():
        if prim["type"] not in JOINTS.values():
            continue
        ends = [prim.get("physics:body0"), prim.get("physics:body1")]
        if ends[1] is None or any(end is not None and end not in bodies for end in ends):
            problems.append(f"{path} is not between bodies")
        if any(abs(math.hypot(*stage.numbers(path, "physics:localRot" + e)) - 1) > 1e-9
               for e in "01"):
            problems.append(f"{path} has a rotation that is none")
    for path in stage.having("MaterialBindingAPI"):
        target = stage.prims.get(stage.prims[path]["material:binding:physics"])
        if target is None or "PhysicsMaterialAPI" not in target["apiSchemas"]:
            problems.append(f"{path} has no material")
    return problems


def joint_problems(stage, instance, robot, prims, tolerance):
    written = {}
    top = next(iter(prims.values())).rsplit("/", 1)[0] if prims else ""
    for path, prim in stage.prims.items():
        if "smurf:joint" in prim and path.startswith("/".join(top.split("/")[:2]) + "/"):
            written[json.loads(prim["smurf:joint"])] = path
    for name, joint in robot.joints.items():
        child = joint.find("child").get("link")
        if child not in prims:
            continue
        body0 = prims[joint.find("parent").get("link")]
        if "PhysicsRigidBodyAPI" not in stage.prims[body0]["apiSchemas"]:
            body0 = body0.rsplit("/", 1)[0]  # the body of a frame
        if robot.is_frame(joint):
            if prims[child].rsplit("/", 1)[0] != body0:
                yield f"{child} is not in its body"
            continue
        if name not in written:
            yield f"{name} is missing"
            continue
        path = written[name]
        prim = stage.prims[path]
        if prim["type"] != JOINTS[joint.get("type")]:
            yield f"{name} is a {prim['type']}"
        if (prim["physics:body0"], prim["physics:body1"]) != (body0, prims[child]):
            yield f"{name} is between {prim['physics:body0']} and {prim['physics:body1']}"
        at = robot.position(joint, instance["joint_positions"])
        yield from motion_problems(stage, path, joint, at, tolerance)
        yield from limit_problems(prim, joint, tolerance)


def motion_problems(stage, path, joint, position, tolerance):
    """The second frame is the first, moved along or about its x by the position of the joint."""
    zero, now = stage.joint_frames(path)
    kind = joint.get("type")
    half = position / 2
    moved = {"prismatic": ([position, 0, 0], [1, 0, 0, 0])}.get(
        kind, ([0, 0, 0], [math.cos(half), math.sin(half), 0, 0]))
    if kind in ("fixed", "planar", "floating"):
        moved = [0, 0, 0], [1, 0, 0, 0]
    gap = frames.apart(frames.compose(zero, moved), now)
    if gap > tolerance:
        yield f"{path}: its frames are {gap} from each other"
    if kind in ("fixed", "floating"):
        return
    axis = triple(joint.find("axis"), "xyz", "1 0 0")
    length = math.hypot(*axis) or 1
    found = frames.rotate(stage.numbers(path, "physics:localRot1"), [1, 0, 0])
    if math.dist(found, [c / length for c in axis]) > tolerance:
        yield f"{path}: its axis is {found}"


def limit_problems(prim, joint, tolerance):
    name, kind = joint.get("name"), joint.get("type")
    limit = joint.find("limit")
    unit = 1 if kind == "prismatic" else 180 / math.pi
    is_range = kind != "continuous" and limit is not None and \
        float(limit.get("lower", 0)) <= float(limit.get("upper", 0))
    if kind == "planar":
        locked = sorted(schema.split(":")[1] for schema in prim["apiSchemas"])
        if locked != ["rotY", "rotZ", "transX"]:
            yield f"{name} has the limits {locked}"
        for axis in locked:
            if float(prim[f"limit:{axis}:physics:low"]) <= float(prim[f"limit:{axis}:physics:high"]):
                yield f"{name} is not locked in {axis}"
    if kind not in ("revolute", "prismatic", "continuous"):
        return
    drive = "linear" if kind == "prismatic" else "angular"
    for key, text, factor, is_there in (
            ("physics:lowerLimit", "lower", unit, is_range),
            ("physics:upperLimit", "upper", unit, is_range),
            ("physxJoint:maxJointVelocity", "velocity", unit, True),
            (f"drive:{drive}:physics:maxForce", "effort", 1, True)):
        expected = float(limit.get(text, 0)) * factor if limit is not None and is_there else None
        if expected is not None and text in ("velocity", "effort") and expected <= 0:
            expected = None
        found = float(prim[key]) if key in prim else None
        # Followers without limits have those that follow from their leader (conversions_test).
        if kind == "continuous" and text in ("lower", "upper") and joint.find("mimic") is not None:
            continue
        if (found is None) != (expected is None):
            yield f"{name}: {key} is {found} instead of {expected}"
        elif found is not None and abs(found - expected) > tolerance * max(1, abs(expected)):
            yield f"{name}: {key} is {found} instead of {expected}"


def is_definite(xx, yy, zz, xy, xz, yz):
    """Whether all moments of a tensor are positive, by Sylvester's criterion."""
    return (xx > 0 and xx * yy - xy * xy > 0
            and xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz) > 0)


def is_replaced(I, mass, greatest):
    """Whether the tensor is one that no body has, or the one of templates on something small, so that shapes give it."""
    diagonal, others = [I["ixx"], I["iyy"], I["izz"]], [I["ixy"], I["ixz"], I["iyz"]]
    if diagonal == [1, 1, 1] and others == [0, 0, 0]:
        return 10 * greatest < 1
    is_positive = is_definite(*(moment - 1e-14 for moment in diagonal), *others)
    is_small = is_definite(*(0.4e-6 * mass - moment for moment in diagonal), *(-moment for moment in others))
    return is_small or not is_positive


def mass_problems(prim, stage, path, link, tolerance):
    if "PhysicsMassAPI" not in prim["apiSchemas"]:
        return
    inertial, mass = link.find("inertial"), float(prim["physics:mass"])
    if mass_of(link) <= 0:
        if mass != 0.01:
            yield f"the mass is {mass}"
        return
    position, rotation = origin(inertial)
    moments = stage.numbers(path, "physics:diagonalInertia")
    if abs(mass - max(mass_of(link), LEAST)) > tolerance * mass:
        yield f"the mass is {mass}"
    if math.dist(stage.numbers(path, "physics:centerOfMass"), position) > tolerance:
        yield "the centre of mass is elsewhere"
    if min(moments) <= LEAST:
        return  # repaired, and reported
    written = inertial.find("inertia")
    if written is None:
        return  # that of the shapes
    I = {key: float(written.get(key, 0)) for key in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")}
    expected = frames.turned(rotation, [[I["ixx"], I["ixy"], I["ixz"]], [I["ixy"], I["iyy"], I["iyz"]],
                                        [I["ixz"], I["iyz"], I["izz"]]])
    found = frames.turned(stage.numbers(path, "physics:principalAxes"),
                          [[moments[0], 0, 0], [0, moments[1], 0], [0, 0, moments[2]]])
    gap = max(abs(a - b) for row, other in zip(expected, found) for a, b in zip(row, other))
    if gap > tolerance * max(moments) and not (min(moments) > LEAST and is_replaced(I, mass_of(link), max(moments))):
        yield f"the inertia is {found} instead of {expected}"
