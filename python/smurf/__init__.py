# SPDX-License-Identifier: BSD-3-Clause
"""SMURF robot models: checked, loaded with types, placed, and exported.

    import smurf

    for finding in smurf.check("arm.smurf"):
        print(finding)                          # arm_motors.yml:3:10: error[SML3101] ...

    smurf.check("robots/")                      # all robots of a folder
    smurf.check_each("robots/")                 # a plain record of each, for data sets

    arm = smurf.load_model("arm.smurf")         # in a notebook: the robot in 3D
    arm.joint("elbow").limit.upper              # rad
    arm.motors[0].places["joint"]               # where that is written
    arm.forward_kinematics({"elbow": 0.5})      # {link: X_RL}, arrays of shape (4, 4)

    arm.write("mjcf").save("arm.xml")           # or sdf, usda, gltf, html, ...
    smurf.convert("arm.urdf", "arm/")           # a SMURF model of a URDF

    scene = smurf.load_scene("cell.smurfs").flatten()
    scene.X_WE                                  # array of shape (n, 4, 4)

Lengths are in metres, angles in radians, masses in kilograms. X_AB is the pose of the frame B in the
frame A: `p_A = X_AB @ p_B` for homogeneous p. Quaternions are (w, x, y, z). Arrays are copies. What a
file does not say is None; nothing is filled in. Objects keep what they were loaded with alive.

`python3 -m smurf lint ...` runs the program smurf-lint.
"""
from ._convert import convert, fix
from ._errors import Error
from ._plain import CheckRecord, check_batches, check_each
from ._urdf import Urdf

try:
    from ._smurf import (
        Box,
        Calibration,
        Capsule,
        Collision,
        CollisionAnnotation,
        Comparison,
        Controller,
        Cylinder,
        Dynamics,
        Exoskeleton,
        Export,
        Finding,
        FlatInstance,
        FlatModel,
        FlatScene,
        Graphics,
        Inertial,
        Instance,
        Interface,
        Joint,
        JointAnnotation,
        JointPoseSet,
        JointTask,
        Light,
        Limit,
        Link,
        LinkAnnotation,
        Material,
        MaterialAnnotation,
        Mesh,
        Mimic,
        Model,
        Motor,
        NodeAnnotation,
        Place,
        Report,
        SafetyController,
        Scene,
        Sensor,
        Session,
        Sphere,
        Submechanism,
        Submodel,
        TargetVerdict,
        Visual,
        VisualAnnotation,
        __version__,
        check,
        diff,
        explain,
        load_model,
        load_scene,
        parse_urdf,
    )
except ModuleNotFoundError as missing:
    if missing.name != "smurf._smurf":
        raise
    from . import _absent

    globals().update(__version__=_absent.version(), __getattr__=_absent.attribute)

__all__ = [
    "Box", "Calibration", "Capsule", "CheckRecord", "Collision", "CollisionAnnotation", "Comparison",
    "Controller", "Cylinder", "Dynamics", "Error", "Exoskeleton", "Export", "Finding", "FlatInstance",
    "FlatModel", "FlatScene", "Graphics", "Inertial", "Instance", "Interface", "Joint",
    "JointAnnotation", "JointPoseSet", "JointTask", "Light", "Limit", "Link", "LinkAnnotation",
    "Material", "MaterialAnnotation", "Mesh", "Mimic", "Model", "Motor", "NodeAnnotation", "Place",
    "Report", "SafetyController", "Scene", "Sensor", "Session", "Sphere", "Submechanism", "Submodel",
    "TargetVerdict", "Urdf", "Visual", "VisualAnnotation", "__version__", "check", "check_batches",
    "check_each", "convert", "diff", "explain", "fix", "load_model", "load_scene", "parse_urdf",
]
