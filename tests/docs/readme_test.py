#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""README.md: its first example works in a fresh clone as it stands, and it names scripts/demo and scripts/test with what
they need and how long they take.

usage: readme_test.py BIN_FOLDER [unittest option]...
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import commands_test

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
README = (ROOT / "README.md").read_text(encoding="utf-8")
DURATION = re.compile(r"about \d+ minutes")


def clone(folder):
    """The files of the project, where scripts/demo has built the tools, and nothing else."""
    listed = subprocess.run(["git", "ls-files"], cwd=ROOT, text=True, capture_output=True)
    names = {name.split("/")[0] for name in listed.stdout.splitlines()} or {path.name for path in ROOT.iterdir()} - {"build"}
    for name in names:
        (folder / name).symlink_to(ROOT / name)
    (folder / "build" / "release").mkdir(parents=True)
    (folder / "build" / "release" / "bin").symlink_to(BIN)


def row_of(command):
    """The cells of the table of commands: what the command does, what it needs, how long it takes."""
    found = re.search(rf"^\| `{command}` \|(.*)\|$", README, re.M)
    return [cell.strip() for cell in found[1].split("|")] if found else []


class Readme(unittest.TestCase):
    def test_first_example(self):
        example = re.search(r"^```text\n(\$ .*?)^```$", README, re.M | re.S)[1]
        environment = {**os.environ, "PATH": "/usr/bin:/bin", "NO_COLOR": "1", "COLUMNS": "80"}
        for name in ("GITHUB_ACTIONS", "CI"):
            environment.pop(name, None)
        with tempfile.TemporaryDirectory(dir=pathlib.Path.cwd()) as folder:
            clone(pathlib.Path(folder))
            for command, expected in commands_test.commands_of(example):
                printed = commands_test.run(command, folder, environment)
                self.assertRegex(printed, f"^{commands_test.pattern_of(expected)}$", command)

    def test_both_commands(self):
        for command in ("scripts/demo", "scripts/test"):
            with self.subTest(command):
                self.assertTrue(os.access(ROOT / command, os.X_OK))
                does, needs, takes = row_of(command)
                self.assertTrue(does)
                self.assertRegex(needs, r"\d+ MB")
                self.assertRegex(takes, DURATION)

    def test_demo_says_the_same_duration(self):
        said = DURATION.search((ROOT / "scripts" / "demo").read_text(encoding="utf-8"))
        self.assertIsNotNone(said)
        self.assertIn(said[0], row_of("scripts/demo")[2])


if __name__ == "__main__":
    BIN = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
