#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""docs/nightly.md has a row for every job of scripts/nightly; a run replaces the rows of its jobs; nothing passes unrun."""
import importlib.machinery
import importlib.util
import pathlib
import re
import subprocess
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SCRIPT = ROOT / "scripts/nightly"


def load():
    loader = importlib.machinery.SourceFileLoader("nightly", str(SCRIPT))
    spec = importlib.util.spec_from_loader("nightly", loader)
    module = importlib.util.module_from_spec(spec)
    loader.exec_module(module)
    return module


class NightlyTest(unittest.TestCase):
    def test_page_has_every_job(self):
        nightly = load()
        page = nightly.PAGE.read_text(encoding="utf-8")
        self.assertEqual(list(nightly.recorded(page)), list(nightly.JOBS))
        self.assertEqual(nightly.record(page, {}), page)

    def test_a_run_replaces_its_row(self):
        nightly = load()
        page = nightly.PAGE.read_text(encoding="utf-8")
        new = nightly.record(page, {"tidy": nightly.Result("2026-01-02", "0123abcd", 17, ["a_test"])})
        changed = [line for line in new.splitlines() if line not in page.splitlines()]
        self.assertEqual(len(changed), 1)
        self.assertTrue(changed[0].startswith("| tidy |") and changed[0].endswith("| 2026-01-02 | 0123abcd | 17 | **failed**: a_test |"))

    def test_failures_are_named(self):
        nightly = load()
        log = "99% tests passed, 1 tests failed out of 3\n\nThe following tests did not run:\n\t  2 - b_test (Skipped)\n\n" \
              "The following tests FAILED:\n\t  3 - c_test (Failed)\n\t 14 - d_test (Timeout)\nErrors while running CTest\n"
        self.assertEqual(nightly.failures_in(log), ["c_test", "d_test"])
        self.assertEqual(nightly.failures_in("make: it | broke\n\n"), ["make: it / broke"])

    def test_commands_exist_and_unknown_jobs_are_refused(self):
        for _, commands in load().JOBS.values():
            for command in commands:
                self.assertTrue(command.startswith("cmake ") or (ROOT / command.split()[0]).is_file(), command)
        done = subprocess.run([SCRIPT, "corpse"], capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (1, "scripts/nightly: there is no job 'corpse' (see --list)\n"))

    def test_every_step_of_ci_does_all_its_work(self):
        for path in [ROOT / ".ci/run", *(ROOT / "scripts").iterdir()]:
            if path.is_file():
                self.assertFalse(re.search(r"\bnot run\b", path.read_text(encoding="utf-8"), re.I), path)


if __name__ == "__main__":
    unittest.main()
