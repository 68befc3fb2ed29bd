#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""run.py TEST.py: runs it by pytest; exit code 77, and a line that says why, where that cannot be."""
import importlib.util
import sys

missing = [name for name in ("pytest", "numpy") if importlib.util.find_spec(name) is None]
if missing:
    print(f"skipped: {' and '.join(missing)} not installed for {sys.executable} (scripts/setup --readers)")
    sys.exit(77)

import pytest  # noqa: E402

code = pytest.main(["-q", "-rs", "-p", "no:cacheprovider", *sys.argv[1:]])
# No tests were collected: the file skips itself as a whole.
sys.exit(77 if code == pytest.ExitCode.NO_TESTS_COLLECTED else code)
