# SPDX-License-Identifier: BSD-3-Clause
"""run_reader.hpp for readers with a Python module: NAME < list of files.

Each file is read by a child, for readers crash and do not come to an end; what they print is dropped.
"""
import json
import math
import os
import pathlib
import resource
import signal
import sys

SECONDS = 20  # of processor time, after which a reader is hanging


def plain(value):
    """JSON has neither nan nor infinity, and both are to be told from what is absent."""
    if isinstance(value, dict):
        return {key: plain(one) for key, one in value.items()}
    if isinstance(value, str) or value is None or isinstance(value, (bool, int)):
        return value
    if hasattr(value, "__iter__"):
        return [plain(one) for one in value]
    number = float(value)
    return number if math.isfinite(number) else str(number)


def package_of(file):
    """The folder with a package.xml around the file; for paths_record.py, which says that packages are given."""
    return next(folder for folder in pathlib.Path(file).parents if (folder / "package.xml").exists())


def said_of(read, file):
    try:
        robot = read(file)
    except Exception as error:  # pylint: disable=broad-except  # any exception of the reader
        return {"file": file, "verdict": "refuses", "message": str(error).split("\n", maxsplit=1)[0]}
    return {"file": file, "verdict": "takes", "message": "", "robot": plain(robot)}


def be_child(pipe, read, file):
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 1)
    os.dup2(nowhere, 2)
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 1))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    signal.alarm(6 * SECONDS)
    text = (json.dumps(said_of(read, file)) + "\n").encode()
    while text:
        text = text[os.write(pipe, text):]
    os._exit(0)  # pylint: disable=protected-access  # without what modules do at the end


def read_apart(read, file):
    end, pipe = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(end)
        be_child(pipe, read, file)
    os.close(pipe)
    with os.fdopen(end, "rb") as stream:
        text = stream.read().decode()
    _, status = os.waitpid(child, 0)
    if status == 0 and text.endswith("\n"):
        return text
    how = f"signal {os.WTERMSIG(status)}" if os.WIFSIGNALED(status) else "ends the process"
    return json.dumps({"file": file, "verdict": "crashes", "message": how}) + "\n"


def run_reader(read):
    for line in sys.stdin:
        sys.stdout.write(read_apart(read, line.rstrip("\n")))
        sys.stdout.flush()
