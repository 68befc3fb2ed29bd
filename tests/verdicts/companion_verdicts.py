#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What smurf-lint says of damaged SRDFs and elements ros2_control, held against what their readers did.

usage: companion_verdicts.py CASES [--list READER WHAT]
       companion_verdicts.py --record READER COMMIT PROGRAM

The readers are in no package for this system, so companion_executed.tsv is recorded by hand with programs of their unchanged
sources (srdfdom src/model.cpp; ros2_control hardware_interface/src/component_parser.cpp of each branch, with
stubs): srdfdom_companion.cpp and hardware_companion.cpp. PROGRAM reads lines "ROBOT <tab> FILE" and prints for each the file,
`ok` or `refuses`, what was read, and its messages, with tabs between them.

Cells: `refuses`; `reports`, where the reader goes on after a message; `other`, where it reads something else without one; `same`.

For each reader are counted, and may not become more than BOUNDS:
  missed   the reader refuses the file, and we print no error; or it drops something, with a message or without, and we print
           neither error nor warning
  alarms   we print an error, and the reader reads the same as without the damage
"""
import argparse
import collections
import datetime
import json
import pathlib
import re
import subprocess
import sys
import tempfile

import companion_damage

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import cases as drivers  # noqa: E402

TABLE = pathlib.Path(__file__).resolve().parent / "companion_executed.tsv"
TARGETS = {"srdfdom": "moveit", "humble": "ros2_control:humble", "jazzy": "ros2_control:jazzy", "kilted": "ros2_control:kilted",
           "rolling": "ros2_control:rolling"}
WARNINGS = {"srdf": "SML35", "hardware": "SML36"}
# Upper limits, which should only become smaller.
BOUNDS = {"srdfdom": (0, 1), "humble": (6, 8), "jazzy": (4, 0), "kilted": (4, 0), "rolling": (4, 0)}
# An empty parameter is an empty text.
NOT_AN_ERROR = r"text not specified in the [\w. ]+ tag"
# Ways of damage in which the reader no longer finds something that the author wrote.
HIDDEN = re.compile(r":(misspelt|cased|moved-up|moved-down|key-cased)$")


def read_table():
    """(what stands above, {(kind, case): {reader: cell}})"""
    lines = TABLE.read_text(encoding="utf-8").splitlines() if TABLE.exists() else []
    heads = [line for line in lines if line.startswith("#")]
    rows = (line.split("\t") for line in lines if not line.startswith(("#", "kind\t")))
    return heads, {(row[0], row[1]): dict(zip(TARGETS, row[2:])) for row in rows}


def write_table(heads, rows):
    lines = [*heads, "\t".join(("kind", "case", *TARGETS))]
    lines += ["\t".join((*place, *(cells.get(reader, "-") for reader in TARGETS))) for place, cells in rows.items()]
    TABLE.write_text("\n".join(lines) + "\n", encoding="utf-8")


def kind_of(reader):
    return "srdf" if reader == "srdfdom" else "hardware"


def all_cases():
    """{(kind, case): text}"""
    return {("srdf", name): text for name, text in companion_damage.srdfs().items()} | \
           {("hardware", name): text for name, text in companion_damage.hardware().items()}


def twin_of(name):
    return "async:undamaged" if name.startswith("async:") else "undamaged"


def record(reader, commit, program):
    kind = kind_of(reader)
    with tempfile.TemporaryDirectory() as folder:
        found = companion_damage.write(pathlib.Path(folder).resolve())[kind]
        done = subprocess.run([program], input="".join(f"{robot}\t{file}\n" for _, robot, file in found), stdout=subprocess.PIPE,
                              text=True, check=True)
    answers = {name: line.split("\t")[1:] for (name, _, _), line in zip(found, done.stdout.splitlines(), strict=True)}
    heads, rows = read_table()
    heads = sorted([*(line for line in heads if not line.startswith(f"# {reader} ")),
                    f"# {reader} {commit}, run by hand on {datetime.date.today().isoformat()}"])
    table = {place: rows.get(place, {}) for place in all_cases()}
    for name, (verdict, read, messages) in answers.items():
        twin = answers[twin_of(name)]
        messages, expected = (re.sub(NOT_AN_ERROR, "", text).strip() for text in (messages, twin[2]))
        cell = "refuses" if verdict == "refuses" else "reports" if messages != expected else \
            "same" if read == twin[1] else "other"
        table[(kind, name)][reader] = cell
    write_table(heads, table)


def lint_all(program, cases):
    """{(kind, case): {reader: severities}}"""
    said = collections.defaultdict(dict)
    with tempfile.TemporaryDirectory() as scratch, drivers.Cases(program) as tools:
        folder = drivers.Folder(scratch)
        for (kind, name), text in cases.items():
            if kind == "srdf":
                folder.become({"lamp.urdf": companion_damage.ROBOT + "</robot>\n", "lamp.srdf": text})
            else:
                folder.become({"lamp.urdf": text})
            for reader, target in TARGETS.items():
                if kind_of(reader) != kind:
                    continue
                file = "lamp.srdf" if kind == "srdf" else "lamp.urdf"
                done = tools.run("smurf-lint", "--target", target, "--format", "json", file, cwd=folder.path)
                findings = json.loads(done.stdout)["diagnostics"]
                said[(kind, name)][reader] = [f"{one['severity']} {one['id']}" for one in findings
                                              if one["severity"] == "error" or one["id"].startswith(WARNINGS[kind])]
    return said


def has(said, *severities):
    return any(one.split()[0] in severities for one in said)


def is_missed(name, cell, said):
    if cell == "refuses":
        return not has(said, "error")
    is_hidden = cell == "other" and HIDDEN.search(name)
    return (cell == "reports" or is_hidden) and not has(said, "error", "warning")


def count(reader, rows, said):
    """{what: [line]}"""
    found = {"missed": [], "alarms": []}
    for (kind, name), cells in rows.items():
        if kind != kind_of(reader):
            continue
        cell, ours = cells[reader], said[(kind, name)][reader]
        line = f"{name}: {cell}, we print {', '.join(ours) or 'nothing'}"
        if is_missed(name, cell, ours):
            found["missed"].append(line)
        elif cell == "same" and has(ours, "error"):
            found["alarms"].append(line)
    return found


def check(reader, found):
    numbers = (len(found["missed"]), len(found["alarms"]))
    print(f"{reader}: {numbers[0]} missed, {numbers[1]} alarms")
    for number, bound in zip(numbers, BOUNDS[reader]):
        if number < bound:
            print(f"  {number}: make the bound of {bound} smaller")
    return all(number <= bound for number, bound in zip(numbers, BOUNDS[reader]))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("cases", type=pathlib.Path, nargs="?")
    parser.add_argument("--list", nargs=2, metavar=("READER", "WHAT"))
    parser.add_argument("--record", nargs=3, metavar=("READER", "COMMIT", "PROGRAM"))
    options = parser.parse_args()
    if options.record:
        return record(*options.record)
    cases = all_cases()
    heads, rows = read_table()
    if list(rows) != list(cases) or len(heads) != len(TARGETS):
        sys.exit("companion_executed.tsv is not of these cases: see --record")
    said = lint_all(options.cases, cases)
    is_good = True
    for reader in TARGETS:
        found = count(reader, rows, said)
        if options.list and options.list[0] == reader:
            print("\n".join(found[options.list[1]]))
        is_good = check(reader, found) and is_good
    return 0 if is_good else 1


if __name__ == "__main__":
    sys.exit(main())
