#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the programs of a page of documentation to a folder: NAME.cpp, and NAME.txt with what the page says that
it prints. Prints a line "NAME ARGUMENT" for each; the argument is the comment where the program reads argv[1].

Usage: examples.py PAGE FOLDER
"""
import pathlib
import re
import sys

page, folder = map(pathlib.Path, sys.argv[1:])
blocks = re.findall(r"```cpp\n(.*?)```\n\n```text\n(.*?)```", page.read_text(encoding="utf-8"), re.S)
for number, (code, output) in enumerate(blocks, 1):
    name = f"example{number}"
    (folder / f"{name}.cpp").write_text(code, encoding="utf-8")
    (folder / f"{name}.txt").write_text(output, encoding="utf-8")
    argument = re.search(r"argv\[1\].*?// (\S+)", code)
    print(name, argument[1] if argument else "")
