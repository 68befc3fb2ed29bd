#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The verdicts of smurf-lint on damaged robots, held against what readers did (executed.tsv, drake_executed.tsv).

usage: verdicts_test.py CASES [--list READER WHAT]

For each reader are counted, and may not become more than BOUNDS:
  all-clears  we print "loads", with losses or without; it refuses the file or crashes
  alarms      we print "fails to load"; it takes the file
  not-known   we print "not known"
  others      we print no more losses than for the undamaged robot; it makes another robot of a file
              that can mean nothing but the undamaged one
--list prints the cases of one count: --list mujoco alarms.
"""
import argparse
import collections
import json
import pathlib
import sys
import tempfile

import damage
import executed
import robot

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import cases as drivers  # noqa: E402

TARGETS = {"ros": "urdfdom", "ros:jazzy": "urdfdom-4", "ros:rolling": "urdfdom-6", "gazebo": "libsdformat", "dart": "DART", "dart:6.20": "DART-6.20",
           "mujoco": "MuJoCo", "mujoco:2.3": "MuJoCo-2.3", "mujoco:3.1": "MuJoCo-3.1", "mujoco:3.3": "MuJoCo-3.3",
           "mujoco:4.0": "MuJoCo-4", "pybullet": "Bullet", "pinocchio": "Pinocchio", "newton": "Newton", "isaac": "Isaac"}
WITH_OBJ = {"drake": "Drake"}  # see executed.with_obj
OF_DRAKE = {"drake elements": "Drake"}  # the second word is for the reader of this test only
COUNTS = ("all-clears", "alarms", "not-known", "others")
# Upper limits, which should only become smaller. For pinocchio, 17 alarms are `file://cube.stl`, which it finds only where
# it runs in the folder of the file, as in this record; paths_executed.tsv has the run elsewhere.
BOUNDS = {"ros": (0, 2, 6, 53), "ros:jazzy": (0, 1, 6, 53), "ros:rolling": (0, 1, 2, 53), "gazebo": (0, 5, 8, 43),
          "dart": (0, 2, 6, 12), "dart:6.20": (0, 1, 6, 12), "mujoco": (0, 1, 4, 9), "mujoco:2.3": (1, 1, 4, 13), "mujoco:3.1": (1, 1, 4, 15),
          "mujoco:3.3": (0, 1, 4, 15), "mujoco:4.0": (0, 1, 6, 9), "pybullet": (0, 6, 4, 35), "drake": (2, 1, 4, 12), "drake elements": (1, 1, 0, 23),
          "pinocchio": (0, 18, 2, 30), "newton": (0, 3, 0, 16), "isaac": (0, 2, 0, 42)}
LEAST, LEAST_OF_DRAKE = 7000, 1300


def lint_all(program, cases, targets, text_of):
    """{name: {target: its part of the report}}"""
    verdicts = {}
    with tempfile.TemporaryDirectory() as scratch, drivers.Cases(program) as tools:
        # Otherwise, names are looked for in all of the repository around it, and packages in the folders beside it.
        workspace = pathlib.Path(scratch) / "workspace/src"
        (workspace / ".git").mkdir(parents=True)
        folder = drivers.Folder(workspace)
        for name, case in cases.items():
            folder.become({**robot.meshes(), "robot.urdf": text_of(case.text)})
            # The readers looked everywhere, too. Two rules are about what was not recorded: motion (SML1655), and meshes
            # in RViz and MoveIt (SML1918).
            done = tools.run("smurf-lint", "--target", ",".join(targets), "--ignore", "SML1655,SML1918", "--allow-outside", "--format", "json",
                             "robot.urdf", cwd=folder.path)
            verdicts[name] = json.loads(done.stdout)["targets"]
    return verdicts


def is_another(case, cell, verdict, twin):
    if not case.is_same or cell in ("same", "taken") or verdict["verdict"] not in ("takes", "loses"):
        return False
    return verdict["losses"] <= twin["losses"]


def count(target, reader, cases, rows, verdicts):
    """{what: [line about a case]}"""
    found = collections.defaultdict(list)
    for name, case in cases.items():
        cell, verdict = rows[name][reader], verdicts[name][target]
        said = verdict["verdict"]
        line = f"{name}: {cell}, we print {said}"
        if "first" in verdict:
            line += f" ({verdict['first']['id']}: {verdict['first']['makes']})"
        if said == "unknown":
            found["not-known"].append(line + " " + ",".join(verdict.get("unknown_rules", [])))
        elif cell in executed.REFUSED:
            if said != "refuses":
                found["all-clears"].append(line)
        elif said == "refuses":
            found["alarms"].append(line)
        elif is_another(case, cell, verdict, verdicts[case.twin][target]):
            found["others"].append(line)
    return found


def check(title, found, total):
    numbers = [len(found[what]) for what in COUNTS]
    print(f"{title}: " + ", ".join(f"{number} {what}" for number, what in zip(numbers, COUNTS)) + f" of {total}")
    is_good = True
    for number, bound, what in zip(numbers, BOUNDS[title], COUNTS):
        if number > bound:
            print(f"  {number} {what}, more than {bound}; see them with --list {title!r} {what}")
            is_good = False
        elif number < bound:
            print(f"  {number} {what}: make the bound of {bound} smaller")
    return is_good


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("cases", type=pathlib.Path)
    parser.add_argument("--list", nargs=2, metavar=("READER", "WHAT"))
    options = parser.parse_args()
    robots, elements = damage.all_cases(), damage.drake_cases()
    is_good = True
    for cases, table, targets, text_of, least in (
            (robots, executed.TABLE, TARGETS, executed.as_it_is, LEAST),
            (robots, executed.TABLE, WITH_OBJ, executed.with_obj, LEAST),
            (elements, executed.DRAKE_TABLE, OF_DRAKE, executed.as_it_is, LEAST_OF_DRAKE)):
        _, rows = executed.read_table(table)
        if list(rows) != list(cases) or len(cases) < least:
            sys.exit(f"{table.name} is not of these cases: record.py writes it again")
        verdicts = lint_all(options.cases, cases, [target.split()[0] for target in targets], text_of)
        for title, reader in targets.items():
            found = count(title.split()[0], reader, cases, rows, verdicts)
            if options.list and options.list[0] == title:
                print("\n".join(found[options.list[1]]))
            is_good = check(title, found, len(cases)) and is_good
    return 0 if is_good else 1


if __name__ == "__main__":
    sys.exit(main())
