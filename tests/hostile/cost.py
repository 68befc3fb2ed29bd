# SPDX-License-Identifier: BSD-3-Clause
"""What a run of a tool costs, and whether that is within its bound on this machine.

A bound is given in seconds of processor time on the machine where PEER_SECONDS were measured. A run that takes longer is
compared with a peer, an honest file that the same build of smurf-lint reads in the same minute, and is repeated: what is
judged is work, and neither the machine nor what else runs on it.
"""
import functools
import os
import pathlib
import statistics
import sys
import tempfile

import inputs

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "cli"))
import cli  # noqa: E402

SECONDS = 2
MEGABYTES = 300
PEER_BYTES = 4_000_000
PEER_SECONDS = 0.13
TRIES = 3
NET = 30  # times the bound, also with sanitizers: where the system ends a run


class Run:
    """A run of a tool in a separate folder: its end, its cost, and its files."""

    def __init__(self, arguments, folder, seconds=SECONDS):
        said = folder / "said"
        limit = f'ulimit -t {round(seconds * NET)}; cd "$0" && exec env -i PATH=/nonexistent "$@"'
        with open(said, "wb") as stream:
            child = os.posix_spawn(
                "/bin/sh", ["sh", "-c", limit, str(folder), *map(str, arguments)], {"PATH": "/usr/bin:/bin"},
                file_actions=[(os.POSIX_SPAWN_OPEN, 0, "/dev/null", os.O_RDONLY, 0),
                              (os.POSIX_SPAWN_DUP2, stream.fileno(), 1),
                              (os.POSIX_SPAWN_DUP2, stream.fileno(), 2)])
            _, status, usage = os.wait4(child, 0)
        self.code = os.waitstatus_to_exitcode(status)  # negative: a signal
        self.seconds = usage.ru_utime + usage.ru_stime
        self.megabytes = usage.ru_maxrss / 1024
        with open(said, "rb") as stream:
            self.said = stream.read(1 << 16)


@functools.cache
def has_sanitizer(tool: pathlib.Path) -> bool:
    return cli.is_sanitized(tool)


@functools.cache
def peer_text() -> str:
    part = ('<link name="l{0}"/><joint name="j{0}" type="revolute"><parent link="b"/><child link="l{0}"/><axis xyz="0 0 1"/>'
            '<limit lower="-1" upper="1" effort="1" velocity="1"/></joint>\n').replace("{0}", "{}")
    return '<robot name="r"><link name="b"/>\n' + inputs.repeat(part, PEER_BYTES) + "</robot>\n"


def peer_seconds(tools: pathlib.Path) -> float:
    """What the honest file takes now."""
    with tempfile.TemporaryDirectory(prefix="smurf-peer-") as name:
        folder = pathlib.Path(name)
        (folder / ".git").mkdir()
        (folder / "r.urdf").write_text(peer_text())
        runs = [Run([tools / "smurf-lint", "-q", "r.urdf"], folder) for _ in range(TRIES)]
    if any(run.code not in (0, 1) for run in runs):
        raise AssertionError(f"the honest file ended with {[run.code for run in runs]}")
    return statistics.median(run.seconds for run in runs)


def excess(tools: pathlib.Path, run: Run, seconds: float, again) -> str:
    """By how much a run has exceeded its bound; empty: it has not. `again()` repeats it."""
    pace = 1.0
    for attempt in range(TRIES):
        if run.seconds <= seconds * pace:
            return ""
        pace = max(1.0, peer_seconds(tools) / PEER_SECONDS)
        if run.seconds <= seconds * pace:
            return ""
        if attempt + 1 < TRIES:
            run = again()
    return f"took {run.seconds:.1f} s, where {seconds * pace:.1f} s are allowed"


def faults(tools: pathlib.Path, make_run, codes=(0, 1, 2), seconds=SECONDS, megabytes=MEGABYTES):
    """What is wrong with the cost or the end of the run that `make_run()` makes."""
    run = make_run()
    if run.code not in codes:
        yield f"ended with {run.code}"
    if what := excess(tools, run, seconds, make_run):
        yield what
    if run.megabytes > megabytes and not has_sanitizer(tools / "smurf-lint"):
        yield f"took {run.megabytes:.0f} MB"
