#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the test programs, and every tool on the fixtures, under valgrind: memcheck.py BIN [NAME...]

NAME leaves all but the programs whose name holds it. Only what valgrind finds counts: assertions about
time fail there.
"""
import os
import pathlib
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

HERE = pathlib.Path(__file__).resolve().parent
FIXTURES = HERE.parent / "build/fixtures"
FOUND = 99
VALGRIND = ["valgrind", "--quiet", f"--suppressions={HERE / 'memcheck.supp'}", f"--error-exitcode={FOUND}",
            "--leak-check=full", "--errors-for-leak-kinds=definite", "--show-leak-kinds=definite", "--num-callers=30"]
# Reads every file truncated at every byte, which takes hours here; it runs with AddressSanitizer. The other one
# requests data that may be absent.
LEFT_OUT = ("hostile_test", "consumers_test")
# Their children crash on purpose; the tool covers the same code.
SILENT_CHILDREN = {"load_check_test": ["--child-silent-after-fork=yes"]}
# Programs that repeat themselves with random input.
FEWER = {"SMURF_TEST_CASES": "200"}
TOOLS = {
    "smurf-lint": lambda path, out: ["--unsafe-fixes", "--diff", path],
    "smurf2urdf": lambda path, out: [path, "--force", "-o", out],
    "urdf2smurf": lambda path, out: [path, "--dry-run", "-o", out],
    "smurfs-flatten": lambda path, out: [path, "--links", "-o", out],
    "smurf-diff": lambda path, out: [path, path],
    "smurf-view": lambda path, out: [path, "--no-open", "-o", out],
    "smurf-load-check": lambda path, out: [path, "--time", "0.01", "--time-limit", "60"],
}
KINDS = {"smurf2urdf": (".smurf",), "urdf2smurf": (".urdf",)}


def runs(binaries, out):
    """(title, command)"""
    for program in sorted(binaries.iterdir()):
        if program.name.endswith("_test") and program.name not in LEFT_OUT:
            yield program.name, [program]
        elif program.name.startswith("replay_"):
            yield program.name, [program, FIXTURES / "crashes", FIXTURES / "models"]
    entries = [path for folder in ("models", "scenes") for path in sorted((FIXTURES / folder).rglob("*"))
               if path.suffix in (".smurf", ".smurfs", ".smurfa", ".urdf")]
    bad = sorted(path for path in (FIXTURES / "rules").glob("*/bad/*") if path.suffix in (".smurf", ".smurfs", ".urdf"))
    for tool, words in TOOLS.items():
        kinds = KINDS.get(tool, (".smurf", ".smurfs", ".smurfa", ".urdf"))
        # A tenth of the rules' fixtures for the tools that read one file; the linter reads all at once.
        for path in entries + ([] if tool == "smurf-lint" else bad[::10]):
            if path.suffix in kinds:
                yield f"{tool} {path.relative_to(FIXTURES)}", [binaries / tool, *words(path, out / f"{tool}.out")]
    yield "smurf-lint fixtures", [binaries / "smurf-lint", "--format", "json", FIXTURES / "rules"]


def main():
    binaries = pathlib.Path(sys.argv[1]).resolve()
    wanted = sys.argv[2:]
    found = count = 0
    with tempfile.TemporaryDirectory() as out:
        def check(run):
            title, command = run
            # In a temporary folder, with all files that a program leaves in its current folder.
            return title, subprocess.run([*VALGRIND, *SILENT_CHILDREN.get(title, []), *command], capture_output=True,
                                         text=True, errors="replace", cwd=out, env={**os.environ, **FEWER}, check=False)

        chosen = [run for run in runs(binaries, pathlib.Path(out))
                  if not wanted or any(name in run[0] for name in wanted)]
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            for title, done in pool.map(check, chosen):
                count += 1
                if done.returncode == FOUND or "\n==" in "\n" + done.stderr:
                    found += 1
                    lines = [line for line in done.stderr.splitlines() if line.startswith("==")]
                    print(f"{title}:\n" + "\n".join(lines[:60]), flush=True)
    print(f"{count} runs under valgrind, {found} with findings")
    return 1 if found or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
