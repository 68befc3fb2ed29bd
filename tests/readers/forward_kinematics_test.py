# SPDX-License-Identifier: BSD-3-Clause
"""Are the poses of Python's forward_kinematics those of Pinocchio and yourdfpy?

Usage: forward_kinematics_test.py BUILD [CORPUS]    BUILD has the folder `python` with the module

On random robots of driven_scenes.py, and on those of CORPUS that both load.
"""
import pathlib
import random
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import driven_scenes  # noqa: E402
import driven_scenes_test  # noqa: E402

PYTHON = driven_scenes_test.PYTHON
YOURDFPY = PYTHON.parents[2] / "yourdfpy-0.0.60"
SKIPPED = 77
ROBOTS = 300
MOST = 1e-9


def of_pinocchio(file, values):
    import pinocchio as pin
    model = pin.buildModelFromUrdf(str(file))
    data, positions = model.createData(), pin.neutral(model)
    for name, value in values.items():
        joint = model.joints[model.getJointId(name)]
        places = [pin.numpy.cos(value), pin.numpy.sin(value)] if joint.nq == 2 else [value]
        positions[joint.idx_q:joint.idx_q + joint.nq] = places
    pin.framesForwardKinematics(model, data, positions)
    return {frame.name: data.oMf[i].homogeneous for i, frame in enumerate(model.frames) if frame.type == pin.FrameType.BODY}


def of_yourdfpy(file, values):
    import yourdfpy
    robot = yourdfpy.URDF.load(str(file), build_scene_graph=True, load_meshes=False)
    robot.update_cfg({name: values[name] for name in robot.actuated_joint_names})
    return {link: robot.get_transform(link, robot.base_link) for link in robot.link_map}


READERS = {"Pinocchio": ("pinocchio", of_pinocchio), "yourdfpy": ("yourdfpy", of_yourdfpy)}


def robots(folder, corpus):
    paths = [corpus / "urdf" / f"{name}.urdf" for name in driven_scenes_test.RICH] if corpus.is_dir() else []
    for i, path in enumerate([None] * ROBOTS + paths):
        dice = random.Random(i)
        robot = driven_scenes.RealRobot(dice, f"r{i}", path) if path else driven_scenes.Robot(dice, f"r{i}")
        file = folder / f"r{i}.urdf"
        file.write_text(robot.files()[file.name])
        # A follower is where its leader puts it; Pinocchio moves it by itself.
        moved = {joint.name: robot.position(joint, robot.free) for joint in robot.joints if joint.kind != "fixed"}
        yield file, robot.free, moved


def compare(corpus):
    import importlib
    import numpy
    try:
        import smurf
    except ImportError:
        print("skipped: the Python module is not built")
        return SKIPPED
    wrong, counts, absent = [], {}, []
    with tempfile.TemporaryDirectory() as folder:
        known = list(robots(pathlib.Path(folder), corpus))
        for reader, (module, read) in READERS.items():
            try:
                importlib.import_module(module)
            except ImportError:
                absent.append(reader)
                continue
            for file, free, values in known:
                own = smurf.load_model(str(file)).forward_kinematics(free)
                theirs = read(file, values)
                for link, pose in own.items():
                    counts[reader] = counts.get(reader, 0) + 1
                    gap = numpy.abs(numpy.asarray(pose) - theirs[link]).max()
                    if gap > MOST * max(1, numpy.abs(theirs[link]).max()):
                        wrong.append(f"{reader}: {file.name}, {link}: {gap:.2g}")
    print(f"{counts} links, {len(wrong)} differ")
    print("\n".join(wrong[:20] + [f"skipped: {reader} is not installed" for reader in absent]))
    return 1 if wrong else SKIPPED if absent else 0


def main(build, corpus="/nowhere"):
    if "--again" in sys.argv:
        sys.path[:0] = [str(pathlib.Path(build) / "python"), str(YOURDFPY)]
        return compare(pathlib.Path(corpus))
    if not PYTHON.exists():
        print("skipped: the readers of scripts/setup --python-readers are not installed")
        return SKIPPED
    return subprocess.run([PYTHON, __file__, build, corpus, "--again"], check=False).returncode


if __name__ == "__main__":
    sys.exit(main(*[word for word in sys.argv[1:] if word != "--again"]))
