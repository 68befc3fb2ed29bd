#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Thousands of robots with one damage each, always the same ones.

usage: damage.py FOLDER    writes them and their meshes, FOLDER/NAME.urdf

The name of a case says where and how the robot of robot.py is damaged: `joint.shoulder.limit@effort:word`.
`=` stands for a change that leaves a good robot, which is then damaged further: `link.arm.visual=box`.
"""
import pathlib
import re
import sys
from dataclasses import dataclass

import files
import robot as robots
import values
from robot import Element

# Everything here is damaged in every way; similar parts elsewhere get a selection of the damages.
THOROUGH = {"link.arm", "joint.shoulder", "material.red"}
DRAKE_ROBOT = pathlib.Path(__file__).resolve().parent.parent.parent / "build/fixtures/rules/SML1450-drake-element/good/robot.urdf"
LIKE_OTHERS = {"link.slide", "link.wheel", "link.finger", "joint.knuckle", "material.grey"}
SHAPES = {
    "box": [Element("box", [("size", "0.2 0.3 0.6")])],
    "cylinder": [Element("cylinder", [("radius", "0.15"), ("length", "0.3")])],
    "sphere": [Element("sphere", [("radius", "0.2")])],
    "mesh": [Element("mesh", [("filename", "cube.stl"), ("scale", "0.2 0.3 0.6")])],
    "plain-mesh": [Element("mesh", [("filename", "cube.stl")])],
}


@dataclass
class Case:
    name: str
    text: bytes
    twin: str = "robot"     # the case without this damage
    is_same: bool = False   # nothing but the twin can be meant


class Cases:
    def __init__(self):
        self.by_name = {}

    def add(self, name, robot, twin="robot", is_same=False):
        text = robot if isinstance(robot, bytes) else robots.document(robot).encode()
        assert name not in self.by_name, name
        self.by_name[name] = Case(name, text, twin, is_same)


def labelled(element, label):
    """All elements below, each with its label and its parent."""
    counts = {}
    for child in element.children:
        name = child.get("name") or child.get("reference")
        step = f"{child.tag}.{name}" if label == "robot" else f"{label}.{child.tag}"
        counts[step] = counts.get(step, 0) + 1
        if counts[step] > 1:
            step += str(counts[step])
        yield step, child, element
        yield from labelled(child, step)


def find(robot, label):
    if label == "robot":
        return robot, None
    return next((child, above) for found, child, above in labelled(robot, label="robot") if found == label)


def names_of(robot):
    return {tag: [one.get("name") for one in robot.all(tag)][:4] for tag in ("link", "joint")}


def damage_attribute(cases, base, twin, label, attribute, is_thorough):
    element, _ = find(base, label)
    value = element.get(attribute)

    def add(kind, change, is_same):
        changed = base.copy()
        change(find(changed, label)[0])
        cases.add(f"{label}@{attribute}:{kind}" if twin == "robot" else f"{twin}/{label}@{attribute}:{kind}",
                  changed, twin, is_same)

    def rename(name):
        return lambda found: [one.__setitem__(0, name) for one in found.attributes if one[0] == attribute]

    add("dropped", lambda found: found.drop(attribute), False)
    for kind, (text, is_same) in values.kinds_of(element, attribute, value, names_of(base)).items():
        if is_thorough or kind in values.CORE or attribute in ("type", "link", "joint", "reference", "filename"):
            add(kind, lambda found, text=text: found.set(attribute, text), is_same)
    if is_thorough:
        add("misspelt", rename(attribute[:-2] + attribute[:-3:-1] if len(attribute) > 2 else attribute + "x"), True)
        add("cased", rename(attribute.capitalize()), True)
        add("prefixed", lambda found: (rename("foreign:" + attribute)(found),
                                       found.set("xmlns:foreign", "urn:foreign")), False)
        add("doubled", lambda found: found.attributes.append([attribute, value]), True)
        add("as-element", lambda found: (found.drop(attribute), found.children.append(
            Element(attribute, text=value))), True)


def is_single(base, label):
    """Whether a second one is a mistake; a link may have many visuals and collisions."""
    return find(base, label)[0].tag not in ("visual", "collision")


def damage_element(cases, base, twin, label, is_thorough):
    def add(kind, change, is_same):
        changed = base.copy()
        change(*find(changed, label))
        cases.add(f"{label}:{kind}" if twin == "robot" else f"{twin}/{label}:{kind}", changed, twin, is_same)

    def misspell(found, _):
        found.tag = found.tag[:-2] + found.tag[:-3:-1]

    def insert(*new):
        return lambda found, _: found.children.__setitem__(slice(0, 0), new)

    def insert_last(*new):
        return lambda found, _: found.children.extend(new)

    def twice(change):
        def apply(found, above):
            second = found.copy()
            change(second)
            above.children.insert(above.children.index(found) + 1, second)
        return apply

    def other_numbers(found):
        for one in [found, *(child for _, child, _ in labelled(found, "x"))]:
            for attribute in one.attributes:
                if attribute[0] not in values.NAMES | {"type", "filename"}:
                    attribute[1] = " ".join("0.7" if part.replace(".", "").replace("-", "").isdigit() else part
                                            for part in attribute[1].split())

    add("dropped", lambda found, above: above.children.remove(found), False)
    add("doubled", twice(lambda second: None), is_single(base, label))
    add("misspelt", misspell, True)
    add("cased", lambda found, _: setattr(found, "tag", found.tag.capitalize()), True)
    add("emptied", lambda found, _: (found.attributes.clear(), found.children.clear(), setattr(found, "text", "")),
        False)
    add("foreign-child", insert(Element("foreign", [("a", "1")])), True)
    if not is_thorough:
        return
    add("doubled-otherwise", twice(other_numbers), False)
    add("shouted", lambda found, _: setattr(found, "tag", found.tag.upper()), True)
    add("prefixed", lambda found, _: (setattr(found, "tag", "foreign:" + found.tag),
                                      found.set("xmlns:foreign", "urn:foreign")), False)
    add("childless", lambda found, _: (found.children.clear(), setattr(found, "text", "")), False)
    add("foreign-attribute", lambda found, _: found.set("foreign", "1"), True)
    add("foreign-prefixed-child", insert(Element("drake:thing", [("xmlns:drake", "http://drake.mit.edu")])), True)
    add("foreign-last-child", insert_last(Element("foreign", text="foo")), True)
    add("xacro-child", insert(Element("xacro:thing", [("xmlns:xacro", "http://www.ros.org/wiki/xacro")])), True)
    add("text", lambda found, _: setattr(found, "text", "foo"), True)
    add("nested", lambda found, above: above.children.__setitem__(
        above.children.index(found), Element("group", children=[found])), True)


def damage_everything(cases, base):
    for label, element, _ in list(labelled(base, "robot")):
        top = ".".join(label.split(".")[:2])
        if top in LIKE_OTHERS and element.tag not in ("link", "joint", "mimic"):
            continue
        is_thorough = top in THOROUGH
        damage_element(cases, base, "robot", label, is_thorough)
        for attribute, _ in element.attributes:
            damage_attribute(cases, base, "robot", label, attribute, is_thorough)
        if element.text:
            for kind, (text, _) in values.number_kinds("0.5").items():
                if kind in ("word", "comma", "nan", "negative", "zero", "empty", "trailing", "many"):
                    changed = base.copy()
                    find(changed, label)[0].text = text
                    cases.add(f"{label}.text:{kind}", changed, "robot", False)
    for attribute, _ in base.attributes:
        damage_attribute(cases, base, "robot", "robot", attribute, True)
    add_robot_damages(cases, base)


def add_robot_damages(cases, base):
    for kind, tag in (("misspelt", "robbot"), ("cased", "Robot"), ("shouted", "ROBOT"), ("sdf", "sdf")):
        changed = base.copy()
        changed.tag = tag
        cases.add(f"robot:{kind}", changed, "robot", True)
    for kind, changed in (("emptied", Element("robot")), ("childless", Element("robot", base.attributes))):
        cases.add(f"robot:{kind}", changed)


def damage_shapes(cases, base):
    """Every shape in every place: as visual or collision of a fixed, a moving, or an attached link."""
    for link in ("base", "plate", "arm", "tool"):
        for tag in ("visual", "collision"):
            for shape, elements in SHAPES.items():
                twin = f"link.{link}.{tag}={shape}"
                robot = base.copy()
                robot.first(f"link:{link}", tag, "geometry").children = [one.copy() for one in elements]
                cases.add(twin, robot, twin, True)
                label = f"link.{link}.{tag}.geometry.{elements[0].tag}"
                for attribute, _ in elements[0].attributes:
                    if shape != "mesh" or attribute == "scale" or link != "base":
                        damage_attribute(cases, robot, twin, label, attribute, link == "arm")
                if link in ("base", "arm"):
                    damage_element(cases, robot, twin, label, True)


def damage_typed_joints(cases, base):
    """The parts of a joint, in joints of every type, at the root, below it and at a fixed joint."""
    for joint in ("shoulder", "rail", "tool_bolt"):
        for kind in values.JOINT_TYPES[:7]:
            robot = base.copy()
            found = robot.first(f"joint:{joint}")
            found.set("type", kind)
            if joint == "tool_bolt":
                found.children += [Element("axis", [("xyz", "0 0 1")]), Element("limit", [
                    ("lower", "-1"), ("upper", "1"), ("effort", "2"), ("velocity", "3")]),
                                   Element("dynamics", [("damping", "1"), ("friction", "1")])]
            twin = f"joint.{joint}={kind}"
            cases.add(twin, robot, twin, True)
            for part in ("axis", "limit", "dynamics", "mimic"):
                damage_typed_part(cases, robot, twin, joint, part)


def damage_typed_part(cases, robot, twin, joint, part):
    label = f"joint.{joint}.{part}"
    if part == "mimic":
        changed = robot.copy()
        changed.first(f"joint:{joint}").children.append(Element("mimic", [("joint", "axle")]))
        cases.add(f"{twin}/{label}:added", changed, twin)
        return
    for kind in ("dropped", "emptied", "doubled"):
        changed = robot.copy()
        found, above = find(changed, label)
        if kind == "dropped":
            above.children.remove(found)
        elif kind == "doubled":
            above.children.append(found.copy())
        else:
            found.attributes.clear()
        cases.add(f"{twin}/{label}:{kind}", changed, twin, kind == "doubled")
    element, _ = find(robot, label)
    for attribute, value in element.attributes:
        kinds = values.kinds_of(element, attribute, value, {})
        for kind in ("dropped", "word", "nan", "negative", "zero", "noise", "trailing"):
            if kind != "dropped" and kind not in kinds:
                continue
            changed = robot.copy()
            found, _ = find(changed, label)
            if kind == "dropped":
                found.drop(attribute)
            else:
                found.set(attribute, kinds[kind][0])
            cases.add(f"{twin}/{label}@{attribute}:{kind}", changed, twin,
                      kind != "dropped" and kinds[kind][1])


def drake_cases():
    """A robot with the elements that only Drake reads, and its damages."""
    cases = Cases()
    base = robots.parse(DRAKE_ROBOT.read_text("utf-8"))
    cases.add("robot", base, "robot", True)
    for label, element, _ in list(labelled(base, "robot")):
        if "drake:distance_constraint" in label:
            continue  # Drake 1.51 does not read it
        if "drake:" not in label and not label.startswith(("robot.frame", "frame.", "transmission.")):
            continue
        damage_element(cases, base, "robot", label, False)
        for attribute, _ in element.attributes:
            damage_attribute(cases, base, "robot", label, attribute, False)
    for part in ("link.upper_arm", "joint.shoulder", "joint.hook"):
        changed = base.copy()
        find(changed, part)[0].set("drake_ignore", "true")
        cases.add(f"{part}@drake_ignore:added", changed)
    for kind, element in (("loop", Element("loop_joint", [("name", "loop"), ("type", "revolute")], [
            Element("link1", [("link", "cord")]), Element("link2", [("link", "bulb")])])),
                          ("foreign", Element("drake:foreign"))):
        changed = base.copy()
        changed.children.append(element)
        cases.add(f"robot:{kind}", changed)
    return cases.by_name


def all_cases():
    """{name: Case}, the undamaged robot first."""
    cases = Cases()
    base = robots.parse(robots.TEXT)
    cases.add("robot", base, "robot", True)
    damage_everything(cases, base)
    damage_shapes(cases, base)
    damage_typed_joints(cases, base)
    files.damage_bodies(cases, base)
    files.damage_trees(cases, base)
    files.damage_files(cases, base)
    return cases.by_name


def write(cases, folder, text_of=lambda text: text):
    """{name: path}"""
    folder.mkdir(parents=True, exist_ok=True)
    for name, content in robots.meshes().items():
        (folder / name).write_bytes(content)
    # Readers that treat paths as URIs fail at some of the characters of the names.
    paths = {name: folder / f"{number:04}_{re.sub(r'[^A-Za-z0-9.@=-]', '_', name)[:200]}.urdf"
             for number, name in enumerate(cases)}
    for name, path in paths.items():
        path.write_bytes(text_of(cases[name].text))
    return paths


if __name__ == "__main__":
    print(len(write(all_cases(), pathlib.Path(sys.argv[1]))))
