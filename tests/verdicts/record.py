#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Gives the damaged robots to their readers.

usage: record.py BUILD [--hold] [--drake] [--keep FOLDER]

BUILD has the programs urdfdom_robot, sdformat_robot and dart_robot. Writes executed.tsv again, and
drake_executed.tsv, which is about Drake only; with --hold they stay, and what readers of the same
version do must be what they say. --keep leaves the robots, and what each reader said of them, in
FOLDER. --drake does the second table only.

Ends with 77, which CTest shows as skipped, where a reader is absent or of another version.
"""
import argparse
import datetime
import json
import pathlib
import sys
import tempfile

import damage
import executed

SHOWN = 20


def record(found, cases, folder, keep):
    """{reader: (version, {name: cell})}"""
    results, written = {}, {}
    for reader in found:
        if reader.text_of not in written:
            written[reader.text_of] = damage.write(cases, folder / reader.text_of.__name__, reader.text_of)
        paths = written[reader.text_of]
        said = executed.read_all(reader, [str(path) for path in paths.values()])
        results[reader.name] = (reader.version, executed.judge(cases, paths, said))
        if keep:
            (folder / f"{reader.name}.json").write_text(json.dumps(
                {name: said[str(path)] for name, path in paths.items()}))
        print(f"{reader.name} {reader.version}: {len(said)} robots", flush=True)
    return results


def hold(table, results):
    """The number of cells that differ from the recorded ones; readers of other versions are not compared."""
    versions, rows = executed.read_table(table)
    wrong, others = [], []
    for name, (version, cells) in results.items():
        if versions.get(name) != version:
            others.append(f"{name} {version}: recorded is {versions.get(name)}")
            continue
        wrong += [f"{name}: {case}: {cell}, recorded is {rows.get(case, {}).get(name)}"
                  for case, cell in cells.items() if rows.get(case, {}).get(name) != cell]
    for line in wrong[:SHOWN]:
        print(line)
    print(f"{len(wrong)} of what was run is not as recorded")
    return len(wrong), others


def write(table, results):
    versions = {name: version for name, (version, _) in results.items()}
    names = next(iter(results.values()))[1]
    executed.write_table(table, datetime.date.today().isoformat(), versions, {
        case: {reader: cells[case] for reader, (_, cells) in results.items()} for case in names})


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--hold", action="store_true")
    parser.add_argument("--drake", action="store_true")
    parser.add_argument("--keep", type=pathlib.Path)
    options = parser.parse_args()
    found, absent = executed.readers(options.build.resolve())
    if absent and not options.hold and (not options.drake or "Drake" in absent):
        sys.exit(f"not written: {', '.join(absent)} is not installed")
    drake = [reader for reader in found if reader.name == "Drake"]
    tables = {} if options.drake else {executed.TABLE: (found, damage.all_cases())}
    tables[executed.DRAKE_TABLE] = (drake, damage.drake_cases())
    wrong, others = 0, []
    for table, (readers, cases) in tables.items():
        with tempfile.TemporaryDirectory() as scratch:
            folder = (options.keep or pathlib.Path(scratch)) / table.stem
            results = record(readers, cases, folder.resolve(), options.keep is not None)
        if not options.hold:
            write(table, results)
            continue
        more, of_others = hold(table, results)
        wrong, others = wrong + more, others + of_others
    if not options.hold:
        return 0
    for line in [f"{name} is not installed" for name in absent] + others:
        print(f"skipped: {line}")
    if wrong:
        return 1
    return 77 if absent or others else 0


if __name__ == "__main__":
    sys.exit(main())
