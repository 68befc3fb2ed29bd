# SPDX-License-Identifier: BSD-3-Clause
"""A dry run of scripts/release, with a small project instead of a real build."""
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest
import zipfile

from local_release import PROGRAMS, ROOT, copy_of_project

VERSION = re.search(r"\n  VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1]
PAGES = ("man/man1/{}.1", "bash-completion/completions/{}", "zsh/vendor-completions/_{}", "fish/vendor_completions.d/{}.fish",
         "smurf/schemas/{}.json", "doc/smurf/{}")


class Release(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="smurf-release-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        source = self.folder / "source"
        for program in PROGRAMS:
            files = [source / "bin" / program, *(source / "share" / page.format(program) for page in PAGES)]
            for file in files:
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(program)
            shutil.copy("/bin/true", files[0])
        (source / "CMakeLists.txt").write_text(
            "cmake_minimum_required(VERSION 3.25)\nproject(small NONE)\n"
            "install(DIRECTORY bin share DESTINATION . USE_SOURCE_PERMISSIONS)\n")
        subprocess.run(["cmake", "-S", source, "-B", self.folder / "build"], check=True, stdout=subprocess.DEVNULL)

    def build_for_arm64(self):
        """The same programs, whose headers name the other machine."""
        shutil.copytree(self.folder / "source", self.folder / "arm64-source")
        for program in (self.folder / "arm64-source/bin").iterdir():
            content = bytearray(program.read_bytes())
            content[18:20] = (183).to_bytes(2, "little")
            program.write_bytes(content)

    def build_for_windows(self):
        """Programs with the header of Windows, and without the pages of shells."""
        source = self.folder / "windows-source"
        shutil.copytree(self.folder / "source", source)
        for program in list((source / "bin").iterdir()):
            header = b"MZ".ljust(60, b"\0") + (64).to_bytes(4, "little") + b"PE\0\0\x64\x86"
            program.with_suffix(".exe").write_bytes(header)
            program.unlink()
        for page in PAGES[:4]:
            shutil.rmtree(source / "share" / page.partition("/")[0], ignore_errors=True)

    def release(self, *arguments, output="out"):
        command = [ROOT / "scripts/release", *arguments, "--built", self.folder / "build", "--output", self.folder / output]
        environment = {name: value for name, value in os.environ.items() if not name.startswith(("SMURF_", "PYTHON"))}
        return subprocess.run(command, capture_output=True, text=True, check=False, env=environment)

    def test_files(self):
        status = subprocess.run(["git", "status", "--porcelain"], cwd=ROOT, capture_output=True, check=True).stdout
        done = self.release(VERSION, "--dry-run")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("nothing was committed or tagged", done.stdout)
        out = self.folder / "out"
        sums = dict(reversed(line.split()) for line in (out / "SHA256SUMS").read_text().splitlines())
        self.assertEqual({*sums, "SHA256SUMS", "notes.md", "uploads.md"},
                         {str(file.relative_to(out)) for file in out.rglob("*") if file.is_file()})
        for recipe in (out / "recipes").iterdir():
            text = recipe.read_text()
            self.assertNotRegex(text, r"@\w+@")
            self.assertIn(sums[f"smurf_tools-{VERSION}.tar.gz"], text)
        for name, digest in sums.items():
            self.assertEqual(hashlib.sha256((out / name).read_bytes()).hexdigest(), digest)
        self.assertRegex(" ".join(sorted(sums)), r"smurf-tools-\S+-linux-\w+.tar.gz smurf_tools-\S+-py3-none-manylinux\S+.whl "
                                                 r"smurf_tools-\S+.tar.gz")
        with tarfile.open(next(out.glob("smurf-tools-*.tar.gz"))) as archive:
            names = {name.partition("/")[2] for name in archive.getnames()}
        expected = {"LICENSE", *(f"bin/{program}" for program in PROGRAMS)}
        expected |= {f"share/{page.format(program)}" for page in PAGES for program in PROGRAMS}
        self.assertLessEqual(expected | {"share/doc/smurf/licences/libyaml-cpp-dev"}, names)
        self.assertIn("\n- ", (out / "notes.md").read_text())
        self.assertEqual(subprocess.run(["git", "status", "--porcelain"], cwd=ROOT, capture_output=True, check=True).stdout,
                         status)

    def test_a_release_with_a_tag(self):
        """With other scripts instead of the build and the tests. pip makes the wheel from the tagged sources."""
        self.build_for_arm64()
        self.build_for_windows()
        project = self.folder / "project"
        (project / "scripts").mkdir(parents=True)
        copy_of_project(project)
        shutil.copy(ROOT / "scripts/release", project / "scripts")
        shutil.copytree(ROOT / "packaging/recipes", project / "packaging/recipes")
        shutil.copy(ROOT / "packaging/uploads.md", project / "packaging")
        for name, text in (("setup", "exit 0"), ("static-libraries", "exit 0"), ("viewer", "exit 0"), ("test", f"cmake -S '{self.folder}/source' -B build/release"),
                           ("container", 'echo image >"$2"'), ("licences", 'mkdir -p "$1"'),
                           ("debian", "mkdir -p build/debian && cd build/debian && touch smurf_a.deb smurf_a.dsc smurf_a.tar.xz"), ("arm64", f"cmake -S '{self.folder}/arm64-source' -B build/arm64"),
                           ("windows", f"cmake -S '{self.folder}/windows-source' -B build/windows"),
                           ("wasm", "mkdir -p build/wasm && echo packed >build/wasm/smurf-tools-1.tgz"),
                           ("../editors/vscode/build", 'echo packed >"$2"'), ("site", "mkdir -p build/site && echo >build/site/index.html")):
            (project / "scripts" / name).parent.mkdir(parents=True, exist_ok=True)
            (project / "scripts" / name).write_text(f"#!/bin/sh\n{text}\n")
            (project / "scripts" / name).chmod(0o755)
        (project / ".gitignore").write_text("/build/\n__pycache__/\n")
        (project / "CHANGELOG.md").write_text(f"# Changelog\n\n## [{VERSION}] - today\n\n- all\n\n## [0.0.1]\n\n- old\n")
        git = ("git", "-C", project, "-c", "user.name=a", "-c", "user.email=a@b")
        for command in (("init", "-q"), ("add", "-A"), ("commit", "-q", "-m", "all")):
            subprocess.run([*git, *command], check=True)
        environment = os.environ | {f"GIT_{who}_{what}": "a@b" for who in ("AUTHOR", "COMMITTER") for what in ("NAME", "EMAIL")}
        command = [project / "scripts/release", VERSION]
        done = subprocess.run(command, capture_output=True, text=True, check=False, env=environment)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        out = project / "build/dist"
        self.assertEqual((out / "notes.md").read_text(), "- all\n")
        self.assertTrue((out / "smurf_a.deb").exists())
        self.assertEqual(subprocess.run([*git, "status", "--porcelain"], check=True, capture_output=True).stdout, b"")
        table = subprocess.run([*git, "show", f"v{VERSION}:python/backend/releases.sha256"], check=True, capture_output=True)
        self.assertEqual({file.name for file in out.glob("*.oci.tar")},
                         {f"smurf-lint-{VERSION}-linux-{machine}.oci.tar" for machine in ("x86_64", "aarch64")})
        archives = table.stdout.decode().splitlines()[-3:]
        self.assertLessEqual(set(archives), set((out / "SHA256SUMS").read_text().splitlines()))
        self.assertEqual([line.rpartition(VERSION)[2] for line in archives], ["-linux-x86_64.tar.gz", "-linux-aarch64.tar.gz", "-win-amd64.tar.gz"])
        self.assertIn(f"{hashlib.sha256(b'packed' + os.linesep.encode()).hexdigest()}  smurf-tools-1.tgz",
                      (out / "SHA256SUMS").read_text().splitlines())
        build = "import sys, backend; backend.build_wheel(sys.argv[1])"
        subprocess.run([sys.executable, "-c", build, self.folder], check=True, stderr=subprocess.DEVNULL,
                       env=environment | {"PYTHONPATH": str(project / "python"), "SMURF_RELEASES": out.as_uri()})
        wheel = next(out.glob("*_x86_64.whl"))
        self.assertEqual(len(list(out.glob("*_aarch64.whl"))), 1)
        with zipfile.ZipFile(next(out.glob("*-win_amd64.whl"))) as packed:
            scripts = {name.rpartition("/")[2] for name in packed.namelist() if "/scripts/" in name}
        self.assertEqual(scripts, {f"{program}.exe" for program in PROGRAMS})
        self.assertEqual((self.folder / wheel.name).read_bytes(), wheel.read_bytes())
        again = subprocess.run(command, capture_output=True, text=True, check=False, env=environment)
        self.assertEqual((again.returncode, again.stderr), (2, f"release: the tag v{VERSION} exists\n"))

    def test_two_runs_are_the_same_bytes(self):
        for output in ("first", "second"):
            self.assertEqual(self.release(VERSION, "--dry-run", output=output).returncode, 0)
        for file in (self.folder / "first").iterdir():
            if file.is_file():
                self.assertEqual(file.read_bytes(), (self.folder / "second" / file.name).read_bytes(), file.name)

    def test_a_program_that_needs_a_physics_engine(self):
        """With git, which needs libraries that some Linux systems lack."""
        shutil.copy(shutil.which("git"), self.folder / "source/bin/smurf-load-check")
        done = self.release(VERSION, "--dry-run")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("smurf-load-check needs shared libraries", done.stderr)
        with tarfile.open(next((self.folder / "out").glob("smurf-tools-*.tar.gz"))) as archive:
            self.assertEqual([name for name in archive.getnames() if "load-check" in name], [])

    def test_refused(self):
        for arguments, words in (((), "which version?"), (("9.9.9", "--dry-run"), f"has version {VERSION}, not 9.9.9"),
                                 ((VERSION,), "--built is for --dry-run"), ((VERSION, "--new"), "unknown option")):
            done = self.release(*arguments)
            self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
            self.assertIn(words, done.stderr)
            self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    if not (ROOT / ".git").exists():
        print("SKIPPED: these sources are not a git repository")
        raise SystemExit(77)
    unittest.main(argv=sys.argv[:1])
