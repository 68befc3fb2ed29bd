# SPDX-License-Identifier: BSD-3-Clause
"""smurf-lint --rename on names of xacro. xacro_rename_test.py SMURF-LINT SMURF2URDF

The robots stay byte for byte, and a rename back restores the files.
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

LINT = CONVERT = None
FILES = {
    "package.xml": '<package format="3"><name>cart</name></package>\n',
    "urdf/cart.urdf.xacro": """<?xml version="1.0"?>
<robot name="cart" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="$(find cart)/urdf/wheel.xacro"/>
  <xacro:arg name="load" default="2"/>
  <xacro:property name="size" value="0.3"/>
  <xacro:property name="half" value="${size / 2}"/>
  <link name="base"><inertial><mass value="$(arg load)"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <xacro:wheel prefix="left" radius="${half}">
    <origin xyz="0 ${size} 0"/>
  </xacro:wheel>
  <xacro:wheel prefix="right"><origin xyz="0 -${size} 0"/></xacro:wheel>
</robot>
""",
    "urdf/other.urdf.xacro": """<?xml version="1.0"?>
<robot name="other" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="wheel.xacro"/>
  <xacro:property name="size" value="7"/>
  <link name="base"/>
  <xacro:call macro="wheel" prefix="only"><origin xyz="${size} 0 0"/></xacro:call>
</robot>
""",
    "urdf/wheel.xacro": """<?xml version="1.0"?>
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="wheel" params="prefix radius:=0.1 *place">
    <link name="${prefix}_wheel">
      <collision><geometry><sphere radius="${radius}"/></geometry></collision>
    </link>
    <joint name="${prefix}_wheel" type="fixed">
      <parent link="base"/>
      <child link="${prefix}_wheel"/>
      <xacro:insert_block name="place"/>
    </joint>
  </xacro:macro>
  <xacro:macro name="cap" params="prefix"><link name="${prefix}"/></xacro:macro>
</robot>
""",
    "launch/cart.launch.py": 'command = ["xacro", path, " load:=", load]\n',
}
RENAMES = {  # back, and the number of files that change
    "macro:wheel=tyre-1": ("macro:tyre-1=wheel", 3),
    "parameter:wheel.radius=r": ("parameter:wheel.r=radius", 2),
    "parameter:wheel.prefix=side": ("parameter:wheel.side=prefix", 3),
    "block:wheel.place=where": ("block:wheel.where=place", 1),
    "property:half=quarter": ("property:quarter=half", 1),
    "property:size=width": ("property:width=size", 1),
    "argument:load=kilograms": ("argument:kilograms=load", 1),
}


class Rename(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp()).resolve()
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        (self.folder / ".git").mkdir()
        for path, text in FILES.items():
            (self.folder / path).parent.mkdir(exist_ok=True)
            (self.folder / path).write_text(text)

    def rename(self, what, path="urdf/cart.urdf.xacro", *more):
        return subprocess.run([LINT, path, *more, "--rename", what, "--fix-only"], cwd=self.folder, capture_output=True,
                              text=True, check=False)

    def texts(self):
        return {path: (self.folder / path).read_text() for path in FILES}

    def robots(self):
        return [subprocess.run([CONVERT, f"urdf/{name}.urdf.xacro"], cwd=self.folder, capture_output=True, check=True).stdout
                for name in ("cart", "other")]

    def test_there_and_back(self):
        robots = self.robots()
        for there, (back, files) in RENAMES.items():
            with self.subTest(there):
                done = self.rename(there)
                self.assertEqual(done.returncode, 0, done.stderr)
                changed = [path for path, text in self.texts().items() if text != FILES[path]]
                self.assertEqual(len(changed), files, changed)
                name = there.split(":")[1].split("=")[0].split(".")[-1]
                if there.startswith("macro"):
                    self.assertNotIn("xacro:" + name, "".join(self.texts().values()))
                self.assertEqual(self.robots(), robots)
                done = self.rename(back)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual(self.texts(), FILES)

    def test_other_robots_of_a_library_follow(self):
        self.assertEqual(self.rename("macro:wheel=tyre").returncode, 0)
        self.assertIn('macro="tyre"', self.texts()["urdf/other.urdf.xacro"])
        # The property of the same name in another robot is another one.
        self.assertEqual(self.rename("property:size=width").returncode, 0)
        self.assertIn('name="size"', self.texts()["urdf/other.urdf.xacro"])

    def test_launch_files_are_named(self):
        done = self.rename("argument:load=kilograms")
        self.assertIn("`load` is still named in 'launch/cart.launch.py' (line 1)", done.stderr)

    def refused(self, what, reason):
        done = self.rename(what)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("nothing was renamed: " + reason, done.stderr)

    def test_refused(self):
        self.refused("macro:whel=tyre", "there is no macro `whel`")
        self.refused("parameter:cap.radius=r", "there is no parameter `radius` in the macro `cap`")
        self.refused("property:size=half", "`half` is the name of a property in 'urdf/cart.urdf.xacro', line 6")
        self.refused("property:size=1st", "`1st` cannot be a name")
        self.refused("macro:wheel=include", "`xacro:include` is an element of xacro")
        self.refused("parameter:wheel.radius=prefix", "`prefix` is the name of a parameter")
        self.assertEqual(self.texts(), FILES)

    def test_a_name_in_a_computed_text_is_refused(self):
        path = self.folder / "urdf/cart.urdf.xacro"
        text = path.read_text().replace("$(arg load)", "${xacro.arg('lo' + 'ad')}")
        path.write_text(text)
        self.refused("argument:load=kilograms", "with `kilograms`, the robot of 'urdf/cart.urdf.xacro' cannot be expanded")
        self.assertEqual(path.read_text(), text)

    def test_arguments_of_the_command_line(self):
        path = self.folder / "urdf/cart.urdf.xacro"
        path.write_text(path.read_text().replace('<xacro:arg name="load" default="2"/>', ""))
        self.refused("property:size=width", "no robot with the property `size` can be expanded")
        done = self.rename("property:size=width", "urdf/cart.urdf.xacro", "load:=3")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_arguments_of_the_configuration(self):
        path = self.folder / "urdf/cart.urdf.xacro"
        path.write_text(path.read_text().replace('<link name="base">', '<link name="$(arg root)"/><link name="base">'))
        config = self.folder / ".smurf-lint.yaml"
        text = """xacro:
- file: urdf/cart.urdf.xacro
  arguments:
    load: [2, 3]  # load
    root: world
- file: urdf/other.urdf.xacro
  arguments: {load: 5}
"""
        config.write_text(text)
        done = self.rename("argument:load=kilograms")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(config.read_text(), text.replace("    load:", "    kilograms:"))
        self.assertIn("$(arg kilograms)", path.read_text())
        self.assertEqual(self.rename("argument:kilograms=load").returncode, 0)
        self.assertEqual(config.read_text(), text)

    def test_wrong_uses(self):
        for what in ("parameter:radius=r", "macro:=a", "property:size"):
            self.assertIn("write " + what.split(":")[0] + ":", self.rename(what).stderr)
        done = subprocess.run([LINT, "urdf/cart.urdf.xacro", "--rename", "macro:wheel=a", "--rename", "link:base=b"],
                              cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertIn("one after the other", done.stderr)


if __name__ == "__main__":
    LINT, CONVERT = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1])
