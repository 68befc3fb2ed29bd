#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""To show what `smurf-lint --fix` would change costs less than to find it, where every line changes.

diff_cost_test.py FOLDER_OF_TOOLS

Skips, and says so, without valgrind.
"""
import pathlib
import re
import shutil
import subprocess
import sys

LINES = 3000
MOST = 2.0  # times the instructions of --fix-only
ROBOT = '<robot name="r"><link name="a"/><gazebo>\n{}</gazebo></robot>\n'
TEXTS = {
    "equal lines": ROBOT.format("<x>&</x>\n" * LINES),
    "different lines": ROBOT.format("".join(f"<x>{i}&</x>\n" for i in range(LINES))),
    "every second line": ROBOT.format("".join(f"<x>{i}&</x>\n<y>{i}</y>\n" for i in range(LINES))),
}


def instructions(tool: pathlib.Path, option: str, text: str) -> int:
    run = subprocess.run(
        ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", str(tool), option, "--isolated", "-"],
        input=text, capture_output=True, text=True, timeout=600)
    if run.returncode not in (0, 1):
        raise SystemExit(f"ended with {run.returncode}: {run.stderr[-500:]}")
    return int(re.search(r"Collected : (\d+)", run.stderr).group(1))


def main() -> int:
    tool = pathlib.Path(sys.argv[1]).resolve() / "smurf-lint"
    if shutil.which("valgrind") is None:
        print("SKIPPED: no valgrind; scripts/setup --dev installs it")
        return 77
    failed = 0
    for title, text in TEXTS.items():
        fixed, shown = (instructions(tool, option, text) for option in ("--fix-only", "--diff"))
        if shown > fixed * MOST:
            print(f"{title}: --diff takes {shown / fixed:.1f} times the instructions of --fix-only")
            failed += 1
    print(f"{len(TEXTS) - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
