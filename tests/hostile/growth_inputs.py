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

    def arguments(self, size: int) -> list:
        """Those of the tool; a part of the command may be a function of the size."""
        return [one for part in self.command[1:] for one in (part(size) if callable(part) else [part])]

    def variables(self, size: int) -> dict:
        """Those of the environment, which may be functions of the size as well."""
        return {name: value(size) if callable(value) else value for name, value in self.environment.items()}

    def write(self, size: int, folder: pathlib.Path) -> None:
        def write(name: str, text) -> None:
            path = folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(text if isinstance(text, bytes) else text.encode())

        write.link = lambda name, target: (folder / name).symlink_to(target)
        self.make(size, write)


CASES: list = []


def grows(size: int, *command, **environment):
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


# Files: links, folders, ignore files

URDF = '<robot name="r"><link name="a"/></robot>'


def link_spellings(n: int) -> list:
    """Of this folder, where `l` and `m` are links to it."""
    return ["/".join("lm"[i >> bit & 1] for bit in range(13)) for i in range(n)]


@grows(30, "smurf-lint", "-q", "a.smurf")
def links_in_files(n, write):
    """The file grows as the number of its names does: read for each name, it would be quadratic."""
    write.link("l", ".")
    write.link("m", ".")
    write("b.yml", "foo:\n" + "- 1\n" * 40 * n)
    write("a.smurf", "modelname: a\nfiles:\n" + "".join(f"- {place}/b.yml\n" for place in link_spellings(n)))


@grows(30, "smurf-lint", "-q", "s.smurfs")
def links_in_scenes(n, write):
    write.link("l", ".")
    write.link("m", ".")
    write("b.yml", "foo:\n" + "- 1\n" * 40 * n)
    write("a.smurf", "modelname: a\nfiles: [b.yml]\n")
    write("s.smurfs", "smurfs:\n" + "".join(
        f"- {{name: e{i}, type: smurf, file: {place}/a.smurf}}\n" for i, place in enumerate(link_spellings(n))))


@grows(30, "smurf-lint", "-q", "a.urdf")
def spellings_of_a_material_library(n, write):
    write("m.mtl", "newmtl a\n" + "map_Kd x\n" * 40 * n)
    names = ["".join("./" if i >> bit & 1 else ".//" for bit in range(10)) + "m.mtl" for i in range(n)]
    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n" + "".join(f"mtllib {name}\n" for name in names))
    write("a.urdf", URDF.replace("/></robot>", '><visual><geometry><mesh filename="a.obj"/></geometry></visual></link></robot>'))


@grows(100, "smurf-lint", "-q", "--statistics", "a.smurf")
def missing_files_beside_many(n, write):
    for i in range(n):
        write(f"file_{i:05}_that_is_there.yml", "")
    write("a.smurf", "modelname: a\nfiles:\n" + "".join(f"- file_{i:05}_that_is_gone.yml\n" for i in range(n)))


@grows(50, "smurf-lint", "-q", "--statistics", "a.urdf",
       ROS_PACKAGE_PATH=lambda n: ":".join(f"/nonexistent{i}" for i in range(4 * n)))
def packages_in_many_folders(n, write):
    write("a.urdf", URDF.replace("/></robot>", ">" + "".join(
        f'<visual><geometry><mesh filename="package://p{i}/x"/></geometry></visual>' for i in range(n)) + "</link></robot>"))


@grows(20, "smurf-lint", "-q", "--only-listed", lambda n: [f"x{i}.yml" for i in range(n)])
def files_named_beside_models(n, write):
    for i in range(n):
        write(f"m{i}.smurf", f"modelname: a\nfiles: [x{i}.yml]\n")
        write(f"x{i}.yml", "motors: []\n")


@grows(20, "smurf-lint", "-q", "--only-listed", lambda n: [f"x{i}.stl" for i in range(n)])
def meshes_named_beside_robots(n, write):
    for i in range(n):
        write(f"m{i}.urdf", URDF)
        write(f"x{i}.stl", "solid\nendsolid\n")


@grows(20, "smurf-lint", "-q", "--shard", "1/2", ".")
def shards_of_models_and_robots(n, write):
    for i in range(n):
        write(f"m{i}.smurf", MODEL)
        write(f"x{i}.urdf", URDF)
