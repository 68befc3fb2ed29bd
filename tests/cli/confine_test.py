# SPDX-License-Identifier: BSD-3-Clause
"""A model cannot cause reading of files outside of its project."""
import itertools
import json
import os
import pathlib
import shutil
import subprocess
import sys
import threading

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import cli  # noqa: E402

URDF = '<robot name="r"><link name="a"/></robot>\n'
SECRET = "motors:\n- {name: the_secret, joint: nowhere, type: PID}\n"


class Confine(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.leave_repository()
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

    def test_a_configuration_opens_no_folder(self):
        """Without a repository: what --init writes must not decide which packages are found."""
        self.write("a/b/project/arm/package.xml", "<package><name>arm</name></package>\n")
        self.write("a/b/project/arm/urdf/r.urdf", '<robot name="r"><link name="a"><visual><geometry><mesh filename='
                   '"package://far/a.stl"/></geometry></visual></link></robot>\n')
        self.write("a/b/far/package.xml", "<package><name>far</name></package>\n")
        without = self.expect(None, "--format", "concise", ".", cwd=self.project).stdout
        self.assertIn("package://far/a.stl", without)
        self.write("a/b/project/.smurf-lint.yaml", "{}\n")
        self.assertEqual(self.expect(None, "--format", "concise", ".", cwd=self.project).stdout, without)

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

    def test_links_that_a_search_finds_open_no_other_project(self):
        """Without a repository, too: whoever made the folder may have chosen where they lead."""
        self.write("far/x/y/stolen.xacro", '<robot name="stolen"><link name="nowhere"/><link name="nowhere"/></robot>\n')
        self.write("far/x/y/other.urdf", '<robot name="stolen"><link name="nowhere"/><link name="nowhere"/></robot>\n')
        self.write("a/b/project/urdf/r.urdf.xacro", '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
                   '<xacro:include filename="part.xacro"/><link name="a"/></robot>\n')
        (self.project / "urdf/part.xacro").symlink_to(self.folder / "far/x/y/stolen.xacro")
        (self.project / "urdf/other.urdf").symlink_to(self.folder / "far/x/y/other.urdf")
        found = self.expect(None, "--isolated", "--format", "concise", ".", cwd=self.project).stdout
        self.assertIn("outside of the project", found)
        self.assertNotIn("nowhere", found)

    def test_a_repository_is_the_project(self):
        (self.folder / ".git").mkdir()
        self.model("../../../../secret.yml")
        self.assertNotIn("outside", self.lint(code=1))

    def test_a_package_in_a_home_folder_is_not_the_project(self):
        """Anybody may have left a package.xml in a folder that is shared, such as that of temporary files."""
        self.write("a/package.xml", "<package><name>stray</name></package>\n")
        self.write("a/b/secret.yml", SECRET)
        self.write("a/b/project/deep/smurf/r.smurf", "files: [../../r.urdf, ../../../secret.yml]\n")
        found = self.expect(1, "--isolated", "--format", "concise", "deep/smurf/r.smurf", cwd=self.project,
                            environment={"HOME": str(self.folder / "a")}).stdout
        self.assertIn("lies outside of the project", found)
        self.assertNotIn("nowhere", found)

    def test_packages_are_allowed(self):
        self.write("elsewhere/meshes/box.stl", "solid a\nendsolid a\n")
        self.write("a/b/project/r.urdf", URDF.replace(
            '<link name="a"/>', '<link name="a"><visual><geometry><mesh filename="package://p/meshes/box.stl"/>'
            "</geometry></visual></link>"))
        found = self.expect(None, "--isolated", "--format", "concise", "--package", f"p={self.folder / 'elsewhere'}",
                            "r.urdf", cwd=self.project).stdout
        self.assertNotIn("outside", found)

    def test_the_spelling_of_a_path_changes_nothing(self):
        mesh = '<link name="a"><visual><geometry><mesh filename="../../../{0}.stl"/></geometry></visual></link>'
        joint = ('<joint name="j{0}" type="fixed"><parent link="a"/><child link="b{0}"/></joint><link name="b{0}">'
                 '<visual><geometry><mesh filename="../../../{0}.stl"/></geometry></visual></link>')
        self.write("a/b/kuka/urdf/kuka.urdf", '<robot name="r">' + mesh.format("one") + joint.format("two") + "</robot>\n")
        self.write("a/b/kuka/smurf/kuka.smurf", "modelname: kuka\nfiles: [../urdf/kuka.urdf]\n")
        for name in ("one", "two"):
            self.write(f"a/{name}.stl", "solid x\nendsolid x\n")
        said = []
        for path in ("kuka", "kuka/smurf", "kuka/smurf/kuka.smurf", self.folder / "a/b/kuka"):
            done = self.run_tool("--isolated", "--format", "json", path, cwd=self.folder / "a/b")
            said.append([(one["id"], one["severity"], one["message"], one.get("help"))
                         for one in json.loads(done.stdout)["diagnostics"]])
        self.assertEqual(said[1:], said[:1] * 3)
        self.assertEqual([one for one in said[0] if one[0] == "SML1644"], [
            ("SML1644", "warning", "meshes were not looked at: they lie outside of the project",
             "add `--allow-outside` to check them")])

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


    def test_what_lies_outside_is_not_told_apart(self):
        """Nothing is revealed by messages, through a link, or for any way to name a file."""
        self.write("away.yml", SECRET)
        self.write("away.stl", "solid a\nendsolid a\n")
        self.write("away.png", "")
        for name in ("away", "gone"):
            for end in ("yml", "stl", "png"):
                (self.project / f"{name}.{end}").symlink_to(self.folder / f"{name}.{end}")
        shape = ('<visual><geometry><mesh filename="{0}.stl"/></geometry>'
                 '<material name="{0}"><texture filename="{0}.png"/></material></visual>')

        def said(name):
            for place in (f"../../../{name}", name, f"{self.folder}/{name}"):
                self.write("a/b/project/r.urdf", '<robot name="r"><link name="a">' + shape.format(place) + "</link></robot>")
                self.write("a/b/project/smurf/r.smurf", f"files: [../r.urdf, ../{place}.yml]\n"
                           if not place.startswith("/") else f"files: [../r.urdf, {place}.yml]\n")
                self.write("a/b/project/s.smurfs", f"smurfs:\n- {{name: e, type: object, file: {place}.png}}\n"
                           f"- {{name: f, type: smurf, file: {place}.smurf}}\n")
                for model in ("smurf/r.smurf", "s.smurfs"):
                    yield self.run_tool("--isolated", "--format", "concise", model, cwd=self.project).stdout

        for away, gone in zip(said("away"), said("gone")):
            self.assertEqual(away.replace("away", "gone"), gone)
            self.assertIn("outside of the project; --allow-outside", gone)

    def test_the_root_as_current_folder_allows_nothing(self):
        self.model("../../../../secret.yml")
        found = self.expect(1, "--isolated", "--format", "concise", self.project / "smurf/r.smurf", cwd="/").stdout
        self.assertIn("outside of the project", found)
        self.assertNotIn("the_secret", found)

    def test_home_folders_are_no_projects(self):
        self.write("a/.ssh/id.yml", SECRET)
        self.write("a/visible.yml", SECRET)
        home = {"HOME": str(self.folder / "a")}
        for name in ("../.ssh/id.yml", "../visible.yml"):
            self.write("a/b/r.smurf", f"files: [{name}]\n")
            for cwd in (self.folder / "a/b", self.folder / "a", self.folder):
                for path in (self.folder / "a/b/r.smurf", "."):
                    found = self.expect(1, "--isolated", "--format", "concise", path, cwd=cwd, environment=home).stdout
                    self.assertIn("outside of the project", found)
                    self.assertNotIn("the_secret", found)
        # A model in the home folder itself reads only files that are not hidden.
        self.write("a/.hidden.yml", SECRET)
        for name, is_read in (("visible.yml", True), (".hidden.yml", False), (".ssh/id.yml", False), ("b/r.yml", True), ("b/.r.yml", False)):
            self.write("a/b/r.yml", SECRET)
            self.write("a/b/.r.yml", SECRET)
            self.write("a/r.smurf", f"files: [{name}]\n")
            found = self.expect(1, "--isolated", "--format", "concise", self.folder / "a/r.smurf", cwd="/", environment=home).stdout
            self.assertEqual("the_secret" in found, is_read, name)

    def test_meshes_below_a_shared_folder(self):
        """A model in the home folder, or in a folder of a container such as /workspace, with its meshes."""
        home = {"HOME": str(self.folder / "a")}
        self.write("a/r.urdf", '<robot name="r"><link name="l"><visual><geometry><mesh filename="meshes/m.stl"/></geometry></visual>'
                               '</link></robot>')
        self.write("a/meshes/m.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                                     "endloop\nendfacet\nendsolid a\n")
        for cwd in (self.folder / "a", self.folder, "/"):
            found = self.run_tool("--isolated", "--format", "concise", self.folder / "a/r.urdf", cwd=cwd, environment=home)
            self.assertNotIn("outside of the project", found.stdout)
        # Homes of other users are not read.
        self.write("r.urdf", self.folder.joinpath("a/r.urdf").read_text().replace("meshes/", "b/meshes/"))
        self.write("b/meshes/m.stl", "secret")
        found = self.run_tool("--isolated", "--format", "concise", self.folder / "r.urdf", cwd="/", environment=home)
        self.assertIn("outside of the project", found.stdout)

    def test_what_was_not_looked_at_is_not_known(self):
        self.write("far/m.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                                "endloop\nendfacet\nendsolid a\n")
        shapes = "".join(f'<{kind}><geometry><mesh filename="m.stl"/></geometry></{kind}>' for kind in ("visual", "collision"))
        self.write("a/b/project/r.urdf", f'<robot name="r"><link name="l">{shapes}</link></robot>')
        (self.project / "m.stl").symlink_to(self.folder / "far/m.stl")
        done = self.run_tool("--isolated", "--target", "mujoco,dart,ros", self.project / "r.urdf", cwd=self.project)
        self.assertIn("lies outside of the project", done.stdout)
        self.assertNotIn("fails to load", done.stdout)
        self.assertRegex(done.stdout, "mujoco +not known")
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_a_baseline_in_a_home_folder(self):
        home = {"HOME": str(self.folder / "a")}
        self.write("a/r.urdf", '<robot name="r"><link name="l"><inertial><mass value="-1"/></inertial></link></robot>')
        self.run_tool("--generate-baseline", ".", cwd=self.folder / "a", environment=home)
        self.write("a/.smurf-lint.yaml", "baseline: .smurf-lint-baseline.yaml\n")
        done = self.run_tool(".", cwd=self.folder / "a", environment=home)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_a_repository_at_home_is_no_project(self):
        (self.folder / "a/.git").mkdir()
        self.write("a/.ssh/id.yml", SECRET)
        self.write("a/b/r.smurf", "files: [../.ssh/id.yml]\n")
        found = self.expect(1, "--isolated", "--format", "concise", "b/r.smurf", cwd=self.folder / "a",
                            environment={"HOME": str(self.folder / "a")}).stdout
        self.assertIn("outside of the project", found)

    def test_models_found_in_a_home_folder_have_projects_of_their_own(self):
        self.write("a/x/y/smurf/r.smurf", "files: [../motors.yml]\n")
        self.write("a/x/y/motors.yml", SECRET)
        self.write("a/x/left/out/r.smurf", "nonsense: [\n")
        self.write("a/x/left/.smurf-lintignore", "out/\n")
        found = self.expect(1, "--isolated", "--format", "concise", ".", cwd=self.folder / "a",
                            environment={"HOME": str(self.folder / "a")}).stdout
        self.assertIn("the_secret", found)
        self.assertNotIn("outside", found)
        self.assertNotIn("left", found)

    def test_show_config(self):
        self.write("secret", "TOP SECRET LINE\n")
        (self.project / ".git").mkdir()
        for setting in ("schemas: {sections: {foo: ../../../secret}}", "extends: ../../../secret",
                        f"extends: {self.folder}/secret"):
            self.write("a/b/project/.smurf-lint.yaml", setting + "\n")
            done = self.run_tool("--show-config", ".", cwd=self.project)
            self.assertIn("outside of the project", done.stderr)
            self.assertNotIn("TOP", done.stdout + done.stderr)
            done = self.run_tool("--show-config", ".", "--allow-outside", cwd=self.project)
            self.assertIn("TOP", done.stderr)

    def test_the_history_of_a_repository_is_not_read(self):
        """CI servers keep tokens in .git/config."""
        self.write("a/b/project/.git/config", "[http]\n  the_token\n")
        self.write("a/b/project/.git/info/exclude", "left_out.urdf\n")
        self.write("a/b/project/left_out.urdf", URDF)
        (self.project / "link.yml").symlink_to(".git/config")
        for name in ("config", "gone"):
            self.model(f"../.git/{name}.yml")
            self.assertIn("outside of the project", self.lint(code=1))
        self.model("../link.yml")
        self.assertIn("outside of the project", self.lint(code=1))
        self.write("a/b/project/smurf/r.smurf", "files: [../r.urdf]\n")
        for setting in ("extends: .git/config", "extends: link.yml", "extends: .git/gone",
                        "schemas: {sections: {foo: .git/config}}"):
            self.write("a/b/project/.smurf-lint.yaml", setting + "\n")
            done = self.run_tool("--format", "full", ".", cwd=self.project)
            self.assertIn("outside of the project", done.stdout, setting)
            self.assertNotIn("token", done.stdout + done.stderr, setting)
        self.assertEqual(self.expect(0, "--isolated", "--list-files", ".", cwd=self.project).stdout,
                         "r.urdf\nsmurf/r.smurf\n")

    def test_links_that_lead_outside_are_not_searched(self):
        self.write("elsewhere/deep/private.smurf", "files: []\n")
        self.write("a/b/project/smurf/r.smurf", "files: [../r.urdf]\n")
        (self.project / "out").symlink_to(self.folder / "elsewhere")
        (self.project / "up").symlink_to("..")
        (self.project / "same").symlink_to("smurf")
        (self.project / "loop").symlink_to("loop")
        (self.project / "lost.urdf").symlink_to("/nowhere/lost.urdf")
        found = self.expect(0, "--isolated", "--list-files", ".", cwd=self.project).stdout
        self.assertEqual(found, "r.urdf\nsmurf/r.smurf\n")
        report = self.run_tool("--isolated", ".", cwd=self.project).stdout
        self.assertIn("4 symbolic links that lead out of the folder were not followed", report)
        self.assertNotIn("SML0001", report)

    def test_hard_links_are_files_of_their_own(self):
        """They may have other neighbours, and whoever counts verdicts of a data set misses one."""
        self.write("set/a/r.urdf", URDF)
        (self.folder / "set/b").mkdir()
        (self.folder / "set/b/r.urdf").hardlink_to(self.folder / "set/a/r.urdf")
        (self.folder / "set/c.urdf").symlink_to("a/r.urdf")
        found = self.expect(0, "--isolated", "--list-files", "set", cwd=self.folder).stdout
        self.assertEqual(found, "set/a/r.urdf\nset/b/r.urdf\n")
        self.assertIn("2 models", self.run_tool("--isolated", "set", cwd=self.folder).stdout)

    def test_what_folders_outside_are_links_to_is_not_told(self):
        """For two links that lead outside, it makes no difference whether they have the same target."""
        (self.project / ".git").mkdir()
        for kind in ("smurf", "smurfs", "urdf"):
            (self.project / f"1.{kind}").symlink_to(f"../../../private/x/f.{kind}")
            (self.project / f"2.{kind}").symlink_to(f"../../../private/y/f.{kind}")
        names = sorted(one.name for one in self.project.iterdir() if one.is_symlink())
        load_check = pathlib.Path(cli.TOOL).with_name("smurf-load-check")
        runs = [(cli.TOOL, "--isolated", *options, *paths) for paths in ((".",), names)
                for options in (("--list-files",), ("--format", "json"), ("--format", "full"))]
        runs += [(load_check, "--format", "json", "."), (load_check, "--format", "json", *names)] if load_check.exists() else []
        told = []
        for makes in (lambda: (self.folder / "private/y").mkdir(), lambda: (self.folder / "private/y").symlink_to("x")):
            (self.folder / "private/x").mkdir(parents=True)
            makes()
            for place in ("x", "y"):
                for kind, text in (("smurf", "files: []\n"), ("smurfs", "entities: []\n"), ("urdf", URDF)):
                    (self.folder / "private" / place / f"f.{kind}").write_text(text)
            done = [subprocess.run([str(word) for word in run], cwd=self.project, capture_output=True, text=True, check=False)
                    for run in runs]
            told.append([(one.args, one.returncode, one.stdout, one.stderr) for one in done])
            shutil.rmtree(self.folder / "private")
        for first, second in zip(*told):
            self.assertEqual(first, second)

    def test_named_links_out_of_a_repository_open_nothing(self):
        """A hook names files of a pull request."""
        (self.project / ".git").mkdir()
        self.write("a/other/x.yml", SECRET)
        self.write("a/other/r.urdf", URDF)
        self.write("a/other/r.smurf", "files: [r.urdf, x.yml]\n")
        (self.project / "link.smurf").symlink_to(self.folder / "a/other/r.smurf")
        (self.project / "folder").symlink_to(self.folder / "a/other")
        for named in ("link.smurf", "folder/r.smurf", "folder/x.yml", "folder"):
            done = self.run_tool("--isolated", "--format", "concise", named, cwd=self.project)
            self.assertIn(done.returncode, (1, 2), named)
            self.assertIn("outside of the project", done.stdout + done.stderr, named)
            self.assertNotIn("nowhere", done.stdout + done.stderr, named)
            done = self.run_tool("--isolated", "--format", "concise", "--allow-outside", named, cwd=self.project)
            self.assertEqual(done.returncode, 1, named)

    def test_a_named_file_that_is_missing_is_not_called_outside(self):
        for named in ("/smurf-none.urdf", "/home/smurf-none.urdf", "/smurf-none/r.urdf", "none.urdf", "../none.urdf"):
            done = self.run_tool("--isolated", named, cwd=self.project)
            self.assertEqual((done.returncode, done.stderr.split(": ", 1)[1]),
                             (2, f"cannot read '{named}': No such file or directory\n"))

    def test_a_search_is_bounded(self):
        for i in range(30):
            self.write(f"a/b/project/many/{i}/x.txt", "")
        done = self.run_tool("--isolated", "--limit", "folder-entries=20", ".", cwd=self.project)
        self.assertEqual(done.returncode, 2)
        self.assertIn("has more than 20 files and folders; raise the limit with `--limit folder-entries=N`", done.stderr)
        self.assertEqual(done.stderr.count("folder-entries"), 1)

    def test_links_that_change_meanwhile_lead_nowhere_else(self):
        """A link is judged and followed in one step: see found_file.hpp."""
        self.model("motors.yml")
        self.write("a/b/project/smurf/inside.yml", "motors: []\n")
        stop = threading.Event()

        def flip():
            link, other = self.project / "smurf/motors.yml", self.project / "smurf/next"
            for target in itertools.cycle(("inside.yml", self.folder / "secret.yml")):
                other.symlink_to(target)
                other.rename(link)
                if stop.is_set():
                    return

        thread = threading.Thread(target=flip)
        thread.start()
        try:
            for _ in range(60):
                self.assertNotIn("the_secret", self.run_tool("--isolated", "smurf/r.smurf", cwd=self.project).stdout)
        finally:
            stop.set()
            thread.join()

    def test_pipes_are_not_opened(self):
        """If a pipe were opened for reading, even for a moment, its writer would continue."""
        (self.project / "smurf").mkdir()
        pipe = self.project / "smurf/motors.yml"
        os.mkfifo(pipe)
        self.model("motors.yml")
        writer = subprocess.Popen(["sh", "-c", 'exec 3>"$0"; echo opened', pipe], stdout=subprocess.PIPE, text=True)
        try:
            for options in ((), ("--allow-outside",)):
                self.assertIn("is not a regular file", self.lint(*options, code=1))
            with self.assertRaises(subprocess.TimeoutExpired):
                writer.wait(timeout=0.5)
        finally:
            writer.kill()
            writer.communicate()

    def test_current_folders_without_a_path_end(self):
        self.write("deep/a.smurf", "files: []\n")
        here = os.open(self.folder / "deep", os.O_RDONLY)
        for _ in range(25):  # 5,000 bytes
            os.mkdir("d" * 200, dir_fd=here)
            inner = os.open("d" * 200, os.O_RDONLY, dir_fd=here)
            os.close(here)
            here = inner
        with open(os.open("a.smurf", os.O_CREAT | os.O_WRONLY, dir_fd=here), "w") as file:
            file.write("files: []\n")
        done = self.run_tool("--isolated", ".", preexec_fn=lambda: os.fchdir(here))
        os.close(here)
        self.assertIn(done.returncode, (0, 1, 2))

    def test_current_folders_below_unreadable_ones_are_searched(self):
        self.write("closed/open/a.smurf", "modelname: a\nfiles: [r.urdf]\n")
        self.write("closed/open/r.urdf", URDF)
        os.chmod(self.folder, 0o755)
        os.chmod(self.folder / "closed/open", 0o755)
        inner = os.open(self.folder / "closed/open", os.O_RDONLY)
        os.chmod(self.folder / "closed", 0)

        def become_nobody():
            os.fchdir(inner)
            if os.getuid() == 0:
                os.setgid(65534)
                os.setuid(65534)

        tool = self.folder / "smurf-lint"
        shutil.copy(cli.TOOL, tool)
        done = subprocess.run([tool, "--isolated", "--format", "concise", "."], capture_output=True, text=True, timeout=600,
                              preexec_fn=become_nobody, check=False)
        os.close(inner)
        os.chmod(self.folder / "closed", 0o755)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        self.assertNotIn("outside", done.stdout)


if __name__ == "__main__":
    cli.main()
