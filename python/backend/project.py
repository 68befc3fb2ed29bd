# SPDX-License-Identifier: BSD-3-Clause
"""The metadata of the project, read from its files."""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
VIEWER = ROOT / "build/viewer/viewer.html"


def _fact(file, pattern):
    found = re.search(pattern, (ROOT / file).read_text(encoding="utf-8"))
    if found is None:
        raise LookupError(f"{file} has no {pattern}")
    return found[1]


def name():
    return _fact("pyproject.toml", r'\nname = "([^"]+)"')


def version():
    return _fact("CMakeLists.txt", r"\n  VERSION ([0-9.]+)\n")


def homepage():
    return _fact("CMakeLists.txt", r'\n  HOMEPAGE_URL "([^"]+)"')


def site():
    """The address of the documentation of this version."""
    return _fact("CMakeLists.txt", r'SMURF_SITE "([^"]+)/\$').rstrip("/") + f"/{version()}/"


def summary():
    return _fact("CMakeLists.txt", r'\n  DESCRIPTION "([^"]+)"')


def stem():
    """What the names of a wheel, of its folders and of an sdist start with."""
    return f"{name().replace('-', '_')}-{version()}"


def readme():
    """README.md for a page elsewhere: links lead to the files of this version."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    relative = r"\]\((?![a-z]+:|#)([^)]+)\)"
    text = re.sub("(!\\[[^]]*)" + relative, rf"\1]({homepage()}/raw/v{version()}/\2)", text)
    return re.sub(relative, rf"]({homepage()}/blob/v{version()}/\1)", text)


def metadata(has_module=True):
    extra = 'Provides-Extra: mcp\nRequires-Dist: mcp>=2.3; extra == "mcp"\n'
    extra += 'Provides-Extra: poses\nRequires-Dist: numpy; extra == "poses"\n' if has_module else ""
    return f"""Metadata-Version: 2.1
Name: {name()}
Version: {version()}
Summary: {summary()}
Project-URL: Homepage, {homepage()}
License: BSD-3-Clause
Requires-Python: >=3.9
Classifier: Environment :: Console
Classifier: Intended Audience :: Science/Research
Classifier: License :: OSI Approved :: BSD License
Classifier: Topic :: Scientific/Engineering
{extra}Description-Content-Type: text/markdown

""" + readme()
