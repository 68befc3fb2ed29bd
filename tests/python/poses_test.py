# SPDX-License-Identifier: BSD-3-Clause
"""Forward kinematics and flat scenes are equal to those of smurfs-flatten."""
import json
import math

import inputs
import numpy as np
import pytest
import smurf


def matrix(pose):
    """Of a pose in JSON."""
    q = pose["orientation"]
    w, x, y, z = q["w"], q["x"], q["y"], q["z"]
    X = np.eye(4)
    X[:3, :3] = [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                 [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                 [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]
    X[:3, 3] = pose["position"]
    return X


def flat_json(path, *options):
    done = inputs.run("smurfs-flatten", *options, path)
    return json.loads(done.stdout) if done.returncode == 0 else None


def test_link_poses():
    """A model alone is a scene whose world is its root link."""
    compared = 0
    for path in inputs.fixtures():
        if inputs.is_scene(path) or (flat := flat_json(path, "--links", "--force")) is None:
            continue
        links = flat["instances"][0].get("links", {})
        X_RL = smurf.load_model(path).forward_kinematics()
        assert set(links) <= set(X_RL), path
        for name, pose in links.items():
            assert X_RL[name].shape == (4, 4) and X_RL[name].dtype == np.float64
            assert np.allclose(X_RL[name], matrix(pose), rtol=1e-12, atol=1e-12), (path, name)
        compared += len(links)
    assert compared > 500


def test_links_of_scenes():
    """The links of each instance are where its joint positions place them."""
    compared = 0
    for path in inputs.fixtures():
        if not inputs.is_scene(path):
            continue
        try:
            scene = smurf.load_scene(path)
            flat = scene.flatten(links=True, force=True)
        except smurf.Error:
            continue
        assert len(flat) == len(scene.instances) == len(flat.instances)
        for instance, entity in zip(scene.instances, flat.instances):
            assert instance.path == entity.path
            assert np.array_equal(instance.X_WE, entity.X_WE)
            if instance.model is None:
                continue
            X_RL = instance.model.forward_kinematics(instance.joint_positions)
            for name, X_WL in entity.links.items():
                assert np.allclose(X_WL, instance.X_WE @ X_RL[name], rtol=1e-9, atol=1e-9), (path, name)
                compared += 1
    assert compared > 100


@pytest.mark.parametrize("dialect", ["spec", "mars", "mars2", "phobos"])
def test_flat_scenes(dialect):
    compared = 0
    for path in inputs.fixtures():
        if not inputs.is_scene(path):
            continue
        done = inputs.run("smurfs-flatten", "--dialect", dialect, path)
        scene = smurf.load_scene(path)
        before = scene.to_json()
        if b"has no `entities`" in done.stderr:  # a table can be empty
            assert not scene.flatten(dialect=dialect).instances
            continue
        if done.returncode != 0:
            with pytest.raises(smurf.Error):
                scene.flatten(dialect=dialect)
            continue
        flat = scene.flatten(dialect=dialect)
        assert flat.to_json().encode() == done.stdout, path
        assert scene.to_json() == before, "a dialect changed the scene"
        placed = [entity for entity in flat.instances if entity.X_WE is not None]
        instances = json.loads(done.stdout)["instances"]
        assert len(placed) == len(instances)
        for entity, expected in zip(placed, instances):
            assert entity.position.tolist() == expected["position"]
            q = expected["orientation"]
            assert entity.orientation.tolist() == [q["w"], q["x"], q["y"], q["z"]]
            assert np.allclose(entity.X_WE, matrix(expected), atol=1e-12)
            assert entity.path == expected["path"] and entity.type == expected["type"]
            assert entity.properties == expected["properties"]
            assert entity.joint_positions == expected["joint_positions"]
            assert entity.model == expected.get("model")
            compared += 1
        n = len(flat)
        assert flat.X_WE.shape == (n, 4, 4) and flat.positions.shape == (n, 3)
        assert flat.orientations.shape == (n, 4)
        for i, entity in enumerate(flat.instances):
            if entity.X_WE is None:
                assert np.isnan(flat.X_WE[i]).all()
            else:
                assert np.array_equal(flat.X_WE[i], entity.X_WE)
    assert compared > 30


def test_positions():
    arm = smurf.load_model(inputs.ARM)
    joint = next(joint for joint in arm.joints if joint.type == "revolute")
    zero = arm.forward_kinematics()
    assert all(np.array_equal(zero[name], X) for name, X in arm.forward_kinematics({}).items())
    turned = arm.forward_kinematics({joint.name: 0.3})
    axis = joint.axis / np.linalg.norm(joint.axis)
    K = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    R = np.eye(3) + math.sin(0.3) * K + (1 - math.cos(0.3)) * K @ K
    X_JC = np.eye(4)
    X_JC[:3, :3] = R
    assert np.allclose(turned[joint.child], zero[joint.parent] @ joint.X_PJ @ X_JC, atol=1e-14)
    for pose in arm.poses:
        positions = arm.joint_positions(pose.name)
        named = arm.forward_kinematics(pose.name)
        for name, X in arm.forward_kinematics(positions).items():
            assert np.array_equal(X, named[name])


def test_copies():
    arm = smurf.load_model(inputs.ARM)
    root = arm.roots[0].name
    arm.forward_kinematics()[root][:] = 7
    assert np.array_equal(arm.forward_kinematics()[root], np.eye(4))
    flat = smurf.load_scene(inputs.NESTED).flatten()
    flat.X_WE[:] = 7
    assert not (flat.X_WE == 7).any()


def test_many_configurations_at_once():
    """Arrays of shape (n, joints), arrays of shape (n,) by joint, and single configurations are equal."""
    arm = smurf.load_model(inputs.ARM)
    names = [joint.name for joint in arm.free_joints]
    assert names and all(arm.joint(name).mimic is None for name in names)
    q = np.random.default_rng(1).uniform(-0.5, 0.5, (20, len(names)))
    X = arm.forward_kinematics(q)
    assert X["forearm"].shape == (20, 4, 4)
    by_joint = arm.forward_kinematics({name: q[:, i] for i, name in enumerate(names)})
    turned = arm.forward_kinematics(q[:, ::-1], joints=names[::-1])
    for link, poses in X.items():
        assert np.array_equal(poses, by_joint[link]) and np.array_equal(poses, turned[link])
        for i, row in enumerate(q):
            assert np.array_equal(poses[i], arm.forward_kinematics(row)[link])
            assert np.array_equal(poses[i], arm.forward_kinematics(dict(zip(names, row)))[link])
    mixed = arm.forward_kinematics({names[0]: q[:, 0], names[1]: 0.25})
    assert np.array_equal(mixed["forearm"][3], arm.forward_kinematics({names[0]: q[3, 0], names[1]: 0.25})["forearm"])
    assert arm.forward_kinematics(q[:0])["forearm"].shape == (0, 4, 4)
    for wrong in (q[:, :-1], q[None], np.nan * q, {names[0]: [1, 2], names[1]: [1, 2, 3]}, {names[0]: q}):
        with pytest.raises(ValueError):
            arm.forward_kinematics(wrong)
    for wrong in ({names[0]: "x"}, 3, {names[0]: None}, object(), np.float64(3)):
        with pytest.raises(TypeError):
            arm.forward_kinematics(wrong)
    with pytest.raises(TypeError):
        arm.forward_kinematics({}, joints=names)
    with pytest.raises(ValueError):
        arm.forward_kinematics(q, joints=[*names[:-1], "nothing"])
