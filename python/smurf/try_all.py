#!/usr/bin/env -S python3 -I
# SPDX-License-Identifier: BSD-3-Clause
"""try_all.py smurf2urdf|smurfs-flatten [OPTION]... [-- PATH...]: converts every model or scene, and discards the results.

The files are those that smurf-lint would check in the PATHs, or in the current folder; the OPTIONs are those of the
program. The programs are those on PATH. For hooks; ends with the highest exit code of the program.
"""
import os
import subprocess
import sys

ENDINGS = {"smurf2urdf": (".smurf",), "smurfs-flatten": (".smurfs", ".smurfa")}


def find_on_path(name):
    """The program in a folder of PATH, or None. Never in the current folder, where Windows looks first: the checked files
    lie there."""
    endings = (".exe",) if os.name == "nt" else ("",)
    for folder in os.environ.get("PATH", os.defpath).split(os.pathsep):
        for ending in endings:
            program = os.path.join(folder, name + ending)
            if os.path.isabs(folder) and os.path.isfile(program) and os.access(program, os.X_OK):
                return program
    return None


def try_all(arguments, find=find_on_path):
    if not arguments or arguments[0] not in ENDINGS:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    name, *rest = arguments
    lint, program = find("smurf-lint"), find(name)
    if lint is None or program is None:
        print(f"{name}: the program {name if lint else 'smurf-lint'} is not on PATH; install smurf-tools", file=sys.stderr)
        return 2
    split = rest.index("--") if "--" in rest else len(rest)
    options, paths = rest[:split], rest[split + 1 :]
    listed = subprocess.run([lint, "--list-files", "--", *paths], stdout=subprocess.PIPE, check=False)
    if listed.returncode != 0:
        return listed.returncode
    code = 0
    for file in listed.stdout.decode(errors="surrogateescape").splitlines():
        if file.lower().endswith(ENDINGS[name]):
            # smurf-lint shows control characters in names as `\n`, and bytes that are no UTF-8 as U+FFFD; another file may
            # have just that name.
            if "\\" in file or "\ufffd" in file:
                print(f"{name}: cannot tell which file is meant by '{file}': rename it", file=sys.stderr)
                code = 2
                continue
            done = subprocess.run([program, *options, "--", file], stdout=subprocess.DEVNULL, check=False)
            code = max(code, done.returncode)
    return code


if __name__ == "__main__":
    sys.exit(try_all(sys.argv[1:]))
