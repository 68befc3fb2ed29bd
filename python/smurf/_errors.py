# SPDX-License-Identifier: BSD-3-Clause
"""The exceptions of the module."""


class Error(Exception):
    """A file cannot be read, or its errors prevent the operation.

    `findings` is a list of smurf.Finding that say why; it may be empty.
    """

    def __init__(self, message="", findings=()):
        super().__init__(message)
        self.findings = list(findings)

    def __str__(self):
        return "\n".join([super().__str__(), *map(str, self.findings[:10])])
