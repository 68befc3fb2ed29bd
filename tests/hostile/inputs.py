# SPDX-License-Identifier: BSD-3-Clause
"""Hostile inputs: texts, archives, meshes, images and file systems, each with a title."""
import dataclasses
import io
import itertools
import json
import os
import pathlib
import shutil
import struct
import zipfile
import zlib

FIXTURES = pathlib.Path(__file__).resolve().parent.parent.parent / "build/fixtures"
MANY = 100_000
URDF = b'<robot name="r"><link name="a"/></robot>'
MODEL = b"files: [r.urdf]\n"


def repeat(text, size, number="{}"):
    """Repeats `text` until there are `size` bytes. `number` stands for the number of the repetition."""
    parts = []
    while size > 0:
        parts.append(text.replace(number, str(len(parts))))
        size -= len(parts[-1])
    return "".join(parts)


class Special:
    """An input that is not a file with bytes: creates itself at a path."""

    def __init__(self, make):
        self.make = make


def link(target):
    return Special(lambda path: path.symlink_to(target))


FIFO = Special(lambda path: os.mkfifo(path))
FOLDER = Special(lambda path: path.mkdir())


def unreadable(data):
    def make(path):
        path.write_bytes(data)
        path.chmod(0)
    return Special(make)


@dataclasses.dataclass
class Case:
    title: str
    files: dict
    main: str
    codes: tuple = (0, 1, 2)
    tools: tuple = ()    # empty: all
    words: tuple = ()    # of the command line instead of the usual ones; {} is the main file
    scale: float = 1     # of the bounds on time and memory, for what is large without being hostile

    def write(self, folder):
        folder.mkdir()
        for name, data in self.files.items():
            path = folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            if isinstance(data, Special):
                data.make(path)
            else:
                path.write_bytes(data)

    @staticmethod
    def remove(folder):
        shutil.rmtree(folder, ignore_errors=True)


def as_model(title, urdf, **keywords):
    return Case(title, {"r.smurf": MODEL, "r.urdf": urdf}, "r.smurf", **keywords)


def robot(body):
    return b'<robot name="r"><link name="a">' + body + b"</link></robot>"


# --- texts ---------------------------------------------------------------------------------------

ALIAS_BOMB = "a0: &a0 [" + ",".join("x" * 9) + "]\n" + "".join(
    f"a{i}: &a{i} [" + ",".join([f"*a{i - 1}"] * 9) + "]\n" for i in range(1, 10))
ANY_TEXT = {
    "nothing": b"",
    "a line end": b"\n",
    "zeros": bytes(MANY),
    "a zero in a name": b"name: a\0b\n",
    "every byte": bytes(range(256)) * 64,
    "UTF-16, little end first": "name: r\u00fc\nfiles: [r.urdf]\n".encode("utf-16"),
    "UTF-16, big end first": b"\xfe\xff" + "<robot name='r'/>".encode("utf-16-be"),
    "UTF-16 without a mark": "<robot name='r'/>".encode("utf-16-le"),
    "UTF-32": "files: [r.urdf]\n".encode("utf-32"),
    "Latin-1": "name: J\u00fcrgen\n".encode("latin-1"),
    "a lone surrogate": b"name: a\xed\xa0\x80b\n",
    "an overlong slash": b"name: ..\xc0\xaf..\n",
    "a byte order mark alone": b"\xef\xbb\xbf",
    "a program": b"\x7fELF\x02\x01\x01" + bytes(64),
    "escape sequences": b"name: \x1b]0;owned\x07\x1b[2J\n",
    "a megabyte in one word": b"x" * (1 << 20),
}
YAML_TEXTS = {
    **ANY_TEXT,
    "brackets": b"[" * MANY,
    "braces": b"{a: " * MANY,
    "a megabyte of brackets": b"[" * (1 << 20),
    "dashes": b"- " * MANY,
    "deeper and deeper": b"".join(b" " * i + b"a:\n" for i in range(1000)),
    "alias bomb": ALIAS_BOMB.encode(),
    "aliases of aliases": b"a: &a [x]\n" + b"".join(b"b%d: &b%d [*a, *a]\n" % (i, i) for i in range(5000)),
    "an alias of itself": b"a: &a [*a]\n",
    "merge keys": b"a: &a {x: 1}\n" + b"".join(b"b%d: {<<: *a}\n" % i for i in range(5000)),
    "one line": b"a: " + b"x " * (1 << 19),
    "one key again and again": b"a: 1\n" * 20_000,
    "a key of a megabyte": b"k" * (1 << 20) + b": 1\n",
    "a quoted key of a megabyte": b'"' + b"k" * (1 << 20) + b'": 1\n',
    "a list of lists": b"motors: [" + b"[[]]," * 5_000 + b"]",
    "a comment of a megabyte": b"# " + b"x" * (1 << 20) + b"\n",
    "a tag of a megabyte": b"!<" + b"x" * (1 << 20) + b"> a\n",
    "documents": b"--- {}\n" * 10_000,
    "escapes": b'name: "' + b"\\u0041" * 50_000 + b'"\n',
    "a surrogate by escape": b'name: "\\ud800"\n',
    "printf": b"%s%n%n: %n\nmodelname: '%s%n%n%n%n'\nfiles: ['%s%n.urdf', '%n%n%n.yml']\n",
}
NUMBERS = (b"1e400", b"-1e400", b"9" * 400, b"0." + b"0" * 400 + b"1", b"1e-400", b"nan", b"inf", b"0x1p4",
           b"1e999999999999999999", b"--1", b"1_000", b"\xd9\xa1")
XML_TEXTS = {
    **ANY_TEXT,
    "elements": b"<a>" * MANY,
    "links in links": b"<robot name='r'>" + b"<link>" * MANY,
    "attributes": b"<robot" + b"".join(b" a%d='1'" % i for i in range(20_000)) + b"/>",
    "prefixes": b"<robot" + b"".join(b" xmlns:a%d='1'" % i for i in range(900)) + b"/>",
    "one line": b"<robot name='" + b"x" * (1 << 20) + b"'",
    "a name of a megabyte": b"<robot name='" + b"x" * (1 << 20) + b"'><link name='a'/></robot>",
    "an element of a megabyte": b"<robot name='r'><" + b"x" * (1 << 20) + b"/><link name='a'/></robot>",
    "a million blanks": b"<robot name='r'>" + b" " * (1 << 20) + b"<link name='a'/></robot>",
    "a number of a megabyte": b"<robot name='r'><link name='a'><visual><origin xyz='" + b"1 " * (1 << 19)
                              + b"'/></visual></link></robot>",
    "entities": b"<!DOCTYPE a [<!ENTITY a '&b;&b;'><!ENTITY b '&a;&a;'>]><robot name='&a;'/>",
    "a billion laughs": b"<!DOCTYPE a [<!ENTITY l0 'ha'>" + b"".join(
        b"<!ENTITY l%d '%s'>" % (i, b"&l%d;" % (i - 1) * 10) for i in range(1, 10)) + b"]><robot name='&l9;'/>",
    "an external entity": b"<!DOCTYPE a [<!ENTITY a SYSTEM 'file:///etc/passwd'>]><robot name='&a;'><link "
                          b"name='a'/></robot>",
    "an included file": b"<robot name='r' xmlns:xi='http://www.w3.org/2001/XInclude'><xi:include "
                        b"href='/dev/zero'/><link name='a'/></robot>",
    "character references": b"<robot name='" + b"&#65;" * 50_000 + b"'><link name='a'/></robot>",
    "a reference to no character": b"<robot name='&#0;&#xD800;&#x110000;&#99999999999;'/>",
    "comments": b"<robot name='r'>" + b"<!---->" * 50_000 + b"<link name='a'/></robot>",
    "a comment of a megabyte": b"<robot name='r'><!--" + b"x" * (1 << 20) + b"--><link name='a'/></robot>",
    "an instruction that ends early": b"<?nd\"/>?><robot name='r'><link name='a'/></robot>",
    "instructions": b"<?a?>" * 50_000 + b"<robot name='r'><link name='a'/></robot>",
    "a section of a megabyte": b"<robot name='r'><![CDATA[" + b"x" * (1 << 20) + b"]]><link name='a'/></robot>",
    "links of one name": b"<robot name='r'>" + b"<link name='a'/>" * 5_000 + b"</robot>",
    "a ring": b"<robot name='r'><link name='a'/><link name='b'/>" + b"".join(
        b"<joint name='j%d' type='fixed'><parent link='%s'/><child link='%s'/></joint>" % (i, a, b)
        for i, (a, b) in enumerate([(b"a", b"b"), (b"b", b"a")])) + b"</robot>",
    "mimics in a ring": b"<robot name='r'><link name='a'/>" + b"".join(
        b"<link name='l%d'/><joint name='j%d' type='revolute'><parent link='a'/><child link='l%d'/>"
        b"<limit lower='0' upper='1' effort='1' velocity='1'/><mimic joint='j%d'/></joint>"
        % (i, i, i, (i + 1) % 500) for i in range(500)) + b"</robot>",
    "printf": b"<robot name='%s%n'><link name='%s%n'><inertial><mass value='%s%n'/></inertial><visual><geometry>"
              b"<mesh filename='%n%s.stl'/></geometry><material name='%n%s'/></visual></link></robot>",
    **{f"the number {number[:20].decode()}":
       robot(b"<inertial><mass value='%s'/><origin xyz='%s 0 0' rpy='0 0 %s'/><inertia ixx='%s' ixy='0' ixz='0' "
             b"iyy='1' iyz='0' izz='1'/></inertial>" % ((number,) * 4)) for number in NUMBERS},
}


def texts():
    for title, data in YAML_TEXTS.items():
        yield Case(f"annotations: {title}",
                   {"r.smurf": b"files: [r.urdf, a.yml]\n", "r.urdf": URDF, "a.yml": data}, "r.smurf")
        yield Case(f"a model: {title}", {"r.smurf": data, "r.urdf": URDF}, "r.smurf")
        yield Case(f"a scene: {title}", {"s.smurfs": data}, "s.smurfs")
    for title, data in XML_TEXTS.items():
        yield as_model(f"a model's URDF: {title}", data)
        yield Case(f"a URDF: {title}", {"r.urdf": data}, "r.urdf")
    for number in NUMBERS:
        yield Case(f"numbers {number[:20].decode()}", {
            "r.smurf": b"files: [r.urdf, a.yml]\n", "r.urdf": URDF, "s.smurfs":
            b"physics: {stepsize: %s}\nentities: [{name: a, type: smurf, file: r.smurf, position: [%s, 0, 0], "
            b"rotation: [%s, 0, 0]}]\n" % (number, number, number),
            "a.yml": b"motors: [{name: m, joint: j, maxEffort: %s, minPosition: %s}]\n" % (number, number)},
            "s.smurfs")
    yield Case("entities called printf", {"s.smurfs": b"entities:\n- {name: '%s%n', type: '%n', file: '%n%s'}\n"
                                          b"- {name: '%n', file: 'r.smurf', parent: '%s%n', anchor: '%n'}\n",
                                          "r.smurf": MODEL, "r.urdf": URDF}, "s.smurfs")
    yield Case("a file called printf", {"%s%n%n.urdf": XML_TEXTS["printf"]}, "%s%n%n.urdf")
    yield Case("a file called as a terminal is told", {"\x1b[2J.urdf": URDF + b"x"}, "\x1b[2J.urdf")


# --- truncations ---------------------------------------------------------------------------------

def truncations():
    for path in sorted([*FIXTURES.glob("models/*/*/*"), *FIXTURES.glob("scenes/**/*")]):
        if not path.is_file() or path.suffix not in (".urdf", ".smurf", ".smurfs", ".smurfa"):
            continue
        whole = path.read_bytes()
        for part in (3, 2):
            yield Case(f"{path.name}, one of {part} parts", {path.name: whole[:len(whole) // part]}, path.name)


# --- depth and size ------------------------------------------------------------------------------

def chain(links):
    return b"".join([
        b'<robot name="r">', *(b'<link name="l%d"/>' % i for i in range(links)),
        *(b'<joint name="j%d" type="fixed"><parent link="l%d"/><child link="l%d"/></joint>' % (i, i, i + 1)
          for i in range(links - 1)), b"</robot>"])


def nested_scenes(depth):
    files = {f"s{i}.smurfs": b"entities: [{name: e, file: s%d.smurfs}]\n" % (i + 1) for i in range(depth)}
    return {**files, f"s{depth}.smurfs": b"entities: []\n"}


def long_file(head, part, megabytes, tail):
    def make(path):
        with open(path, "wb") as file:
            file.write(head)
            for _ in range(megabytes):
                file.write(part * ((1 << 20) // len(part)))
            file.write(tail)
    return Special(make)


ROBOT = b'<robot name="r"><link name="a"/>'
FIFTY_MEGABYTES = {
    "lists": ("r.smurf", b"x: [", b"[],", b"1]\n"),
    "mappings": ("r.smurf", b"x: [", b"{a: b},", b"1]\n"),
    "ones": ("r.smurf", b"x: [", b"1,", b"1]\n"),
    "entries": ("r.smurf", b"x:\n", b"- 1\n", b""),
    "equal keys": ("r.smurf", b"", b"a: 1\n", b""),
    "empty motors": ("r.smurf", b"motors:\n", b"- {}\n", b""),
    "motors that are numbers": ("r.smurf", b"motors:\n", b"- 1\n", b""),
    "listed files": ("r.smurf", b"files:\n", b"- a.yml\n", b""),
    "empty entities": ("s.smurfs", b"entities:\n", b"- {}\n", b""),
    "empty lights": ("s.smurfs", b"lights:\n", b"- {}\n", b""),
    "elements": ("r.urdf", ROBOT, b"<a/>", b"</robot>"),
    "attributes": ("r.urdf", ROBOT, b'<a b="" c="" d="" e=""/>', b"</robot>"),
    "links of one name": ("r.urdf", ROBOT, b'<link name="a"/>', b"</robot>"),
    "empty links": ("r.urdf", ROBOT, b"<link/>", b"</robot>"),
    "empty joints": ("r.urdf", ROBOT, b"<joint/>", b"</robot>"),
    "empty transmissions": ("r.urdf", ROBOT, b"<transmission/>", b"</robot>"),
    "empty visuals": ("r.urdf", b'<robot name="r"><link name="a">', b"<visual/>", b"</link></robot>"),
}
# Fewer findings than the limits allow, of the kinds with the longest messages.
EIGHT_MEGABYTES = {
    "empty entities": ("s.smurfs", b"entities:\n", b"- {}\n", b""),
    "ampersands": ("r.urdf", b'<robot name="', b"&", b'"/>'),
    "folders of a mesh": ("r.urdf", b'<robot name="r"><link name="a"><visual><geometry><mesh filename="', b"a/",
                          b'"/></geometry></visual></link></robot>'),
}


def large():
    yield as_model("a chain of 5,000 links", chain(5_000))
    yield as_model("a chain of 100,000 links", chain(100_000), scale=8)
    yield Case("scenes in scenes", nested_scenes(500), "s0.smurfs", codes=(1, 2))
    yield Case("scenes that double", {
        f"s{i}.smurfs": b"entities: [{name: a, file: s%d.smurfs}, {name: b, file: s%d.smurfs}]\n" % (i + 1, i + 1)
        for i in range(40)}, "s0.smurfs", codes=(1, 2), scale=4)
    yield Case("parents of parents", {
        "r.urdf": URDF, "s.smurfs": b"entities:\n" + b"".join(
            b"- {name: e%d, type: urdf, file: r.urdf, parent: e%d, anchor: a}\n" % (i, i + 1) for i in range(5_000))},
        "s.smurfs")
    for title, (name, head, part, tail) in FIFTY_MEGABYTES.items():
        yield Case(f"50 MB of {title}", {name: long_file(head, part, 50, tail)}, name, codes=(1, 2), scale=2)
        if name.endswith("f") and title != "links of one name":
            yield Case(f"50 MB of {title} next to the file", {
                name: long_file(head, part, 50, tail), "a.yml": b"motors: []\n"}, "a.yml", tools=("smurf-lint",))
    for title, (name, head, part, tail) in EIGHT_MEGABYTES.items():
        yield Case(f"8 MB of {title}", {name: long_file(head, part, 8, tail)}, name, scale=2)
    yield Case("a key of 50 MB", {"r.smurf": long_file(b"", b"k", 50, b": 1\n")}, "r.smurf", codes=(1, 2))
    yield Case("50 MB in a comment", {"r.urdf": long_file(
        b"<robot name='r'><!--", b"x", 50, b"--><link name='a'/></robot>")}, "r.urdf", scale=2)
    yield Case("a file with a hole of a terabyte", {"r.urdf": Special(
        lambda path: (path.touch(), os.truncate(path, 1 << 40)))}, "r.urdf", codes=(1, 2))


# --- the file system -----------------------------------------------------------------------------

def places():
    for name in ("r.smurf", "s.smurfs", "r.urdf"):
        kind = pathlib.Path(name).suffix
        yield Case(f"a folder called {kind}", {name: FOLDER}, name, codes=(1, 2))
        yield Case(f"a pipe called {kind}", {name: FIFO}, name, codes=(1, 2))
        yield Case(f"a link to itself called {kind}", {name: link(name)}, name, codes=(1, 2))
        yield Case(f"a link to /dev/zero called {kind}", {name: link("/dev/zero")}, name, codes=(1, 2))
        yield Case(f"a missing {kind}", {}, name, codes=(2,))
        if os.geteuid() != 0:
            yield Case(f"an unreadable {kind}", {name: unreadable(URDF)}, name, codes=(2,))
    for device in ("/dev/zero", "/dev/random", "/dev/full", "/dev/stdin", "/proc/self/mem", "/proc/kmsg"):
        yield Case(f"the device {device}", {}, device, codes=(1, 2))
    yield Case("a long name", {}, "x" * 5000 + ".smurf", codes=(2,))
    yield Case("a folder that holds itself", {"in/r.urdf": URDF, "in/again": link("."), "in/up": link("..")}, "in")
    named = {"a device": link("/dev/zero"), "endless noise": link("/dev/random"), "a pipe": FIFO, "a folder": FOLDER,
             "a link to itself": link("thing"), "a secret": link("/etc/shadow")}
    for title, thing in named.items():
        for extension in (".stl", ".obj", ".dae"):
            mesh = b"<geometry><mesh filename='thing%s'/></geometry>" % extension.encode()
            moved = link("thing" + extension) if title == "a link to itself" else thing
            yield Case(f"a mesh {extension} that is {title}", {"r.smurf": MODEL, "thing" + extension: moved, "r.urdf": robot(
                b"<visual>%s<material name='m'><texture filename='thing%s'/></material></visual><collision>%s"
                b"</collision>" % (mesh, extension.encode(), mesh))}, "r.smurf")
        for name in ("thing.urdf", "thing.yml"):
            moved = link(name) if title == "a link to itself" else thing
            yield Case(f"a model's {name[6:]} that is {title}", {
                "r.smurf": b"files: [%s]\n" % name.encode(), name: moved}, "r.smurf")
        for kind in ("smurf", "smurfs", "urdf", "heightmap", "scn", "yml"):
            name = "thing.png" if kind == "heightmap" else f"thing.{kind}"
            moved = link(name) if title == "a link to itself" else thing
            yield Case(f"an entity {kind} that is {title}", {name: moved, "s.smurfs": (
                f"entities: [{{name: e, type: {kind}, file: {name}, width: 1.0, length: 1.0, height: 1.0}}]\n"
            ).encode()}, "s.smurfs")
    for path in ("/dev/zero", "/dev/random", "file:///dev/zero", "package://../../dev/zero", "/proc/self/mem"):
        yield as_model(f"a mesh at {path}", robot(
            b"<collision><geometry><mesh filename='%s'/></geometry></collision>" % path.encode()))
    yield Case("a scene in itself", {"s.smurfs": b"entities: [{name: a, file: s.smurfs}]\n"}, "s.smurfs", codes=(1, 2))
    yield Case("scenes in a ring", {"s.smurfs": b"entities: [{name: a, file: t.smurfs}]\n",
                                    "t.smurfs": b"entities: [{name: a, file: s.smurfs}]\n"}, "s.smurfs", codes=(1, 2))
    yield Case("a scene in itself by a link", {"s.smurfs": b"entities: [{name: a, file: d/s.smurfs}]\n",
                                               "d": link(".")}, "s.smurfs", codes=(1, 2))
    yield Case("a model that lists itself", {"r.smurf": b"files: [r.smurf, r.smurf]\n"}, "r.smurf")


# --- meshes and images ---------------------------------------------------------------------------

TRIANGLE = struct.pack("<12fH", 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0)
DAE = (b'<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">'
       b'<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="%s">%s</float_array>'
       b'<technique_common><accessor source="#a" count="%s" stride="3"/></technique_common></source>'
       b'<vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="%s">'
       b'<input semantic="VERTEX" source="#v" offset="0"/><p>%s</p></triangles></mesh></geometry>'
       b'</library_geometries></COLLADA>')


def placed_dae(nodes, corners=b"0 1 2"):
    """A DAE of three points with these nodes in its library; the scene shows n0."""
    return (DAE % (b"9", b"0 0 0 1 0 0 0 1 0", b"3", b"%d" % (len(corners.split()) // 3), corners)).replace(
        b"</COLLADA>", b'<library_nodes>%s</library_nodes><library_visual_scenes><visual_scene id="s"><node>'
        b'<instance_node url="#n0"/></node></visual_scene></library_visual_scenes><scene>'
        b'<instance_visual_scene url="#s"/></scene></COLLADA>' % nodes)


GLTF = (b'{"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":%s,"meshes":[{"primitives":[{"attributes":'
        b'{"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],'
        b'"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":"%s"}]}')
MESHES = {
    "an STL of 4,000,000,000 triangles": ("m.stl", bytes(80) + struct.pack("<I", 4_000_000_000) + TRIANGLE * 10),
    "an STL cut short": ("m.stl", bytes(80) + struct.pack("<I", 10) + TRIANGLE * 9 + TRIANGLE[:20]),
    "an STL of NaN": ("m.stl", bytes(80) + struct.pack("<I", 10) + (struct.pack("<12f", *[float("nan")] * 12)
                                                                    + b"\0\0") * 10),
    "an STL of infinite size": ("m.stl", bytes(80) + struct.pack("<I", 1) + struct.pack("<12f", *[3e38] * 12) + b"\0\0"),
    "an STL that says solid": ("m.stl", b"solid " + b"facet normal 0 0 0 outer loop vertex " * 20_000),
    "an STL of one word": ("m.stl", b"solid " + b"x" * (1 << 20)),
    "an OBJ with an index of 1,000,000,000": ("m.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 1000000000\n"),
    "an OBJ with negative indices": ("m.obj", b"v 0 0 0\nf -1 -2 -999999999999\n"),
    "an OBJ with a face of 100,000 corners": ("m.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf" + b" 1 2 3" * 33_000 + b"\n"),
    "an OBJ with material libraries": ("m.obj", b"mtllib /dev/zero\nmtllib m.obj\n" * 2_000 + b"v 0 0 0\nf 1 1 1\n"),
    "an OBJ of numbers": ("m.obj", b"v 1e400 nan -inf\n" * 3 + b"v " + b"9" * 100_000 + b" 0 0\nf 1 2 3\n"),
    "a DAE cut short": ("m.dae", (DAE % (b"9", b"0 " * 9, b"3", b"1", b"0 1 2"))[:500]),
    "a DAE that counts to 4,000,000,000": ("m.dae", DAE % (b"4000000000", b"0 0 0", b"4000000000", b"4000000000", b"0")),
    "a DAE with negative counts": ("m.dae", DAE % (b"-1", b"0 0 0", b"-1", b"-1", b"-1 -2 -3")),
    "a deep DAE": ("m.dae", b"<COLLADA>" + b"<node>" * MANY),
    "a glTF": ("m.glb", b"glTF" + struct.pack("<III", 2, 0xFFFFFFFF, 0xFFFFFFFF) + b"JSON" + b"{" * 1000),
    "a glTF of brackets": ("m.gltf", b'{"a":' + b"[" * MANY),
    "a PLY": ("m.ply", b"ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nend_header\n1\n"),
    "a BOBJ": ("m.bobj", struct.pack("<i", 1) + b"\xff" * 100),
    "an empty mesh": ("m.stl", b""),
    "zeros": ("m.stl", bytes(MANY)),
    "a DAE of nodes that double": ("m.dae", placed_dae(b"".join(
        b'<node id="n%d"><instance_node url="#n%d"/><instance_node url="#n%d"/></node>' % (i, i + 1, i + 1)
        for i in range(60)) + b'<node id="n60"><instance_geometry url="#g"/></node>')),
    "a DAE of a node in itself": ("m.dae", placed_dae(b'<node id="n0"><instance_node url="#n0"/></node>')),
    "a DAE of a chain of 30,000 nodes": ("m.dae", placed_dae(b"".join(
        b'<node id="n%d"><instance_node url="#n%d"/></node>' % (i, i + 1) for i in range(30_000)))),
    "a DAE of 30,000 instances of 10,000 triangles": ("m.dae", placed_dae(
        b'<node id="n0">' + b'<instance_geometry url="#g"/>' * 30_000 + b"</node>", b"0 1 2 " * 10_000)),
    "a DAE of a polygon with 100,000 corners": ("m.dae", placed_dae(b'<node id="n0"><instance_geometry url="#g"/></node>', b"0 1 2 1 " * 25_000)
                                                .replace(b"triangles", b"polygons")),
    "a DAE of entities": ("m.dae", b'<!DOCTYPE a [<!ENTITY a "' + b"0 " * 1000 + b'">' + b"".join(
        b'<!ENTITY %s "%s">' % (b, b"&%s;" % a * 10) for a, b in zip((b"a", b"b", b"c", b"d", b"e", b"f"), (b"b", b"c", b"d", b"e", b"f", b"g")))
        + b"]>" + placed_dae(b'<node id="n0"/>', b"&g;")),
    "a glTF of a node in itself": ("m.gltf", GLTF % (b'[{"mesh":0,"children":[0]}]', b"data:;base64," + b"A" * 48)),
    "a glTF of 100,000 nodes": ("m.gltf", GLTF % (b'[{"mesh":0,"children":[%s]}%s]' % (
        b",".join(b"%d" % i for i in range(1, 100_000)), b',{"mesh":0}' * 99_999), b"data:;base64," + b"A" * 48)),
    "a glTF of a device": ("m.gltf", GLTF % (b'[{"mesh":0}]', b"/dev/zero")),
    "a glTF of a file elsewhere": ("m.gltf", GLTF % (b'[{"mesh":0}]', b"../../../../../../../../../../etc/passwd")),
    "a glTF of a file of its own": ("m.gltf", GLTF % (b'[{"mesh":0}]', b"m.gltf")),
}


def png(width, height, rows, depth=8):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, depth, 0, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def images():
    row = bytes(9)
    return {
        "4,000,000,000 pixels": png(65_000, 65_000, b"\0" * 1_000),
        "15,900,000 pixels": png(3_990, 3_990, bytes(3_991 * 3_990)),
        "too few rows": png(8, 8, row * 3),
        "too many rows": png(8, 8, row * 100_000),
        "half of the file": png(8, 8, row * 8)[:40],
        "a signature alone": b"\x89PNG\r\n\x1a\n",
        "no pixels": png(0, 0, b""),
        "one pixel": png(1, 1, b"\0\0"),
        "something else": b"GIF89a",
        "nothing": b"",
    }


def shapes():
    for title, (name, data) in MESHES.items():
        geometry = b"<geometry><mesh filename='%s'/></geometry>" % name.encode()
        urdf = robot(b"<visual>%s</visual><collision>%s</collision>" % (geometry, geometry))
        files = {"r.smurf": MODEL, "r.urdf": urdf, name: data}
        yield Case(title, files, "r.smurf")
        yield Case(f"the triangles of {title}", files, "r.smurf", tools=("smurfs-flatten",),
                   words=("{}", "--force", "--format", "gltf", "-o", "out/scene.gltf"))
    for title, data in images().items():
        yield Case(f"heights: {title}", {"h.png": data, "s.smurfs": b"entities:\n- {name: h, type: heightmap, "
                                         b"file: h.png, width: 6.0, length: 6.0, height: 0.8}\n"}, "s.smurfs",
                   scale=2)


# --- archives ------------------------------------------------------------------------------------

class Repeated:
    """This number of megabytes. Memory used here would be included in that of the tools."""

    def __init__(self, byte, megabytes):
        self.parts = [byte * (1 << 20)] * megabytes


def archive(files, method=zipfile.ZIP_DEFLATED):
    target = io.BytesIO()
    with zipfile.ZipFile(target, "w", method) as zipped:
        for name, data in files.items():
            info = zipfile.ZipInfo(name)
            info.compress_type = method
            with zipped.open(info, "w") as file:
                for part in data.parts if isinstance(data, Repeated) else [data]:
                    file.write(part)
    return target.getvalue()


def archives():
    sound = archive({"a.smurfs": b"entities: []\n"})
    bomb = archive({"a.smurfs": b"entities: []\n", "zeros": Repeated(b"\0", 400)})
    everything = {
        "a bomb": bomb,
        "a bomb in a bomb": archive({"a.smurfs": b"entities: []\n", "b.zsmurf": bomb, "c.zip": bomb}),
        "a scene that is a bomb": archive({"a.smurfs": Repeated(b"#", 200)}),
        "20,000 files": archive({**{f"{i}.yml": b"" for i in range(20_000)}, "a.smurfs": b"entities: []\n"}),
        "files elsewhere": archive({"../../a.smurfs": b"entities: []\n"}),
        "an absolute name": archive({"/tmp/a.smurfs": b"entities: []\n"}),
        "a long name": archive({"x" * 60_000 + ".smurfs": b"entities: []\n"}),
        "one name twice": archive({"a.smurfs": b"entities: []\n", "./a.smurfs": b"entities: [1]\n"}),
        "half of it": sound[:len(sound) // 2],
        "all but the end": sound[:-10],
        "a wrong sum": sound.replace(b"entities", b"entitles"),
        "a wrong size": sound.replace(struct.pack("<I", 13), struct.pack("<I", 0x7FFFFFFF)),
        "no archive": b"PK\x05\x06" + b"\xff" * 18,
        "nothing": b"",
        "zeros": bytes(MANY),
    }
    for title, data in everything.items():
        yield Case(f"an archive: {title}", {"a.zsmurf": data}, "a.zsmurf", codes=(1, 2) if "name twice" not in title
                   else (0, 1, 2))
        yield Case(f"an archive of old: {title}", {"a.scn": data, "s.smurfs": b"entities: [{name: a, type: scn, "
                                                   b"file: a.scn}]\n"}, "s.smurfs")


# --- what the tools read beside models -----------------------------------------------------------

def settings():
    def lint(title, files, *words):
        return Case(title, {"r.urdf": URDF, **files}, "r.urdf", tools=("smurf-lint",), words=words)
    deep = b'{"a":' * MANY
    texts_of_settings = {**YAML_TEXTS, "deep JSON": deep, "deep lists of JSON": b"[" * MANY}
    for title, data in texts_of_settings.items():
        yield lint(f"a configuration: {title}", {".smurf-lint.yaml": data}, "{}")
        yield lint(f"a baseline: {title}", {"base.yaml": data}, "--baseline", "base.yaml", "{}")
        yield lint(f"a schema: {title}", {"s.json": data, ".smurf-lint.yaml": b"schemas: {sections: {a: s.json}}\n"}, "{}")
        yield lint(f"a list of what to leave out: {title}", {".smurf-lintignore": data}, ".")
    for name in (".smurf-lint.yaml", ".smurf-lintignore", ".gitignore", "base.yaml"):
        words = ("--baseline", "base.yaml", "{}") if name == "base.yaml" else (".",)
        yield lint(f"{name} that is a pipe", {name: FIFO}, *words)
        yield lint(f"{name} that is a device", {name: link("/dev/zero")}, *words)
        yield lint(f"{name} that is a link to itself", {name: link(name)}, *words)
    yield lint("configurations that extend each other", {
        ".smurf-lint.yaml": b"extend: b.yaml\n", "b.yaml": b"extend: .smurf-lint.yaml\n"}, "{}")
    yield lint("a pattern of a megabyte", {".gitignore": b"*a" * (1 << 15) + b"\n"}, ".")
    yield lint("fixes of everything", {"r.urdf": XML_TEXTS["links of one name"]}, "--diff", "--unsafe-fixes", "{}")


def versions():
    """Two files of a megabyte each whose lists share no entry."""
    lists = {
        "names": ("sensors: [{name: s, type: Joint6DOF, link: l, id: [", ("x", "y"), "]}]\n"),
        "words": ("s: [", ("x", "y"), "]\n"),
        "mappings": ("s: [", ("{x: 1}", "{y: 1}"), "]\n"),
    }
    for title, (begin, items, end) in lists.items():
        old, new = ((begin + ",".join([item] * (900_000 // (len(item) + 1))) + end).encode() for item in items)
        yield Case(f"two lists of {title}", {"old.yml": old, "new.yml": new}, "old.yml", tools=("smurf-diff",),
                   words=("old.yml", "new.yml"))


def cases():
    return itertools.chain(texts(), truncations(), places(), shapes(), archives(), settings(), large(), versions())
