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


@grows(3000, "smurf-lint", "-q", "a.smurf")
def markers_on_one_line(n, write):
    write("a.smurf", MODEL + "#" + " #smurf-lint:" * n + "\n")


@grows(1500, "smurf-lint", "-q", "a.smurf")
def comments_behind_many_values(n, write):
    write("a.smurf", MODEL + "x: [" + "1," * 8 * n + "1]\n" + "#smurf-lint:ignore[A]\n" * n)


@grows(1500, "smurf-lint", "-q", "a.urdf")
def comments_behind_many_elements(n, write):
    write("a.urdf", '<robot name="a"><link name="b"/>' + "<a/>" * 4 * n + "<!--smurf-lint:ignore[A]-->" * n + "</robot>")


# Schemas and configurations


def schema(write, text, section):
    write(".smurf-lint.yaml", "schemas: {sections: {foo: s.yaml}}\n")
    write("s.yaml", text)
    write("a.smurf", MODEL + f"foo: {section}\n")


@grows(400, "smurf-lint", "-q", "a.smurf")
def a_text_and_its_pattern(n, write):
    schema(write, "pattern: '" + "a*" * 20 + "b'\n", "a" * n)


@grows(2000, "smurf-lint", "-q", "a.smurf")
def required_keys_of_other_names(n, write):
    schema(write, "required: [" + ",".join(f"a{i}" for i in range(n)) + "]\n",
           "{" + ",".join(f"b{i}: 1" for i in range(n)) + "}")


@grows(2000, "smurf-lint", "-q", "a.smurf")
def values_that_are_none_of_many(n, write):
    schema(write, "items: {enum: [" + ",".join(str(i) for i in range(n)) + "]}\n",
           "[" + ",".join(f"a{i}" for i in range(n)) + "]")


@grows(1000, "smurf-lint", "-q", "--statistics", "a.smurf")
def rules_ignored_again_and_again(n, write):
    write(".smurf-lint.yaml", "ignore:\n" + "- SML9\n" * 8 * n)
    links = "".join(f'<link name="l{i}" x="1"/>' for i in range(n))
    write("a.urdf", f'<robot name="r">{links}</robot>')
    write("a.smurf", "modelname: a\nfiles: [a.urdf]\n")
