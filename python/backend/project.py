# SPDX-License-Identifier: BSD-3-Clause
"""The metadata of the project, read from its files."""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]


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


def metadata():
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
Provides-Extra: poses
Requires-Dist: numpy; extra == "poses"
Description-Content-Type: text/markdown

""" + (ROOT / "README.md").read_text(encoding="utf-8")
