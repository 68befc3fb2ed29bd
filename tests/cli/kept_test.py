# SPDX-License-Identifier: BSD-3-Clause
"""smurfs-flatten writes everything in a model or a scene, or reports the loss.

Each thing of a rich scene is changed or removed, and each format must change its result or its
warnings. The things are those of docs/scene-formats.md, every one of which has a change here.
What the table does not call kept must be in the warnings, also when the result changes with it.

Usage: kept_test.py SMURFS-FLATTEN
"""
import json
import re
import struct
import unittest
import zlib

import cli

FORMATS = ("sdf", "sdf1.6", "mjcf", "urdf", "dmd", "html", "gltf", "usda")
BODY = ('<inertial><mass value="{m}"/><inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" '
        'iyz="0"/></inertial>')
URDF = """<robot name="rich">
<gazebo><plugin name="brain" filename="libbrain.so"/></gazebo>
<link name="base">""" + BODY.format(m="2") + """
  <visual name="hull"><geometry><box size="1 2 3"/></geometry>
    <material name="red"><color rgba="1 0 0 1"/></material></visual>
  <visual><geometry><box size="2 1 1"/></geometry>
    <material name="blue"><color rgba="0 0 1 1"/></material></visual>
  <visual><geometry><box size="1 1 1"/></geometry>
    <material name="skin"><color rgba="0 1 0 1"/><texture filename="skin.png"/></material></visual>
  <collision name="bumper"><geometry><box size="1 2 3"/></geometry></collision>
  <collision name="shield" group="2"><geometry><box size="2 2 2"/></geometry></collision>
  <contact><lateral_friction value="0.4"/></contact></link>
<link name="arm">""" + BODY.format(m="1") + """</link>
<joint name="shoulder" type="revolute"><parent link="base"/><child link="arm"/><axis xyz="0 0 1"/>
  <limit lower="-1" upper="2" effort="5" velocity="3" acceleration="9"/>
  <dynamics damping="0.25" friction="0.125"/><calibration rising="0.5"/>
  <safety_controller soft_lower_limit="-0.5" k_velocity="7"/></joint>
<link name="hand"><collision><geometry><sphere radius="0"/></geometry></collision>""" + BODY.format(m="1") + """</link>
<joint name="wrist" type="revolute"><parent link="arm"/><child link="hand"/><axis xyz="0 1 0"/>
  <limit lower="-1" upper="1" effort="6" velocity="4"/><mimic joint="shoulder" multiplier="0.5"/></joint>
<link name="finger"/>
<joint name="knuckle" type="prismatic"><parent link="hand"/><child link="finger"/><axis xyz="1 0 0"/>
  <limit lower="0" upper="1" effort="8" velocity="2"/></joint>
<link name="pad">""" + BODY.format(m="1") + """<collision><geometry><box size="1 1 1"/></geometry></collision></link>
<joint name="glue::d" type="fixed"><parent link="base"/><child link="pad"/></joint>
<gazebo reference="base"><sensor name="touch" type="contact"><contact>
  <collision>base_fixed_joint_lump__bumper_collision</collision>
  <collision>base_fixed_joint_lump__pad_collision_2</collision></contact></sensor></gazebo>
<link name="flat"><collision><geometry><mesh filename="fork.obj"/></geometry></collision><visual><geometry><mesh filename="two.obj"/></geometry></visual><inertial><mass value="1"/><inertia ixx="0.0001" iyy="0.0001" izz="0.000201" ixy="0"
  ixz="0" iyz="0"/></inertial></link>
<joint name="hinge" type="continuous"><parent link="base"/><child link="flat"/><axis xyz="0 0 1"/></joint>
<link name="ball"><inertial><mass value="1"/></inertial>
  <collision><geometry><sphere radius="0.125"/></geometry></collision></link>
<joint name="roll" type="continuous"><parent link="base"/><child link="ball"/><axis xyz="0 0 1"/></joint>
<link name="dot"><inertial><mass value="1"/><inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial>
  <collision><geometry><sphere radius="0.375"/></geometry></collision></link>
<joint name="spin" type="continuous"><parent link="base"/><child link="dot"/><axis xyz="0 0 1"/></joint>
<joint name="loop" type="continuous"><parent link="pad"/><child link="dot"/><axis xyz="0 0 1"/></joint>
<link name="island"/>
<gazebo reference="arm"><selfCollide>true</selfCollide><mu1>0.75</mu1><kp>7</kp><sensor name="eye" type="camera"><camera/></sensor></gazebo>
<transmission name="drive"><type>transmission_interface/SimpleTransmission</type>
  <joint name="knuckle"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></joint>
  <actuator name="knuckle_actuator"><mechanicalReduction>50</mechanicalReduction></actuator></transmission>
<ros2_control name="system" type="system"><joint name="hinge"><command_interface name="velocity"/><state_interface name="position"/></joint>
</ros2_control>
</robot>
"""
ANNOTATIONS = """motors:
- {name: shoulder_motor, joint: shoulder, type: PID, maxEffort: 5, maxSpeed: 3, p: 20, filterValue: 0.5}
- {name: wrist_motor, joint: wrist, type: PID, maxEffort: 5, maxSpeed: 3}
sensors:
- {name: imu, type: NodeIMU, link: arm, id: [arm], cutoff: 3}
controllers:
- {name: brain, rate: 10, sensors: [imu], motors: [shoulder_motor]}
materials:
- {name: skin, shininess: 2, diffuseColor: {r: 1, g: 0.5, b: 0, a: 1}}
collision:
- {name: bumper, link: base, bitmask: 6, cfriction1: 0.5, cerp: 0.3}
joint:
- {name: shoulder, springDamping: 3}
joint_tasks:
- {name: shoulder, provider: frames, port: shoulder, driver: arm}
link:
- {name: arm, density: 3}
visuals:
- {name: hull, link: base, materialName: skin}
nodes:
- {name: extra, parent: arm}
lights:
- {name: lamp, nodeName: arm}
graphics: {clearColor: {r: 1, g: 1, b: 1, a: 1}}
poses:
- {name: straight, joints: {shoulder_motor: 0}}
- {name: bent, joints: {shoulder_motor: 0.5}}
submechanisms:
- {name: parallel, type: fourbar, jointnames: [shoulder]}
exoskeletons:
- {name: sleeve, around: arm, jointnames: [shoulder]}
interfaces:
- {name: flange, parent: hand, position: [0, 0, 0], rotation: [0, 0, 0]}
submodels:
  half: {exportdir: half, start: arm, stop: [hand]}
own_section:
- {name: something}
"""
SCENE = """plugins: [libmars_gui]
physics: {gravity: {x: 0, y: 0, z: -3}, ode: {stepsize: 2, cfm: 1.0e-8, erp: 0.3}}
environment: {fog: {density: 0.5}}
lights:
- {name: lamp, type: 1, position: {x: 0, y: 0, z: 3}, linearAttenuation: 0.25, ambient: {r: 1, g: 0, b: 0, a: 1}}
entities:
- {name: Robot, file: rich.smurf, pose: bent, anchor: world}
- {name: Ball, type: primitive, geometry: {type: sphere}, position: {x: 2, y: 0, z: 3}, bitmask: 2,
   cfriction2: 0.25, colour: blue}
- {name: Cloud, type: weather, rain: heavy}
- {name: Free, file: free.urdf}
- {name: Free Änd easy, file: free.urdf, anchor: none}
- {name: Hill, type: heightmap, file: hill.png, width: 1, length: 1, height: 1}
"""
# A tetrahedron, and a flat part in another colour.
TWO = """mtllib two.mtl
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
usemtl red
f 1 3 2
f 1 2 4
f 2 3 4
f 3 1 4
usemtl green
f 1 2 3
"""
# Two prongs on a bar: the hull has 2.5 times the volume.
PROFILE = ((0, 0), (10, 0), (10, 10), (8.5, 10), (8.5, 1.5), (1.5, 1.5), (1.5, 10), (0, 10))
LID = ((1, 2, 5), (1, 5, 6), (2, 3, 4), (2, 4, 5), (1, 6, 7), (1, 7, 8))
FORK = "".join(f"v {x} {y} {z}\n" for z in (0, 2) for x, y in PROFILE) + "".join(
    f"f {c} {b} {a}\nf {a + 8} {b + 8} {c + 8}\n" for a, b, c in LID) + "".join(
    f"f {i + 1} {(i + 1) % 8 + 1} {(i + 1) % 8 + 9}\nf {i + 1} {(i + 1) % 8 + 9} {i + 9}\n" for i in range(8))


def png(*pixels, height=1):
    """Equal rows of pixels of three bytes."""
    def chunk(name, content):
        return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", len(pixels), height, 8, 2, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress((b"\0" + b"".join(map(bytes, pixels))) * height)) + chunk(b"IEND", b""))


# For every thing: a text of the model, and the text that replaces it.
CHANGES = {
    "masses and inertias": ('<mass value="2"/>', '<mass value="3"/>'),
    "masses of moving links that have none": ('<link name="finger"/>', '<link name="finger">'
                                              + BODY.format(m="1") + "</link>"),
    "moments of inertia that are not written": ('<sphere radius="0.125"/>', '<sphere radius="0.25"/>'),
    "moments of inertia of 0 and placeholders": ('<sphere radius="0.375"/>', '<sphere radius="0.5"/>'),
    "inertias that simulators refuse": ("0.000201", "0.0002"),
    "visual shapes": ('<visual name="hull"><geometry><box size="1 2 3"/>',
                      '<visual name="hull"><geometry><box size="1 2 4"/>'),
    "collision shapes": ('<collision name="bumper"><geometry><box size="1 2 3"/>',
                         '<collision name="bumper"><geometry><box size="1 2 4"/>'),
    "concave meshes of collisions": ("fork.obj", "two.obj"),
    "shapes with a size of 0": ('<sphere radius="0"/>', '<sphere radius="1"/>'),
    "names of visuals and collisions": ('<visual name="hull">', '<visual name="shell">'),
    "colours": ('rgba="0 0 1 1"', 'rgba="0 1 1 1"'),
    "colours of parts of mesh files": ("usemtl green", "usemtl red"),
    "textures": ('<texture filename="skin.png"/>', ""),
    "movable joints": ('name="hinge" type="continuous"', 'name="hinge" type="fixed"'),
    "joints that close a loop": ('<joint name="loop".*?</joint>', ""),
    "joints and links that the root does not reach": ('<link name="island"/>', ""),
    "mimicking joints": ('<mimic joint="shoulder" multiplier="0.5"/>', ""),
    "position limits": ('upper="2"', 'upper="1.5"'),
    "effort limits": ('effort="6"', ""),
    "velocity limits": ('velocity="4"', ""),
    "soft limits and safety controllers":
        ('<safety_controller soft_lower_limit="-0.5" k_velocity="7"/>', ""),
    "calibrations of joints": ('<calibration rising="0.5"/>', ""),
    "limits of acceleration and jerk": (' acceleration="9"', ""),
    "damping and friction of joints": ('damping="0.25"', 'damping="0.5"'),
    "reserved names of links and joints": ('name="glue::d"', 'name="glued"'),
    "collisions within a robot": ('<collision name="bumper"><geometry><box size="1 2 3"/>',
                                  '<collision name="bumper"><geometry><box size="1 2 4"/>'),
    "pairs of links that cannot touch": ('<disable_collisions link1="ball" link2="dot" reason="Never"/>', ""),
    "gains of motors": ("joint: shoulder, type: PID", "joint: shoulder, type: direct_effort"),
    "transmissions": ("<transmission.*</transmission>", ""),
    "elements of ros2_control": ("<ros2_control.*</ros2_control>", ""),
    "elements in <gazebo>": ('<plugin name="brain" filename="libbrain.so"/>', ""),
    "collisions of contact sensors on several links":
        ("<collision>base_fixed_joint_lump__pad_collision_2</collision>", ""),
    "systems of Gazebo for sensors": ('type="camera"', 'type="sonar"'),
    "elements that URDF does not define": ('<contact><lateral_friction value="0.4"/></contact>', ""),
    "attributes that URDF does not define": (' group="2"', ""),
    "motor": ("- {name: shoulder_motor.*?}\n", ""),
    "motor setting": (", filterValue: 0.5", ""),
    "sensor": ("- {name: imu.*?}\n", "[]\n"),
    "sensor setting": (", cutoff: 3", ""),
    "controller": ("controllers:\n.*?}\n", ""),
    "material": ("materials:\n.*?}}\n", ""),
    "material setting": (" shininess: 2,", ""),
    "collision setting": (", cerp: 0.3", ""),
    "joint setting": ("joint:\n- {name: shoulder, springDamping: 3}\n", ""),
    "joint task": ("joint_tasks:\n.*?}\n", ""),
    "link setting": ("link:\n- {name: arm, density: 3}\n", ""),
    "visual setting": ("visuals:\n.*?}\n", ""),
    "node": ("nodes:\n.*?}\n", ""),
    "light": ("lights:\n- {name: lamp, nodeName: arm}\n", ""),
    "graphics section": ("graphics: .*?}}\n", ""),
    "joint pose set": ("- {name: straight.*?}}\n", ""),
    "submechanism": ("submechanisms:\n.*?}\n", ""),
    "exoskeleton": ("exoskeletons:\n.*?}\n", ""),
    "interface": ("interfaces:\n.*?}\n", ""),
    "submodel": ("submodels:\n.*?}\n", ""),
    "other section": ("own_section:\n.*?}\n", ""),
    "gravity": ("gravity: {x: 0, y: 0, z: -3}, ", ""),
    "step size": ("stepsize: 2, ", ""),
    "solver settings": ("cfm: 1.0e-8, ", ""),
    "environment": ("environment: {fog: {density: 0.5}}\n", ""),
    "plug-ins of MARS": ("plugins: [libmars_gui]\n", ""),
    "lights": ("- {name: lamp, type: 1.*?}}\n", "[]\n"),
    "ambient colours of lights": (", ambient: {r: 1, g: 0, b: 0, a: 1}", ""),
    "attenuations and specular colours of lights": (", linearAttenuation: 0.25", ""),
    "heightmaps in colour or out of reach": ("file: hill.png", "file: grey.png"),
    "heightmaps that are not square": ("file: hill.png", "file: square.png"),
    "robots that move freely": (", anchor: none", ", anchor: world"),
    "entities of other types": ("- {name: Cloud.*?}\n", ""),
    "names of entities": ("name: Free Änd easy", "name: Free_and_easy"),
    "anchors": (", anchor: world", ""),
    "roots named `world` without an anchor": ('<robot name="free"><link name="world"/>',
                                              '<robot name="free"><link name="root"/>'),
    "start positions": (", pose: bent", ""),
    "keys of primitives": (", colour: blue", ""),
}
CHANGES["gains of controllers"] = CHANGES["gains of motors"]
CHANGES["gravity when none is set"] = CHANGES["gravity"]
CHANGES["step size when none is set"] = CHANGES["step size"]
# Things that only some formats keep, beside the entry that contains them.
PARTS = {
    "bitmask of a collision": ("bitmask: 6", "bitmask: 4", ("sdf", "mjcf")),
    "friction of a collision": ("cfriction1: 0.5", "cfriction1: 0.25", ("sdf", "mjcf", "usda")),
    "bitmask of a primitive": ("bitmask: 2", "bitmask: 4", ("sdf", "mjcf")),
    "friction of a primitive": ("cfriction2: 0.25", "cfriction2: 0.5", ("sdf",)),
    "bitmask of a primitive without a place": (" bitmask: 2,", "", ("sdf1.6", "urdf", "gltf", "usda")),
    "friction of a primitive without a place": ("cfriction2: 0.25, ", "", ("sdf1.6", "mjcf", "urdf", "gltf", "usda")),
    "name of a collision": (' name="shield"', "", ("sdf", "sdf1.6", "mjcf", "urdf", "usda")),
    "gain of a motor": ("p: 20", "p: 10", ("mjcf", "usda")),
    "reduction of a transmission": ("<mechanicalReduction>50</mechanicalReduction>", "", ("mjcf", "usda")),
    "contact of a link without collisions": ("<kp>7</kp>", "", ("sdf", "sdf1.6", "mjcf", "usda")),
    "motor of a joint that mimics": ("- {name: wrist_motor.*?}\n", "", ("sdf", "mjcf", "usda")),
    "interface of ros2_control": ('<state_interface name="position"/>', "", ("mjcf", "usda")),
}
# Words of warnings that do not begin with the name of the row.
OWN_WORDS = {"textures in mjcf": "the texture `skin.png`, whose content is not PNG,",
             "mimicking joints": "the joint `wrist` is free to move, since ",
             "gravity": "the gravity is not in", "step size": "the step size is not in",
             "solver settings": "the constraint force mixing is not in", "lights": "the light is not in",
             "plug-ins of MARS": "the list of plug-ins is not in", "environment": "the environment is not in",
             "entities of other types": "`Cloud` is not in"}
# The rich scene has none of the materials, names, sensors and loops that are lost where others are kept.
UNNAMED = {("partly", thing) for thing in ("material", "visual setting", "sensor", "joints that close a loop")}
UNNAMED |= {("changed: USD computes moments of inertia of 0 from shapes", "inertias that simulators refuse")}
# The scene has no controllers; joint_controllers_test has.
UNNAMED |= {("added", "gains of controllers")}
# Previews show where things are at the start, and do not list what changes nothing of that.
UNNAMED |= {("shapes only", thing) for thing in ("names of visuals and collisions", "mimicking joints", "position limits",
                                                  "anchors", "gravity", "step size", "solver settings")}
# A format that keeps everything else does not report these.
ASIDES = {"masses of moving links that have none", "moments of inertia that are not written", "inertias that simulators refuse", "motor setting",
          "sensor setting", "material setting", "gravity when none is set", "step size when none is set",
          "ambient colours of lights", "attenuations and specular colours of lights", "keys of primitives",
          "roots named `world` without an anchor", "colours of parts of mesh files", "collisions within a robot", "pairs of links that cannot touch",
          "reserved names of links and joints",
          "gains of motors", "gains of controllers", "collisions of contact sensors on several links", "systems of Gazebo for sensors",
          "names of entities", "heightmaps in colour or out of reach", "moments of inertia of 0 and placeholders",
          "heightmaps that are not square", "robots that move freely"}
OF_URDF = set(list(CHANGES)[:list(CHANGES).index("motor")])


def is_told(thing, form, cell):
    """Previews report the kinds of things that they do not have, and directives name the URDF."""
    if cell == "shapes only" or (form == "dmd" and thing in OF_URDF):
        return False
    if thing == "collision setting" and cell == "lost":
        return False  # the entry is reported, with all of its keys
    return not (cell == "kept" and thing in ASIDES)


def table():
    """The cells of each row of the page, one for each format."""
    page = (cli.ROOT / "docs/scene-formats.md").read_text()
    return {cells[1].strip(): [cell.strip() for cell in cells[2:-1]]
            for cells in (line.split("|") for line in page.splitlines() if line.startswith("| "))}


def must_be_named(thing, cell):
    return not cell.startswith("kept") and (cell, thing) not in UNNAMED and (cell.split(":")[0], thing) not in UNNAMED


def is_named(thing, form, messages):
    words = OWN_WORDS.get(f"{thing} in {form}", OWN_WORDS.get(thing, f"{thing} ("))
    patterns = [re.escape(words), rf".* are not in .*\b\d+ {thing}s?(,|$)", rf".* does not have: .*\b{re.escape(thing)}(,|$)"]
    return any(re.match(pattern, message, re.DOTALL | re.MULTILINE) for pattern in patterns for message in messages)


class KeptTest(cli.CliTest):
    def written(self, texts, forms=FORMATS):
        for name, text in texts.items():
            self.write(name, text)
        self.write("hill.png", png((0, 0, 0), (9, 0, 90)))
        self.write("grey.png", png((0, 0, 0), (9, 9, 9)))
        self.write("square.png", png((0, 0, 0), (9, 0, 90), (9, 9, 9), height=3))
        results = {}
        for form in forms:
            (self.folder / "out").unlink(missing_ok=True)
            done = self.run_tool("rich.smurfs", "--format", form, "-o", "out", "--force",
                                 "--report", "json=r.json")
            if "this build has no viewer" in done.stderr:
                continue
            self.assertEqual(done.returncode, 0, done.stderr)
            losses = [(d["id"], "\n".join([d["message"], *d.get("notes", [])]))
                      for d in json.loads(self.read("r.json"))["diagnostics"] if d["id"].startswith("SML82")]
            results[form] = ((self.folder / "out").read_bytes(), losses)
        return results

    @staticmethod
    def texts():
        return {"rich.urdf": URDF, "rich_all.yml": ANNOTATIONS, "rich.smurfs": SCENE,
                "rich.srdf": '<robot name="rich"><disable_collisions link1="ball" link2="dot" reason="Never"/></robot>',
                "free.urdf": '<robot name="free"><link name="world"/></robot>',
                "two.obj": TWO, "fork.obj": FORK, "two.mtl": "newmtl red\nKd 1 0 0\nnewmtl green\nKd 0 1 0\n",
                "rich.smurf": "modelname: rich\nfiles: [rich.urdf, rich_all.yml]\n"}

    def test_nothing_is_lost_without_a_word(self):
        self.write("skin.png", b"")
        before = self.written(self.texts())
        rows = table()
        self.assertEqual(set(CHANGES), {row for row in rows if row})
        for thing, (old, new) in CHANGES.items():
            forms = [form for form, cell in zip(FORMATS, rows[thing]) if is_told(thing, form, cell)]
            self.assert_seen(thing, old, new, forms, before)
        for thing, (old, new, forms) in PARTS.items():
            self.assert_seen(thing, old, new, forms, before)

    def test_what_is_not_kept_is_named(self):
        """A start position changes poses in the SDF; that the zero of the joint moved must be said."""
        self.write("skin.png", b"")
        rich = self.written(self.texts())
        texts = self.texts()
        for part in (CHANGES["gravity"][0], CHANGES["step size"][0]):
            texts["rich.smurfs"] = texts["rich.smurfs"].replace(part, "")
        unset = self.written(texts)
        for thing in CHANGES:
            results = unset if thing.endswith("when none is set") else rich
            for form, cell in zip(FORMATS, table()[thing]):
                if form not in results or not must_be_named(thing, cell):
                    continue
                messages = [message for _, message in results[form][1]]
                with self.subTest(thing, form=form):
                    self.assertTrue(is_named(thing, form, messages), messages)

    def assert_seen(self, thing, old, new, forms, before):
        pattern = old if "*" in old else re.escape(old)
        texts = {name: re.sub(pattern, lambda _: new, text, count=1, flags=re.DOTALL)
                 for name, text in self.texts().items()}
        with self.subTest(thing):
            self.assertNotEqual(texts, self.texts(), "the change changes nothing")
            after = self.written(texts, forms)
            silent = [form for form in after if after[form] == before[form]]
            self.assertEqual(silent, [])


if __name__ == "__main__":
    cli.main()
