#!/usr/bin/env python3
"""Seeds of the fuzz targets out of the fixtures: seeds.py FIXTURES OUT writes OUT/TARGET/*.

A model or scene of several files becomes one text, with a line that names it before each file.
"""
import base64
import hashlib
import io
import json
import pathlib
import re
import struct
import sys
import zipfile

LARGEST = 20000  # bytes; libFuzzer makes no progress with large inputs
MESHES = {".stl", ".obj", ".dae", ".bobj", ".gltf", ".glb"}
# From the reader of bundles itself: with another mark, a bundle would be one file that nobody can read.
MARK = re.search(r'kBundleMark = "(.+?)"', (pathlib.Path(__file__).parent / "bundle.hpp").read_text()).group(1).encode()
YAML = {".yml", ".yaml", ".smurf", ".smurfs", ".smurfa"}


def main() -> None:
    fixtures, out = map(pathlib.Path, sys.argv[1:3])

    def add(target: str, data: bytes) -> None:
        if len(data) <= LARGEST:
            (out / target).mkdir(parents=True, exist_ok=True)
            (out / target / hashlib.sha1(data).hexdigest()[:16]).write_bytes(data)

    for data in streams():
        add("lsp", data)
    for data in xacros(fixtures / "xacro" / "language.tsv"):
        add("xacro", data)
    for data in gltfs():
        add("meshes", data)
    for data in schemas():
        add("schemas", data)
    for path in sorted(fixtures.rglob("*")):
        if not path.is_file() or "crashes" in path.parts:
            continue
        if path.suffix in {".urdf", ".yml"}:
            add("lsp", path.read_bytes())
        if path.suffix.lower() in MESHES:
            add("meshes", path.read_bytes())
        if path.suffix == ".urdf":
            add("urdf", path.read_bytes())
            add("differential_urdf", path.read_bytes())
        elif path.name == "robot.urdf.xacro":
            add("xacro", bundle(path, path.parent, "r.urdf.xacro"))
        elif path.suffix in YAML:
            add("differential_yaml", path.read_bytes())
        elif path.suffix in {".mjcf", ".sdf"} or (path.suffix == ".xml" and is_mjcf(path)):
            add("imports", bundle(path, path.parent, "r.xml"))
        if path.name == "package.xml" and (path.parent / "robot.urdf.xacro").exists():
            add("package", package(path.parent))
        if path.name == ".smurf-lint.yaml":
            add("config", path.read_bytes())
        if path.suffix == ".smurf":
            bundled = bundle(path, path.parent, "r.smurf")
            add("model", bundled)
            add("fixes", bundled)
        elif path.suffix == ".smurfs":
            add("scene", bundle(path, path.parent, "s.smurfs"))
            for method in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
                add("archives", archive(path.parent, method))


def is_mjcf(path: pathlib.Path) -> bool:
    return b"<mujoco" in path.read_bytes()[:500]


def package(folder: pathlib.Path) -> bytes:
    """All texts of a ROS package, in a folder `p`."""
    return b"".join(file("p/" + str(path.relative_to(folder)), path.read_bytes())
                    for path in sorted(folder.rglob("*")) if path.is_file() and path.suffix not in MESHES)


def streams() -> list[bytes]:
    """Messages to the language server: a session, one with requests too early, and malformed ones."""
    uri = {"uri": "file:///nowhere-at-all/r.urdf"}
    place = {"line": 0, "character": 20}
    messages = [
        {"id": 1, "method": "initialize", "params": {"capabilities": {}}},
        {"method": "initialized", "params": {}},
        {"method": "textDocument/didOpen", "params": {"textDocument": {
            **uri, "version": 1, "text": '<robot name="r"><link name="a"/></robot>'}}},
        {"method": "textDocument/didChange", "params": {"textDocument": {**uri, "version": 2}, "contentChanges": [
            {"range": {"start": place, "end": {"line": 9, "character": 9}}, "text": "<link "}]}},
        {"id": 2, "method": "textDocument/completion", "params": {"textDocument": uri, "position": place}},
        {"id": "3", "method": "textDocument/rename", "params": {"textDocument": uri, "position": place, "newName": "b"}},
        {"method": "$/cancelRequest", "params": {"id": 2}},
        {"method": "textDocument/didClose", "params": {"textDocument": uri}},
        {"id": 4, "method": "shutdown"},
        {"method": "exit"},
    ]

    def framed(content: bytes) -> bytes:
        return b"Content-Length: %d\r\n\r\n%b" % (len(content), content)

    whole = [framed(json.dumps({"jsonrpc": "2.0", **one}).encode()) for one in messages]
    malformed = [framed(b"{"), framed(b"[[[["), framed(b"\xff"), b"Content-Length: 99\r\n\r\n{}",
                 b"Content-Length: -1\r\n\r\n{}"]
    return [b"".join(whole), b"".join(whole[2:]), *(b"".join([*whole[:3], one, *whole[4:]]) for one in malformed)]


def xacros(table: pathlib.Path) -> list[bytes]:
    """One robot a row, with its other files."""
    def plain(text: str) -> str:
        return "\\".join(part.replace("\\n", "\n").replace("\\t", "\t").replace("\\r", "\r") for part in text.split("\\\\"))

    found = []
    for row in table.read_text("utf8").split("\n")[1:-1]:
        document, _, *files = map(plain, row.split("\t"))
        texts = [file("r.urdf.xacro", f'<robot name="r" xmlns:xacro="x">{document}</robot>'.encode())]
        texts += [file(name, content.encode()) for name, content in zip(files[::2], files[1::2])]
        found.append(b"".join(texts))
    return found


def gltfs() -> list[bytes]:
    """A triangle as text and binary, in a separate file, and with nodes."""
    points = struct.pack("<9f3B", 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 2) + b"\0"
    file = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "children": [1], "scale": [1, 2, 3]}, {"mesh": 0, "rotation": [0, 0, 1, 0]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0, "mode": 4}]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
                      {"bufferView": 1, "componentType": 5121, "count": 3, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36, "byteStride": 12}, {"buffer": 0, "byteOffset": 36, "byteLength": 3}],
        "buffers": [{"byteLength": 40}]}

    def text(**buffer) -> bytes:
        return json.dumps({**file, "buffers": [{"byteLength": 40, **buffer}]}).encode()

    own = text().ljust((len(text()) + 3) // 4 * 4)
    binary = struct.pack("<II", len(own), 0x4E4F534A) + own + struct.pack("<II", len(points), 0x004E4942) + points
    return [text(uri="data:;base64," + base64.b64encode(points).decode()), text(uri="m.bin"), text(),
            b"glTF" + struct.pack("<II", 2, 12 + len(binary)) + binary]


def schemas() -> list[bytes]:
    """Each keyword of a JSON schema, with a document that it judges."""
    values = {"a": [1, 2, 2, {"b": "wheel_1"}], "ab": {"b": 0.5, "c": None}, "wheel": "aaaaaaab", "n": 7}
    keywords = [
        {"type": ["object", "null"], "required": ["a", "x"]}, {"enum": [values, 1, "a"]}, {"const": values},
        {"properties": {"n": {"maximum": 9, "exclusiveMinimum": 0, "multipleOf": 0.5}, "wheel": {"minLength": 3, "maxLength": 9}}},
        {"patternProperties": {"^(a|ab)+$": {"type": "array"}, "\\w{2,5}": {}}, "additionalProperties": False},
        {"propertyNames": {"pattern": "^[a-z_]*?(?=l)\\S+$"}, "minProperties": 1, "maxProperties": 3},
        {"properties": {"a": {"items": [{}, {"type": "integer"}], "additionalItems": {"minimum": 3}, "uniqueItems": True, "maxItems": 3}}},
        {"properties": {"a": {"contains": {"required": ["b"]}, "items": {"type": ["integer", "object"]}, "minItems": 5}}},
        {"properties": {"wheel": {"pattern": "(a*)*b$", "format": "date"}}}, {"dependencies": {"a": ["x"], "ab": {"required": ["y"]}}},
        {"allOf": [{"$ref": "#/definitions/d"}], "definitions": {"d": {"anyOf": [{"$ref": "#/definitions/e"}, False]}, "e": {"not": {}}}},
        {"oneOf": [{"type": "object"}, {"minProperties": 2}], "if": {"required": ["a"]}, "then": {"maxProperties": 1}, "else": True},
        {"properties": {"ab": {"$ref": "#"}}, "additionalProperties": {"$ref": "#/properties/ab"}},
    ]
    return [file("schema.json", json.dumps(one).encode()) + file("values.yml", json.dumps({"s": values}).encode()) for one in keywords]


def archive(folder: pathlib.Path, method: int) -> bytes:
    """The texts of a folder; always the same bytes."""
    target = io.BytesIO()
    with zipfile.ZipFile(target, "w", method) as zipped:
        for path in sorted(folder.rglob("*")):
            if path.is_file() and path.suffix in YAML | {".urdf"}:
                zipped.writestr(zipfile.ZipInfo(str(path.relative_to(folder))), path.read_bytes(), method)
    return target.getvalue()


def file(name: str, text: bytes) -> bytes:
    """A file of a bundle."""
    return MARK + name.encode() + b"\n" + text + b"\n"


def bundle(entry: pathlib.Path, folder: pathlib.Path, name: str) -> bytes:
    """The entry under `name`, then the texts in its folder, below it, and in ../urdf."""
    texts = [file(name, entry.read_bytes())]
    beside = [*sorted(folder.rglob("*")), *sorted((folder.parent / "urdf").glob("*"))]
    for path in beside:
        if path.is_file() and path != entry and path.suffix in YAML | {".urdf", ".xacro"}:
            relative = path.relative_to(folder) if path.is_relative_to(folder) else "../urdf/" + path.name
            texts.append(file(str(relative), path.read_bytes()))
    return b"".join(texts)


if __name__ == "__main__":
    main()
