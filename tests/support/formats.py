# SPDX-License-Identifier: BSD-3-Clause
"""The formats that a tool lists, so that no test has a list of its own."""
import re


def listed(text, without=("html",)):
    """The names in the text of --format help; pages are made by some builds only, and are large."""
    names = [name for name in re.findall(r"^  ([\w.]+) +\S", text, re.M) if name not in without]
    assert len(names) > 6, text
    return names
