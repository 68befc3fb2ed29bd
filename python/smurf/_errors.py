# SPDX-License-Identifier: BSD-3-Clause
"""The exceptions of the module."""
from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, List

if TYPE_CHECKING:
    from ._smurf import Finding


class Error(Exception):
    """A file cannot be read, or its errors prevent the operation.

    `findings` is a list of smurf.Finding that say why; it may be empty.
    """

    findings: List[Finding]

    def __init__(self, message: str = "", findings: Iterable[Finding] = ()) -> None:
        # A path may contain an escape sequence of terminals.
        super().__init__("".join(c if c.isprintable() else f"\\u{ord(c):04x}" for c in message))
        self.findings = list(findings)

    def __str__(self) -> str:
        return "\n".join([super().__str__(), *map(str, self.findings[:10])])
