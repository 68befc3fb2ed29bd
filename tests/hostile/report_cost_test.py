#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A report of many findings asks the file system for the place of their file once, not for each of them.

report_cost_test.py FOLDER_OF_TOOLS

Skips, and says so, without valgrind.
"""
import pathlib
import sys
import tempfile

import callgrind

FORMATS = ("github", "gitlab", "sarif")
FINDINGS = 1000
DEPTH = 40  # folders
MOST = 1.1  # times the instructions for a file with a path of the same length and without parent folders


def main() -> int:
    tool = pathlib.Path(sys.argv[1]).resolve() / "smurf-lint"
    callgrind.skip_without_valgrind()
    failed = 0
    with tempfile.TemporaryDirectory() as work:
        folder = pathlib.Path(work)
        deep = pathlib.Path(*["f"] * DEPTH) / "r.urdf"
        near = pathlib.Path(str(deep).replace("/", "_"))
        (folder / deep).parent.mkdir(parents=True)
        for path in (near, deep):
            (folder / path).write_text('<robot name="r"><link name="a"/><gazebo>\n' + "<x>&</x>\n" * FINDINGS + "</gazebo></robot>\n")
        for report in FORMATS:
            here, there = (callgrind.instructions(tool, "--isolated", "--format", report, path, codes=(1,), cwd=folder) for path in (near, deep))
            if there > here * MOST:
                print(f"{report}: {there / here:.2f} times the instructions, {DEPTH} folders deep")
                failed += 1
    print(f"{len(FORMATS) - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
