# SPDX-License-Identifier: BSD-3-Clause
"""findings_test.py on the corpus, if it exists."""
import findings_test
import inputs
import pytest

FILES = inputs.corpus()
if not FILES:
    pytest.skip(f"there is no corpus in {inputs.CORPUS}", allow_module_level=True)


def test_corpus():
    # For a single URDF, smurf-lint looks for models around it; the library checks only the file.
    alone = [path for path in FILES if path.suffix != ".urdf" or not list(path.parent.glob("../smurf/*.smurf"))]
    assert len(alone) > 400
    faults, found = findings_test.differences(alone)
    print(f"compared {len(alone)} files with {found} findings")
    assert not faults, f"{len(faults)} of {len(alone)}\n" + "\n\n".join(faults[:3])
