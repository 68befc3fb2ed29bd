# SPDX-License-Identifier: BSD-3-Clause
"""A model makes nothing be read that lies outside of its project."""
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import cli  # noqa: E402

URDF = '<robot name="r"><link name="a"/></robot>\n'
SECRET = "motors:\n- {name: the_secret, joint: nowhere, type: PID}\n"


class Confine(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.write("secret.yml", SECRET)
        self.write("a/b/project/r.urdf", URDF)
        self.project = self.folder / "a/b/project"

    def model(self, file):
        self.write("a/b/project/smurf/r.smurf", f"files: [../r.urdf, {file}]\n")

    def lint(self, *options, code=None):
        return self.expect(code, "--isolated", "--format", "concise", *options, "smurf/r.smurf", cwd=self.project).stdout

    def test_two_folders_above_are_the_project(self):
        self.write("a/b/project/motors.yml", SECRET)
        self.model("../motors.yml")
        found = self.lint(code=1)
        self.assertIn("nowhere", found)
        self.assertNotIn("outside", found)

    def test_outside(self):
        for path in ("../../../../secret.yml", self.folder / "secret.yml"):
            self.model(path)
            found = self.lint(code=1)
            self.assertIn("lies outside of the project; --allow-outside reads it", found)
            self.assertNotIn("nowhere", found)
            self.assertNotIn("outside", self.lint("--allow-outside", code=1))
            self.assertIn("nowhere", self.lint("--allow-outside", code=1))

    def test_links_are_followed_first(self):
        (self.project / "smurf").mkdir()
        (self.project / "smurf/motors.yml").symlink_to(self.folder / "secret.yml")
        self.model("motors.yml")
        self.assertIn("outside of the project", self.lint(code=1))

    def test_a_repository_is_the_project(self):
        (self.folder / ".git").mkdir()
        self.model("../../../../secret.yml")
        self.assertNotIn("outside", self.lint(code=1))

    def test_packages_are_allowed(self):
        self.write("elsewhere/meshes/box.stl", "solid a\nendsolid a\n")
        self.write("a/b/project/r.urdf", URDF.replace(
            '<link name="a"/>', '<link name="a"><visual><geometry><mesh filename="package://p/meshes/box.stl"/>'
            "</geometry></visual></link>"))
        found = self.expect(None, "--isolated", "--format", "concise", "--package", f"p={self.folder / 'elsewhere'}",
                            "r.urdf", cwd=self.project).stdout
        self.assertNotIn("outside", found)

    def test_device_files_and_loops(self):
        for path in ("/dev/zero", "/dev/stdin", "/proc/self/environ", "loop.yml"):
            self.write("a/b/project/smurf/x", "")
            loop = self.project / "smurf/loop.yml"
            if not loop.is_symlink():
                loop.symlink_to("loop.yml")
            self.model(path)
            for options in ((), ("--allow-outside",)):
                done = self.run_tool("--isolated", "--format", "json", *options, "smurf/r.smurf", cwd=self.project)
                self.assertIn(done.returncode, (0, 1), done.stderr)
                self.assertTrue(json.loads(done.stdout)["diagnostics"], path)


if __name__ == "__main__":
    cli.main()
