# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of driven_scenes.py in every export that a reader with a Python module reads: links, bodies, limits, and joints that move.

Usage: driven_scenes_test.py SMURFS_FLATTEN [CORPUS]     with the robots RICH of the corpus, without their shapes

The environment variable SMURF_SEED changes the scenes.
"""
import json
import os
import pathlib
import random
import subprocess
import sys
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / "cli"), str(HERE)]
import cli  # noqa: E402
import driven_scenes  # noqa: E402

PYTHON = cli.ROOT / "build/readers/python/bin/python"
SCENES = 300
SEED = int(os.environ.get("SMURF_SEED", "0"))
CORPUS = None
# With bodies that exist: readers and exports repair others, and tensors of 1 kg m^2.
RICH = tuple(f"Gepetto__example-robot-data/robots/{name}" for name in (
    "solo_description/robots/solo12", "z1_description/urdf/z1")) + tuple(
    f"bulletphysics__bullet3/{name}" for name in (
        "data/quadruped/vision/vision60", "examples/pybullet/gym/pybullet_data/a1/a1")) + tuple(
    f"unitreerobotics__unitree_ros/robots/{name}" for name in (
        "laikago_description/urdf/laikago", "g1_description/g1_29dof_rev_1_0_with_inspire_hand_DFQ", "h1_description/urdf/h1_with_hand",
        "h2_description/H2", "a2_description/urdf/a2", "dexterous_hand_description/dex5_1/Dex5-URDF-L/Dex5-URDF-L"))
SHOWN = 5
EXACT, SINGLE = 1e-9, 2e-5  # relative to the largest number, or to 1; PyBullet and Newton have single precision
# reader: (its module, the file, tolerance, whether links without mass are frames of others, whether the base may be moved)
READERS = {
    "MuJoCo": ("mujoco", "mjcf.xml", EXACT, False, False),
    "Drake, directives": ("pydrake", "scene.dmd.yaml", EXACT, False, False),
    "Drake, SDF": ("pydrake", "scene.sdf", EXACT, True, False),
    "Pinocchio": ("pinocchio", "scene.urdf", EXACT, False, True),
    "PyBullet": ("pybullet", "scene.urdf", SINGLE, False, True),
    "Newton": ("newton", "scene.usda", SINGLE, True, False),
    "validators of OpenUSD": ("pxr", "scene.usda", EXACT, True, False),
}
FORMATS = {"mjcf.xml": "mjcf", "scene.dmd.yaml": "dmd", "scene.sdf": "sdf", "scene.urdf": "urdf", "scene.usda": "usda"}


def has(module):
    return PYTHON.exists() and subprocess.run([PYTHON, "-c", f"import {module}"], capture_output=True, check=False).returncode == 0


def flat(value):
    return [number for one in value for number in flat(one)] if isinstance(value, list) else [value]


def is_near(found, expected, tolerance):
    if found is None or expected is None:
        return found is expected
    found, expected = flat(found), flat(expected)
    scale = max(1, *map(abs, expected))
    return len(found) == len(expected) and all(abs(a - b) <= tolerance * scale for a, b in zip(found, expected))


def from_base(poses):
    """Relative to the base of each entity."""
    return {name: driven_scenes.product(driven_scenes.inverse(poses[name.split("/")[0] + "/l0"]), pose)
            for name, pose in poses.items() if name.split("/")[0] + "/l0" in poses}


def is_chosen(what, have, want):
    """Whether the gains of a motor are others than the scene says, with its effort: MJCF has some that are stable at its step, hold the
    weight and arrive, which motors_test.py runs. A part of the damping can be that of the joint."""
    if what == "damping":
        return have > want
    return what == "drives" and is_near(have[2], want[2], EXACT) and have[1] > 0 and (have[0] > 0) == (want[0] > 0)


def problems(reader, found, truth, tolerance, frames_are_left_out, is_moved):
    """What differs, as texts; and the number of comparisons."""
    wrong, count = list(found.get("complaints", [])), len(truth["links"]) if "complaints" in found else 0
    for what in sorted(set(truth) & set(found)):
        have, want = found[what], truth[what]
        if is_moved and what == "driven":
            have, want = from_base(have), from_base(want)
        for name, value in want.items():
            is_frame = what in ("links", "driven", "bodies") and truth["bodies"][name] is None
            if is_frame and (what == "bodies" or (frames_are_left_out and name not in have)):
                continue
            if what == "bodies" and name.endswith("/l0") and name not in have and is_moved:
                continue  # PyBullet's base is the world
            count += 1
            if reader == "MuJoCo" and name in have and name in truth["drives"] and is_chosen(what, have[name], value):
                continue
            if name not in have or not is_near(have[name], value, tolerance):
                wrong.append(f"{what} {name}: {have.get(name)}, not {value}")
    if not found.get("speed", 0) < 1e3:
        wrong.append(f"a second later the largest speed is {found['speed']}")
    return wrong, count


class DrivenScenes(cli.CliTest):
    def write_scenes(self):
        scenes = []
        rich = [CORPUS / "urdf" / f"{name}.urdf" for name in RICH] if CORPUS else []
        for i, path in enumerate([None] * SCENES + rich):
            seed = SEED + i
            name = f"s{seed}" if path is None else path.stem
            scene = driven_scenes.write_scene(self.folder / name, random.Random(seed), path)
            for name, form in FORMATS.items():
                done = self.run_tool(scene, "--format", form, "-o", scene.parent / name, "--quiet")
                self.assertEqual((done.returncode, done.stdout), (0, ""), f"seed {seed}: {done.stderr}")
            scenes.append(scene.parent)
        return scenes

    def test_readers_build_what_the_scene_says(self):
        if not PYTHON.exists():
            self.skipTest("the readers of scripts/setup --python-readers are not installed")
        scenes, absent = self.write_scenes(), []
        for reader, (module, name, tolerance, frames_are_left_out, is_moved) in READERS.items():
            if not has(module):
                absent.append(module)
                continue
            with self.subTest(reader):
                files = "".join(f"{scene / name}\n" for scene in scenes)
                done = subprocess.run([PYTHON, HERE / "driven_scene.py", module], input=files, capture_output=True, text=True, check=True)
                said = [json.loads(line) for line in done.stdout.splitlines()]
                wrong, count = [], 0
                for scene, one in zip(scenes, said, strict=True):
                    if one["verdict"] != "takes":
                        wrong.append(f"{scene.name}: {one['verdict']}: {one['message']}")
                        continue
                    truth = json.loads((scene / "truth.json").read_text())
                    more, compared = problems(reader, one["robot"], truth, tolerance, frames_are_left_out, is_moved)
                    wrong += [f"{scene.name}: {text}" for text in more]
                    count += compared
                print(f"{reader}: {count} comparisons in {len(scenes)} scenes, {len(wrong)} wrong", file=sys.stderr)
                self.assertEqual(wrong[:SHOWN], [])
                self.assertGreater(count, 5 * SCENES)
        if absent:
            self.skipTest(f"not installed: {', '.join(absent)}")


if __name__ == "__main__":
    if len(sys.argv) > 2 and pathlib.Path(sys.argv[2]).is_dir():
        CORPUS = pathlib.Path(sys.argv.pop(2))
    cli.main()
