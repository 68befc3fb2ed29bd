# SPDX-License-Identifier: BSD-3-Clause
"""Robots as the Python module of DART reads them; dart_robot.cpp reads them with another version.

The module does not tell which joint another one follows, only that it follows.
"""
import os

import dartpy
from run_reader import package_of, run_reader


def add_shape(robot, body, index):
    node = body.getShapeNode(index)
    shape = node.getShape()
    size = [list(getattr(shape, get)()) if get == "getSize" else getattr(shape, get)()
            for get in ("getSize", "getRadius", "getHeight", "getScale", "getMeshUri") if hasattr(shape, get)]
    kind = "visuals" if node.getCollisionAspect() is None else "collisions"
    robot[f"{kind}:{body.getName()}:{index}"] = [node.getRelativeTransform().matrix(), shape.getType(), size]
    if node.getVisualAspect() is not None:
        robot[f"colours:{body.getName()}:{index}"] = node.getVisualAspect().getRGBA()


def add_body(robot, body):
    name = body.getName()
    parent = body.getParentBodyNode()
    robot[f"links:{name}"] = "" if parent is None else parent.getName()
    robot[f"poses:{name}"] = body.getWorldTransform().matrix()
    robot[f"masses:{name}"] = [body.getMass(), body.getInertia().getLocalCOM()]
    robot[f"inertias:{name}"] = body.getInertia().getMoment()
    for index in range(body.getNumShapeNodes()):
        add_shape(robot, body, index)


def add_joint(robot, joint):
    name = joint.getName()
    robot[f"joints:{name}"] = joint.getType()
    dofs = range(joint.getNumDofs())
    if not dofs:
        return
    limits = ("Position", "Force", "Velocity")
    robot[f"limits:{name}"] = [[getattr(joint, f"get{what}{end}Limit")(i) for what in limits for end in ("Lower", "Upper")]
                               for i in dofs]
    robot[f"dynamics:{name}"] = [[joint.getDampingCoefficient(i), joint.getCoulombFriction(i)] for i in dofs]
    robot[f"axes:{name}"] = joint.getRelativeJacobian()
    if joint.getActuatorType() == dartpy.dynamics.ActuatorType.MIMIC:
        robot[f"mimics:{name}"] = True


def read(file):
    loader = dartpy.utils.DartLoader()
    if "SMURF_SIZES" in os.environ:  # for paths_record.py, the packages are given
        loader.addPackageDirectory("robot_hand", str(package_of(file)))
    skeleton = loader.parseSkeleton(file)
    if skeleton is None:
        raise ValueError("no skeleton")
    robot = {"name:": skeleton.getName()}
    for index in range(skeleton.getNumBodyNodes()):
        body = skeleton.getBodyNode(index)
        add_body(robot, body)
        add_joint(robot, body.getParentJoint())
    return robot


run_reader(read)
