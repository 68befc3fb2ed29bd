#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""smurf-lint, the converters and the example of the README report the same findings for every fixture.

same_findings_test.py BIN README_EXAMPLE FIXTURES
"""
import pathlib
import re
import subprocess
import sys

FINDING = re.compile(r"^.*: (error|warning|info)\[SML\d{4}\] ")
SCENES = {".smurfs", ".smurfa", ".svg"}


def entries(fixtures: pathlib.Path):
    """One file per fixture, as in rule_fixtures_test, and all models and scenes."""
    for folder in sorted(fixtures.glob("rules/*/*/")):
        for name in ("scene.svg", "scene.smurfs", "model.smurf", "robot.urdf"):
            if (folder / name).exists():
                yield folder / name
                break
    yield from sorted(fixtures.glob("models/**/*.smurf"))
    yield from sorted(fixtures.glob("scenes/**/*.smurfs"))


def findings(command: list) -> list:
    """The findings of a program, in its order; other lines are ignored."""
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=60)
    if done.returncode < 0:
        raise SystemExit(f"{command} ended with signal {-done.returncode}")
    return [line for line in (done.stdout + done.stderr).splitlines() if FINDING.match(line)]


def main() -> int:
    binaries, example, fixtures = map(pathlib.Path, sys.argv[1:])
    faults = compared = found = 0
    for entry in entries(fixtures):
        expected = findings([binaries / "smurf-lint", "--format", "concise", entry])
        converter = ["smurfs-flatten"] if entry.suffix in SCENES else ["smurf2urdf", "--dry-run"]
        # Losses belong to the converters, not to the check.
        converted = [line for line in findings([binaries / converter[0], *converter[1:], "--report", "concise", entry])
                     if "[SML8" not in line]
        compared += 1
        found += len(expected)
        for what, actual in ((converter[0], converted), ("the example", findings([example, entry]))):
            if actual != expected:
                faults += 1
                print(f"{entry}: {what} finds\n  " + "\n  ".join(actual) + "\nand smurf-lint\n  " + "\n  ".join(expected))
    print(f"compared {compared} files with {found} findings")
    return 1 if faults or compared < 500 or found < 300 else 0


if __name__ == "__main__":
    sys.exit(main())
