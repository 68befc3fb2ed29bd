#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Input of four times the size takes about four times the instructions, in every tool.

growth_test.py FOLDER_OF_TOOLS [NAME...]

The inputs are in growth_inputs.py. A quadratic path takes sixteen times as many instructions, so FACTOR leaves room
for logarithms only. Skips, and says so, without valgrind.
"""
import concurrent.futures
import os
import pathlib
import subprocess
import sys
import tempfile

import callgrind
import growth_inputs

STEP = 4
FACTOR = 5.5
SECONDS = 120


def instructions(tools: pathlib.Path, case: growth_inputs.Case, folder: pathlib.Path, size: int) -> int:
    folder.mkdir()
    case.write(size, folder)
    return callgrind.instructions(tools / case.command[0], *case.arguments(size), codes=(0, 1, 2), cwd=folder, timeout=SECONDS,
                                  env={**os.environ, **case.variables(size)}, stdin=subprocess.DEVNULL)


def fault(tools: pathlib.Path, case: growth_inputs.Case) -> str:
    """An error message; empty if the cost grows in proportion to the input."""
    with tempfile.TemporaryDirectory() as work:
        try:
            small, large = (instructions(tools, case, pathlib.Path(work) / str(size), size)
                            for size in (case.size, case.size * STEP))
        except subprocess.TimeoutExpired:
            return f"took more than {SECONDS} s"
        except AssertionError as error:
            return str(error)
    if large > small * FACTOR:
        return f"{large / small:.1f} times the instructions for {STEP} times the input ({large / 1e6:.0f} million)"
    return ""


def main() -> int:
    tools, wanted = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2:]
    callgrind.skip_without_valgrind()
    cases = [case for case in growth_inputs.CASES if not wanted or case.name in wanted]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        faults = list(pool.map(lambda case: fault(tools, case), cases))
    for case, what in zip(cases, faults):
        if what:
            print(f"{case.name}: {what}")
    failed = sum(bool(what) for what in faults)
    print(f"{len(cases) - failed} passed, {failed} failed")
    return 1 if failed or not cases else 0


if __name__ == "__main__":
    sys.exit(main())
