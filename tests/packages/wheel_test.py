# SPDX-License-Identifier: BSD-3-Clause
"""The wheel: where its programs come from, what is refused, and what pip makes of it in an empty environment.

usage: wheel_test.py FOLDER_OF_TOOLS
"""
import importlib.util
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import unittest
import zipfile

from local_release import PROGRAMS, ROOT, add_release, copy_of_project

ARM = ROOT / "fixtures/models/arm/smurf/arm.smurf"
TOOLS = None
BUILD = "import sys; sys.path.insert(0, 'python'); import backend; print(backend.build_{}(sys.argv[1]))"
sys.path.insert(0, str(ROOT / "python"))


def state_of(folder):
    return {str(path): path.stat().st_mtime_ns for path in folder.rglob("*") if path.is_file()}


class Case(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="smurf-wheel-test-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.project = self.folder / "project"
        self.project.mkdir()
        copy_of_project(self.project)
        for name in ("release", "home", "temporary", "out", "small"):
            (self.folder / name).mkdir()
        self.small = self.folder / "small"  # replaces the programs in tests that do not run them
        for program in PROGRAMS:
            shutil.copy("/bin/true", self.small / program)
        keep = {name: value for name, value in os.environ.items() if not name.startswith(("SMURF_", "PIP_", "PYTHON"))}
        self.environment = keep | {
            "HOME": str(self.folder / "home"), "TMPDIR": str(self.folder / "temporary"), "PIP_NO_INDEX": "1",
            "PIP_DISABLE_PIP_VERSION_CHECK": "1", "PIP_NO_CACHE_DIR": "1", "PYTHONDONTWRITEBYTECODE": "1"}

    def call(self, *command, **environment):
        return subprocess.run([str(part) for part in command], cwd=self.project, env=self.environment | environment,
                              capture_output=True, text=True, timeout=600, check=False)

    def build(self, what="wheel", folder="out", **environment):
        return self.call(sys.executable, "-c", BUILD.format(what), self.folder / folder, **environment)

    def refused(self, **environment):
        done = self.build(**environment)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertEqual(list((self.folder / "out").iterdir()), [])
        self.assertNotIn("Traceback", done.stderr)
        return done.stderr


class Sources(Case):
    def test_a_folder(self):
        done = self.build(SMURF_PREBUILT=str(self.small))
        self.assertIn("takes the programs of SMURF_PREBUILT", done.stderr)
        with zipfile.ZipFile(self.folder / "out" / done.stdout.strip()) as wheel:
            self.assertIsNone(wheel.testzip())
            names = set(wheel.namelist())
            scripts = [name for name in names if ".data/scripts/" in name]
            self.assertEqual({name.rsplit("/")[-1] for name in scripts}, set(PROGRAMS))
            for name in scripts:
                self.assertEqual(wheel.getinfo(name).external_attr >> 16, 0o100755)
                is_link = wheel.read(name).startswith(b"#!python\n")
                self.assertEqual(is_link, not name.endswith("/smurf-lint"))  # all programs are one here
                self.assertTrue(is_link or wheel.read(name) == (self.small / "smurf-lint").read_bytes())
            self.assertEqual([name for name in names if name.endswith((".pyi", ".typed"))], [])
            metadata = wheel.read(next(name for name in names if name.endswith("/METADATA"))).decode()
            self.assertNotIn("poses", metadata.partition("\n\n")[0])
            links = re.findall(r"\]\(([^)]+)\)", metadata)
            self.assertEqual([link for link in links if not link.startswith(("https://", "#"))], [])
            record = next(name for name in names if name.endswith("/RECORD"))
            self.assertEqual({line.split(",")[0] for line in wheel.read(record).decode().splitlines()}, names)

    def test_pages(self):
        """Manual pages and completions of the programs, from beside a folder and from a release; nothing else of share."""
        from backend.programs import PAGES

        pages = [page.format(program) for page in PAGES for program in PROGRAMS]
        for page in [*pages, "man/man1/other.1", "doc/smurf/README.md"]:
            file = self.folder / "share" / page
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(page)
        archive = add_release(self.project, self.folder / "release", self.small)
        for source in ({"SMURF_PREBUILT": str(self.small)}, {"SMURF_RELEASES": archive.parent.as_uri()}):
            done = self.build(**source)
            self.assertEqual(done.returncode, 0, done.stderr)
            with zipfile.ZipFile(self.folder / "out" / done.stdout.strip()) as wheel:
                found = {name.partition(".data/data/share/")[2]: wheel.read(name).decode() for name in wheel.namelist()
                         if ".data/data/" in name}
            self.assertEqual(found, {page: page for page in pages})

    def test_a_folder_without_a_program(self):
        shutil.copy("/bin/true", self.folder / "release/smurf-lint")
        message = self.refused(SMURF_PREBUILT=str(self.folder / "release"))
        self.assertIn("there is no smurf-lsp and no smurf2urdf", message)

    def test_a_folder_without_a_physics_engine(self):
        (self.small / "smurf-load-check").unlink()
        done = self.build(SMURF_PREBUILT=str(self.small))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("there is no smurf-load-check among them", done.stderr)

    def test_the_module_makes_it_a_wheel_of_this_python(self):
        folder = self.folder / "release"
        for program in PROGRAMS:
            shutil.copy("/bin/true", folder / program)
        name = "_smurf" + sysconfig.get_config_var("EXT_SUFFIX")
        shutil.copy("/bin/true", folder / name)
        done = self.build(SMURF_PREBUILT=str(folder))
        self.assertIn("-cp{0}{1}-cp{0}{1}-".format(*sys.version_info), done.stdout)
        with zipfile.ZipFile(self.folder / "out" / done.stdout.strip()) as wheel:
            self.assertIn(f"smurf/{name}", wheel.namelist())
            self.assertIn(b"from ._smurf import", wheel.read("smurf/__init__.py"))
        shutil.copy("/bin/true", folder / "_smurf.cpython-399-x86_64-linux-gnu.so")  # modules of several: for every Python
        done = self.build(SMURF_PREBUILT=str(folder))
        self.assertIn("-py3-none-", done.stdout)
        with zipfile.ZipFile(self.folder / "out" / done.stdout.strip()) as wheel:
            self.assertEqual(len([file for file in wheel.namelist() if file.startswith("smurf/_smurf.") and file.endswith(".so")]), 2)

    def test_a_release(self):
        archive = add_release(self.project, self.folder / "release", self.small)
        before = state_of(self.project)
        done = self.build(SMURF_RELEASES=archive.parent.as_uri())
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(f"takes the programs of the release, file://{archive}", done.stderr)
        self.assertEqual(state_of(self.project), before)
        self.assertEqual(list((self.folder / "temporary").iterdir()), [])

    def test_a_corrupted_release(self):
        archive = add_release(self.project, self.folder / "release", self.small)
        content = bytearray(archive.read_bytes())
        content[len(content) // 2] ^= 1
        archive.write_bytes(content)
        message = self.refused(SMURF_RELEASES=archive.parent.as_uri())
        self.assertIn("is not what was released: its sha256 is", message)

    def test_a_release_that_is_not_there(self):
        archive = add_release(self.project, self.folder / "release", self.small)
        archive.unlink()
        message = self.refused(SMURF_RELEASES=archive.parent.as_uri())
        self.assertIn("cannot download file://", message)
        self.assertIn("SMURF_PREBUILT=FOLDER", message)

    def test_a_system_without_release_and_compiler(self):
        add_release(self.project, self.folder / "release", self.small, "linux-s390x")
        message = self.refused(PATH="/nowhere")
        self.assertRegex(message, r"the release has no programs for \S+ \(it has smurf-tools-\S+-linux-s390x.tar.gz\)")
        self.assertIn("needs cmake and ninja and a C++ compiler, which are not here", message)

    def test_a_system_without_the_libraries(self):
        """CMake reports what is missing."""
        if not shutil.which("cmake") or not shutil.which("ninja"):
            self.skipTest("cmake and ninja are not installed")
        text = (self.project / "CMakeLists.txt").read_text()
        (self.project / "CMakeLists.txt").write_text(text.replace("(yaml-cpp REQUIRED)", "(yaml-nothing REQUIRED)"))
        message = self.refused()
        self.assertIn("compiles the programs (version", message)
        self.assertIn("yaml-nothing", message)
        self.assertIn("scripts/setup installs what is needed", message)

    def test_compiled(self):
        """With a small project instead of ours."""
        if not shutil.which("cmake") or not shutil.which("ninja"):
            self.skipTest("cmake and ninja are not installed")
        module = "_smurf" + sysconfig.get_config_var("EXT_SUFFIX")
        shutil.copy("/bin/true", self.small / module)
        head = (self.project / "CMakeLists.txt").read_text().partition("LANGUAGES CXX)")[0]
        (self.project / "CMakeLists.txt").write_text(
            f"{head}LANGUAGES NONE)\ninstall(PROGRAMS {' '.join(str(self.small / name) for name in PROGRAMS)} DESTINATION bin)\n"
            f"install(FILES {self.small / module} DESTINATION ${{SMURF_PYTHON_DIR}}/smurf)\n")
        before = state_of(self.project)
        done = self.build()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("compiles the programs (version", done.stderr)
        self.assertEqual(state_of(self.project), before)
        with zipfile.ZipFile(self.folder / "out" / done.stdout.splitlines()[-1]) as wheel:
            self.assertIn(f"smurf/{module}", wheel.namelist())
            self.assertEqual(len([name for name in wheel.namelist() if ".data/scripts/" in name]), len(PROGRAMS))

    def test_the_sources_make_a_plan(self):
        """Without a preset, as pip and Debian build them: ninja reads the files of the build and knows each step."""
        if not shutil.which("cmake") or not shutil.which("ninja"):
            self.skipTest("cmake and ninja are not installed")
        build = self.folder / "out/build"
        done = self.call("cmake", "-S", ROOT, "-B", build, "-G", "Ninja", "-DSMURF_STATIC=ON", "-DSMURF_BUILD_TESTS=OFF")
        self.assertEqual(done.returncode, 0, done.stderr)
        done = self.call("ninja", "-C", build, "-t", "query", "bin/smurf-diff")
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_two_builds_are_the_same_bytes(self):
        names = [self.build(folder=folder, SMURF_PREBUILT=str(self.small)).stdout.strip() for folder in ("out", "home")]
        first, second = [(self.folder / folder / name).read_bytes() for folder, name in zip(("out", "home"), names)]
        self.assertEqual(first, second)

    def test_source_archive(self):
        for command in (("init", "-q"), ("add", "-A")):
            self.assertEqual(self.call("git", *command).returncode, 0)
        (self.project / "not_ours.txt").write_text("x")
        name = self.build("sdist").stdout.strip()
        with tarfile.open(self.folder / "out" / name) as archive:
            names = archive.getnames()
        top = name[: -len(".tar.gz")]
        self.assertLessEqual({f"{top}/{file}" for file in ("PKG-INFO", "pyproject.toml", "python/backend/elf.py")}, set(names))
        self.assertNotIn(f"{top}/not_ours.txt", names)


class Tags(unittest.TestCase):
    def test_libraries_and_versions_are_those_of_readelf(self):
        from backend.elf import Elf

        if shutil.which("readelf") is None:
            self.skipTest("readelf is not installed")
        programs = [TOOLS / program for program in PROGRAMS] + [pathlib.Path("/bin/sh"), pathlib.Path(sys.executable)]
        for program in programs:
            elf = Elf(program.read_bytes())
            text = subprocess.run(["readelf", "-dV", program], capture_output=True, text=True, check=True).stdout
            self.assertEqual(elf.libraries, re.findall(r"\(NEEDED\).*\[(.*)\]", text), program)
            needs = text.partition("Version needs section")[2]
            self.assertEqual(sorted(elf.versions), sorted(re.findall(r"Name: (\S+)", needs)), program)

    def test_tags(self):
        from backend import elf

        class Made(elf.Elf):
            def __init__(self, content):
                self.machine, self.libraries, self.versions = machine, *self.made[content[6:]]

        Made.made = {
            b"static": ([], []), b"old": (["libc.so.6"], ["GLIBC_2.2.5", "GLIBC_PRIVATE"]),
            b"new": (["libc.so.6", "libm.so.6"], ["GLIBC_2.4", "GLIBC_2.35"]), b"more": (["libc.so.6", "libode.so.8"], [])}
        self.addCleanup(setattr, elf, "Elf", elf.Elf)
        elf.Elf = Made
        machine = "x86_64"
        for names, expected in {
            ("static", "static"): "manylinux_2_17_x86_64.manylinux2014_x86_64.musllinux_1_1_x86_64",
            ("static", "old"): "manylinux_2_17_x86_64.manylinux2014_x86_64",
            ("static", "old", "new"): "manylinux_2_35_x86_64",
            ("static", "more"): "linux_x86_64",
        }.items():
            files = [b"\x7fELF\x02\x01" + name.encode() for name in names]
            self.assertEqual(elf.tag_of(files, False), f"py3-none-{expected}")
        machine = "aarch64"
        self.assertEqual(elf.tag_of([b"\x7fELF\x02\x01static"], False),
                         "py3-none-manylinux_2_17_aarch64.manylinux2014_aarch64.musllinux_1_1_aarch64")


HAS_VENV = importlib.util.find_spec("ensurepip") is not None


@unittest.skipUnless(HAS_VENV, "python3-venv is not installed")
class Pip(Case):
    def test_install_in_an_empty_environment(self):
        archive = add_release(self.project, self.folder / "release", TOOLS)
        environment = self.folder / "environment"
        self.assertEqual(self.call(sys.executable, "-m", "venv", environment).returncode, 0)
        before = state_of(self.project), state_of(self.folder / "home")
        del self.environment["PYTHONDONTWRITEBYTECODE"]
        done = self.call(environment / "bin/pip", "install", "-v", ".", SMURF_RELEASES=archive.parent.as_uri())
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("takes the programs of the release", done.stdout + done.stderr)
        self.assertEqual((state_of(self.project), state_of(self.folder / "home")), before)
        for program in PROGRAMS:
            done = self.call(environment / "bin" / program, "--version")
            self.assertIn(program, done.stdout, done.stderr)
        run = (environment / "bin/python", "-m", "smurf")
        done = self.call(*run, "lint", ARM, PATH="/nowhere")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("no findings", done.stdout)
        done = self.call(*run, "try-all", "smurf2urdf", "--", ARM.parent, PATH="/nowhere")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        done = self.call(environment / "bin/python", "-c", "import smurf; smurf.check('a')")
        self.assertIn("AttributeError: smurf.check needs the compiled module for Python 3.", done.stderr)
        self.assertIn("and this package has the programs only", done.stderr)
        done = self.call(environment / "bin/python", "-c", "import smurf; print(smurf.convert('" + str(ARM) + "', 'arm.xml', format='mjcf'))")
        self.assertIn("smurfs-flatten: wrote arm.xml", done.stdout, done.stderr)
        (self.project / "arm.xml").unlink()
        done = self.call(environment / "bin/python", "-c", "import smurf; print(smurf.__version__, hasattr(smurf, 'check'))")
        self.assertRegex(done.stdout, r"^\d+\.\d+\.\d+ False\n$")
        self.assertEqual(self.call(environment / "bin/pip", "uninstall", "-y", "smurf-tools").returncode, 0)
        left = [path for path in environment.rglob("*smurf*")]
        self.assertEqual(left, [])

    def test_what_pip_chooses_on_arm64(self):
        """Among wheels of both machines; those of glibc and of musl."""
        (self.folder / "arm64").mkdir()
        for program in PROGRAMS:  # ELF files without contents
            header = b"\x7fELF\x02\x01".ljust(18, b"\0") + (183).to_bytes(2, "little")
            (self.folder / "arm64" / program).write_bytes(header.ljust(64, b"\0"))
        for programs in (self.small, self.folder / "arm64"):
            self.assertEqual(self.build(SMURF_PREBUILT=str(programs)).returncode, 0)
        environment = self.folder / "environment"
        self.assertEqual(self.call(sys.executable, "-m", "venv", environment).returncode, 0)
        for platform in ("manylinux2014_aarch64", "manylinux_2_17_aarch64", "musllinux_1_1_aarch64"):
            done = self.call(environment / "bin/pip", "download", "--no-deps", "--only-binary=:all:", "--platform", platform,
                             "-d", self.folder / platform, "smurf-tools", PIP_FIND_LINKS=str(self.folder / "out"))
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            wheel = next((self.folder / platform).iterdir())
            self.assertIn("_aarch64", wheel.name)

    def test_what_pip_chooses_on_windows(self):
        """Among wheels of both systems."""
        (self.folder / "windows").mkdir()
        for program in PROGRAMS:  # PE files without contents
            header = b"MZ".ljust(60, b"\0") + (64).to_bytes(4, "little") + b"PE\0\0\x64\x86"
            (self.folder / "windows" / f"{program}.exe").write_bytes(header)
        for programs in (self.small, self.folder / "windows"):
            self.assertEqual(self.build(SMURF_PREBUILT=str(programs)).returncode, 0)
        environment = self.folder / "environment"
        self.assertEqual(self.call(sys.executable, "-m", "venv", environment).returncode, 0)
        done = self.call(environment / "bin/pip", "download", "--no-deps", "--only-binary=:all:", "--platform", "win_amd64",
                         "-d", self.folder / "got", "smurf-tools", PIP_FIND_LINKS=str(self.folder / "out"))
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        wheel = next((self.folder / "got").iterdir())
        self.assertTrue(wheel.name.endswith("-py3-none-win_amd64.whl"), wheel.name)
        with zipfile.ZipFile(wheel) as packed:
            scripts = {name.rpartition("/")[2] for name in packed.namelist() if "/scripts/" in name}
        self.assertEqual(scripts, {f"{program}.exe" for program in PROGRAMS})

    def test_the_line_of_the_readme(self):
        """With a folder instead of the Python index."""
        self.assertEqual(self.build(SMURF_PREBUILT=str(self.small)).returncode, 0)
        command = re.search(r"\n    pip (install .*)\n", (ROOT / "README.md").read_text())[1]
        environment = self.folder / "environment"
        self.assertEqual(self.call(sys.executable, "-m", "venv", environment).returncode, 0)
        done = self.call(environment / "bin/pip", *shlex.split(command, comments=True), PIP_FIND_LINKS=str(self.folder / "out"))
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual(self.call(environment / "bin/smurf-lint").returncode, 0)


if __name__ == "__main__":
    if not HAS_VENV:
        print("SKIPPED: the tests with pip; python3-venv is not installed (scripts/setup --readers)")
    TOOLS = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
