# SPDX-License-Identifier: BSD-3-Clause
"""Inputs that were quadratic once, or could be: what growth_test.py counts the instructions for.

Each function writes an input of size n into the current case's folder. `size` is the smaller one: large enough that
what grows outweighs the start of the tool (some 10 million instructions), small enough for valgrind.
"""
import dataclasses
import pathlib
import typing


@dataclasses.dataclass
class Case:
    name: str
    size: int
    command: tuple
    environment: dict
    make: typing.Callable

    def write(self, size: int, folder: pathlib.Path) -> None:
        def write(name: str, text) -> None:
            path = folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(text if isinstance(text, bytes) else text.encode())

        self.make(size, write)


CASES: list = []


def grows(size: int, *command: str, **environment: str):
    """Adds a case: `@grows(1000, "smurf-lint", "a.smurf")` above a function of (n, write)."""

    def add(make):
        CASES.append(Case(make.__name__, size, command, environment, make))
        return make

    return add


MODEL = "modelname: a\nfiles: []\n"


# Comments


@grows(500, "smurf-lint", "-q", "a.smurf")
def markers_in_one_comment(n, write):
    write("a.smurf", MODEL + "#" + " #smurf-lint:ignore[A," * n + "]\n")
