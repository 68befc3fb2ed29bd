#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The verdicts of smurf-lint on the robots of paths.py or texts.py, held against what readers did with them.

usage: paths_verdicts_test.py CASES paths|texts [--list READER]

For each reader are counted, and may not become more than BOUNDS:
  all-clears  we print "loads", with losses or without; it refuses the file or crashes
  alarms      we print "fails to load"; it takes the file
  not-known   we print "not known"
  unsaid      we print "loads"; the shape is lost, or of another size than in the other formats
"""
import argparse
import collections
import json
import pathlib
import sys
import tempfile

import executed
import paths
from paths_record import SETS, table_of

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import cases as drivers  # noqa: E402

TARGETS = {"ros": "urdfdom", "gazebo": "libsdformat", "dart": "DART", "dart:6.20": "DART-6.20", "mujoco:2.3": "MuJoCo-2.3",
           "mujoco:3.1": "MuJoCo-3.1", "mujoco:3.3": "MuJoCo-3.3", "mujoco:4.0": "MuJoCo-4", "pybullet": "Bullet", "drake": "Drake",
           "pinocchio": "Pinocchio", "newton": "Newton", "isaac": "Isaac"}
COUNTS = ("all-clears", "alarms", "not-known", "unsaid")
# A COLLADA file that ends with a zero byte is read by DART and Pinocchio. MuJoCo 3.3 and earlier refuse a turned plate. Newton
# looks for a package only from the folder above the URDF.
BOUNDS = {"paths": {"dart:6.20": (0, 3, 0, 0), "mujoco:2.3": (1, 0, 0, 0), "mujoco:3.1": (1, 0, 0, 0), "mujoco:3.3": (1, 0, 0, 0),
                    "pinocchio": (0, 3, 0, 0), "newton": (0, 0, 0, 2)},
          # TinyXML and DART 6.12 stop reading at the end of the root. Python reads no name whose bytes are not UTF-8, of a
          # robot in DART only. Whether sdformat accepts moments near 0, which it has moved to another link, depends on rounding.
          "texts": {"ros": (0, 1, 0, 0), "gazebo": (0, 0, 45, 0), "dart": (0, 1, 0, 0), "dart:6.20": (10, 0, 20, 0),
                    "mujoco:2.3": (0, 3, 20, 0), "mujoco:3.1": (0, 2, 20, 0), "mujoco:3.3": (0, 0, 20, 0), "mujoco:4.0": (0, 2, 21, 0),
                    "pybullet": (0, 0, 20, 0), "pinocchio": (0, 0, 20, 0), "drake": (0, 0, 20, 0)}}
LEAST = {"paths": 180, "texts": 200}
SIZES = ("100x200x400", "104x204x404", "106x206x406")  # Bullet adds a margin
# What a reader never builds is no loss that a case causes.
NEVER_BUILT = {"visual": ("MuJoCo", "MuJoCo-2.3", "MuJoCo-3.1", "MuJoCo-3.3", "MuJoCo-4")}


def is_unsaid(reader, case, name, cell):
    if cell in ("kept", "loads", *SIZES) or reader in NEVER_BUILT.get(case.place, ()) or case.place == "both":
        return False
    # Some contents have no size of their own.
    return cell == "lost" or name.split(":")[-1].startswith(("dae", "glb"))


def compare(case, name, reader, cell, verdict):
    said = verdict["verdict"]
    if said == "unknown":
        return "not-known"
    if cell in executed.REFUSED:
        return "" if said == "refuses" else "all-clears"
    if said == "refuses":
        return "alarms"
    return "unsaid" if said == "takes" and is_unsaid(reader, case, name, cell) else ""


def lint_all(program, all_cases, targets, text_of):
    verdicts = {}
    with tempfile.TemporaryDirectory() as scratch, drivers.Cases(program) as tools:
        files = paths.write(all_cases, pathlib.Path(scratch).resolve(), text_of)
        for name, path in files.items():
            done = tools.run("smurf-lint", "--isolated", "--target", ",".join(targets), "--allow-outside", "--format", "json", path.name, cwd=path.parent)
            verdicts[name] = json.loads(done.stdout)["targets"]
    return verdicts


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("cases", type=pathlib.Path)
    parser.add_argument("set", choices=SETS)
    parser.add_argument("--list", metavar="READER")
    options = parser.parse_args()
    all_cases = SETS[options.set]()
    versions, rows = executed.read_table(table_of(options.set))
    if list(rows) != list(all_cases) or len(all_cases) < LEAST[options.set]:
        sys.exit(f"{table_of(options.set).name} is not of these cases: paths_record.py writes it again")
    is_good = True
    for text_of, wanted in ((executed.as_it_is, [one for one in TARGETS if one != "drake"]), (executed.with_obj, ["drake"])):
        verdicts = lint_all(options.cases, all_cases, wanted, text_of)
        for target in wanted:
            reader = TARGETS[target]
            if reader not in versions:
                print(f"skipped: {reader} is not recorded")
                continue
            found = collections.defaultdict(list)
            for name, case in all_cases.items():
                what = compare(case, name, reader, rows[name][reader], verdicts[name][target])
                first = verdicts[name][target].get("first", {})
                found[what].append(f"{name}: {rows[name][reader]}, we print {verdicts[name][target]['verdict']} "
                                   f"({first.get('id', '')}: {first.get('makes', '')}) "
                                   f"{','.join(verdicts[name][target].get('unknown_rules', []))}")
            counts = [len(found[what]) for what in COUNTS]
            print(f"{target}: " + ", ".join(f"{number} {what}" for number, what in zip(counts, COUNTS)) + f" of {len(rows)}")
            if options.list == target:
                print("\n".join(f"  {what}: {line}" for what in COUNTS for line in found[what]))
            for number, bound, what in zip(counts, BOUNDS[options.set].get(target, (0, 0, 0, 0)), COUNTS):
                if number > bound:
                    print(f"  {number} {what}, more than {bound}; see them with --list {target}")
                    is_good = False
    return 0 if is_good else 1


if __name__ == "__main__":
    sys.exit(main())
