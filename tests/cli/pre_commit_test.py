# SPDX-License-Identifier: BSD-3-Clause
"""The hooks of .pre-commit-hooks.yaml, run by the real pre-commit in a repository with a broken and a sound model.

usage: pre_commit_test.py FOLDER_OF_TOOLS
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
TOOLS = None
CONFIG = """repos:
- repo: {hooks}
  rev: v1
  hooks:
  - id: smurf-lint
  - id: smurf-lint-fix
    stages: [manual]
  - id: smurf-flatten-check
"""


class PreCommit(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="smurf-hooks-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.environment = os.environ | {
            "PATH": f"{TOOLS}:{os.environ['PATH']}", "PRE_COMMIT_HOME": str(self.folder / "cache"),
            "GIT_AUTHOR_NAME": "a", "GIT_AUTHOR_EMAIL": "a@b", "GIT_COMMITTER_NAME": "a", "GIT_COMMITTER_EMAIL": "a@b",
            "GIT_CONFIG_GLOBAL": "/dev/null", "GIT_CONFIG_SYSTEM": "/dev/null"}
        hooks = self.repository("hooks")
        shutil.copy(ROOT / ".pre-commit-hooks.yaml", hooks)
        self.commit(hooks)
        self.git(hooks, "tag", "v1")
        self.robots = self.repository("robots")
        shutil.copytree(ROOT / "fixtures/models/arm", self.robots / "arm")
        shutil.copytree(ROOT / "fixtures/scenes/nested", self.robots / "cell")
        (self.robots / "ci.yml").write_text("motors: this file is none of ours\n")
        (self.robots / ".pre-commit-config.yaml").write_text(CONFIG.format(hooks=hooks))
        self.commit(self.robots)
        self.assertEqual(self.call(self.robots, "pre-commit", "install").returncode, 0)

    def repository(self, name):
        folder = self.folder / name
        folder.mkdir()
        self.git(folder, "init", "-q", "-b", "main")
        return folder

    def call(self, folder, *command):
        return subprocess.run(command, cwd=folder, env=self.environment, capture_output=True, text=True, timeout=300,
                              check=False)

    def git(self, folder, *arguments):
        done = self.call(folder, "git", *arguments)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def commit(self, folder):
        self.git(folder, "add", "-A")
        self.git(folder, "commit", "-q", "--no-verify", "-m", "all")

    def try_commit(self):
        self.git(self.robots, "add", "-A")
        return self.call(self.robots, "git", "commit", "-m", "change")

    def change(self, path, old, new):
        path = self.robots / path
        text = path.read_text()
        self.assertIn(old, text)
        path.write_text(text.replace(old, new, 1))

    def test_all_files_are_sound(self):
        done = self.call(self.robots, "pre-commit", "run", "--all-files")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual(done.stdout.count("Passed"), 2, done.stdout)

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
        self.assertIn("error[SML1202]", done.stdout + done.stderr)

    def test_fixes(self):
        mount = '<joint name="pedestal_mount" type="fixed">'
        self.change("arm/urdf/arm.urdf", mount, mount + "<dynamics/>")
        self.git(self.robots, "add", "-A")
        done = self.call(self.robots, "pre-commit", "run", "--hook-stage", "manual", "--all-files", "smurf-lint-fix")
        self.assertIn("fixed 2 findings", done.stdout)
        self.assertNotIn("<dynamics/>", (self.robots / "arm/urdf/arm.urdf").read_text())

    def test_names_are_no_options(self):
        """A folder of the repository that is called like an option, with a path outside in it."""
        outside = self.folder / "outside"
        outside.mkdir()
        for option in ("--output=", "--config=", "--baseline=", "-o"):
            for name in ("victim.yml", "victim.smurfs"):
                (outside / name).write_text("mine\n")
                place = self.robots / (option + str(outside)) / name
                place.parent.mkdir(parents=True, exist_ok=True)
                place.write_text((self.robots / "cell/outer.smurfs").read_text() if name.endswith("s") else "a: 1\n")
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
        done = self.call(self.robots, "pre-commit", "run", "--all-files", "smurf-flatten-check")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("SML5101", done.stdout)


if __name__ == "__main__":
    if shutil.which("pre-commit") is None:
        print("SKIPPED: pre-commit is not installed (scripts/setup --readers)")
        sys.exit(77)
    TOOLS = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main()
