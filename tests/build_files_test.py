#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The CMake files: lists are sorted, lines are short, and every script of the tests is in the table. The workflows: actions
and packages are pinned.

Prints one line per violation, `file:line: what`; the exit code is 1 if there is any.
"""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
TESTS = ROOT / "tests"
LONGEST_LINE = 120

LISTED = re.compile(r"^ *(\S+\.[ch]pp)\)?$")
PINNED_ACTION = re.compile(r"uses: [\w./-]+@[0-9a-f]{40}  # v\d")
PINNED_PACKAGE = re.compile(r"npx (?:@\w+/)?\w+@\d+\.\d+\.\d+ ")
ROW = re.compile(r"^smurf_script\((\S+) (\S+?\.py)\b", re.M)


def build_files():
    listed = subprocess.run(["git", "ls-files", "*CMakeLists.txt", "*.cmake"], cwd=ROOT, text=True, capture_output=True)
    if listed.returncode != 0:  # an archive of the sources
        return sorted(p for p in ROOT.rglob("CMakeLists.txt") if "build" not in p.relative_to(ROOT).parts)
    return [ROOT / name for name in listed.stdout.splitlines()]


def lines_of(path):
    return enumerate(path.read_text(encoding="utf-8").splitlines(), 1)


def check_lines(path):
    for number, line in lines_of(path):
        if len(line) > LONGEST_LINE:
            yield path, number, f"{len(line)} columns; break the line before column {LONGEST_LINE}"


def check_lists(path):
    """Sources and headers that are listed one a line."""
    before = None
    for number, line in lines_of(path):
        found = LISTED.match(line)
        if found and before and found[1] < before:
            yield path, number, f"{found[1]} is listed after {before}; sort the list"
        before = found[1] if found else None
        if len(re.findall(r"\.[ch]pp\b", line)) > 2:
            yield path, number, "write one source a line"


def check_table():
    path = TESTS / "CMakeLists.txt"
    text = path.read_text(encoding="utf-8")
    rows = [(row[2], row[1], text.count("\n", 0, row.start()) + 1) for row in ROW.finditer(text)]
    for before, row in zip(rows, rows[1:]):
        if row[0] < before[0]:
            yield path, row[2], f"{row[0]} is listed after {before[0]}; sort the table"
    listed = {script for script, _, _ in rows}
    for script in sorted(TESTS.rglob("*_test.py")):
        name = script.relative_to(TESTS).as_posix()
        if name not in listed and not name.startswith("python/"):
            yield path, 1, f"no test runs {name}; add a row to the table"
    python = (TESTS / "python" / "CMakeLists.txt").read_text(encoding="utf-8")
    for script in sorted((TESTS / "python").glob("*_test.py")):
        if not re.search(rf"\b{script.stem}\b", python):
            yield TESTS / "python" / "CMakeLists.txt", 1, f"no test runs {script.name}"
    if len(rows) < 50:
        yield path, 1, f"only {len(rows)} rows of the table were found; has it moved?"


def check_workflows():
    """A tag of an action, and a range of versions, may be another program tomorrow: with the rights to release."""
    found = 0
    for path in sorted((ROOT / ".github" / "workflows").glob("*.yml")):
        for number, line in lines_of(path):
            for word, pinned in (("uses: ", PINNED_ACTION), ("npx ", PINNED_PACKAGE)):
                found += line.count(word)
                if line.count(word) != len(pinned.findall(line)):
                    yield path, number, f"pin what follows '{word}': an action by its commit, a package by its whole version"
    if found < 10:
        yield ROOT / ".github", 1, f"only {found} actions and packages were found; have the workflows moved?"


def main():
    faults = [fault for path in build_files() for check in (check_lines, check_lists) for fault in check(path)]
    faults += [*check_table(), *check_workflows()]
    for path, number, fault in faults:
        print(f"{path.relative_to(ROOT)}:{number}: {fault}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
