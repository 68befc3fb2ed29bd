# SPDX-License-Identifier: BSD-3-Clause
"""findings_test.py over the corpus, where there is one."""
import findings_test
import inputs
import pytest

FILES = inputs.corpus()
if not FILES:
    pytest.skip(f"there is no corpus in {inputs.CORPUS}", allow_module_level=True)


def test_corpus():
    faults, found = findings_test.differences(FILES)
    print(f"compared {len(FILES)} files with {found} findings")
    assert not faults, f"{len(faults)} of {len(FILES)}\n" + "\n\n".join(faults[:3])
