# SPDX-License-Identifier: BSD-3-Clause
"""python3 -m smurf COMMAND ...: runs a program of the toolchain with the arguments that follow.

    lint        smurf-lint: checks models and scenes
    lsp         smurf-lsp: a language server, for editors
    to-urdf     smurf2urdf: exports the URDF of a model
    from-urdf   urdf2smurf: makes a model around a URDF
    flatten     smurfs-flatten: expands a scene
    diff        smurf-diff: tells what differs between two versions
    view        smurf-view: shows a robot or a scene in the browser
    load-check  smurf-load-check: builds models and scenes in a physics engine
    mcp         a server of the Model Context Protocol, for assistants; needs smurf-tools[mcp]
    try-all     runs smurf2urdf or smurfs-flatten on every model or scene, and keeps nothing; for hooks
"""
import os
import pathlib
import subprocess
import sys
import sysconfig

from .try_all import find_on_path, try_all

PROGRAMS = {
    "lint": "smurf-lint",
    "lsp": "smurf-lsp",
    "to-urdf": "smurf2urdf",
    "from-urdf": "urdf2smurf",
    "flatten": "smurfs-flatten",
    "diff": "smurf-diff",
    "view": "smurf-view",
    "load-check": "smurf-load-check",
}


def find_program(name):
    """In the build folder or the prefix that the package is in, else on PATH; or None."""
    package = pathlib.Path(__file__).resolve().parent
    # TARGET/smurf of `pip install --target`, build/release/python/smurf and PREFIX/lib/python3/site-packages/smurf
    folders = [package.parents[i] / "bin" / name for i in (0, 1, 3) if i < len(package.parents)]
    if os.name == "nt":  # ENVIRONMENT/Lib/site-packages/smurf
        folders = [pathlib.Path(sysconfig.get_path("scripts"), f"{name}.exe")]
    for program in folders:
        if program.is_file() and os.access(program, os.X_OK):
            return str(program)
    return find_on_path(name)


def main(arguments):
    if not arguments or arguments[0] in ("-h", "--help"):
        print(__doc__.strip())
        return 0 if arguments else 2
    if arguments[0] == "try-all":
        return try_all(arguments[1:], find_program)
    if arguments[0] == "mcp":
        from .mcp_server import main as serve
        return serve(arguments[1:], find_program)
    name = PROGRAMS.get(arguments[0])
    if name is None:
        commands = ", ".join([*PROGRAMS, "mcp", "try-all"])
        print(f"smurf: there is no command '{arguments[0]}'; the commands are {commands}", file=sys.stderr)
        return 2
    program = find_program(name)
    if program is None:
        print(f"smurf: the program {name} is neither beside this module nor on PATH; install it, or run\n"
              "smurf.check(path) in Python, which needs no program", file=sys.stderr)
        return 2
    if os.name == "nt":  # where execv() does not wait
        return subprocess.call([program, *arguments[1:]])
    os.execv(program, [name, *arguments[1:]])


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
