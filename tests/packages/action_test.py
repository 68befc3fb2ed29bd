# SPDX-License-Identifier: BSD-3-Clause
"""The steps of action.yml, run as a runner does, with nothing of ours on the PATH.

usage: action_test.py FOLDER_OF_TOOLS
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from local_release import ROOT, add_release, copy_of_project

TOOLS = None


class Action(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="smurf-action-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        for name in ("action", "release", "temporary", "work"):
            (self.folder / name).mkdir()
        (self.folder / "work/.git").mkdir()  # as actions/checkout leaves it
        copy_of_project(self.folder / "action")
        self.archive = add_release(self.folder / "action", self.folder / "release", TOOLS)
        shutil.copytree(ROOT / "fixtures/models/arm", self.folder / "work/robots/arm")
        self.action = yaml.safe_load((ROOT / "action.yml").read_text())

    def run_action(self, **inputs):
        """The exit code and output of the step that fails, or of the last."""
        values = {name: row["default"] for name, row in self.action["inputs"].items()} | inputs
        environment = {
            "PATH": "/usr/bin:/bin", "HOME": str(self.folder / "temporary"), "GITHUB_ACTIONS": "true",
            "GITHUB_ACTION_PATH": str(self.folder / "action"), "RUNNER_TEMP": str(self.folder / "temporary"),
            "GITHUB_PATH": str(self.folder / "path"), "GITHUB_STEP_SUMMARY": str(self.folder / "summary"),
            "SMURF_RELEASES": self.archive.parent.as_uri(),
            "PYTHONPATH": "."}  # as shells of robots and workflows have it: the checked repository
        for step in self.action["runs"]["steps"]:
            own = {name: re.sub(r"\$\{\{ inputs\.([\w-]+) \}\}", lambda found: values[found[1]], text)
                   for name, text in step.get("env", {}).items()}
            done = subprocess.run(["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", step["run"]], check=False,
                                  cwd=self.folder / "work", env=environment | own, capture_output=True, text=True)
            if done.returncode != 0:
                break
        return done

    def summary(self):
        return (self.folder / "summary").read_text()

    def test_a_sound_model(self):
        done = self.run_action()
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("no findings in", self.summary())
        folder = pathlib.Path((self.folder / "path").read_text().strip())
        self.assertTrue(os.access(folder / "smurf2urdf", os.X_OK))

    def test_a_broken_model(self):
        (self.folder / "work/robots/arm/meshes/forearm.obj").unlink()
        done = self.run_action(paths="robots/arm", targets="ros", sarif="out.sarif", **{"fail-on": "warning"})
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("::warning file=robots/arm/urdf/arm.urdf,line=", done.stdout)
        self.assertIn("    warning[SML1604]: mesh file not found", self.summary())
        self.assertRegex(self.summary(), r"\n    ros +loads, with losses")
        self.assertIn("SML1604", (self.folder / "work/out.sarif").read_text())

    def test_a_summary_is_of_its_own_step(self):
        self.assertEqual(self.run_action().returncode, 0)
        (self.folder / "summary").unlink()
        done = self.run_action(targets="nothing")
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertFalse((self.folder / "summary").exists())

    def test_python_files_of_the_checkout(self):
        work = self.folder / "work"
        (work / "backend").mkdir()
        (work / "backend/__init__.py").touch()
        for name in ("backend/__main__.py", "hashlib.py", "pathlib.py", "sitecustomize.py", "tarfile.py"):
            (work / name).write_text(f"open({str(self.folder / 'imported')!r}, 'a').write({name!r})\n")
        done = self.run_action(paths="robots")
        self.assertFalse((self.folder / "imported").exists())
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_a_corrupted_release(self):
        self.archive.write_bytes(self.archive.read_bytes() + b"\0")
        done = self.run_action()
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertIn("is not what was released", done.stderr)
        self.assertFalse((self.folder / "temporary/smurf-tools").exists())


if __name__ == "__main__":
    try:
        import yaml
    except ImportError:
        print("SKIPPED: PyYAML is not installed (scripts/setup --readers)")
        sys.exit(77)
    TOOLS = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
