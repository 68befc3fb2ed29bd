# SPDX-License-Identifier: BSD-3-Clause
"""Robots as Bullet reads them (pybullet.loadURDF with its own settings)."""
import os

import pybullet
from run_reader import run_reader

TYPES = {pybullet.JOINT_REVOLUTE: "revolute", pybullet.JOINT_PRISMATIC: "prismatic", pybullet.JOINT_SPHERICAL: "spherical",
         pybullet.JOINT_PLANAR: "planar", pybullet.JOINT_FIXED: "fixed"}


def add_shapes(robot, body, index, name):
    for number, shape in enumerate(pybullet.getCollisionShapeData(body, index) or ()):
        _, _, kind, dimensions, file, position, orientation = shape
        robot[f"collisions:{name}:{number}"] = [kind, list(dimensions), file.decode(), list(position), list(orientation)]


def read(file):
    client = pybullet.connect(pybullet.DIRECT)
    body = pybullet.loadURDF(file, physicsClientId=client)
    root = pybullet.getBodyInfo(body)[0].decode()
    names = {-1: root}
    robot = {f"links:{root}": ""}
    for index in range(pybullet.getNumJoints(body)):
        joint = pybullet.getJointInfo(body, index)
        names[index] = link = joint[12].decode()
        name = joint[1].decode()
        robot[f"links:{link}"] = joint[16]
        robot[f"joints:{name}"] = [TYPES.get(joint[2], joint[2]), link]
        robot[f"axes:{name}"] = joint[13]
        robot[f"poses:{name}"] = [joint[14], joint[15]]
        robot[f"dynamics:{name}"] = [joint[6], joint[7]]
        robot[f"limits:{name}"] = joint[8:12]
    for index, link in names.items():
        robot[f"links:{link}"] = "" if index < 0 else names.get(robot[f"links:{link}"], "")
        dynamics = pybullet.getDynamicsInfo(body, index)
        robot[f"masses:{link}"] = [dynamics[0], dynamics[3], dynamics[4]]
        robot[f"inertias:{link}"] = dynamics[2]
        add_shapes(robot, body, index, link)
        if "SMURF_SIZES" in os.environ and f"collisions:{link}:0" in robot:
            robot[f"sizes:collisions:{link}"] = [*sum(pybullet.getAABB(body, index), ())]
    for number, shape in enumerate(pybullet.getVisualShapeData(body)):
        robot[f"visuals:{names[shape[1]]}:{number}"] = [shape[2], shape[3], shape[4].decode(), shape[5], shape[6]]
        robot[f"colours:{names[shape[1]]}:{number}"] = shape[7]
    return robot


run_reader(read)
