# SPDX-License-Identifier: BSD-3-Clause
"""In python/, python3 -m backend FOLDER: puts the programs of a wheel into a folder, without pip."""
import pathlib
import sys
import tempfile

from .programs import MAIN, NoPrograms, gather, names_of_main


def main(arguments):
    if len(arguments) != 1:
        print(__doc__, file=sys.stderr)
        return 2
    with tempfile.TemporaryDirectory(prefix="smurf-") as work:
        try:
            programs, *_ = gather(pathlib.Path(work))
        except NoPrograms as problem:
            print(f"smurf-tools: {problem}", file=sys.stderr)
            return 2
    folder = pathlib.Path(arguments[0])
    folder.mkdir(parents=True, exist_ok=True)
    links = names_of_main(programs)
    for name, content in programs.items():
        (folder / name).unlink(missing_ok=True)
        if name in links:
            (folder / name).symlink_to(MAIN)
        else:
            (folder / name).write_bytes(content)
            (folder / name).chmod(0o755)
    return 0


sys.exit(main(sys.argv[1:]))
