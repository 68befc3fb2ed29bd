# SPDX-License-Identifier: BSD-3-Clause
"""Counts the instructions of a tool with valgrind."""
import functools
import pathlib
import re
import resource
import shutil
import subprocess
import sys

SKIPPED = 77  # to CTest
# Valgrind takes fifty times as long: the clock of the tools would end runs that are honest.
HAVE_CLOCK = {"smurf-lint", "smurf2urdf", "urdf2smurf", "smurfs-flatten", "smurf-diff"}
SECONDS = 600  # of processor time, after which a run is ended: no clock on the wall may decide


def skip_without_valgrind():
    if shutil.which("valgrind") is None:
        print("SKIPPED: no valgrind; scripts/setup --dev installs it")
        sys.exit(SKIPPED)


def instructions(tool: pathlib.Path, *arguments, codes=(0, 1), **how) -> int:
    """The instructions of the tool and its child processes. `codes`: allowed exit codes; `how`: arguments of subprocess.run."""
    limit = functools.partial(resource.setrlimit, resource.RLIMIT_CPU, (SECONDS, SECONDS))
    run = subprocess.run(
        ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", "--trace-children=yes", str(tool),
         *(["--max-seconds=0"] if tool.name in HAVE_CLOCK else []), *map(str, arguments)], capture_output=True, text=True, errors="replace", check=False, preexec_fn=limit, **how)
    if run.returncode not in codes:
        raise AssertionError(f"ended with {run.returncode}: {run.stderr[-500:]}")
    return sum(int(count) for count in re.findall(r"Collected : (\d+)", run.stderr))
