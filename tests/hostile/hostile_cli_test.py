#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The tools on files that nobody means well with: a verdict, in bounded time and memory, and no
output unless all of it.

hostile_cli_test.py [--quick] FOLDER_OF_TOOLS

--quick runs one case of 61, a prime number, so that every kind has its turn.
"""
import itertools
import os
import pathlib
import re
import shutil
import sys
import tempfile

import inputs

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "cli"))
import cli  # noqa: E402

SECONDS = 2
MEGABYTES = 300
# The arguments of each tool; {} is the input. Results go to `out`.
COMMANDS = {
    "smurf-lint": ["{}"],
    "smurf2urdf": ["{}", "-o", "out/robot.urdf"],
    "urdf2smurf": ["{}", "-o", "out/model"],
    "smurfs-flatten": ["{}", "-o", "out/scene.json"],
    "smurf-diff": ["{}", "{}", "-o", "out/differences"],
    "smurf-load-check": ["{}", "--time", "0.01", "--time-limit", "1"],
}


class Run:
    """A run of a tool in a separate folder: its end, its cost, and its files."""

    def __init__(self, arguments, folder):
        said = folder / "said"
        with open(said, "wb") as stream:
            child = os.posix_spawn(
                "/usr/bin/env", ["env", "-C", str(folder), *arguments], {"PATH": "/nonexistent"},
                file_actions=[(os.POSIX_SPAWN_OPEN, 0, "/dev/null", os.O_RDONLY, 0),
                              (os.POSIX_SPAWN_DUP2, stream.fileno(), 1),
                              (os.POSIX_SPAWN_DUP2, stream.fileno(), 2)])
            _, status, usage = os.wait4(child, 0)
        self.code = os.waitstatus_to_exitcode(status)  # negative: a signal
        self.seconds = usage.ru_utime + usage.ru_stime
        self.megabytes = usage.ru_maxrss / 1024
        with open(said, "rb") as stream:
            self.said = stream.read(1 << 16)


def faults(case, run, folder, has_sanitizer):
    written = sorted(str(path.relative_to(folder)) for path in (folder / "out").rglob("*") if path.is_file())
    if run.code not in case.codes:
        yield f"ended with {run.code}"
    if run.code != 0 and not run.said.strip():
        yield "said nothing"
    if run.code != 0 and written:
        yield f"wrote {written[:3]}"
    if any(".smurf-" in path for path in written):
        yield "left a temporary file"
    if re.search(rb"[\x00-\x08\x0b-\x1f\x7f]", run.said):
        yield "wrote a control character"
    scale = case.scale * (15 if has_sanitizer else 1)
    if run.seconds > SECONDS * scale:
        yield f"took {run.seconds:.1f} s"
    if run.megabytes > MEGABYTES * case.scale and not has_sanitizer:
        yield f"took {run.megabytes:.0f} MB"


def main():
    arguments = [argument for argument in sys.argv[1:] if argument != "--quick"]
    step = 61 if len(arguments) < len(sys.argv) - 1 else 1
    tools = pathlib.Path(arguments[0]).resolve()
    has_sanitizer = {tool: cli.is_sanitized(tools / tool) for tool in COMMANDS}
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
                (place / "out").mkdir()
                words = [tool_word for word in (case.words or words)
                         for tool_word in ([str(case.main)] if word == "{}" else [word])]
                run = Run([str(tools / tool), *words], place)
                count += 1
                title = f"{tool}: {case.title}"
                failures += [f"{title}: {fault}" for fault in faults(case, run, place, has_sanitizer[tool])]
                slowest = max(slowest, (title, run.seconds / case.scale), key=lambda one: one[1])
                largest = max(largest, (title, run.megabytes / case.scale), key=lambda one: one[1])
                shutil.rmtree(place / "out")
            case.remove(place)
    print("\n".join(failures))
    print(f"slowest: {slowest[0]} ({slowest[1]:.2f} s); largest: {largest[0]} ({largest[1]:.0f} MB)")
    print(f"{count} runs, {len(failures)} failures")
    return 1 if failures or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
