# SPDX-License-Identifier: BSD-3-Clause
"""Robots as Pinocchio reads them: the model and both geometries, as a call without further arguments gives them."""
import os
import pathlib

import pinocchio
from run_reader import package_of, run_reader


def pose(placement):
    return [placement.translation, placement.rotation.ravel()]


def folders_of(file):
    """The folder of the URDF; for paths_record.py, as programs give them, that of the packages, too."""
    own = str(pathlib.Path(file).parent)
    return [own] if "SMURF_SIZES" not in os.environ else [own, str(package_of(file).parent)]


def read(file):
    model = pinocchio.buildModelFromUrdf(file)
    robot = {}
    for number in range(1, model.njoints):
        name, joint = model.names[number], model.joints[number]
        inertia = model.inertias[number]
        robot[f"joints:{name}"] = [joint.shortname(), model.names[model.parents[number]]]
        robot[f"poses:{name}"] = pose(model.jointPlacements[number])
        robot[f"masses:{name}"] = [inertia.mass, inertia.lever]
        robot[f"inertias:{name}"] = inertia.inertia.ravel()
        positions = slice(joint.idx_q, joint.idx_q + joint.nq)
        velocities = slice(joint.idx_v, joint.idx_v + joint.nv)
        robot[f"limits:{name}"] = [*model.lowerPositionLimit[positions], *model.upperPositionLimit[positions],
                                   *model.upperVelocityLimit[velocities], *model.upperEffortLimit[velocities]]
        robot[f"dynamics:{name}"] = [*model.damping[velocities], *model.upperDryFrictionLimit[velocities]]
    for frame in model.frames:
        robot[f"links:{frame.name}:{frame.type}"] = [model.names[frame.parentJoint], *pose(frame.placement)]
    for kind, what in ((pinocchio.GeometryType.VISUAL, "visuals"), (pinocchio.GeometryType.COLLISION, "collisions")):
        shapes = pinocchio.buildGeomFromUrdf(model, file, kind, package_dirs=folders_of(file))
        for shape in shapes.geometryObjects:
            robot[f"{what}:{shape.name}"] = [shape.meshPath, shape.meshScale, *pose(shape.placement),
                                             str(shape.geometry.getNodeType()) if shape.geometry else ""]
            if "SMURF_SIZES" in os.environ and shape.geometry:
                shape.geometry.computeLocalAABB()
                robot[f"sizes:{what}:{shape.name}"] = [*shape.geometry.aabb_local.min_, *shape.geometry.aabb_local.max_]
            if what == "visuals":
                robot[f"colours:{shape.name}"] = shape.meshColor
    return robot


run_reader(read)
