# SPDX-License-Identifier: BSD-3-Clause
"""Checking parts of the files separately and merging the reports gives the report of all files."""
import json
import pathlib
import shlex
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import cli  # noqa: E402


class Shards(cli.CliTest):
    def setUp(self):
        super().setUp()
        for name in sorted(p.name for p in (cli.FIXTURES / "rules").iterdir())[::7]:
            shutil.copytree(cli.FIXTURES / "rules" / name, self.folder / "rules" / name)
        shutil.copytree(cli.FIXTURES / "models", self.folder / "models")

    def report(self, *arguments):
        return json.loads(self.expect(None, "--isolated", "--format", "json", *arguments).stdout)

    def test_merged_is_whole(self):
        whole = self.report(".")
        self.assertGreater(len(whole["diagnostics"]), 50)
        parts = []
        for k in (1, 2, 3):
            self.expect(None, "--isolated", "--format", f"json=part-{k}.json", "--shard", f"{k}/3", ".")
            parts.append(json.loads(self.read(f"part-{k}.json")))
        for part in parts:
            self.assertLess(len(part["diagnostics"]), len(whole["diagnostics"]))
        names = [f"part-{k}.json" for k in (1, 2, 3)]
        done = self.expect(1, "--merge-reports", *names)
        merged = json.loads(done.stdout)
        self.assertEqual(merged["diagnostics"], whole["diagnostics"])
        for count in ("error", "warning", "info"):
            self.assertEqual(merged["summary"][count], whole["summary"][count], count)
        self.expect(0, "--merge-reports", "--exit-zero", *names)
        self.assertEqual(self.expect(1, "--merge-reports", *reversed(names)).stdout, done.stdout)

    def test_every_file_is_in_one_part(self):
        whole = self.expect(0, "--list-files", "models").stdout.split()
        parts = [line for k in range(1, 5)
                 for line in self.expect(0, "--list-files", "--shard", f"{k}/4", "models").stdout.split()]
        self.assertEqual(len(parts), len(set(parts)))
        # A URDF belongs to the same part as the model that lists it.
        self.assertEqual(sorted(parts), [path for path in whole if not path.endswith(".urdf")])

    def test_gnu_parallel(self):
        if shutil.which("parallel") is None:
            self.skipTest("GNU parallel is not installed")
        subprocess.run(["parallel", "--will-cite", "-j2",
                        f"{shlex.quote(cli.TOOL)} --isolated --exit-zero --format json=p-{{}}.json --shard {{}}/4 .",
                        ":::", "1", "2", "3", "4"], cwd=self.folder, check=True, capture_output=True)
        merged = json.loads(self.expect(None, "--merge-reports", *(f"p-{k}.json" for k in range(1, 5))).stdout)
        self.assertEqual(merged["diagnostics"], self.report(".")["diagnostics"])

    def test_complaints(self):
        self.write("no.json", "{}")
        self.expect_complaint("'no.json' is not a JSON report of these tools", "--merge-reports", "no.json")
        self.expect(2, "--merge-reports", "gone.json")
        for value in ("0/2", "3/2", "1", "a/b", "1/0"):
            done = self.expect(2, "--shard", value, ".")
            self.assertIn("is not K/N with K from 1 to N", done.stderr)


if __name__ == "__main__":
    cli.main()
