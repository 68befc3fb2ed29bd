#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Pages of the documentation are run: files are written, commands started, outputs compared.

Usage: commands_test.py BIN_FOLDER PAGE...

A code block after a line that is only "`PATH`:" is the file PATH. In a block `text`, a line that starts
with "$ " is a command, and what follows is all it prints; a line "..." stands for any number of
lines, and "..." at the end of a line for the rest of that line. The command in "<!-- $ COMMAND -->" is
run, and its output ignored. All commands of a page run in one folder, which also holds `fixtures`, the
programs in `build/release/bin`, the model `arm` and `arm.urdf`.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
BLOCK = re.compile(r"^<!-- \$ (?P<silent>[^\n]*) -->$|"
                   r"(?:^`(?P<path>[^`\n]+)`:\n\n)?^```(?P<language>\w*)\n(?P<text>.*?)^```$", re.M | re.S)


def pattern_of(expected):
    """A regular expression for an output with "..." in it."""
    parts = []
    for line in expected.splitlines():
        if line == "...":
            parts.append(r"(?:[^\n]*\n)*?")
        elif line.endswith("..."):
            parts.append(re.escape(line[:-3]) + r"[^\n]*\n")
        else:
            parts.append(re.escape(line) + "\n")
    return "".join(parts)


def commands_of(text):
    """Pairs of a command and what it prints."""
    for part in re.split(r"^\$ ", text, flags=re.M)[1:]:
        command, _, expected = part.partition("\n")
        yield command, expected


def run(command, folder, environment):
    return subprocess.run(["bash", "-c", command], cwd=folder, env=environment, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT).stdout


def differences(page, folder, environment):
    """Messages about commands that print something else, and how many commands there were."""
    count = 0
    messages = []
    for block in BLOCK.finditer(page.read_text(encoding="utf-8")):
        if block["silent"]:
            run(block["silent"], folder, environment)
        elif block["path"]:
            path = folder / block["path"]
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(block["text"], encoding="utf-8")
        elif block["language"] == "text" and block["text"].startswith("$ "):
            for command, expected in commands_of(block["text"]):
                count += 1
                printed = run(command, folder, environment)
                if not re.fullmatch(pattern_of(expected), printed):
                    messages.append(f"{page}: $ {command}\n--- the page\n{expected}--- printed\n{printed}")
    return messages, count


def set_up(folder, binaries):
    """The models that the pages name, and the tools as in a clone."""
    (folder / "build" / "release").mkdir(parents=True)
    (folder / "build" / "release" / "bin").symlink_to(binaries)
    (folder / "fixtures").symlink_to(ROOT / "fixtures")
    shutil.copytree(ROOT / "fixtures" / "models" / "arm", folder / "arm")
    shutil.copy(ROOT / "tests" / "docs" / "arm.urdf", folder)


def main():
    binaries, pages = pathlib.Path(sys.argv[1]).resolve(), [pathlib.Path(page) for page in sys.argv[2:]]
    environment = {**os.environ, "PATH": f"{binaries}:{os.environ['PATH']}", "NO_COLOR": "1", "COLUMNS": "80"}
    for name in ("GITHUB_ACTIONS", "CI"):
        environment.pop(name, None)
    failures = 0
    for page in pages:
        with tempfile.TemporaryDirectory(dir="/tmp") as folder:  # has links to the fixtures, and is in no repository
            set_up(pathlib.Path(folder), binaries)
            messages, count = differences(page, pathlib.Path(folder), environment)
        if count == 0:
            messages.append(f"{page}: no command")
        print("\n".join(messages) or f"{page}: {count} commands print what the page says")
        failures += len(messages)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
