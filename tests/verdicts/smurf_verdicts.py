#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The verdicts of smurf-lint on damaged SMURF models and scenes, held against what SMURF's own readers did.

usage: smurf_verdicts.py CASES [--list READER]
       smurf_verdicts.py --record READER COMMIT COMMAND...

Phobos 2 and MARS 1 are in no package, so smurf_executed.tsv is made by hand: COMMAND reads paths of main files from standard
input, in their order, and prints a line of JSON for each, {"file": ..., "verdict": "takes", "refuses" or "crashes"}. Of Phobos
that is phobos_smurf.py. Of MARS it is a program of its loaders, managers and sensors, unchanged. Its graphics print what they are
told to create, and end where those of MARS would: a collision mesh that is not there. Its physics make nothing.

Counted are false all-clears (the reader refuses, we print that it takes the file, with losses or without) and false alarms;
both may not become more than BOUNDS. "Not known" agrees with nothing and counts with the all-clears where the reader refuses.
"""
import argparse
import datetime
import json
import pathlib
import re
import subprocess
import sys
import tempfile

import smurf_damage

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import cases as drivers  # noqa: E402

TABLE = pathlib.Path(__file__).resolve().parent / "smurf_executed.tsv"
READERS = ("phobos", "mars")
# Upper limits for missed and false findings, which should only become smaller.
BOUNDS = {"phobos": (14, 18), "mars": (22, 4)}
LEAST_AGREEMENT = 0.97


def read_table():
    """(what stands above, {name: {reader: cell}})"""
    lines = TABLE.read_text(encoding="utf-8").splitlines() if TABLE.exists() else []
    heads = [line for line in lines if line.startswith("#")]
    rows = (line.split("\t") for line in lines if not line.startswith(("#", "case\t")))
    return heads, {row[0]: dict(zip(READERS, row[1:])) for row in rows}


def write_table(heads, rows):
    lines = [*heads, "\t".join(("case", *READERS))]
    lines += ["\t".join((name, *(cells.get(reader, "-") for reader in READERS))) for name, cells in rows.items()]
    TABLE.write_text("\n".join(lines) + "\n", encoding="utf-8")


def record(reader, commit, command):
    cases = smurf_damage.all_cases()
    with tempfile.TemporaryDirectory() as folder:
        paths = smurf_damage.write(cases, pathlib.Path(folder).resolve())
        done = subprocess.run(command, input="".join(f"{path}\n" for path in paths.values()), stdout=subprocess.PIPE,
                              text=True, check=True)
    said = {answer["file"]: answer["verdict"] for answer in map(json.loads, done.stdout.splitlines())}
    heads, rows = read_table()
    heads = [line for line in heads if not line.startswith(f"# {reader} ")]
    heads = sorted([*heads, f"# {reader} {commit}, run by hand on {datetime.date.today().isoformat()}"])
    write_table(heads, {name: {**rows.get(name, {}), reader: said[str(paths[name])]} for name in cases})


def lint_all(program, cases):
    """{name: {reader: verdict}}"""
    verdicts = {}
    with tempfile.TemporaryDirectory() as scratch, drivers.Cases(program) as tools:
        folder = drivers.Folder(scratch)
        for name, case in cases.items():
            folder.become(case.files)
            main = folder.path / case.main
            done = tools.run("smurf-lint", "--target", ",".join(READERS), "--format", "json", main.name, cwd=main.parent)
            verdicts[name] = {reader: said["verdict"] for reader, said in json.loads(done.stdout)["targets"].items()}
    return verdicts


def check(reader, rows, verdicts, is_listed):
    refused = {name for name, cells in rows.items() if cells[reader] != "takes"}
    printed = {name for name, verdict in verdicts.items() if verdict[reader] == "refuses"}
    clears, alarms = refused - printed, printed - refused
    agreement = 1 - (len(clears) + len(alarms)) / len(rows)
    print(f"{reader}: {len(clears)} all-clears, {len(alarms)} alarms of {len(rows)}, agrees on {agreement:.2%}")
    if is_listed:
        print("\n".join(f"  {rows[name][reader]}, we print {verdicts[name][reader]}: {name}"
                        for name in rows if name in clears or name in alarms))
    most = BOUNDS[reader]
    for number, bound in zip((len(clears), len(alarms)), most):
        if number < bound:
            print(f"  {number}: make the bound of {bound} smaller")
    return len(clears) <= most[0] and len(alarms) <= most[1] and agreement >= LEAST_AGREEMENT


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("cases", type=pathlib.Path, nargs="?")
    parser.add_argument("--list", metavar="READER")
    parser.add_argument("--record", nargs=argparse.REMAINDER, metavar="READER COMMIT COMMAND")
    options = parser.parse_args()
    if options.record:
        return record(options.record[0], options.record[1], options.record[2:])
    cases = smurf_damage.all_cases()
    heads, rows = read_table()
    if list(rows) != list(cases) or not all(re.search(r" [0-9a-f]{7}, run by hand on ", head) for head in heads[1:]):
        sys.exit("smurf_executed.tsv is not of these cases: see --record")
    verdicts = lint_all(options.cases, cases)
    return 0 if all([check(reader, rows, verdicts, options.list == reader) for reader in READERS]) else 1


if __name__ == "__main__":
    sys.exit(main())
