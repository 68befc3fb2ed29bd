#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Input of four times the size takes about four times the instructions, in every tool.

growth_test.py FOLDER_OF_TOOLS [--all] [NAME...]

The inputs are in growth_inputs.py. A quadratic path takes sixteen times as many instructions, so FACTOR leaves room
for logarithms only. Instructions are counted where the processor time of larger inputs leaves a doubt, with --all for
every input: a run in valgrind takes a hundred times as long. Skips, and says so, without valgrind.
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
RUNS = 2  # of which the faster counts
LEAST_GROWTH = 2.5  # less says that a limit or the start of the tool hides what grows


def make(case: growth_inputs.Case, folder: pathlib.Path, size: int) -> dict:
    """Writes an input; returns how a tool is run on it."""
    folder.mkdir()
    case.write(size, folder)
    return {"cwd": folder, "env": {**os.environ, **case.variables(size)}, "stdin": subprocess.DEVNULL}


def instructions(tools: pathlib.Path, case: growth_inputs.Case, folder: pathlib.Path, size: int) -> int:
    how = make(case, folder, size)
    return callgrind.instructions(tools / case.command[0], *case.arguments(size), codes=(0, 1, 2), **how)


def processor_time(tools: pathlib.Path, case: growth_inputs.Case, folder: pathlib.Path, size: int) -> tuple:
    """The seconds of the fastest run, and its exit code."""
    how = make(case, folder, size)
    costs = []
    for _ in range(RUNS):
        with subprocess.Popen([str(tools / case.command[0]), *map(str, case.arguments(size))], stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL, **how) as run:
            _, status, used = os.wait4(run.pid, 0)
            run.returncode = os.waitstatus_to_exitcode(status)
        costs.append((used.ru_utime + used.ru_stime, run.returncode))
    return min(costs)


def is_doubtful(tools: pathlib.Path, case: growth_inputs.Case, work: pathlib.Path) -> bool:
    """Whether inputs of four and of sixteen times the size, where a quadratic part would outweigh all else, do not show
    that the cost grows in proportion."""
    (small, code), (large, large_code) = (processor_time(tools, case, work / f"time{size}", size)
                                          for size in (case.size * STEP, case.size * STEP * STEP))
    return code != large_code or code not in (0, 1, 2) or not small * LEAST_GROWTH <= large <= small * FACTOR


def fault(tools: pathlib.Path, case: growth_inputs.Case, counts_all: bool) -> tuple:
    """An error message, empty if the cost grows in proportion to the input, and whether instructions were counted."""
    with tempfile.TemporaryDirectory() as name:
        work = pathlib.Path(name)
        if not counts_all and not is_doubtful(tools, case, work):
            return "", False
        try:
            small, large = (instructions(tools, case, work / str(size), size) for size in (case.size, case.size * STEP))
        except AssertionError as error:
            return str(error), True
    if large > small * FACTOR:
        return f"{large / small:.1f} times the instructions for {STEP} times the input ({large / 1e6:.0f} million)", True
    return "", True


def main() -> int:
    tools, wanted = pathlib.Path(sys.argv[1]).resolve(), [word for word in sys.argv[2:] if word != "--all"]
    callgrind.skip_without_valgrind()
    cases = [case for case in growth_inputs.CASES if not wanted or case.name in wanted]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        results = list(pool.map(lambda case: fault(tools, case, "--all" in sys.argv), cases))
    for case, (what, _) in zip(cases, results):
        if what:
            print(f"{case.name}: {what}")
    failed = sum(bool(what) for what, _ in results)
    print(f"{len(cases) - failed} passed, {failed} failed, {sum(counted for _, counted in results)} by instructions")
    return 1 if failed or not cases else 0


if __name__ == "__main__":
    sys.exit(main())
