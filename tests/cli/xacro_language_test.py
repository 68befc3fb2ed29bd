# SPDX-License-Identifier: BSD-3-Clause
"""The language of xacro in one-line documents of our own: does each expand to what xacro makes of it?

usage: xacro_language_test.py SMURF2URDF TABLE [PYTHON]

A row of TABLE has the content of <robot> and the answer of xacro 2.1.1 under Python 3.11: the elements below the root and their
attributes, or ERROR; then names and contents of other files. UNSUPPORTED stands before answers that only xacro gives; there, our finding must be SML3304.
With a PYTHON that has the module xacro (and PyYAML), the answers of the table are compared with those of xacro instead.
"""
import concurrent.futures
import pathlib
import subprocess
import sys
import tempfile
import xml.dom.minidom

from xacro_corpus_test import canonical

LEAST_ROWS = 1900
SLOWEST = 20.0  # seconds
ASK = """
import sys, xacro
sys.stdout.write(xacro.process_file(sys.argv[1], verbosity=0).toprettyxml())
"""


def with_escapes(text):
    return text.replace("\\", "\\\\").replace("\n", "\\n").replace("\t", "\\t")


def without_escapes(text):
    names = {"n": "\n", "t": "\t", "r": "\r"}
    parts = text.split("\\\\")
    for name in names:
        parts = [part.replace("\\" + name, names[name]) for part in parts]
    return "\\".join(parts)


def answer(text):
    """The elements and attributes below the root."""
    lines = canonical(xml.dom.minidom.parseString(text).documentElement)[1:]
    return with_escapes(" ".join(
        path.split("/")[-1] + ("=" + value if value or "@" in path else "") for path, value in lines))


def rows_of(table):
    return [line.split("\t") for line in table.read_text("utf8").split("\n") if line and not line.startswith("#")]


def write_row(row, folder):
    """Writes the document as robot.xacro, and its other files."""
    document, _, *files = row
    for name, content in zip(files[::2], files[1::2]):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(without_escapes(content), encoding="utf8", newline="")
    folder.mkdir(exist_ok=True)
    path = folder / "robot.xacro"
    path.write_text('<robot xmlns:xacro="x">' + without_escapes(document) + "</robot>", encoding="utf8")


def check(row, command, folder, number):
    document, expected, *_ = row
    folder = pathlib.Path(folder) / str(number)
    write_row(row, folder)
    done = subprocess.run([*command, "robot.xacro"], cwd=folder, capture_output=True, timeout=SLOWEST, check=False)
    if done.returncode not in (0, 1):
        return f"{document}: exit code {done.returncode}: {done.stderr[-300:]}"
    said = answer(done.stdout) if done.returncode == 0 else "ERROR"
    if expected.startswith("UNSUPPORTED "):
        expected = expected[len("UNSUPPORTED "):]
        if "-c" not in command and said == "ERROR" and b"SML3304" in done.stderr:
            return ""
    return "" if said == expected else f"{document}: {expected!r}, but {said!r}"


def main():
    tool, table = sys.argv[1], pathlib.Path(sys.argv[2])
    command = [sys.argv[3], "-c", ASK] if len(sys.argv) > 3 else [tool]
    rows = rows_of(table)
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(2) as pool:
        found = pool.map(lambda item: check(item[1], command, folder, item[0]), enumerate(rows))
        failures = [failure for failure in found if failure]
    print("\n".join(failures))
    print(f"rows: {len(rows) - len(failures)} of {len(rows)}")
    return 1 if failures or len(rows) < LEAST_ROWS else 0


if __name__ == "__main__":
    sys.exit(main())
