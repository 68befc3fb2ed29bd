#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Expressions that CONTRIBUTING.md asks to avoid do not come back: words_test.py TOOL...

Looks at README.md, CHANGELOG.md, SECURITY.md, everything in docs/, the hooks, and the --help of the tools.
"""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def avoided():
    """The right column of the table in the section English."""
    section = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8").split("\n## English\n")[1].split("\n## ")[0]
    rows = [line.split("|")[2] for line in section.splitlines() if line.startswith("| ")][1:]
    return [words for row in rows for words in re.findall(r"`([^`]+)`", row)]


def texts(tools):
    for path in [*(ROOT / name for name in ("README.md", "CHANGELOG.md", "SECURITY.md", ".pre-commit-hooks.yaml")),
                 *sorted((ROOT / "docs").rglob("*.md"))]:
        yield str(path.relative_to(ROOT)), path.read_text(encoding="utf-8")
    for tool in tools:
        done = subprocess.run([tool, "--help"], stdout=subprocess.PIPE, text=True, check=True)
        yield pathlib.Path(tool).name + " --help", done.stdout


def main():
    patterns = [(words, re.compile(r"(?<!\w)" + re.escape(words).replace(r"\ ", r"\s+") + r"(?!\w)", re.I)) for words in avoided()]
    if len(patterns) < 15:
        sys.exit("CONTRIBUTING.md has no table of words to avoid")
    failures = 0
    for name, text in texts(sys.argv[1:]):
        for words, pattern in patterns:
            for match in pattern.finditer(text):
                line = text.count("\n", 0, match.start()) + 1
                print(f"{name}:{line}: `{words}`: {text.splitlines()[line - 1].strip()[:120]}")
                failures += 1
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
