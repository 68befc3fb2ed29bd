# SPDX-License-Identifier: BSD-3-Clause
"""Conversions by the programs, and all rounds of fixes."""
from __future__ import annotations

import os
import subprocess
from collections.abc import Iterable
from typing import Any, Dict, List, Union

from ._errors import Error

Path = Union[str, "os.PathLike[str]"]
ROUNDS = 20


def convert(source: Path, output: Path, arguments: Dict[str, Any] | None = None, **options: Any) -> str:
    """Converts a file into another one, with the program for it, and returns what the program says.

        smurf.convert("arm.urdf", "arm/")                          # urdf2smurf: a SMURF model in a new folder
        smurf.convert("arm.smurf", "arm.urdf", preset="ros2")      # smurf2urdf
        smurf.convert("arm.smurf", "arm.xml", format="mjcf", copy_assets="assets")  # smurfs-flatten

    The ending of `output` tells the program: a folder (`arm/`, or one that exists), `.urdf` for a model, and all
    formats of smurfs-flatten. `options` are the options of the program: `copy_meshes=True` is --copy-meshes,
    `package={"arm": "/robots/arm"}` is --package arm=/robots/arm. `arguments` are those of a xacro file.
    Raises smurf.Error with the words of the program when nothing was written.
    """
    from .__main__ import find_program  # not before, because `python3 -m smurf` runs it

    source, output = os.fspath(source), os.fspath(output)
    name = _program_for(source, output, options)
    program = find_program(name)
    if program is None:
        raise Error(f"the program {name} is neither beside this module nor on PATH; install smurf-tools")
    given = [f"{key}:={value}" for key, value in (arguments or {}).items()]
    command = [program, *_words(options), "-o", output, "--", source, *given]
    done = subprocess.run(command, capture_output=True, text=True, errors="replace", check=False)
    if done.returncode != 0:
        problem = Error(f"{name} ended with exit code {done.returncode}")
        if done.stderr.strip():
            problem.args = (done.stderr.strip(),)  # lines, in which the program has escaped what a terminal would obey
        raise problem
    return done.stderr.strip()


def _program_for(source: str, output: str, options: Dict[str, Any]) -> str:
    ending = os.path.splitext(output)[1].lower()
    is_folder = output.endswith(("/", os.sep)) or os.path.isdir(output) or (ending == "" and "format" not in options)
    if is_folder:
        return "urdf2smurf"
    is_scene = source.lower().endswith((".smurfs", ".smurfa", ".svg", ".zsmurfs", ".zsmurfa"))
    is_urdf = ending == ".urdf" and "format" not in options and not is_scene
    return "smurf2urdf" if is_urdf else "smurfs-flatten"


def _words(options: Dict[str, Any]) -> List[str]:
    words: List[str] = []
    for key, value in options.items():
        option = "--" + key.replace("_", "-")
        if value is None or value is False:
            continue
        if value is True:
            words.append(option)
        elif isinstance(value, dict):
            words += [word for name, one in value.items() for word in (option, f"{name}={one}")]
        elif isinstance(value, (list, tuple, set)):
            words += [option, ",".join(map(str, value))]
        else:
            words += [option, str(value)]
    return words


def fix(path: Path | Iterable[Path], unsafe: bool = False, infos: bool = False, **settings: Any) -> Dict[str, bytes]:
    """The files that change when the safe fixes (or all fixes) of errors and warnings (and infos) are applied.

    A dict from paths to bytes; nothing is written:

        for path, content in smurf.fix("robots/").items():
            pathlib.Path(path).write_bytes(content)

    `settings` are the keyword arguments of smurf.check().
    """
    from ._smurf import Session  # conversions need only the programs

    session = Session()
    fixed: Dict[str, bytes] = {}
    paths: Any = path if isinstance(path, (str, bytes, os.PathLike)) else list(path)
    for _ in range(ROUNDS):
        texts = session.check(paths, **settings).fixed(unsafe, infos)
        if not texts:
            return fixed
        for name, content in texts.items():
            session.set_text(name, content)
        fixed.update(texts)
    raise Error("the fixes undo each other; this is a bug of smurf-lint")
