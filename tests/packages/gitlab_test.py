# SPDX-License-Identifier: BSD-3-Clause
"""The component for GitLab, templates/smurf-lint, whose script is run as a runner does, with pip and a folder in place of the index.

usage: gitlab_test.py FOLDER_OF_TOOLS
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from local_release import ROOT

TEMPLATE = ROOT / "templates/smurf-lint/template.yml"
TOOLS = None


class Component(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="smurf-gitlab-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        (cls.folder / "index").mkdir()
        build = "import sys, backend; backend.build_wheel(sys.argv[1])"
        subprocess.run([sys.executable, "-c", build, cls.folder / "index"], check=True, stderr=subprocess.DEVNULL, cwd=ROOT / "python",
                       env=os.environ | {"SMURF_PREBUILT": str(TOOLS), "PYTHONDONTWRITEBYTECODE": "1"})
        subprocess.run([sys.executable, "-m", "venv", cls.folder / "environment"], check=True)
        cls.spec, cls.jobs = yaml.safe_load_all(TEMPLATE.read_text())

    def setUp(self):
        self.work = pathlib.Path(tempfile.mkdtemp(dir=self.folder))
        shutil.copytree(ROOT / "fixtures/models/arm", self.work / "arm")

    def job(self, **inputs):
        """The only job, with values in place of the inputs."""
        defaults = {name: row["default"] for name, row in self.spec["spec"]["inputs"].items()}
        self.assertLessEqual(set(inputs), set(defaults))
        values = defaults | inputs

        def fill(node):
            if isinstance(node, dict):
                return {key: fill(value) for key, value in node.items()}
            if isinstance(node, list):
                return [fill(value) for value in node]
            return re.sub(r"\$\[\[ inputs\.([\w-]+) \]\]", lambda found: values[found[1]], node)
        (job,) = fill(self.jobs).values()
        return job

    def run_job(self, **inputs):
        job = self.job(**inputs)
        environment = {
            "PATH": f"{self.folder}/environment/bin:/usr/bin:/bin", "HOME": str(self.work), "PIP_NO_INDEX": "1",
            "PIP_FIND_LINKS": str(self.folder / "index"), **job["variables"]}
        return subprocess.run(["bash", "-eo", "pipefail", "-c", "\n".join(job["script"])], check=False, cwd=self.work,
                              env=environment, capture_output=True, text=True)

    def report(self):
        return json.loads((self.work / self.job()["artifacts"]["reports"]["codequality"]).read_text())

    def test_a_sound_model(self):
        done = self.run_job()
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("no findings", done.stdout)
        self.assertEqual(self.report(), [])

    def test_a_broken_model(self):
        (self.work / "arm/meshes/forearm.obj").unlink()
        version = re.search(r"\n  VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1]
        done = self.run_job(version=version, paths="arm/urdf arm/smurf", targets="ros", **{"fail-on": "warning"})
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("warning[SML1604]", done.stdout)
        self.assertIn("SML1604", {issue["check_name"] for issue in self.report()})

    def test_a_version_that_does_not_exist(self):
        done = self.run_job(version="9.9.9")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("smurf-tools==9.9.9", done.stderr)


if __name__ == "__main__":
    try:
        import ensurepip  # noqa: F401
        import yaml
    except ImportError as problem:
        print(f"SKIPPED: {problem.name} is not installed (scripts/setup --readers)")
        sys.exit(77)
    TOOLS = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
