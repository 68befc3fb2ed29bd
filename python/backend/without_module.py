# SPDX-License-Identifier: BSD-3-Clause
"""The programs of smurf-tools, without the Python module: `python3 -m smurf lint ...` runs smurf-lint."""

__version__ = "@VERSION@"


def __getattr__(name):
    if name.startswith("__"):
        raise AttributeError(name)
    raise AttributeError(f"smurf.{name} needs the Python module, and this package was installed with the programs only; "
                         "docs/python.md of smurf-tools says how the module is built")
