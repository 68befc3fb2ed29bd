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
        """The arguments of the tool; a part of the command may be a function of the size."""
        return [one for part in self.command[1:] for one in (part(size) if callable(part) else [part])]

    def variables(self, size: int) -> dict:
        """The environment variables, whose values may be functions of the size as well."""
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
    """In this folder, `l` and `m` are links to the folder itself."""
    return ["/".join("lm"[i >> bit & 1] for bit in range(13)) for i in range(n)]


@grows(30, "smurf-lint", "-q", "a.smurf")
def links_in_files(n, write):
    """The file grows in proportion to its number of names: reading it for each name would be quadratic."""
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


@grows(1000, "smurf-lint", "-q", "a.smurf")
def markers_on_one_line(n, write):
    write("a.smurf", MODEL + "#" + " #smurf-lint:" * n + "\n")


@grows(1500, "smurf-lint", "-q", "a.smurf")
def comments_behind_many_values(n, write):
    write("a.smurf", MODEL + "x: [" + "1," * 8 * n + "1]\n" + "#smurf-lint:ignore[A]\n" * n)


@grows(700, "smurf-lint", "-q", "a.urdf")
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


def looks(count, name):
    visual = '<visual><geometry><sphere radius="1"/></geometry><material name="%s"/></visual>'
    return "".join(visual % name(i) for i in range(count))


@flattens(500, "--format", "sdf")
def undefined_materials_of_one_link(n, write):
    write("r.smurf", "modelname: r\nfiles: [r.urdf]\n")
    write_scene(write, (f"- {{name: e{i}, type: smurf, file: r.smurf}}\n" for i in range(10)),
                f'<robot name="r"><link name="a">{looks(n, lambda i: f"m{i}")}</link></robot>')


@flattens(2000)
def poses_of_one_model(n, write):
    write("r.smurf", "modelname: r\nfiles: [r.urdf, p.yml]\n")
    write("p.yml", "poses:\n" + "".join(f"- {{name: p{i}, joints: {{}}}}\n" for i in range(n)))
    write_scene(write, (f"- {{name: e{i}, type: smurf, file: r.smurf, pose: p{i}}}\n" for i in range(n)))


@flattens(1000)
def uses_of_a_large_model(n, write):
    write_scene(write, (ENTITY % (i, "") for i in range(n)), star(n))


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


# Names of shapes, nodes, lists and files that are looked up for each entry


@grows(1000, "smurf-lint", "-q", "a.smurf")
def shapes_of_another_link(n, write):
    shapes = "".join(f'<collision name="c{i}"><geometry><sphere radius="1"/></geometry></collision>' for i in range(n))
    write("a.urdf", f'<robot name="a"><link name="big">{shapes}</link><link name="o"><collision name="x"><geometry>'
          '<sphere radius="1"/></geometry></collision></link><joint name="j" type="fixed"><parent link="big"/>'
          '<child link="o"/></joint></robot>')
    write("a.yml", "collision:\n" + "- {name: x, link: big}\n" * n)
    write("a.smurf", "modelname: a\nfiles: [a.urdf, a.yml]\n")


@grows(1000, "smurf-lint", "-q", "a.smurf")
def nodes_of_a_sensor(n, write):
    write("a.urdf", '<robot name="a"><link name="l"/></robot>')
    nodes = "".join(f"- {{name: n{i}, parent: l}}\n" for i in range(n))
    write("a.yml", f"nodes:\n{nodes}sensors:\n- name: s\n  type: NodePosition\n  id: [{', '.join(['n0x'] * n)}]\n")
    write("a.smurf", "modelname: a\nfiles: [a.urdf, a.yml]\n")


@grows(1000, "smurfs-flatten", "--dialect", "phobos", "-o", "a.json", "a.smurfs")
def entities_to_phobos(n, write):
    write("a.smurfs", "smurfs:\n" + "".join(f"- {{name: e{i}, type: box}}\n" for i in range(n)))


def mesh_of_many_names(n, write):
    """The file grows in proportion to its number of names: writing it for each name would be quadratic."""
    write.link("l", ".")
    write.link("m", ".")
    facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
    write("p.stl", "solid s\n" + facet * 40 * n + "endsolid s\n")
    write("r.urdf", '<robot name="r"><link name="a">' + "".join(
        f'<visual><geometry><mesh filename="{place}/p.stl"/></geometry></visual>' for place in link_spellings(n))
        + "</link></robot>")


@grows(30, "smurfs-flatten", "-q", "--format", "usda", "-o", "out", "r.urdf")
def mesh_of_many_names_to_usda(n, write):
    mesh_of_many_names(n, write)


@grows(30, "smurfs-flatten", "-q", "--format", "gltf", "-o", "out", "r.urdf")
def mesh_of_many_names_to_gltf(n, write):
    mesh_of_many_names(n, write)


@grows(30, "smurfs-flatten", "-q", "--format", "sdf", "--copy-assets", "copies", "-o", "out", "r.urdf")
def mesh_of_many_names_copied(n, write):
    mesh_of_many_names(n, write)


@grows(100, "smurfs-flatten", "-q", "--format", "sdf", "--copy-assets", "copies", "-o", "out", "r.urdf")
def files_of_a_mesh_copied(n, write):
    for i in range(n):
        write(f"t{i}/wood.png", "")
    images = ", ".join(f'{{"uri": "{way}t{i}/wood.png"}}' for i in range(n) for way in ("", "t0/../"))
    write("m.gltf", '{"asset": {"version": "2.0"}, "scenes": [{"nodes": []}], "images": [' + images + "]}")
    write("r.urdf", '<robot name="r"><link name="l"><visual><geometry><mesh filename="m.gltf"/></geometry></visual></link></robot>')


@grows(300, "smurf-lint", "-q", "r.urdf")
def nodes_and_accessors_of_gltf(n, write):
    accessors = ", ".join(['{"bufferView": 0, "componentType": 5126, "count": 300, "type": "VEC3"}'] * n)
    primitives = ", ".join(f'{{"attributes": {{"POSITION": {i}}}}}' for i in range(n))
    nodes = ", ".join(['{"mesh": 0}'] * n)
    write("m.gltf", f'{{"asset": {{"version": "2.0"}}, "scenes": [{{"nodes": {list(range(n))}}}], "nodes": [{nodes}], '
          f'"meshes": [{{"primitives": [{primitives}]}}], "accessors": [{accessors}], '
          '"bufferViews": [{"buffer": 0, "byteLength": 3600}], "buffers": [{"byteLength": 3600, "uri": "m.bin"}]}')
    write("m.bin", "\0" * 3600)
    write("r.urdf", '<robot name="r"><link name="l"><visual><geometry><mesh filename="m.gltf"/></geometry></visual></link></robot>')


@grows(300, "smurf-lint", "-q", "r.urdf")
def buffers_of_one_file(n, write):
    buffers = ", ".join([f'{{"byteLength": {96 * n}, "uri": "m.bin"}}'] * n)
    views = ", ".join(f'{{"buffer": {i}, "byteLength": {96 * n}}}' for i in range(n))
    accessors = ", ".join(f'{{"bufferView": {i}, "componentType": 5126, "count": {8 * n}, "type": "VEC3"}}' for i in range(n))
    primitives = ", ".join(f'{{"attributes": {{"POSITION": {i}}}}}' for i in range(n))
    write("m.gltf", '{"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}], '
          f'"meshes": [{{"primitives": [{primitives}]}}], "accessors": [{accessors}], '
          f'"bufferViews": [{views}], "buffers": [{buffers}]}}')
    write("m.bin", "\0" * 96 * n)
    write("r.urdf", '<robot name="r"><link name="l"><visual><geometry><mesh filename="m.gltf"/></geometry></visual></link></robot>')


@grows(1000, "smurf-lint", "-q", "a.smurf")
def driven_joints_of_unknown_links(n, write):
    write("a.urdf", '<robot name="a"><link name="l"/>' + "".join(
        f'<joint name="j{i}" type="fixed"><parent link="l"/><child link="c{i}"/></joint>' for i in range(n)) + "</robot>")
    write("a.yml", "motors:\n" + "".join(f"- {{name: m{i}, joint: j{i}}}\n" for i in range(n)))
    write("a.smurf", "modelname: a\nfiles: [a.urdf, a.yml]\n")


@grows(50, "smurf-lint", "-q", "a.smurf")
def keys_beside_a_missing_one(n, write):
    keys = "".join(f", k{i}: 1" for i in range(n * 8))
    write("a.yml", "motors:\n" + f"- {{name: m{keys}}}\n" * 8)
    write("a.smurf", "modelname: a\nfiles: [a.yml]\n")


@grows(300, "smurf-lint", "-q", "a.urdf")
def missing_meshes_beside_many_files(n, write):
    for i in range(n):
        write(f"m/{'f' * 100}{i}.stl", "")
    shapes = "".join(f'<visual><geometry><mesh filename="m/g{i}.stl"/></geometry></visual>' for i in range(n))
    write("a.urdf", f'<robot name="a"><link name="l">{shapes}</link></robot>')


@grows(300, "smurf-lint", "-q", "a.smurf")
def findings_below_a_long_key(n, write):
    write("a.yml", f"? {'k' * 100 * n}\n: {{" + "a: 1, " * n + "}\n")
    write("a.smurf", "modelname: a\nfiles: [a.yml]\n")


@grows(300, "smurf-lint", "-q", "a.urdf")
def findings_in_a_link_of_a_long_name(n, write):
    write("a.urdf", f'<robot name="a"><link name="{"l" * 100 * n}">' + '<visual a="1"/>' * n + "</link></robot>")


@grows(500, "smurf-lint", "-q", "a.urdf")
def baseline_of_a_long_file_name(n, write):
    write(".smurf-lint.yaml", "baseline: b.yaml\n")
    write("b.yaml", f"? {'f' * 100 * n}\n:\n  SML3101: [" + ", ".join(f"p{i}" for i in range(n)) + "]\n")
    write("a.urdf", '<robot name="a"><link name="l"/></robot>')


@grows(500, "urdf2smurf", "-q", "--dry-run", "--force", "-o", "out", "--motors", "all", "a.urdf")
def mimics_against_the_order(n, write):
    joint = ('<joint name="j{0}" type="revolute"><parent link="l{0}"/><child link="l{1}"/><axis xyz="0 0 1"/>'
             '<limit lower="-1" upper="1" effort="1" velocity="1"/>{2}</joint>')
    write("a.urdf", '<robot name="a">' + "".join(f'<link name="l{i}"/>' for i in range(n + 1)) + "".join(
        joint.format(i, i + 1, f'<mimic joint="j{i + 1}"/>' if i < n - 1 else "") for i in range(n)) + "</robot>")


# Scenes of many models


@grows(400, "smurf-lint", "-q", "s.smurfs")
def models_of_a_scene_in_a_folder(n, write):
    for i in range(n):
        write(f"m{i}.smurf", "modelname: r\nfiles: []\n")
    write("s.smurfs", "smurfs:\n" + "".join(f"- {{name: e{i}, type: smurf, file: m{i}.smurf}}\n" for i in range(n)))

# Keys that are renamed


@grows(300, "smurf-lint", "-q", "a.smurfs")
def slips_in_one_mapping(n, write):
    write("a.smurfs", "entities: []\n" + "lihgts: [1]\n" * n * 4)


@grows(300, "smurf-lint", "-q", "a.smurf")
def slips_of_settings(n, write):
    write(".smurf-lint.yaml", "selct: [SML]\n" * n * 4)
    write("a.smurf", MODEL)


@grows(300, "smurf-lint", "-q", "a.smurf")
def sections_of_other_readers(n, write):
    write("a.smurf", MODEL + "joints: [1]\n" * n * 4)


# Drake's language.


# More names than `suggestions` are compared with each other, so that this cost does not grow.
@grows(300, "smurf-lint", "-q", "--target", "drake", "--limit", "suggestions=10000", "a.urdf")
def drake_groups_of_unknown_members(n, write):
    group = ('<drake:collision_filter_group name="g{0}"><drake:member link="m{0}"/><drake:member_group name="h{0}"/>'
             '<drake:ignored_collision_filter_group name="i{0}"/></drake:collision_filter_group>')
    write("a.urdf", '<robot name="a"><link name="l"/>' + "".join(group.format(i) for i in range(n)) + "</robot>")


# The models of a scene in smurf-load-check.


@grows(40, "smurf-load-check", "--time", "0.001", "s.smurfs")
def models_to_load(n, write):
    model = '<robot name="r"><link name="l"/>{}</robot>'.format(
        "".join(f'<link name="l{i}"/><joint name="j{i}" type="fixed"><parent link="l"/><child link="l{i}"/></joint>'
                for i in range(20)))
    for i in range(n):
        write(f"m{i}.urdf", model)
    write("s.smurfs", "smurfs:\n" + "".join(f"- {{name: e{i}, type: urdf, file: m{i}.urdf}}\n" for i in range(n)))


# Two versions in smurf-diff.


def versions(write, old, new, ending="urdf"):
    write(f"old.{ending}", old)
    write(f"new.{ending}", new)


def robot_of(links, joints=""):
    return f'<robot name="r">{links}{joints}</robot>'


def chain_of(n, prefix, parent_of):
    links = "".join(f'<link name="{prefix}{i}"/>' for i in range(n))
    return robot_of(links, "".join(
        f'<joint name="{prefix}j{i}" type="fixed"><parent link="{prefix}{parent_of(i)}"/><child link="{prefix}{i}"/></joint>'
        for i in range(1, n)))


@grows(400, "smurf-diff", "-q", "old.urdf", "new.urdf")
def renamed_chain(n, write):
    versions(write, *(chain_of(n, prefix, lambda i: i - 1) for prefix in "ab"))


@grows(400, "smurf-diff", "-q", "old.urdf", "new.urdf")
def renamed_star(n, write):
    versions(write, *(chain_of(n, prefix, lambda i: 0) for prefix in "ab"))


@grows(1000, "smurf-diff", "old.urdf", "new.urdf")
def visuals_without_names(n, write):
    visual = '<visual><geometry><sphere radius="{}"/></geometry></visual>'
    versions(write, *(robot_of('<link name="a">' + "".join(visual.format(i + first) for i in range(n)) + "</link>")
                      for first in (1, 2 * n)))


@grows(1000, "smurf-diff", "-q", "old.yml", "new.yml")
def renamed_motors(n, write):
    versions(write, *("motors:\n" + "".join(f"- {{name: {prefix}{i}, joint: j, p: 1}}\n" for i in range(n)) for prefix in "ab"), "yml")


@grows(1000, "smurf-diff", "-q", "old.urdf", "new.urdf")
def extensions_that_name_a_renamed_link(n, write):
    versions(write, *(robot_of(f'<link name="{name}"/>', f'<gazebo><x>{name}</x><y link="{name}"/></gazebo>' * n) for name in "ab"))


@grows(1000, "smurf-diff", "-q", "old.yml", "new.yml")
def lists_of_named_items(n, write):
    versions(write, *("s:\n" + "".join(f"- {{name: n{i * step}, v: {i}}}\n" for i in range(n)) for step in (1, 2)), "yml")


@grows(200, "smurf-diff", "-q", "old.smurfs", "new.smurfs")
def entities_that_change_their_models(n, write):
    for i in range(20):
        write(f"r{i}.urdf", robot_of("".join(f'<link name="l{i}_{k}"/>' for k in range(20))))
    versions(write, *("entities:\n" + "".join(f"- {{name: e{i}, file: r{(i * step) % 20}.urdf}}\n" for i in range(n)) for step in (1, 3)),
             "smurfs")


@grows(100, "smurf-diff", "-q", "old.smurfs", "new.smurfs")
def moved_scenes_in_scenes(n, write):
    for i in range(n):
        inner = f", file: s{i + 1}.smurfs" if i + 1 < n else ", type: primitive"
        write(f"s{i}.smurfs", f"entities:\n- {{name: e{inner}, position: [1, 0, 0]}}\n")
    versions(write, *(f"entities:\n- {{name: e, file: s0.smurfs, position: [{x}, 0, 0]}}\n" for x in (1, 2)), "smurfs")


@grows(300, "smurf-diff", "-o", "out", "old.yml", "new.yml")
def a_long_name_with_many_keys(n, write):
    versions(write, *(f"motors:\n- {{name: {'a' * 200 * n}, " + ", ".join(f"k{i}: {x}" for i in range(n)) + "}\n" for x in (1, 2)),
             "yml")


# Names that many models share.


def models_that_share(n, write):
    write("r.urdf", star(5))
    for i in range(n):
        write(f"m{i}.smurf", "modelname: r\nfiles: [r.urdf]\n")


@grows(100, "smurf-lint", "--rename", "link:b=z", "--diff", "r.urdf")
def models_to_rename_in(n, write):
    models_that_share(n, write)


@grows(150, "smurf-lint", "--rename", "link:b=z", "--diff", "s.smurfs")
def models_of_a_scene_to_rename_in(n, write):
    models_that_share(n, write)
    write("s.smurfs", "smurfs:\n" + "".join(f"- {{name: e{i}, type: smurf, file: m{i}.smurf}}\n" for i in range(n)))


@grows(8000, "urdf2smurf", "-q", "--force", "-o", "out", "a.urdf")
def extensions_on_one_line(n, write):
    write("a.urdf", '<robot name="a"><link name="l"/>' + "".join(f"<x{i}/>" for i in range(n)) + "</robot>")


@grows(1000, "smurf-lint", "-q", "--exit-zero", "--statistics", "a.urdf")
def joints_from_a_link_to_itself(n, write):
    write("a.urdf", '<robot name="r"><link name="a"/>' + "".join(
        f'<joint name="j{i}" type="fixed"><parent link="a"/><child link="a"/></joint>' for i in range(n)) + "</robot>")


# Pages of findings


@grows(300, "smurf-lint", "-q", "--exit-zero", "--target", "mujoco", "--format", "html", "a.urdf")
def a_page_of_findings_in_one_line(n, write):
    write("a.urdf", '<robot name="r"><link name="b"/>' + "".join(
        f'<link name="l{i}"/><joint name="j{i}" type="fixd"><parent link="b"/><child link="l{i}"/></joint>'
        for i in range(n)) + "</robot>")


@grows(300, "smurf-lint", "-q", "--exit-zero", "--format", "html", "a.yml")
def a_page_of_findings_in_one_section(n, write):
    write("a.yml", "motors:\n" + "- {nam: 1, joint: 2, type: x, maxSpeed: a, maxEffort: -1}\n" * n)


# OpenUSD and the sensors of MuJoCo.

def joints_in_a_row(n, joint, link='<link name="l%d"/>'):
    return '<robot name="r"><link name="l0"/>' + "".join(
        link % i + '<joint name="j%d" type="%s"><parent link="l%d"/><child link="l%d"/>%s</joint>' %
        (i, joint, i - 1, i, f'<mimic joint="j{i - 1}"/>' if joint == "continuous" and i > 1 else "")
        for i in range(1, n)) + "</robot>"


@flattens(400, "--format", "usda")
def frames_in_one_body_to_usda(n, write):
    write_scene(write, [ENTITY % (0, "")], joints_in_a_row(n, "fixed"))


@flattens(400, "--format", "usda")
def bodies_in_a_row_to_usda(n, write):
    write_scene(write, [ENTITY % (0, "")], joints_in_a_row(n, "revolute", '<link name="l%d"><collision><geometry>'
                                                           '<sphere radius="1"/></geometry></collision></link>'))


@flattens(1000, "--format", "usda")
def followers_in_a_row_to_usda(n, write):
    write_scene(write, [ENTITY % (0, "")], joints_in_a_row(n, "continuous"))


@flattens(400, "--format", "usda")
def anchors_on_one_robot_to_usda(n, write):
    write_scene(write, (ENTITY % (i, ', anchor: "e0::b"' if i else "") if i else
                        "- {name: e0, type: urdf, file: big.urdf}\n" for i in range(n)))
    write("big.urdf", star(n))


@flattens(400, "--format", "mjcf")
def sensors_of_a_robot_to_mjcf(n, write):
    write_scene(write, [ENTITY % (0, "")], star(n).replace("</robot>", "".join(
        f'<gazebo reference="l{i}"><sensor name="s" type="imu"><always_on>1</always_on></sensor></gazebo>'
        for i in range(n)) + "</robot>"))


@grows(1500, "smurfs-flatten", "-q", "--force", "--format", "mjcf", "-o", "out", "a.smurf")
def shapes_of_one_name_that_a_sensor_names_again_and_again(n, write):
    write("a.urdf", '<robot name="r"><link name="b">' + '<collision name="x"><geometry><box size="1 1 1"/></geometry></collision>' * n
          + "</link></robot>")
    write("s.yml", "sensors:\n- {name: s, type: NodeContact, collisions: [" + "x, " * n + "x]}\n")
    write("a.smurf", "modelname: a\nfiles: [a.urdf, s.yml]\n")


# Scenes whose entities name parts of one model


@grows(400, "smurf-diff", "-q", "a.smurfs", "a.smurfs")
def joint_pose_of_each_entity(n, write):
    write("r.urdf", '<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="continuous"><parent link="a"/>'
                    '<child link="b"/></joint></robot>')
    write("p.yml", "poses:\n" + "".join(f"- {{name: p{i}, joints: {{j: 0.1}}}}\n" for i in range(n)))
    write("a.smurf", "modelname: a\nfiles: [r.urdf, p.yml]\n")
    write("a.smurfs", "smurfs:\n" + "".join(
        f"- {{name: e{i}, type: smurf, file: a.smurf, pose: p{i}}}\n" for i in range(n)))


# Files beside a robot


ARM = ('<robot name="r"><link name="a"/><link name="b"/><joint name="j1" type="continuous"><parent link="a"/><child link="b"/></joint>'
       "{}</robot>")


def srdf_groups(write, groups):
    write("r.urdf", ARM.format(""))
    write("r.srdf", '<robot name="r">' + "".join(groups) + "</robot>")


@grows(1000, "smurf-lint", "-q", "r.urdf")
def ring_of_groups(n, write):
    srdf_groups(write, (f'<group name="g{i}"><group name="g{(i + 1) % n}"/></group>' for i in range(n)))


@grows(1000, "smurf-lint", "-q", "r.urdf")
def nested_groups(n, write):
    groups = (f'<group name="g{i}"><group name="g{i - 1}"/><group name="g{i - 1}"/></group>' for i in range(1, n))
    srdf_groups(write, ['<group name="g0"><joint name="j1"/></group>', *groups])


CONTROL = ('<ros2_control name="s" type="system"><hardware><plugin>mock_components/GenericSystem</plugin></hardware><joint name="j1">'
           '<command_interface name="position"/><state_interface name="position"/></joint></ros2_control>')


def controllers(write, n, kind, parameters):
    write("r.urdf", ARM.format(CONTROL))
    types = "".join(f"    c{i}:\n      type: {kind}\n" for i in range(n))
    settings = "".join(f"c{i}:\n  ros__parameters:\n" + parameters(i) for i in range(n))
    write("config/controllers.yaml", f"controller_manager:\n  ros__parameters:\n    update_rate: 100\n{types}{settings}")


@grows(300, "smurf-lint", "-q", "r.urdf")
def many_controllers(n, write):
    controllers(write, n, "joint_trajectory_controller/JointTrajectoryController",
                lambda i: "    joints: [j1]\n    command_interfaces: [position]\n    state_interfaces: [position]\n")


@grows(300, "smurf-lint", "-q", "r.urdf")
def controllers_that_command_unknown_ones(n, write):
    controllers(write, n, "joint_trajectory_controller/JointTrajectoryController",
                lambda i: f"    joints: [j1]\n    command_joints: [d{i}/j1]\n    command_interfaces: [position]\n    state_interfaces: [position]\n")


@grows(300, "smurf-lint", "-q", "r.urdf")
def planners_that_are_not_defined(n, write):
    srdf_groups(write, ['<group name="g"><joint name="j1"/></group>'])
    write("config/ompl_planning.yaml", "planner_configs:\n" + "".join(f"  p{i}: {{type: geometric::RRT}}\n" for i in range(n)) +
          "".join(f"g{i}: {{planner_configs: [q{i}, p{i}]}}\n" for i in range(n)))


# Sensors of MJCF, which name sites


@grows(300, "smurf-lint", "-q", "a.xml")
def orientations_of_sites_that_are_measured(n, write):
    write("a.xml", '<mujoco><worldbody><body name="b"><joint name="j"/><geom size=".1"/>' + "".join(
        f'<site name="s{i}" pos="1 0 0"/>' for i in range(n)) + "</body></worldbody><sensor>" + "".join(
        f'<framequat objtype="site" objname="s{i}"/>' for i in range(n)) + "".join(
        f'<gyro site="s{i}"/>' for i in reversed(range(n))) + "</sensor></mujoco>")
