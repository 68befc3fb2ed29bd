# SPDX-License-Identifier: BSD-3-Clause
"""Robots as the Python module of MuJoCo reads them; mujoco_robot.mjs reads them with another version."""
import mujoco
from run_reader import run_reader

TYPES = ["free", "ball", "slide", "hinge"]


def force_of(model, joint):
    """Absent before 2.3.4."""
    return [model.jnt_actfrclimited[joint], *model.jnt_actfrcrange[joint]] if hasattr(model, "jnt_actfrclimited") else []


def read(file):
    model = mujoco.MjModel.from_xml_path(file)
    robot = {}
    for index in range(model.nbody):
        body = model.body(index)
        robot[f"links:{body.name}"] = model.body(body.parentid[0]).name
        robot[f"poses:{body.name}"] = [*body.pos, *body.quat]
        robot[f"masses:{body.name}"] = [*body.mass, *body.ipos]
        robot[f"inertias:{body.name}"] = [*body.inertia, *body.iquat]
    for index in range(model.njnt):
        joint = model.joint(index)
        robot[f"joints:{joint.name}"] = [TYPES[joint.type[0]], model.body(joint.bodyid[0]).name]
        robot[f"axes:{joint.name}"] = [*joint.axis, *joint.pos]
        robot[f"dynamics:{joint.name}"] = [*joint.damping.ravel(), *joint.frictionloss]
        robot[f"limits:{joint.name}"] = [*joint.limited, *joint.range,
                                        *force_of(model, index)]
    for index in range(model.ngeom):
        geom = model.geom(index)
        moves = geom.contype[0] != 0 or geom.conaffinity[0] != 0
        mesh = "" if geom.dataid[0] < 0 else model.mesh(geom.dataid[0]).name
        robot[f"{'collisions' if moves else 'visuals'}:{model.body(geom.bodyid[0]).name}:{index}"] = [
            int(geom.type[0]), mesh, *geom.size, *geom.pos, *geom.quat]
        robot[f"colours:{index}"] = geom.rgba
    for index in range(model.neq):
        robot[f"mimics:{index}"] = [int(model.eq_type[index]), int(model.eq_obj1id[index]), int(model.eq_obj2id[index]),
                                    *model.eq_data[index]]
    return robot


run_reader(read)
