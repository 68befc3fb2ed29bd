# SPDX-License-Identifier: BSD-3-Clause
"""Another build of smurf2urdf expands xacro to the bytes of the native one: rows of the language, and public robots.

usage: xacro_parity_test.py FOLDER_OF_TOOLS wasm|arm64|windows FOLDER_OF_BUILD TABLE SHARED

TABLE is fixtures/xacro/language.tsv. The robots are those of SHARED/xacro, if it is there.

Rows with a cube root are left out: that of glibc differs in the last digit from those of other C libraries.
"""
import pathlib
import sys
import tempfile

from builds import BUILDS, Native
from comparison import are_equal

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "cli"))
from xacro_corpus_test import LEAST_ENTRIES, entries_of  # noqa: E402
from xacro_language_test import LEAST_ROWS, rows_of, write_row  # noqa: E402


def language_jobs(table, folder):
    for number, row in enumerate(rows_of(table)):
        if "cbrt(" in row[0]:
            continue
        write_row(row, folder / str(number))
        yield "smurf2urdf", [f"{number}/robot.xacro"], folder


def robot_jobs(shared):
    for repository, name, arguments, *_ in entries_of(shared):
        yield "smurf2urdf", [f"{repository}/{name}", *arguments.split()], shared / "corpus"


def main():
    tools, kind, build = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2], pathlib.Path(sys.argv[3]).resolve()
    table, shared = pathlib.Path(sys.argv[4]), pathlib.Path(sys.argv[5]).resolve() / "xacro"
    BUILDS[kind].skip_without(tools, build)
    with tempfile.TemporaryDirectory(prefix="smurf-parity-") as folder, tempfile.TemporaryDirectory() as scratch:
        jobs = [*language_jobs(table, pathlib.Path(folder))]
        least = LEAST_ROWS
        if (shared / "entries.tsv").is_file():
            jobs += robot_jobs(shared)
            least += LEAST_ENTRIES
        else:
            print(f"there is no {shared}; only the rows of the language are compared")
        equal = are_equal(Native(tools), BUILDS[kind](build), jobs, pathlib.Path(scratch))
        sys.exit(not equal or len(jobs) < least)


main()
