#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The verdicts of smurf-lint on robots that are in no table, each with other sizes and joints, and a damage or two.

usage: fresh_verdicts_test.py CASES BUILD [--seed N] [--count N] [--keep FOLDER]

BUILD has the programs of record.py. The default seed is the day, which is printed. The counts are of verdicts_test.py,
and their cases are printed. --keep leaves the robots, and what each reader said of them, in FOLDER.

Ends with 77, which CTest shows as skipped, where a reader is absent.
"""
import argparse
import datetime
import json
import pathlib
import random
import sys
import tempfile

import damage
import executed
import files
import robot as robots
import verdicts_test

COUNT = 1000
TARGETS = {**verdicts_test.TARGETS, **verdicts_test.WITH_OBJ}
# Parts of all robots, for each count of verdicts_test.py but the last.
MOST = {"all-clears": 0.005, "alarms": 0.005, "not-known": 0.02}
OPTIONAL = ("transmission", "gazebo", "material", "visual", "collision", "calibration", "safety_controller", "dynamics",
            "mimic", "texture")
SIZES = ("xyz", "rpy", "size", "scale", "radius", "length", "value", "ixx", "ixy", "ixz", "iyy", "iyz", "izz")
LIMIT = [("lower", "-1"), ("upper", "1"), ("effort", "2"), ("velocity", "3")]
RARE = {"tree": files.damage_trees, "body": files.damage_bodies, "file": files.damage_files}


class Elements(damage.Cases):
    """Keeps the damaged robot as a tree, so that it can be damaged again."""

    def add(self, name, robot, twin="robot", is_same=False):
        self.by_name[name] = robot


def number(value, factor):
    return repr(float(value) * factor)


def resize(element, dice):
    """Lengths, masses and moments of one element by one factor, so that bodies stay possible; axes and limits stay."""
    factor = dice.uniform(0.5, 1.5)
    for attribute in element.attributes:
        if attribute[0] in SIZES and element.tag != "axis":
            attribute[1] = " ".join(number(value, factor) for value in attribute[1].split())


def variant(dice):
    """An undamaged robot."""
    robot = robots.parse(robots.TEXT)
    for _, element, above in list(damage.labelled(robot, "robot")):
        resize(element, dice)
        is_optional = element.tag in OPTIONAL and element in above.children and element.get("name") != "red"
        if is_optional and dice.random() < 0.15:
            above.children.remove(element)
        if element.tag == "geometry" and dice.random() < 0.4:
            element.children = [one.copy() for one in damage.SHAPES[dice.choice(sorted(damage.SHAPES))]]
        if element.tag == "joint" and element.get("type") and element.get("name") != "shoulder" and dice.random() < 0.2:
            element.set("type", dice.choice(["fixed", "revolute", "continuous", "prismatic"]))
            if not element.first("limit"):
                element.children.append(robots.Element("limit", LIMIT))
    robot.set("name", f"robot{dice.randrange(1000)}")
    return robot


def damaged(robot, dice):
    """The name of a damage and the robot with it; bytes where it is no longer a tree."""
    found = Elements()
    kind = dice.random()
    if kind < 0.15:
        RARE[dice.choice(sorted(RARE))](found, robot)
    else:
        label, element, _ = dice.choice(list(damage.labelled(robot, "robot")))
        if not element.attributes or kind < 0.35:
            damage.damage_element(found, robot, "robot", label, True)
        else:
            attribute, _ = dice.choice(element.attributes)
            damage.damage_attribute(found, robot, "robot", label, attribute, True)
    name = dice.choice(sorted(found.by_name))
    return name, found.by_name[name]


def fresh_cases(dice, count):
    cases = damage.Cases()
    while len(cases.by_name) < count:
        robot, names = variant(dice), []
        for _ in range(dice.choice([1, 1, 2])):
            try:
                name, changed = damaged(robot, dice)
            except (AttributeError, ValueError, IndexError, KeyError):
                continue  # the part that it damages was removed
            names.append(name)
            robot = changed
            if isinstance(robot, bytes):
                break
        if names:
            name = f"{len(cases.by_name)} " + " and ".join(names)
            cases.add(name, robot, name)
    return cases.by_name


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("cases", type=pathlib.Path)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--seed", type=int, default=int(datetime.date.today().strftime("%Y%m%d")))
    parser.add_argument("--count", type=int, default=COUNT)
    parser.add_argument("--keep", type=pathlib.Path)
    options = parser.parse_args()
    found, absent = executed.readers(options.build.resolve())
    readers = {reader.name: reader for reader in found}
    cases = fresh_cases(random.Random(options.seed), options.count)
    print(f"seed {options.seed}, {len(cases)} robots")
    is_good = True
    with tempfile.TemporaryDirectory() as scratch:
        folder = (options.keep or pathlib.Path(scratch)).resolve()
        for text_of in (executed.as_it_is, executed.with_obj):
            paths = damage.write(cases, folder / text_of.__name__, text_of)
            targets = {target: readers[name] for target, name in TARGETS.items()
                       if name in readers and readers[name].text_of is text_of}
            if not targets:
                continue
            verdicts = verdicts_test.lint_all(options.cases, cases, list(targets), text_of)
            for target, reader in targets.items():
                said = executed.read_all(reader, [str(path) for path in paths.values()])
                if options.keep:
                    (folder / f"{reader.name}.json").write_text(
                        json.dumps({name: said[str(paths[name])] for name in cases}))
                is_good = compare(target, reader, cases, executed.judge(cases, paths, said), verdicts) and is_good
    if absent:
        print("skipped: " + ", ".join(f"{name} is not installed" for name in absent))
    return 1 if not is_good else 77 if absent else 0


def compare(target, reader, cases, cells, verdicts):
    rows = {name: {reader.name: cell} for name, cell in cells.items()}
    found = verdicts_test.count(target, reader.name, cases, rows, verdicts)
    print(f"{target} ({reader.version}): " + ", ".join(f"{len(found[what])} {what}" for what in MOST), flush=True)
    for what in MOST:
        for line in found[what]:
            print(f"  {what}: {line}")
    return all(len(found[what]) <= part * len(cases) for what, part in MOST.items())


if __name__ == "__main__":
    sys.exit(main())
