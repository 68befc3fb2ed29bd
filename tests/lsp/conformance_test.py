# SPDX-License-Identifier: BSD-3-Clause
"""smurf-lsp, driven by the client library of VS Code: every answer is of the type that the protocol gives it.

conformance_test.py SMURF-LSP FOLDER...   Files of the folders. Ends with 77, which CTest shows as skipped, when node
                                          or a package is absent: scripts/setup --readers installs them.
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
MODULES = HERE.parent.parent / "build/readers/node_modules"
PACKAGES = ["vscode-languageserver-protocol", "typescript"]
KINDS = {".smurf", ".smurfs", ".smurfa", ".urdf", ".yml", ".yaml"}
LARGEST = 300_000  # bytes
MOST = 60  # files of a folder
SETTINGS = {"strict": True, "noEmit": True, "target": "es2022", "module": "nodenext",
            "moduleResolution": "nodenext", "skipLibCheck": True, "types": []}


def inputs(folder):
    """Files of all kinds, evenly selected from the folder."""
    found = sorted(one for one in folder.rglob("*")
                   if one.suffix in KINDS and one.is_file() and one.stat().st_size < LARGEST)
    return found[::max(1, len(found) // MOST)][:MOST]


def main():
    for package in PACKAGES:
        if shutil.which("node") is None or not (MODULES / package).is_dir():
            print(f"skipped: the npm package {package} is not installed; scripts/setup --readers installs it")
            return 77
    files = [one for folder in sys.argv[2:] for one in inputs(pathlib.Path(folder))]
    if not files:
        print("skipped: there are no files in " + ", ".join(sys.argv[2:]))
        return 77
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        (work / "node_modules").symlink_to(MODULES)
        (work / "tsconfig.json").write_text(json.dumps({"compilerOptions": SETTINGS, "files": ["answers.ts"]}))
        (work / "package.json").write_text('{"type": "module"}')
        driven = subprocess.run(["node", HERE / "conformance.mjs", MODULES, sys.argv[1], work / "answers.ts", *files],
                                check=False)
        if driven.returncode != 0:
            return 1
        compiled = subprocess.run(["node", MODULES / "typescript/bin/tsc", "-p", work], check=False)
        return 1 if compiled.returncode != 0 else 0


if __name__ == "__main__":
    sys.exit(main())
