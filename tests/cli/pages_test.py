# SPDX-License-Identifier: BSD-3-Clause
"""Manual pages and completions: every tool makes them, and man and bash accept them without messages."""
import pathlib
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import cli  # noqa: E402


class Pages(cli.CliTest):
    def generate(self, what):
        return self.expect(0, f"--generate={what}").stdout

    def long_options(self):
        lines = self.expect(0, "--help").stdout.splitlines()
        return {word.split("=")[0].split("[")[0] for line in lines if line.startswith("      --") or line.startswith("  -")
                for word in line.replace(",", " ").split()[:2] if word.startswith("--")}

    def test_all_name_every_option(self):
        options = self.long_options()
        self.assertIn("--help", options)
        manual = self.generate("man").replace("\\-", "-")
        bash, zsh, fish = (self.generate(what) for what in ("bash", "zsh", "fish"))
        for option in options:
            self.assertIn(option, manual)
            self.assertIn(option, bash)
            self.assertIn(option, zsh)
            self.assertIn(f" -l {option[2:]} ", fish)

    def test_man_reads_it(self):
        if shutil.which("man") is None:
            self.skipTest("man is not installed")
        self.write("page.1", self.generate("man"))
        done = subprocess.run(["man", "--warnings", "-l", "page.1"], cwd=self.folder, capture_output=True, text=True,
                              env={"PATH": "/usr/bin:/bin", "MANWIDTH": "80", "LC_ALL": "C.UTF-8"}, check=True)
        self.assertEqual(done.stderr, "")
        for heading in ("NAME", "SYNOPSIS", "OPTIONS", "EXIT STATUS", "EXAMPLES"):
            self.assertIn(f"\n{heading}\n", done.stdout)

    def complete(self, *words):
        """The words that bash offers for the last word."""
        name = pathlib.Path(cli.TOOL).name
        self.write("completion.bash", self.generate("bash"))
        script = ('source completion.bash; compopt() { :; }; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); '
                  f'_{name.replace("-", "_")}; printf "%s\\n" "${{COMPREPLY[@]}}"')
        done = subprocess.run(["bash", "-c", script, "bash", name, *words], cwd=self.folder, capture_output=True,
                              text=True, check=True)
        self.assertEqual(done.stderr, "")
        return done.stdout.split()

    def test_bash_completes(self):
        self.assertIn("--version", self.complete("--ver"))
        if "--color" not in self.long_options():
            return
        self.assertIn("--color", self.complete("--co"))
        self.assertEqual(self.complete("--color", "al"), ["always"])
        self.assertEqual(self.complete("--color", "=", "n"), ["never"])
        self.assertEqual(self.complete("--package", ""), [])

    def test_rules_are_completed(self):
        if pathlib.Path(cli.TOOL).name != "smurf-lint":
            self.skipTest("only smurf-lint takes rules")
        self.assertEqual(self.complete("--explain", "SML3101"), ["SML3101"])
        self.assertEqual(self.complete("--explain", "unknown-joi"), ["unknown-joint"])
        self.assertEqual(self.complete("--explain", "controllers"), ["controllers"])
        self.assertEqual(self.complete("--severity", "SML3101"), ["SML3101"])
        self.assertEqual(self.complete("--severity", "SML3101", "=", "w"), ["warning"])
        self.assertEqual(self.complete("--severity", "SML3101", "="), ["error", "warning", "info"])
        self.assertEqual(self.complete("--target", "muj"), ["mujoco", "mujoco:2.3", "mujoco:3.1", "mujoco:3.3", "mujoco:3.14", "mujoco:4.0"])
        self.assertIn("SML3101=error", self.generate("fish"))

    def test_help_begins_with_examples_and_ends_with_shared_options(self):
        text = self.expect(0, "--help").stdout
        headings = [line for line in text.splitlines() if line.endswith(":") and not line.startswith(" ")]
        headings = [heading for heading in headings if heading != "More examples:"]
        self.assertEqual(headings[0], "Examples:")
        self.assertEqual(headings[-1], "General:")
        shared = [heading for heading in headings if heading in ("Output:", "Exit code:", "Input:", "General:")]
        self.assertEqual(headings[-len(shared):], shared)
        self.assertEqual(shared, [one for one in ("Output:", "Exit code:", "Input:", "General:") if one in shared])
        examples = text.split("Examples:\n")[1].split("\n\n")[0]
        self.assertEqual(examples.count("\n      "), 2)

    def test_limits_have_a_page(self):
        if "--limit" not in self.long_options():
            self.skipTest("has no limits")
        self.assertNotIn("yaml-nodes=", self.expect(0, "--help").stdout)
        page = self.expect(0, "--limit", "help").stdout
        self.assertRegex(page, r"\n  yaml-depth +100  ")


if __name__ == "__main__":
    cli.main()
