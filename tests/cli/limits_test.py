# SPDX-License-Identifier: BSD-3-Clause
"""--limit of every tool: an exceeded limit is reported at its place, and can be raised by its name.

Usage: limits_test.py FOLDER_OF_TOOLS
"""
import io
import pathlib
import resource
import subprocess
import sys
import tempfile
import unittest
import zipfile

TOOLS = None
DEEP = "<a>" * 10 + "</a>" * 10
LINK = ('<link name="a"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'
        '</inertial></link>')
COMMANDS = {
    "smurf-lint": ["robot.urdf"],
    "smurf2urdf": ["robot.smurf"],
    "urdf2smurf": ["robot.urdf", "-o", "model", "--dry-run"],
    "smurfs-flatten": ["scene.smurfs"],
    "smurf-diff": ["robot.urdf", "robot.urdf"],
    "smurf-load-check": ["robot.urdf", "--time", "0.01"],
}


class LimitsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="smurf-limits-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.write("robot.urdf", f'<robot name="robot">{LINK}{DEEP}</robot>')
        self.write("robot.smurf", "modelname: robot\nfiles: [robot.urdf]\n")
        self.write("scene.smurfs", "entities:\n- {name: a, type: smurf, file: robot.smurf, position: [0, 0, 0]}\n")

    def write(self, path, text):
        (self.folder / path).parent.mkdir(exist_ok=True)
        (self.folder / path).write_bytes(text if isinstance(text, bytes) else text.encode())

    def run_tool(self, tool, *words, stdin="", **settings):
        return subprocess.run([TOOLS / tool, *words], cwd=self.folder, input=stdin, capture_output=True,
                              encoding="utf-8", timeout=600, check=False, **settings)

    def test_without_memory(self):
        def limit():
            resource.setrlimit(resource.RLIMIT_DATA, (3 << 20, 3 << 20))

        links = "".join(f'<link name="l{i}"/>' for i in range(100_000))
        self.write("robot.urdf", f'<robot name="robot">{links}</robot>')
        for tool, words in COMMANDS.items():
            with self.subTest(tool):
                if self.run_tool(tool, "--version", preexec_fn=limit).returncode != 0:
                    self.skipTest("needs more memory to start: is it built with sanitizers?")
                told = self.run_tool(tool, *words, preexec_fn=limit)
                self.assertEqual((told.returncode, told.stdout, told.stderr), (2, "", "out of memory\n"))

    def test_every_tool(self):
        for tool, words in COMMANDS.items():
            with self.subTest(tool):
                told = self.run_tool(tool, *words, "--limit", "xml-depth=10")
                # In smurf-diff, 1 means that something differs.
                self.assertEqual(told.returncode, 2 if tool == "smurf-diff" else 1)
                self.assertIn("SML0014", told.stdout + told.stderr)
                self.assertIn("raise the limit with `--limit xml-depth=N`", told.stdout + told.stderr)
                for limits in (["--limit", "xml-depth=11"], ["--limit", "yaml-depth=9,xml-depth=10",
                                                             "--limit", "xml-depth=11"]):
                    done = self.run_tool(tool, *words, *limits)
                    self.assertNotIn("SML0014", done.stdout + done.stderr)
                    self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                self.assertIn("--limit NAME=N", self.run_tool(tool, "--help").stdout)

    def test_processor_time(self):
        """Work for an hour, and a limit that allows it: every tool ends soon, and says which file it has left."""
        work = "len([0 for j in range(90000) if [0 for i in range(90000) if 0]])"
        self.write("slow.urdf.xacro", f'<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="${{{work}}}"/></robot>')
        self.write("folder/fast.urdf", f'<robot name="robot">{LINK}</robot>')
        self.write("folder/slow.urdf.xacro", (self.folder / "slow.urdf.xacro").read_text())
        options = ["--limit", "xacro-steps=9000000000", "--max-seconds", "1"]

        def run(tool, *words):
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            told = subprocess.run([TOOLS / tool, *words, *options], cwd=self.folder, capture_output=True, encoding="utf-8",
                                  timeout=600, check=False)
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            self.assertLess(after.ru_utime - before.ru_utime, 5)
            return told

        for tool, words in {"smurf-lint": ["slow.urdf.xacro"], "smurf2urdf": ["slow.urdf.xacro"],
                            "smurfs-flatten": ["slow.urdf.xacro"], "smurf-load-check": ["slow.urdf.xacro"],
                            "smurf-diff": ["slow.urdf.xacro", "robot.urdf"]}.items():
            with self.subTest(tool):
                told = run(tool, *words)
                self.assertIn(told.returncode, (1, 2), told.stdout + told.stderr)
                self.assertIn("slow.urdf.xacro", told.stdout + told.stderr)
                self.assertIn("took more than 1 s of processor time", told.stdout + told.stderr)
                self.assertIn("--max-seconds N", told.stdout + told.stderr)
                self.assertIn("--max-seconds N", self.run_tool(tool, "--help").stdout)
        told = run("smurf-lint", "folder", "--target", "gazebo", "--format", "concise")
        self.assertIn("folder/slow.urdf.xacro", told.stdout)
        self.assertIn("folder/fast.urdf", told.stdout)  # the others are checked
        wrong = self.run_tool("smurf-lint", "robot.urdf", "--max-seconds", "soon")
        self.assertEqual((wrong.returncode, wrong.stdout), (2, ""))
        self.assertIn("'soon' is not a whole number of at least 0", wrong.stderr)

    def test_what_cannot_be_asked_for(self):
        for item, wrong in {
                "xml-deepth=10": "there is no limit 'xml-deepth'; did you mean",
                "xml-depth": "'xml-depth' is not NAME=N",
                "xml-depth=many": "'many' is not a whole number from 1 to 98",
                "xml-depth=99": "'99' is not a whole number from 1 to 98",
                "xml-depth=0": "'0' is not a whole number from 1 to 98"}.items():
            for tool in COMMANDS:
                with self.subTest(item, tool=tool):
                    done = self.run_tool(tool, *COMMANDS[tool], "--limit", item)
                    self.assertEqual(done.returncode, 2)
                    self.assertIn(wrong, done.stderr)
        done = self.run_tool("smurf-lint", "--limit", "xml-deepth=10")
        self.assertIn("did you mean 'xml-depth'?", done.stderr)

    def test_standard_input(self):
        text = "<robot name='r'><link name='a'/></robot>"
        for tool in ("smurf-lint", "urdf2smurf"):
            words = ["-o", "out", "--dry-run"] if tool == "urdf2smurf" else []
            self.assertEqual(self.run_tool(tool, "-", *words, "--limit", f"file-bytes={len(text)}",
                                           stdin=text).returncode, 0)
            done = self.run_tool(tool, "-", *words, "--limit", f"file-bytes={len(text) - 1}", stdin=text)
            self.assertEqual(done.returncode, 2)
            self.assertIn("raise the limit with `--limit file-bytes=N`", done.stderr)

    def test_archives(self):
        target = io.BytesIO()
        with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as zipped:
            zipped.writestr("a.smurfs", "entities: []\n" + 1000 * "#\n")
            zipped.writestr("b.yml", "x: 1\n")
        self.write("a.zsmurfs", target.getvalue())
        for item, enough in {"archive-bytes": 2018, "archive-files": 2}.items():
            done = self.run_tool("smurfs-flatten", "a.zsmurfs", "--limit", f"{item}={enough}")
            self.assertEqual(done.returncode, 0, done.stderr)
            done = self.run_tool("smurfs-flatten", "a.zsmurfs", "--limit", f"{item}={enough - 1}")
            self.assertEqual(done.returncode, 2)
            self.assertIn(f"raise the limit with `--limit {item}=N`", done.stderr)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(f"usage: {sys.argv[0]} FOLDER_OF_TOOLS [unittest option]...")
    TOOLS = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
