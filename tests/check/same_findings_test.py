#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""smurf-lint, the converters and the example of the README report the same findings for every fixture.

same_findings_test.py CASES README_EXAMPLE FIXTURES
"""
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import cases  # noqa: E402

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


def findings(done) -> list:
    """The findings that a program printed, in its order; other lines are ignored."""
    if done.returncode < 0:
        raise SystemExit(f"{done.args} ended with signal {-done.returncode}")
    return [line for line in (done.stdout + done.stderr).splitlines() if FINDING.match(line)]


def main() -> int:
    program, example, fixtures = map(pathlib.Path, sys.argv[1:])
    with cases.Cases(program) as tools:
        return compare(tools, example, fixtures)


def compare(tools, example, fixtures) -> int:
    faults = compared = found = 0
    for entry in entries(fixtures):
        expected = findings(tools.run("smurf-lint", "--format", "concise", entry))
        converter = ["smurfs-flatten"] if entry.suffix in SCENES else ["smurf2urdf", "--dry-run"]
        # Losses belong to the converters, not to the check.
        converted = [line for line in findings(tools.run(*converter, "--report", "concise", entry))
                     if "[SML8" not in line]
        # Converters read no companions of a robot (SRDF, controllers, MoveIt, plugins.xml), and nothing of its package.
        of_robot = [line for line in expected
                    if not re.search(r"\[SML(3[578]|4[245]|1666)|\[SML3616\] the package |\[SML3907\]", line)]
        compared += 1
        found += len(expected)
        shown = findings(subprocess.run([example, entry], capture_output=True, text=True, timeout=600, check=False))
        for what, actual, wanted in ((converter[0], converted, of_robot), ("the example", shown, expected)):
            if actual != wanted:
                faults += 1
                print(f"{entry}: {what} finds\n  " + "\n  ".join(actual) + "\nand smurf-lint\n  " + "\n  ".join(expected))
    print(f"compared {compared} files with {found} findings")
    return 1 if faults or compared < 500 or found < 300 else 0


if __name__ == "__main__":
    sys.exit(main())
