#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The tools on files that nobody means well with: a verdict, in bounded time and memory.

Called with the tools: hostile_cli_test.py TOOL...
"""
import os
import pathlib
import sys
import tempfile

MANY = 100_000
URDF = '<robot name="r"><link name="a"/></robot>'
ALIAS_BOMB = "a0: &a0 [" + ",".join("x" * 9) + "]\n" + "".join(
    f"a{i}: &a{i} [" + ",".join([f"*a{i - 1}"] * 9) + "]\n" for i in range(1, 10)
)
ATTRIBUTES = "".join(f" a{i}='1'" for i in range(20_000))

YAML_TEXTS = {
    "empty": b"",
    "zeros": bytes(MANY),
    "every byte": bytes(range(256)) * 64,
    "brackets": b"[" * MANY,
    "braces": b"{a: " * MANY,
    "a megabyte of brackets": b"[" * (1 << 20),
    "dashes": b"- " * MANY,
    "alias bomb": ALIAS_BOMB.encode(),
    "one line": b"a: " + b"x " * (1 << 19),
    "one key": b"a: 1\n" * 20_000,
    "a list of lists": b"motors: [" + b"[[]]," * 5_000 + b"]",
}
XML_TEXTS = {
    "empty": b"",
    "zeros": bytes(MANY),
    "every byte": bytes(range(256)) * 64,
    "elements": b"<a>" * MANY,
    "links": b"<robot name='r'>" + b"<link>" * MANY,
    "attributes": f"<robot{ATTRIBUTES}/>".encode(),
    "one line": b"<robot name='" + b"x" * (1 << 20) + b"'",
    "a number": b"<robot name='r'><link name='a'/><joint><origin xyz='" + b"1 " * (1 << 19) + b"'/></joint>",
    "entities": b"<!DOCTYPE a [<!ENTITY a '&b;&b;'><!ENTITY b '&a;&a;'>]><robot name='&a;'/>",
    "printf": b"<robot name='%s%n'><link name='%s%n'><inertial><mass value='%s%n'/></inertial></link></robot>",
}


def has_sanitizer(tool):
    return b"__asan_init" in pathlib.Path(tool).read_bytes()


def run(tool, path, folder):
    """Exit code (negative: signal), CPU seconds, memory in MB, and the first bytes it wrote."""
    output = folder / "output"
    with open(output, "wb") as stream:
        child = os.posix_spawn(
            tool, [tool, str(path)], {"PATH": "/nonexistent"},
            file_actions=[(os.POSIX_SPAWN_OPEN, 0, "/dev/null", os.O_RDONLY, 0),
                          (os.POSIX_SPAWN_DUP2, stream.fileno(), 1),
                          (os.POSIX_SPAWN_DUP2, stream.fileno(), 2)])
        _, status, usage = os.wait4(child, 0)
    seconds = usage.ru_utime + usage.ru_stime
    with open(output, "rb") as stream:
        return os.waitstatus_to_exitcode(status), seconds, usage.ru_maxrss / 1024, stream.read(4096)


def cases(folder):
    """(title, path) of every bad input; the files lie in folders of their own."""
    def write(title, files, main):
        place = folder / title.replace(" ", "_")
        place.mkdir()
        for name, data in files.items():
            (place / name).write_bytes(data if isinstance(data, bytes) else data.encode())
        return title, place / main

    for title, data in YAML_TEXTS.items():
        yield write(f"annotations {title}", {
            "r.smurf": "files: [r.urdf, a.yml]\n", "r.urdf": URDF, "a.yml": data}, "r.smurf")
        yield write(f"model {title}", {"r.smurf": data}, "r.smurf")
        yield write(f"scene {title}", {"s.smurfs": data}, "s.smurfs")
    for title, data in XML_TEXTS.items():
        yield write(f"urdf {title}", {"r.smurf": "files: [r.urdf]\n", "r.urdf": data}, "r.smurf")
        yield write(f"alone {title}", {"r.urdf": data}, "r.urdf")
    (folder / "folder.smurf").mkdir()
    yield "a folder called like a model", folder / "folder.smurf"
    os.mkfifo(folder / "pipe.smurf")
    yield "a pipe", folder / "pipe.smurf"
    (folder / "loop.smurf").symlink_to("loop.smurf")
    yield "a link to itself", folder / "loop.smurf"
    yield "a missing file", folder / "missing.smurf"
    yield "a device", pathlib.Path("/dev/zero")
    yield "a long name", folder / ("x" * 5000 + ".smurf")
    yield write("a scene in itself", {
        "s.smurfs": "entities: [{name: a, file: s.smurfs}]\n"}, "s.smurfs")


def faults(tool, title, path, folder, is_slow):
    code, seconds, memory, output = run(tool, path, folder)
    # A scene may be of odd keys and still be one, without entities.
    if code not in ((0, 1, 2) if title.startswith("scene") else (1, 2)):
        yield f"ended with {code}"
    if not output.strip():
        yield "said nothing"
    if seconds > (30 if is_slow else 2):
        yield f"took {seconds:.1f} s"
    if memory > 300 and not is_slow:
        yield f"took {memory:.0f} MB"


def main():
    count = 0
    failures = []
    with tempfile.TemporaryDirectory(prefix="smurf-hostile-") as name:
        folder = pathlib.Path(name)
        everything = list(cases(folder))
        for tool in sys.argv[1:]:
            is_slow = has_sanitizer(tool)
            for title, path in everything:
                count += 1
                failures += [f"{pathlib.Path(tool).name}: {title}: {fault}"
                             for fault in faults(tool, title, path, folder, is_slow)]
    print("\n".join(failures))
    print(f"{count} runs, {len(failures)} failures")
    return 1 if failures or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
