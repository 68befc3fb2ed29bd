#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Loads SMURF models, URDFs and scenes with Phobos 2.

usage: PYTHONPATH=PHOBOS phobos_smurf.py    reads paths from standard input

PHOBOS is a clone of dfki-ric/phobos; Debian has what it needs (python3-numpy, -scipy, -yaml, -lxml, -networkx, -pydot,
-collada, -pil) but for trimesh. Prints a line of JSON for each file: its verdict, what Phobos made of it, and what it said.
"""
import json
import os
import signal
import sys

DEPTH = 6
SECONDS = 60
UNTOLD = ("inputfile", "excludes", "returns", "_class_linkables")
LISTS = ("links", "joints", "materials", "motors", "sensors", "poses", "submechanisms", "exoskeletons", "interfaces",
         "transmissions", "generic_annotations", "entities")


def name_of(value):
    name = getattr(value, "name", None)
    return name if isinstance(name, str) else type(value).__name__


def plain(value, depth=0):
    """Numbers, texts and lists of them: the contents of a robot without references between its parts."""
    if isinstance(value, (bool, int, float, str)) or value is None:
        return value
    if isinstance(value, dict):
        return {str(key): plain(one, depth + 1) for key, one in value.items()} if depth < DEPTH else "..."
    if isinstance(value, (list, tuple)):
        return [plain(one, depth + 1) for one in value]
    if hasattr(value, "tolist"):
        return plain(value.tolist(), depth)
    if depth >= DEPTH or not hasattr(value, "__dict__"):
        return name_of(value)
    members = {"is": type(value).__name__}
    for key, one in sorted(vars(value).items()):
        if key.startswith("_related") or key in UNTOLD:
            continue
        is_above = key.startswith("_") and key != "_collisions"  # name of its parent
        members[key] = name_of(one) if is_above and hasattr(one, "__dict__") else plain(one, depth + 1)
    return members


def parts_of(model, folder):
    robot = {}
    for kind in LISTS:
        for number, one in enumerate(getattr(model, kind, None) or []):
            text = json.dumps(plain(one), default=str).replace(folder, "")
            robot[f"{kind}:{number}"] = text
    return robot


class Hangs(BaseException):
    """Phobos does not catch it."""


def ring(*_):
    raise Hangs


def judge(path):
    from phobos.core import Robot
    from phobos.core.multiple import World
    is_scene = path.endswith((".smurfs", ".smurfa"))
    signal.alarm(SECONDS)
    try:
        model = World(inputfile=path) if is_scene else Robot(inputfile=path)
        robot = parts_of(model, os.path.dirname(os.path.dirname(path)))
    except Hangs:
        return {"verdict": "crashes", "why": "hangs"}
    except Exception as error:  # after any exception, there is no robot
        return {"verdict": "refuses", "why": f"{type(error).__name__}: {error}"[:200]}
    finally:
        signal.alarm(0)
    if not is_scene and not model.links:
        return {"verdict": "refuses", "why": "a robot without links"}
    return {"verdict": "takes", "robot": robot}


def main():
    out = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)  # Phobos logs to standard output
    signal.signal(signal.SIGALRM, ring)
    for line in sys.stdin:
        path = line.rstrip("\n")
        print(json.dumps({"file": path, **judge(path)}), file=out, flush=True)


if __name__ == "__main__":
    main()
