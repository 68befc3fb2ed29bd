#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""An SRDF and a robot with elements ros2_control, with one damage each, always the same ones.

usage: companion_damage.py FOLDER    writes them

The name of a case says where and how the text is damaged: `group:arm/chain@tip_link:empty`. Each place is damaged in these
ways: elements are dropped, doubled, misspelt, emptied and moved; attributes are dropped, misspelt and given other values; texts
are given other values.
"""
import copy
import pathlib
import sys
import xml.etree.ElementTree as tree

MASS = ('<inertial><mass value="0.5"/><inertia ixx="0.00013" ixy="0" ixz="0" iyy="0.00013" iyz="0" izz="0.00013"/></inertial>'
        '<collision><geometry><sphere radius="0.02"/></geometry></collision>')


def joint(name, kind, parent, child, more=""):
    limit = '<limit lower="-1" upper="1" effort="10" velocity="2"/>' if kind in ("revolute", "prismatic") else ""
    return (f'  <joint name="{name}" type="{kind}">\n    <parent link="{parent}"/><child link="{child}"/>'
            f'<origin xyz="0 0 0.3"/><axis xyz="0 1 0"/>{limit}{more}\n  </joint>\n')


LINKS = ("upper", "lower", "hand", "finger", "thumb", "eye")
ROBOT = ('<robot name="lamp">\n  <link name="base"/>\n' + "".join(f'  <link name="{name}">{MASS}</link>\n' for name in LINKS)
         + joint("shoulder", "revolute", "base", "upper") + joint("elbow", "revolute", "upper", "lower")
         + joint("wrist", "revolute", "lower", "hand") + joint("grip", "prismatic", "hand", "finger")
         + joint("squeeze", "prismatic", "hand", "thumb", '<mimic joint="grip"/>') + joint("mount", "fixed", "upper", "eye"))
SRDF = """<robot name="lamp">
  <group name="arm">
    <chain base_link="base" tip_link="hand"/>
  </group>
  <group name="gripper">
    <link name="finger"/>
    <joint name="squeeze"/>
  </group>
  <group name="all">
    <group name="arm"/>
    <group name="gripper"/>
  </group>
  <group_state name="up" group="arm">
    <joint name="shoulder" value="0.1"/>
    <joint name="elbow" value="0.2"/>
    <joint name="wrist" value="0.3"/>
  </group_state>
  <end_effector name="tool" group="gripper" parent_link="hand" parent_group="arm"/>
  <virtual_joint name="world_joint" type="fixed" parent_frame="world" child_link="base"/>
  <passive_joint name="squeeze"/>
  <joint_property joint_name="wrist" property_name="angular_distance_weight" value="0.5"/>
  <link_sphere_approximation link="upper">
    <sphere center="0 0 0.1" radius="0.05"/>
  </link_sphere_approximation>
  <disable_default_collisions link="eye"/>
  <enable_collisions link1="eye" link2="hand"/>
  <disable_collisions link1="base" link2="upper" reason="Adjacent"/>
  <disable_collisions link1="upper" link2="hand" reason="Never"/>
</robot>
"""
HARDWARE = """<robot>
  <ros2_control name="arm" type="system" rw_rate="100" is_async="true" thread_priority="40">
    <hardware>
      <plugin>lamp_hardware/Arm</plugin>
      <group>all</group>
      <param name="port">/dev/ttyUSB0</param>
    </hardware>
    <joint name="shoulder">
      <command_interface name="position">
        <param name="min">-0.9</param>
        <param name="max">0.9</param>
        <param name="initial_value">0.1</param>
      </command_interface>
      <state_interface name="position"/>
      <param name="id">1</param>
    </joint>
    <joint name="elbow">
      <command_interface name="velocity">
        <limits enable="false"/>
        <param name="max">1.5</param>
      </command_interface>
      <state_interface name="position"/>
      <state_interface name="velocity"/>
    </joint>
    <joint name="grip">
      <limits enable="true"/>
      <command_interface name="position"/>
      <state_interface name="position" data_type="double" size="1"/>
    </joint>
    <joint name="squeeze" mimic="true">
      <state_interface name="position"/>
    </joint>
    <sensor name="force">
      <state_interface name="force.x"/>
      <param name="frame_id">hand</param>
    </sensor>
    <gpio name="lights">
      <command_interface name="green" data_type="bool" size="2"/>
      <state_interface name="green" data_type="bool"/>
      <param name="bus">3</param>
    </gpio>
    <transmission name="belt">
      <plugin>transmission_interface/SimpleTransmission</plugin>
      <joint name="shoulder" role="joint1">
        <mechanical_reduction>50.0</mechanical_reduction>
        <offset>0.5</offset>
      </joint>
      <actuator name="motor" role="actuator1"/>
      <param name="backlash">0.1</param>
    </transmission>
  </ros2_control>
  <ros2_control name="wrist" type="actuator">
    <hardware>
      <plugin>lamp_hardware/Wrist</plugin>
    </hardware>
    <joint name="wrist">
      <command_interface name="effort"/>
      <state_interface name="effort"/>
    </joint>
  </ros2_control>
</robot>
"""
# Humble refuses `properties`.
ASYNC = """<robot>
  <ros2_control name="wrist" type="actuator">
    <hardware>
      <plugin>lamp_hardware/Wrist</plugin>
    </hardware>
    <properties>
      <async affinity="[1, 2]" scheduling_policy="synchronized" thread_priority="30" print_warnings="true"/>
    </properties>
    <joint name="wrist">
      <command_interface name="effort"/>
    </joint>
  </ros2_control>
</robot>
"""
VALUES = {"empty": "", "blank": " ", "word": "nobody", "comma": "0,5", "unit": "0.5 m", "negative": "-1", "zero": "0", "nan": "nan",
          "infinite": "inf", "huge": "1e400", "two": "0.1 0.2", "one": "1", "yes": "yes", "true": "True", "false": "FALSE",
          "hexadecimal": "0x10", "fraction": "2.5", "plus": "+1", "placeholder": "${x}"}


def swapped(name):
    """A misspelling: the last two letters in the other order, or the last one twice."""
    if len(name) < 2:
        return name + name
    other = name[:-2] + name[-1] + name[-2]
    return other if other != name else name + name[-1]


def label(element):
    return f"{element.tag}:{element.get('name')}" if element.get("name") else element.tag


def paths(root):
    """Every element below: (label, steps to it)."""
    seen = {}
    def walk(element, title, steps):
        for index, child in enumerate(element):
            name = (title + "/" if title else "") + label(child)
            seen[name] = seen.get(name, 0) + 1
            unique = name if seen[name] == 1 else f"{name}#{seen[name]}"
            yield unique, (*steps, index)
            yield from walk(child, unique, (*steps, index))
    yield from walk(root, "", ())


def at(root, steps):
    for step in steps:
        root = root[step]
    return root


def edited(root, steps, change):
    """The text after `change(parent, index)`."""
    copied = copy.deepcopy(root)
    change(at(copied, steps[:-1]), steps[-1])
    return tree.tostring(copied, encoding="unicode") + "\n"


def rename(name):
    def change(parent, index):
        parent[index].tag = name
    return change


def empty(parent, index):
    parent[index][:] = []


def move(to):
    def change(parent, index):
        element = parent[index]
        parent.remove(element)
        to(parent, index).append(element)
    return change


def set_attribute(name, value):
    def change(parent, index):
        element = parent[index]
        if value is None:
            del element.attrib[name]
        else:
            element.set(name, value)
    return change


def rename_attribute(name, other):
    def change(parent, index):
        element = parent[index]
        element.attrib = {other if one == name else one: value for one, value in element.attrib.items()}
    return change


def set_text(value):
    def change(parent, index):
        parent[index].text = value
    return change


def of_element(root, steps):
    """(kind, text)"""
    element = at(root, steps)
    yield "dropped", edited(root, steps, lambda parent, index: parent.remove(parent[index]))
    yield "doubled", edited(root, steps, lambda parent, index: parent.insert(index, copy.deepcopy(parent[index])))
    yield "misspelt", edited(root, steps, rename(swapped(element.tag)))
    yield "cased", edited(root, steps, rename(element.tag.capitalize()))
    yield "unknown", edited(root, steps, rename("something"))
    if len(element):
        yield "emptied", edited(root, steps, empty)
    if len(steps) > 1:
        copied = copy.deepcopy(root)
        inner = at(copied, steps)
        at(copied, steps[:-1]).remove(inner)
        at(copied, steps[:-2]).append(inner)
        yield "moved-up", tree.tostring(copied, encoding="unicode") + "\n"
    if steps[-1] > 0:
        yield "moved-down", edited(root, steps, move(lambda parent, index: parent[index - 1]))


def of_attributes(root, steps):
    """(label, text)"""
    for name, value in at(root, steps).attrib.items():
        yield f"@{name}:dropped", edited(root, steps, set_attribute(name, None))
        yield f"@{name}:misspelt", edited(root, steps, rename_attribute(name, swapped(name)))
        yield f"@{name}:key-cased", edited(root, steps, rename_attribute(name, name.capitalize()))
        for kind, other in {**VALUES, "padded": f" {value} ", "near": swapped(value), "upper": value.upper(),
                            "longer": value + "x"}.items():
            if other != value:
                yield f"@{name}:{kind}", edited(root, steps, set_attribute(name, other))


def of_text(root, steps):
    value = (at(root, steps).text or "").strip()
    if value:
        for kind, other in {**VALUES, "padded": f" {value} ", "near": swapped(value)}.items():
            yield f"#{kind}", edited(root, steps, set_text(other))


def damages(text):
    """{case: text}, the undamaged one first"""
    root = tree.fromstring(text)
    cases = {"undamaged": text}
    def add(name, damaged):
        assert name not in cases, name
        cases[name] = damaged
    for name, steps in paths(root):
        for kind, damaged in of_element(root, steps):
            add(f"{name}:{kind}", damaged)
        for kind, damaged in of_attributes(root, steps):
            add(name + kind, damaged)
        for kind, damaged in of_text(root, steps):
            add(name + kind, damaged)
    return cases


ROOTS = {"name-dropped": ('<robot name="lamp">', "<robot>"), "name-empty": ('name="lamp"', 'name=""'),
         "name-other": ('name="lamp"', 'name="light"'), "name-padded": ('name="lamp"', 'name=" lamp "'),
         "tag": ("robot", "model"), "cased": ("robot", "Robot"), "unclosed": ("</robot>", ""),
         "doctype": ("<robot", '<!DOCTYPE robot>\n<robot'), "declaration": ("<robot", '<?xml version="1.0"?>\n<robot')}


def srdfs():
    """{case: text of the SRDF}"""
    cases = damages(SRDF)
    for kind, (old, new) in ROOTS.items():
        count = -1 if kind in ("tag", "cased") else 1
        cases[f"robot:{kind}"] = SRDF.replace(old, new, count)
    cases |= {f"moveit:{kind}": SRDF.replace(old, new, 1) for kind, (old, new) in STATES.items()}
    return cases


# Mistakes of several elements.
STATES = {
    "chain-turned": ('base_link="base" tip_link="hand"', 'base_link="hand" tip_link="base"'),
    "chain-apart": ('base_link="base" tip_link="hand"', 'base_link="eye" tip_link="hand"'),
    "group-in-itself": ('<group name="arm"/>', '<group name="all"/>'),
    "ring": ('<chain base_link="base" tip_link="hand"/>', '<group name="all"/>'),
    "state-fixed": ('<joint name="elbow" value="0.2"/>', '<joint name="mount" value="0.2"/>'),
    "state-mimic": ('<joint name="elbow" value="0.2"/>', '<joint name="squeeze" value="0.2"/>'),
    "state-virtual": ('<joint name="elbow" value="0.2"/>', '<joint name="world_joint" value="0.2"/>'),
    "passive-in-group": ('<joint name="squeeze"/>', '<passive_joint name="squeeze"/>'),
    "link-for-joint": ('<joint name="squeeze"/>', '<joint name="thumb"/>'),
    "joint-for-link": ('<link name="finger"/>', '<link name="grip"/>'),
}


def hardware():
    """{case: text of the robot}"""
    cases = {name: robot_with(text) for name, text in damages(HARDWARE).items()}
    cases |= {f"async:{name}": robot_with(text) for name, text in damages(ASYNC).items() if name == "undamaged" or "prop" in name}
    inner = HARDWARE.removeprefix("<robot>\n").removesuffix("</robot>\n")
    more = {
        "none": "", "in-gazebo": f"<gazebo>{inner}</gazebo>", "joint-unknown": inner.replace('"elbow"', '"ellbow"'),
        "joint-fixed": inner.replace('"elbow"', '"mount"'), "block-twice": inner + inner,
        "mimic-commanded": inner.replace('<joint name="squeeze" mimic="true">',
                                         '<joint name="squeeze"><command_interface name="position"/>'),
        "mimic-none": inner.replace('<joint name="elbow">', '<joint name="elbow" mimic="true">'),
        "mimic-param": inner.replace('<joint name="squeeze" mimic="true">',
                                     '<joint name="squeeze"><param name="mimic">grip</param>'),
        "actuator-transmission": inner.replace('<ros2_control name="arm" type="system"', '<ros2_control name="arm" type="actuator"'),
    }
    return cases | {f"robot:{kind}": f"{ROBOT}{text}</robot>\n" for kind, text in more.items()}


def robot_with(text):
    """The robot with the inside of `<robot>`, which may be damaged."""
    inside = text.strip()
    return ROBOT + inside[inside.index(">") + 1:inside.rindex("</robot>")] + "</robot>\n"


def write(folder):
    """Folders of cases: {table: [(case, path of the robot, path of the file)]}"""
    found = {"srdf": [], "hardware": []}
    for number, (name, text) in enumerate(srdfs().items()):
        place = folder / f"srdf{number}"
        place.mkdir(parents=True)
        (place / "lamp.urdf").write_text(ROBOT + "</robot>\n", encoding="utf-8")
        (place / "lamp.srdf").write_text(text, encoding="utf-8")
        found["srdf"].append((name, place / "lamp.urdf", place / "lamp.srdf"))
    for number, (name, text) in enumerate(hardware().items()):
        place = folder / f"hardware{number}"
        place.mkdir(parents=True)
        (place / "lamp.urdf").write_text(text, encoding="utf-8")
        found["hardware"].append((name, place / "lamp.urdf", place / "lamp.urdf"))
    return found


if __name__ == "__main__":
    write(pathlib.Path(sys.argv[1]))
