#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Folders of a megabyte whose files would be read again and again: a verdict in bounded time and memory.

folder_cost_test.py FOLDER_OF_TOOLS [NAME...]

Links, and files that share others, make much of little: the cost of such a folder was once not that of its bytes, but
the number of its files times their size.
"""
import contextlib
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

import cost
from inputs import repeat

MEGABYTE = 1_000_000
MODEL = "modelname: r\nfiles: [r.urdf]\n"
SMALL = "modelname: r\nfiles: []\n"
FOLDERS = []
# A folder of many files has twice the bound of a file of a megabyte, because of the limit on what is read again.
FOLDER_SECONDS = 2 * cost.SECONDS


def folder(*commands):
    """A function that writes the files, and the commands to run in their folder."""

    def add(make):
        FOLDERS.append((make, commands))
        return make

    return add


LINT = ("smurf-lint", "-q", ".")


@folder(LINT, ("smurf-lint", "--show-config", "a.smurf"))
def configurations_that_extend_themselves_through_links(write):
    for i in range(8):
        write.link(f"l{i}", ".")
    write(".smurf-lint.yaml", "extends: [" + ", ".join(f"l{i}/.smurf-lint.yaml" for i in range(8)) + "]\n")
    write("a.smurf", SMALL)


@folder(LINT)
def a_schema_of_a_thousand_sections(write):
    write("s.json", '{"properties": {' + repeat('"k{}": {"type": "string"}, ', 900_000) + '"z": {}}}')
    write(".smurf-lint.yaml", "schemas:\n  sections:\n" + "".join(f"    a{i}: s.json\n" for i in range(1000)))
    write("a.smurf", SMALL + "a0: {k0: x}\n")


@folder(LINT)
def a_base_of_many_configurations(write):
    write("base.yaml", repeat("# a long remark\n", 40_000) + "paths:\n" + repeat('  "x{}*": {ignore: SML3}\n', 50_000))
    for i in range(300):
        write(f"f{i}/.smurf-lint.yaml", "extends: ../base.yaml\n")
        write(f"f{i}/a.smurf", SMALL)


@folder(LINT)
def a_configuration_of_many_models(write):
    write(".smurf-lint.yaml", repeat("# a long remark\n", 90_000) + "schemas: {sections: {foo: s.json}}\n")
    write("s.json", '{"properties": {' + repeat('"k{}": {}, ', 900_000) + '"z": {}}}')
    for i in range(2000):
        write(f"m{i}.smurf", SMALL)


@folder(LINT)
def patterns_of_many_models(write):
    for i in range(9):
        write(f"b{i}.yaml", "paths:\n" + "".join(f'  "{"a*" * 37}{j}": {{ignore: SML3}}\n' for j in range(1000)))
    write(".smurf-lint.yaml", "extends: [" + ", ".join(f"b{i}.yaml" for i in range(9)) + "]\n")
    for i in range(500):
        write("a" * 200 + f"{i}.smurf", "modelname: r\nfiles: [gone.yml]\n")


@folder(LINT)
def a_pattern_of_a_megabyte(write):
    write(".smurf-lintignore", "*[" + "b" * 900_000 + "]z\n")
    write(".smurf-lint.yaml", 'exclude: ["*[' + "b" * 90_000 + ']z"]\n')
    for i in range(20):
        write("a" * 230 + f"{i}.smurf", SMALL)


def share_a_urdf(write, urdf):
    write("r.urdf", urdf)
    for i in range(1000):
        write(f"m{i}.smurf", MODEL)


@folder(LINT, ("smurf-lint", "-q", "-j", "1", "."), ("smurf-lint", "-q", "--only-listed", "t.png"),
        ("smurf-lint", "-q", "--only-listed", "r.urdf"))
def models_of_one_large_robot(write):
    part = '<link name="l{}"/><joint name="j{}" type="fixed"><parent link="b"/><child link="l{}"/></joint>'
    share_a_urdf(write, '<robot name="r"><link name="b"/>' + repeat(part, MEGABYTE) + "</robot>")
    write("t.png", "x")


@folder(LINT)
def models_of_one_robot_with_many_findings(write):
    share_a_urdf(write, '<robot name="r"><link name="b"/>' + repeat('<link name="l{}"/>', MEGABYTE) + "</robot>")


@folder(("smurf-lint", "-q", "s.smurfs"), ("smurfs-flatten", "-q", "--force", "-o", "out", "s.smurfs"))
def a_scene_of_models_of_one_large_robot(write):
    models_of_one_large_robot(write)
    write("s.smurfs", "smurfs:\n" + "".join(f"- {{name: e{i}, type: smurf, file: m{i}.smurf}}\n" for i in range(1000)))


@folder(LINT)
def many_scenes_of_one_large_robot(write):
    models_of_one_large_robot(write)
    for i in range(300):
        write(f"s{i}.smurfs", f"smurfs:\n- {{name: e, type: smurf, file: m{i}.smurf}}\n")


SCHEMA = json.loads((pathlib.Path(__file__).parents[2] / "schemas/config.schema.json").read_text())
TARGETS = ",".join(name for name in SCHEMA["properties"]["targets"]["anyOf"][1]["enum"] if ":" not in name)
REPORTS = tuple(("smurf-lint", "--target", TARGETS, "--format", name, ".")
                for name in ("full", "json", "sarif", "gitlab", "junit", "html"))


@folder(*REPORTS)
def findings_of_many_rules(write):
    """Each rule has fewer than its limit."""
    motors = repeat("- {nam: 1, joint: 2, type: x, maxSpeed: a, maxEffort: -1, minValue: 5, maxValue: 1, q: }\n", 560_000)
    write("s.yml", "motors:\n" + motors + "sensors:\n" + repeat("- {nam: 1, link: 2, type: x, rate: a}\n", 350_000))
    write("r.urdf", '<robot name="r"><link name="b"/></robot>')
    write("m.smurf", "modelname: r\nfiles: [r.urdf, s.yml]\n")


@folder(*REPORTS)
def findings_of_many_models(write):
    """None has more than a file may have."""
    for i in range(20):
        write(f"s{i}.yml", "motors:\n" + repeat("- {nam: 1, joint: 2, type: x, maxSpeed: a}\n", MEGABYTE // 20))
        write(f"m{i}.smurf", f"modelname: r\nfiles: [s{i}.yml]\n")


@folder(*(("smurf-lint", *words, "--unsafe-fixes", "m.smurf") for words in (("--fix",), ("--diff",))))
def slips_of_many_rounds(write):
    write("s.yml", "motors:\n" + repeat("- {nam: a, jont: b}\n", MEGABYTE))
    write("m.smurf", "modelname: r\nfiles: [s.yml]\n")


DEEP = "d/" * 600


@folder(LINT, ("smurf-lint", "-q", DEEP + "r0.urdf"), ("smurf2urdf", "-q", "-o", "o.urdf", DEEP + "r0.urdf"),
        ("smurf-load-check", "-q", "--time", "0.001", "."))
def folders_in_folders(write):
    """Each path down was formerly searched again for each folder on it."""
    write(".git/HEAD", "")
    for i in range(20):
        write(f"{DEEP}r{i}.urdf", '<robot name="r"><link name="b"/></robot>')


DEEPEST = "d/" * 1900


@folder(LINT, ("smurf-lint", "-q", DEEPEST + "s.smurfs"), ("smurf-lint", "--rename", "link:b=c", "--diff", DEEPEST + "r.smurf"),
        ("smurf2urdf", "-q", "-o", "o.urdf", DEEPEST + "r.urdf"), ("smurfs-flatten", "-q", "-o", "o", DEEPEST + "s.smurfs"),
        ("smurf-load-check", "-q", "--time", "0.001", DEEPEST + "r.urdf"))
def a_model_in_the_deepest_folder(write):
    write(".git/HEAD", "")
    write(DEEPEST + "r.urdf", '<robot name="r"><link name="b"/></robot>')
    write(DEEPEST + "r.smurf", MODEL)
    write(DEEPEST + "s.smurfs", "smurfs:\n- {name: e, type: smurf, file: r.smurf}\n")


@folder(("smurf-lint", "-q", "r.smurf"), ("smurf-lint", "--dump-model", "r.smurf"))
def files_in_deep_folders(write):
    """Each prefix of a path was kept and looked up from the root."""
    write(".git/HEAD", "")
    names = [f"c{i}/" + "d/" * 1800 + "a.yml" for i in range(10)]
    for name in names:
        write(name, "motors: []\n")
    write("r.smurf", "modelname: r\nfiles:\n" + "".join(f"- {name}\n" for name in names))


@folder(("smurf-lint", "--rename", "link:b=c", "--diff", "."), ("smurf-lint", "--rename", "link:b=c", "--diff", "r.urdf"))
def models_that_share_what_is_renamed(write):
    write(".git/HEAD", "")
    write(".smurf-lint.yaml", "ignore:\n" + "- SML9103\n" * 30_000)
    write("r.urdf", '<robot name="r"><link name="b"/></robot>')
    for i in range(4000):
        write(f"m{i}.smurf", MODEL)


@folder(("smurf-lint", "--rename", "link:b=c", "--diff", "r.urdf"))
def many_uses_of_what_is_renamed(write):
    """The text was copied for each of them."""
    write(".git/HEAD", "")
    write("r.urdf", '<robot name="r"><link name="b"/>' + repeat('<frame name="f{}" link="b"/>', 3 * MEGABYTE) + "</robot>")


@folder(("smurf-lint", "--rename", "link:b=c", "--diff", "s.smurfs"), ("smurf-lint", "--dump-model", "s.smurfs"))
def scenes_that_name_the_next_one_twice(write):
    for i in range(17):
        write(f"s{i}.smurfs" if i else "s.smurfs", "smurfs:\n" + "".join(
            f"- {{name: {name * 100}, type: smurfs, file: s{i + 1}.smurfs}}\n" for name in "ab"))
    write("s17.smurfs", "smurfs:\n- {name: e, type: urdf, file: r.urdf}\n")
    write("r.urdf", '<robot name="r"><link name="b"/></robot>')


@folder(("smurf-load-check", "-q", "s.smurfs"))
def an_image_with_packed_texts(write):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    text = chunk(b"zTXt", b"a\0\0" + zlib.compress(bytes(7_000_000), 9))
    write("h.png", b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 8, 8, 8, 0, 0, 0, 0)) + text * 145
          + chunk(b"IDAT", zlib.compress(bytes(72))) + chunk(b"IEND", b""))
    write("s.smurfs", "entities:\n" + "".join(
        f"- {{name: h{i}, type: heightmap, file: h.png, width: 6.0, length: 6.0, height: 0.8}}\n" for i in range(5)))


@folder(("smurfs-flatten", "-q", "--force", "--format", "mjcf", "-o", "o.xml", "s.smurfs"))
def names_that_grow_when_they_are_written(write):
    part = '<link name="l{}"/><joint name="j{}" type="continuous"><parent link="b"/><child link="l{}"/></joint>'
    write("r.urdf", '<robot name="r"><link name="b"/>' + "".join(part.replace("{}", str(i)) for i in range(2000))
          + "</robot>")
    write("s.smurfs", "entities:\n" + "".join(
        f'- {{name: "{chr(39) * 897}{100 + i}", type: urdf, file: r.urdf, position: [{i}, 0, 0]}}\n' for i in range(12)))


@folder(("smurfs-flatten", "-q", "--format", "sdf", "-o", "o.sdf", "s.smurfs"))
def elements_of_gazebo_for_many_shapes(write):
    shapes = "<collision><geometry><box size=\"1 1 1\"/></geometry></collision>" * 4000
    write("r.urdf", f'<robot name="r"><link name="b">{shapes}</link><gazebo reference="b">{"<kp/>" * 44000}</gazebo></robot>')
    write("s.smurfs", "entities:\n- {name: e, type: urdf, file: r.urdf}\n")


@folder(("smurfs-flatten", "-q", "--format", "sdf", "-o", "o.sdf", "s.smurfs"))
def texts_of_gazebo_for_many_shapes(write):
    shapes = "<visual><geometry><box size=\"1 1 1\"/></geometry></visual>" * 2000
    text = "<visual><x>" + "a" * 200_000 + "</x></visual>"
    write("r.urdf", f'<robot name="r"><link name="b">{shapes}</link><gazebo reference="b">{text}</gazebo></robot>')
    write("s.smurfs", "entities:\n- {name: e, type: urdf, file: r.urdf}\n")


@folder(("smurfs-flatten", "-q", "--format", "sdf", "-o", "o.sdf", "s.smurfs"))
def a_long_name_in_many_shapes(write):
    shapes = "<visual><geometry><box size=\"1 1 1\"/></geometry></visual>" * 2000
    write("r.urdf", f'<robot name="r"><link name="{"b" * 128_000}">{shapes}</link></robot>')
    write("s.smurfs", "entities:\n- {name: e, type: urdf, file: r.urdf}\n")


@folder(LINT)
def names_of_an_srdf_in_other_robots(write):
    write("urdf/r.urdf", '<robot name="r"><link name="b"/>' + repeat('<link name="l{}"/>', MEGABYTE // 2) + "</robot>")
    write("urdf/r2.urdf", '<robot name="r">' + repeat('<link name="k{}"/>', MEGABYTE // 2) + "</robot>")
    write("config/r.srdf", '<robot name="r">' + repeat('<disable_collisions link1="k{}" link2="b{}" reason="Never"/>', MEGABYTE // 2) + "</robot>")


@folder(LINT)
def robots_of_one_name_with_an_srdf_each(write):
    for i in range(60):
        links = "".join(f'<link name="k{i}_{k}"/>' for k in range(400))
        pairs = "".join(f'<disable_collisions link1="q{k}" link2="k{i}_{k}" reason="Never"/>' for k in range(400))
        write(f"urdf/r{i}.urdf", f'<robot name="r">{links}</robot>')
        write(f"config/r{i}.srdf", f'<robot name="r">{pairs}</robot>')


@folder(LINT)
def groups_in_groups_of_long_chains(write):
    def arm(side):
        return "".join(f'<link name="{side}{i}"/><joint name="{side}j{i}" type="fixed"><parent link="{side}{i - 1}"/>'
                       f'<child link="{side}{i}"/></joint>' for i in range(1, 2000))

    write("urdf/r.urdf", '<robot name="r"><link name="b"/><link name="l0"/><link name="r0"/>'
          + "".join(f'<joint name="{side}j" type="fixed"><parent link="b"/><child link="{side}0"/></joint>' for side in "lr")
          + arm("l") + arm("r") + "</robot>")
    write("config/r.srdf", '<robot name="r">' + "".join(
        f'<group name="g{i}"><chain base_link="l{1999 - i}" tip_link="r{1999 - i}"/><group name="g{(i + 1) % 1000}"/></group>'
        f'<group_state name="s{i}" group="g{i}"><joint name="lj1" value="0"/></group_state>' for i in range(1000)) + "</robot>")


@folder(LINT)
def robots_that_look_for_packages_in_a_large_workspace(write):
    """Each robot once looked through all folders again."""
    for i in range(4000):
        write(f"other/f{i % 50}/g{i}/notes.rst", "")
    for i in range(600):
        write(f"ws/p{i}/package.xml", f"<package><name>p{i}</name></package>")
        write(f"ws/p{i}/urdf/r.urdf.xacro", '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="a"/>'
              f'<xacro:include filename="$(find q{i})/urdf/x.xacro"/></robot>')


def make_folder(path):
    """Including the folders above it, which may be too many for Python to make in reasonable time."""
    if not path.exists():
        subprocess.run(["mkdir", "-p", path], check=True)


@contextlib.contextmanager
def temporary_folder():
    name = tempfile.mkdtemp(prefix="smurf-folder-cost-")
    try:
        yield name
    finally:
        subprocess.run(["rm", "-rf", name], check=True)  # Python recurses into folders


def faults(tools, make, command):
    with temporary_folder() as name:
        place = pathlib.Path(name)

        def write(path, text):
            target = place / path
            make_folder(target.parent)
            target.write_bytes(text if isinstance(text, bytes) else text.encode())

        write.link = lambda path, target: (place / path).symlink_to(target)
        make(write)
        yield from cost.faults(tools, lambda: cost.Run([tools / command[0], *command[1:]], place, FOLDER_SECONDS),
                               seconds=FOLDER_SECONDS)


def main():
    tools = pathlib.Path(sys.argv[1]).resolve()
    wanted = sys.argv[2:]
    runs = [(make, command) for make, commands in FOLDERS for command in commands
            if not wanted or make.__name__ in wanted]
    failures = [f"{make.__name__}: {' '.join(command)}: {fault}"
                for make, command in runs for fault in faults(tools, make, command)]
    print("\n".join(failures))
    print(f"{len(runs)} runs, {len(failures)} failures")
    return 1 if failures or not runs else 0


if __name__ == "__main__":
    sys.exit(main())
