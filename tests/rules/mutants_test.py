# SPDX-License-Identifier: BSD-3-Clause
"""Is every one of many single defects found, at its line, by its rule, without an avalanche of findings?

usage: mutants_test.py CASES FIXTURES [NAME...]    with names: shows what is found of these

A defect is found when a warning or an error lies within one line of it in the file that was changed, or labels
such a place. mutants.tsv has the rules of these findings and of the others; SMURF_UPDATE_SNAPSHOTS=1 writes it.
The unchanged files raise nothing.
"""
import json
import os
import pathlib
import shutil
import sys
import tempfile

import mutants
import mutants_scenes
import mutants_smurf
import mutants_urdf

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import cases  # noqa: E402

TABLE = pathlib.Path(__file__).resolve().parent / "mutants.tsv"
HEADING = "# mutant, rules of the findings at the defect, rules of the others"
MODULES = [mutants_urdf, mutants, mutants_smurf, mutants_scenes]
MUTANTS = [mutant for module in MODULES for mutant in module.MUTANTS]
# The path to check after changing a file of the folder; by default, the file itself.
ENTRIES = {"models/": "models/arm/smurf/arm.smurf", "crane/": mutants_smurf.MAIN, **mutants_scenes.ENTRIES}
# Generated files; those of fixtures are copied.
FILES = {**mutants_urdf.WALKER_FILES, **mutants_scenes.FILES}
# Known misses, which should become fewer: a mutant in this list that is found is also a failure.
KNOWN_MISSES = {name for module in MODULES for name in getattr(module, "KNOWN_MISSES", ())}
MOST_FINDINGS_EACH = 1.3


def findings(tools, path):
    done = tools.run("smurf-lint", "--format", "json", path.name, cwd=path.parent)
    if done.returncode not in (0, 1):
        sys.exit(f"smurf-lint ended with {done.returncode} on {path}:\n{done.stderr}")
    return [d for d in json.loads(done.stdout)["diagnostics"] if d["severity"] != "info"]


def entry_of(file):
    """The path to check after changing this file."""
    return next((entry for folder, entry in ENTRIES.items() if file.startswith(folder)), file)


def line_of(before, after, where):
    if where:
        return before[:before.index(where)].count("\n") + 1
    lines = list(zip(before.split("\n"), after.split("\n")))
    return next((i for i, (a, b) in enumerate(lines) if a != b), len(lines) - 1) + 1


def is_at(finding, path, line):
    """Whether a finding, or a label of it, is at the defect."""
    def is_near(place):
        return pathlib.Path(place["file"]).name == path.name and abs((place.get("line") or 0) - line) <= 1
    return is_near(finding) or any(map(is_near, finding.get("labels", [])))


def key_of(mutant):
    """Names occur once in a file."""
    return f"{mutant[0]} {mutant[1]}"


def read_table():
    """{key of a mutant: its line}"""
    lines = TABLE.read_text(encoding="utf-8").splitlines() if TABLE.exists() else []
    return {line.split("\t")[0]: line for line in lines if not line.startswith("#")}


def places(found):
    return [f"{d['id']} {pathlib.Path(d['file']).name}:{d.get('line')}: {d['message']}" for d in found]


def write_originals(root, fixtures):
    for part in ("models/arm", "scenes/example", "scenes/showcase"):
        shutil.copytree(pathlib.Path(fixtures) / part, root / part)
    for name, text in FILES.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_bytes(text if isinstance(text, bytes) else text.encode("utf-8"))


class Checker:
    """Makes one change at a time in a copy of the files."""

    def __init__(self, tools, fixtures, root):
        self.tools, self.root = tools, root
        write_originals(root, fixtures)

    def noise(self, entry):
        return findings(self.tools, self.root / entry)

    def check(self, mutant):
        """The findings at the defect, and the others."""
        name, file, old, new, *where = mutant
        path = self.root / file
        before = path.read_text(encoding="utf-8")
        if old not in before:
            sys.exit(f"{name}: {file} does not hold {old!r}")
        after = before.replace(old, new, 1)
        path.write_bytes(after.encode("utf-8", "surrogateescape"))
        try:
            found = findings(self.tools, self.root / entry_of(file))
        finally:
            path.write_text(before, encoding="utf-8")
        line = line_of(before, after, *where or [""])
        there = [one for one in found if is_at(one, path, line)]
        return there, [one for one in found if one not in there]


def row_of(mutant, there, others):
    """The line of the table."""
    return "\t".join((key_of(mutant), *(" ".join(one["id"] for one in found) or "-" for found in (there, others))))


def judge(mutant, there, others, known):
    """The reason of a failure, or None."""
    name = mutant[0]
    if there and name in KNOWN_MISSES:
        return f"{name} is found: delete it from KNOWN_MISSES"
    if not there and name not in KNOWN_MISSES:
        return f"missed {name}: {places(others)}"
    if known != row_of(mutant, there, others):
        return f"{name}: {places(there + others)}\n  now      {row_of(mutant, there, others)}\n  recorded {known}"
    return None


def update(rows):
    if "SMURF_UPDATE_SNAPSHOTS" in os.environ:
        TABLE.write_text("\n".join([HEADING, *rows]) + "\n", encoding="utf-8")


def main(program, fixtures, *names):
    chosen = [mutant for mutant in MUTANTS if not names or mutant[0] in names]
    failures, total = [], 0
    with tempfile.TemporaryDirectory() as folder, cases.Cases(program) as tools:
        checker = Checker(tools, fixtures, pathlib.Path(folder).resolve())
        for entry in sorted({entry_of(mutant[1]) for mutant in MUTANTS}):
            failures += [f"{entry} without a defect: {place}" for place in places(checker.noise(entry))]
        found = {mutant: checker.check(mutant) for mutant in chosen}
    if not names:
        update([row_of(mutant, *both) for mutant, both in found.items()])
    table = read_table()
    for mutant, (there, others) in found.items():
        total += len(there) + len(others)
        failure = judge(mutant, there, others, table.get(key_of(mutant)))
        if failure:
            failures.append(failure)
        if names:
            print(f"{mutant[0]}: {places(there + others)}")
    if not names and list(table) != list(map(key_of, MUTANTS)):
        failures.append(f"{TABLE.name} is not of these mutants; write it with SMURF_UPDATE_SNAPSHOTS=1")
    print(f"{len(chosen)} mutants, {len(failures)} failures, {len(KNOWN_MISSES)} known misses, {total / len(chosen):.2f} findings each")
    if failures or total > MOST_FINDINGS_EACH * len(chosen):
        sys.exit("\n".join(failures) or "too many findings for single defects")


if __name__ == "__main__":
    main(*sys.argv[1:])
