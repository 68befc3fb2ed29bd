# SPDX-License-Identifier: BSD-3-Clause
"""Does libsmurf/src/mjcf/schema.def say what MuJoCo reads? Skipped without MuJoCo 4.0 for Python.

Each attribute is written into an element where the table has it: with a text, with too few and too many numbers, with
words. Only messages about the attribute itself count; what MuJoCo says of the rest of the model does not.
"""
import json
import os
import pathlib
import re
import signal
import sys

try:
    import mujoco
except ImportError:
    installed = pathlib.Path(__file__).resolve().parents[2] / "build/readers/python/bin/python"
    if installed.exists() and pathlib.Path(sys.prefix) != installed.parents[1]:
        os.execv(installed, [installed, *sys.argv])
    print("skipped: there is no module mujoco; scripts/setup --readers installs it")
    sys.exit(77)
if not mujoco.__version__.startswith("4.0"):
    print(f"skipped: MuJoCo is {mujoco.__version__}, not 4.0")
    sys.exit(77)

SCHEMA = pathlib.Path(__file__).resolve().parents[2] / "libsmurf/src/mjcf/schema.def"
SETS = {"b": "false|true", "a": "false|true|auto", "e": "disable|enable"}
NAMED = {"objtype": "body", "reftype": "body", "role": "rgb", "builtin": "sphere"}  # values that MuJoCo accepts; other required attributes take any
MANY = 41


def rows(text):
    """Path and attributes of each element."""
    path = []
    for depth, name, attributes in re.findall(r'SMURF_MJCF\((\d+), "(\w+)", \'.\', "([^"]*)"\)', text):
        path = path[:int(depth)] + [name]
        yield tuple(path), [one for one in attributes.split() if not one.startswith("(")]


def document(path, attributes):
    path = ["mujoco", "worldbody", *path[1:]] if path[1:2] == ("body",) else list(path)
    opened = "".join(f"<{one}>" for one in path[:-1])
    written = "".join(f' {key}="{value}"' for key, value in attributes.items())
    return f"{opened}<{path[-1]}{written}/>" + "".join(f"</{one}>" for one in reversed(path[:-1]))


def wanted(said):
    """The attributes that a message asks for: required, one of several, or together with others."""
    if one := re.search(r"required attribute missing: '(\w+)'", said):
        return [one[1]]
    if one := re.search(r"one of (.*) must be specified", said):
        return re.findall(r"\w+", re.findall(r"\([^)]*\)|'\w+'", one[1])[-1])
    together = re.search(r"attributes (.*) must be specified together", said)
    return re.findall(r"'(\w+)'", together[1]) if together else []


def message(path, attributes, but=""):
    """The first line of what MuJoCo says, with all attributes that it asks for, but one."""
    attributes = dict(attributes)
    for _ in range(8):
        try:
            mujoco.MjModel.from_xml_string(document(path, attributes))
            return ""
        except ValueError as error:
            said = str(error).split("\n")[0]
        missing = [one for one in wanted(said) if one not in attributes and one != but]
        if not missing:
            return said
        attributes.update({one: NAMED.get(one, "1") for one in missing})
    return said


def faults(path, attribute):
    is_required = attribute.endswith("!")
    name, _, kind = attribute.rstrip("!").partition(":")

    def says(value):
        return message(path, {**({"builtin": "sphere"} if name == "params" else {}), name: value})

    found = []
    if is_required and f"'{name}'" not in message(path, {}, name):
        found.append("is not required")
    text = says("zz!")
    is_format, is_word = f"bad format in attribute '{name}'" in text, "invalid keyword: 'zz!'" in text
    is_format = is_format or f"problem reading attribute '{name}'" in text
    numbers = re.fullmatch(r"(i?)(\d+)(?:-(\d+)|(\+))?", kind)
    if not kind:
        return found + (["is no text"] if is_format or is_word else [])
    if not numbers:
        words = SETS.get(kind, kind).split("|")
        refused = [one for one in words if f"invalid keyword: '{one}'" in says(one)]
        return found + ([] if is_word else ["is no word"]) + [f"has no value {one}" for one in refused]
    least = int(numbers[2])
    most = MANY if numbers[4] else int(numbers[3] or least)
    if not is_format:
        found.append("is no number")
    if f"'{name}' does not have enough data" in says(" ".join(["1"] * least)):
        found.append(f"needs more than {least}")
    if least > 1 and f"'{name}' does not have enough data" not in says(" ".join(["1"] * (least - 1))):
        found.append(f"needs fewer than {least}")
    if f"'{name}' has too much data" in says(" ".join(["1"] * most)):
        found.append(f"has fewer than {most}")
    if most < MANY and f"'{name}' has too much data" not in says(" ".join(["1"] * (most + 1))):
        found.append(f"has more than {most}")
    half = says(" ".join(["1.5"] + ["1"] * (least - 1)))
    if ("bad format" in half or "problem reading" in half) != bool(numbers[1]):
        found.append("is an integer or not")
    return found


def of_row(path, attributes):
    """In a process of its own: MuJoCo may end the process, or take long for a model of many parts."""
    read, write = os.pipe()
    child = os.fork()
    if child == 0:
        signal.alarm(60)
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        os.dup2(1, 2)
        os.write(write, json.dumps([(one, faults(path, one)) for one in attributes]).encode())
        os._exit(0)
    os.close(write)
    with os.fdopen(read, "rb") as pipe:
        data = pipe.read()
    os.waitpid(child, 0)
    return json.loads(data) if data else None


def main():
    count, wrong, unasked = 0, [], []
    for path, attributes in rows(SCHEMA.read_text()):
        if not attributes:
            continue
        answers = of_row(path, attributes)
        if answers is None:
            unasked.append("/".join(path))
            continue
        count += len(answers)
        wrong += [f"{'/'.join(path)} {one}: {'; '.join(found)}" for one, found in answers if found]
    print(f"{count} attributes asked of MuJoCo {mujoco.__version__}; not asked: {unasked}")
    assert not wrong, "\n".join(wrong)
    assert count > 1500 and len(unasked) <= 3


main()
