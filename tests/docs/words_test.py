#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Expressions that CONTRIBUTING.md asks to avoid do not come back: words_test.py TOOL...

Looks at every text of the project but the fixtures: pages, sources with their comments, messages and docstrings, build
files, tests; and at the --help of the tools.
"""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SUFFIXES = {".md", ".hpp", ".cpp", ".def", ".py", ".pyi", ".txt", ".cmake", ".js", ".mjs", ".ts", ".yml", ".yaml", ".html",
            ".json", ""}
LEFT_OUT = {"CONTRIBUTING.md", "fixtures", "build"}
BETWEEN_WORDS = r"(?:\s|[\"'#/*])+"  # a sentence goes on in the next line of a comment or a text


def avoided():
    """The right column of the table in the section English."""
    section = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8").split("\n## English\n")[1].split("\n## ")[0]
    rows = [line.split("|")[2] for line in section.splitlines() if line.startswith("| ")][1:]
    return [words for row in rows for words in re.findall(r"`([^`]+)`", row)]


def files():
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, stdout=subprocess.PIPE, check=False)
    names = listed.stdout.decode().split("\0") if listed.returncode == 0 else [
        str(path.relative_to(ROOT)) for path in ROOT.rglob("*") if path.is_file()]
    for name in names:
        path = ROOT / name
        if path.suffix in SUFFIXES and pathlib.PurePath(name).parts[:1] and pathlib.PurePath(name).parts[0] not in LEFT_OUT:
            yield path


def texts(tools):
    for path in files():
        try:
            yield str(path.relative_to(ROOT)), path.read_text(encoding="utf-8")
        except (UnicodeDecodeError, OSError):
            continue  # a picture without extension, or a file that is deleted and still listed
    for tool in tools:
        done = subprocess.run([tool, "--help"], stdout=subprocess.PIPE, text=True, check=True)
        yield pathlib.Path(tool).name + " --help", done.stdout


def main():
    patterns = [(words, re.compile(r"(?<!\w)" + re.escape(words).replace(r"\ ", BETWEEN_WORDS) + r"(?!\w)", re.I))
                for words in avoided()]
    if len(patterns) < 15:
        sys.exit("CONTRIBUTING.md has no table of words to avoid")
    failures = read = 0
    for name, text in texts(sys.argv[1:]):
        read += 1
        for words, pattern in patterns:
            for match in pattern.finditer(text):
                line = text.count("\n", 0, match.start()) + 1
                print(f"{name}:{line}: `{words}`: {text.splitlines()[line - 1].strip()[:120]}")
                failures += 1
    if read < 500:
        sys.exit(f"only {read} texts were found; has the project moved?")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
