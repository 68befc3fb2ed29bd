# SPDX-License-Identifier: BSD-3-Clause
"""The container image of smurf-lint: what is in it, how large it is, and what it finds in a folder that is mounted.

usage: container_test.py FOLDER_OF_TOOLS
"""
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
VERSION = re.search(r"\n  VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1]
MOST_BYTES = 9_000_000  # bytes stored and transferred
sys.path.insert(0, str(ROOT / "python"))
from backend.elf import Elf  # noqa: E402

TOOLS = None


class Container(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="smurf-container-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        (cls.folder / "bin").mkdir()
        subprocess.run(["strip", "-o", cls.folder / "bin/smurf-lint", TOOLS / "smurf-lint"], check=True)
        cls.archive = cls.make("image.tar")

    @classmethod
    def make(cls, name, program="smurf-lint"):
        archive = cls.folder / name
        subprocess.run([ROOT / "scripts/container", cls.folder / "bin" / program, archive], check=True)
        return archive

    def blobs(self, archive):
        """The index, the configuration and the layers of an image."""
        with tarfile.open(archive) as files:
            def read(digest):
                return files.extractfile("blobs/" + digest.replace(":", "/")).read()
            index = json.load(files.extractfile("index.json"))
            manifest = json.loads(read(index["manifests"][0]["digest"]))
            config = json.loads(read(manifest["config"]["digest"]))
            return index, config, [read(layer["digest"]) for layer in manifest["layers"]]

    def test_contents(self):
        index, config, layers = self.blobs(self.archive)
        self.assertEqual(index["manifests"][0]["annotations"]["org.opencontainers.image.ref.name"], f"smurf-lint:{VERSION}")
        self.assertEqual(config["architecture"], {"x86_64": "amd64", "aarch64": "arm64"}[os.uname().machine])
        self.assertEqual(config["config"]["Entrypoint"], ["/bin/program"])
        names, size = set(), 0
        for number, layer in enumerate(layers):
            path = self.folder / f"layer{number}"
            path.write_bytes(layer)
            with tarfile.open(path) as files:
                names |= {member.name for member in files if member.isfile()}
                size += sum(member.size for member in files)
        self.assertEqual(names, {"bin/program"})
        stored = self.archive.stat().st_size
        print(f"the image has {size:,} bytes, its archive {stored:,}")
        self.assertLess(stored, MOST_BYTES)

    def test_arm64(self):
        """The image names the architecture of the program."""
        content = bytearray((self.folder / "bin/smurf-lint").read_bytes())
        content[18:20] = (183).to_bytes(2, "little")
        (self.folder / "bin/other").write_bytes(content)
        self.assertEqual(self.blobs(self.make("other.tar", "other"))[1]["architecture"], "arm64")

    def test_two_images_are_the_same_bytes(self):
        self.assertEqual(self.blobs(self.archive), self.blobs(self.make("again.tar")))

    def test_a_program_with_shared_libraries(self):
        shutil.copy(shutil.which("git"), self.folder / "bin/git")
        done = subprocess.run([ROOT / "scripts/container", self.folder / "bin/git", self.folder / "git.tar"], capture_output=True,
                              text=True, check=False)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("the program needs lib", done.stderr)
        self.assertFalse((self.folder / "git.tar").exists())

    def test_the_line_of_the_readme(self):
        """With buildah in place of podman, which cannot be run everywhere. The findings are those of the program outside, among them
        one on a file beside the folder of the URDF."""
        line = re.search(r"\n    podman (run .*)\n", (ROOT / "README.md").read_text())[1]
        work = self.folder / "work"
        shutil.copytree(ROOT / "fixtures/models/arm", work / "arm")
        (work / "arm/meshes/forearm.obj").unlink()
        shutil.copy(self.archive, work / f"smurf-lint-{VERSION}-linux-x86_64.oci.tar")
        run, remove, option, mount, image, *arguments = shlex.split(line.replace("$PWD", str(work)))
        self.assertEqual((run, remove, option), ("run", "--rm", "-v"))
        buildah = ["buildah", "--root", self.folder / "store", "--runroot", self.folder / "run", "--storage-driver", "vfs"]
        made = subprocess.run([*buildah, "from", "--quiet", image], cwd=work, capture_output=True, text=True, check=True)
        command = [*buildah, "run", "--isolation", "chroot", "-v", f"{mount}:ro", made.stdout.strip(), "--", "/bin/program"]
        tried = subprocess.run([*command, "--version"], capture_output=True, text=True, check=False)
        if re.search("operation not permitted|permission denied", tried.stderr, re.IGNORECASE):
            self.skipTest(f"containers cannot be run here: {tried.stderr.strip()}")
        self.assertIn(VERSION, tried.stdout, tried.stderr)
        inside = subprocess.run([*command, "--format=json", *arguments], capture_output=True, text=True, check=False)
        outside = subprocess.run([TOOLS / "smurf-lint", "--format=json", *arguments], cwd=work, capture_output=True, text=True, check=False)
        self.assertEqual(inside.returncode, 1, inside.stdout + inside.stderr)
        self.assertEqual(inside.stdout, outside.stdout)
        self.assertIn("SML1604", inside.stdout)


if __name__ == "__main__":
    TOOLS = pathlib.Path(sys.argv.pop(1)).resolve()
    if shutil.which("buildah") is None:
        print("SKIPPED: buildah is not installed (scripts/setup --readers)")
        sys.exit(77)
    if Elf((TOOLS / "smurf-lint").read_bytes()).libraries:
        print("SKIPPED: smurf-lint needs shared libraries here")
        sys.exit(77)
    unittest.main()
