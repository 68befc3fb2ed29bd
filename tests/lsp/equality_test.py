# SPDX-License-Identifier: BSD-3-Clause
"""What smurf-lsp tells of a file is what smurf-lint finds in it: as it is, and after random edits, which the server
takes one by one and the linter reads afresh.

equality_test.py SMURF-LSP SMURF-LINT [--edits N] [--most FILES] FOLDER...
Ends with 77, which CTest shows as skipped, when a folder is absent.
"""
import argparse
import json
import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import client  # noqa: E402

KINDS = {".smurf", ".smurfs", ".smurfa", ".urdf", ".yml", ".yaml"}
LARGEST = 200_000  # bytes
MARK = "\ufeff"
SEVERITIES = {1: "error", 2: "warning", 3: "info"}


def of_linter(linter, path, position_of):
    """(id, severity, message, begin, end) of each finding in a file, places in UTF-16."""
    done = subprocess.run([linter, "--format", "json", "--only-listed", "--force-exclude", path], capture_output=True,
                          check=False, timeout=600)
    if done.returncode not in (0, 1):
        return None, done.stderr.decode(errors="replace")
    found = []
    for one in json.loads(done.stdout)["diagnostics"]:
        if os.path.normpath(one["file"]) != str(path):
            continue
        found.append((one["id"], one["severity"], one["message"], position_of(one["line"], one["column"]),
                      position_of(one["end_line"], one["end_column"])))
    return sorted(found), ""


def of_server(diagnostics, text):
    """The same for the linter. A byte order mark is a character in the protocol; the columns of the linter do not count it."""
    def position(place):
        is_behind_mark = text.startswith(MARK) and place["line"] == 0 and place["character"] > 0
        return place["line"], place["character"] - is_behind_mark
    return sorted((one["code"], SEVERITIES[one["severity"]], one["data"]["message"],
                   position(one["range"]["start"]), position(one["range"]["end"])) for one in diagnostics)


def positions_in(text):
    """Converts lines and characters, counted from 1, to those of the protocol."""
    lines = text.removeprefix(MARK).split("\n")

    def position_of(line, column):
        before = lines[line - 1][:column - 1] if line <= len(lines) else ""
        return line - 1, len(before.encode("utf-16-le")) // 2
    return position_of


def edit_of(text, rng):
    """Begin, end and the new text of typical edits: inserted, deleted and changed lines and characters."""
    if not text:
        return 0, 0, "a: 1\n"
    at = rng.randrange(len(text))
    begin = text.rfind("\n", 0, at) + 1
    end = text.find("\n", at) + 1 or len(text)
    return rng.choice([(begin, end, ""), (begin, begin, text[begin:end]), (at, at + 1, ""), (at, at, rng.choice("a1:<\" ")),
                       (at, at + 1, str(rng.randrange(10))), (at, at, "\N{ROBOT FACE}\N{LATIN SMALL LETTER E WITH ACUTE}"),
                       (begin, begin, "# smurf-lint: ignore[SML31] because\n")])


def compare(server, linter, path, edits, rng):
    """The differences, in words; "" if there are none."""
    server.open(path)
    for number in range(edits + 1):
        text = server.texts[str(path)]
        told = of_server(server.published(path), text)
        path.write_bytes(text.encode())
        found, problem = of_linter(linter, path, positions_in(text))
        if found is not None and told != found:
            return (f"{path} after {number} edits:\n  only told: {[one for one in told if one not in found]}\n"
                    f"  only found: {[one for one in found if one not in told]}\n{problem}")
        if number < edits:
            for _ in range(rng.randrange(1, 4)):  # several key strokes between two checks
                text = server.texts[str(path)]
                server.edit(path, *edit_of(text, rng))
    server.close(path)
    return ""


def files_in(folder, most):
    found = sorted(one for one in folder.rglob("*")
                   if one.suffix in KINDS and one.is_file() and one.stat().st_size < LARGEST and
                   one.name != "expected.yaml" and "\r" not in one.read_bytes().decode("latin-1"))
    found = [one for one in found if is_text(one)]
    return found[::max(1, -(-len(found) // most))] if most else found


def is_text(path):
    try:
        path.read_bytes().decode("utf-8")
        return True
    except UnicodeDecodeError:
        return False


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("server")
    parser.add_argument("linter")
    parser.add_argument("--edits", type=int, default=3)
    parser.add_argument("--most", type=int, default=0, help="files of each folder; 0: all")
    parser.add_argument("folders", nargs="+", type=pathlib.Path)
    options = parser.parse_args()
    linter = str(pathlib.Path(options.linter).resolve())
    count = 0
    different = []
    for folder in options.folders:
        if not folder.is_dir():
            print(f"skipped: there is no folder {folder}")
            return 77
        with tempfile.TemporaryDirectory(prefix="smurf-lsp-") as work:
            copy = pathlib.Path(work).resolve() / folder.name
            files = [one.relative_to(folder) for one in files_in(folder, options.most)]
            shutil.copytree(folder, copy, symlinks=False, ignore_dangling_symlinks=True)
            for name in files:
                server = client.Client(options.server, [copy], {"workspace": {}})
                before = (copy / name).read_bytes()
                different.append(compare(server, linter, copy / name, options.edits, random.Random(str(name))))
                (copy / name).write_bytes(before)
                server.end()
                count += 1
    different = [one for one in different if one]
    print(f"{count} files, {options.edits} edits each: {len(different)} differ")
    print("\n".join(different[:20]))
    return 1 if different or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
