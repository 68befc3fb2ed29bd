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
import re
import shutil
import subprocess
import sys
import tempfile

import growth_inputs

STEP = 4
FACTOR = 5.5
SECONDS = 120


def instructions(tools: pathlib.Path, case: growth_inputs.Case, folder: pathlib.Path, size: int) -> int:
    """Of the tool and its child processes."""
    folder.mkdir()
    case.write(size, folder)
    run = subprocess.run(
        ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", "--trace-children=yes",
         str(tools / case.command[0]), *case.arguments(size)],
        cwd=folder, capture_output=True, text=True, errors="replace", timeout=SECONDS,
        env={**os.environ, **case.variables(size)}, stdin=subprocess.DEVNULL)
    if run.returncode not in (0, 1, 2):
        raise AssertionError(f"ended with {run.returncode}: {run.stderr[-500:]}")
    return sum(int(count) for count in re.findall(r"Collected : (\d+)", run.stderr))


def fault(tools: pathlib.Path, case: growth_inputs.Case) -> str:
    """Empty when the case grows as its input does."""
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
    if shutil.which("valgrind") is None:
        print("SKIPPED: no valgrind; scripts/setup --dev installs it")
        return 77
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
