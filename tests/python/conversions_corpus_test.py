# SPDX-License-Identifier: BSD-3-Clause
"""Programs and module convert all public models and scenes alike."""
import inputs
import pytest
from conversions_test import compare


def test_corpus(tmp_path):
    paths = inputs.corpus()
    if not paths:
        pytest.skip("there is no corpus")
    exported, refused = compare(paths, tmp_path)
    assert exported > 1000 and exported + refused > 1500
