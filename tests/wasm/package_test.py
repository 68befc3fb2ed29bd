# SPDX-License-Identifier: BSD-3-Clause
"""The npm package, installed into an empty folder without a network: its commands, its module, its types.

usage: package_test.py FOLDER_OF_TOOLS FOLDER_OF_PACKED [READERS]
"""
import hashlib
import http.server
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
import threading
import unittest

from built import skip_without

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
ARM = ROOT / "fixtures/models/arm"
TOOLS = PACKED = READERS = None
# A stride that does not fit 32 bits: if it became 0, the tool would never terminate.
WIDE_MESH = """<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="a" count="9">0 0 0 1 0 0 0 1 0</float_array>
<technique_common><accessor source="#a" count="3" stride="4294967296"/></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene>
</COLLADA>
"""
COMMANDS = ("smurf-lint", "smurf2urdf", "urdf2smurf", "smurfs-flatten")


class Registry(http.server.BaseHTTPRequestHandler):
    """The answers to npm: the metadata of a package, and its archive."""

    def do_GET(self):
        archive = PACKED / self.path.strip("/")
        if archive.suffix == ".tgz" and archive.exists():
            answer = archive.read_bytes()
        else:
            archives = list(PACKED.glob(self.path.strip("/") + "-[0-9]*.tgz"))
            answer = self.description(archives[0]) if archives else b""
        self.send_response(200 if answer else 404)
        self.end_headers()
        self.wfile.write(answer)

    def description(self, archive):
        with tarfile.open(archive) as packed:
            manifest = json.load(packed.extractfile("package/package.json"))
        address = "http://{}:{}".format(*self.server.server_address)
        manifest["dist"] = {"tarball": f"{address}/{archive.name}", "shasum": hashlib.sha1(archive.read_bytes()).hexdigest()}
        version = manifest["version"]
        return json.dumps({"name": manifest["name"], "dist-tags": {"latest": version}, "versions": {version: manifest}}).encode()

    def log_message(self, *_):
        pass


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="smurf-npm-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        (cls.folder / "package.json").write_text("{}")
        cls.environment = {"PATH": os.environ["PATH"], "HOME": str(cls.folder), "npm_config_offline": "true",
                           "npm_config_audit": "false", "npm_config_update_notifier": "false"}
        done = cls.call("npm", "install", "--silent", *map(str, PACKED.glob("smurf-tools-*.tgz")))
        assert done.returncode == 0, done.stdout + done.stderr

    @classmethod
    def call(cls, *command, cwd=None, **options):
        return subprocess.run(command, cwd=cwd or cls.folder, env=cls.environment, capture_output=True, text=True, timeout=300,
                              check=False, **options)

    def test_version(self):
        version = re.search(r"\n  VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1]
        manifest = json.loads((self.folder / "node_modules/smurf-tools/package.json").read_text())
        self.assertEqual(manifest["version"], version)
        self.assertNotIn("dependencies", manifest)
        for command in COMMANDS:
            self.assertEqual(self.call("npx", command, "--version").stdout, f"{command} {version}\n")

    def test_from_a_registry(self):
        """The line of the README, with a local server instead of the registry of npm."""
        line = re.search(r"\n    npx (.*)\n", (ROOT / "README.md").read_text())[1]
        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Registry)
        self.addCleanup(server.server_close)
        self.addCleanup(server.shutdown)
        threading.Thread(target=server.serve_forever).start()
        folder = self.folder / "empty"
        shutil.copytree(ARM, folder / "arm")
        done = subprocess.run(["npx", "--yes", *shlex.split(line, comments=True)], cwd=folder, capture_output=True, text=True, check=False,
                              env={**self.environment, "npm_config_offline": "false", "HOME": str(folder),
                                   "npm_config_registry": "http://{}:{}".format(*server.server_address)})
        self.assertEqual((done.returncode, done.stdout), (0, "no findings in 16 files (1 model)\n"), done.stderr)
        self.assertFalse((folder / "node_modules").exists())

    def test_lint(self):
        shutil.copytree(ARM, self.folder / "arm")
        done = self.call("npx", "smurf-lint", "arm")
        self.assertEqual((done.returncode, done.stdout), (0, "no findings in 16 files (1 model)\n"), done.stderr)
        motors = self.folder / "arm/smurf/arm_motors.yml"
        motors.write_text(motors.read_text().replace("joint: joint2_shoulder", "joint: joint2_sholder"))
        done = self.call("npx", "smurf-lint", "arm")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("no such joint in `arm/urdf/arm.urdf`", done.stdout)
        self.assertEqual(self.call("npx", "smurf-lint", "--fix", "--unsafe-fixes", "arm").returncode, 0)
        self.assertEqual(motors.read_text(), (ARM / "smurf/arm_motors.yml").read_text())

    def test_standard_input(self):
        done = self.call("npx", "smurf-lint", "-", input="<robot name='a'><link name='b'/></robot>")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        done = self.call("npx", "smurf-lint", "-", input="<robot name='a'>")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)

    def test_names_that_are_not_ascii(self):
        (self.folder / "Bücher").mkdir()
        shutil.copy(ARM / "urdf/arm.urdf", self.folder / "Bücher" / "größe.urdf")
        done = self.call("npx", "smurf-lint", "--list-files", "Bücher")
        self.assertEqual(done.stdout, "Bücher/größe.urdf\n")

    def test_deep_files(self):
        for depth in (500, 200000):
            path = self.folder / "deep.urdf"
            path.write_text("<robot name='a'>" + "<a>" * depth + "</a>" * depth + "</robot>")
            done = self.call("npx", "smurf-lint", "--format=json", "deep.urdf")
            native = subprocess.run([TOOLS / "smurf-lint", "--format=json", "deep.urdf"], cwd=self.folder, capture_output=True,
                                    text=True, check=False)
            self.assertEqual((done.returncode, done.stdout), (native.returncode, native.stdout), done.stderr)

    def test_numbers_beyond_32_bits(self):
        (self.folder / "wide.urdf").write_text(
            '<robot name="a"><link name="b"><visual><geometry><mesh filename="wide.dae"/></geometry></visual></link></robot>')
        (self.folder / "wide.dae").write_text(WIDE_MESH)
        (self.folder / "wide.smurfs").write_text(
            "entities: [{name: a, type: smurf, file: wide.urdf, position: [4294967297, 0, 0], parent: nobody, anchor: 18446744073709551617}]")
        for arguments in (["--all", "wide.urdf"], ["--all", "wide.smurfs"], ["--limit=file-bytes=4294967297", "wide.urdf"]):
            done = self.call("npx", "smurf-lint", *arguments)
            native = subprocess.run([TOOLS / "smurf-lint", *arguments], cwd=self.folder, capture_output=True, text=True, check=False)
            self.assertEqual((done.returncode, done.stdout, done.stderr), (native.returncode, native.stdout, native.stderr))

    def test_module(self):
        shutil.copy(pathlib.Path(__file__).with_name("module_test.mjs"), self.folder)
        done = self.call("node", "module_test.mjs", str(ROOT / "fixtures"), str(TOOLS))
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_types(self):
        compiler = READERS / "node_modules/.bin/tsc" if READERS else None
        if compiler is None or not compiler.exists():
            self.skipTest("there is no TypeScript (scripts/setup --readers)")
        (self.folder / "use.mts").write_text(
            "import { lint, flatten, run, toSmurf, toUrdf, load, ToolError } from 'smurf-tools';\n"
            "const report = await lint({ 'a.urdf': '', 'b.stl': new Uint8Array(1) }, { args: ['--all'], paths: ['.'] });\n"
            "const line: number | undefined = report.diagnostics[0].line;\n"
            "const x: number = (await flatten({}, 'a.smurfs')).instances[0].position[0];\n"
            "const code: number = (await run('smurf-lint', [], {})).code;\n"
            "// @ts-expect-error\n"
            "await run('no-tool', [], {});\n"
            "export { line, x, code, toSmurf, toUrdf, load, ToolError };\n")
        done = self.call(str(compiler), "--noEmit", "--strict", "--module", "nodenext", "--target", "es2022", "--lib", "es2022,dom",
                         "use.mts")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


if __name__ == "__main__":
    TOOLS, PACKED = (pathlib.Path(path).resolve() for path in sys.argv[1:3])
    skip_without(TOOLS, PACKED / "package")
    if len(sys.argv) > 3:
        READERS = pathlib.Path(sys.argv[3]).resolve()
    unittest.main(argv=[sys.argv[0]], verbosity=2)
