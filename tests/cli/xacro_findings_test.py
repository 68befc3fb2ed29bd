# SPDX-License-Identifier: BSD-3-Clause
"""Public robots of xacro: are the findings those of the expansion, moved to the bytes that made it?

usage: xacro_findings_test.py XACRO-FINDINGS SHARED-FOLDER; exits with 77 (skipped) without that folder.
"""
import pathlib
import subprocess
import sys

LEAST = 204


def main():
    program, shared = sys.argv[1], pathlib.Path(sys.argv[2]).resolve() / "xacro"
    if not (shared / "entries.tsv").is_file():
        print(f"skipped: there is no {shared}")
        return 77
    rows = [line.split("\t") for line in (shared / "entries.tsv").read_text("utf8").splitlines() if line[0] != "#"]
    lines = "".join(f"corpus/{row[0]}/{row[1]}\t{row[2]}\n" for row in rows)
    done = subprocess.run([program], input=lines, text=True, cwd=shared, timeout=3000, check=False)
    return done.returncode if len(rows) >= LEAST else 1


if __name__ == "__main__":
    sys.exit(main())
