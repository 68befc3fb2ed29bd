# SPDX-License-Identifier: BSD-3-Clause
"""Lists the files of the site for its service worker, and leads the root to the version. usage: offline.py SITE VERSION

The version is a folder of SITE. Files of the playground have another worker.
"""
import hashlib
import json
import pathlib
import sys

REDIRECT = """<!DOCTYPE html>
<html lang="en"><meta charset="utf-8"><title>smurf</title>
<meta http-equiv="refresh" content="0; url={version}/"><link rel="canonical" href="{version}/">
<a href="{version}/">smurf {version}</a></html>
"""


def main(site, version):
    folder = site / version
    files = sorted(file for file in folder.rglob("*") if file.is_file() and is_kept(file.relative_to(folder)))
    digest = hashlib.sha256()
    for file in files:
        digest.update(file.read_bytes())
    names = [address_of(file.relative_to(folder).as_posix()) for file in files]
    text = (pathlib.Path(__file__).parent / "sw.js").read_text(encoding="utf-8")
    text = text.replace("@SUM@", digest.hexdigest()[:16]).replace("/* @FILES@ */", ", ".join(map(json.dumps, names)))
    (folder / "sw.js").write_text(text, encoding="utf-8")
    (site / "index.html").write_text(REDIRECT.format(version=version), encoding="utf-8")


def is_kept(path):
    return path.parts[0] != "playground" and path.name not in ("sw.js", "404.html") and path.suffix not in (".map", ".gz")


def address_of(name):
    """A page is asked for by its folder."""
    return "./" + name.removesuffix("index.html") if name.endswith("index.html") else "./" + name


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), sys.argv[2])
