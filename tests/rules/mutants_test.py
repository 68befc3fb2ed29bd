# SPDX-License-Identifier: BSD-3-Clause
"""Is every one of many single defects found, at its line, without an avalanche of findings?

usage: mutants_test.py SMURF_LINT FIXTURES

A defect is found when a warning or an error lies within one line of it in the file that was changed, or labels
such a place. The unchanged fixtures raise nothing.
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

from mutants import MUTANTS


def findings(lint, path):
    result = subprocess.run([lint, "--format", "json", path.name], cwd=path.parent, capture_output=True, text=True, timeout=60)
    if result.returncode not in (0, 1):
        sys.exit(f"smurf-lint ended with {result.returncode} on {path}:\n{result.stderr}")
    return [d for d in json.loads(result.stdout)["diagnostics"] if d["severity"] != "info"]


def entry_of(file):
    """What is checked when this fixture file was changed."""
    return "models/arm/smurf/arm.smurf" if file.startswith("models/") else file


def changed_line(before, after):
    lines = list(zip(before.split("\n"), after.split("\n")))
    return next((i for i, (a, b) in enumerate(lines) if a != b), len(lines) - 1) + 1


def is_found(found, path, line):
    def is_near(place):
        return pathlib.Path(place["file"]).name == path.name and abs(place["line"] - line) <= 1
    return any(is_near(d) or any(map(is_near, d.get("labels", []))) for d in found)


def main(lint, fixtures):
    missed, total = [], 0
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for part in ("models/arm", "scenes/example", "scenes/showcase"):
            shutil.copytree(pathlib.Path(fixtures) / part, root / part)
        for entry in sorted({entry_of(file) for _, file, _, _ in MUTANTS}):
            noise = findings(lint, root / entry)
            if noise:
                missed.append(f"{entry}: raises {[(d['id'], d['file'], d['line'], d['message']) for d in noise]}")
        for name, file, old, new in MUTANTS:
            path = root / file
            before = path.read_text(encoding="utf-8")
            if old not in before:
                sys.exit(f"{name}: {file} does not hold {old!r}")
            after = before.replace(old, new, 1)
            path.write_text(after, encoding="utf-8")
            found = findings(lint, root / entry_of(file))
            path.write_text(before, encoding="utf-8")
            total += len(found)
            if not is_found(found, path, changed_line(before, after)):
                missed.append(f"{name}: {[(d['id'], pathlib.Path(d['file']).name, d['line'], d['message']) for d in found]}")
            elif len(found) > 2 and "-v" in sys.argv:
                print(f"many {name}: {[(d['id'], pathlib.Path(d['file']).name, d['line']) for d in found]}")
    print(f"{len(MUTANTS)} mutants, {len(missed)} missed, {total / len(MUTANTS):.2f} findings each")
    if missed:
        sys.exit("\n".join(missed))


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
