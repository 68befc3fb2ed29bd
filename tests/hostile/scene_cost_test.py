#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A megabyte of every construct of scenes through smurfs-flatten, in every format: a verdict in bounded time and memory.

scene_cost_test.py FOLDER_OF_TOOLS [NAME...]
"""
import pathlib
import subprocess
import sys
import tempfile

import cost
from inputs import repeat

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import formats  # noqa: E402

MEGABYTE = 1_000_000
ROBOT = '<robot name="r"><link name="b"/></robot>'
MODEL = "modelname: r\nfiles: [r.urdf, p.yml]\n"
CONSTRUCTS = []


def construct(make):
    """A function that gives the files; the first is the scene."""
    CONSTRUCTS.append(make)
    return make


def robot(part, size=MEGABYTE // 2):
    return '<robot name="r"><link name="b"/>' + repeat(part, size) + "</robot>"


def link(parent="b", inside=""):
    return ('<link name="l{}">' + inside + '</link><joint name="j{}" type="continuous"><parent link="' + parent +
            '"/><child link="l{}"/></joint>')


def entities(text, size=MEGABYTE // 2):
    return "smurfs:\n" + repeat(text, size)


ENTITY = "- {name: e{}, type: urdf, file: r.urdf}\n"


@construct
def entities_of_a_model():
    return {"s.smurfs": entities(ENTITY, MEGABYTE), "r.urdf": ROBOT}


@construct
def entities_of_a_large_model():
    return {"s.smurfs": entities(ENTITY), "r.urdf": robot(link())}


@construct
def twenty_of_a_large_model():
    return {"s.smurfs": entities(ENTITY, 20 * len(ENTITY)), "r.urdf": robot(link(), MEGABYTE)}


def few_of(shape):
    inside = f"<visual><geometry>{shape}</geometry></visual>"
    return {"s.smurfs": entities(ENTITY, 20 * len(ENTITY)), "r.urdf": robot(link(inside=inside), MEGABYTE)}


@construct
def spheres():
    return few_of('<sphere radius="1"/>')


@construct
def capsules():
    return few_of('<capsule radius="1" length="1"/>')


@construct
def capsules_of_a_link():
    capsule = '<visual><geometry><capsule radius="1" length="1"/></geometry></visual>'
    entity = "- {name: e{}, type: urdf, file: r.urdf, position: [{}, 0, 0], rotation: [1, 0, 0, 0]}\n"
    return {"s.smurfs": entities(entity, 18 * len(entity)),
            "r.urdf": '<robot name="r"><link name="b">' + repeat(capsule, MEGABYTE) + "</link></robot>"}


@construct
def meshes():
    return few_of('<mesh filename="m{}.stl"/>')


@construct
def chains():
    parts = []
    size = MEGABYTE
    while size > 0:
        i = len(parts) + 1
        parts.append(f'<link name="l{i}"/><joint name="j{i}" type="fixed"><parent link="l{i - 1}"/>'
                     f'<child link="l{i}"/><origin rpy="1 2 3"/></joint>')
        size -= len(parts[-1])
    return {"s.smurfs": entities(ENTITY, 20 * len(ENTITY)),
            "r.urdf": '<robot name="r"><link name="l0"/>' + "".join(parts) + "</robot>"}


@construct
def one_pose_for_all():
    return {"s.smurfs": entities("- {name: e{}, type: smurf, file: r.smurf, pose: p}\n"), "r.smurf": MODEL,
            "r.urdf": ROBOT, "p.yml": "poses:\n- name: p\n  joints:\n" + repeat("    j{}: 1\n", MEGABYTE // 2)}


@construct
def poses_of_their_own():
    entity = ('- {name: e{}, type: smurf, file: r.smurf, pose: q, poses: [{name: q, joints: {j1: 0.{}}}], '
              'parent: "a::l5"}\n')
    return {"s.smurfs": "smurfs:\n- {name: a, type: smurf, file: r.smurf}\n" + repeat(entity, MEGABYTE // 3),
            "r.smurf": "modelname: r\nfiles: [r.urdf]\n", "r.urdf": robot(link(), MEGABYTE * 2 // 3)}


@construct
def many_poses_of_an_entity_often_included():
    poses = "".join(f"  - {{name: p{i}, joints: {{}}}}\n" for i in range(16_000))
    return {"s.smurfs": entities("- {name: i{}, type: smurfs, file: t.smurfs}\n"),
            "t.smurfs": "smurfs:\n- name: e\n  type: smurf\n  file: r.smurf\n  pose: q\n  poses:\n" + poses
                        + "  - {name: q, joints: {j0: 0.1}}\n",
            "r.smurf": "modelname: r\nfiles: [r.urdf]\n", "r.urdf": robot(link(), 100)}


@construct
def scenes_that_double():
    files = {f"s{i}.smurfs" if i else "s.smurfs": "smurfs:\n" + "".join(
        f"- {{name: {name * 1000}, type: smurfs, file: s{i + 1}.smurfs}}\n" for name in "ab") for i in range(16)}
    return {**files, "s16.smurfs": "smurfs:\n" + ENTITY, "r.urdf": ROBOT}


@construct
def a_long_name_around():
    return {"s.smurfs": "smurfs:\n- {name: " + "n" * (MEGABYTE // 2) + ", type: smurfs, file: t.smurfs}\n",
            "t.smurfs": entities(ENTITY), "r.urdf": ROBOT}


@construct
def a_long_parent_around():
    name = "n" * (MEGABYTE // 4)
    return {"s.smurfs": f'smurfs:\n- {{name: {name}, type: urdf, file: r.urdf}}\n'
                        f'- {{name: i, type: smurfs, file: t.smurfs, parent: "{name}::b"}}\n',
            "t.smurfs": entities(ENTITY), "r.urdf": ROBOT}


@construct
def aliases():
    return {"s.smurfs": "smurfs:\n- {name: e, type: light, a: &a [" + "1," * 10_000 + "1]}\n"
                        + repeat("- {name: e{}, type: light, b: *a}\n", 60_000)}


@construct
def drawn():
    return {"s.svg": '<svg width="100">' + repeat('<g><title>k.yml</title><desc>origin_z: 0</desc><path d="m 1,1"/></g>',
                                                  MEGABYTE // 3) + "</svg>",
            "k.yml": "type: light\nx: [" + "1," * 300_000 + "1]\n"}


@construct
def drawn_with_many_keys():
    return {"s.svg": '<svg width="100">' + repeat('<g><title>k.yml</title><desc>origin_z: 0</desc><path d="m 1,1"/></g>',
                                                  MEGABYTE // 2) + "</svg>",
            "k.yml": "type: light\n" + repeat("k{}: 1\n", MEGABYTE // 2)}


@construct
def old_scenes():
    node = "<node><name>a</name><origname>box</origname></node>"
    return {"s.smurfs": entities("- {name: e{}, type: scene, file: o.scene}\n", 100_000),
            "o.scene": "<SceneFile><nodelist>" + repeat(node, 900_000) + "</nodelist></SceneFile>"}


@construct
def lights_of_nested_scenes():
    return {"s.smurfs": entities("- {name: i{}, type: smurfs, file: t.smurfs}\n"),
            "t.smurfs": "smurfs: []\nlights:\n" + repeat("- {name: l}\n", MEGABYTE // 2)}


@construct
def primitives():
    return {"s.smurfs": entities("- {name: e{}, type: primitive, geometry: {type: sphere}, extend: {x: 1}}\n", MEGABYTE)}


def faults(tools, files, folder, options):
    command = [tools / "smurfs-flatten", "-q", "--force", *options, "-o", "out/result", next(iter(files))]
    return cost.faults(tools, lambda: cost.Run(command, folder))


def main():
    tools = pathlib.Path(sys.argv[1]).resolve()
    tool = tools / "smurfs-flatten"
    wanted = sys.argv[2:]
    names = formats.listed(subprocess.run([tool, "--format", "help"], capture_output=True, text=True, check=True).stdout)
    runs = [["--format", name] for name in names] + [["--links"], ["--dialect", "mars"], ["--compare-dialects"]]
    count = 0
    failures = []
    for make in CONSTRUCTS:
        if wanted and make.__name__ not in wanted:
            continue
        with tempfile.TemporaryDirectory(prefix="smurf-scene-cost-") as name:
            folder = pathlib.Path(name)
            files = make()
            (folder / "out").mkdir()
            for path, text in files.items():
                (folder / path).write_text(text)
            for options in runs:
                count += 1
                failures += [f"{make.__name__} {' '.join(options)}: {fault}"
                             for fault in faults(tools, files, folder, options)]
    print("\n".join(failures))
    print(f"{count} runs, {len(failures)} failures")
    return 1 if failures or not count else 0


if __name__ == "__main__":
    sys.exit(main())
