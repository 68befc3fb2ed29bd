# SPDX-License-Identifier: BSD-3-Clause
"""python3 -m smurf COMMAND ...: runs a program of the toolchain with the arguments that follow.

    lint        smurf-lint: checks models and scenes
    to-urdf     smurf2urdf: exports the URDF of a model
    from-urdf   urdf2smurf: makes a model around a URDF
    flatten     smurfs-flatten: expands a scene
    load-check  smurf-load-check: builds models and scenes in a physics engine
"""
import os
import pathlib
import shutil
import sys

PROGRAMS = {
    "lint": "smurf-lint",
    "to-urdf": "smurf2urdf",
    "from-urdf": "urdf2smurf",
    "flatten": "smurfs-flatten",
    "load-check": "smurf-load-check",
}


def find_program(name):
    """In the package, in the build folder or the prefix that it is in, else on PATH; or None."""
    package = pathlib.Path(__file__).resolve().parent
    beside = [package / "bin"]
    # build/release/python/smurf and PREFIX/lib/python3/dist-packages/smurf
    beside += [package.parents[i] / "bin" for i in (1, 3) if i < len(package.parents)]
    for folder in beside:
        program = folder / name
        if program.is_file() and os.access(program, os.X_OK):
            return str(program)
    return shutil.which(name)


def main(arguments):
    if not arguments or arguments[0] in ("-h", "--help"):
        print(__doc__.strip())
        return 0 if arguments else 2
    name = PROGRAMS.get(arguments[0])
    if name is None:
        print(f"smurf: there is no command '{arguments[0]}'; the commands are {', '.join(PROGRAMS)}", file=sys.stderr)
        return 2
    program = find_program(name)
    if program is None:
        print(f"smurf: the program {name} is neither beside this module nor on PATH; install it, or run\n"
              "smurf.check(path) in Python, which needs no program", file=sys.stderr)
        return 2
    os.execv(program, [name, *arguments[1:]])


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
