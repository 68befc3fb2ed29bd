#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""try_all.py smurf2urdf|smurfs-flatten [OPTION]... [-- PATH...]: converts every model or scene, and discards the results.

The files are those that smurf-lint would check in the PATHs, or in the current folder; the OPTIONs are those of the
program. The programs are those on PATH. For hooks; ends with the highest exit code of the program.
"""
import subprocess
import sys

ENDINGS = {"smurf2urdf": (".smurf",), "smurfs-flatten": (".smurfs", ".smurfa")}


def try_all(arguments):
    if not arguments or arguments[0] not in ENDINGS:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    program, *rest = arguments
    split = rest.index("--") if "--" in rest else len(rest)
    options, paths = rest[:split], rest[split + 1 :]
    listed = subprocess.run(["smurf-lint", "--list-files", "--", *paths], stdout=subprocess.PIPE, check=False)
    if listed.returncode != 0:
        return listed.returncode
    code = 0
    for file in listed.stdout.decode(errors="surrogateescape").splitlines():
        if file.lower().endswith(ENDINGS[program]):
            # smurf-lint shows control characters in names as `\n`, and bytes that are no UTF-8 as U+FFFD; another file may
            # have just that name.
            if "\\" in file or "\ufffd" in file:
                print(f"{program}: cannot tell which file is meant by '{file}': rename it", file=sys.stderr)
                code = 2
                continue
            done = subprocess.run([program, *options, "--", file], stdout=subprocess.DEVNULL, check=False)
            code = max(code, done.returncode)
    return code


if __name__ == "__main__":
    sys.exit(try_all(sys.argv[1:]))
