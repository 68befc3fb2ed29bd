# SPDX-License-Identifier: BSD-3-Clause
"""Special file names of Windows neither change findings nor damage files. Runs the programs under wine.

usage: windows_test.py FOLDER_OF_TOOLS FOLDER_OF_PROGRAMS
"""
import os
import pathlib
import sys
import tempfile
import unittest

from builds import Native, Windows

TOOLS, PROGRAMS = (pathlib.Path(folder).resolve() for folder in sys.argv[1:3])
URDF = """<robot name="arm">
  <link name="base">
    <visual><geometry><mesh filename="{mesh}"/></geometry></visual>
  </link>
</robot>
"""
STL = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n"


class WindowsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.native, cls.windows = Native(TOOLS), Windows(PROGRAMS)

    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="smurf-windows-")
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name) / "rob\u00f6t"
        (self.folder / "meshes").mkdir(parents=True)
        (self.folder / "package.xml").write_text("<package/>")
        (self.folder / "meshes/arm.stl").write_text(STL)
        self.write("meshes/arm.stl")

    def write(self, mesh):
        (self.folder / "arm.urdf").write_text(URDF.format(mesh=mesh))

    def run_tool(self, *arguments, tool="smurf-lint", build=None):
        return (build or self.windows).run_alone((tool, [str(one) for one in arguments], self.folder))

    def assert_same(self, *arguments):
        native = self.run_tool(*arguments, build=self.native)
        windows = self.run_tool(*arguments)
        self.assertEqual((native.returncode, native.stdout, native.stderr),
                         (windows.returncode, self.windows.shared(windows.stdout), self.windows.shared(windows.stderr)))
        return windows

    def drive(self, path):
        return "Z:" + str(path).replace("/", "\\")

    def test_names_of_meshes(self):
        """Names of devices, streams, patterns, drives, and names in another case are missing files, as on other systems."""
        for mesh in ("NUL", "meshes/con.stl", "meshes/COM1.stl", "meshes/arm.stl:stream", "meshes/arm.stl::$DATA", "meshes\\arm.stl",
                     "meshes/ARM.STL", "Meshes/arm.stl", "meshes/arm.stl.", "meshes/arm.stl ", "meshes/a*.stl", "C:/Windows/win.ini",
                     "C:\\Windows\\win.ini", "//server/share/arm.stl", "meshes/arm.stl"):
            with self.subTest(mesh):
                self.write(mesh)
                self.assert_same("--format=json", "--all", "arm.urdf")

    def test_lines_end_as_on_other_systems(self):
        found = self.assert_same("--format=full", "--all", "arm.urdf")
        self.assertNotIn(b"\r", found.stdout + found.stderr)
        self.assertIn(b"\n", found.stdout)

    def test_paths_of_users(self):
        """Users can type drives, backslashes, and another case; reports have slashes."""
        self.write("meshes/missing.stl")
        expected = self.run_tool("--format=concise", "--all", "meshes/../arm.urdf")
        self.assertIn(b"arm.urdf:", expected.stdout)
        for path in (".\\arm.urdf", "meshes\\..\\arm.urdf", "ARM.urdf"):
            with self.subTest(path):
                found = self.run_tool("--format=concise", "--all", path)
                self.assertEqual((found.returncode, found.stderr), (expected.returncode, expected.stderr))
                self.assertEqual(found.stdout.count(b"\n"), expected.stdout.count(b"\n"))
                self.assertNotIn(b"\\", found.stdout)
        found = self.run_tool("--format=concise", "--all", self.drive(self.folder / "arm.urdf"))
        self.assertEqual(found.stdout.count(b"\n"), expected.stdout.count(b"\n"), found.stderr)
        self.assertIn(f"/Z:{self.folder}/arm.urdf:".encode(), found.stdout)

    def test_files_are_replaced(self):
        for _ in range(2):
            done = self.run_tool("-o", "out\u00e9.urdf", "--force", "arm.urdf", tool="smurf2urdf")
            self.assertIn(done.returncode, (0, 1), done.stderr)
        self.assertEqual({"arm.urdf", "meshes", "out\u00e9.urdf", "package.xml"}, set(os.listdir(self.folder)))
        self.assertNotIn(b"\r", (self.folder / "out\u00e9.urdf").read_bytes())

    def test_devices_are_not_written(self):
        for name in ("NUL", "con.urdf", "out.urdf:stream"):
            with self.subTest(name):
                done = self.run_tool("-o", name, "--force", "arm.urdf", tool="smurf2urdf")
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertIn(b"Windows", done.stderr)
        self.assertEqual({"arm.urdf", "meshes", "package.xml"}, set(os.listdir(self.folder)))

    def test_absolute_names_for_others(self):
        """They begin with the drive."""
        done = self.run_tool("--mesh-uri=absolute", "--force", "arm.urdf", tool="smurf2urdf")
        self.assertIn(f'"Z:{self.folder}/meshes/arm.stl"'.encode(), done.stdout)
        done = self.run_tool("--mesh-uri=file", "--force", "arm.urdf", tool="smurf2urdf")
        self.assertIn(f'"file:///Z:{self.folder}/meshes/arm.stl"'.encode(), done.stdout)

    def test_names_without_drive(self):
        """A name that begins with a slash is on the drive of the model."""
        self.write("../../../../usr/share/arm.stl")
        self.run_tool("--force", "--overwrite", "-o", "robot", "arm.urdf", tool="urdf2smurf", build=self.native)
        expected = (self.folder / "robot/urdf/arm.urdf").read_bytes()
        self.run_tool("--force", "--overwrite", "-o", "robot", "arm.urdf", tool="urdf2smurf")
        self.assertEqual((self.folder / "robot/urdf/arm.urdf").read_bytes(), expected)
        self.assertIn(b"/usr/share/arm.stl", expected)


Windows.skip_without(TOOLS, PROGRAMS)
unittest.main(argv=sys.argv[:1])
