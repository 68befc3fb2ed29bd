# SPDX-License-Identifier: BSD-3-Clause
"""The package where the compiled module is for other Pythons, or is not there: programs and conversions by them."""
import importlib.metadata
import pathlib
import re
import sys


def version():
    try:
        return importlib.metadata.version("smurf-tools")
    except importlib.metadata.PackageNotFoundError:
        return "unknown"


def attribute(name):
    """What the package answers to smurf.NAME."""
    if name.startswith("__"):
        raise AttributeError(name)
    files = (file.name for file in pathlib.Path(__file__).parent.glob("_smurf.cpython-*"))
    known = sorted({re.sub(r"_smurf\.cpython-(\d)(\d+).*", r"\1.\2", name) for name in files}, key=lambda text: int(text[2:]))
    why = f"has it for Python {', '.join(known)}" if known else "has the programs only"
    raise AttributeError(f"smurf.{name} needs the compiled module for Python {sys.version_info[0]}.{sys.version_info[1]}, and this package {why}; "
                         "docs/python.md of smurf-tools says how the module is built")
