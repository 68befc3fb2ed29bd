#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A megabyte of one piece, again and again, takes smurf-lint what cost.py allows.

repeated_pieces_test.py FOLDER_OF_TOOLS [WORD...]: with words, only the pieces that hold one of them.

In a piece, @ is its number and ~ that of the piece before.
"""
import os
import pathlib
import sys
import tempfile

import cost

BYTES = 1_000_000
MODEL = "modelname: a\nfiles: [a.urdf]\n"
URDF = '<robot name="a"><link name="b"/></robot>'
SECTIONS = ("materials motors sensors controllers collision visuals links nodes joints lights poses submechanisms "
            "interfaces submodels custom").split()
ITEMS = ("- {name: a@}\n", "- {name: a}\n", "- a@\n", "- []\n", "- {name: a@, joint: j@, link: k@}\n",
         "- {name: a@, joints: {j: 1}}\n", "- {name: a@, type: JointPosition, id: [j, j, j]}\n")
COMMENTS = ("#smurf-lint:ignore[SML3101]\n", "#smurf-lint:ignore[A]\n", "# smurf-lint: ignore[SML@]\n", "#smurf-lint:\n")
ELEMENTS = ('<link name="l@"/>', "<link/>", '<joint name="j@"/>', '<gazebo reference="l@"/>', "<x@/>",
            "<!--smurf-lint:ignore[A]-->", '<transmission name="t@"><joint name="j@"/></transmission>')
ENTITIES = ("- {name: e@, type: smurf, file: a.smurf}\n", "- {name: e@, type: x@}\n",
            '- {name: e@, type: smurf, file: a.smurf, parent: "e~::x"}\n',
            '- {name: e@, type: smurf, file: a.smurf, parent: "f@::b"}\n',
            "- {name: e@, type: smurf, file: a.smurf, pose: p@}\n")
SETTINGS = {
    **{f"{key}:\n": ("- a@\n", "- SML3101\n") for key in ("select", "ignore", "targets", "format", "exclude")},
    **{f"{key}:\n": ("  a@: error\n", "  SML3101: 1\n") for key in ("severity", "tolerances", "packages")},
    "paths:\n": ("  a@: {ignore: SML3}\n",),
    "": ("k@: 1\n",),
}
VALUES = {
    "pattern: 'a*a*a*a*b'": '"' + "a" * 9999 + '"',
    "patternProperties: {'^.*z$': {type: string}}": "{? " + "a" * 30000 + " : 1}",
    "items: {oneOf: [" + ",".join(f"{{const: {i}}}" for i in range(200)) + "]}": "[" + "[[]]," * 60000 + "]",
    "items: {enum: [" + ",".join(map(str, range(50000))) + "]}": "[" + ",".join(f"a{i}" for i in range(60000)) + "]",
    "items: {anyOf: [" + ",".join(f"{{properties: {{a{i}: {{type: string}}}}, required: [b{i}]}}" for i in range(150)) + "]}":
        "[" + "".join(f"{{a{i}: 1}}," for i in range(90000)) + "]",
    "required: [" + ",".join(f"a{i}" for i in range(60000)) + "]":
        "{" + ",".join(f"b{i}: 1" for i in range(60000)) + "}",
    "uniqueItems: true": "[" + "1," * 100000 + "]",
}


def pieces(piece: str, head: str = "", tail: str = "") -> str:
    parts, size, number = [head], len(head), 0
    while size < BYTES:
        parts.append(piece.replace("@", str(number)).replace("~", str(number - 1)))
        size += len(parts[-1])
        number += 1
    return "".join(parts) + tail


def cases():
    """For a title, the files by name and the file to check."""
    for section in SECTIONS:
        for item in ITEMS:
            yield f"{section}: {item}", {"a.urdf": URDF, "a.smurf": pieces(item, f"{MODEL}{section}:\n")}, "a.smurf"
    for comment in COMMENTS:
        yield f"comments {comment}", {"a.urdf": URDF, "a.smurf": pieces(comment, MODEL)}, "a.smurf"
    for comment in COMMENTS:
        text = pieces(" " + comment.strip(), f"{MODEL}#") + "\n"
        yield f"one line of {comment}", {"a.urdf": URDF, "a.smurf": text}, "a.smurf"
    yield "a list in a comment", {"a.urdf": URDF, "a.smurf": pieces("SML3101,", f"{MODEL}#smurf-lint:ignore[", "]\n")}, \
        "a.smurf"
    for element in ELEMENTS:
        yield f"robot of {element}", {"a.urdf": pieces(element, '<robot name="r"><link name="a"/>', "</robot>")}, "a.urdf"
    for entity in ENTITIES:
        files = {"a.urdf": URDF, "a.smurf": MODEL, "s.smurfs": pieces(entity, "smurfs:\n")}
        yield f"scene of {entity}", files, "s.smurfs"
    for head, entries in SETTINGS.items():
        for entry in entries:
            files = {".smurf-lint.yaml": pieces(entry, head), "a.urdf": URDF, "a.smurf": MODEL + "motors: [{name: a}]\n"}
            yield f"configuration {head}{entry}", files, "a.smurf"
    deep = "d/" * 300
    for mesh in ("package://p/x@.dae", "x@/y.stl"):
        shapes = pieces(f'<visual><geometry><mesh filename="{mesh}"/></geometry></visual>',
                        '<robot name="r"><link name="a">', "</link></robot>")
        yield f"deep in folders {mesh}", {f"{deep}a.urdf": shapes}, f"{deep}a.urdf"
    for schema, value in VALUES.items():
        files = {".smurf-lint.yaml": "schemas: {sections: {foo: s.yaml}}\n", "s.yaml": schema + "\n",
                 "a.urdf": URDF, "a.smurf": f"{MODEL}foo: {value}\n"}
        yield f"schema {schema[:60]}", files, "a.smurf"


def fault(tools: pathlib.Path, files: dict, main: str) -> str:
    """An error message; empty if the bounds are kept."""
    with tempfile.TemporaryDirectory() as work:
        folder = pathlib.Path(work)
        (folder / ".git").mkdir()
        for name, text in files.items():
            os.makedirs((folder / name).parent, exist_ok=True)
            (folder / name).write_text(text, encoding="utf-8")
        return ", ".join(cost.faults(tools, lambda: cost.Run([tools / "smurf-lint", "-q", "--statistics", main], folder)))


def main() -> int:
    tools, words = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2:]
    failed = passed = 0
    for title, files, name in cases():
        if words and not any(word in title for word in words):
            continue
        what = fault(tools, files, name)
        failed, passed = failed + bool(what), passed + (not what)
        if what:
            print(f"{title.strip()!r}: {what}", flush=True)
    print(f"{passed} passed, {failed} failed")
    return 1 if failed or not passed else 0


if __name__ == "__main__":
    sys.exit(main())
