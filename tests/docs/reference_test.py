#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The reference of the library is made without warnings, and every class in it has a sentence; members whose names say
everything need none. Skips without doxygen.

Usage: reference_test.py
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
MEMBER = re.compile(r": warning: (?:Member|parameters of member) .* (?:is|are) not (?:\(all\) )?documented")


def main():
    if not shutil.which("doxygen"):
        print("skipped: doxygen is not installed")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        settings = (ROOT / "docs/Doxyfile").read_text() + f"\nOUTPUT_DIRECTORY = {folder}\nEXTRACT_ALL = NO\n"
        run = subprocess.run(["doxygen", "-"], cwd=ROOT, input=settings, capture_output=True, text=True)
        pages = [path.name for path in pathlib.Path(folder, "html").glob("*.html")]
    warnings = [line for line in run.stderr.splitlines() if not MEMBER.search(line)]
    print("\n".join(warnings))
    for page in ("index.html", "classsmurf_1_1Session.html", "structsmurf_1_1LinkedModel.html"):
        if page not in pages:
            warnings.append(page)
            print(f"there is no page {page}")
    return 1 if run.returncode != 0 or warnings else 0


if __name__ == "__main__":
    sys.exit(main())
