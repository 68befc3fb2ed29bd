# SPDX-License-Identifier: BSD-3-Clause
"""The exceptions of the module."""


class Error(Exception):
    """A file cannot be read, or its errors prevent the operation.

    `findings` is a list of smurf.Finding that say why; it may be empty.
    """

    def __init__(self, message="", findings=()):
        # A path may contain an escape sequence of terminals.
        super().__init__("".join(c if c.isprintable() else f"\\u{ord(c):04x}" for c in message))
        self.findings = list(findings)

    def __str__(self):
        return "\n".join([super().__str__(), *map(str, self.findings[:10])])
