# SPDX-License-Identifier: BSD-3-Clause
"""The playground in Chromium: it finds, fixes and converts what the native tools do, works offline, and runs no foreign code.

Usage: playground_test.py SMURF_LINT FOLDER_OF_WASM
"""
import base64
import contextlib
import functools
import http.server
import json
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import threading
import urllib.request
import zipfile

import browser
from browser import cli, reader

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "wasm"))
import built  # noqa: E402

ROOT = cli.ROOT
PAGE = "window.smurfPlayground"
CHECKED = {"until": f"{PAGE}.checker.checked === {PAGE}.files.all && !{PAGE}.checker.isChecking"}
FINDINGS = f"{PAGE}.checker.page.report.diagnostics.map(({{ id, severity, file, line, column, edits }}) =>" \
           " [id, severity, file, line, column, edits])"
FILES = f"Object.fromEntries([...{PAGE}.files.all].map(([name, bytes]) => [name, [...bytes]]))"
RESULT = f"[Object.fromEntries([...{PAGE}.convert.result].map(([name, bytes]) => [name, [...bytes]])), " \
         "document.getElementById('said').textContent]"
CONVERTED = {"until": "!document.getElementById('result').hidden"}
MESSAGE = "document.getElementById('message').textContent"
TOLD = {"until": f"{MESSAGE} !== ''"}
ARM, URDF, SCENE = range(3)  # the examples
HOSTILE = "<img src=x onerror=window.hacked=1>"


def click(selector):
    return f"document.querySelector({json.dumps(selector)}).click()"


def example(number):
    return f"document.querySelectorAll('#examples button')[{number}].click()"


def choose(select, value):
    return f"(() => {{ const list = document.getElementById('{select}'); list.value = {json.dumps(value)};" \
           " list.dispatchEvent(new Event('change')); })()"


class Site(http.server.SimpleHTTPRequestHandler):
    """Serves the playground until /stop is requested."""
    is_down = False

    def do_GET(self):
        if self.path == "/stop":
            type(self).is_down = True
        if self.is_down:
            self.close_connection = True
            self.connection.close()
        else:
            with contextlib.suppress(ConnectionError):  # a page that is closed while it loads
                super().do_GET()

    def log_message(self, *_):
        pass


class PlaygroundTest(browser.BrowserTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.site = pathlib.Path(tempfile.mkdtemp(prefix="smurf-playground-"))
        cls.addClassCleanup(shutil.rmtree, cls.site, ignore_errors=True)
        subprocess.run(["node", ROOT / "web/playground/assemble.mjs", reader.BUILD / "package", cls.site], check=True)
        cls.about = json.loads((cls.site / "about.json").read_text())

    def setUp(self):
        super().setUp()
        self.handler = type("OwnSite", (Site,), {})
        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(self.handler, directory=self.site))
        threading.Thread(target=server.serve_forever, daemon=True).start()
        self.addCleanup(server.server_close)
        self.addCleanup(server.shutdown)
        self.url = "http://{}:{}/".format(*server.server_address)

    def play(self, *steps, **job):
        return self.browse({"page": self.url, "steps": steps, **job})[0]["results"]

    def unpack(self, number):
        """The files of an example in the current folder."""
        for name, content in self.about["examples"][number]["files"].items():
            self.write(name, content if isinstance(content, str) else base64.b64decode(content["base64"]))
        return self.about["examples"][number]["targets"]

    def native(self, tool, *arguments):
        return subprocess.run([pathlib.Path(cli.TOOL).parent / tool, *arguments], cwd=self.folder, capture_output=True,
                              encoding="utf-8", check=False)

    def findings(self, *arguments):
        report = json.loads(self.native("smurf-lint", "--format=json", *arguments, ".").stdout)
        return [[one["id"], one["severity"], one["file"], one.get("line"), one.get("column"), one.get("fix", {}).get("edits")]
                for one in report["diagnostics"]]

    def contents(self):
        return {str(path.relative_to(self.folder)): list(path.read_bytes()) for path in self.folder.rglob("*") if path.is_file()}


class CheckTest(PlaygroundTest):
    def test_examples_have_the_findings_of_the_native_tool(self):
        for number, one in enumerate(self.about["examples"]):
            self.folder = pathlib.Path(tempfile.mkdtemp(dir=self.folder))
            targets = self.unpack(number)
            expected = self.findings(*([f"--target={','.join(targets)}"] if targets else []))
            self.assertTrue(expected, one["title"])
            verdicts = "[...document.querySelectorAll('#target-list b')].map((title) => title.textContent)"
            results = self.play(example(number), CHECKED, FINDINGS, "document.querySelectorAll('.finding').length", verdicts)
            self.assertEqual([[*finding[:5], finding[5] if len(finding) > 5 else None] for finding in results[2]], expected)
            severe = [finding for finding in expected if finding[1] != "info"]  # infos are shown on request
            self.assertEqual(results[3], len(severe or expected))
            self.assertEqual(len(results[4]), len(targets))

    def test_targets_are_chosen(self):
        self.unpack(ARM)
        boxes = "[...document.querySelectorAll('#programs input')].map((box) => box.value)"
        results = self.play(boxes, example(ARM), CHECKED, click("#programs [value=mujoco]"),
                            {"until": "document.querySelectorAll('#target-list li').length === 1"}, FINDINGS,
                            "document.getElementById('chosen').textContent")
        self.assertIn("mujoco", results[0])
        self.assertEqual([finding[:5] for finding in results[5]], [one[:5] for one in self.findings("--target=mujoco")])
        self.assertEqual(results[6], "mujoco")

    def test_what_is_typed_is_checked(self):
        self.write("a.urdf", '<robot name="a">\r\n<link name="b"/>\r\n</robot>\r\n')
        at_end = "(() => { const field = document.getElementById('text'); field.focus(); field.setSelectionRange(34, 34); })()"
        results = self.play({"drop": [str(self.folder / "a.urdf")]}, CHECKED, FINDINGS, at_end, {"type": "<lnk/>\n"},
                            {"until": f"{PAGE}.checker.page.report.diagnostics.length > 0"}, CHECKED, FINDINGS, FILES,
                            click("#undo"), CHECKED, FILES, FINDINGS)
        self.assertEqual((results[2], results[12]), ([], []))
        before = (self.folder / "a.urdf").read_bytes()
        typed = before.replace(b"</robot>", b"<lnk/>\r\n</robot>")
        self.assertEqual(bytes(results[8]["a.urdf"]), typed)
        self.assertEqual(bytes(results[11]["a.urdf"]), before)
        (self.folder / "a.urdf").write_bytes(typed)
        self.assertEqual([finding[:5] for finding in results[7]], [one[:5] for one in self.findings()])

    def test_files_that_a_text_field_would_change_are_only_shown(self):
        self.write("mixed.urdf", '<robot name="a">\r\n<link name="b"/>\n</robot>\n')
        self.write("bytes.urdf", b"\xff<robot/>")
        field = "[document.getElementById('text').readOnly, document.getElementById('obstacle').textContent]"
        show = "[...document.querySelectorAll('#names button')].find((one) => one.textContent.startsWith('%s')).click()"
        results = self.play({"drop": [str(self.folder / name) for name in ("mixed.urdf", "bytes.urdf")]}, CHECKED,
                            show % "mixed", field, show % "bytes", field, FILES)
        self.assertEqual(results[3][0], True)
        self.assertIn("line ends", results[3][1])
        self.assertEqual(results[5][0], True)
        self.assertIn("no text", results[5][1])
        self.assertEqual(results[6], self.contents())

    def test_a_finding_is_opened_at_its_place(self):
        selected = "(() => { const field = document.getElementById('text');" \
                   " return [document.getElementById('edited-name').textContent," \
                   " field.value.slice(field.selectionStart, field.selectionEnd), document.activeElement.id]; })()"
        edit = "[...document.querySelectorAll('.finding')].find((card) => card.textContent.includes('SML1407'))" \
               ".querySelector('.edited').click()"
        self.assertEqual(self.play(example(ARM), CHECKED, edit, selected)[3], ["urdf/arm.urdf", "1.75", "text"])

    def test_what_takes_long_can_be_stopped(self):
        self.write("a.urdf", '<robot name="a"><link name="base"/>\n' + "".join(
            f'<link name="l{i}"/><joint name="j{i}" type="fixd"><parent link="base"/><child link="l{i}"/></joint>\n'
            for i in range(60000)) + "</robot>\n")
        steps = [{"drop": [str(self.folder / "a.urdf")]}, {"until": "!document.getElementById('stop').hidden"},
                 "document.getElementById('work-status').textContent", click("#stop"),
                 {"until": "!document.getElementById('failure').hidden"}, "document.getElementById('failure').textContent",
                 "document.getElementById('stop').hidden", example(URDF), CHECKED, "document.querySelectorAll('.finding').length"]
        results = self.play(*steps)
        self.assertIn("Working", results[2])
        self.assertIn("Stopped", results[5])
        self.assertTrue(results[6])
        self.assertGreater(results[9], 0)


class FixTest(PlaygroundTest):
    def test_a_click_writes_what_the_native_tool_writes(self):
        self.unpack(ARM)
        before = self.contents()
        self.native("smurf-lint", "--fix", "--fix-only", ".")
        safe = self.contents()
        self.native("smurf-lint", "--fix", "--unsafe-fixes", "--fix-only", ".")
        everything = self.contents()
        self.assertNotEqual(before, safe)
        self.assertNotEqual(safe, everything)
        one = "[...document.querySelectorAll('.finding')].find((card) => card.textContent.includes('%s')).querySelector('.apply').click()"
        changed = {"until": f"{PAGE}.files.all !== window.before"}
        remember = f"void (window.before = {PAGE}.files.all)"
        results = self.play(example(ARM), CHECKED, FILES, one % "SML1605", CHECKED, FILES, click("#undo"), CHECKED, FILES,
                            remember, click("#fix"), changed, CHECKED, FILES, one % "SML3101", CHECKED, one % "SML1407", CHECKED,
                            FILES, FINDINGS)
        self.assertEqual([results[2], results[5], results[8], results[13], results[18]], [before, safe, before, safe, everything])
        self.assertEqual(results[19], [])


class ConvertTest(PlaygroundTest):
    # (example, file, the name of the form, tool, options, output)
    CASES = (
        (ARM, "smurf/arm.smurf", "URDF", "smurf2urdf", [], "arm.urdf"),
        (ARM, "smurf/arm.smurf", "SDF (Gazebo)", "smurfs-flatten", ["--format", "sdf", "--copy-assets", "arm_assets"], "arm.sdf"),
        (ARM, "smurf/arm.smurf", "MJCF (MuJoCo)", "smurfs-flatten", ["--format", "mjcf"], "arm.xml"),
        (ARM, "urdf/arm.urdf", "SMURF", "urdf2smurf", ["--copy-meshes"], "arm_smurf"),
        (SCENE, "base.smurf", "OpenUSD (Isaac Sim)", "smurfs-flatten", ["--format", "usda", "--copy-assets", "base_assets"], "base.usda"),
        (SCENE, "outer.smurfs", "SDF (Gazebo)", "smurfs-flatten", ["--force", "--format", "sdf", "--copy-assets", "outer_assets"], "outer.sdf"),
        (SCENE, "outer.smurfs", "MJCF (MuJoCo)", "smurfs-flatten", ["--force", "--format", "mjcf"], "outer.xml"),
        (SCENE, "outer.smurfs", "one merged URDF", "smurfs-flatten", ["--force", "--format", "urdf", "--copy-assets", "outer_assets"], "outer.urdf"),
        (SCENE, "outer.smurfs", "glTF (viewers)", "smurfs-flatten", ["--force", "--format", "gltf"], "outer.gltf"),
        (SCENE, "outer.smurfs", "JSON", "smurfs-flatten", [], "outer.json"),
    )

    def test_results_are_those_of_the_native_tools(self):
        for number in (ARM, SCENE):
            self.folder = pathlib.Path(tempfile.mkdtemp(dir=self.folder))
            self.unpack(number)
            before = self.contents()
            steps, expected = [example(number), CHECKED], []
            for _, file, form, tool, options, output in [case for case in self.CASES if case[0] == number]:
                default = ["--format", "json"] if tool == "smurfs-flatten" and not options else []
                done = self.native(tool, *options, *default, "-o", output, "--", file)
                expected.append([{name: data for name, data in self.contents().items() if name not in before}, done.stderr])
                for name in expected[-1][0]:
                    (self.folder / name).unlink()
                steps += [choose("source", file), choose("form", form),
                          f"void (document.getElementById('despite').checked = {str('--force' in options).lower()})",
                          "void (document.getElementById('result').hidden = true)", click("#convert"), CONVERTED, RESULT]
            results = self.play(*steps)[8::7]
            self.assertEqual(len(results), len(expected))
            for result, wanted, case in zip(results, expected, [case for case in self.CASES if case[0] == number]):
                self.assertEqual(result, wanted, case)
            self.assertGreater(sum(bool(files) for files, _ in expected), 3, [said for _, said in expected])

    def test_the_outermost_scene_is_offered_first(self):
        first = "document.getElementById('source').value"
        self.assertEqual(self.play(example(SCENE), CHECKED, first)[2], "outer.smurfs")

    def test_results_are_saved_and_kept(self):
        self.unpack(ARM)
        downloads = self.folder / "downloads"
        downloads.mkdir()
        names = f"[...{PAGE}.files.all.keys()]"
        save = click("#save-result")
        results = self.play({"downloads": str(downloads)}, example(ARM), CHECKED, click("#save"), {"file": str(downloads / "robot.zip")},
                            click("#convert"), CONVERTED, save, {"file": str(downloads / "arm.urdf")},
                            choose("source", "urdf/arm.urdf"), choose("form", "SMURF"),
                            "void (document.getElementById('result').hidden = true)", click("#convert"), CONVERTED, save,
                            {"file": str(downloads / "arm_smurf.zip")}, click("#keep-result"), CHECKED, names,
                            click("#save-report"), {"file": str(downloads / "report.html")})
        with zipfile.ZipFile(downloads / "robot.zip") as archive:
            self.assertIsNone(archive.testzip())
            for name in archive.namelist():
                self.assertEqual(archive.read(name), (self.folder / name).read_bytes())
            self.assertEqual(set(archive.namelist()), set(self.about["examples"][ARM]["files"]))
        self.native("smurf2urdf", "-o", "arm.urdf", "smurf/arm.smurf")
        self.assertEqual((downloads / "arm.urdf").read_bytes(), (self.folder / "arm.urdf").read_bytes())
        with zipfile.ZipFile(downloads / "arm_smurf.zip") as archive:
            self.assertIn("arm_smurf/smurf/arm.smurf", archive.namelist())
            self.assertTrue(set(archive.namelist()) <= set(results[18]))
        self.assertIn("SML3101", (downloads / "report.html").read_text())


class OpenTest(PlaygroundTest):
    def archive(self, names, name="robot.zip", method=zipfile.ZIP_DEFLATED):
        with zipfile.ZipFile(self.folder / name, "w", method) as archive:
            for path, content in names.items():
                archive.writestr(path, content)
        return str(self.folder / name)

    def test_a_folder_and_a_zip_file_are_dropped_or_chosen(self):
        self.unpack(ARM)
        inner = {f"robot/{name}": data for name, data in self.contents().items()}
        moved = self.folder / "robot"
        moved.mkdir()
        for path in list(self.folder.iterdir()):
            if path != moved:
                path.rename(moved / path.name)
        (moved / ".git").mkdir()
        (moved / ".git/config").write_text("not read")
        expected = self.findings()
        packed = self.archive({name: bytes(data) for name, data in inner.items()})
        stored = self.archive({name: bytes(data) for name, data in inner.items()}, "stored.zip", zipfile.ZIP_STORED)
        ways = [{"drop": [str(moved)]}, {"choose": "#folder", "paths": [str(moved)]}, {"drop": [packed]},
                {"choose": "#files", "paths": [stored]}]
        for way in ways:
            results = self.play(way, CHECKED, {"until": f"{PAGE}.files.all.size > 0"}, CHECKED, FILES, FINDINGS)
            self.assertEqual(results[4], inner, way)
            self.assertEqual([one[:5] for one in results[5]], [one[:5] for one in expected], way)

    def test_meshes_are_added_to_the_robot_that_is_open(self):
        robot = (cli.FIXTURES / "models/arm/urdf/arm.urdf").read_text().replace("../meshes/", "meshes/")
        self.write("arm.urdf", robot)
        meshes = self.folder / "more/meshes"
        shutil.copytree(cli.FIXTURES / "models/arm/meshes", meshes)
        missing = f"{PAGE}.checker.page.report.diagnostics.filter(({{ id }}) => id === 'SML1604').length"
        names = f"[...{PAGE}.files.all.keys()].sort()"
        results = self.play({"drop": [str(self.folder / "arm.urdf")]}, CHECKED, missing, {"drop": [str(meshes)]},
                            {"until": f"{PAGE}.files.all.size > 1"}, CHECKED, missing, names, MESSAGE, click("#undo"), names)
        self.assertGreater(results[2], 0)
        self.assertEqual(results[6], 0)
        self.assertEqual(results[7], sorted(["arm.urdf", *(f"meshes/{path.name}" for path in meshes.iterdir())]))
        self.assertEqual(results[8], f"{len(results[7]) - 1} files were added.")
        self.assertEqual(results[10], ["arm.urdf"])

    def test_a_missing_package_is_asked_for_in_the_words_of_the_page(self):
        robot = (cli.FIXTURES / "models/arm/urdf/arm.urdf").read_text().replace("../meshes/", "package://arm_parts/")
        self.write("arm.urdf", robot)
        helps = f"{PAGE}.checker.page.report.diagnostics.filter(({{ id }}) => id === 'SML1604').map(({{ help }}) => help)"
        self.assertEqual(self.play({"drop": [str(self.folder / "arm.urdf")]}, CHECKED, helps)[2],
                         ["drop the folder of the package `arm_parts` on this page, too"])

    def test_a_shared_address_stays_until_something_changes(self):
        shared = {"until": "document.getElementById('shared').textContent !== ''"}
        hash = self.play(example(URDF), CHECKED, click("#share"), shared, "location.hash")[4]
        opened = self.play({"until": f"{PAGE}.files.all.size > 0"}, CHECKED, "location.hash",
                           f"{PAGE}.files.set('more.txt', new Uint8Array(1), 'step')", "location.hash", hash=hash)
        self.assertEqual((opened[2], opened[4]), (hash, ""))

    def test_what_cannot_be_opened_is_said(self):
        whole = pathlib.Path(self.archive({"a.urdf": "<robot/>" * 100})).read_bytes()
        content = 30 + len("a.urdf")  # where it begins
        cases = {
            "cut.zip": (whole[:len(whole) // 2], "no zip file"),
            "damaged.zip": (whole[:content] + b"\xff" + whole[content + 1:], "damaged"),
            "outside.zip": (pathlib.Path(self.archive({"../a.urdf": "x"})).read_bytes(), "outside of the folder"),
            "large.zip": (pathlib.Path(self.archive({"a.urdf": bytes(210_000_000)})).read_bytes(), "more than 200 MB"),
            "no.zip": (b"no", "no zip file"),
            "empty.zip": (pathlib.Path(self.archive({})).read_bytes(), "no files"),
            "nowhere.zip": (whole[:-6] + b"\xff\xff\xff\x7f" + whole[-2:], "cut off"),
        }
        for name, (data, text) in cases.items():
            self.write(name, data)
            results = self.play({"drop": [str(self.folder / name)]}, TOLD, MESSAGE, f"{PAGE}.files.all.size")
            self.assertIn("cannot be opened", results[2], name)
            self.assertIn(text, results[2], name)
            self.assertEqual(results[3], 0)

    def test_a_link_has_the_files_and_the_targets(self):
        shared = {"until": "document.getElementById('shared').textContent !== ''"}
        results = self.play(example(URDF), CHECKED, click("#share"), shared, "location.hash", FILES, FINDINGS)
        self.assertRegex(results[4], r"^#robot=[A-Za-z0-9_-]+$")
        opened = self.play({"until": f"{PAGE}.files.all.size > 0"}, CHECKED, FILES, FINDINGS, f"{PAGE}.targets", hash=results[4])
        self.assertEqual(opened[2:4], results[5:7])
        self.assertEqual(sorted(opened[4]), sorted(self.about["examples"][URDF]["targets"]))
        cut = self.play(TOLD, MESSAGE, f"{PAGE}.files.all.size", hash=results[4][:-40])
        self.assertIn("damaged", cut[1])
        self.assertEqual(cut[2], 0)

    def test_large_robots_are_in_no_link(self):
        noise = random.Random(1)
        self.write("a.urdf", "<robot name='a'><link name='b'/></robot><!--" + "".join(
            noise.choice("abcdefghijklmnopqrstuvwxyz") for _ in range(100_000)) + "-->")
        results = self.play({"drop": [str(self.folder / "a.urdf")]}, CHECKED, click("#share"),
                            {"until": "document.getElementById('shared').textContent !== ''"},
                            "document.getElementById('shared').textContent", "location.hash")
        self.assertIn("too large for a link", results[4])
        self.assertEqual(results[5], "")

    def test_it_works_offline_after_the_first_load(self):
        first = self.play({"until": "!document.getElementById('offline').hidden"}, "fetch('/stop').catch(() => 'stopped')",
                          {"load": ""}, example(SCENE), CHECKED, FINDINGS, click("#convert"), CONVERTED, RESULT, is_hostile=True)
        self.assertEqual(first[1], "stopped")
        self.assertTrue(first[5])
        self.assertTrue(self.handler.is_down)
        with self.assertRaises(OSError):
            urllib.request.urlopen(self.url, timeout=5)


class SafetyTest(PlaygroundTest):
    def test_nothing_else_runs_and_nothing_is_fetched(self):
        self.check_nothing_else_runs(self.url)

    def test_names_and_contents_are_text(self):
        robot = f'<robot name="{HOSTILE}"><link name="{HOSTILE}"><lnk/></link></robot>'.replace("<img", "&lt;img").replace("x onerror", "x  onerror")
        self.write(f"robot/{HOSTILE}.urdf", robot)
        self.write("robot/b.urdf", '</textarea><script>window.hacked=2</script><robot name="</script><script>window.hacked=3</script>"/>')
        self.write("robot/c.smurfs", json.dumps({"entities": [{"name": HOSTILE, "file": f"{HOSTILE}.urdf", HOSTILE: "</script>"}]}))
        state = "[window.hacked, document.images.length, document.scripts.length, document.querySelectorAll('#names img').length]"
        shown = "document.getElementById('names').textContent"
        everything = "document.querySelectorAll('#report details').forEach((part) => (part.open = true))"
        shared = {"until": "document.getElementById('shared').textContent !== ''"}
        results = self.play({"drop": [str(self.folder / "robot")]}, CHECKED, {"until": f"{PAGE}.files.all.size > 0"}, CHECKED, everything,
                            "document.querySelectorAll('#names button').forEach((one) => one.click())", click("#show-robot"),
                            {"until": f"{PAGE}.checker.page.picture.isOpen || !document.getElementById('failure').hidden"},
                            f"void (document.getElementById('despite').checked = true)", click("#convert"), CONVERTED,
                            "document.querySelectorAll('#result details').forEach((part) => (part.open = true))",
                            click("#share"), shared, state, shown, "location.hash")
        self.assertEqual(results[14], [None, 0, 1, 0])
        self.assertIn(HOSTILE, results[15])
        opened = self.play({"until": f"{PAGE}.files.all.size === 3"}, CHECKED, state, hash=results[16])
        self.assertEqual(opened[2], [None, 0, 1, 0])


class UseTest(PlaygroundTest):
    def test_the_robot_is_shown(self):
        if "script-src 'self' 'wasm-unsafe-eval' 'sha256-" not in (self.site / "index.html").read_text():
            self.skipTest("the module was built without the viewer")
        selected = "[...document.querySelectorAll('.finding')].find((card) => card.textContent.includes('SML3101')).querySelector('.pictured').click()"
        viewer = f"{PAGE}.checker.page.picture.viewer().then((viewer) => new Promise((done) => setTimeout(() =>" \
                 " done([viewer.scene.entities.length, viewer.selected ?? null]), 200)))"
        is_open = {"until": f"{PAGE}.checker.page.picture.isOpen"}
        fine = cli.FIXTURES / "models/arm"
        results = self.play(example(ARM), CHECKED, selected, is_open, viewer, {"axe": True}, click("#close"),
                            {"drop": [str(fine)]}, {"until": f"{PAGE}.files.all.has('arm/urdf/arm.urdf')"}, CHECKED, FINDINGS,
                            click("#show-robot"), is_open, viewer)
        self.assertEqual(results[4][0], 1)
        self.assertEqual(results[4][1]["entity"], 0)
        self.assertEqual((results[5], results[10]), ([], []))
        self.assertEqual(results[13], [1, None])

    def test_each_of_several_robots_is_shown_with_its_joints(self):
        if "script-src 'self' 'wasm-unsafe-eval' 'sha256-" not in (self.site / "index.html").read_text():
            self.skipTest("the module was built without the viewer")
        shape = '<visual><geometry><box size="1 1 1"/></geometry></visual>'
        self.write("one.urdf", f'<robot name="one"><link name="a">{shape}</link><link name="b">{shape}</link><joint name="j" type="continuous">'
                               '<origin xyz="0 0 1"/><parent link="a"/><child link="b"/></joint></robot>')
        self.write("two.urdf.xacro", '<robot name="two" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:property name="n" value="c"/>'
                                     f'<link name="${{n}}">{shape}</link></robot>')
        offered = "[...document.getElementById('shown-robot').options].map((one) => one.value)"
        frame = "document.getElementById('viewer')"
        links = f"{frame}.contentWindow?.smurfViewer?.scene.entities[0].model.links.map((link) => link.name).join()"
        aside = f"getComputedStyle({frame}.contentDocument.querySelector('aside')).display !== 'none'"
        moves = f"{frame}.contentDocument.getElementById('moves').click()"
        results = self.play({"drop": [str(self.folder / name) for name in ("one.urdf", "two.urdf.xacro")]}, CHECKED, offered,
                            click("#show-robot"), {"until": f"{links} === 'a,b'"}, aside, moves, aside,
                            choose("shown-robot", "two.urdf.xacro"), {"until": f"{links} === 'c'"}, f"{frame}.contentDocument.smurfTakesDrops")
        self.assertEqual(results[2], ["one.urdf", "two.urdf.xacro"])
        self.assertNotEqual(results[5], results[7])
        self.assertTrue(results[10])

    def test_the_text_is_not_behind_the_picture(self):
        edit = "[...document.querySelectorAll('#report button')].find((button) => button.textContent === 'Edit').click()"
        is_open = f"{PAGE}.checker.page.picture.isOpen"
        results = self.play(example(ARM), CHECKED, click("#show-robot"), {"until": is_open}, edit,
                            f"[{is_open}, document.activeElement.id]")
        self.assertEqual(results[5], [False, "text"])

    def test_an_edit_keeps_the_search_and_the_view(self):
        viewer = "document.getElementById('viewer').contentWindow.smurfViewer"
        loaded = f"{PAGE}.checker.page.picture.viewer().then(() => new Promise((done) => setTimeout(done, 200)))"
        edit = (f"(() => {{ const name = 'urdf/arm.urdf'; const text = new TextDecoder().decode({PAGE}.files.all.get(name));"
                f" {PAGE}.files.set(name, new TextEncoder().encode(text + '<!-- -->\\n'), name); }})()")
        words = "[document.getElementById('words').value, document.getElementById('status').textContent]"
        view = f"[{viewer}.selected?.link, {viewer}.motion.positions[0].get('joint1_waist'), ...({viewer}.stage.view() ?? [])]"
        results = self.play(example(ARM), CHECKED, "document.getElementById('words').value = 'joint2'", f"{PAGE}.checker.page.filters.change()",
                            words, click("#show-robot"), {"until": f"{viewer}?.stage"}, f"{viewer}.select(0, 3)",
                            f"{viewer}.joints.set(0, new Map([['joint1_waist', 0.5]]))", f"{viewer}.stage.turn(0.5, 0.25, 0.5)", view, edit,
                            CHECKED, loaded, words, view)
        self.assertEqual(results[4][0], "joint2")
        self.assertRegex(results[4][1], "^2 of ")
        self.assertEqual(results[-2], results[4])
        before, after = results[10], results[-1]
        self.assertEqual(before[:2], [3, 0.5])
        for a, b in zip(before, after):
            self.assertAlmostEqual(a, b, 4)

    def test_everything_has_a_name_and_is_readable(self):
        fits = "[document.documentElement.scrollWidth, [...document.querySelectorAll('body *')]" \
               ".filter((part) => part.getBoundingClientRect().right > innerWidth + 1).map((part) => part.outerHTML)]"
        unfold = "document.querySelectorAll('details').forEach((part) => (part.open = true))"
        steps = [{"axe": True}, fits, example(URDF), CHECKED, click("#convert"), CONVERTED, unfold, {"axe": True}, fits]
        jobs = [{"page": self.url, "width": width, "height": 800, "scheme": scheme, "steps": steps}
                for width in (1280, 400) for scheme in ("light", "dark")]
        for job, answer in zip(jobs, self.browse(*jobs)):
            for at in (0, 7):
                self.assertEqual(answer["results"][at], [], (job["width"], job["scheme"]))
                self.assertEqual(answer["results"][at + 1], [job["width"], []])

    def test_keys_reach_everything(self):
        here = "document.activeElement.id || document.activeElement.textContent"
        steps = [value for _ in range(8) for value in ({"key": "Tab"}, here)]
        reached = self.play(*steps)[1::2]
        for name in ("open-folder", "open-files", self.about["examples"][ARM]["title"]):
            self.assertIn(name, reached)


if __name__ == "__main__":
    built.skip_without(pathlib.Path(sys.argv[1]).resolve().parent, reader.BUILD / "package")
    browser.main()
