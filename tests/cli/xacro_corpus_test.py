# SPDX-License-Identifier: BSD-3-Clause
"""xacro files of public robots, and one-line documents: is the expansion that of the reference?

usage: xacro_corpus_test.py SMURF2URDF SHARED-FOLDER; exits with 77 (skipped) without that folder.

The canonical form has one line a node, attribute or text: attributes sorted, comments and blanks between elements left
out. The recorded answers of xacro are in SHARED-FOLDER/xacro. Numbers may differ in the last digits of sines and cosines.
"""
import gzip
import math
import pathlib
import subprocess
import sys
import tempfile
import xml.dom.minidom

CLOSE = 1e-12  # relative
SLOWEST = 20.0  # seconds for one expansion, on a busy machine
LEAST_ENTRIES, LEAST_CASES = 204, 395


def canonical(node, path="", out=None):
    out = [] if out is None else out
    here = path + "/" + node.tagName
    out.append((here, ""))
    out += [(here + "@" + name, value) for name, value in sorted(node.attributes.items())
            if not name.startswith("xmlns")]
    counts, text = {}, ""
    for child in [*node.childNodes, None]:
        if child is not None and child.nodeType in (child.TEXT_NODE, child.CDATA_SECTION_NODE):
            text += child.data
        if child is not None and child.nodeType != child.ELEMENT_NODE:
            continue
        if text.strip():
            out.append((here + "#text", text.strip()))
        text = ""
        if child is not None:
            counts[child.tagName] = counts.get(child.tagName, 0) + 1
            mark = len(out)
            canonical(child, here, out)
            out[mark] = (here + "/" + child.tagName, child.getAttribute("name") or str(counts[child.tagName]))
    return out


def are_close(a, b):
    left, right = a.split(), b.split()
    try:
        return len(left) == len(right) and all(
            x == y or math.isclose(float(x), float(y), rel_tol=CLOSE, abs_tol=1e-300) for x, y in zip(left, right))
    except ValueError:
        return False


def expand(tool, path, words, folder):
    """The canonical lines; none with the reason if the tool refuses."""
    done = subprocess.run([tool, str(path), *words], cwd=folder, capture_output=True, timeout=SLOWEST, check=False)
    if done.returncode != 0:
        return None, done.stderr.decode("utf8", "replace")
    return canonical(xml.dom.minidom.parseString(done.stdout).documentElement), ""


def first_difference(expected, lines):
    """"" if equal. Paths of packages as CMake installs them are those of the sources here."""
    for wanted, (path, value) in zip(expected, lines):
        found = path + (" = " + value if value else "")
        if "{installed}" in wanted:
            found = found[:len(wanted.split("{installed}")[0])] + "{installed}" + \
                found[found.find(wanted.split("{installed}")[1].split("/config")[0]):]
        if wanted != found and not (wanted.startswith(path + " = ") and are_close(wanted[len(path) + 3:], value)):
            return f"{wanted!r}, but {found!r}"
    return "" if len(expected) == len(lines) else f"{len(expected)} lines, but {len(lines)}"


def entries_of(shared):
    """Repository, file, arguments and more of each robot."""
    return [line.split("\t") for line in (shared / "entries.tsv").read_text("utf8").splitlines() if line[0] != "#"]


def check_entries(tool, shared):
    rows = entries_of(shared)
    failures = []
    for number, row in enumerate(rows, 1):
        corpus = shared / "corpus"
        lines, reason = expand(tool, corpus / row[0] / row[1], row[2].split(), corpus)
        with gzip.open(shared / "expected" / f"{number:03}.txt.gz", "rt", encoding="utf8") as f:
            expected = f.read().splitlines()
        text = "\n".join(path + (" = " + value if value else "") for path, value in lines or [])
        lines = [tuple((line + " = ").split(" = ", 1)) for line in text.replace(str(corpus), "{corpus}").splitlines()]
        lines = [(path, value[:-3] if value.endswith(" = ") else value) for path, value in lines]
        reason = reason or first_difference(expected, lines)
        if reason:
            failures.append(f"{row[0]}/{row[1]} {row[2]}: {reason[:400]}")
    print(f"entries: {len(rows) - len(failures)} of {len(rows)}")
    return failures + ([] if len(rows) >= LEAST_ENTRIES else ["there are fewer entries than expected"])


def check_cases(tool, shared):
    rows = [line.split("\t") for line in (shared / "cases.tsv").read_text("utf8").splitlines() if line[0] != "#"]
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        for name, document, expected in rows:
            path = pathlib.Path(folder) / "case.xacro"
            path.write_text(document.replace("\\n", "\n").replace("\\t", "\t"), encoding="utf8")
            lines, _ = expand(tool, path, [], folder)
            said = "ERROR" if lines is None else " ".join(
                p.split("/")[-1] + ("=" + value if value or "@" in p else "") for p, value in lines[1:])
            if said != expected:
                failures.append(f"{name}: {expected!r}, but {said!r}")
    print(f"cases: {len(rows) - len(failures)} of {len(rows)}")
    return failures + ([] if len(rows) >= LEAST_CASES else ["there are fewer cases than expected"])


def main():
    tool, shared = sys.argv[1], pathlib.Path(sys.argv[2]) / "xacro"
    if not (shared / "entries.tsv").is_file():
        print(f"skipped: there is no {shared}")
        return 77
    failures = check_cases(tool, shared) + check_entries(tool, shared.resolve())
    print("\n".join(failures))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
