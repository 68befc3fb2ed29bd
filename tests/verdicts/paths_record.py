#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Gives the robots of paths.py or texts.py to their readers, and writes paths_executed.tsv or texts_executed.tsv.

usage: paths_record.py BUILD paths|texts [READER...] [--keep FOLDER]

With names of readers, only their columns are written again. --keep leaves the robots, and what each reader said, in FOLDER.
"""
import argparse
import datetime
import json
import os
import pathlib
import tempfile

import executed
import paths
import texts

SETS = {"paths": paths.all_cases, "texts": texts.all_cases}


def table_of(name):
    return pathlib.Path(__file__).resolve().parent / f"{name}_executed.tsv"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("set", choices=SETS)
    parser.add_argument("readers", nargs="*")
    parser.add_argument("--keep", type=pathlib.Path)
    options = parser.parse_args()
    if options.set == "paths":
        os.environ["SMURF_SIZES"] = "1"  # needs a package.xml
    executed.FOLDER = "/"  # Bullet looks in the working folder, too
    found, absent = executed.readers(options.build.resolve())
    # urdf-loader opens no meshes; the files of MuJoCo's module for node are those beside the URDF.
    chosen = [reader for reader in found if reader.name not in ("urdf-loader", "MuJoCo") and (not options.readers or reader.name in options.readers)]
    cases, table = SETS[options.set](), table_of(options.set)
    versions, rows = executed.read_table(table) if table.exists() else ({}, {})
    rows = {name: rows.get(name, {}) for name in cases}
    for reader in chosen:
        with tempfile.TemporaryDirectory() as scratch:
            folder = (options.keep or pathlib.Path(scratch)).resolve() / reader.name
            files = paths.write(cases, folder, reader.text_of)
            said = executed.read_all(reader, [str(path) for path in files.values()])
            if options.keep:
                (folder / "said.json").write_text(json.dumps({name: said[str(path)] for name, path in files.items()}, indent=1))
        versions[reader.name] = reader.version
        for name, case in cases.items():
            rows[name][reader.name] = paths.cell_of(reader.name, case, said[str(files[name])])
        print(f"{reader.name} {reader.version}", flush=True)
        executed.write_table(table, datetime.date.today().isoformat(), versions, {
            name: {reader: cells.get(reader, "") for reader in versions} for name, cells in rows.items()}, f"{options.set}.py", "paths_record.py")
    print("absent:", ", ".join(absent) or "none")


if __name__ == "__main__":
    main()
