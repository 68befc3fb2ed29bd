# SPDX-License-Identifier: BSD-3-Clause
"""A report does not depend on the number of threads."""
import os
import pathlib
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import cli  # noqa: E402

RUNS = int(os.environ.get("SMURF_TEST_CASES", 4))


class Jobs(cli.CliTest):
    def setUp(self):
        super().setUp()
        shutil.copytree(cli.FIXTURES / "rules", self.folder / "rules")
        shutil.copytree(cli.FIXTURES / "models", self.folder / "models")
        # The files of two configurations are judged separately and reported together.
        self.write("rules/.smurf-lint.yaml", "ignore: [SML19]\nseverity: {SML3: warning}\n")

    def test_same_report_on_every_run(self):
        for form in ("json", "full", "sarif"):
            first = self.expect(1, "--all", "--format", form, "-j", 1, ".").stdout
            self.assertGreater(len(first), 10000)
            for run in range(RUNS):
                jobs = 2 if run % 2 == 0 else 7
                self.assertEqual(self.expect(1, "--all", "--format", form, "-j", jobs, ".").stdout, first, f"-j {jobs}, {form}")
        self.assertEqual(self.expect(1, "--min-severity", "info", "--format", "sarif", ".").stdout, first)

    def test_order_of_arguments_does_not_matter_to_findings(self):
        models = sorted(str(p.relative_to(self.folder)) for p in (self.folder / "models").rglob("*.smurf"))
        rules = sorted(str(p.relative_to(self.folder)) for p in (self.folder / "rules").rglob("model.smurf"))[:40]
        forward = self.expect(None, "--isolated", "--format", "concise", "-j", 2, *models, *rules).stdout
        backward = self.expect(None, "--isolated", "--format", "concise", "-j", 2, *reversed(models + rules)).stdout
        self.assertEqual(forward, backward)


if __name__ == "__main__":
    cli.main()
