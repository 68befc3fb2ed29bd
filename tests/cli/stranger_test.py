# SPDX-License-Identifier: BSD-3-Clause
"""Checked files (configuration, models, scenes, archives, names, links) cannot choose a place to write or act as
options, and outputs never replace inputs.

Usage: stranger_test.py FOLDER_OF_TOOLS [unittest option]...
"""
import ctypes
import json
import os
import pathlib
import resource
import shutil
import signal
import stat
import subprocess
import sys
import tempfile
import threading
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
FIXTURES = ROOT / "build/fixtures"
TOOLS = None
MESH = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n"
WARNED = "smurfs:\n- {name: a, type: box, position: [0, 0, 0]}\n"


def urdf(*meshes, name="r"):
    shapes = "".join(f'<visual><geometry><mesh filename="{mesh}"/></geometry></visual>' for mesh in meshes)
    return f'<robot name="{name}"><link name="a">{shapes}</link></robot>\n'


class StrangerTest(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="smurf-stranger-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.victim = self.folder / "victim"
        self.victim.mkdir()
        (self.victim / "mine").write_text("mine\n")
        self.project = self.folder / "project"
        self.project.mkdir()
        (self.project / ".git").mkdir()

    def write(self, path, text):
        target = self.project / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(text if isinstance(text, bytes) else text.encode())

    def run_tool(self, tool, *arguments, cwd=None, **keywords):
        variables = {k: v for k, v in os.environ.items() if k not in ("FORCE_COLOR", "GITHUB_ACTIONS")}
        return subprocess.run([TOOLS / tool, *map(str, arguments)], cwd=cwd or self.project, env=variables, timeout=600,
                              capture_output=True, encoding="utf-8", errors="replace", check=False, **keywords)

    def expect(self, code, tool, *arguments, **keywords):
        done = self.run_tool(tool, *arguments, **keywords)
        self.assertEqual(done.returncode, code, f"{tool} {arguments}\n{done.stdout}\n{done.stderr}")
        return done

    def texts(self, folder):
        return {str(path.relative_to(folder)): path.read_bytes()
                for path in sorted(folder.rglob("*")) if path.is_file() and not path.is_symlink()}

    def assert_unharmed(self):
        self.assertEqual(self.texts(self.victim), {"mine": b"mine\n"})


class Configuration(StrangerTest):
    def setUp(self):
        super().setUp()
        self.write("r.urdf", urdf())

    def test_one_that_was_found_names_no_reports(self):
        (self.project / "link").symlink_to(self.victim / "mine")
        for place in (self.victim / "mine", "../victim/mine", "link", "report.json"):
            for text in (f'format: "json={place}"\n', f'extends: other.yaml\n# {place}\n'):
                with self.subTest(place=place, text=text):
                    self.write("other.yaml", f'format: [concise, "json={place}"]\n')
                    self.write(".smurf-lint.yaml", text)
                    done = self.expect(1, "smurf-lint", "--select", "SML9", ".")
                    self.assertIn("SML9002", done.stdout)
                    self.assertIn("must not name a file to write", done.stdout)
                    self.assert_unharmed()
                    self.assertFalse((self.project / "report.json").exists())

    def test_one_that_is_named_does_as_it_is_trusted(self):
        self.write("base.yaml", "format: [concise, json=report.json]\n")
        self.write("c.yaml", "extends: base.yaml\n")
        self.expect(0, "smurf-lint", "--config", "c.yaml", ".")
        json.loads((self.project / "report.json").read_text())

    def test_a_format_without_a_file_stays(self):
        self.write(".smurf-lint.yaml", "format: concise\n")
        self.assertEqual(self.expect(0, "smurf-lint", ".").stdout, "")

    def test_baseline(self):
        self.write("r.urdf", '<robot name="r"><link nam="a"/></robot>')
        self.write(".smurf-lint.yaml", "baseline: ../victim/mine\n")
        done = self.expect(2, "smurf-lint", "--generate-baseline", ".")
        self.assertIn("add --baseline '../victim/mine'", done.stderr)
        self.assert_unharmed()
        self.write(".smurf-lint.yaml", "baseline: .smurf-lint-baseline.yaml\n")
        self.expect(0, "smurf-lint", "--generate-baseline", ".")
        self.assertIn("suppressed", self.expect(0, "smurf-lint", ".").stdout)
        self.expect(0, "smurf-lint", "--generate-baseline", ".")  # again
        self.write(".smurf-lint.yaml", "")
        (self.project / ".smurf-lint-baseline.yaml").unlink()
        done = self.expect(0, "smurf-lint", "--generate-baseline", ".")
        self.assertIn("add --baseline .smurf-lint-baseline.yaml", done.stdout)

    def test_a_baseline_replaces_baselines_only(self):
        self.write("notes.txt", "mine\n")
        for arguments in (["--baseline", "notes.txt"], ["--baseline", "r.urdf"]):
            before = self.texts(self.project)
            self.expect(2, "smurf-lint", *arguments, "--generate-baseline", ".")
            self.assertEqual(self.texts(self.project), before)

    def test_the_usual_baseline_is_no_link(self):
        self.expect(0, "smurf-lint", "--baseline", self.victim / "mine2", "--generate-baseline", ".")
        before = self.texts(self.victim)
        self.write("r.urdf", '<robot name="r"><link nam="a"/></robot>')
        for target in (self.victim / "mine2", self.victim / "new"):
            (self.project / ".smurf-lint-baseline.yaml").symlink_to(target)
            self.expect(2, "smurf-lint", "--generate-baseline", ".")
            self.assertEqual(self.texts(self.victim), before)
            (self.project / ".smurf-lint-baseline.yaml").unlink()

    def test_fixes_do_not_follow_links_out_of_the_project(self):
        text = '<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="fixed"><parent link="a"/>' \
               '<child link="b"/><dynamics/></joint></robot>\n'
        (self.victim / "mine").write_text(text)
        (self.victim / ".git").mkdir()
        (self.project / "l.urdf").symlink_to(self.victim / "mine")
        self.write("sound.urdf", text)
        self.expect(2, "smurf-lint", "--fix", "l.urdf", "sound.urdf")
        self.assertEqual((self.victim / "mine").read_text(), text)
        self.assertNotEqual((self.project / "sound.urdf").read_text(), text)
        self.expect(2, "smurf-lint", "--fix", "--allow-outside", "l.urdf", "sound.urdf")  # this test is about reading
        self.assertEqual((self.victim / "mine").read_text(), text)

    def test_fixes_change_nothing_that_a_model_only_reads(self):
        """An installed package and the current folder may be read, but fixes must not change a file of them only because a model lists it."""
        text = '<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="fixed"><parent link="a"/>' \
               '<child link="b"/><dynamics/></joint></robot>\n'
        installed = self.victim / "pkg/r.urdf"
        installed.parent.mkdir()
        installed.write_text(text)
        (self.victim / "pkg/.git").mkdir()
        self.write("m.smurf", "modelname: r\nfiles: [../victim/pkg/r.urdf]\n")
        self.write("own.urdf", text)
        for options, cwd in ((["--package", f"pkg={installed.parent}"], self.project), ([], self.folder)):
            model, own = self.project / "m.smurf", self.project / "own.urdf"
            own.write_text(text)
            done = self.expect(1, "smurf-lint", "--fix", *options, model, own, cwd=cwd)
            self.assertEqual(installed.read_text(), text)
            self.assertNotEqual(own.read_text(), text)
            self.assertIn("SML1425", done.stdout)
            self.assertNotIn("fixable", done.stdout)
            self.assertEqual(self.expect(0, "smurf-lint", "--diff", *options, model, cwd=cwd).stdout, "")
            done = self.expect(2, "smurf-lint", "--rename", "joint:j=k", *options, model, cwd=cwd)
            self.assertIn("r.urdf' is in no project of the named files; name it, too", done.stderr)
            self.assertEqual(installed.read_text(), text)
            self.expect(1, "smurf-lint", "--rename", "joint:j=k", *options, model, installed, cwd=cwd)
            self.assertIn('name="k"', installed.read_text())
            installed.write_text(text)
            self.expect(0, "smurf-lint", "--fix", *options, model, installed, cwd=cwd)
            self.assertNotEqual(installed.read_text(), text)
            installed.write_text(text)
        self.expect(0, "smurf-lint", "--fix", "--allow-outside", "m.smurf")
        self.assertNotEqual(installed.read_text(), text)


class Pipes(StrangerTest):
    def test_a_pipe_that_nobody_reads(self):
        self.write("r.urdf", urdf())
        os.mkfifo(self.project / "pipe")
        for option in (["-o", "pipe"], ["--format", "json=pipe"]):
            done = self.expect(2, "smurf-lint", *option, "r.urdf")
            self.assertIn("cannot write 'pipe': it is a pipe that nobody reads", done.stderr)

    def test_a_pipe_of_a_configuration(self):
        self.write("r.urdf", urdf())
        os.mkfifo(self.project / "pipe")
        self.write(".smurf-lint.yaml", "format: json=pipe\nbaseline: pipe\n")
        self.expect(1, "smurf-lint", "r.urdf")
        self.expect(2, "smurf-lint", "--generate-baseline", "r.urdf")

    def test_pipes_of_the_user(self):
        self.write("r.urdf", urdf())
        for script in ("smurf-lint --format json=/dev/stdout r.urdf",
                       "smurf-lint -o >(cat) --format json r.urdf; sleep 0.3",
                       "mkfifo p; cat p & smurf-lint -o p --format json r.urdf; wait",
                       "mkfifo q; { sleep 0.2; cat q; } & smurf-lint -o q --format json r.urdf; wait",
                       "smurf-lint --format json=/dev/stderr r.urdf 2>&1"):
            with self.subTest(script):
                done = subprocess.run(["bash", "-c", f"PATH={TOOLS}:$PATH; {script}"], cwd=self.project, timeout=600,
                                      capture_output=True, text=True, check=False)
                self.assertEqual(done.stderr, "")
                self.assertEqual(json.loads(done.stdout)["summary"]["files"], 1)

    def test_standard_error_in_a_file_keeps_what_is_in_it(self):
        with (self.project / "log").open("w") as log:
            log.write("before\n")
            log.flush()
            subprocess.run([TOOLS / "smurf-lint", "--fix", "-"], input=urdf().encode(), stderr=log, cwd=self.project,
                           stdout=subprocess.DEVNULL, timeout=600, check=False)
        text = (self.project / "log").read_text()
        self.assertTrue(text.startswith("before\n") and "no findings" in text, text)


class Names(StrangerTest):
    """Names of models are used as names of folders."""

    def copy(self, model, mesh="m.stl", folder="out/files", code=0):
        self.write(f"in/{model}", "modelname: r\nfiles: [r.urdf]\n")
        self.write("in/r.urdf", urdf(mesh))
        self.write(f"in/{mesh}", MESH)
        self.write("in/s.smurfs", f"smurfs:\n- {{name: a, file: {json.dumps(model)}, type: smurf}}\n")
        return self.expect(code, "smurfs-flatten", "--format", "sdf", "--force", "in/s.smurfs", "-o", "w.sdf",
                           "--copy-assets", folder)

    def test_folders_of_copies(self):
        self.write("out/m.stl", "mine\n")
        for model in ("...smurf", "-x.smurf", ".git.smurf", "a\nb\x1b.smurf", "....smurf", ".smurf"):
            with self.subTest(model=model):
                shutil.rmtree(self.project / "out/files", ignore_errors=True)
                shutil.rmtree(self.project / "in", ignore_errors=True)
                self.copy(model)
                self.assertEqual(self.texts(self.project / "out").pop("m.stl"), b"mine\n")
                copies = [path for path in self.texts(self.project / "out") if path != "m.stl"]
                self.assertEqual(len(copies), 1)
                self.assertRegex(copies[0], r"^files/[\w][\w. -]*/m\.stl$")

    def test_names_of_copies(self):
        for mesh in (".bashrc.stl", "-rf.stl", "a;b.stl"):
            shutil.rmtree(self.project / "out/files", ignore_errors=True)
            self.copy("r.smurf", mesh)
            copies = list(self.texts(self.project / "out"))
            self.assertEqual(len(copies), 1)
            self.assertRegex(copies[0], r"^files/r/[\w][\w.-]*$")
            self.assertIn(copies[0], (self.project / "w.sdf").read_text())

    def test_an_obj_keeps_its_materials(self):
        self.write("in/größe (1).mtl", "newmtl a\n")
        self.copy("r.smurf", "größe (1).obj")
        self.assertEqual(sorted(path.name for path in (self.project / "out/files/r").iterdir()),
                         ["größe (1).mtl", "größe (1).obj"])

    def test_names_of_new_models(self):
        for name in ("-x.urdf", "...urdf", ".hidden.urdf"):
            shutil.rmtree(self.project / "out", ignore_errors=True)
            self.write(name, urdf())
            self.expect(0, "urdf2smurf", "-o", "out", "--", name)
            for path in self.texts(self.project / "out"):
                self.assertRegex(path, r"^(smurf|urdf)/[\w][\w.-]*$")


class Hooks(StrangerTest):
    def test_a_file_hides_behind_no_other(self):
        """A list of files shows U+2028 as an escape; a sound file may have the escape as its name."""
        shutil.copytree(FIXTURES / "models/arm", self.project / "arm")
        shutil.copy(self.project / "arm/smurf/arm.smurf", self.project / "arm/smurf/a\\u2028b.smurf")
        self.write("arm/smurf/a\u2028b.smurf", "modelname: [\n")
        self.write(".smurf-lintignore", "a\\\\u2028b.smurf\n")
        self.converts_not_all()

    def test_a_file_hides_behind_no_replacement(self):
        """A list of files shows invalid UTF-8 as U+FFFD, which the name of a sound file may contain."""
        shutil.copytree(FIXTURES / "models/arm", self.project / "arm")
        shutil.copy(self.project / "arm/smurf/arm.smurf", self.project / "arm/smurf/a\ufffdb.smurf")
        (self.project / "arm/smurf" / os.fsdecode(b"a\xffb.smurf")).write_text("modelname: [\n")
        self.converts_not_all()

    def test_endings_in_capitals(self):
        """smurf-lint also treats them as models and scenes."""
        self.write("arm.SMURF", "modelname: [\n")
        self.assertEqual(self.try_all("smurf2urdf").returncode, 1)
        self.write("cell.Smurfs", "smurfs: [\n")
        self.assertEqual(self.try_all("smurfs-flatten").returncode, 1)

    def try_all(self, program):
        environment = {**os.environ, "PATH": f"{TOOLS}:{os.environ['PATH']}"}
        return subprocess.run([sys.executable, "-I", ROOT / "python/smurf/try_all.py", program], cwd=self.project,
                              env=environment, capture_output=True, text=True, timeout=600, check=False)

    def converts_not_all(self):
        done = self.try_all("smurf2urdf")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("cannot tell which file is meant", done.stderr)


class Links(StrangerTest):
    """Links below a folder that the user names."""

    def setUp(self):
        super().setUp()
        self.write("r.urdf", urdf("m.stl"))
        self.write("m.stl", MESH)

    def test_copies(self):
        (self.project / "assets").mkdir()
        (self.victim / "m.stl").write_text("mine\n")
        before = self.texts(self.victim)
        (self.project / "assets/r").symlink_to(self.victim)
        done = self.expect(2, "smurfs-flatten", "--format", "sdf", "r.urdf", "--copy-assets", "assets", "-o", "w.sdf")
        self.assertIn("cannot write 'assets/r': it is a symbolic link", done.stderr)
        done = self.expect(2, "smurfs-flatten", "--format", "sdf", "r.urdf", "--copy-assets", "assets", "--overwrite",
                           "-o", "w.sdf")
        self.assertIn("cannot write 'assets/r': it is a symbolic link", done.stderr)
        (self.project / "assets/r").unlink()
        (self.project / "assets/r").mkdir()
        (self.victim / "same.stl").write_text(MESH)
        before = self.texts(self.victim)
        # The message does not reveal whether a file outside exists, or its contents.
        for target in (self.victim / "m.stl", self.victim / "same.stl", self.victim / "new"):
            (self.project / "assets/r/m.stl").symlink_to(target)
            done = self.expect(2, "smurfs-flatten", "--format", "sdf", "r.urdf", "--copy-assets", "assets", "-o", "w.sdf")
            self.assertIn("cannot write 'assets/r/m.stl': it is a symbolic link", done.stderr)
            (self.project / "assets/r/m.stl").unlink()
        self.assertEqual(self.texts(self.victim), before)

    def test_unreadable_mesh_is_no_empty_file(self):
        (self.victim / "m.stl").write_text(MESH)
        (self.project / "m.stl").unlink()
        (self.project / "m.stl").symlink_to(self.victim / "m.stl")
        self.write("assets/r/m.stl", "")
        self.expect(2, "smurfs-flatten", "--force", "--format", "sdf", "r.urdf", "--copy-assets", "assets", "-o", "w.sdf")
        self.assertFalse((self.project / "w.sdf").exists())

    def test_chain_of_material_libraries(self):
        """A material library may only name textures, whatever its name."""
        for i in range(3000):
            self.write(f"c{i}.obj", f"mtllib c{i + 1}.obj\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        self.write("r.urdf", urdf("c0.obj"))
        self.expect(0, "smurfs-flatten", "--force", "--format", "sdf", "r.urdf", "--copy-assets", "assets", "-o", "w.sdf")
        self.assertEqual(sorted(path.name for path in (self.project / "assets").rglob("*.obj")), ["c0.obj", "c1.obj"])

    def test_one_file_with_many_links(self):
        """All of them are refused before their bytes fill the memory."""
        libraries = "".join(f"mtllib l{i}.obj\n" for i in range(200))
        self.write("big.obj", libraries + "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + "f 1 2 3\n" * 100_000)
        for i in range(200):
            (self.project / f"l{i}.obj").symlink_to("big.obj")
        self.write("r.urdf", urdf("big.obj"))
        done = self.expect(2, "smurfs-flatten", "--force", "--format", "sdf", "r.urdf", "--copy-assets", "assets", "-o", "w.sdf",
                           "--limit", "scene-bytes=20000000")
        self.assertIn("have more than 20000000 bytes", done.stderr)

    def test_names_of_files_and_folders(self):
        """Another file has the name of a folder."""
        image = "![](x)"
        self.write("k/m.gltf", '{"asset": {"version": "2.0"}, "images": [{"uri": "../x.png"}, {"uri": "x.png/y.png"}]}')
        self.write("x.png", image)
        self.write("k/x.png/y.png", image)
        self.write("r.urdf", urdf("k/m.gltf"))
        self.expect(0, "smurfs-flatten", "--force", "--format", "sdf", "r.urdf", "--copy-assets", "assets", "-o", "w.sdf")
        self.assertEqual(len([path for path in (self.project / "assets").rglob("*.png") if path.is_file()]), 2)

    def test_copies_replace_no_other_files(self):
        """The scene chooses the names of the folder and of the file."""
        self.write("src.urdf", urdf("assets/m.stl"))
        self.write("assets/m.stl", MESH)
        self.write("user/src/m.stl", "mine\n")
        flatten = ("smurfs-flatten", "--format", "sdf", "../src.urdf", "--copy-assets", ".", "-o", "w.sdf")
        before = self.texts(self.project)
        done = self.expect(2, *flatten, cwd=self.project / "user")
        self.assertIn("cannot write 'src/m.stl': another file is there; see --overwrite", done.stderr)
        self.assertEqual(self.texts(self.project), before)
        self.expect(0, *flatten, "--overwrite", cwd=self.project / "user")
        self.assertEqual((self.project / "user/src/m.stl").read_text(), MESH)
        self.expect(0, *flatten, cwd=self.project / "user")  # the same file may exist

    def test_copies_are_meshes_and_images(self):
        for name in ("main.py", "Makefile", "pre-commit", "m.stl.sh"):
            self.write("src.urdf", urdf(f"assets/{name}"))
            self.write(f"assets/{name}", MESH)
            done = self.expect(2, "smurfs-flatten", "--format", "sdf", "--force", "src.urdf", "--copy-assets", "out",
                               "-o", "w.sdf")
            self.assertIn("its name is not that of a mesh or image", done.stderr)
            self.assertFalse((self.project / "out").exists())

    def test_new_models(self):
        (self.project / "robot").mkdir()
        (self.project / "robot/smurf").symlink_to(self.victim)
        for options in ([], ["--overwrite"]):
            self.expect(2, "urdf2smurf", "r.urdf", "-o", "robot", *options)
            self.assert_unharmed()
            self.assertFalse((self.project / "robot/urdf").exists())
        (self.project / "robot/smurf").unlink()
        (self.project / "robot/smurf").mkdir()
        for target in (self.victim / "mine", self.victim / "new"):
            (self.project / "robot/smurf/r.smurf").symlink_to(target)
            self.expect(2, "urdf2smurf", "r.urdf", "-o", "robot", "--overwrite")
            self.assert_unharmed()
            (self.project / "robot/smurf/r.smurf").unlink()

    def test_the_users_own_folder_and_file_may_be_links(self):
        """Outside and inside of a repository."""
        (self.folder / "elsewhere").mkdir()
        (self.folder / "robot").symlink_to(self.folder / "elsewhere")
        self.expect(0, "urdf2smurf", "r.urdf", "-o", "../robot")
        self.assertTrue((self.folder / "elsewhere/smurf/r.smurf").is_file())
        (self.folder / "w.sdf").symlink_to(self.victim / "mine")
        self.expect(0, "smurfs-flatten", "--format", "sdf", "r.urdf", "--copy-assets", "../robot", "-o", "../w.sdf")
        self.assertTrue((self.folder / "elsewhere/r/m.stl").is_file())
        self.assertTrue((self.folder / "w.sdf").is_symlink())
        self.assertIn("<sdf", (self.victim / "mine").read_text())
        self.write("results/old.urdf", "old\n")
        (self.project / "latest.urdf").symlink_to("results/old.urdf")
        self.expect(0, "smurf2urdf", "r.urdf", "-o", "latest.urdf")
        self.assertIn("<robot", (self.project / "results/old.urdf").read_text())

    def test_links_of_repositories_of_other_kinds(self):
        shutil.rmtree(self.project / ".git")
        (self.project / "out").symlink_to("../victim/mine")
        for kept in (".hg", ".svn"):
            (self.project / kept).mkdir()
            self.expect(2, "smurf2urdf", "r.urdf", "-o", "out")
            self.assert_unharmed()
            (self.project / kept).rmdir()

    def test_links_of_a_repository_that_lead_out_of_it(self):
        """For example, under the name of a report that CI writes."""
        self.write(".git/hooks/pre-push", "#!/bin/sh\n")
        before = self.texts(self.project)
        for name, target in (("out", self.victim / "mine"), ("out", self.victim / "new"), ("out", "../victim/mine"),
                             ("out", "a"), ("out", ".git/hooks/pre-push"), ("dir/out", None), ("robot", self.victim)):
            (self.project / "a").symlink_to("../victim/mine")
            link = self.project / (name if target else "dir")
            link.symlink_to(target or self.victim)
            jobs = [("smurf2urdf", "r.urdf", "-o", name), ("smurf-lint", "--format", f"json={name}", "r.urdf"),
                    ("smurfs-flatten", "r.urdf", "-o", name), ("urdf2smurf", "r.urdf", "--overwrite", "-o", name)]
            for job in jobs[3:] if name == "robot" else jobs:
                with self.subTest(job, target=str(target)):
                    done = self.expect(2, *job)
                    self.assertIn("is a link that leads out of its repository", done.stderr)
                    self.assert_unharmed()
            link.unlink()
            (self.project / "a").unlink()
            self.assertEqual(self.texts(self.project), before)


class Inputs(StrangerTest):
    """No output replaces an input: every option that writes, with every input."""

    MODEL = ["arm/smurf/arm.smurf", "arm/urdf/arm.urdf", "arm/smurf/arm_motors.yml", "arm/meshes/forearm.obj"]

    def setUp(self):
        super().setUp()
        shutil.copytree(FIXTURES / "models/arm", self.project / "arm")
        self.write("s.smurfs", "smurfs:\n- {name: a, file: arm/smurf/arm.smurf, type: smurf, anchor: world}\n")
        self.write(".smurf-lint.yaml", "fail-on: never\n")
        self.write("report.json", "{}")

    def refuse(self, tool, arguments, option, victims, code=2):
        for victim in victims:
            os.link(self.project / victim, self.project / "other_name")
            (self.project / "link").symlink_to(victim)
            names = (victim, self.project / victim, "other_name", "link") if option == "-o" else (victim,)
            for name in names:
                before = self.texts(self.project)
                with self.subTest(tool, option=option, victim=str(name)):
                    value = [option + str(name)] if option.endswith("=") else [option, name]
                    done = self.expect(code, tool, *arguments, *value, "--", *self.inputs)
                    self.assertIn("is an input of this run", done.stderr)
                    self.assertEqual(self.texts(self.project), before)
            (self.project / "other_name").unlink()
            (self.project / "link").unlink()

    def test_smurf_lint(self):
        self.inputs = ["arm"]
        for option in ("-o", "--format=json=", "--format=sarif="):
            self.refuse("smurf-lint", [], option, [*self.MODEL, ".smurf-lint.yaml"])
        self.refuse("smurf-lint", ["--fix"], "-o", self.MODEL[:1])
        self.refuse("smurf-lint", ["--list-files"], "-o", self.MODEL[:1])
        self.refuse("smurf-lint", ["--generate-baseline"], "--baseline", self.MODEL[:2])
        self.inputs = []
        self.refuse("smurf-lint", ["--show-config", "arm"], "-o", [".smurf-lint.yaml"])
        self.refuse("smurf-lint", ["--dump-model", self.MODEL[0]], "-o", self.MODEL[:1])

    def test_smurf2urdf(self):
        self.inputs = ["arm/smurf/arm.smurf"]
        for option in ("-o", "--srdf", "--loss-report", "--report=json="):
            self.refuse("smurf2urdf", [], option, self.MODEL)
        self.refuse("smurf2urdf", ["--loss-report", "lost.json"], "-o", self.MODEL[:1])
        self.assertFalse((self.project / "lost.json").exists())

    def test_urdf2smurf(self):
        self.inputs = ["arm/urdf/arm.urdf"]
        self.refuse("urdf2smurf", ["-o", "new"], "--report=json=", ["arm/urdf/arm.urdf"])
        before = self.texts(self.project)
        self.expect(2, "urdf2smurf", "arm/urdf/arm.urdf", "-o", "arm/urdf", "--flat", "--overwrite")
        self.expect(2, "urdf2smurf", "arm/urdf/arm.urdf", "-o", "arm", "--overwrite")
        self.assertEqual(self.texts(self.project), before)
        self.expect(0, "urdf2smurf", "arm/urdf/arm.urdf", "--in-place")

    def test_smurfs_flatten(self):
        self.inputs = ["s.smurfs"]
        for option in ("-o", "--report=json="):
            self.refuse("smurfs-flatten", ["--format", "sdf"], option, ["s.smurfs", *self.MODEL])
        for arguments in (["--compare-dialects"], ["--explain-pose", "a"]):
            self.refuse("smurfs-flatten", arguments, "-o", ["s.smurfs"])

    def test_smurf_load_check(self):
        arguments = ["--time", "0.01", "--stages", "still"]
        self.inputs = ["s.smurfs"]
        for option in ("-o", "--trace", "--report=json="):
            self.refuse("smurf-load-check", arguments, option, ["s.smurfs", self.MODEL[0]])

    def test_copies(self):
        """The mesh of one model would replace the mesh of another one."""
        self.write("a.urdf", urdf("a/m.stl", "a/b/m.stl"))
        self.write("a/m.stl", MESH)
        self.write("a/b/m.stl", MESH.replace("solid a", "solid b"))
        before = self.texts(self.project)
        self.expect(0, "smurfs-flatten", "--format", "sdf", "a.urdf", "--copy-assets", ".", "-o", "w.sdf")
        self.assertEqual({p: t for p, t in self.texts(self.project).items() if p in before}, before)
        self.assertEqual((self.project / "a/2/m.stl").read_text(), MESH.replace("solid a", "solid b"))
        # Another file of the run, which has this name by chance.
        self.write("b.smurf", "modelname: b\nfiles: [b.urdf, b/r.yml]\n")
        self.write("b.urdf", urdf("a/b/r.yml"))
        self.write("a/b/r.yml", MESH)
        self.write("b/r.yml", "{}\n")
        before = self.texts(self.project)
        done = self.expect(2, "smurfs-flatten", "--force", "--format", "sdf", "b.smurf", "--copy-assets", ".", "-o", "w.sdf")
        self.assertIn("'b/r.yml' is an input of this run", done.stderr)
        self.assertEqual(self.texts(self.project), before)

    def test_standard_input(self):
        self.write("in.urdf", urdf())
        with (self.project / "in.urdf").open() as file:
            done = subprocess.run([TOOLS / "smurf-lint", "-o", "in.urdf", "-"], stdin=file, cwd=self.project, timeout=600,
                                  capture_output=True, check=False)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual((self.project / "in.urdf").read_text(), urdf())


class Fixes(StrangerTest):
    """A stranger chooses the name in a suggestion, so it must stay a name."""

    def test_suggested_names(self):
        links = ("ba'se", "ba&quot;se", "ba]se", "*base", "ba#se", "ba: se", "ba&#10;se: {x", "ba&lt;se")
        for link in links:
            for place in ("link: base", "link: 'base'", 'link: "base"', "{name: x, link: base}"):
                with self.subTest(link=link, place=place):
                    self.write("r.urdf", f'<robot name="r"><link name="{link}"/></robot>')
                    entry = place if place.startswith("{") else f"name: x\n  {place}"
                    self.write("s.yml", f"sensors:\n- {entry}\n")
                    self.write("m.smurf", "modelname: r\nfiles: [r.urdf, s.yml]\n")
                    self.run_tool("smurf-lint", "--fix", "--unsafe-fixes", "-q", "m.smurf")
                    done = self.run_tool("smurf-lint", "--format", "concise", "--no-ignores", "m.smurf")
                    self.assertNotRegex(done.stdout, r"SML00\d\d|SML100\d")

    def test_names_of_files(self):
        for name in ("mod'l.urdf", 'mod"l.urdf', "mod #l.urdf", "mod]l.urdf"):
            for place in ("[modl.urdf]", "['modl.urdf']", '["modl.urdf"]'):
                with self.subTest(name=name, place=place):
                    shutil.rmtree(self.project)
                    self.write(name, urdf())
                    self.write("m.smurf", f"modelname: r\nfiles: {place}\n")
                    self.run_tool("smurf-lint", "--fix", "--unsafe-fixes", "-q", "m.smurf")
                    done = self.run_tool("smurf-lint", "--format", "concise", "m.smurf")
                    self.assertNotIn("SML001", done.stdout)

    def test_keys_that_are_there(self):
        """A key is never renamed to a key that exists in its mapping, even without a value, or that another fix creates."""
        urdf_of_one_joint = ('<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="continuous">'
                             '<parent link="a"/><child link="b"/><axis xyz="0 0 1"/></joint></robot>')
        motor = "motors:\n- {{name: j, joint: j, type: PID, maxEffort: 1, {}}}\n"
        sensor = "sensors:\n- {{name: s, type: NodePosition, link: a, {}}}\n"
        for name, text in (("m.smurf", "modelname: r\nfiles:\n-files:\n- r.urdf\n- s.yml\n"),
                           ("m.smurf", "modelname: r\nfiles:\nfile: [r.urdf, s.yml]\n"),
                           ("s.yml", motor.format("maxSpeed: , maxSped: 1")),
                           ("s.yml", motor.format("maxSped: 1, maxSpeeed: 1")),
                           ("s.yml", motor.format("maxSpeed: 1, minVale: 0, minValu: 1")),
                           ("s.yml", sensor.format("id: , targets: [a]")),
                           ("s.yml", sensor.format("id: [], targets: [a]")),
                           ("s.yml", "joint:\n- {name: j}\njoints:\n- {name: j}\n"),
                           ("s.yml", "motor:\n- {name: j, joint: j}\nmotors:\n- {name: k, joint: j}\n"),
                           (".smurf-lint.yaml", "select: \nselct: [SML]\nignor: []\nignre: []\n"),
                           ("s.smurfs", "lights: \nlihgts: []\nentites: []\nentitis: []\n"),
                           ("s.smurfs", "entities:\n- {name: e, type: urdf, file: , fiel: r.urdf}\n"),
                           ("s.smurfs", "entities:\n- {name: e, type: urdf, file: , URI: r.urdf}\n"),
                           ("s.smurfs", "entities:\n- {name: e, type: heightmap, fiel: h.png, URI: h.png}\n"),
                           ("s.yml", "motor:\n- {name: k, joint: j}\nmotrs:\n- {name: l, joint: j}\n"),
                           ("s.yml", "joints:\n- {name: j}\njiont:\n- {name: j}\n"),
                           ("s.smurfs", "entities:\n- {name: e, file: r.urdf, rpy: {x: 0}, orientation: {x: 0}}\n")):
            with self.subTest(text=text):
                shutil.rmtree(self.project)
                self.write("r.urdf", urdf_of_one_joint)
                self.write("s.yml", "motors: []\n")
                self.write("m.smurf", "modelname: r\nfiles: [r.urdf, s.yml]\n")
                self.write(name, text)
                self.run_tool("smurf-lint", "--fix", "--unsafe-fixes", "-q", ".")
                done = self.run_tool("smurf-lint", "--format", "concise", "--no-ignores", ".")
                self.assertNotIn("SML0011", done.stdout)

    def test_fixes_that_leave_yaml_and_xml(self):
        """A readable file is still readable after all fixes."""
        robot = '<robot name="r"><link name="b"/>{}</robot>'
        for name, text in (
                ("r.urdf", "<!-- smurf-lint: ignore[SML3101] -->" + robot.format("")),
                ("s.yml", "  # smurf-lint: ignore[SML3101]\nmotors: []\n"),
                ("r.urdf", robot.format('<link name=" x&quot;/&gt;&lt;link name=&quot;y "/>')),
                ("r.urdf", robot.format('<link name=" a&quot;b&amp;lt;c "/>')),
                ("r.urdf", robot.format('<link name="b "/><joint name="j" type="fixed"><parent link="b"/>'
                                        '<child link="b "/></joint>')),
                ("r.urdf", robot.format('<link name="c "/><link name=" c"/>')),
                ("r.urdf", robot.format('<gazebo refrence="b" referense="b"><mu1>1</mu1></gazebo>')),
                ("r.urdf", robot.format('<link nam="c" nme="d"/>')),
                ("s.yml", "? |-\n  motrs\n: \n- {name: m, joint: j}\n"),
                ("s.yml", "? >-\n  motrs\n: \n- {name: m, joint: j}\n"),
                ("s.yml", "poses: [] # smurf-lint: ignore[SML3101]\u0085motors: [{name: m, joint: j}]\n"),
                ("s.yml", 'motors:\n- name: m\n  type: |-\n    PDI\n'),
                (".smurf-lint.yaml", "targets:\n- |-\n  rso\n")):
            with self.subTest(text=text):
                shutil.rmtree(self.project)
                self.write("r.urdf", urdf())
                self.write("s.yml", "motors: []\n")
                self.write("m.smurf", "modelname: r\nfiles: [r.urdf, s.yml]\n")
                self.write(name, text)
                self.run_tool("smurf-lint", "--fix", "--unsafe-fixes", "-q", ".")
                done = self.run_tool("smurf-lint", "--format", "concise", "--no-ignores", ".")
                self.assertNotRegex(done.stdout, r"SML00\d\d|SML100\d|SML1301")
                fixed = (self.project / name).read_text()
                for part in ("<link ", "motors:"):
                    self.assertEqual(fixed.count(part), text.count(part))


class Exchanges(StrangerTest):
    """Folders that become links while a tool runs."""

    def test_the_folder_of_a_result(self):
        self.write("r.urdf", urdf())
        (self.project / "out").mkdir()
        (self.project / "other").symlink_to("../victim")
        exchange = ctypes.CDLL(None).syscall  # renameat2 with RENAME_EXCHANGE
        is_over = threading.Event()

        def exchange_all_the_time():
            while not is_over.is_set():
                exchange(316, -100, os.fsencode(self.project / "out"), -100, os.fsencode(self.project / "other"), 2)

        thread = threading.Thread(target=exchange_all_the_time)
        thread.start()
        try:
            for tool, *arguments in (["smurf-lint", "--format", "json", "-o", "out/o.json", "r.urdf"],
                                     ["smurf2urdf", "-o", "out/o.urdf", "r.urdf"],
                                     ["urdf2smurf", "--overwrite", "-o", "out", "r.urdf"]):
                for _ in range(60):
                    self.run_tool(tool, "-q", *arguments)
                    self.assert_unharmed()
        finally:
            is_over.set()
            thread.join()


class Searches(StrangerTest):
    """A link in a searched folder reveals nothing about files outside."""

    def setUp(self):
        super().setUp()
        self.write("r.urdf", urdf())
        self.write(".hidden/in.urdf", urdf())
        (self.project / "inside.urdf").symlink_to(".hidden/../r.urdf")

    def said(self):
        """For each tool, both if the folder outside is missing and if it exists."""
        for arguments in (["smurf-lint", "."], ["smurf-lint", "--list-files", "."], ["smurf-load-check", "--time", "0.01", "."]):
            runs = [self.run_tool(*arguments)]
            (self.folder / "out/deep").mkdir(parents=True)
            runs.append(self.run_tool(*arguments))
            shutil.rmtree(self.folder / "out")
            yield arguments, [(run.returncode, run.stdout, run.stderr) for run in runs]

    def test_ways_through_a_folder_outside(self):
        for way in ("../out/deep/../../project", self.folder / "out/deep/../../project",
                    "/proc/self/cwd/../out/deep/../../project"):
            for name, target in (("link.urdf", "r.urdf"), ("link.urdf", "gone.urdf"), ("link", ".hidden")):
                link = self.project / name
                link.symlink_to(f"{way}/{target}")
                for arguments, (missing, there) in self.said():
                    with self.subTest(arguments=arguments, way=way, name=name, target=target):
                        self.assertEqual(missing, there)
                link.unlink()


class Permissions(StrangerTest):
    def test_mode_and_owner_without_privileges(self):
        self.write("r.urdf", urdf())
        report = self.project / "report.json"
        for mode in (0o4755, 0o2755, 0o1644, 0o640, 0o444):
            report.write_text("old")
            if os.geteuid() == 0:
                os.chown(report, 65534, 65534)
            report.chmod(mode)
            self.expect(0, "smurf-lint", "--format", "json=report.json", "r.urdf")
            status = report.stat()
            self.assertEqual(stat.S_IMODE(status.st_mode), mode & 0o777)
            if os.geteuid() == 0:
                self.assertEqual((status.st_uid, status.st_gid), (65534, 65534))
            report.unlink()

    def test_killed_by_a_limit_no_more(self):
        self.write("r.urdf", urdf())

        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_DFL)
            resource.setrlimit(resource.RLIMIT_FSIZE, (10, 10))

        done = self.expect(2, "smurf-lint", "--format", "json=report.json", "r.urdf", preexec_fn=limit)
        self.assertIn("File too large", done.stderr)
        self.assertEqual(sorted(path.name for path in self.project.iterdir()), [".git", "r.urdf"])


class CurrentFolder(StrangerTest):
    def test_it_is_gone(self):
        self.write("r.urdf", urdf())
        self.write("s.smurfs", WARNED)
        absolute = self.project
        for tool, arguments in {"smurf2urdf": [absolute / "r.urdf"],
                                "urdf2smurf": [absolute / "r.urdf", "-o", absolute / "out"],
                                "smurfs-flatten": [absolute / "r.urdf"],
                                "smurf-lint": ["."], "smurf-load-check": ["."]}.items():
            with self.subTest(tool):
                script = 'mkdir gone; cd gone; rmdir ../gone; exec "$@"'
                done = subprocess.run(["sh", "-c", script, "sh", TOOLS / tool, *arguments], cwd=self.folder, timeout=600,
                                      capture_output=True, encoding="utf-8", check=False)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertTrue(done.stderr.startswith(tool + ": "), done.stderr)


class Action(StrangerTest):
    def test_paths(self):
        text = (ROOT / "action.yml").read_text()
        script = text[text.rindex("run: |") + 6:].replace("\n      ", "\n")
        tool = self.folder / "smurf-tools/smurf-lint"
        tool.parent.mkdir()
        tool.write_text("#!/bin/sh\nprintf '%s\\n' \"$@\"\n")
        tool.chmod(0o755)
        head = ["--format", "github", "--format", f"full={self.folder}/smurf-lint.txt", "--fail-on=error"]
        for paths, wanted in {"robots models": ["robots", "models"], "one folder\nmore\n": ["one folder", "more"],
                              "--output=x": ["--output=x"], "a\n\n-ox\n": ["a", "-ox"], "": [],
                              "a b\n": ["a", "b"]}.items():
            done = subprocess.run(["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", script], cwd=self.project,
                                  env={"PATH": os.environ["PATH"], "RUNNER_TEMP": str(self.folder), "PATHS": paths,
                                       "FAIL_ON": "error", "SARIF": "", "TARGETS": ""},
                                  capture_output=True, text=True, timeout=600, check=False)
            self.assertEqual((done.returncode, done.stdout.splitlines()), (0, [*head, "--", *wanted]), done.stderr)

    def test_a_package_is_an_input(self):
        """It decides which files a model may name."""
        self.write("p/package.xml", "<package><name>p</name></package>\n")
        self.write("p/m.stl", MESH)
        self.write("p/a.urdf", urdf("package://p/m.stl"))
        (self.project / "out").symlink_to("p/package.xml")
        for output in ("out", "p/package.xml"):
            done = self.expect(2, "smurf-lint", "-o", output, "p/a.urdf")
            self.assertIn("is an input of this run", done.stderr)
            self.assertEqual((self.project / "p/package.xml").read_text(), "<package><name>p</name></package>\n")

    def test_try_all_runs_nothing_of_the_checkout(self):
        """Neither a program in the current folder nor a module, whatever the variables of a shell say."""
        for name in ("smurf-lint", "smurf2urdf", "smurf-lint.exe"):
            self.write(name, "#!/bin/sh\ntouch hacked\n")
            (self.project / name).chmod(0o755)
        for name in ("encodings.py", "sitecustomize.py", "subprocess.py", "runpy.py"):
            self.write(name, "open('hacked', 'w')\n")
        self.write("r.urdf", urdf())
        self.write("r.smurf", "modelname: r\nfiles: [r.urdf]\n")
        script = ROOT / "python/smurf/try_all.py"
        for path in ("", ".", f".{os.pathsep}{self.project.name}"):
            variables = {**os.environ, "PYTHONPATH": ".", "PYTHONSTARTUP": "sitecustomize.py",
                         "PATH": os.pathsep.join([path, str(TOOLS), os.environ["PATH"]])}
            done = subprocess.run([script, "smurf2urdf"], cwd=self.project, env=variables, capture_output=True, text=True,
                                  check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertFalse((self.project / "hacked").exists())
        done = subprocess.run([script, "smurf2urdf"], cwd=self.project, env={**os.environ, "PATH": f".{os.pathsep}/usr/bin"},
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn("smurf-lint is not on PATH", done.stderr)
        self.assertFalse((self.project / "hacked").exists())

    def test_operands_are_no_options(self):
        self.write("--output=x.urdf", urdf())
        for tool in ("smurf-lint", "smurfs-flatten", "smurf2urdf"):
            before = self.texts(self.project)
            self.run_tool(tool, "--", "--output=x.urdf")
            self.assertEqual(self.texts(self.project), before)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(f"usage: {sys.argv[0]} FOLDER_OF_TOOLS [unittest option]...")
    TOOLS = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
