# SPDX-License-Identifier: BSD-3-Clause
"""What conversions once did wrong silently: each case is kept, or named.

Usage: conversions_test.py BIN
"""
import json
import pathlib
import re
import sys
import unittest

import cli

INERTIAL = ('<inertial><mass value="1"/><inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/>'
            "</inertial>")
TWO_LINKS = ('<robot name="r"{version}><link name="base">' + INERTIAL + '{base}</link><link name="arm">' + INERTIAL
             + '{arm}</link><joint name="j" type="{type}"><parent link="base"/><child link="arm"/><axis xyz="0 0 1"/>'
             '<limit lower="-1" upper="2" effort="5" velocity="3"/>{joint}</joint>{more}</robot>\n')
TETRAHEDRON = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
FACES = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"
MESH = '<visual><geometry><mesh filename="{}"/></geometry>{}</visual>'


def robot(base="", arm="", joint="", more="", version="", type_="revolute"):
    return (TWO_LINKS.replace("{base}", base).replace("{arm}", arm).replace("{joint}", joint).replace("{more}", more)
            .replace("{version}", version).replace("{type}", type_))


class ConversionTest(cli.CliTest):
    def convert(self, tool, *arguments, code=0):
        cli.TOOL = str(BIN / tool)
        done = self.run_tool(*arguments)
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stderr + done.stdout

    def flatten(self, source, form, *arguments, **keywords):
        """What the tool says; the result is in self.result."""
        said = self.convert("smurfs-flatten", source, "--format", form, "-o", "out." + form, *arguments, **keywords)
        path = self.folder / ("out." + form)
        self.result = path.read_text() if path.exists() else ""
        return said


class Drives(ConversionTest):
    def interfaces(self, *names, actuator=""):
        joint = "".join(f"<hardwareInterface>hardware_interface/{name}</hardwareInterface>" for name in names)
        return ("<transmission name=\"t\"><type>transmission_interface/SimpleTransmission</type><joint name=\"j\">"
                + joint + '</joint><actuator name="m">' + actuator + "</actuator></transmission>")

    def test_a_transmission_that_also_observes(self):
        for names, motor, actuator in (
                (["JointStateInterface", "PositionJointInterface"], "PID", "<general"),
                (["PositionJointInterface", "JointStateInterface"], "PID", "<general"),
                (["JointStateInterface", "EffortJointInterface"], "direct_effort", "<motor"),
                ([], "PID", "<general"), (["JointStateInterface"], None, None)):
            self.write("r.urdf", robot(more=self.interfaces(*names)))
            self.flatten("r.urdf", "mjcf")
            self.assertEqual(actuator is not None and actuator in self.result, actuator is not None, names)
            self.assertEqual("<actuator>" in self.result, actuator is not None, names)
            self.flatten("r.urdf", "usda")
            self.assertEqual("smurf:motor" in self.result, motor is not None, names)
            self.convert("urdf2smurf", "r.urdf", "-o", "m", "--overwrite")
            files = list((self.folder / "m").rglob("*motors.yml"))
            self.assertEqual([re.search("type: (.*)", file.read_text())[1] for file in files], [motor] if motor else [])
            for file in (self.folder / "m").rglob("*.*"):
                file.unlink()

    def test_the_interface_may_be_that_of_the_actuator(self):
        actuator = "<hardwareInterface>hardware_interface/VelocityJointInterface</hardwareInterface>"
        self.write("r.urdf", robot(more=self.interfaces("JointStateInterface", actuator=actuator)))
        self.flatten("r.urdf", "mjcf")
        self.assertIn('gainprm="16.666666666666668" biasprm="0 0 -16.666666666666668"', self.result)

    def test_chosen_gains_are_named(self):
        self.write("r.urdf", robot(more=self.interfaces("PositionJointInterface")))
        for form in ("mjcf", "usda"):
            self.assertIn("gains of motors (`j`)", self.flatten("r.urdf", form))
        self.write("r.urdf", robot(more=self.interfaces("EffortJointInterface")))
        self.assertNotIn("gains of motors", self.flatten("r.urdf", "mjcf"))

    def test_effort_limits_of_joints_without_a_motor(self):
        self.write("r.urdf", robot())
        self.assertIn("`urdf2smurf --motors all` adds motors", self.flatten("r.urdf", "mjcf"))

    def test_a_command_that_is_not_the_first(self):
        self.write("r.urdf", robot(more='<ros2_control name="c" type="system"><joint name="j"><command_interface '
                                        'name="gpio"/><command_interface name="effort"/><command_interface name="position">'
                                        '<param name="max">1.5</param><param name="min">-0.5</param></command_interface>'
                                        "</joint></ros2_control>"))
        said = self.flatten("r.urdf", "mjcf")
        self.assertIn('ctrlrange="-0.5 1.5"', self.result)
        self.assertIn("elements of ros2_control (`command_interface of c`)", said)
        self.assertNotIn("param of c", said)

    def test_no_torque_sensors_for_phobos(self):
        self.write("r.urdf", robot(more='<ros2_control name="c" type="system"><joint name="j"><command_interface '
                                        'name="position"/><state_interface name="position"/><state_interface name="effort"/>'
                                        "</joint></ros2_control>"))
        said = self.convert("urdf2smurf", "r.urdf", "-o", "m", "--style", "phobos")
        self.assertIn("the effort of the joint `j` cannot become an entry of a section", said)
        sensors = next((self.folder / "m").rglob("*sensors.yml")).read_text()
        self.assertIn("JointPosition", sensors)
        self.assertNotIn("JointTorque", sensors)
        self.convert("urdf2smurf", "r.urdf", "-o", "n", "--style", "mars")
        self.assertIn("JointTorque", next((self.folder / "n").rglob("*sensors.yml")).read_text())


class Lights(ConversionTest):
    def test_a_wrong_type_says_nothing_about_poses(self):
        self.write("s.smurfs", "lights: [{name: l, type: 0, position: {x: 0, y: 0, z: 3}}]\nentities: []\n")
        for form in ("mjcf", "sdf", "usda", "gltf", "json"):
            said = self.flatten("s.smurfs", form)
            self.assertIn("error[SML4003]", said)
            self.assertNotIn("poses are unknown", said)
            self.assertTrue(self.result)
        self.flatten("s.smurfs", "mjcf")
        self.assertIn('<light name="l"', self.result)

    def test_other_settings(self):
        for setting in ("physics: {gravity: {x: 0, y: 0, z: down}}", "environment: [fog]", "plugins: 7"):
            self.write("s.smurfs", setting + "\nentities: []\n")
            self.flatten("s.smurfs", "json", "--force")
        self.write("s.smurfs", "entities: [{name: a, type: primitive, geometry: {type: box}, position: here}]\n")
        self.assertIn("some poses are unknown", self.flatten("s.smurfs", "json", "--force", code=1))


class Directives(ConversionTest):
    def test_followers_start_where_they_follow(self):
        self.write("r.urdf", robot(more='<link name="tip">' + INERTIAL + '</link><joint name="k" type="revolute"><parent '
                                        'link="arm"/><child link="tip"/><axis xyz="0 0 1"/><limit lower="-9" upper="9" '
                                        'effort="1" velocity="1"/><mimic joint="j" multiplier="-2" offset="0.25"/></joint>'))
        self.write("r.smurf", "modelname: r\nfiles: [r.urdf, r_poses.yml]\n")
        self.write("r_poses.yml", "poses:\n- {name: bent, joints: {j: 0.5}}\n")
        self.write("s.smurfs", "entities:\n- {name: A, file: r.smurf, pose: bent}\n- {name: B, file: r.smurf}\n")
        self.flatten("s.smurfs", "dmd")
        self.assertEqual(re.findall('"([jk])": (.*)', self.result), [("j", "[0.5]"), ("k", "[-0.75]"), ("k", "[0.25]")])


class Capsules(ConversionTest):
    CAPSULE = ('<collision name="c"><origin xyz="0 0 1"/><geometry><capsule radius="0.1" length="0.4"/></geometry>'
               '</collision><visual><geometry><capsule radius="0.1" length="0.4"/></geometry><material name="m">'
               '<color rgba="1 0 0 1"/></material></visual>')

    def test_urdf_1_0_has_none(self):
        self.write("r.urdf", robot(base=self.CAPSULE))
        self.flatten("r.urdf", "urdf", "--fail-on-loss", "--force")
        self.assertNotIn("capsule", self.result)
        self.assertEqual(self.result.count('<cylinder radius="0.1" length="0.4"/>'), 2)
        self.assertEqual(self.result.count('<sphere radius="0.1"/>'), 4)
        for z in ("1.2", "0.8"):
            self.assertIn(f'<origin xyz="0 0 {z}"', self.result)
        self.assertEqual(self.result.count('<color rgba="1 0 0 1"/>'), 3)

    def test_urdf_1_1_keeps_them(self):
        self.write("r.urdf", robot(base=self.CAPSULE, version=' version="1.1"'))
        self.flatten("r.urdf", "urdf", "--force")
        self.assertEqual(self.result.count("<capsule"), 2)


class Names(ConversionTest):
    def test_changed_names_are_named(self):
        self.write("r.urdf", robot())
        self.write("s.smurfs", "entities:\n" + "".join(f"- {{name: \"{name}\", file: r.urdf}}\n" for name in (
            "Kran Ä ß", "a b", "left/right", "plain_1", "__world__", "true")))
        for form, changed in (("sdf", 5), ("sdf1.6", 5), ("urdf", 3), ("dmd", 3)):
            said = self.flatten("s.smurfs", form)
            names = re.search(r"names of entities \((.*?)\)", said)[1]
            self.assertEqual(names.count(" as "), changed, names)
            self.assertNotIn("plain_1", names)
        for form in ("mjcf", "usda", "gltf"):
            self.assertNotIn("names of entities", self.flatten("s.smurfs", form))
        self.flatten("s.smurfs", "sdf")
        self.assertIn('<model name="__world___0">', self.result)

    def test_nested_scenes_are_no_change(self):
        self.write("r.urdf", robot())
        self.write("in.smurfs", "entities: [{name: R, file: r.urdf}]\n")
        self.write("s.smurfs", "entities: [{name: Cell, type: smurfs, file: in.smurfs}]\n")
        self.assertNotIn("names of entities", self.flatten("s.smurfs", "sdf"))

    def test_plugins_of_a_scene_are_named(self):
        self.write("s.smurfs", "plugins: [libgui]\nentities: []\n")
        for form in ("sdf", "mjcf", "urdf", "usda", "gltf", "dmd"):
            self.assertIn("the list of plug-ins is not in", self.flatten("s.smurfs", form))
            self.flatten("s.smurfs", form, "--fail-on-loss", code=1)


class Gazebo(ConversionTest):
    def test_plugins_without_a_file(self):
        plugin = '<plugin name="p"/>'
        for more, name in ((f"<gazebo>{plugin}</gazebo>", "p"),
                           (f'<gazebo reference="arm">{plugin}</gazebo>', "p"),
                           (f'<gazebo reference="arm"><sensor name="s" type="imu">{plugin}</sensor></gazebo>', "p")):
            self.write("r.urdf", robot(more=more))
            said = self.flatten("r.urdf", "sdf", "--force")
            self.assertIn(f"elements in <gazebo> (`{name}`) are not in the SDF", said)
            self.assertNotIn('name="p"', self.result)

    def test_systems_for_sensors(self):
        sensor = '<gazebo reference="arm"><sensor name="s{n}" type="{type}"/></gazebo>'
        self.write("r.urdf", robot(more=sensor.format(n=1, type="imu") + sensor.format(n=2, type="camera")))
        said = self.flatten("r.urdf", "sdf")
        self.assertIn("systems of Gazebo for sensors", said)
        self.assertEqual(re.findall('filename="gz-sim-(.*?)-system"', self.result),
                         ["physics", "user-commands", "scene-broadcaster", "sensors", "imu"])
        self.flatten("r.urdf", "sdf1.6")
        self.assertNotIn("<plugin", self.result)
        self.write("r.urdf", robot())
        self.assertNotIn("systems", self.flatten("r.urdf", "sdf"))
        self.assertNotIn("<plugin", self.result)


class Materials(ConversionTest):
    COLORS = ["0.8 0.1 0.1 1", "0.1 0.1 0.8 1", "0.1 0.8 0.1 1"]

    def colored(self, name=""):
        return [f'<visual><geometry><box size="1 1 1"/></geometry><material name="{name}"><color rgba="{color}"/>'
                "</material></visual>" for color in self.COLORS]

    def test_materials_without_a_name_keep_their_colours(self):
        first, second, third = self.colored()
        self.write("r.urdf", robot(base=first + second, arm=third))
        self.convert("urdf2smurf", "r.urdf", "-o", "m")
        self.assertEqual(list((self.folder / "m").rglob("*materials*")), [])
        model = next((self.folder / "m").rglob("*.smurf"))
        for preset in ("gazebo", "mujoco", "drake", "pybullet", "ros2"):
            self.convert("smurf2urdf", model, "-o", "out.urdf", "--preset", preset, "--prove")
            self.assertEqual(re.findall('rgba="(.*?)"', self.read("out.urdf")), self.COLORS, preset)

    def test_models_of_older_versions(self):
        """They have a material with an empty name."""
        first, second, third = self.colored()
        self.write("r.urdf", robot(base=first + second, arm=third))
        self.write("r.smurf", "modelname: r\nfiles: [r.urdf, r_materials.yml]\n")
        self.write("r_materials.yml", "materials:\n- {name: '', diffuseColor: {r: 0.8, g: 0.1, b: 0.1, a: 1}}\n")
        self.convert("smurf2urdf", "r.smurf", "-o", "out.urdf", "--apply", "all", "--prove")
        self.assertEqual(re.findall('rgba="(.*?)"', self.read("out.urdf")), self.COLORS)
        self.flatten("r.smurf", "mjcf")
        self.assertEqual([tuple(map(float, c.split())) for c in re.findall('class="visual".*rgba="(.*?)"', self.result)],
                         [tuple(map(float, c.split())) for c in self.COLORS])


class Meshes(ConversionTest):
    RED, GLASS = [1, 0, 0, 1], [0, 0, 1, 0.25]
    LIBRARY = "newmtl red\nKd 1 0 0\nnewmtl glass\nKd 0 0 1\nd 0.25\n"

    def mesh(self, text, material="", library=LIBRARY):
        self.write("m.obj", text)
        self.write("m.mtl", library)
        self.write("r.urdf", '<robot name="r"><link name="l">' + INERTIAL + MESH.format("m.obj", material)
                   + "</link></robot>")

    def two(self):
        """Two tetrahedra in two colours."""
        return ("mtllib m.mtl\n" + TETRAHEDRON + "usemtl red\n" + FACES + TETRAHEDRON.replace("v ", "v 2") + "usemtl glass\n"
                + FACES.translate(str.maketrans("1234", "5678")))

    def gltf_colors(self):
        return [m["pbrMetallicRoughness"]["baseColorFactor"] for m in json.loads(self.result)["materials"]]

    def mjcf_colors(self):
        return [list(map(float, color.split())) for color in re.findall('class="visual".* rgba="(.*?)"', self.result)]

    def test_colours_of_an_obj(self):
        for text, colors in ((self.two(), [self.RED, self.GLASS]),
                             ("mtllib m.mtl\n" + TETRAHEDRON + "usemtl glass\n" + FACES, [self.GLASS])):
            self.mesh(text)
            self.assertNotIn("SML8211", self.flatten("r.urdf", "gltf"))
            self.assertEqual(self.gltf_colors(), colors)
            self.assertNotIn("SML8211", self.flatten("r.urdf", "mjcf"))
            self.assertEqual(self.mjcf_colors(), colors)
            self.flatten("r.urdf", "usda")
            shown = "[" + ", ".join(f"({c[0]}, {c[1]}, {c[2]})" for c in colors) + "]"
            self.assertIn(f"primvars:displayColor = {shown}", self.result)
            self.assertIn("primvars:displayOpacity = [" + ", ".join(f"{c[3]:g}" for c in colors) + "]", self.result)
            self.flatten("r.urdf", "obj")
            self.assertEqual(len(set(re.findall(r"^v \S+ \S+ \S+ (.*)$", self.result, re.M))), len(colors))

    def test_the_material_of_the_urdf_comes_first(self):
        self.mesh(self.two(), '<material name="g"><color rgba="0 1 0 1"/></material>')
        self.flatten("r.urdf", "gltf")
        self.assertEqual(self.gltf_colors(), [[0, 1, 0, 1]])
        self.flatten("r.urdf", "mjcf")
        self.assertEqual(self.mjcf_colors(), [[0, 1, 0, 1]])

    def test_a_flat_part_in_mjcf_is_named(self):
        self.mesh("mtllib m.mtl\n" + TETRAHEDRON + "usemtl red\n" + FACES + "usemtl glass\nf 1 2 3\n")
        self.assertIn("colours of parts of mesh files (`m.obj`)", self.flatten("r.urdf", "mjcf"))
        self.assertEqual(len(self.mjcf_colors()), 1)

    def test_textures_of_mesh_files_are_named(self):
        self.mesh("mtllib m.mtl\nvt 0 0\n" + TETRAHEDRON + "usemtl red\n" + FACES, library="newmtl red\nmap_Kd wood.png\n")
        for form in ("gltf", "usda", "mjcf"):
            self.assertIn("textures (`m.obj`)", self.flatten("r.urdf", form))
            self.flatten("r.urdf", form, "--fail-on-loss", code=1)
        self.mesh("mtllib m.mtl\n" + TETRAHEDRON + "usemtl red\n" + FACES)
        for form in ("gltf", "usda", "mjcf"):
            self.assertNotIn("textures (", self.flatten("r.urdf", form))


class Usd(ConversionTest):
    def test_friction_and_own_collisions(self):
        box = '<collision><geometry><box size="1 1 1"/></geometry></collision>'
        self.write("r.urdf", robot(base=box, arm=box, joint='<dynamics friction="0.5"/>'))
        said = self.flatten("r.urdf", "usda")
        self.assertIn("float physxJoint:jointFriction = 0.5", self.result)
        self.assertIn("bool physxArticulation:enabledSelfCollisions = 0", self.result)
        self.assertIn("PhysxArticulationAPI", self.result)
        self.assertIn("collisions within a robot", said)
        self.assertNotIn("friction of joints", said)
        self.write("r.urdf", robot(base=box))
        self.assertNotIn("collisions within a robot", self.flatten("r.urdf", "usda"))

    def follower(self, leader, multiplier=2):
        self.write("r.urdf", robot(type_=leader, more='<link name="tip">' + INERTIAL + '</link><joint name="k" '
                                   'type="continuous"><parent link="arm"/><child link="tip"/><axis xyz="0 0 1"/>'
                                   f'<mimic joint="j" multiplier="{multiplier}" offset="0.5"/></joint>'))
        return self.flatten("r.urdf", "usda")

    def test_followers_without_limits(self):
        for multiplier, low, high in ((2, -1.5, 4.5), (-2, -3.5, 2.5)):
            self.follower("revolute", multiplier)
            joint = self.result[self.result.index('"k"'):]
            for key, value in (("lowerLimit", low), ("upperLimit", high)):
                found = float(re.search(f"physics:{key} = (.*)", joint)[1])
                self.assertAlmostEqual(found * 3.141592653589793 / 180, value, delta=1e-9)
        self.assertIn("the joint `k` is free to move, since PhysX needs limits of the follower or of its leader",
                      self.follower("continuous"))
        self.assertNotIn("PhysxMimicJointAPI", self.result)


if __name__ == "__main__":
    BIN = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main(module="__main__")
