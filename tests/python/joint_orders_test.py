# SPDX-License-Identifier: BSD-3-Clause
"""Orders of joints are those of smurf-lint --joint-order, and permutations lead from one to another."""
import json

import inputs
import numpy as np
import pytest
import smurf

READERS = ["mujoco", "pinocchio", "dart", "newton", "pybullet", "drake"]
BIPED = """<robot name="biped">
  <link name="pelvis"/><link name="thigh_r"/><link name="shin_r"/><link name="thigh_l"/><link name="shin_l"/><link name="rail"/>
  <joint name="hip_r" type="continuous"><parent link="pelvis"/><child link="thigh_r"/></joint>
  <joint name="hip_l" type="continuous"><parent link="pelvis"/><child link="thigh_l"/></joint>
  <joint name="knee_r" type="continuous"><parent link="thigh_r"/><child link="shin_r"/></joint>
  <joint name="knee_l" type="continuous"><parent link="thigh_l"/><child link="shin_l"/></joint>
  <joint name="drive" type="planar"><parent link="pelvis"/><child link="rail"/></joint>
</robot>
"""


@pytest.fixture(name="biped")
def write_biped(tmp_path):
    path = tmp_path / "biped.urdf"
    path.write_text(BIPED)
    return path


def test_orders_of_the_tool(biped):
    done = inputs.run("smurf-lint", "--joint-order", ",".join(READERS), "--format=json", biped)
    model = smurf.load_model(biped)
    orders = json.loads(done.stdout)["orders"]
    assert [order["reader"] for order in orders] == READERS
    for order in orders:
        mine = model.joint_order(order["reader"])
        assert mine["indices"].dtype == np.int64
        assert {**mine, "indices": mine["indices"].tolist(), "known": True} == order


def test_permutation(biped):
    model = smurf.load_model(biped)
    names = np.array(model.joint_order("pinocchio")["joints"])
    there = model.joint_permutation("pinocchio", "pybullet")
    assert names[there].tolist() == model.joint_order("pybullet")["joints"] != names.tolist()
    assert names[there][model.joint_permutation("pybullet", "pinocchio")].tolist() == names.tolist()


def test_what_has_no_order(biped):
    model = smurf.load_model(biped)
    with pytest.raises(ValueError, match="graphics card"):
        model.joint_order("isaac")
    with pytest.raises(ValueError, match="not one of the targets"):
        model.joint_order("mujocoo")
    with pytest.raises(ValueError, match="pybullet has no joint 'drive_TX', which mujoco has"):
        model.joint_permutation("pybullet", "mujoco")
