# SPDX-License-Identifier: BSD-3-Clause
"""Is every one of many single defects found, at its line, without an avalanche of findings?

usage: mutants_test.py SMURF_LINT FIXTURES [NAME...]    with names: shows what is found of these

A defect is found when a warning or an error lies within one line of it in the file that was changed, or labels
such a place. The unchanged files raise nothing.
"""
import concurrent.futures
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import threading

import mutants
import mutants_scenes
import mutants_smurf
import mutants_urdf

MODULES = [mutants_urdf, mutants, mutants_smurf, mutants_scenes]
MUTANTS = [mutant for module in MODULES for mutant in module.MUTANTS]
# The path to check after changing a file of the folder; by default, the file itself.
ENTRIES = {"models/": "models/arm/smurf/arm.smurf", "crane/": mutants_smurf.MAIN, **mutants_scenes.ENTRIES}
# Generated files; those of fixtures are copied.
FILES = {**mutants_urdf.WALKER_FILES, **mutants_scenes.FILES}
# Known misses, which should become fewer: a mutant in this list that is found is also a failure.
KNOWN_MISSES = {name for module in MODULES for name in getattr(module, "KNOWN_MISSES", ())}
MOST_FINDINGS_EACH = 1.3


def findings(lint, path):
    result = subprocess.run([lint, "--format", "json", path.name], cwd=path.parent, capture_output=True, timeout=60)
    if result.returncode not in (0, 1):
        sys.exit(f"smurf-lint ended with {result.returncode} on {path}:\n{result.stderr.decode()}")
    return [d for d in json.loads(result.stdout)["diagnostics"] if d["severity"] != "info"]


def entry_of(file):
    """The path to check after changing this file."""
    return next((entry for folder, entry in ENTRIES.items() if file.startswith(folder)), file)


def line_of(before, after, where):
    if where:
        return before[:before.index(where)].count("\n") + 1
    lines = list(zip(before.split("\n"), after.split("\n")))
    return next((i for i, (a, b) in enumerate(lines) if a != b), len(lines) - 1) + 1


def is_found(found, path, line):
    def is_near(place):
        return pathlib.Path(place["file"]).name == path.name and abs((place.get("line") or 0) - line) <= 1
    return any(is_near(d) or any(map(is_near, d.get("labels", []))) for d in found)


def places(found):
    return [f"{d['id']} {pathlib.Path(d['file']).name}:{d.get('line')}: {d['message']}" for d in found]


def write_originals(root, fixtures):
    for part in ("models/arm", "scenes/example", "scenes/showcase"):
        shutil.copytree(pathlib.Path(fixtures) / part, root / part)
    for name, text in FILES.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_bytes(text if isinstance(text, bytes) else text.encode("utf-8"))


class Checker:
    """Makes one change at a time in a copy of the files; each thread has its own copy."""

    def __init__(self, lint, fixtures, folder):
        self.lint, self.fixtures, self.folder = lint, fixtures, pathlib.Path(folder)
        self.local = threading.local()

    def root(self):
        if not hasattr(self.local, "root"):
            self.local.root = self.folder / str(threading.get_ident())
            write_originals(self.local.root, self.fixtures)
        return self.local.root

    def noise(self, entry):
        return findings(self.lint, self.root() / entry)

    def check(self, mutant):
        """The findings of a mutant, and whether the defect is among them."""
        name, file, old, new, *where = mutant
        path = self.root() / file
        before = path.read_text(encoding="utf-8")
        if old not in before:
            sys.exit(f"{name}: {file} does not hold {old!r}")
        after = before.replace(old, new, 1)
        path.write_bytes(after.encode("utf-8", "surrogateescape"))
        try:
            found = findings(self.lint, self.root() / entry_of(file))
        finally:
            path.write_text(before, encoding="utf-8")
        return found, is_found(found, path, line_of(before, after, *where or [""]))


def main(lint, fixtures, *names):
    chosen = [mutant for mutant in MUTANTS if not names or mutant[0] in names]
    failures, total = [], 0
    with tempfile.TemporaryDirectory() as folder:
        checker = Checker(os.path.abspath(lint), fixtures, folder)
        for entry in sorted({entry_of(mutant[1]) for mutant in MUTANTS}):
            failures += [f"{entry} without a defect: {place}" for place in places(checker.noise(entry))]
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            for mutant, (found, is_seen) in zip(chosen, pool.map(checker.check, chosen)):
                total += len(found)
                if is_seen and mutant[0] in KNOWN_MISSES:
                    failures.append(f"{mutant[0]} is found: delete it from KNOWN_MISSES")
                elif not is_seen and not names and mutant[0] in KNOWN_MISSES:
                    continue
                elif not is_seen:
                    failures.append(f"missed {mutant[0]}: {places(found)}")
                elif names or len(found) > 2:
                    print(f"{mutant[0]}: {places(found)}")
    print(f"{len(chosen)} mutants, {len(failures)} failures, {len(KNOWN_MISSES)} known misses, {total / len(chosen):.2f} findings each")
    if failures or total > MOST_FINDINGS_EACH * len(chosen):
        sys.exit("\n".join(failures) or "too many findings for single defects")


if __name__ == "__main__":
    main(*sys.argv[1:])
