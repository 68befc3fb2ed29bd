# SPDX-License-Identifier: BSD-3-Clause
"""Robots as Drake reads them (pydrake's Parser with its own settings)."""
import os

from pydrake.geometry import Role
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import AddMultibodyPlantSceneGraph
from pydrake.systems.framework import DiagramBuilder
from run_reader import package_of, run_reader


def pose(transform):
    return [transform.translation(), transform.rotation().matrix().ravel()]


def add_body(robot, body, context):
    inertia = body.CalcSpatialInertiaInBodyFrame(context)
    robot[f"masses:{body.name()}"] = [inertia.get_mass(), inertia.get_com()]
    matrix = inertia.CalcRotationalInertia().CopyToFullMatrix3()
    robot[f"inertias:{body.name()}"] = matrix.ravel()


def add_joint(robot, joint):
    name = joint.name()
    robot[f"joints:{name}"] = [joint.type_name(), joint.child_body().name()]
    robot[f"links:{joint.child_body().name()}"] = joint.parent_body().name()
    robot[f"poses:{name}"] = [*pose(joint.frame_on_parent().GetFixedPoseInBodyFrame()),
                              *pose(joint.frame_on_child().GetFixedPoseInBodyFrame())]
    robot[f"limits:{name}"] = [*joint.position_lower_limits(), *joint.position_upper_limits(),
                               *joint.velocity_lower_limits(), *joint.velocity_upper_limits(),
                               *joint.acceleration_lower_limits(), *joint.acceleration_upper_limits()]
    robot[f"dynamics:{name}"] = joint.default_damping_vector()
    for axis in ("revolute_axis", "translation_axis"):
        if hasattr(joint, axis):
            robot[f"axes:{name}"] = getattr(joint, axis)()


def add_shapes(robot, plant, scene_graph):
    inspector = scene_graph.model_inspector()
    for what, role in (("visuals", Role.kPerception), ("collisions", Role.kProximity)):
        counts = {}
        for geometry in inspector.GetAllGeometryIds(role):
            body = plant.GetBodyFromFrameId(inspector.GetFrameId(geometry)).name()
            counts[body] = counts.get(body, -1) + 1
            shape = inspector.GetShape(geometry)
            robot[f"{what}:{body}:{counts[body]}"] = [repr(shape), *pose(inspector.GetPoseInFrame(geometry))]
            if role == Role.kPerception:
                colour = inspector.GetPerceptionProperties(geometry).GetPropertyOrDefault("phong", "diffuse", None)
                robot[f"colours:{body}:{counts[body]}"] = [] if colour is None else colour.rgba


def read(file):
    plant, scene_graph = AddMultibodyPlantSceneGraph(DiagramBuilder(), 0.001)
    parser = Parser(plant)
    if "SMURF_SIZES" in os.environ:  # for paths_record.py, the packages are given
        parser.package_map().PopulateFromFolder(str(package_of(file).parent))
    models = parser.AddModels(file)
    plant.Finalize()
    context = plant.CreateDefaultContext()
    robot = {}
    for model in models:
        for body in plant.GetBodyIndices(model):
            robot[f"links:{plant.get_body(body).name()}"] = ""
            add_body(robot, plant.get_body(body), context)
        for joint in plant.GetJointIndices(model):
            add_joint(robot, plant.get_joint(joint))
        for index in plant.GetJointActuatorIndices(model):
            actuator = plant.get_joint_actuator(index)
            robot[f"actuators:{actuator.name()}"] = [actuator.joint().name(), actuator.effort_limit(),
                                                     actuator.default_gear_ratio(), actuator.default_rotor_inertia()]
    robot["mimics:"] = plant.num_constraints()  # Python does not show their numbers
    add_shapes(robot, plant, scene_graph)
    return robot


run_reader(read)
