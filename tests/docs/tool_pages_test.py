#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The pages in docs/tools end with the examples and options of the tools: tool_pages_test.py TOOL...

SMURF_UPDATE_SNAPSHOTS=1 writes them.
"""
import os
import pathlib
import subprocess
import sys

PAGES = pathlib.Path(__file__).resolve().parent.parent.parent / "docs" / "tools"
FIRST = "## Examples\n"


def main():
    failures = 0
    for tool in sys.argv[1:]:
        page = PAGES / (pathlib.Path(tool).name + ".md")
        text = page.read_text(encoding="utf-8")
        made = subprocess.run([tool, "--generate=markdown"], stdout=subprocess.PIPE, text=True, check=True).stdout
        wanted = text.split("\n" + FIRST)[0].rstrip("\n") + "\n\n" + made
        if os.environ.get("SMURF_UPDATE_SNAPSHOTS"):
            page.write_text(wanted, encoding="utf-8")
        elif text != wanted:
            print(f"{page} is stale: run with SMURF_UPDATE_SNAPSHOTS=1")
            failures += 1
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
