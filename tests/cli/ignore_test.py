# SPDX-License-Identifier: BSD-3-Clause
"""Files that a search skips: .gitignore, .smurf-lintignore and `exclude`; compared with git itself."""
import pathlib
import random
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import cli  # noqa: E402

URDF = '<robot name="box"><link name="box"/></robot>\n'


class IgnoreTest(cli.CliTest):
    def write_all(self, *paths):
        for path in paths:
            self.write(path, URDF)

    def listed(self, *arguments, **keywords):
        return self.expect(0, "--list-files", *arguments, **keywords).stdout.splitlines()


class Files(IgnoreTest):
    def setUp(self):
        super().setUp()
        self.write_all("a.urdf", "old/b.urdf", "robots/c.urdf", "robots/old/d.urdf")

    def test_gitignore_counts_in_a_repository(self):
        self.leave_repository()
        self.write(".gitignore", "old/\n")
        self.assertEqual(len(self.listed()), 4)
        (self.folder / ".git").mkdir()
        self.assertEqual(self.listed(), ["a.urdf", "robots/c.urdf"])
        self.assertEqual(len(self.listed("--no-ignore-files")), 4)
        self.write("robots/.gitignore", "!old/\n")
        self.assertEqual(self.listed("robots"), ["robots/c.urdf", "robots/old/d.urdf"])

    def test_an_ignored_folder_may_be_a_repository(self):
        """As in workspaces, whose repository ignores the folder of its clones."""
        self.write(".gitignore", "robots\n")
        for folder in (".", "robots"):
            (self.folder / folder / ".git").mkdir()
        self.assertEqual(self.listed("robots"), ["robots/c.urdf", "robots/old/d.urdf"])
        self.assertEqual(self.listed("robots/c.urdf", "robots/old/d.urdf", "--force-exclude"),
                         ["robots/c.urdf", "robots/old/d.urdf"])
        self.write(".smurf-lintignore", "robots\n")
        self.assertEqual(self.listed("robots/c.urdf", "a.urdf", "--force-exclude"), ["a.urdf"])

    def test_comparisons_with_patterns_are_bounded(self):
        for patterns, text in ((".smurf-lintignore", "x*y\n" * 500), (".smurf-lint.yaml", "exclude:\n" + "- x*y\n" * 500)):
            self.write(patterns, text)
            self.assertEqual(len(self.listed()), 4)
            done = self.run_tool("--list-files", "--limit", "ignore-checks=2000")
            self.assertEqual(done.returncode, 2)
            self.assertIn("more than 2000 comparisons of files with patterns; raise the limit with `--limit ignore-checks=N`",
                          done.stderr)
            (self.folder / patterns).unlink()

    def test_own_ignore_file_counts_everywhere(self):
        self.write(".smurf-lintignore", "/old\n# robots\n")
        self.assertEqual(self.listed(), ["a.urdf", "robots/c.urdf", "robots/old/d.urdf"])
        self.assertEqual(self.listed("."), self.listed())
        self.assertEqual(self.listed(cwd=self.folder / "robots"), ["c.urdf", "old/d.urdf"])
        (self.folder / ".git").mkdir()
        self.write(".gitignore", "robots\n")
        self.write("robots/.smurf-lintignore", "*\n!c.urdf\n")
        self.assertEqual(self.listed("robots"), ["robots/c.urdf"])

    def test_exclude(self):
        self.write(".smurf-lint.yaml", "exclude: [robots/old, /a.urdf]\n")
        self.assertEqual(self.listed(), ["old/b.urdf", "robots/c.urdf"])
        self.assertEqual(self.listed("--isolated"), ["a.urdf", "old/b.urdf", "robots/c.urdf", "robots/old/d.urdf"])
        self.assertEqual(self.listed(cwd=self.folder / "robots"), ["c.urdf"])
        # A configuration nearer to a file replaces this one.
        self.write("robots/.smurf-lint.yaml", "ignore: SML19\n")
        self.assertEqual(self.listed("robots"), ["robots/c.urdf", "robots/old/d.urdf"])

    def test_what_is_named_is_checked(self):
        self.write(".smurf-lint.yaml", "exclude: [old]\n")
        self.assertEqual(self.listed("old/b.urdf"), ["old/b.urdf"])
        self.assertEqual(self.listed("old"), ["old/b.urdf"])
        self.assertEqual(self.listed("--force-exclude", "old/b.urdf", "a.urdf"), ["a.urdf"])
        self.write(".smurf-lint.yaml", "exclude: [old]\nforce-exclude: true\n")
        self.assertEqual(self.listed("robots/old/d.urdf", "a.urdf"), ["a.urdf"])
        self.assertEqual(self.expect(0, "old/b.urdf").stdout.splitlines()[-1], "no findings in 1 file")
        self.assertEqual(self.listed("--isolated", "old/b.urdf"), ["old/b.urdf"])

    def test_nothing_left(self):
        self.write(".smurf-lintignore", "*.urdf\n")
        done = self.expect(2, "robots")
        self.assertEqual(done.stderr, "smurf-lint: no .smurf, .smurfs, .smurfa, .urdf or .xacro file in 'robots' (2 left out)\n")


@unittest.skipUnless(shutil.which("git"), "git is not installed")
class LikeGit(IgnoreTest):
    """Random patterns and trees: smurf-lint searches exactly the files that git does not ignore."""

    NAMES = ["a", "b", "ab", "a b", "#c", "build"]
    PIECES = ["a", "b", "ab", "a*", "*b", "?", "[ab]", "[!a]", "**", "*", "a b", "\\#c", "build", "*.urdf", "a.urdf"]

    def pattern(self, choose):
        text = "/".join(choose.choice(self.PIECES) for _ in range(choose.choice((1, 1, 2, 3))))
        return choose.choice(("", "", "", "!")) + choose.choice(("", "", "/")) + text + choose.choice(("", "", "/"))

    def test_random_trees(self):
        subprocess.run(["git", "init", "-q"], cwd=self.folder, check=True)
        compared = 0
        for seed in range(40):
            choose = random.Random(seed)
            for entry in self.folder.iterdir():
                if entry.name != ".git":
                    shutil.rmtree(entry) if entry.is_dir() else entry.unlink()
            paths = {"/".join(choose.choice(self.NAMES) for _ in range(choose.randrange(4))) + "/"
                     + choose.choice(("a", "b", "ab")) + ".urdf" for _ in range(12)}
            self.write_all(*(path.lstrip("/") for path in paths))
            for folder in ("", "a/", "ab/b/"):
                lines = [self.pattern(choose) for _ in range(choose.randrange(1, 4))]
                if (self.folder / folder).is_dir():
                    self.write(folder + ".gitignore", "\n".join(lines) + "\n")
            shown = subprocess.run(["git", "ls-files", "-z", "--others", "--exclude-standard", "*.urdf"], cwd=self.folder,
                                   check=True, capture_output=True, text=True).stdout
            expected = sorted(path for path in shown.split("\0") if path)
            with self.subTest(seed=seed):
                done = self.run_tool("--list-files")
                self.assertEqual(sorted(done.stdout.splitlines()), expected)
                self.assertEqual(done.returncode, 0 if expected else 2)
            compared += len(paths)
        self.assertGreater(compared, 200)


if __name__ == "__main__":
    cli.main()
