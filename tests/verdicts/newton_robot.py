# SPDX-License-Identifier: BSD-3-Clause
"""Robots as Newton reads them: what its builder holds."""
import pathlib
import tempfile

import newton
import robot as robots
from run_reader import run_reader


def own_name(label):
    """Labels begin with the name of the robot."""
    return label.split("/", maxsplit=1)[-1]


def corners(mesh):
    """The number of vertices, and the box around them."""
    points = getattr(mesh, "vertices", [])
    return [len(points), *(points.min(axis=0) if len(points) else ()), *(points.max(axis=0) if len(points) else ())]


def read(file):
    builder = newton.ModelBuilder()
    builder.add_urdf(file)
    robot = {}
    bodies = ["world" if index < 0 else own_name(builder.body_label[index])
              for index in (-1, *range(builder.body_count))]
    for index in range(builder.body_count):
        name = own_name(builder.body_label[index])
        robot[f"links:{name}"] = ""
        robot[f"masses:{name}"] = [builder.body_mass[index], *builder.body_com[index]]
        robot[f"inertias:{name}"] = [builder.body_inertia[index][row, column] for row in range(3) for column in range(3)]
    for index in range(builder.joint_count):
        name = own_name(builder.joint_label[index])
        robot[f"joints:{name}"] = [int(builder.joint_type[index]), bodies[1 + builder.joint_parent[index]],
                                   bodies[1 + builder.joint_child[index]]]
        robot[f"poses:{name}"] = [*builder.joint_X_p[index], *builder.joint_X_c[index]]
        first = builder.joint_qd_start[index]
        last = builder.joint_qd_start[index + 1] if index + 1 < builder.joint_count else builder.joint_dof_count
        robot[f"axes:{name}"] = [list(builder.joint_axis[dof]) for dof in range(first, last)]
        robot[f"limits:{name}"] = [[builder.joint_limit_lower[dof], builder.joint_limit_upper[dof], builder.joint_effort_limit[dof],
                                    builder.joint_velocity_limit[dof]] for dof in range(first, last)]
        robot[f"dynamics:{name}"] = [[builder.joint_damping[dof], builder.joint_friction[dof]] for dof in range(first, last)]
        robot[f"mimics:{name}"] = [builder.joint_mimic_joint[index], *builder.joint_mimic_coeffs[index]]
    for index in range(builder.shape_count):
        flags = int(builder.shape_flags[index])
        kind = "collisions" if flags & int(newton.ShapeFlags.COLLIDE_SHAPES) else "visuals"
        source = builder.shape_source[index]
        robot[f"{kind}:{bodies[1 + builder.shape_body[index]]}:{index}"] = [
            int(builder.shape_type[index]), *builder.shape_scale[index], *builder.shape_transform[index],
            *corners(source)]
        if kind == "visuals":
            robot[f"colors:{index}"] = [*builder.shape_color[index], builder.shape_opacity[index]]
    return robot


def warm_up():
    """Its first robot loads hundreds of modules, which each child would do again."""
    with tempfile.TemporaryDirectory() as folder:
        for name, content in {**robots.meshes(), "robot.urdf": robots.document(robots.parse(robots.TEXT)).encode()}.items():
            (pathlib.Path(folder) / name).write_bytes(content)
        read(folder + "/robot.urdf")


warm_up()
run_reader(read)
