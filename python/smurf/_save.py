# SPDX-License-Identifier: BSD-3-Clause
"""Writes a file as a whole or not at all, as the programs do."""
from __future__ import annotations

import os
import tempfile
from typing import Union

Path = Union[str, bytes, "os.PathLike[str]", "os.PathLike[bytes]"]


def save(path: Path, content: bytes) -> None:
    """Replaces the file at `path`; through a symbolic link, its target. Raises OSError, and leaves the file as it was."""
    place = os.path.realpath(os.fsdecode(path))
    if os.path.exists(place) and not os.path.isfile(place):  # a pipe or a terminal
        with open(place, "wb") as file:
            file.write(content)
        return
    with tempfile.NamedTemporaryFile(dir=os.path.dirname(place), prefix=".smurf-", suffix=".tmp", delete=False) as file:
        try:
            file.write(content)
            file.flush()
            os.chmod(file.name, _mode_of(place))
            os.replace(file.name, place)
        except BaseException:
            os.unlink(file.name)
            raise


def _mode_of(place: str) -> int:
    try:
        return os.stat(place).st_mode & 0o777
    except FileNotFoundError:
        mask = os.umask(0)
        os.umask(mask)
        return 0o666 & ~mask
