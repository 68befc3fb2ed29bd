# SPDX-License-Identifier: BSD-3-Clause
"""The hooks of .pre-commit-hooks.yaml, run by the real pre-commit in a repository with a broken and a sound model.

usage: pre_commit_test.py FOLDER_OF_TOOLS
"""
import functools
import http.server
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import threading
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "packages"))
from local_release import PROGRAMS, ROOT, add_release, copy_of_project  # noqa: E402

TOOLS = None
CONFIG = """repos:
- repo: {hooks}
  rev: v1
  hooks:
  - id: smurf-lint{suffix}
  - id: smurf-lint-fix{suffix}
    stages: [manual]
  - id: smurf2urdf-check{suffix}
  - id: smurf-flatten-check{suffix}
"""
# As in docs/integrations.md.
CHANGED_ONLY = """- repo: {hooks}
  rev: v1
  hooks:
  - id: smurf-lint{suffix}
    alias: changed
    args: [--only-listed, --]
    pass_filenames: true
    always_run: false
    files: \\.(smurf|smurfs|smurfa|urdf|yml|yaml|stl|obj|dae|bobj)$
    require_serial: true
"""


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *arguments):
        pass


class Hooks:
    """The hooks with a suffix; a subclass for each family defines how their programs are found."""

    suffix = ""

    @classmethod
    def setUpClass(cls):
        cls.shared = pathlib.Path(tempfile.mkdtemp(prefix="smurf-hooks-"))
        cls.addClassCleanup(shutil.rmtree, cls.shared, ignore_errors=True)
        keep = {name: value for name, value in os.environ.items() if not name.startswith(("SMURF_", "PIP_", "PYTHON"))}
        cls.environment = keep | {
            "HOME": str(cls.shared), "PRE_COMMIT_HOME": str(cls.shared / "cache"), "PIP_NO_INDEX": "1",
            "GIT_AUTHOR_NAME": "a", "GIT_AUTHOR_EMAIL": "a@b", "GIT_COMMITTER_NAME": "a", "GIT_COMMITTER_EMAIL": "a@b",
            "GIT_CONFIG_GLOBAL": "/dev/null", "GIT_CONFIG_SYSTEM": "/dev/null"}
        cls.hooks = cls.repository(cls.shared / "hooks")
        copy_of_project(cls.hooks)
        cls.prepare()
        cls.commit(cls.hooks)
        cls.git(cls.hooks, "tag", "v1")

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="smurf-robots-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.robots = self.repository(self.folder / "robots")
        shutil.copytree(ROOT / "fixtures/models/arm", self.robots / "arm")
        shutil.copytree(ROOT / "fixtures/scenes/nested", self.robots / "cell")
        (self.robots / "ci.yml").write_text("motors: this file is not one of ours\n")
        (self.robots / ".pre-commit-config.yaml").write_text(CONFIG.format(hooks=self.hooks, suffix=self.suffix))
        self.commit(self.robots)
        self.assertEqual(self.call(self.robots, "pre-commit", "install").returncode, 0)

    @classmethod
    def repository(cls, folder):
        folder.mkdir()
        cls.git(folder, "init", "-q", "-b", "main")
        return folder

    @classmethod
    def call(cls, folder, *command):
        return subprocess.run(command, cwd=folder, env=cls.environment, capture_output=True, text=True, timeout=300,
                              check=False)

    @classmethod
    def git(cls, folder, *arguments):
        done = cls.call(folder, "git", *arguments)
        if done.returncode != 0:
            raise AssertionError(done.stdout + done.stderr)

    @classmethod
    def commit(cls, folder):
        cls.git(folder, "add", "-A")
        cls.git(folder, "commit", "-q", "--no-verify", "-m", "all")

    def try_commit(self):
        self.git(self.robots, "add", "-A")
        return self.call(self.robots, "git", "commit", "-m", "change")

    def hook(self, name, *options):
        return self.call(self.robots, "pre-commit", "run", *options, "--all-files", name + self.suffix)

    def change(self, path, old, new):
        path = self.robots / path
        text = path.read_text()
        self.assertIn(old, text)
        path.write_text(text.replace(old, new, 1))

    def test_all_files_are_sound(self):
        done = self.call(self.robots, "pre-commit", "run", "--all-files")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual(done.stdout.count("Passed"), 3, done.stdout)

    def test_a_change_of_an_annotation_file_only(self):
        self.change("arm/smurf/arm_motors.yml", "joint: joint3_elbow", "joint: joint3_elbwo")
        done = self.try_commit()
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("error[SML3101]", done.stdout + done.stderr)
        self.change("arm/smurf/arm_motors.yml", "joint: joint3_elbwo", "joint: joint3_elbow  # checked")
        done = self.try_commit()
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_a_change_of_a_mesh_only(self):
        self.change("arm/urdf/arm.urdf", '<child link="turret"/>', '<child link="turet"/>')
        self.commit(self.robots)
        mesh = self.robots / "arm/meshes/forearm.obj"
        mesh.write_text(mesh.read_text() + "# one more line\n")
        done = self.try_commit()
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("error[SML1201]", done.stdout + done.stderr)

    def test_changed_files_only(self):
        config = self.robots / ".pre-commit-config.yaml"
        config.write_text("repos:\n" + CHANGED_ONLY.format(hooks=self.hooks, suffix=self.suffix))
        self.change("arm/urdf/arm.urdf", '<child link="turret"/>', '<child link="turet"/>')
        self.commit(self.robots)
        self.change("ci.yml", "this file", "still this file")
        self.change("arm/meshes/forearm.obj", "\n", "\n# one more line\n")
        self.git(self.robots, "add", "-A")
        done = self.call(self.robots, "pre-commit", "run", "changed")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("error[SML1201]", done.stdout)
        self.assertNotIn("ci.yml", done.stdout)

    def test_a_mesh_that_is_deleted(self):
        """The commit breaks a model that it does not contain."""
        (self.robots / "arm/meshes/forearm.obj").unlink()
        done = self.try_commit()
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("error[SML1604]", done.stdout + done.stderr)

    def test_a_model_that_cannot_be_exported(self):
        self.change("arm/urdf/arm.urdf", '<child link="turret"/>', '<child link="turet"/>')
        done = self.hook("smurf2urdf-check")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("SML1201", done.stdout)

    def test_fixes(self):
        mount = '<joint name="pedestal_mount" type="fixed">'
        unused = '<limit effort="1" velocity="1"/>'
        self.change("arm/urdf/arm.urdf", mount, mount + "<dynamics/>" + unused)
        self.git(self.robots, "add", "-A")
        done = self.hook("smurf-lint-fix", "--hook-stage", "manual")
        self.assertIn("fixed 1 finding", done.stdout)
        fixed = (self.robots / "arm/urdf/arm.urdf").read_text()
        self.assertTrue(mount + unused in fixed, "deletes `<dynamics/>`; to delete the limit is no safe fix")

    def test_names_are_no_options(self):
        """A folder of the repository with a name like an option, which contains a path outside."""
        outside = self.folder / "outside"
        outside.mkdir()
        for option in ("--output=", "--config=", "--baseline=", "-o"):
            for name in ("victim.yml", "victim.smurfs"):
                (outside / name).write_text("mine\n")
                place = self.robots / (option + str(outside)) / name
                place.parent.mkdir(parents=True, exist_ok=True)
                place.write_text((self.robots / "cell/outer.smurfs").read_text() if name.endswith("s") else "a: 1\n")
        config = self.robots / ".pre-commit-config.yaml"
        config.write_text(config.read_text() + CHANGED_ONLY.format(hooks=self.hooks, suffix=self.suffix))
        self.git(self.robots, "add", "-A")
        for stage in ("pre-commit", "manual"):
            self.call(self.robots, "pre-commit", "run", "--hook-stage", stage, "--all-files")
        self.assertEqual({path.name: path.read_text() for path in outside.iterdir()},
                         {"victim.yml": "mine\n", "victim.smurfs": "mine\n"})

    def test_a_file_of_no_model(self):
        self.change("ci.yml", "this file", "still this file")
        done = self.try_commit()
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_a_scene_that_does_not_expand(self):
        self.change("cell/outer.smurfs", '"Base::flange"', '"Base::flansch"')
        done = self.hook("smurf-flatten-check")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("SML5101", done.stdout)


class InstalledPrograms(Hooks, unittest.TestCase):
    suffix = "-system"

    @classmethod
    def prepare(cls):
        cls.environment["PATH"] = f"{TOOLS}:{cls.environment['PATH']}"


class NothingInstalled(Hooks, unittest.TestCase):
    """The programs come from a release, by HTTP from this machine."""

    @classmethod
    def prepare(cls):
        for program in PROGRAMS:
            if found := shutil.which(program, path=cls.environment["PATH"]):
                raise unittest.SkipTest(f"SKIPPED: {found} is on the PATH")
        release = cls.shared / "release"
        release.mkdir()
        add_release(cls.hooks, release, TOOLS)
        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=release))
        cls.addClassCleanup(server.server_close)
        cls.addClassCleanup(server.shutdown)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        cls.environment["SMURF_RELEASES"] = f"http://127.0.0.1:{server.server_address[1]}"

    def test_the_line_of_the_readme(self):
        line = re.search(r"\n    (repos: \[.*)\n", (ROOT / "README.md").read_text())[1]
        self.git(self.hooks, "tag", "-f", re.search(r"rev: (\S+),", line)[1])
        url = re.search(r'"(https:.*?)"', line)[1]
        (self.robots / ".pre-commit-config.yaml").write_text(line.replace(url, str(self.hooks)))
        self.git(self.robots, "add", "-A")
        done = self.call(self.robots, "pre-commit", "run")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        (self.robots / "arm/meshes/forearm.obj").unlink()
        self.git(self.robots, "add", "-A")
        done = self.call(self.robots, "pre-commit", "run")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("error[SML1604]", done.stdout)


if __name__ == "__main__":
    if shutil.which("pre-commit") is None:
        print("SKIPPED: pre-commit is not installed (scripts/setup --readers)")
        sys.exit(77)
    TOOLS = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
