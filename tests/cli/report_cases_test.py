# SPDX-License-Identifier: BSD-3-Clause
"""Robots as users reported them: the verdict of a reader, and what is said.

Usage: report_cases_test.py SMURF-LINT
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

LINT = ""
INERTIAL = '<inertial><mass value="1"/><inertia ixx="0.006" iyy="0.006" izz="0.006" ixy="0" ixz="0" iyz="0"/></inertial>'
MASSLESS = '<inertial><mass value="0"/><inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial>'
TETRAHEDRON = "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"
PACKAGE = "<package><name>mini_description</name></package>"


def link(name, parts=INERTIAL):
    return f'<link name="{name}">{parts}</link>'


def fixed(name, parent, child):
    return f'<joint name="{name}" type="fixed"><parent link="{parent}"/><child link="{child}"/></joint>'


def moving(name, parent, child, more=""):
    return (f'<joint name="{name}" type="revolute"><parent link="{parent}"/><child link="{child}"/><axis xyz="0 0 1"/>'
            f'<limit lower="-1" upper="1" effort="1" velocity="1"/>{more}</joint>')


def robot(*parts, begin=""):
    return begin + '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">\n' + "\n".join(parts) + "\n</robot>\n"


def collision(mesh):
    return INERTIAL + f'<collision><geometry><mesh filename="{mesh}"/></geometry></collision>'


ARM = link("base") + link("arm") + moving("shoulder", "base", "arm")
LASER = ARM + link("laser") + fixed("mount", "base", "laser")


class CasesTest(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="smurf-reports-")
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def lint(self, text, target="ros,gazebo,mujoco,dart", *options, files=(), name="r.urdf", folder="."):
        for path, content in [(name, text), *files]:
            place = self.folder / path
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_text(content, encoding="utf-8")
        targets = ["--target", target] if target else []
        done = subprocess.run([LINT, *targets, "--format", "json", *options, os.path.relpath(name, folder)],
                              cwd=self.folder / folder, timeout=600, capture_output=True, encoding="utf-8", check=False)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        return json.loads(done.stdout)

    def check(self, text, target, verdict, rule="", says="", **more):
        """The verdict of a reader, and a finding of this rule with these words."""
        report = self.lint(text, target, *more.pop("options", ()), **more)
        self.assertEqual(report["targets"][target]["verdict"], verdict, report["diagnostics"])
        found = [one for one in report["diagnostics"] if one["id"] == rule]
        self.assertEqual(bool(found), bool(rule), report["diagnostics"])
        if says:
            self.assertIn(says, json.dumps(found, ensure_ascii=False))

    def rules(self, text, target="", **more):
        return {one["id"]: one["severity"] for one in self.lint(text, target, **more)["diagnostics"]}

    def test_limbs_below_massless_mounts(self):
        mount = link("base") + link("mount", "") + link("arm") + fixed("f", "base", "mount") + moving("j", "mount", "arm")
        self.check(robot(mount), "gazebo:fortress", "loses", "SML1453", "1 link and 1 joint less")
        self.check(robot(mount), "gazebo:harmonic", "takes")
        self.check(robot(mount.replace("<link name=\"mount\"></link>", link("mount", MASSLESS))), "gazebo:fortress",
                   "loses", "SML1453")
        leaf = ARM + link("eye", "") + fixed("f", "arm", "eye")
        self.check(robot(leaf), "gazebo:fortress", "takes")

    def test_limbs_below_unread_masses(self):
        """urdfdom reads no number with white space behind it, so the link has no mass for Gazebo."""
        legs = link("base") + link("knee") + link("foot") + moving("j", "base", "knee") + moving("k", "knee", "foot")
        for part, lost in (('"1"', '"1 "'), ("<mass", '<origin xyz="0 0\n0"/><mass')):
            text = robot(legs.replace(link("knee"), link("knee", INERTIAL.replace(part, lost))))
            self.check(text, "gazebo", "loses", "SML1453", "2 links and 2 joints less")
        spaced = link("knee", INERTIAL.replace("<mass", '<origin xyz=" 0 0  0 "/><mass'))
        self.check(robot(legs.replace(link("knee"), spaced)), "gazebo", "takes")

    def test_impossible_inertias_of_lost_limbs(self):
        """sdformat does not look at what it leaves out. Later releases do."""
        wrong = INERTIAL.replace('ixx="0.006"', 'ixx="0.6"')
        mount = link("base") + link("mount", "") + link("arm", wrong) + fixed("f", "base", "mount") + moving("j", "mount", "arm")
        self.check(robot(mount), "gazebo:fortress", "loses", "SML1453", "1 link and 1 joint less")
        self.check(robot(mount), "gazebo:harmonic", "refuses", "SML1513", "E18")

    def test_textures_do_not_hide_meshes(self):
        text = robot('<material name="m"><texture filename="file:///nowhere/t.png"/></material>',
                     link("a", INERTIAL + '<visual><geometry><mesh filename="file://meshes/a.obj"/></geometry></visual>'))
        self.check(text, "dart", "refuses", "SML1610", "finds no file")

    def test_meshes_of_mujoco_outside(self):
        text = robot('<mujoco><compiler meshdir="../../meshes"/></mujoco>', ARM.replace(link("arm"), link("arm", collision("a.obj"))))
        files = [("pkg/.git/HEAD", ""), ("pkg/urdf/a.obj", TETRAHEDRON)]
        report = self.lint(text, "mujoco", files=files, name="pkg/urdf/r.urdf", folder="pkg")
        self.assertEqual(report["targets"]["mujoco"]["verdict"], "unknown", report["diagnostics"])

    def test_formats_of_assimp(self):
        off = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"
        self.check(robot(link("a", collision("a.off"))), "dart", "takes", "SML1614", files=[("a.off", off)])
        self.check(robot(link("a", collision("a.step"))), "dart", "refuses", "SML1614", files=[("a.step", "ISO-10303-21;")])

    def test_faces_from_both_sides(self):
        """Their volumes cancel, but MuJoCo adds up the sizes."""
        both = TETRAHEDRON + "f 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n"
        text = robot(link("a", collision("a.obj").replace(".obj\"", '.obj" scale="0.5 0.5 0.5"')))
        self.assertNotIn("SML1627", self.rules(text, files=[("a.obj", both)]))
        self.assertIn("SML1627", self.rules(text.replace("0.5 0.5 0.5", "1e-5 1e-5 1e-5")))

    def test_massless_inertials_together(self):
        tip = link("base") + link("tool", "") + link("tip", MASSLESS) + fixed("f", "base", "tool") + fixed("g", "tool", "tip")
        self.check(robot(tip), "gazebo", "refuses", "SML1454", "delete the `inertial` of link `tip`")
        self.check(robot(tip.replace(link("tool", ""), link("tool"))), "gazebo", "takes")

    def test_settings_that_act_elsewhere(self):
        def gazebo(setting, reference="laser", more=""):
            return robot(LASER, f'<gazebo reference="{reference}">{setting}</gazebo>', more)
        for setting in ("<turnGravityOff>true</turnGravityOff>", "<gravity>0</gravity>", "<kinematic>1</kinematic>",
                        "<selfCollide>true</selfCollide>"):
            with self.subTest(setting):
                self.check(gazebo(setting), "gazebo", "loses", "SML1455", "link `base`")
        for text in (gazebo("<turnGravityOff>false</turnGravityOff>"), gazebo("<turnGravityOff>true</turnGravityOff>", "arm"),
                     gazebo("<turnGravityOff>true</turnGravityOff>",
                            more='<gazebo reference="mount"><preserveFixedJoint>true</preserveFixedJoint></gazebo>'),
                     gazebo("<turnGravityOff>true</turnGravityOff>", "base")):
            with self.subTest(text):
                self.assertNotIn("SML1455", self.rules(text))
        foot = robot(link("foot", ""), fixed("f", "foot", "base"), LASER,
                     '<gazebo reference="base"><turnGravityOff>true</turnGravityOff></gazebo>')
        self.assertNotIn("SML1455", self.rules(foot))  # the base is the robot

    def test_settings_that_are_dropped(self):
        lost = {"mount": ('<sensor name="s" type="gpu_lidar"/>', "<provideFeedback>1</provideFeedback>"),
                "shoulder": ('<sensor name="s" type="gpu_lidar"/>', "<mu1>1</mu1>", "<turnGravityOff>1</turnGravityOff>"),
                "arm": ("<preserveFixedJoint>1</preserveFixedJoint>", "<implicitSpringDamper>1</implicitSpringDamper>",
                        "<material><diffuse>0 0 1 1</diffuse></material>", '<material><color rgba="1 0 0 1"/></material>')}
        for reference, settings in lost.items():
            for setting in settings:
                with self.subTest(reference + setting):
                    self.check(robot(LASER, f'<gazebo reference="{reference}">{setting}</gazebo>'), "gazebo", "loses",
                               "SML1456")
        kept = {"shoulder": '<sensor name="s" type="force_torque"/>', "arm": "<material>Gazebo/Red</material>"}
        for reference, setting in kept.items():
            self.check(robot(LASER, f'<gazebo reference="{reference}">{setting}</gazebo>'), "gazebo", "takes")

    def test_parts_of_sensors(self):
        def sensor(kind, parts):
            return robot(ARM, f'<gazebo reference="arm"><sensor name="s" type="{kind}">{parts}</sensor></gazebo>')
        ray = "<ray><scan><horizontal><samples>9</samples><resolution>1</resolution><min_angle>0</min_angle><max_angle>1" \
              "</max_angle></horizontal></scan><range><min>0.1</min><max>9</max></range></ray>"
        noise = "<noise><type>gaussian</type><mean>0</mean><stddev>1</stddev></noise>"
        wrong = {("ray", ray + noise): "move it into `ray`", ("ray", "<updateRate>9</updateRate>" + ray): "update_rate",
                 ("imu", "<imu/>" + noise): "`sensor` has no `noise`",
                 ("camera", "<camera><horizontal_fov>1</horizontal_fov><horizontal_fow>1</horizontal_fow></camera>"):
                     "horizontal_fov",
                 ("ray", ray + "<range><min>1</min><max>2</max></range>"): "move it into `ray`",
                 ("camera", "<lidar/>"): "a sensor of type `camera` has no `lidar`",
                 ("ray", "<alwaysOn>1</alwaysOn>" + ray): "always_on"}
        for (kind, parts), says in wrong.items():
            with self.subTest(parts):
                self.check(sensor(kind, parts), "gazebo", "loses", "SML1458", says)
        self.check(sensor("ray", ray), "gazebo", "loses", "SML3905", "makes no sensor of type")
        self.check(sensor("gpu_ray", ray), "gazebo", "takes")
        self.check(sensor("ray", ray + '<plugin name="p" filename="p.so"><topicName>a</topicName></plugin>'), "gazebo",
                   "takes")

    def test_names_in_contact_sensors_and_plugins(self):
        pad = '<collision name="pad"><geometry><box size="0.2 0.2 0.2"/></geometry></collision>'
        def touch(name):
            return robot(link("base", INERTIAL + pad), f'<gazebo reference="base"><sensor name="s" type="contact"><contact>'
                         f"<collision>{name}</collision></contact></sensor></gazebo>")
        self.check(touch("pad"), "gazebo", "loses", "SML1457", "base_fixed_joint_lump__pad_collision")
        self.check(touch("base_fixed_joint_lump__pad_collision"), "gazebo", "takes")
        for element in ("left_joint", "jointName", "leftJoint", "joint_name", "mimicJoint"):
            self.check(robot(ARM, f'<gazebo><plugin name="p" filename="p.so"><{element}>sholder</{element}></plugin></gazebo>'),
                       "gazebo", "loses", "SML1459", "did you mean `shoulder`?")
        for inner in ("<bodyName>arm</bodyName>", "<odometry_frame>odom</odometry_frame>", "<topicName>sholder</topicName>"):
            self.check(robot(ARM, f'<gazebo><plugin name="p" filename="p.so">{inner}</plugin></gazebo>'), "gazebo", "takes")

    def test_false_alarms(self):
        empty = ('<visual><geometry><box size="1 1 1"/></geometry><material name=""><color rgba="1 1 1 1"/>'
                 '<texture filename=""/></material></visual>')
        self.assertEqual(self.rules(robot(link("a", INERTIAL + empty))).get("SML1603"), "info")
        for target in ("ros", "gazebo", "mujoco"):
            self.assertEqual(self.lint(robot(link("a", INERTIAL + empty)), target)["targets"][target]["verdict"], "takes")
        unused = robot('<xacro:property name="width" value="0.2"/>', link("a"))
        self.assertEqual(self.rules(unused), {"SML1121": "info"})
        for target in ("ros", "gazebo", "mujoco", "dart"):
            self.check(unused, target, "takes", "SML1121")
        self.assertIn("SML1009", self.rules(robot('<xacro:leg/>', link("a"))))
        same = robot(link("base"), link("mount"), fixed("mount", "base", "mount"))
        self.assertEqual(self.rules(same).get("SML1303"), "info")
        self.check(robot(link("bot/base_link")), "ros", "takes", "SML1309")
        self.check(robot(link("/base_link")), "ros", "loses", "SML1309", "strips a leading slash")

    def test_declarations(self):
        for begin in ('<?xml version="0.0" ?>\n', "<?xml ?>\n", '<?xml version="2.0"?>\n'):
            with self.subTest(begin):
                self.check(robot(link("a"), begin=begin), "ros", "takes", "SML1018", "1.0")
        self.assertEqual(self.rules(robot(link("a"), begin='<?xml version="1.1"?>\n')), {})
        for target in ("ros", "gazebo", "mujoco"):
            self.check(robot(link("a"), begin="<?xml version=1.0 ?>\n"), target, "takes", "SML1001", "no quotes")

    def test_mujoco_block(self):
        for inner in ("<actuator/>", "<default/>", "<equality/>", "<sensor/>", "<contact/>", "<worldbody/>", "<keyframe/>",
                      '<option gravty="0 0 1"/>', "<option><geom/></option>", '<option><flag contcat="disable"/></option>'):
            with self.subTest(inner):
                self.check(robot(f"<mujoco>{inner}</mujoco>", link("a")), "mujoco", "loses", "SML1449")
        self.check(robot('<mujoco><compiler fusestatic="false" meshdir="m"/><option gravity="0 0 -1"><flag gravity="enable"/>'
                         '</option><size nconmax="9"/></mujoco>', link("a")), "mujoco", "takes")

    def test_groups_of_obj_files(self):
        cap = "o cap\nv 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nf 1 3 2\no rest\nv 0 0 0.1\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"
        text = robot(link("a", collision("a.obj")))
        self.check(text, "mujoco", "refuses", "SML1652", "first group", files=[("a.obj", cap)])
        two = TETRAHEDRON + "g b\n" + TETRAHEDRON.replace("f 1 3 2\n", "f -4 -2 -3\n").split("f 1 2 4")[0]
        self.check(text, "mujoco", "loses", "SML1652", "first group", files=[("a.obj", two)])
        self.check(text, "mujoco", "takes", files=[("a.obj", "o a\n" + TETRAHEDRON)])

    def test_words_of_other_dialects(self):
        ball = '<geometry><sphere radius="0.1"/></geometry>'
        words = {"contact": link("a", INERTIAL + '<contact><lateral_friction value="1"/></contact>'),
                 "gravity": link("a", INERTIAL + "<gravity>0</gravity>"),
                 "mask": link("a", INERTIAL + f'<collision><mask value="1"/>{ball}</collision>'),
                 "max_contacts": link("a", INERTIAL + f"<collision><max_contacts>9</max_contacts>{ball}</collision>"),
                 "actuator": ARM + '<actuator name="x" joint="shoulder"/>'}
        for word, parts in words.items():
            with self.subTest(word):
                for target in ("gazebo", "mujoco"):
                    self.check(robot(parts), target, "loses", "SML1120", word)
                self.assertNotIn("SML1120", self.rules(robot(parts)))
        self.check(robot(words["contact"]), "pybullet", "takes")

    def test_packages(self):
        text = robot(link("a", collision("package://mini_descripton/meshes/a.obj")))
        files = [("pkg/package.xml", PACKAGE), ("pkg/meshes/a.obj", TETRAHEDRON)]
        self.check(text, "ros", "loses", "SML1651", "did you mean `mini_description`", files=files, name="pkg/urdf/r.urdf")
        self.assertEqual(self.rules(text, name="pkg/urdf/r.urdf").get("SML1651"), "error")
        other = text.replace("mini_descripton", "nowhere")
        self.check(other, "ros", "loses", "SML1651", "mini_description", name="pkg/urdf/r.urdf")
        right = text.replace("mini_descripton", "mini_description")
        self.check(right, "ros", "takes", name="pkg/urdf/r.urdf")
        self.check(right, "dart", "takes", name="pkg/urdf/r.urdf")

    def test_file_addresses_of_found_packages(self):
        """As `file://$(find PACKAGE)` writes them: only MuJoCo and MARS refuse them."""
        text = robot(link("a", collision("file://$(find mini_description)/meshes/a.obj")))
        files = [("pkg/package.xml", PACKAGE), ("pkg/meshes/a.obj", TETRAHEDRON)]
        name = "pkg/urdf/r.urdf.xacro"
        self.assertEqual(self.rules(text, files=files, name=name).get("SML1610"), "info")
        for reader in ("ros", "gazebo", "dart", "drake", "newton", "isaac"):
            self.check(text, reader, "takes", name=name)
        self.check(text, "mujoco", "refuses", "SML1610", "scheme", name=name)
        relative = robot(link("a", collision("file://meshes/a.obj")))
        self.assertEqual(self.rules(relative, name="pkg/r.urdf").get("SML1610"), "error")

    def test_packages_without_package_xml(self):
        files = [("go/meshes/a.obj", TETRAHEDRON), ("go/visuals/b.obj", TETRAHEDRON)]
        text = robot(link("a", collision("package://other/meshes/a.obj")))
        self.check(text, "ros", "loses", "SML1651", "--package other=DIR", files=files, name="go/urdf/r.urdf")
        case = robot(link("a", collision("package://other/meshes/A.obj")), link("b", collision("package://other/meshes/a.obj")),
                     fixed("f", "a", "b"))
        self.assertIn("SML1605", self.rules(case, name="go/urdf/r.urdf"))
        beside = case.replace("meshes/A.obj", "meshes/b.obj")
        report = self.lint(beside, "", name="go/urdf/r.urdf")
        self.assertIn("package://other/visuals/b.obj", json.dumps(report))

    def test_bullet_looks_above(self):
        text = robot(link("a", collision("../meshes/a.obj")))
        self.check(text, "pybullet", "takes", "SML1604", files=[("robots/meshes/a.obj", TETRAHEDRON)],
                   name="robots/urdf/more/r.urdf")

    def test_colours_in_rviz(self):
        def visual(name, colour):
            return (f'<visual><geometry><box size="1 1 1"/></geometry><material name="{name}"><color rgba="{colour}"/>'
                    "</material></visual>")
        red, grey = visual("red", "1 0 0 1"), visual("grey", "0.5 0.5 0.5 1")
        self.check(robot(link("a", INERTIAL + red + grey)), "ros", "loses", "SML1713", "`red`")
        self.check(robot(link("a", INERTIAL + red + red)), "ros", "takes")

    def test_a_link_in_the_wrong_case_is_missed_only_by_its_joints(self):
        lost = link("a") + '<Link name="b"/>'
        for target in ("ros", "gazebo", "dart", "mujoco"):
            self.check(robot(lost), target, "loses", "SML1114")
            self.check(robot(lost + fixed("j", "a", "b")), target, "refuses", "SML1114")
            self.check(robot('<Link name="a"/>'), "ros", "refuses", "SML1114")

    def test_wheels_of_two_kinds_have_no_odd_one(self):
        def wheels(*masses):
            return robot(link("base") + "".join(
                link(f"wheel_{i}", INERTIAL.replace('mass value="1"', f'mass value="{mass}"')) + moving(f"j{i}", "base", f"wheel_{i}")
                for i, mass in enumerate(masses)))
        self.assertIn("SML1530", self.rules(wheels(1, 1, 1, 1, 3)))
        self.assertIn("SML1530", self.rules(wheels(3, 1, 1, 1, 1)))
        self.assertNotIn("SML1530", self.rules(wheels(1, 1, 2, 2, 6)))
        self.assertNotIn("SML1530", self.rules(wheels(1, 3)))

    def test_dangling_link_is_a_missing_file(self):
        (self.folder / "a.obj").symlink_to("nowhere.obj")
        found = self.rules(robot(link("a", collision("a.obj"))))
        self.assertEqual(found.get("SML1604"), "error")


class UnseenRobots(CasesTest):
    """Kinds that 700 robots of 56 repositories showed."""

    def test_a_mesh_of_a_visual_and_a_collision_is_reported_at_the_collision(self):
        flat = TETRAHEDRON.replace("v 0 0 0.1", "v 0.1 0.1 0")
        first = "o cap\n" + flat + "o rest\n" + TETRAHEDRON.replace("f 1 3 2", "v 0 0 1\nf 5 7 6").replace("f 1 2 4", "f 5 6 8")
        shape = '<geometry><mesh filename="cap.obj"/></geometry>'
        text = robot(link("base", INERTIAL + f"<visual>{shape}</visual><collision>{shape}</collision>"))
        report = self.lint(text, "mujoco", files=[("cap.obj", first)])
        self.assertEqual(report["targets"]["mujoco"]["verdict"], "refuses")
        found = next(one for one in report["diagnostics"] if one["id"] == "SML1652")
        self.assertIn("collision", found["pointer"])

    def test_a_fault_in_an_srdf_is_none_of_readers_of_the_robot(self):
        alone = self.lint(robot(ARM), "ros,gazebo,mujoco,dart,drake,pybullet")["targets"]
        for srdf in ('<robot name="r">\n<<<<<<< HEAD\n<group name="a"/>\n=======\n>>>>>>> other\n</robot>\n', '<robot name="r"><group',
                     '<robot name="r"><drake:x/></robot>'):
            targets = self.lint(robot(ARM), "ros,gazebo,mujoco,dart,drake,pybullet,moveit", files=[("r.srdf", srdf)])["targets"]
            for name in ("ros", "gazebo", "mujoco", "dart", "drake", "pybullet"):
                self.assertEqual(targets[name], alone[name], srdf)
            if "drake:x" not in srdf:  # TinyXML reads on after some faults
                self.assertIn(targets["moveit"]["verdict"], ("refuses", "unknown"), srdf)

    def test_names_of_links_that_were_not_expanded_are_found_again(self):
        text = robot(link("${ns}base"), link("${ns}arm"), moving("${ns}shoulder", "${ns}base", "${ns}arm"))
        report = self.lint(text, "ros,gazebo,mujoco,dart")
        for name, one in report["targets"].items():
            self.assertEqual((name, one["verdict"]), (name, "loses"))
        found = [one for one in report["diagnostics"] if one["id"] == "SML1009"]
        self.assertEqual([one["message"] for one in found], ["`${ns}base` is a xacro expression that was never expanded"])
        self.assertIn("2 more such expressions in this file", found[0]["notes"])
        other = self.lint(text.replace('<child link="${ns}arm"/>', '<child link="${other}arm"/>'), "ros,gazebo,mujoco,dart")["targets"]
        self.assertEqual({one["verdict"] for one in other.values()}, {"refuses"})

    def test_meshes_that_nothing_uses(self):
        base = link("base", INERTIAL + '<visual><geometry><mesh filename="meshes/base.obj"/></geometry></visual>')
        meshes = [("meshes/base.obj", TETRAHEDRON), ("meshes/base.stl", "of the same part"), ("meshes/arm.obj", TETRAHEDRON)]

        def unused(text, *files, **more):
            self.setUp()
            return self.rules(text, files=[*meshes, *files], **more).get("SML1666")
        self.assertEqual(unused(robot(base)), "info")
        self.assertEqual(unused(robot(base, "<!-- arm comes later -->")), None)
        self.assertEqual(unused(robot(base), ("tools.yaml", "part: arm\n")), None)
        self.assertEqual(unused(robot(base), ("other.urdf", robot(base))), None)
        self.assertEqual(unused(robot(base), ("notes.yaml", "other: part\n")), "info")
        # The missing mesh may be the unused one under another name.
        self.assertEqual(unused(robot(base, link("arm", collision("meshes/arms.obj")))), None)
        # Other arguments may use it.
        arm = '<xacro:arg name="part" default="base"/>' + link("arm", collision("meshes/$(arg part).obj"))
        self.assertEqual(unused(robot(base, arm), name="r.urdf.xacro"), None)
        for path in ("package://p/", "file://$(find p)/"):
            text = robot(base.replace("meshes/", path + "meshes/"))
            self.assertEqual(unused(text, ("package.xml", "<package><name>p</name></package>"), name="r.urdf.xacro"), "info")

    def test_arguments_of_files_that_are_not_here(self):
        launch = """from launch_ros.actions import Node
def generate_launch_description():
    share = get_package_share_directory('p')
    return LaunchDescription([Node(package='robot_state_publisher', executable='robot_state_publisher', parameters=[
        {'robot_description': ParameterValue(Command(['xacro ', os.path.join(share, 'r.urdf.xacro'), ' size:=3']), value_type=str)}])])
"""
        files = [("package.xml", "<package><name>p</name></package>"), ("launch/a.launch.py", launch),
                 ("part.xacro", robot('<xacro:arg name="size" default="1"/>')), ("bare.xacro", robot(LASER))]
        for name, is_told in (("$(find elsewhere)/part.xacro", False), ("part.xacro", False), ("$(find p)/bare.xacro", True)):
            text = robot(f'<xacro:include filename="{name}"/>', ARM if is_told is False else "", '<link name="$(arg side)"/>')
            with self.subTest(name):
                self.setUp()
                told = [one["message"] for one in self.lint(text, "", files=files, name="r.urdf.xacro")["diagnostics"]
                        if one["id"] == "SML4203"]
                self.assertEqual(any("`size`" in one for one in told), is_told, told)


if __name__ == "__main__":
    LINT = sys.argv.pop(1)
    unittest.main(verbosity=1)
