# SPDX-License-Identifier: BSD-3-Clause
"""The result of Model.to_urdf()."""
from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, List

from ._save import Path, save

if TYPE_CHECKING:
    from ._smurf import Finding


class Urdf(bytes):
    """The bytes of a URDF. `losses` is a list of smurf.Finding: what the model has and the URDF does not express."""

    losses: List[Finding]

    def __new__(cls, content: bytes = b"", losses: Iterable[Finding] = ()) -> Urdf:
        urdf = super().__new__(cls, content)
        urdf.losses = list(losses)
        return urdf

    def save(self, path: Path) -> None:
        """Writes the bytes into a file, which is replaced as a whole."""
        save(path, self)
