# SPDX-License-Identifier: BSD-3-Clause
"""Which links of a robot can touch each other: --self-collision, the pairs of the SRDF and bitmasks, in MJCF, USD, SDF and
Drake directives. The pairs are counted by the words of each format; MuJoCo, OpenUSD and Drake count theirs where they are
installed."""
import itertools
import json
import re
import subprocess
import unittest
import xml.etree.ElementTree as ElementTree

import reader
from usd_stage import Stage

PYTHON = reader.cli.ROOT / "build/readers/python/bin/python"
BODY = '<inertial><mass value="1"/><inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial>'
BOX = '<collision name="{0}_box"><geometry><box size="0.5 0.5 0.5"/></geometry></collision>'


def link(name, body=BODY):
    return f'<link name="{name}">{body}{BOX.format(name)}</link>'


def joint(name, kind, parent, child, xyz):
    return (f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/><origin xyz="{xyz}"/>'
            '<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="5" velocity="1"/></joint>')


# pad and base, and arm and eye, are one body each; the eye is a frame in USD.
URDF = ('<robot name="bot">' + link("base") + link("pad") + link("arm") + link("eye", "") + link("hand") + link("tip") +
        joint("glue", "fixed", "base", "pad", "0 0 0.7") + joint("j1", "revolute", "base", "arm", "0 0 1.6") +
        joint("mount", "fixed", "arm", "eye", "0.2 0 0") + joint("j2", "revolute", "arm", "hand", "0 0 1") +
        joint("j3", "revolute", "hand", "tip", "0 0 1") + "</robot>")
SRDF = ('<robot name="bot"><disable_collisions link1="base" link2="hand" reason="Default"/>'
        '<disable_collisions link1="eye" link2="tip" reason="Never"/></robot>')
LINKS = ("arm", "base", "eye", "hand", "pad", "tip")
BODIES = {"base": 0, "pad": 0, "arm": 1, "eye": 1, "hand": 2, "tip": 3}  # each a neighbour of the next


def pairs(text):
    return {tuple(sorted(one.split("|"))) for one in text.split()}


ALL = {one for one in itertools.combinations(LINKS, 2) if BODIES[one[0]] != BODIES[one[1]]}
NEIGHBOURS = {one for one in ALL if abs(BODIES[one[0]] - BODIES[one[1]]) > 1}
EXPECTED = {"none": set(), "neighbours": NEIGHBOURS, "srdf": NEIGHBOURS - pairs("base|hand eye|tip"), "all": ALL}

MUJOCO = """
import itertools, json, sys, mujoco
model = mujoco.MjModel.from_xml_path(sys.argv[1])
left_out = {(s >> 16, s & 0xffff) for s in map(int, model.exclude_signature)}
parents = not model.opt.disableflags & int(mujoco.mjtDisableBit.mjDSBL_FILTERPARENT)
found = []
for g, h in itertools.combinations(range(model.ngeom), 2):
    a, b = int(model.geom_bodyid[g]), int(model.geom_bodyid[h])
    if not (model.geom_contype[g] & model.geom_conaffinity[h] or model.geom_contype[h] & model.geom_conaffinity[g]): continue
    weld, other = model.body_weldid[a], model.body_weldid[b]
    above, other_above = (model.body_weldid[model.body_parentid[w]] for w in (weld, other))
    if weld == other or (a, b) in left_out or (b, a) in left_out: continue
    if parents and (weld and weld == other_above or other and other == above): continue
    found.append([model.body(a).name.split("/")[-1], model.body(b).name.split("/")[-1]])
print(json.dumps(found))
"""
DRAKE = """
import json, sys
from pydrake.all import AddMultibodyPlantSceneGraph, DiagramBuilder, Parser
builder = DiagramBuilder()
plant, scene_graph = AddMultibodyPlantSceneGraph(builder, 0.001)
parser = Parser(plant)
parser.package_map().Add("scene", sys.argv[1].rsplit("/", 1)[0])
parser.AddModels(sys.argv[1])
plant.Finalize()
inspector = scene_graph.model_inspector()
name = lambda geometry: plant.GetBodyFromFrameId(inspector.GetFrameId(geometry)).name()
print(json.dumps([[name(g), name(h)] for g, h in inspector.GetCollisionCandidates()]))
"""
USD = """
import itertools, json, sys
from pxr import Usd, UsdPhysics
stage = Usd.Stage.Open(sys.argv[1])
shapes, filtered, joined = [], set(), set()
enabled = any(p.GetAttribute("physxArticulation:enabledSelfCollisions").Get() for p in stage.Traverse())
for prim in stage.Traverse():
    if prim.HasAPI(UsdPhysics.CollisionAPI): shapes.append(prim)
    if prim.HasAPI(UsdPhysics.FilteredPairsAPI):
        for target in UsdPhysics.FilteredPairsAPI(prim).GetFilteredPairsRel().GetTargets():
            at = stage.GetPrimAtPath(target)
            assert at and (at.HasAPI(UsdPhysics.CollisionAPI) or at.HasAPI(UsdPhysics.RigidBodyAPI)), target
            filtered.add((str(prim.GetPath()), str(target)))
    joint = UsdPhysics.Joint(prim)
    if joint and not joint.GetCollisionEnabledAttr().Get():
        joined.add(tuple(str(next(iter(rel.GetTargets()), "")) for rel in (joint.GetBody0Rel(), joint.GetBody1Rel())))
def above(prim):
    while prim and not prim.IsPseudoRoot():
        yield prim
        prim = prim.GetParent()
def body(prim): return next(str(one.GetPath()) for one in above(prim) if one.HasAPI(UsdPhysics.RigidBodyAPI))
def are_in(some, a, b): return any((x, y) in some or (y, x) in some for x in a for y in b)
found = []
for a, b in itertools.combinations(shapes, 2):
    if not enabled or body(a) == body(b) or are_in(joined, [body(a)], [body(b)]): continue
    if are_in(filtered, *([str(p.GetPath()) for p in above(one)] for one in (a, b))): continue
    found.append([str(one.GetParent().GetName()) for one in (a, b)])
print(json.dumps(found))
"""


class SelfCollision(reader.ReaderTest):
    def setUp(self):
        super().setUp()
        self.write("bot.urdf", URDF)
        self.write("bot.srdf", SRDF)

    def counted(self, program, module, file):
        probe = [str(PYTHON), "-c", f"import {module}"]
        if not PYTHON.exists() or subprocess.run(probe, capture_output=True, check=False).returncode:
            self.skipTest(f"{module} for Python is not installed")
        found = json.loads(self.read_with(PYTHON, "-c", program, file).splitlines()[-1])
        return {tuple(sorted(one)) for one in found}

    def flat(self, form, *arguments, name="bot.urdf"):
        output = self.folder / f"out.{form}"
        done = self.run_tool(name, "--format", form, "-o", output, "--force", *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return output, done.stderr

    def test_mujoco(self):
        for choice, expected in EXPECTED.items():
            found = self.counted(MUJOCO, "mujoco", self.flat("mjcf", "--self-collision", choice)[0])
            self.assertEqual(found, expected, choice)

    def test_drake(self):
        for choice, expected in EXPECTED.items():
            file, said = self.flat("dmd", "--self-collision", choice)
            found = self.counted(DRAKE, "pydrake.multibody.parsing", file.rename(file.with_suffix(".dmd.yaml")))
            self.folder.joinpath("out.dmd.yaml").unlink()
            if choice == "all":
                self.assertIn("that a joint connects are not in the result", said)
                expected = expected - pairs("arm|base arm|hand hand|tip")
            self.assertEqual(found, expected, choice)

    def test_usd(self):
        for choice, expected in EXPECTED.items():
            file = self.flat("usda", "--self-collision", choice)[0]
            found = self.counted(USD, "pxr", file.rename(self.folder / "out.usda"))
            self.assertEqual(found, expected, choice)

    def test_filtered_pairs_of_usd(self):
        """Without OpenUSD: the pairs that are written, and nothing at all without a choice."""
        def written(*arguments):
            prims = Stage(self.flat("usda", *arguments)[0].read_text()).prims
            for path, prim in prims.items():
                has_api = "PhysicsFilteredPairsAPI" in prim.get("apiSchemas", [])
                self.assertEqual(has_api, "physics:filteredPairs" in prim, path)
                for target in re.findall("</(.*?)>", prim.get("physics:filteredPairs", "")):
                    self.assertIn(target, prims)
            return prims

        plain = written()
        self.assertEqual(plain["World/bot"]["physxArticulation:enabledSelfCollisions"], "0")
        self.assertFalse([path for path, prim in plain.items() if "physics:filteredPairs" in prim])
        prims = written("--self-collision", "srdf")
        self.assertEqual(prims["World/bot"]["physxArticulation:enabledSelfCollisions"], "1")
        self.assertIn("physics:filteredPairs", prims["World/bot/base"])
        self.assertIn("physics:filteredPairs", prims["World/bot/arm/eye/shape_1"])
        self.assertEqual(written("--self-collision", "all")["World/bot/joints/j1"]["physics:collisionEnabled"], "1")

    def test_sdf(self):
        def own(*arguments):
            file, said = self.flat("sdf", *arguments)
            root = ElementTree.fromstring(file.read_text())
            return [one.text for one in root.iter("self_collide")], said

        lost = "pairs of links that cannot touch (`base and hand`, `eye and tip`) are not in the SDF"
        values, said = own()
        self.assertEqual(values, [])  # nothing touches
        self.assertNotIn(lost, said)
        values, said = own("--self-collision", "srdf")
        self.assertEqual(values, ["true"])
        self.assertIn(lost, said)
        values, said = own("--self-collision", "neighbours")
        self.assertEqual(values, ["true"])
        self.assertNotIn(lost, said)
        values, said = own("--self-collision", "all")
        self.assertIn("that a joint connects are not in the result", said)
        # What the model says counts until somebody chooses.
        self.write("bot.urdf", URDF.replace("</robot>", '<gazebo reference="arm"><selfCollide>true</selfCollide></gazebo>'
                                            "<gazebo><self_collide>true</self_collide></gazebo></robot>"))
        values, said = own()
        self.assertEqual(values, ["1", "true"])
        self.assertIn(lost, said)
        values, said = own("--self-collision", "none")
        self.assertEqual(values, ["false"])
        self.assertNotIn(lost, said)

    def test_bitmasks(self):
        """Where a format has no bitmasks, links whose collisions share no bit are a pair."""
        self.write("bot.smurf", "modelname: bot\nfiles: [bot.urdf, bot.yml]\n")
        self.write("bot.yml", "collision:\n- {name: arm_box, link: arm, bitmask: 1}\n- {name: tip_box, link: tip, bitmask: 6}\n")
        text = self.flat("dmd", name="bot.smurf")[0].read_text()
        groups = dict(re.findall(r'name: "bot_contacts_of_(\w+)"\n.*\n.*ignored_collision_filter_groups: \[(.*)\]', text))
        self.assertIn('"bot_contacts_of_tip"', groups["arm"])
        self.assertNotIn('"bot_contacts_of_tip"', groups.get("pad", ""))

    def test_what_a_format_cannot_do_is_refused(self):
        for arguments, words in ((["--format", "sdf", "--srdf", "bot.srdf"], "--srdf and --exclude-overlaps need one of"),
                                 (["--format", "gltf", "--self-collision", "all"], "--self-collision needs one of"),
                                 (["--format", "mjcf", "--form", "reference", "--self-collision", "all"], "needs --form expand")):
            done = self.run_tool("bot.urdf", "-o", "out", *arguments)
            self.assertEqual((done.returncode, (self.folder / "out").exists()), (2, False), done.stderr)
            self.assertIn(words, done.stderr)

    def test_a_named_urdf_loses_them(self):
        said = self.flat("mjcf", "--form", "reference")[1]
        self.assertIn("2 pairs of links of `bot.urdf` can touch, which `bot.srdf` disables", said)


if __name__ == "__main__":
    reader.main()
