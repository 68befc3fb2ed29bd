# SPDX-License-Identifier: BSD-3-Clause
"""What --collision of smurfs-flatten writes, in MuJoCo, OpenUSD, libsdformat and Drake: the links, masses and places are those of
the result without it, and the collisions are the new ones. CoACD divides a bracket where the `python3` on the PATH has it.
"""
import json
import pathlib
import shutil
import subprocess
import sys
import unittest

import reader

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "cli"))
import collision_shapes_test as shapes  # noqa: E402

PYTHON = reader.cli.FIXTURES.parent / "build/readers/python/bin/python"
COUNTS = {"keep": 1, "hull": 1, "boxes": 1, "capsules": 1, "parts": 3}  # in place of one mesh
MESHES = 4

MUJOCO = """
import json, sys, mujoco, numpy
model = mujoco.MjModel.from_xml_path(sys.argv[1])
data = mujoco.MjData(model)
same = {key: numpy.asarray(getattr(model, key)).tolist() for key in
        ("body_mass", "body_inertia", "body_ipos", "body_iquat", "body_pos", "body_quat", "jnt_axis", "jnt_range")}
same["names"] = [model.body(i).name for i in range(model.nbody)]
for _ in range(500): mujoco.mj_step(model, data)
types = [int(t) for t, c in zip(model.geom_type, model.geom_contype) if c]
print(json.dumps([same, types, bool(numpy.isfinite(data.qpos).all())]))
"""
USD = """
import json, sys
from pxr import Usd, UsdGeom, UsdPhysics
stage = Usd.Stage.Open(sys.argv[1])
same, kinds = [], []
for prim in Usd.PrimRange(stage.GetPrimAtPath("/World"), Usd.TraverseInstanceProxies()):
    if prim.HasAPI(UsdPhysics.MassAPI):
        mass = UsdPhysics.MassAPI(prim)
        same.append([str(prim.GetPath()), mass.GetMassAttr().Get(), list(mass.GetDiagonalInertiaAttr().Get()),
                     list(mass.GetCenterOfMassAttr().Get()),
                     [list(row) for row in UsdGeom.Xformable(prim).ComputeLocalToWorldTransform(Usd.TimeCode.Default())]])
    if prim.HasAPI(UsdPhysics.CollisionAPI): kinds.append(str(prim.GetTypeName()))
print(json.dumps([same, kinds, True]))
"""
DRAKE = """
import json, sys
from pydrake.all import AddMultibodyPlantSceneGraph, DiagramBuilder, Parser, Role
builder = DiagramBuilder()
plant, scene_graph = AddMultibodyPlantSceneGraph(builder, 0.001)
parser = Parser(plant)
parser.package_map().Add("scene", sys.argv[1].rsplit("/", 1)[0])
parser.AddModels(sys.argv[1])
plant.Finalize()
context = plant.CreateDefaultContext()
inspector = scene_graph.model_inspector()
same = []
for i in sorted(plant.GetBodyIndices(plant.GetModelInstanceByName("bot")), key=int):
    body = plant.get_body(i)
    same.append([body.name(), body.default_mass(), plant.EvalBodyPoseInWorld(context, body).GetAsMatrix4().tolist()])
found = inspector.GetGeometryIds(__import__("pydrake.geometry", fromlist=["GeometrySet"]).GeometrySet(
    inspector.GetAllGeometryIds()), Role.kProximity)
print(json.dumps([same, sorted(type(inspector.GetShape(g)).__name__ for g in found), True]))
"""


def has_module(name, python=PYTHON):
    program = shutil.which(str(python))
    return program is not None and subprocess.run([program, "-c", f"import {name}"], capture_output=True, check=False).returncode == 0


def needs_module(name):
    return unittest.skipUnless(has_module(name), f"the Python module {name} is not installed")


class CollisionReadersTest(reader.ReaderTest):
    def setUp(self):
        super().setUp()
        self.leave_repository()
        points, faces = shapes.bracket()
        self.write("meshes/bracket.stl", shapes.stl_of(points, faces))
        self.write("meshes/bracket.obj", shapes.obj_of(points, faces))
        self.write("meshes/sheet.obj", shapes.obj_of(points, faces))
        self.write("bot.urdf", shapes.URDF)
        self.write("modules/coacd.py", shapes.COACD)

    def convert(self, output, form, choice):
        done = self.run_tool("bot.urdf", "--format", form, "-o", output, "--collision", choice, "--quiet", "--force",
                             environment={"PYTHONPATH": str(self.folder / "modules")})
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.folder / output

    def compare(self, form, extension, command, kinds):
        before = None
        for choice, count in COUNTS.items():
            path = self.convert(f"{choice}.{extension}", form, choice)
            same, found, holds = json.loads(self.read_with(*command, path))
            before = before or same
            self.assertEqual(same, before, choice)
            self.assertTrue(holds, choice)
            # Four brackets, a sheet that is a bracket here, too, and a box of the model.
            expected = [kinds[choice]] * (count * (MESHES + 1)) + [kinds["boxes"]]
            self.assertEqual(sorted(found), sorted(expected), choice)

    @needs_module("mujoco")
    def test_mujoco(self):
        capsule, box, mesh = 3, 6, 7  # mjtGeom
        kinds = {"keep": mesh, "hull": mesh, "parts": mesh, "boxes": box, "capsules": capsule}
        self.compare("mjcf", "xml", [PYTHON, "-c", MUJOCO], kinds)

    @needs_module("pxr")
    def test_usd(self):
        kinds = {"keep": "Mesh", "hull": "Mesh", "parts": "Mesh", "boxes": "Cube", "capsules": "Capsule"}
        self.compare("usda", "usda", [PYTHON, "-c", USD], kinds)

    @needs_module("pydrake")
    def test_drake(self):
        for choice in ("hull", "boxes", "parts"):
            path = self.convert(f"{choice}.dmd.yaml", "dmd", choice)
            same, found, _ = json.loads(self.read_with(PYTHON, "-c", DRAKE, path))
            self.assertEqual([name for name, *_ in same], ["base", "finger_left", "finger_right", "plate"])
            self.assertEqual([mass for _, mass, _ in same], [2, 1, 1, 1])
            self.assertEqual(len(found), COUNTS[choice] * (MESHES + 1) + 1, found)

    @reader.needs_program("ign")
    def test_libsdformat(self):
        for choice in COUNTS:
            path = self.convert(f"{choice}.sdf", "sdf", choice)
            self.assertEqual(self.read_with("ign", "sdf", "-k", path).strip(), "Valid.")

    @unittest.skipUnless(has_module("coacd", "python3"), "the python3 on the PATH has no CoACD")
    def test_coacd(self):
        done = self.run_tool("bot.urdf", "--format", "sdf", "-o", "out.sdf", "--collision", "base=parts", "--report", "json=report.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        told = [one["message"] for one in json.loads(self.read("report.json"))["diagnostics"] if one["id"] == "SML8213"]
        self.assertEqual(len(told), 1)
        parts = int(told[0].split("becomes ")[1].split()[0])
        gain = float(told[0].rsplit("volume ", 1)[1].split()[0])
        self.assertGreaterEqual(parts, 2, told)
        self.assertLessEqual(parts, 32, told)
        self.assertLessEqual(abs(gain), 5, told)


if __name__ == "__main__":
    reader.main()
