#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""To show what `smurf-lint --fix` would change costs less than to find it, where every line changes.

diff_cost_test.py FOLDER_OF_TOOLS

Skips, and says so, without valgrind.
"""
import pathlib
import sys

import callgrind

LINES = 3000
MOST = 2.0  # times the instructions of --fix-only
ROBOT = '<robot name="r"><link name="a"/><gazebo>\n{}</gazebo></robot>\n'
TEXTS = {
    "equal lines": ROBOT.format("<x>&</x>\n" * LINES),
    "different lines": ROBOT.format("".join(f"<x>{i}&</x>\n" for i in range(LINES))),
    "every second line": ROBOT.format("".join(f"<x>{i}&</x>\n<y>{i}</y>\n" for i in range(LINES))),
}


def main() -> int:
    tool = pathlib.Path(sys.argv[1]).resolve() / "smurf-lint"
    callgrind.skip_without_valgrind()
    failed = 0
    for title, text in TEXTS.items():
        fixed, shown = (callgrind.instructions(tool, option, "--isolated", "-", input=text) for option in ("--fix-only", "--diff"))
        if shown > fixed * MOST:
            print(f"{title}: --diff takes {shown / fixed:.1f} times the instructions of --fix-only")
            failed += 1
    print(f"{len(TEXTS) - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
