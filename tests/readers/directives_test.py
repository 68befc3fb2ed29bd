# SPDX-License-Identifier: BSD-3-Clause
"""Drake directives. Drake itself is in no package here: what is written is read as YAML and put
together by the words of its documentation (multibody/parsing/README_model_directives.md)."""
import math
import unittest

import reader

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
        self.assertEqual([list(d) for d in self.directives("s.smurfs")], [["add_model"]])
        text = (self.folder / "out.dmd").read_text()
        self.assertNotIn("world", text.split("directives")[1].replace("w.urdf", ""))
        done = self.run_tool("s.smurfs", "--format", "dmd", "-o", "out.dmd", "--fail-on-loss")
        self.assertEqual(done.returncode, 1)
        self.assertIn("`There` is not in the Drake directives: Drake treats its link `world` as the world", done.stderr)
        self.assertIn("2 more findings like this one: `Free` and `On`", done.stderr)


if __name__ == "__main__":
    reader.main()
