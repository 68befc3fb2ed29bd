# SPDX-License-Identifier: BSD-3-Clause
"""Robots as Isaac's converter of URDF reads them: what stands in the USD that it writes."""
import tempfile

from pxr import Usd, UsdGeom, UsdPhysics
from run_reader import run_reader
from urdf_usd_converter import Converter

LARGE = ("points", "faceVertexIndices", "faceVertexCounts", "primvars:st", "normals")  # the extent says enough


def kind_of(prim):
    if prim.HasAPI(UsdPhysics.RigidBodyAPI):
        return "links"
    if prim.IsA(UsdPhysics.Joint):
        return "joints"
    if prim.IsA(UsdGeom.Gprim):
        return "collisions" if prim.HasAPI(UsdPhysics.CollisionAPI) else "visuals"
    return "materials" if prim.GetTypeName() in ("Material", "Shader") else ""


def number_or_text(value):
    if isinstance(value, (bool, int, float, str)):
        return value
    if hasattr(value, "GetReal"):
        return [value.GetReal(), *value.GetImaginary()]
    if hasattr(value, "__iter__"):
        return [number_or_text(one) for one in value]
    return str(value)


def read(file):
    robot = {}
    with tempfile.TemporaryDirectory() as folder:
        tempfile.tempdir = folder  # it leaves folders there
        written = Converter(layer_structure=False).convert(file, folder)
        stage = Usd.Stage.Open(written.path)
        for prim in stage.Traverse():
            kind = kind_of(prim)
            path = str(prim.GetPath())
            if not kind or "/custom/" in path:
                continue
            robot[f"{kind}:{path}"] = [prim.GetTypeName(), sorted(prim.GetAppliedSchemas())]
            for attribute in prim.GetAuthoredAttributes():
                name = attribute.GetName()
                if name not in LARGE and "Texture" not in name:
                    robot[f"{kind}:{path}:{name}"] = number_or_text(attribute.Get())
            for relationship in prim.GetAuthoredRelationships():
                robot[f"{kind}:{path}:{relationship.GetName()}"] = [str(one) for one in relationship.GetTargets()]
    return robot


run_reader(read)
