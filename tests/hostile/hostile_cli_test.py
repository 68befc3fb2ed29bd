#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The tools on files that nobody means well with: a verdict, in bounded time and memory, and no
output unless all of it.

hostile_cli_test.py [--quick] FOLDER_OF_TOOLS

--quick runs one case of 61, a prime number, so that every kind has its turn.
"""
import itertools
import pathlib
import re
import shutil
import sys
import tempfile

import cost
import inputs

# The arguments of each tool; {} is the input. Results go to `out`.
COMMANDS = {
    "smurf-lint": ["{}"],
    "smurf2urdf": ["{}", "-o", "out/robot.urdf"],
    "urdf2smurf": ["{}", "-o", "out/model"],
    "smurfs-flatten": ["{}", "-o", "out/scene.json"],
    "smurf-diff": ["{}", "{}", "-o", "out/differences"],
    "smurf-load-check": ["{}", "--time", "0.01", "--time-limit", "1"],
}


def faults(tools, case, make_run, folder):
    """What is wrong with a run, which is made here, and the run."""
    run = make_run()
    written = sorted(str(path.relative_to(folder)) for path in (folder / "out").rglob("*") if path.is_file())
    found = []
    if run.code not in case.codes:
        found.append(f"ended with {run.code}")
    if run.code != 0 and not run.said.strip():
        found.append("said nothing")
    if run.code != 0 and written:
        found.append(f"wrote {written[:3]}")
    if any(".smurf-" in path for path in written):
        found.append("left a temporary file")
    if re.search(rb"[\x00-\x08\x0b-\x1f\x7f]", run.said):
        found.append("wrote a control character")
    if what := cost.excess(tools, run, cost.SECONDS * case.scale, make_run):
        found.append(what)
    if run.megabytes > cost.MEGABYTES * case.scale and not cost.has_sanitizer(tools / "smurf-lint"):
        found.append(f"took {run.megabytes:.0f} MB")
    return found, run


def main():
    arguments = [argument for argument in sys.argv[1:] if argument != "--quick"]
    step = 61 if len(arguments) < len(sys.argv) - 1 else 1
    tools = pathlib.Path(arguments[0]).resolve()
    count = 0
    failures = []
    slowest = largest = ("", 0)
    with tempfile.TemporaryDirectory(prefix="smurf-hostile-") as name:
        folder = pathlib.Path(name)
        for number, case in enumerate(itertools.islice(inputs.cases(), 0, None, step)):
            place = folder / str(number)
            case.write(place)
            for tool, words in COMMANDS.items():
                if case.tools and tool not in case.tools:
                    continue
                words = [tool_word for word in (case.words or words)
                         for tool_word in ([str(case.main)] if word == "{}" else [word])]

                def make_run():
                    shutil.rmtree(place / "out", ignore_errors=True)
                    (place / "out").mkdir()
                    return cost.Run([tools / tool, *words], place, cost.SECONDS * case.scale)

                found, run = faults(tools, case, make_run, place)
                count += 1
                title = f"{tool}: {case.title}"
                failures += [f"{title}: {fault}" for fault in found]
                slowest = max(slowest, (title, run.seconds / case.scale), key=lambda one: one[1])
                largest = max(largest, (title, run.megabytes / case.scale), key=lambda one: one[1])
            case.remove(place)
    print("\n".join(failures))
    print(f"slowest: {slowest[0]} ({slowest[1]:.2f} s); largest: {largest[0]} ({largest[1]:.0f} MB)")
    print(f"{count} runs, {len(failures)} failures")
    return 1 if failures or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
