# SPDX-License-Identifier: BSD-3-Clause
"""The orders of joints and bodies that a reader builds: order_robot.py MODULE < list of files.

`joints` are those that have positions, in the order of the positions; `indices` are what the functions of
the reader call them. `bodies` are in the order of the reader.
"""
import importlib
import sys

from run_reader import run_reader


def of_mujoco(mujoco, file):
    model = mujoco.MjModel.from_xml_path(file)
    joints = sorted(range(model.njnt), key=lambda index: model.jnt_qposadr[index])
    return [model.joint(index).name for index in joints], joints, [model.body(index).name for index in range(model.nbody)]


def of_pybullet(pybullet, file):
    pybullet.connect(pybullet.DIRECT)
    body = pybullet.loadURDF(file)
    joints = [pybullet.getJointInfo(body, index) for index in range(pybullet.getNumJoints(body))]
    moving = sorted((joint for joint in joints if joint[3] >= 0), key=lambda joint: joint[3])
    return ([joint[1].decode() for joint in moving], [joint[0] for joint in moving],
            [pybullet.getBodyInfo(body)[0].decode(), *(joint[12].decode() for joint in joints)])


def of_drake(parsing, file):
    from pydrake.multibody.plant import MultibodyPlant  # pylint: disable=import-outside-toplevel
    plant = MultibodyPlant(0.001)
    [model] = parsing.Parser(plant).AddModels(file)
    own = plant.num_joints()  # Finalize() adds joints for bodies that nothing holds
    plant.Finalize()
    joints = [plant.get_joint(index) for index in plant.GetJointIndices(model)]
    moving = sorted((joint for joint in joints if joint.num_positions() > 0 and int(joint.index()) < own),
                    key=lambda joint: joint.position_start())
    return ([joint.name() for joint in moving], [int(joint.index()) for joint in moving],
            [plant.get_body(index).name() for index in plant.GetBodyIndices(model)])


def of_pinocchio(pinocchio, file):
    model = pinocchio.buildModelFromUrdf(file)
    joints = sorted(range(1, model.njoints), key=lambda index: model.joints[index].idx_q)
    return ([model.names[index] for index in joints], joints,
            [frame.name for frame in model.frames if frame.type == pinocchio.FrameType.BODY])


def of_newton(newton, file):
    builder = newton.ModelBuilder()
    builder.add_urdf(file)
    starts = [*builder.joint_q_start, builder.joint_coord_count]
    moving = [index for index in range(builder.joint_count) if starts[index + 1] > starts[index]]
    own_name = [label.split("/", maxsplit=1)[-1] for label in builder.joint_label]
    return [own_name[index] for index in moving], moving, [label.split("/", maxsplit=1)[-1] for label in builder.body_label]


def of_dartpy(dartpy, file):
    skeleton = dartpy.utils.DartLoader().parseSkeleton(file)
    joints = [skeleton.getJoint(index) for index in range(skeleton.getNumJoints())]
    moving = [index for index, joint in enumerate(joints) if joint.getNumDofs() > 0 and joint.getName() != "rootJoint"]
    moving.sort(key=lambda index: joints[index].getIndexInSkeleton(0))
    return ([joints[index].getName() for index in moving], moving,
            [skeleton.getBodyNode(index).getName() for index in range(skeleton.getNumBodyNodes())])


MODULES = {"mujoco": ("mujoco", of_mujoco), "pybullet": ("pybullet", of_pybullet), "drake": ("pydrake.multibody.parsing", of_drake),
           "pinocchio": ("pinocchio", of_pinocchio), "newton": ("newton", of_newton), "dart": ("dartpy", of_dartpy)}


def read_with(name, order_of):
    module = importlib.import_module(name)

    def read(file):
        joints, indices, bodies = order_of(module, file)
        return {"joints": joints, "indices": indices, "bodies": bodies}
    return read


run_reader(read_with(*MODULES[sys.argv[1]]))
