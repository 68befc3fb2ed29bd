# SPDX-License-Identifier: BSD-3-Clause
"""Does libsmurf/src/sdf/schema.def say what libsdformat reads? Skipped without libsdformat 12, which has SDF 1.9.

Each element and attribute that libsdformat describes must be in the table, with its count, its type and its range.
What the table has besides must be of a later release.

sdf_schema_test.py SDF_ANSWERS
"""
import pathlib
import re
import subprocess
import sys

SCHEMA = pathlib.Path(__file__).resolve().parents[2] / "libsmurf/src/sdf/schema.def"
KINDS = {"": "", "string": "text", "char": "text", "unsigned int": "uint", "uint64_t": "uint"}
COUNTS = {"0": "?", "1": "!", "-1": "-"}
# Since SDF 1.10. `merge` of an include is read from the XML.
LATER = {"merge", "auto", "density", "auto_inertia_params", "screw_thread_pitch", "mimic", "multiplier", "offset",
         "reference", "cone", "optimization", "convex_decomposition"}
# Until SDF 1.6, as later files have them, too: sdf/checks.cpp says that they have no effect.
FORMER = {"use_parent_model_frame", "initial_position"}
LATER_PATHS = ("sdf/world/joint",)
# A lower bound of two numbers, which libsdformat does not compare.
UNBOUND = {"plane/size"}
FEWEST = 2000


def word(text):
    return f"{float(text.split()[0]):.10g}" if text else ""


def range_of(least, most):
    return f"[{word(least)},{word(most)}]" if least or most else ""


def types():
    """Name of a type: its rows as depth, name, count, kind, attributes."""
    found = {}
    for kind, row in re.findall(r"^SMURF_SDF(_TYPE)?\((.*)\)$", SCHEMA.read_text(encoding="utf-8"), re.M):
        first, name, count, value, attributes = re.fullmatch(
            r'(\d+|"\w+"), "(@?\w+)", \'(.)\', "([^"]*)", "([^"]*)"', row).groups()
        if kind:
            rows = found.setdefault(first.strip('"'), [])
            first = 0
        rows.append((int(first), name, count, value, attributes.split()))
    return found


def walk(all_types, name, outer, found, is_open=True):
    """Paths with what the table says of them. A path has each name once, as in the program."""
    path, hidden = [], None
    for depth, element, count, kind, attributes in all_types[name]:
        if hidden is not None and depth > hidden:
            continue
        hidden = None
        path = path[:depth]
        if element.startswith("@"):
            own = all_types[element[1:]][0][1]
            if own not in outer + path:
                walk(all_types, element[1:], outer + path, found)
            continue
        path.append(element)
        if path.count(element) + outer.count(element) > 1:
            hidden = depth
            continue
        whole = "/".join(outer + path)
        found[whole] = (count, kind)
        for one in attributes:
            key, _, value = one.partition(":")
            found[f"{whole}/@{key.rstrip('!')}"] = ("!" if key.endswith("!") else "?", value or "text")


def main():
    program = pathlib.Path(sys.argv[1])
    if not program.exists():
        print("skipped: there is no libsdformat 12; on Debian, libsdformat-dev has it")
        sys.exit(77)
    done = subprocess.run([program, "--descriptions"], capture_output=True, text=True, check=True, timeout=60)
    found = {}
    walk(types(), "root", [], found)
    wrong, known = [], set()
    for line in done.stdout.splitlines():
        what, path, required, kind, least, most = line.split("\t")
        path = path.lstrip("/")
        # The table has one row for all models and all states; plugins may contain anything.
        if "/plugin/" in path and "/plugin/@" not in path:
            continue
        known.add(path)
        row = found.get(path)
        if row is None:
            wrong.append(f"{path} is not in the table")
            continue
        kind = KINDS.get(kind, kind)
        bounds = "" if "/".join(path.split("/")[-2:]) in UNBOUND or what == "attribute" else range_of(least, most)
        wanted = (COUNTS.get(required, required), kind + bounds)
        if row != wanted and row[1] != "any":
            wrong.append(f"{path} is {row}, not {wanted}")
    for path in set(found) - known:
        if not (LATER | FORMER) & set(path.replace("@", "").split("/")) and not path.startswith(LATER_PATHS):
            wrong.append(f"{path}: libsdformat does not know it")
    print(f"{len(known)} elements and attributes compared")
    assert not wrong, "\n".join(wrong[:60]) + f"\n{len(wrong)}"
    assert len(known) > FEWEST


main()
