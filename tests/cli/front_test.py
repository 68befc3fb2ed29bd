# SPDX-License-Identifier: BSD-3-Clause
"""`smurf VERB`: one name for all programs."""
import json
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree as xml

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import cli  # noqa: E402


class Front(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.write("arm.urdf", cli.ARM_URDF)

    def done(self, *arguments):
        """A run that ends with 0; losses are another test's subject."""
        done = self.run_tool(*arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def verbs(self):
        text = self.expect(0, "--help").stdout.split("\nVerbs:\n")[1].split("\n\n")[0]
        return re.findall(r"^  (\w+) ", text, re.M)

    def test_every_verb_runs_its_program(self):
        self.assertEqual(self.verbs(), ["check", "fix", "explain", "init", "convert", "flatten", "diff", "view", "simulate",
                                        "lsp"])
        programs = {"check": "smurf-lint", "fix": "smurf-lint", "explain": "smurf-lint", "init": "smurf-lint",
                    "flatten": "smurfs-flatten", "diff": "smurf-diff", "view": "smurf-view", "simulate": "smurf-load-check",
                    "lsp": "smurf-lsp"}
        for verb, program in programs.items():
            with self.subTest(verb):
                self.assertTrue(self.expect(0, verb, "--help").stdout.startswith(f"Usage: {program} "))

    def test_the_exit_code_and_the_text_are_those_of_the_program(self):
        self.write("bad.urdf", cli.ARM_URDF.replace('link="forearm"', 'link="foream"'))
        ours = self.expect(1, "check", "--isolated", "bad.urdf")
        program = pathlib.Path(cli.TOOL).with_name("smurf-lint")
        theirs = subprocess.run([program, "--isolated", "bad.urdf"], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual((ours.stdout, ours.returncode), (theirs.stdout, theirs.returncode))

    def test_explain(self):
        self.assertIn("SML3101", self.expect(0, "explain", "SML3101").stdout)

    def test_convert_chooses_the_format_by_the_name(self):
        self.done("convert", "arm.urdf", "arm.xml")
        self.assertEqual(xml.parse(self.folder / "arm.xml").getroot().tag, "mujoco")
        self.done("convert", "arm.urdf", "arm.sdf")
        self.assertEqual(xml.parse(self.folder / "arm.sdf").getroot().tag, "sdf")
        self.done("convert", "arm.urdf", "model", "--motors", "all")
        self.assertTrue((self.folder / "model").is_dir())
        self.done("convert", "model", "back.urdf")
        self.assertEqual((self.folder / "back.urdf").read_text(), cli.ARM_URDF)

    def test_convert_takes_a_format_and_options(self):
        self.assertEqual(xml.fromstring(self.done("convert", "arm.urdf", "--to", "mjcf").stdout).tag, "mujoco")
        flat = json.loads(self.done("convert", "arm.urdf", "--to=json", "--links").stdout)
        self.assertEqual(len(flat["instances"][0]["links"]), 2)
        self.done("convert", "arm.urdf", "--to", "mjcf", "-o", "scene.txt", "--ground")
        self.assertIn("plane", (self.folder / "scene.txt").read_text())

    def test_convert_passes_arguments_of_xacro(self):
        self.write("bot.urdf.xacro", cli.ARM_URDF.replace('<robot name="arm">', '<robot name="arm" xmlns:xacro='
                   '"http://www.ros.org/wiki/xacro"><xacro:arg name="side" default="left"/>').replace("elbow", "$(arg side)_elbow"))
        self.expect(0, "convert", "bot.urdf.xacro", "bot.urdf", "side:=right")
        self.assertIn("right_elbow", (self.folder / "bot.urdf").read_text())

    def test_formats_are_those_of_the_programs(self):
        page = self.expect(0, "convert", "--to", "help").stdout
        listed = re.findall(r"^  ([\w.]+) ", page, re.M)
        flatten = pathlib.Path(cli.TOOL).with_name("smurfs-flatten")
        text = subprocess.run([flatten, "--format", "help"], capture_output=True, text=True, check=True).stdout
        self.assertLessEqual(set(cli.formats.listed(text, without=())), set(listed))
        self.assertLess(max(map(len, page.splitlines())), 81)

    def test_mistakes_say_what_to_write(self):
        for arguments, text in ((["chek"], "did you mean 'check'?"), (["arm.urdf"], "`smurf check arm.urdf`"), ([], "smurf check ."),
                                (["convert"], "name the input first"), (["convert", "arm.urdf"], "`--to mjcf`"),
                                (["convert", "arm.urdf", "a.stp"], "`--to help`"),
                                (["convert", "arm.urdf", "--to", "mjfc"], "did you mean 'mjcf'?"),
                                (["convert", "arm.urdf", "--to", "smurf"], "name the folder")):
            with self.subTest(arguments):
                done = self.expect(2, *arguments)
                self.assertIn(text, done.stderr)
                self.assertEqual(done.stderr.count("\n"), 1)


if __name__ == "__main__":
    cli.main()
