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


# Scenes and what is made of them

ROBOT = '<robot name="r"><link name="b"/></robot>'
ENTITY = "- {name: e%d, type: urdf, file: r.urdf%s}\n"


def write_scene(write, entities, urdf=ROBOT):
    write("r.urdf", urdf)
    write("s.smurfs", "smurfs:\n" + "".join(entities))


def star(n, part='<link name="l%d"/>'):
    """A robot of n links around one."""
    return '<robot name="r"><link name="b"/>' + "".join(
        part % i + '<joint name="j%d" type="fixed"><parent link="b"/><child link="l%d"/></joint>' % (i, i)
        for i in range(n)) + "</robot>"


def flattens(size, *options):
    return grows(size, "smurfs-flatten", *options, "-q", "--force", "-o", "out", "s.smurfs")


def many_in_one_pose(n, write):
    write("r.smurf", "modelname: r\nfiles: [r.urdf, p.yml]\n")
    write("p.yml", "poses:\n- name: p\n  joints:\n" + "".join(f"    j{i}: 1\n" for i in range(n)))
    write_scene(write, (f"- {{name: e{i}, type: smurf, file: r.smurf, pose: p}}\n" for i in range(n)))


@flattens(400)
def instances_in_one_pose(n, write):
    many_in_one_pose(n, write)


@grows(400, "smurf-lint", "-q", "s.smurfs")
def instances_in_one_pose_checked(n, write):
    many_in_one_pose(n, write)


@flattens(400, "--dialect", "mars")
def instances_in_one_pose_to_mars(n, write):
    many_in_one_pose(n, write)


@flattens(5000)
def poses_of_one_model(n, write):
    write("r.smurf", "modelname: r\nfiles: [r.urdf, p.yml]\n")
    write("p.yml", "poses:\n" + "".join(f"- {{name: p{i}, joints: {{}}}}\n" for i in range(n)))
    write_scene(write, (f"- {{name: e{i}, type: smurf, file: r.smurf, pose: p{i}}}\n" for i in range(n)))


@flattens(1000, "--format", "svg")
def labels_of_a_picture(n, write):
    write_scene(write, (ENTITY % (i, f", position: [{i % 60}, {i // 60}, 0]") for i in range(n)))


@flattens(1000, "--format", "svg")
def labels_of_one_place(n, write):
    write_scene(write, (ENTITY % (i, "") for i in range(n)))


@flattens(1500, "--format", "sdf")
def names_alike_without_their_signs(n, write):
    signs = "!$%&()*+;<=>?@[]^{|}~"
    names = ("".join(signs[i // 21**k % 21] for k in range(4)) for i in range(n))
    write_scene(write, (f"- {{name: 'a{name}', type: urdf, file: r.urdf}}\n" for name in names))


@flattens(1500, "--format", "sdf")
def lights_of_one_name(n, write):
    write("r.urdf", ROBOT)
    write("s.smurfs", "smurfs:\n" + ENTITY % (0, "") + "lights:\n" + "- {name: l, position: {x: 0}}\n" * n)


@flattens(500, "--format", "sdf")
def anchors_on_one_robot(n, write):
    write_scene(write, (ENTITY % (i, ', anchor: "e0::b"' if i else "") if i else
                        "- {name: e0, type: urdf, file: big.urdf}\n" for i in range(n)))
    write("big.urdf", star(n))


@flattens(400, "--format", "sdf")
def materials_of_a_robot(n, write):
    shape = '<link name="l%d"><visual><geometry><sphere radius="1"/></geometry><material name="m"/></visual></link>'
    materials = "".join(f'<material name="n{i}"><color rgba="1 1 1 1"/></material>' for i in range(n))
    write_scene(write, [ENTITY % (0, "")],
                star(n, shape).replace("</robot>", materials + '<material name="m"><color rgba="1 0 0 1"/></material></robot>'))


def with_meshes(n, write):
    mesh = '<link name="l%d"><visual><geometry><mesh filename="m{}.stl"/></geometry></visual></link>'
    robot = star(n, mesh)
    for i in range(n):
        robot = robot.replace("{}", str(i), 1)
    write_scene(write, [ENTITY % (0, "")], robot)


@flattens(400, "--format", "sdf")
def meshes_of_a_robot(n, write):
    with_meshes(n, write)


@flattens(400, "--format", "mjcf")
def meshes_that_are_not_there(n, write):
    with_meshes(n, write)


@flattens(400, "--format", "mjcf")
def a_chain_of_bodies(n, write):
    write_scene(write, [ENTITY % (0, "")], '<robot name="r"><link name="l0"/>' + "".join(
        f'<link name="l{i}"/><joint name="j{i}" type="fixed"><parent link="l{i - 1}"/><child link="l{i}"/></joint>'
        for i in range(1, n)) + "</robot>")


@flattens(100_000, "--format", "urdf")
def dashes_in_a_comment(n, write):
    write_scene(write, [f"- {{name: 'a{'-' * n}', type: urdf, file: r.urdf}}\n"])


@flattens(50_000, "--format", "sdf")
def separators_in_a_name(n, write):
    write_scene(write, [ENTITY % (0, "")], f'<robot name="r"><link name="b{"::" * n}"/></robot>')


@grows(1000, "smurf2urdf", "-q", "--force", "--srdf", "r.srdf", "-o", "out.urdf", "r.smurf")
def states_of_a_robot(n, write):
    write("r.urdf", ROBOT)
    write("r.smurf", "modelname: r\nfiles: [r.urdf, p.yml]\n")
    write("p.yml", "poses:\n" + "".join(f"- {{name: p{i}, joints: {{}}}}\n" for i in range(n)))
