# SPDX-License-Identifier: BSD-3-Clause
"""What is written where a value belongs: {kind: (text, is_same)}.

`is_same` says that the author can have meant nothing but the undamaged value, so that a reader that
loads it should make the same robot of it. Where another value is written that is a good one as
well, or where nothing is left, readers are free.
"""


def number_kinds(value):
    whole = value if "." in value else value + ".0"
    return {
        "word": ("foo", True), "comma": (whole.replace(".", ","), True), "unit": (value + "m", True),
        "many": (f"{value} {value}", True), "nan": ("nan", False), "inf": ("inf", False),
        "minus-inf": ("-inf", False), "negative": (f"-{value}".replace("--", ""), False),
        "zero": ("0", False), "empty": ("", False), "blank": (" ", False),
        "exponent": (f"{float(value):e}", True), "hex": ("0x1", False), "plus": (f"+{value}", True),
        "dot": (value.rstrip("0") if value.endswith(".0") else f"{whole}00", True),
        "huge": ("1e400", False), "large": ("1e30", False), "tiny": ("1e-30", False),
        "vanishing": ("1e-400", False), "leading": (f" {value}", True),
        "trailing": (f"{value} ", True), "tab": (f"{value}\t", True), "newline": (f"\n{value}", True),
        "percent": ("%s", False), "xacro": ("${width}", False), "wide": ("\uff11", False),
        "fraction": ("1/2", False), "degrees": (f"{value}\u00b0", True), "quoted": (f"'{value}'", True),
    }


CORE = ("word", "comma", "unit", "many", "nan", "inf", "negative", "zero", "empty", "huge", "trailing",
        "few", "commas", "tiny", "plus")


def vector_kinds(value):
    """Damages one of its numbers, the second, or all of them together."""
    parts = value.split()
    kinds = {}
    for kind, (text, is_same) in number_kinds(parts[1]).items():
        if kind not in ("many", "zero", "blank", "leading", "trailing", "newline", "tab"):
            kinds[kind] = (" ".join([parts[0], text, *parts[2:]]), is_same)
    kinds["first-word"] = (" ".join(["foo", *parts[1:]]), True)
    kinds["last-unit"] = (" ".join([*parts[:-1], parts[-1] + "m"]), True)
    kinds.update({
        "zero": (" ".join("0" for _ in parts), False), "all-negative": (
            " ".join(f"-{part}".replace("--", "") for part in parts), False),
        "few": (" ".join(parts[:-1]), True), "one": (parts[0], True), "many": (f"{value} 1", True),
        "commas": (", ".join(parts), True), "close-commas": (",".join(parts), True),
        "semicolons": ("; ".join(parts), True), "tabs": ("\t".join(parts), True),
        "newlines": ("\n".join(parts), True), "double-blanks": ("  ".join(parts), True),
        "leading": (f" {value}", True), "trailing": (f"{value} ", True), "tab": (f"{value}\t", True),
        "newline": (f"\n{value}", True), "nothing": ("", False), "blank": (" ", False),
        "brackets": (f"[{value}]", True),
    })
    return kinds


def axis_kinds(value):
    return {**vector_kinds(value), "not-unit": ("0 2 0", False), "noise": ("0 1e-10 1", False),
            "more-noise": ("0 1e-7 1", False), "tiny-all": ("0 0 1e-9", False),
            "tiny-more": ("0 0 1e-16", False), "negated": ("0 0 -1", False)}


def name_kinds(value, others):
    """`others` are other existing names."""
    kinds = {
        "unknown": ("nowhere", False), "empty": ("", False), "blank": (" ", False),
        "leading": (f" {value}", True), "trailing": (f"{value} ", True),
        "case": (value.upper(), True), "percent": (value + "%s", False), "slash": (f"a/{value}", False),
        "inner-blank": (f"{value} b", False), "accent": (value + "\u00e9", False),
        "world": ("world", False), "reserved": (f"__{value}__", False), "colons": (f"a::{value}", False),
        "xacro": ("${prefix}" + value, False), "digit": ("1", False), "long": (value * 200, False),
        "tab": (f"{value}\t", True), "amp": (f"{value}&", False), "dot": (f"{value}.", False),
    }
    kinds.update({f"as-{other}": (other, False) for other in others if other != value})
    return kinds


def path_kinds():
    names = {
        "missing": "gone.stl", "missing-folder": "gone/gone.stl", "empty": "", "blank": " ",
        "leading": " cube.stl", "trailing": "cube.stl ", "case": "CUBE.STL", "upper": "CUBE2.STL",
        "ascii": "ascii.stl", "broken": "broken.stl", "no-bytes": "empty.stl", "pointer": "pointer.stl",
        "obj": "cube.obj", "dae": "cube.dae", "other-format": "obj_in.stl",
        "other-format-obj": "stl_in.obj", "unknown-ending": "cube.xyz", "no-ending": "cube",
        "picture": "cube.png", "folder": ".", "dotted": "./cube.stl", "parent": "../gone.stl",
        "backslash": "gone\\cube.stl", "absolute": "/gone/cube.stl", "home": "~/cube.stl",
        "package": "package://nowhere/cube.stl", "package-bare": "package://", "model": "model://nowhere/cube.stl",
        "file": "file://cube.stl", "file-missing": "file:///gone/cube.stl", "http": "http://localhost/cube.stl",
        "percent": "%s.stl", "xacro": "${name}.stl", "find": "$(find nowhere)/cube.stl", "accent": "w\u00fcrfel.stl",
        "inner-blank": "my cube.stl", "number": "1",
    }
    return {kind: (name, kind == "dotted") for kind, name in names.items()}


def word_kinds(value):
    """Values of an attribute with few allowed words, or with free text."""
    return {"unknown": ("foo", False), "empty": ("", False), "blank": (" ", False), "case": (value.upper(), True),
            "title": (value.title(), True), "leading": (f" {value}", True), "trailing": (f"{value} ", True),
            "number": ("1", False), "percent": ("%s", False)}


JOINT_TYPES = ("fixed", "revolute", "continuous", "prismatic", "floating", "planar", "spherical", "ball",
               "universal", "screw", "hinge", "rotational", "world")
VECTORS = {"xyz", "rpy", "rgba", "size", "scale"}
NAMES = {"name", "link", "joint", "reference"}


def kinds_of(element, attribute, value, names):
    """`names` has lists of names by tag, for names that occur more than once."""
    if element.tag == "axis":
        return axis_kinds(value)
    if attribute in VECTORS:
        return vector_kinds(value)
    if attribute == "filename":
        return path_kinds() if element.tag == "mesh" else {
            kind: path_kinds()[kind] for kind in ("missing", "empty", "trailing", "backslash", "package")}
    if attribute == "type":
        return {**word_kinds(value), **{kind: (kind, False) for kind in JOINT_TYPES if kind != value}}
    if attribute == "version":
        return {kind: (text, False) for kind, text in (
            ("empty", ""), ("blank", " "), ("1", "1"), ("1.1", "1.1"), ("1.2", "1.2"), ("2.0", "2.0"), ("0.9", "0.9"),
            ("word", "foo"), ("trailing", "1.0 "), ("leading", " 1.0"), ("three", "1.0.0"), ("negative", "-1.0"),
            ("comma", "1,0"), ("dot", "1."))}
    if attribute in NAMES:
        tag = "joint" if attribute == "joint" or element.tag == "joint" else "link"
        return name_kinds(value, names.get(tag if element.tag not in ("material", "robot") else "", []))
    if " " in value:
        return vector_kinds(value)
    return number_kinds(value) if value[-1].isdigit() else word_kinds(value)
