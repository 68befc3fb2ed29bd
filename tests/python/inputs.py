# SPDX-License-Identifier: BSD-3-Clause
"""The inputs of the tests, and the programs to compare with, all from the environment."""
import os
import pathlib
import subprocess

BIN = pathlib.Path(os.environ["SMURF_BIN"])
ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
FIXTURES = pathlib.Path(os.environ["SMURF_FIXTURES"])
CORPUS = pathlib.Path(os.environ["SMURF_CORPUS"])
ARM = FIXTURES / "models/arm/smurf/arm.smurf"
NESTED = FIXTURES / "scenes/nested/outer.smurfs"
SCENE_SUFFIXES = {".smurfs", ".smurfa", ".svg"}


def run(tool, *arguments, **keywords):
    """A program of the toolchain; its output as bytes."""
    done = subprocess.run([BIN / tool, *map(str, arguments)], capture_output=True, timeout=300, **keywords)
    assert done.returncode >= 0, f"{tool} {arguments} ended with signal {-done.returncode}"
    return done


def fixtures():
    """One file per fixture of a rule, as in rule_fixtures_test, and all models and scenes."""
    files = []
    for folder in sorted(FIXTURES.glob("rules/*/*/")):
        for name in ("scene.svg", "scene.smurfs", "model.smurf", "robot.urdf"):
            if (folder / name).exists():
                files.append(folder / name)
                break
    files += sorted(FIXTURES.glob("models/**/*.smurf"))
    files += sorted(FIXTURES.glob("scenes/**/*.smurfs"))
    assert len(files) > 500
    return files


def corpus():
    """Models, URDFs and scenes; none if there is no corpus."""
    return sorted(p for p in CORPUS.rglob("*") if p.suffix in {".smurf", ".smurfs", ".smurfa", ".urdf"} and p.is_file())


def is_scene(path):
    return path.suffix in SCENE_SUFFIXES
