# SPDX-License-Identifier: BSD-3-Clause
"""Converters report beside their result: one cause once, in few lines, with a cure that works.

Usage: calm_converters_test.py BIN
"""
import json
import pathlib
import sys
import unittest

import cli

INERTIAL = ('<inertial><mass value="1"/><inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/>'
            "</inertial>")
TETRAHEDRON = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"
READ = ("html", "mjcf", "usda", "gltf", "obj")             # formats that have the triangles
NAMED = ("sdf", "json", "dmd", "urdf", "smurfs", "svg")     # formats that name the files, or have none


def robot(address, links=20):
    """A chain, with two meshes on each link, and joints that follow the first one."""
    parts = []
    for i in range(links):
        mesh = f'<geometry><mesh filename="{address}/part{i}.obj"/></geometry>'
        parts.append(f'<link name="l{i}">{INERTIAL}<visual>{mesh}</visual><collision>{mesh}</collision></link>\n')
    for i in range(1, links):
        mimic = '<mimic joint="j1"/>' if i > 1 else ""
        parts.append(f'<joint name="j{i}" type="revolute"><parent link="l{i - 1}"/><child link="l{i}"/><axis xyz="0 0 1"/>'
                     f'<origin xyz="0 0 0.1"/><limit lower="-1" upper="1" effort="1" velocity="1"/>{mimic}'
                     '<safety_controller k_velocity="1"/></joint>\n')
    return '<robot name="r">\n' + "".join(parts) + "</robot>\n"


class Calm(cli.CliTest):
    def convert(self, tool, *arguments, code=0):
        cli.TOOL = str(BIN / tool)
        done = self.run_tool(*arguments)
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stderr

    def flatten(self, form, *arguments):
        return self.convert("smurfs-flatten", "r.urdf", "--format", form, "-o", "out." + form, *arguments)

    def test_a_package_that_is_elsewhere_is_one_finding_with_a_cure(self):
        self.write("r.urdf", robot("package://parts_of_r/meshes"))
        for i in range(20):
            self.write(f"elsewhere/parts_of_r/meshes/part{i}.obj", TETRAHEDRON)
        for form in READ:
            said = self.flatten(form)
            self.assertLessEqual(len(said.splitlines()), 40, said)
            self.assertEqual(said.count("SML8205"), 1, said)
            self.assertRegex(said, r"\d0 meshes are not in the \S+: no folder of the package `parts_of_r` was found")
            self.assertIn("= help: name its folder: `--package parts_of_r=DIR`", said)
            self.assertNotIn("outside", said)
            cured = self.flatten(form, "--package", "parts_of_r=elsewhere/parts_of_r")
            self.assertNotIn("SML8205", cured)

    def test_converters_that_read_no_mesh_name_the_package_as_well(self):
        self.write("r.urdf", robot("package://parts_of_r/meshes"))
        for i in range(20):
            self.write(f"elsewhere/parts_of_r/meshes/part{i}.obj", TETRAHEDRON)
        runs = [("smurfs-flatten", "r.urdf", "--format", form, "--force", "-o", "out." + form) for form in NAMED]
        runs += [("urdf2smurf", "r.urdf", "-o", "model", "--overwrite"), ("smurf2urdf", "r.urdf", "-o", "out.xml")]
        for run in runs:
            with self.subTest(run=run):
                said = self.convert(*run)
                self.assertLessEqual(len(said.splitlines()), 40, said)
                self.assertEqual(said.count("cannot find any file of the package `parts_of_r`"), 1, said)
                self.assertIn("= help: name its folder: `--package parts_of_r=DIR`", said)
                cured = self.convert(*run, "--package", "parts_of_r=elsewhere/parts_of_r")
                self.assertNotIn("package `parts_of_r`", cured)

    def test_the_loss_report_has_each(self):
        self.write("r.urdf", robot("package://parts_of_r/meshes"))
        said = self.flatten("html", "--loss-report", "lost.json")
        self.assertIn("--loss-report FILE each loss", said)
        lost = [loss for loss in json.loads(self.read("lost.json"))["losses"] if loss["id"] == "SML8205"]
        self.assertEqual(len(lost), 40)
        self.assertEqual(len({(loss["line"], loss["column"]) for loss in lost}), 40)
        self.assertEqual(self.flatten("html", "--report", "concise").count("warning[SML8205]"), 40)

    def test_an_address_without_a_package(self):
        self.write("r.urdf", robot("package://"))
        said = self.flatten("mjcf")
        self.assertIn("40 meshes (`package:///part0.obj`, `package:///part1.obj` and 38 more) are not in the MJCF: the address names no package", said)
        self.assertIn("write the path from the folder of the URDF", said)

    def test_one_missing_file_of_a_package_that_is_there(self):
        self.write("r.urdf", robot("package://parts_of_r/meshes", links=2))
        self.write("parts_of_r/meshes/part0.obj", TETRAHEDRON)
        said = self.flatten("obj", "--package", "parts_of_r=parts_of_r")
        said = said.replace("the mesh `parts_of_r/meshes/part1.obj` is", "2 meshes (`parts_of_r/meshes/part1.obj` and 1 more) are")
        self.assertIn("2 meshes (`parts_of_r/meshes/part1.obj` and 1 more) are not in the OBJ", said)
        self.assertNotIn("--package", said)

    def test_several_joints_are_one_sentence(self):
        self.write("r.urdf", robot("meshes"))
        said = self.flatten("sdf")
        self.assertIn("18 joints (`j2`, `j3` and 16 more) are free to move, since Gazebo before Harmonic ignores `mimic`", said)
        self.assertEqual(said.count("SML8206"), 1)

    def test_what_everybody_expects_is_not_said(self):
        self.write("r.urdf", robot("meshes", links=2).replace("<robot ", '<robot xmlns:x="http://x.org/x" '))
        for form in ("mjcf", "sdf", "usda"):
            said = self.flatten(form, "--report", "full")
            self.assertNotIn("gravity", said)
            self.assertNotIn("step size", said)

    def test_a_few_findings_keep_their_lines(self):
        self.write("r.urdf", robot("meshes", links=1))
        said = self.flatten("mjcf")
        self.assertIn("^", said)
        self.assertIn("2 meshes (`meshes/part0.obj` and 1 more) are not in the MJCF: each file is not there", said)
        self.assertNotIn("kinds", said)

    def test_urdf2smurf_groups_too(self):
        joints = "".join(f'<transmission name="t{i}"><type>transmission_interface/DifferentialTransmission</type>'
                         f'<joint name="j{i}"/><joint name="j{i + 1}"/><actuator name="a{i}"/><actuator name="b{i}"/></transmission>\n'
                         for i in range(1, 18))
        self.write("r.urdf", robot("package://parts_of_r/meshes").replace("</robot>", joints + "</robot>"))
        said = self.convert("urdf2smurf", "r.urdf", "-o", "out")
        self.assertLessEqual(len(said.splitlines()), 40, said)
        self.assertIn("17 transmissions (`t1`, `t2` and 15 more) cannot become an entry of a section", said)
        self.assertIn("--report concise shows each finding", said)


if __name__ == "__main__":
    BIN = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main(module="__main__")
