# SPDX-License-Identifier: BSD-3-Clause
"""What a reader with a Python module builds of the exports of driven_scenes.py: driven_scene.py READER < list of files.

The joints are then put where `truth.json` beside the file drives them, and the world is simulated for a second from its start.
"""
import importlib
import json
import pathlib
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "verdicts"))
from run_reader import run_reader  # noqa: E402


def pose(rotation, position):
    matrix = numpy.eye(4)
    matrix[:3, :3], matrix[:3, 3] = rotation, position
    return matrix.tolist()


def rotation_of(w, x, y, z):
    return numpy.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def body(mass, centre, tensor):
    return [mass, *centre, *numpy.array(tensor).reshape(9)]


def plain_name(name):
    """entity/link of the name in a merged URDF."""
    return name.replace("__", "/", 1)


def mujoco(file, drive):
    import mujoco as mj
    model = mj.MjModel.from_xml_path(file)
    data = mj.MjData(model)

    def restart():
        mj.mj_resetDataKeyframe(model, data, 0) if model.nkey else mj.mj_resetData(model, data)
        mj.mj_forward(model, data)

    def poses():
        return {model.body(i).name: pose(data.xmat[i].reshape(3, 3), data.xpos[i]) for i in range(1, model.nbody)}

    restart()
    found = {"links": poses(), "bodies": {}, "starts": {}, "limits": {}, "damping": {}}
    for i in range(1, model.nbody):
        axes = rotation_of(*model.body_iquat[i])
        found["bodies"][model.body(i).name] = body(model.body_mass[i], model.body_ipos[i],
                                                   axes @ numpy.diag(model.body_inertia[i]) @ axes.T)
    for i in range(model.njnt):
        name, at = model.joint(i).name, model.jnt_qposadr[i]
        if name in drive:
            found["starts"][name] = data.qpos[at]
            found["limits"][name] = list(model.jnt_range[i]) if model.jnt_limited[i] else None
            found["damping"][name] = model.dof_damping[model.jnt_dofadr[i]]
            data.qpos[at] = drive[name]
    found["drives"] = {}
    for i in range(model.nu):
        joint = model.actuator_trnid[i][0]
        _, stiffness, damping = -model.actuator_biasprm[i][:3]
        found["drives"][model.joint(joint).name] = [stiffness, damping + model.dof_damping[model.jnt_dofadr[joint]],
                                                    model.actuator_forcerange[i][1]]
    mj.mj_kinematics(model, data)
    found["driven"] = poses()
    restart()
    for _ in range(round(1 / model.opt.timestep)):
        mj.mj_step(model, data)
    found["speed"] = max(map(abs, data.qvel), default=0)
    return found


def pydrake(file, drive):
    from pydrake import all as drake
    builder = drake.DiagramBuilder()
    plant, _ = drake.AddMultibodyPlantSceneGraph(builder, 0.001)
    parser = drake.Parser(plant)
    if file.endswith(".dmd.yaml"):
        parser.package_map().Add("scene", str(pathlib.Path(file).parent))
    parser.AddModels(file)
    plant.Finalize()
    diagram = builder.Build()
    context = plant.GetMyContextFromRoot(diagram.CreateDefaultContext())
    models = {model: plant.GetModelInstanceName(model).split("::")[-1]
              for model in map(drake.ModelInstanceIndex, range(plant.num_model_instances()))}
    bodies = {f"{models[one.model_instance()]}/{one.name()}": one
              for one in map(plant.get_body, map(drake.BodyIndex, range(1, plant.num_bodies())))}
    joints = {f"{models[one.model_instance()]}/{one.name()}": one
              for one in map(plant.get_joint, plant.GetJointIndices()) if one.num_positions() == 1}

    def poses():
        return {name: plant.EvalBodyPoseInWorld(context, one).GetAsMatrix4().tolist() for name, one in bodies.items()}

    # SDF has no start positions: the zero of a joint is where it starts.
    zero = json.loads((pathlib.Path(file).parent / "truth.json").read_text())["starts"] if file.endswith(".sdf") else {}
    found = {"links": poses(), "bodies": {}, "starts": {}, "limits": {}, "damping": {}}
    for name, one in bodies.items():
        inertia = one.CalcSpatialInertiaInBodyFrame(context)
        at_centre = inertia.Shift(inertia.get_com()).CalcRotationalInertia().CopyToFullMatrix3()
        found["bodies"][name] = body(inertia.get_mass(), inertia.get_com(), at_centre)
    for name, one in joints.items():
        shift = zero.get(name, 0)
        found["starts"][name] = one.GetOnePosition(context) + shift
        lower, upper = one.position_lower_limits()[0] + shift, one.position_upper_limits()[0] + shift
        found["limits"][name] = None if upper > 1e9 else [lower, upper]
        found["damping"][name] = one.default_damping_vector()[0]
        plant.SetPositions(context, [drive[name] - shift if index == one.position_start() else value
                                     for index, value in enumerate(plant.GetPositions(context))])
    found["driven"] = poses()
    simulator = drake.Simulator(diagram)
    simulator.AdvanceTo(1)
    speeds = plant.GetVelocities(plant.GetMyContextFromRoot(simulator.get_context()))
    found["speed"] = max(map(abs, speeds), default=0)
    return found


def pinocchio(file, drive):
    import pinocchio as pin
    model = pin.buildModelFromUrdf(file)
    data = model.createData()
    positions = pin.neutral(model)
    found = {"limits": {}}
    for name, value in drive.items():
        joint = model.joints[model.getJointId(name.replace("/", "__"))]
        is_circle = joint.nq == 2
        positions[joint.idx_q:joint.idx_q + joint.nq] = [numpy.cos(value), numpy.sin(value)] if is_circle else [value]
        found["limits"][name] = None if is_circle else [model.lowerPositionLimit[joint.idx_q],
                                                        model.upperPositionLimit[joint.idx_q]]
    pin.forwardKinematics(model, data, positions)
    pin.updateFramePlacements(model, data)
    found["driven"] = {plain_name(frame.name): data.oMf[i].homogeneous.tolist() for i, frame in enumerate(model.frames)
                       if frame.type == pin.FrameType.BODY and frame.name not in ("universe", "world")}
    return found


def pybullet(file, drive):
    import pybullet as bullet
    bullet.connect(bullet.DIRECT)
    robot = bullet.loadURDF(file, useFixedBase=True, flags=bullet.URDF_USE_INERTIA_FROM_FILE)
    found = {"driven": {}, "bodies": {}, "limits": {}, "damping": {}}
    joints = [bullet.getJointInfo(robot, i) for i in range(bullet.getNumJoints(robot))]
    for info in joints:
        name = plain_name(info[1].decode())
        if name in drive:
            bullet.resetJointState(robot, info[0], drive[name])
            found["limits"][name] = [info[8], info[9]] if info[8] <= info[9] else None
            found["damping"][name] = info[6]
    for info in joints:
        link, state = plain_name(info[12].decode()), bullet.getLinkState(robot, info[0], computeForwardKinematics=True)
        x, y, z, w = state[5]
        found["driven"][link] = pose(rotation_of(w, x, y, z), state[4])
        dynamics = bullet.getDynamicsInfo(robot, info[0])
        x, y, z, w = dynamics[4]
        axes = rotation_of(w, x, y, z)
        found["bodies"][link] = body(dynamics[0], dynamics[3], axes @ numpy.diag(dynamics[2]) @ axes.T)
    return found


def newton(file, drive):
    import newton
    import warp
    from newton._src.usd.schemas import SchemaResolverNewton, SchemaResolverPhysx
    builder = newton.ModelBuilder()
    builder.add_usd(file, schema_resolvers=[SchemaResolverNewton(), SchemaResolverPhysx()])
    model = builder.finalize()

    def short(label):
        parts = [part for part in label.split("/") if part and part not in ("World", "joints")]
        return "/".join(parts)

    def poses(positions):
        state = model.state()
        newton.eval_fk(model, warp.array(positions, dtype=warp.float32), model.joint_qd, state)
        return {short(label): pose(rotation_of(at[6], *at[3:6]), at[:3])
                for label, at in zip(builder.body_label, state.body_q.numpy())}

    positions = model.joint_q.numpy().copy()
    found = {"links": poses(positions), "bodies": {}, "starts": {}, "limits": {}, "drives": {}}
    for i, label in enumerate(builder.body_label):
        found["bodies"][short(label)] = body(builder.body_mass[i], builder.body_com[i], list(builder.body_inertia[i]))
    for i, label in enumerate(builder.joint_label):
        name = short(label)
        if name in drive:
            at, dof = builder.joint_q_start[i], builder.joint_qd_start[i]
            lower, upper = builder.joint_limit_lower[dof], builder.joint_limit_upper[dof]
            found["starts"][name] = positions[at]
            found["limits"][name] = [lower, upper] if upper < 1e6 else None
            positions[at] = drive[name]
            found["drives"][name] = [builder.joint_target_ke[dof], builder.joint_target_kd[dof], builder.joint_effort_limit[dof]]
    found["driven"] = poses(positions)
    return found


def pxr(file, _):
    """What the validators of OpenUSD say; nothing is built."""
    from pxr import Usd, UsdValidation
    registry = UsdValidation.ValidationRegistry()
    context = UsdValidation.ValidationContext(registry.GetOrLoadAllValidators())
    said = [f"{error.GetValidator().GetMetadata().name}: {error.GetMessage()}" for error in context.Validate(Usd.Stage.Open(file))]
    return {"complaints": said}


def load(name):
    """Once, before a child is made for each file."""
    importlib.import_module({"pydrake": "pydrake.all"}.get(name, name))


READER = {one.__name__: one for one in (mujoco, pydrake, pinocchio, pybullet, newton, pxr)}[sys.argv[1]]


def read(file):
    drive = json.loads((pathlib.Path(file).parent / "truth.json").read_text())["drive"]
    return READER(file, drive)


load(sys.argv[1])
run_reader(read)
