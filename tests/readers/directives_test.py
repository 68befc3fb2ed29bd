# SPDX-License-Identifier: BSD-3-Clause
"""Drake directives. What is written is read as YAML and put together by the words of Drake's documentation
(multibody/parsing/README_model_directives.md); where Drake is installed, it loads what it is given."""
import math
import pathlib
import subprocess
import sys
import unittest

import reader

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "verdicts"))
import executed  # noqa: E402
import robot as robots  # noqa: E402

BODY = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
LOAD = """
import sys
from pydrake.all import AddMultibodyPlantSceneGraph, DiagramBuilder, Parser
builder = DiagramBuilder()
plant, scene_graph = AddMultibodyPlantSceneGraph(builder, 0.001)
parser = Parser(plant)
parser.package_map().Add("scene", sys.argv[2])
parser.AddModels(sys.argv[1])
plant.Finalize()
context = builder.Build().CreateDefaultContext()
query = scene_graph.get_query_output_port().Eval(scene_graph.GetMyContextFromRoot(context))
query.ComputePointPairPenetration()
print(plant.num_bodies())
"""

try:
    import yaml
except ImportError:
    yaml = None


def rotation(loader, suffix, node):
    value = loader.construct_mapping(node, deep=True)
    if suffix == "Identity":
        return [1, 0, 0, 0]
    half = math.radians(value["angle_deg"]) / 2
    return [math.cos(half), *(math.sin(half) * component for component in value["axis"])]


@unittest.skipUnless(yaml, "python3-yaml is not installed")
class Directives(reader.ReaderTest):
    def directives(self, scene):
        class Loader(yaml.SafeLoader):
            pass

        Loader.add_multi_constructor("!", rotation)
        text = self.write_scene(scene, "dmd").read_text()
        return yaml.load(text, Loader)["directives"]

    def test_free_bodies_and_welds(self):
        directives = self.directives(reader.SCENES["example"])
        flat = {i["path"].replace(" ", "_"): i for i in self.flat(reader.SCENES["example"])["instances"]}
        models = {d["add_model"]["name"]: d["add_model"] for d in directives if "add_model" in d}
        self.assertEqual(set(models), {"Eve", "Adam", "Lazy_Bob"})
        for name in ("Eve", "Adam"):
            pose, = models[name]["default_free_body_pose"].values()
            self.assert_same_pose(name, pose["translation"], pose["rotation"], flat[name])
        self.assertNotIn("default_free_body_pose", models["Lazy_Bob"])
        self.assertEqual(len(models["Lazy_Bob"]["default_joint_positions"]), 1)
        weld, = [d["add_weld"] for d in directives if "add_weld" in d]
        self.assertEqual(weld["parent"], "world")
        self.assert_same_pose("Lazy_Bob", weld["X_PC"]["translation"], weld["X_PC"]["rotation"],
                              flat["Lazy_Bob"])

    def test_what_hangs_on_links(self):
        welds = [d["add_weld"] for d in self.directives(reader.SCENES["nested"]) if "add_weld" in d]
        ends = {(w["parent"], w["child"].split("::")[0]) for w in welds}
        self.assertIn(("Base::flange", "cell__Table"), ends)
        self.assertIn(("cell__Table::top", "cell__Cup"), ends)
        cup, = [w for w in welds if w["parent"] == "cell__Table::top"]
        self.assert_same_pose("Cup", cup["X_PC"]["translation"], cup["X_PC"]["rotation"], {
            "position": [0, 0.1, 0.05],
            "orientation": {"w": math.sqrt(0.5), "x": math.sqrt(0.5), "y": 0, "z": 0}}, 1e-7)

    def test_a_link_called_world_is_the_world(self):
        body = ('<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>'
                "</inertial>")
        self.write("w.urdf", f'<robot name="w"><link name="world"/><link name="b">{body}</link>'
                   '<joint name="j" type="fixed"><parent link="world"/><child link="b"/></joint></robot>')
        self.write("s.smurfs", "entities:\n- {name: Here, type: urdf, file: w.urdf, anchor: world}\n"
                               "- {name: There, type: urdf, file: w.urdf, anchor: world, position: [0, 0, 1]}\n"
                               "- {name: Free, type: urdf, file: w.urdf}\n"
                               "- {name: On, type: urdf, file: w.urdf, parent: \"Here::b\", anchor: parent}\n")
        self.assertEqual([list(d) for d in self.directives("s.smurfs")], [["add_model"], ["add_model"]])
        text = (self.folder / "out.dmd").read_text()
        self.assertNotIn("world", text.split("directives")[1].replace("w.urdf", ""))
        done = self.run_tool("s.smurfs", "--format", "dmd", "-o", "out.dmd", "--fail-on-loss")
        self.assertEqual(done.returncode, 1)
        self.assertIn("`There` is not in the Drake directives: Drake treats its link `world` as the world", done.stderr)
        self.assertIn("1 more finding like this one: `On`", done.stderr)



class Models(reader.ReaderTest):
    """Models that Drake does not load are copied, or refused by name."""

    def setUp(self):
        super().setUp()
        for name, content in robots.meshes().items():
            path = self.folder / "meshes" / name
            path.parent.mkdir(exist_ok=True)
            path.write_bytes(content)

    def write_robot(self, *meshes, joint="revolute"):
        shapes = "".join(f'<collision><geometry><mesh filename="{mesh}"/></geometry></collision>' for mesh in meshes)
        self.write("r.urdf", f'<robot name="r"><link name="a">{BODY}</link><link name="b">{BODY}{shapes}</link><joint name="j" '
                             f'type="{joint}"><parent link="a"/><child link="b"/><limit lower="-1" upper="1" effort="1" velocity="1"/>'
                             "</joint></robot>")

    def flatten(self, *options, code=0):
        done = self.run_tool("r.urdf", "--format", "dmd", *options)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def load(self):
        if not executed.python_version("drake"):
            self.skipTest("Drake is not installed: scripts/setup --python-readers")
        return self.read_with(executed.PYTHON, "-c", LOAD, self.folder / "r.dmd.yaml", self.folder).strip()

    def test_what_loads_stays(self):
        self.write_robot("meshes/cube.obj")
        self.assertNotIn("copied", self.flatten("-o", "r.dmd.yaml").stderr)
        self.assertIn('"package://scene/r.urdf"', (self.folder / "r.dmd.yaml").read_text())
        self.assertFalse((self.folder / "r_models").exists())
        self.assertEqual(self.load(), "3")

    def test_meshes_are_copied(self):
        self.write_robot("meshes/cube.stl", "meshes/cube.dae")
        told = self.flatten("-o", "r.dmd.yaml").stderr
        self.assertIn("copied for Drake, which does not load the originals: 1 model with 2 meshes as .obj to r_models", " ".join(told.split()))
        self.assertIn('"package://scene/r_models/r.urdf"', (self.folder / "r.dmd.yaml").read_text())
        self.assertEqual(len(list((self.folder / "r_models/r_meshes").glob("*.obj"))), 2)
        self.assertEqual(self.load(), "3")

    def test_packages_are_resolved(self):
        self.write_robot("package://meshes/cube.obj")
        self.flatten("-o", "r.dmd.yaml")
        self.assertNotIn("package:", (self.folder / "r_models/r.urdf").read_text())
        self.assertEqual(self.load(), "3")

    def test_what_cannot_be_repaired_is_refused(self):
        self.write_robot("meshes/absent.obj")
        told = self.flatten("-o", "r.dmd.yaml", code=1).stderr
        self.assertIn("cannot be converted: Drake refuses", told)
        self.assertIn("(SML1604 at /robot/link[@name='b']/collision/geometry/mesh/@filename) in 'r.urdf'", told)
        self.assertFalse((self.folder / "r.dmd.yaml").exists())
        self.flatten("-o", "r.dmd.yaml", "--force")
        self.assertIn('"package://scene/r.urdf"', (self.folder / "r.dmd.yaml").read_text())

    def test_standard_output_has_no_copies(self):
        self.write_robot("meshes/cube.stl")
        self.assertIn("with -o FILE, copies that it loads are written", self.flatten(code=1).stderr)

    def test_no_copy_replaces_an_input(self):
        self.write_robot("meshes/cube.stl")
        (self.folder / "r_models").mkdir()
        (self.folder / "r.urdf").rename(self.folder / "r_models/r.urdf")
        (self.folder / "meshes").rename(self.folder / "r_models/meshes")
        done = self.run_tool("r_models/r.urdf", "-o", "r.dmd.yaml", "--format", "dmd")
        self.assertEqual(done.returncode, 2, done.stderr)


if __name__ == "__main__":
    reader.main()
