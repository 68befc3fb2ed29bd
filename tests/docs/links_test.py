#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Links of the documentation lead somewhere, in the repository and where a package installs it.

Usage: links_test.py CMAKE BUILD_FOLDER
"""
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
LINK = re.compile(r"(?<!\\)\]\(([^)\s]+)\)")
CODE = re.compile(r"```.*?```|`[^`\n]*`", re.S)


def slug(heading):
    """The anchor that GitHub gives a heading."""
    text = re.sub(r"[`*]|\[([^\]]*)\]\([^)]*\)", lambda match: match[1] or "", heading).strip().lower()
    return re.sub(r"[^\w\- ]", "", text).replace(" ", "-")


def anchors(path):
    text = path.read_text(encoding="utf-8")
    found = set(re.findall(r'<a id="([^"]+)"', text))
    for heading in re.findall(r"^#+ (.*)$", re.sub(r"```.*?```", "", text, flags=re.S), re.M):
        found.add(slug(heading))
    return found


def broken_links(page, known):
    for link in LINK.findall(CODE.sub("", page.read_text(encoding="utf-8"))):
        if re.match(r"[a-z]+:", link):
            continue
        name, _, anchor = link.partition("#")
        target = (page.parent / name).resolve() if name else page
        if not target.exists():
            yield link
        elif anchor and target.suffix == ".md":
            if target not in known:
                known[target] = anchors(target)
            if anchor not in known[target]:
                yield link


def check(folder, pages):
    known = {}
    count = 0
    for page in pages:
        for link in broken_links(page, known):
            print(f"{page.relative_to(folder)}: {link} leads nowhere")
            count += 1
    return count


def installed(cmake, build, prefix):
    """The folder with the documentation of a package."""
    subprocess.run([cmake, "--install", build, "--component", "documentation", "--prefix", prefix],
                   check=True, stdout=subprocess.DEVNULL)
    readmes = [path for path in pathlib.Path(prefix).resolve().rglob("README.md") if "docs" not in path.parts]
    if len(readmes) != 1:
        sys.exit(f"the package has {len(readmes)} README.md")
    return readmes[0].parent


def main():
    cmake, build = sys.argv[1:]
    pages = [*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")]
    count = check(ROOT, pages)
    with tempfile.TemporaryDirectory() as prefix:
        folder = installed(cmake, build, prefix)
        packed = sorted(folder.rglob("*.md"))
        missing = {page.relative_to(ROOT) for page in pages} - {page.relative_to(folder) for page in packed}
        for page in sorted(missing):
            print(f"{page} is not in the package")
        count += len(missing) + check(folder, packed)
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main())
