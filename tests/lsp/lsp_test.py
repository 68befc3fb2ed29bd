# SPDX-License-Identifier: BSD-3-Clause
"""Every capability of smurf-lsp over real standard streams. lsp_test.py SMURF-LSP [unittest option]..."""
import json
import pathlib
import re
import shutil
import struct
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).parent))
sys.path.append(str(pathlib.Path(__file__).parent.parent / "cli"))
import cli  # noqa: E402
import client  # noqa: E402
from client import apply, offset, path_of, text_in, uri  # noqa: E402

TOOL = None
FIXTURES = pathlib.Path(__file__).resolve().parent.parent.parent / "build/fixtures"
ALL = {
    "general": {"positionEncodings": ["utf-16"]},
    "workspace": {"workspaceEdit": {"documentChanges": True, "resourceOperations": ["rename"]},
                  "didChangeWatchedFiles": {"dynamicRegistration": True}},
    "window": {"workDoneProgress": True},
    "textDocument": {
        "completion": {"completionItem": {"snippetSupport": True}},
        "documentSymbol": {"hierarchicalDocumentSymbolSupport": True}}}


class LspTest(unittest.TestCase):
    maxDiff = None
    capabilities = ALL
    options = None

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="smurf-lsp-")).resolve()
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        shutil.copytree(FIXTURES / "models/arm", self.folder / "arm")
        shutil.copytree(FIXTURES / "scenes/nested", self.folder / "nested")
        self.urdf = self.folder / "arm/urdf/arm.urdf"
        self.motors = self.folder / "arm/smurf/arm_motors.yml"
        self.main = self.folder / "arm/smurf/arm.smurf"
        self.start()

    def start(self, **more):
        arguments = {"capabilities": self.capabilities, "options": self.options, **more}
        self.client = client.Client(TOOL, [self.folder], **arguments)
        self.addCleanup(self.client.end)

    def another(self, *arguments, **keywords):
        other = client.Client(TOOL, *arguments, **keywords)
        self.addCleanup(other.end)
        return other

    def peak(self):
        """The most memory that the server had so far, in MB."""
        status = pathlib.Path(f"/proc/{self.client.process.pid}/status").read_text()
        return int(re.search(r"VmHWM:\s+(\d+) kB", status).group(1)) / 1024

    def tearDown(self):
        self.assertEqual(self.client.stop(), 0)
        self.assertEqual(self.client.stderr, b"")

    def open(self, path, text=None):
        self.client.open(path, text)
        return self.client.published(path)

    def settle(self):
        """Waits until all messages except those about folders are handled."""
        self.client.of("textDocument/foldingRange", self.motors)

    def expect_soon(self, path, codes):
        """Findings of a file that is not open, which has no version to wait for."""
        end = time.monotonic() + 300
        while True:
            self.settle()
            found = self.client.diagnostics.get(str(path), {}).get("diagnostics", [])
            if {one["code"] for one in found} == set(codes) or time.monotonic() > end:
                break
            time.sleep(0.02)
        self.assertEqual({one["code"] for one in found}, set(codes))

    def find(self, path, text, behind=False, after=0):
        found = self.client.texts[str(path)].index(text, after)
        return found + (len(text) if behind else 0)

    def write(self, path, text):
        (self.folder / path).parent.mkdir(parents=True, exist_ok=True)
        (self.folder / path).write_text(text)
        return self.folder / path

    def labels(self, path, at):
        return [one["label"] for one in self.client.at("textDocument/completion", path, at)["items"]]

    def actions(self, path, at, **context):
        place = client.position(self.client.texts[str(path)], at)
        return self.client.of("textDocument/codeAction", path, range={"start": place, "end": place},
                              context={"diagnostics": [], **context})

    def applied(self, path, edit):
        """The text of a document with its part of a WorkspaceEdit."""
        for change in edit["documentChanges"]:
            if path_of(change["textDocument"]["uri"]) == str(path):
                return apply(self.client.texts[str(path)], change["edits"])
        self.fail(f"nothing changes in {path}: {edit}")


class Diagnostics(LspTest):
    def break_motor(self):
        at = self.find(self.motors, "joint: joint1_waist") + len("joint: ")
        self.client.edit(self.motors, at, at + len("joint1"), "joynt1")
        return self.client.published(self.motors)

    def test_a_clean_model(self):
        self.assertEqual(self.open(self.motors), [])

    def test_while_typing(self):
        self.open(self.motors)
        found = self.break_motor()
        self.assertEqual([one["code"] for one in found], ["SML3101"])
        one = found[0]
        self.assertEqual(text_in(self.client.texts[str(self.motors)], one["range"]), "joynt1_waist")
        self.assertEqual(one["severity"], 1)
        self.assertEqual(one["source"], "smurf-lint")
        self.assertIn("/rules/SML3101/", one["codeDescription"]["href"])
        place = one["relatedInformation"][0]["location"]
        self.assertEqual(path_of(place["uri"]), str(self.urdf))
        self.assertEqual(text_in(self.urdf.read_text(), place["range"]), "joint1_waist")
        at = self.find(self.motors, "joynt1")
        self.client.edit(self.motors, at, at + 6, "joint1")
        self.assertEqual(self.client.published(self.motors), [])

    def test_in_files_that_are_not_open(self):
        """Renaming a joint breaks the motor in another file."""
        self.open(self.urdf)
        at = self.find(self.urdf, '<joint name="joint1_waist"') + len('<joint name="')
        self.client.edit(self.urdf, at, at + 6, "joynt1")
        self.expect_soon(self.motors, ["SML3101"])
        self.client.edit(self.urdf, at, at + 6, "joint1")
        self.expect_soon(self.motors, [])

    def test_closed_again(self):
        self.open(self.motors)
        self.break_motor()
        self.client.close(self.motors)
        self.expect_soon(self.motors, [])

    def test_configuration_and_comments(self):
        self.write("arm/.smurf-lint.yaml", "severity: {unknown-joint: info}\n")
        self.open(self.motors)
        self.assertEqual([one["severity"] for one in self.break_motor()], [3])
        at = self.find(self.motors, "joynt1_waist", behind=True)
        self.client.edit(self.motors, at, at, "  # smurf-lint: ignore[SML3101]")
        self.assertEqual(self.client.published(self.motors), [])

    def test_of_a_configuration(self):
        config = self.write("arm/.smurf-lint.yaml", "")
        self.assertEqual(self.open(config, "severty: {SML3101: info}\n")[0]["code"], "SML9001")

    def test_a_yaml_file_of_nobody(self):
        stray = self.write("workflow.yml", "motors:\n- {name: 1\n")
        self.assertEqual(self.open(stray), [])

    def test_files_change(self):
        self.open(self.motors)
        text = self.urdf.read_text().replace('<joint name="joint1_waist"', '<joint name="other"')
        self.urdf.write_text(text)
        self.client.notify("workspace/didChangeWatchedFiles", {"changes": [{"uri": uri(self.urdf), "type": 2}]})
        self.client.diagnostics.clear()
        self.assertIn("SML3101", [one["code"] for one in self.client.published(self.motors)])

    def test_watchers_are_registered(self):
        self.open(self.motors)
        methods = [one["method"] for one in self.client.requests]
        self.assertIn("client/registerCapability", methods)


class Pulled(LspTest):
    capabilities = {**ALL, "textDocument": {"diagnostic": {"relatedDocumentSupport": True}}}

    def test_document(self):
        self.client.open(self.urdf)
        at = self.find(self.urdf, '<joint name="joint1_waist"') + len('<joint name="')
        self.client.edit(self.urdf, at, at + 6, "joynt1")
        report = self.client.of("textDocument/diagnostic", self.urdf)
        self.assertEqual(report["kind"], "full")
        related = report["relatedDocuments"][uri(self.motors)]
        self.assertIn("SML3101", [one["code"] for one in related["items"]])
        again = self.client.of("textDocument/diagnostic", self.urdf, previousResultId=report["resultId"])
        self.assertEqual(again["kind"], "unchanged")
        self.assertEqual(self.client.diagnostics, {})

    def tags_of(self, rule):
        """The actions for the findings of a rule in its fixture."""
        folder = next((FIXTURES / "rules").glob(f"{rule}-*")) / "bad"
        main = (sorted(folder.glob("*.smurf*")) + sorted(folder.glob("*.urdf")))[0]
        self.client.open(main)
        report = self.client.of("textDocument/diagnostic", main)
        self.client.close(main)
        found = report["items"] + [one for other in report.get("relatedDocuments", {}).values()
                                   for one in other["items"]]
        return {tuple(one.get("tags", ())) for one in found if one["code"] == rule}

    def test_tags(self):
        """`unnecessary` marks elements that every known reader ignores, and nothing that has an effect."""
        for rule in ("SML3104", "SML5208", "SML5209"):
            self.assertEqual(self.tags_of(rule), {(1,)}, rule)
        # An error; a different result; ignored by some and refused by another reader; read by Drake only.
        for rule in ("SML3101", "SML1107", "SML2014", "SML1451"):
            self.assertEqual(self.tags_of(rule), {()}, rule)

    def test_workspace(self):
        self.client.open(self.motors)
        at = self.find(self.motors, "joint: joint1_waist") + len("joint: ")
        self.client.edit(self.motors, at, at + 6, "joynt1")
        report = self.client.request("workspace/diagnostic", {"previousResultIds": []})
        found = {path_of(one["uri"]): one for one in report["items"]}
        self.assertEqual([one["code"] for one in found[str(self.motors)]["items"]], ["SML3101"])
        progress = [params["value"]["kind"] for method, params in self.client.notifications if method == "$/progress"]
        self.assertEqual((progress[0], progress[-1]), ("begin", "end"))
        known = [{"uri": one["uri"], "value": one["resultId"]} for one in report["items"]]
        again = self.client.request("workspace/diagnostic", {"previousResultIds": known})
        self.assertEqual({one["kind"] for one in again["items"]}, {"unchanged"})

    def test_closed_without_saving(self):
        """After closing, the text on disk applies again: in the findings and in the names."""
        self.client.open(self.motors, self.motors.read_text().replace("joint1_waist", "no_joint"))
        self.assertEqual(self.found_in_folder(), {"SML3101"})
        self.assertEqual(len(self.client.request("workspace/symbol", {"query": "no_joint"})), 1)
        self.client.close(self.motors)
        self.assertEqual(self.found_in_folder(), set())
        self.assertEqual(self.client.request("workspace/symbol", {"query": "no_joint"}), [])

    def found_in_folder(self):
        """The rules of the findings in the list of motors."""
        report = self.client.request("workspace/diagnostic", {"previousResultIds": []})
        return {one["code"] for file in report["items"] if path_of(file["uri"]) == str(self.motors)
                for one in file["items"]}

    def test_memory_of_many_findings(self):
        """A megabyte with 25,000 findings: they are printed one by one, because a tree of all of them needs 70 MB."""
        entry = f"- {{name: {'n' * 40}, joint: {'n' * 40}q, mimic_motor: {'n' * 40}r, joitn: j}}\n"
        self.client.open(self.motors, "motors:\n" + entry * (1_000_000 // len(entry)))
        self.client.of("textDocument/diagnostic", self.motors)
        if not cli.is_sanitized(TOOL):
            self.assertLess(self.peak(), 150)


class Refreshed(LspTest):
    """A client that requests findings is notified when to request them again."""
    capabilities = {**ALL, "workspace": {name: {"refreshSupport": True}
                                         for name in ("diagnostics", "inlayHint", "semanticTokens")},
                    "textDocument": {"diagnostic": {}}}

    def asked(self):
        self.settle()
        methods = {one["method"] for one in self.client.requests}
        self.client.requests.clear()
        return methods

    def test_files(self):
        self.client.open(self.motors)
        self.assertEqual(self.asked(), set())
        self.client.notify("workspace/didChangeWatchedFiles", {"changes": [{"uri": uri(self.urdf), "type": 2}]})
        self.assertEqual(self.asked(), {f"workspace/{name}/refresh" for name in
                                        ("diagnostic", "inlayHint", "semanticTokens")})

    def test_settings(self):
        self.asked()
        self.client.notify("workspace/didChangeConfiguration", {"settings": {"smurf": {}}})
        self.assertEqual(self.asked(), {"workspace/inlayHint/refresh"})


class Folders(LspTest):
    """A folder whose check needs a second or more."""
    def setUp(self):
        super().setUp()
        star = "".join(f'<link name="l{i}"/><joint name="j{i}" type="fixed"><parent link="b"/><child link="l{i}"/></joint>'
                       for i in range(1000))
        for i in range(200):
            self.write(f"many/r{i:03}.urdf", f'<robot name="r"><link name="b"/><link name="b"/>{star}</robot>')

    def begin(self):
        return self.client.begin("workspace/diagnostic", {"previousResultIds": []})

    def assert_cancelled(self, request):
        with self.assertRaises(client.RequestError) as caught:
            self.client.answer(request)
        self.assertEqual(caught.exception.code, -32800)

    def found(self, request):
        return {path_of(one["uri"]): [each["code"] for each in one["items"]]
                for one in self.client.answer(request)["items"]}

    def test_typing_does_not_wait(self):
        request = self.begin()
        self.open(self.motors)
        at = self.find(self.motors, "joint: joint1_waist") + len("joint: ")
        self.client.edit(self.motors, at, at + 6, "joynt1")
        self.assertEqual([one["code"] for one in self.client.published(self.motors)], ["SML3101"])
        self.client.at("textDocument/hover", self.motors, at + 1)
        self.assertFalse(request in self.client.answers)
        # The next answer contains what was typed since then.
        self.assertNotIn(str(self.motors), self.found(request))
        self.assertEqual(self.found(self.begin())[str(self.motors)], ["SML3101"])

    def test_cancelled(self):
        whole = self.found(self.begin())
        self.assertGreaterEqual(len(whole), 200)
        for path in self.folder.glob("many/*.urdf"):
            path.write_text(path.read_text().replace('name="r"', 'name="s"'))  # otherwise, all files are known
        request = self.begin()
        self.client.notify("$/cancelRequest", {"id": request})
        self.assert_cancelled(request)
        self.assertEqual(self.found(self.begin()), whole)

    def test_the_end_cancels(self):
        request = self.begin()
        waiting = self.begin()
        self.assertEqual(self.client.stop(), 0)
        while (message := self.client.inbox.get(timeout=600)) is not None:
            self.client.answers[message.get("id")] = message
        for one in (request, waiting):
            self.assert_cancelled(one)
        self.client = self.another()


class Actions(LspTest):
    def test_unsafe_fix(self):
        self.open(self.motors)
        at = self.find(self.motors, "joint: joint1_waist") + len("joint: ")
        before = self.client.texts[str(self.motors)]
        self.client.edit(self.motors, at, at + 6, "joynt1")
        self.client.published(self.motors)
        fix = self.actions(self.motors, at)[0]
        self.assertEqual(fix["title"], "Replace `joynt1_waist` by `joint1_waist` (may change the meaning of the model)")
        self.assertFalse(fix["isPreferred"])
        self.assertEqual(self.applied(self.motors, fix["edit"]), before)

    def test_suppress(self):
        self.open(self.motors)
        at = self.find(self.motors, "joint: joint1_waist") + len("joint: ")
        self.client.edit(self.motors, at, at + 6, "joynt1")
        self.client.published(self.motors)
        action = next(one for one in self.actions(self.motors, at) if one["title"].startswith("Ignore SML3101"))
        self.client.replace(self.motors, self.applied(self.motors, action["edit"]))
        self.assertEqual(self.client.published(self.motors), [])

    def test_suppress_in_a_tag_of_several_lines(self):
        urdf = self.write("r.urdf", '<robot name="r">\n  <link name="a"/>\n  <link\n    name="a"/>\n</robot>\n')
        found = self.open(urdf)
        at = offset(self.client.texts[str(urdf)], found[0]["range"]["start"])
        action = next(one for one in self.actions(urdf, at) if one["title"].startswith("Ignore"))
        self.client.replace(urdf, self.applied(urdf, action["edit"]))
        self.assertEqual([one["code"] for one in self.client.published(urdf) if one["code"] == found[0]["code"]], [])

    def test_other_inertias(self):
        text = ('<robot name="r">\n  <link name="a">\n    <inertial>\n      <mass value="0.5"/>\n'
                '      <inertia ixx="6700" ixy="0" ixz="0" iyy="6700" iyz="0" izz="130"/>\n    </inertial>\n'
                '    <collision><geometry><cylinder radius="0.02" length="0.4"/></geometry></collision>\n  </link>\n</robot>\n')
        robot = self.write("r.urdf", text)
        found = next(one for one in self.open(robot) if one["code"] == "SML1518")
        at = offset(text, found["range"]["start"])
        actions = [one for one in self.actions(robot, at) if one["title"].startswith("Replace the inertia: ")]
        self.assertEqual([one["title"].split(",")[0] for one in actions],
                         ["Replace the inertia: its shapes", "Replace the inertia: the box around its shapes"])
        self.client.replace(robot, self.applied(robot, actions[0]["edit"]))
        self.assertNotIn("SML1518", [one["code"] for one in self.client.published(robot)])
        self.assertIn('<mass value="0.5"/>', self.client.texts[str(robot)])

    def test_an_absent_inertia_and_those_of_several_links(self):
        link = ('  <link name="{0}"><inertial><mass value="0.5"/>{1}</inertial><collision><geometry><box size="0.1 0.1 0.1"/>'
                "</geometry></collision></link>\n")
        unit = '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'
        joint = '  <joint name="{0}_j" type="fixed"><parent link="a"/><child link="{0}"/><origin xyz="{1} 0 0"/></joint>\n'
        text = ('<robot name="r">\n' + link.format("a", "") + link.format("b", unit) + link.format("c", unit)
                + joint.format("b", 1) + joint.format("c", 2) + "</robot>\n")
        robot = self.write("r.urdf", text)
        found = {one["code"]: offset(text, one["range"]["start"]) for one in self.open(robot)}
        titled = {one["title"].split(",")[0]: one for code in ("SML1505", "SML1516") for one in self.actions(robot, found[code])}
        for title, filled in (("Add the inertia: its shapes", 1), ("Replace the inertia: its shapes", 1),
                              ("Replace 2 inertias: their shapes", 2)):
            self.assertEqual(self.applied(robot, titled[title]["edit"]).count('ixx="0.0008333333"'), filled, title)

    def test_no_comment_before_the_declaration_of_xml(self):
        robot = self.write("r.urdf", '\n<?xml version="1.0"?>\n<robot name="r"><link name="a"/></robot>\n')
        self.assertEqual([one["code"] for one in self.open(robot)], ["SML1005"])
        titles = [one["title"] for one in self.actions(robot, 0)]
        self.assertTrue(titles)
        self.assertFalse([one for one in titles if one.startswith("Ignore")], titles)

    def test_safe_fixes(self):
        """All of them at once, and each as a preferred one."""
        fixed = 0
        for folder in sorted((FIXTURES / "rules").glob("*/bad")):
            expected = folder / "expected.json"
            if expected.exists() and '"safe"' not in expected.read_text() or fixed >= 3:
                continue
            for path in sorted(folder.glob("*.urdf")) + sorted(folder.glob("*.yml")):
                copy = self.folder / folder.parent.name
                shutil.copytree(folder, copy, dirs_exist_ok=True)
                self.open(copy / path.name)
                text = self.client.texts[str(copy / path.name)]
                everything = self.client.of("textDocument/codeAction", copy / path.name, range={
                    "start": {"line": 0, "character": 0}, "end": client.position(text, len(text))},
                    context={"diagnostics": [], "only": ["source.fixAll"]})
                if not everything:
                    continue
                self.assertEqual([one["kind"] for one in everything], ["source.fixAll"])
                before = len(self.client.published(copy / path.name))
                self.client.replace(copy / path.name, self.applied(copy / path.name, everything[0]["edit"]))
                self.assertLess(len(self.client.published(copy / path.name)), before)
                fixed += 1
        self.assertGreater(fixed, 0)

    def test_what_readers_make(self):
        self.open(self.motors)
        at = self.find(self.motors, "joint: joint1_waist") + len("joint: ")
        self.client.edit(self.motors, at, at + 6, "joynt1")
        self.client.published(self.motors)
        command = next(one["command"] for one in self.actions(self.motors, at) if "command" in one)
        page = self.client.request("workspace/executeCommand", {"command": command["command"],
                                                                "arguments": command["arguments"]})
        self.assertIn("What readers make of it", page)
        self.assertIn("window/showMessage", [method for method, _ in self.client.notifications])


class Names(LspTest):
    def setUp(self):
        super().setUp()
        self.open(self.motors)
        self.at = self.find(self.motors, "joint: joint1_waist") + len("joint: ") + 3

    def test_definition(self):
        for at in (self.at, self.at - 3, self.find(self.motors, "joint: joint1_waist", behind=True)):
            places = self.client.at("textDocument/definition", self.motors, at)
            self.assertEqual([path_of(one["uri"]) for one in places], [str(self.urdf)])
            self.assertEqual(text_in(self.urdf.read_text(), places[0]["range"]), "joint1_waist")

    def test_definition_of_a_file(self):
        self.open(self.main)
        places = self.client.at("textDocument/definition", self.main, self.find(self.main, "arm_motors"))
        self.assertEqual([path_of(one["uri"]) for one in places], [str(self.motors)])

    def test_references(self):
        places = self.client.at("textDocument/references", self.motors, self.at, context={"includeDeclaration": True})
        for one in places:
            self.assertEqual(text_in(pathlib.Path(path_of(one["uri"])).read_text(), one["range"]), "joint1_waist")
        files = {pathlib.Path(path_of(one["uri"])).name for one in places}
        self.assertLessEqual({"arm.urdf", "arm_motors.yml", "arm_sensors.yml", "arm_submechanisms.yml"}, files)
        uses = self.client.at("textDocument/references", self.motors, self.at, context={"includeDeclaration": False})
        self.assertEqual(len(uses), len(places) - 1)

    def test_highlights(self):
        self.open(self.urdf)
        at = self.find(self.urdf, '<link name="turret"', behind=True) - 3
        places = self.client.at("textDocument/documentHighlight", self.urdf, at)
        self.assertEqual(sorted(one["kind"] for one in places)[-1], 3)
        self.assertGreater(len(places), 2)
        for one in places:
            self.assertEqual(text_in(self.client.texts[str(self.urdf)], one["range"]), "turret")

    def test_rename(self):
        self.open(self.urdf)
        prepared = self.client.at("textDocument/prepareRename", self.motors, self.at)
        self.assertEqual(prepared["placeholder"], "joint1_waist")
        edit = self.client.at("textDocument/rename", self.motors, self.at, newName="waist")
        changed = {path_of(one["textDocument"]["uri"]): one for one in edit["documentChanges"]}
        self.assertGreaterEqual(len(changed), 5)
        self.assertEqual(changed[str(self.motors)]["textDocument"]["version"], 1)
        self.assertIsNone(changed[str(self.folder / "arm/smurf/arm_sensors.yml")]["textDocument"]["version"])
        for path, change in changed.items():
            text = pathlib.Path(path).read_text()
            for one in change["edits"]:
                self.assertEqual((text_in(text, one["range"]), one["newText"]), ("joint1_waist", "waist"))
            if path in self.client.texts:
                self.client.replace(path, apply(text, change["edits"]))
            else:
                pathlib.Path(path).write_text(apply(text, change["edits"]))
        self.client.notify("workspace/didChangeWatchedFiles", {"changes": []})
        self.expect_soon(self.motors, [])

    def test_rename_in_models_that_share_a_file(self):
        """The joints of all robots that the same list of motors names are renamed together."""
        robot = ('<robot name="r"><link name="a"/><link name="b"/><joint name="JOINT" type="continuous">'
                 '<parent link="a"/><child link="b"/></joint></robot>\n')
        for model in "ab":
            self.write(f"shared/{model}.smurf", f"modelname: r\nfiles: [{model}.urdf, m.yml]\n")
            self.write(f"shared/{model}.urdf", robot.replace("JOINT", "elbow"))
        motors = self.write("shared/m.yml", "motors:\n- {name: m, joint: elbow}\n")
        self.open(motors)
        edit = self.client.at("textDocument/rename", motors, self.find(motors, "elbow") + 1, newName="knee")
        changed = {pathlib.Path(path_of(one["textDocument"]["uri"])).name for one in edit["documentChanges"]}
        self.assertEqual(changed, {"a.urdf", "b.urdf", "m.yml"})
        self.assertEqual(self.applied(motors, edit), "motors:\n- {name: m, joint: knee}\n")
        # The name of the shared file is reported, and so is a joint of a shared robot.
        edit = self.client.at("textDocument/rename", motors, self.find(motors, "m, joint"), newName="drive")
        self.assertEqual(self.applied(motors, edit), "motors:\n- {name: drive, joint: elbow}\n")
        for model in "ab":
            self.write(f"shared/{model}.smurf", f"modelname: r\nfiles: [a.urdf, {model}.yml]\n")
            self.write(f"shared/{model}.yml", "motors:\n- {name: m, joint: elbow}\n")
        own = self.folder / "shared/a.yml"
        self.open(own)
        edit = self.client.at("textDocument/rename", own, self.find(own, "elbow") + 1, newName="knee")
        changed = {pathlib.Path(path_of(one["textDocument"]["uri"])).name for one in edit["documentChanges"]}
        self.assertEqual(changed, {"a.urdf", "a.yml", "b.yml"})

    def test_rename_in_a_package(self):
        """Files that a model only reads are not changed: an editor would write to files that nobody opened."""
        robot = self.write("opt/pkg/r.urdf", '<robot name="r"><link name="a"/></robot>\n')
        (self.folder / "opt/pkg/.git").mkdir()
        (self.folder / "own/.git").mkdir(parents=True)
        self.write("own/r.smurf", "modelname: r\nfiles: [../opt/pkg/r.urdf, m.yml]\n")
        sensors = self.write("own/m.yml", "sensors:\n- {name: s, type: NodeIMU, link: a}\n")
        other = self.another([self.folder / "own"], capabilities=ALL, cwd=self.folder)
        other.open(self.folder / "own/r.smurf")
        other.open(sensors)
        at = other.texts[str(sensors)].index("link: a") + len("link: ")
        with self.assertRaisesRegex(client.RequestError, "r.urdf' is in no project of the named files$"):
            other.at("textDocument/rename", sensors, at, newName="b")
        other.open(robot)
        edit = other.at("textDocument/rename", sensors, at, newName="b")
        self.assertEqual({path_of(one["textDocument"]["uri"]) for one in edit["documentChanges"]}, {str(robot), str(sensors)})

    def test_lines_that_an_editor_counts_differently(self):
        """A carriage return alone ends a line in some editors, so an edit of a file that they open could hit another line."""
        self.write("cr/r.smurf", "modelname: r\nfiles: [r.urdf, m.yml]\n")
        robot = self.write("cr/r.urdf", '<robot name="r"><link name="a"/></robot>\n')
        (self.folder / "cr/m.yml").write_bytes(b"# a\rb\nsensors:\n- {name: s, type: NodeIMU, link: a}\n")
        self.write("cr/.git/HEAD", "")
        self.open(robot)
        self.open(self.folder / "cr/r.smurf")
        at = self.find(robot, 'link name="a', behind=True)
        with self.assertRaisesRegex(client.RequestError, "cr/m.yml' contains a carriage return alone"):
            self.client.at("textDocument/rename", robot, at, newName="b")
        self.client.open(self.folder / "cr/m.yml")
        edit = self.client.at("textDocument/rename", robot, at, newName="b")
        self.assertEqual(len(edit["documentChanges"]), 2)

    def many_uses(self, number):
        """A model with one link, and one sensor that names it `number` times."""
        model = self.write("many/r.smurf", "modelname: r\nfiles: [r.urdf, m.yml]\n")
        self.write("many/r.urdf", '<robot name="r"><link name="a"/></robot>\n')
        sensors = self.write("many/m.yml", f"sensors:\n- {{name: s, type: NodePosition, links: [{', '.join('a' * number)}]}}\n")
        self.client.open(model)
        self.client.open(sensors)
        return sensors, self.find(sensors, "[a") + 1

    def places(self, sensors, at):
        return len(self.client.at("textDocument/references", sensors, at, context={"includeDeclaration": True}))

    def test_many_uses(self):
        if cli.is_sanitized(TOOL):
            self.skipTest("sanitizers take a multiple of the memory and time")
        sensors, at = self.many_uses(99_999)
        self.assertEqual(self.places(sensors, at), 100_000)
        edit = self.client.at("textDocument/rename", sensors, at, newName="b")
        self.assertEqual(sum(len(one["edits"]) for one in edit["documentChanges"]), 100_000)

    def test_memory_of_too_many_uses(self):
        """A megabyte of one name. The first 100,000 places are shown; more cannot be renamed."""
        if cli.is_sanitized(TOOL):
            self.skipTest("sanitizers take a multiple of the memory and time")
        sensors, at = self.many_uses(330_000)
        self.assertEqual(self.places(sensors, at), 100_000)
        with self.assertRaisesRegex(client.RequestError, "has 330001 places, .* use `smurf-lint --rename`"):
            self.client.at("textDocument/rename", sensors, at, newName="b")
        # Each of the places has the URI of its file. 297 MB, and 20 more where an answer grows beside another one.
        self.assertLess(self.peak(), 400)

    def test_memory_of_many_symbols(self):
        """A megabyte of keys: trees for all of them need 340 MB."""
        if cli.is_sanitized(TOOL):
            self.skipTest("sanitizers take a multiple of the memory and time")
        keys = self.write("arm/smurf/arm_motors.yml", "".join(f"k{i}: [1, {{a: b}}]\n" for i in range(55_000)))
        self.open(keys)
        symbols = self.client.of("textDocument/documentSymbol", keys)
        self.assertEqual((len(symbols), len(symbols[-1]["children"])), (55_000, 2))
        self.assertLess(self.peak(), 200)

    def test_files_of_ros(self):
        """Completion and hover of parameter files, SRDF and ros2_control."""
        limits = self.write("arm/config/joint_limits.yaml",
                            "joint_limits:\n  joint1_waist:\n    has_velocity_limits: true\n    \n")
        self.client.open(limits)
        labels = self.labels(limits, len(limits.read_text()) - 1)
        self.assertIn("max_velocity", labels)
        self.assertNotIn("has_velocity_limits", labels)
        said = self.client.at("textDocument/hover", limits, self.find(limits, "has_velocity") + 3)["contents"]["value"]
        self.assertIn("Whether max\\_velocity counts" if "\\_" in said else "Whether max_velocity counts", said)
        text = ("controller_manager:\n  ros__parameters:\n    mover:\n      type: joint_trajectory_controller/JointTrajectoryController\n"
                "mover:\n  ros__parameters:\n    joints: [joint1_waist]\n    interpolation_method: \n    gains:\n      joint1_waist:\n        p: 1.0\n        \n    \n")
        controllers = self.write("arm/config/controllers.yaml", text)
        self.client.open(controllers)
        self.assertEqual(self.labels(controllers, text.index("method: ") + 8), ["splines", "none"])
        self.assertIn("constraints", self.labels(controllers, len(text) - 1))
        self.assertIn("ff_velocity_scale", self.labels(controllers, text.index("1.0\n") + 12))
        self.assertIn("joint1_waist", self.labels(controllers, text.index("[joint1") + 1))
        self.assertIn("diff_drive_controller/DiffDriveController", self.labels(controllers, text.index("type: ") + 6))
        said = self.client.at("textDocument/hover", controllers, text.index("p: 1.0"))["contents"]["value"]
        self.assertIn("proportional gain", said)
        srdf = self.write("arm/srdf/arm.srdf", '<robot name="arm">\n  <group name="all"><joint name="joint1_waist"/></group>\n  <\n</robot>\n')
        self.client.open(srdf, language="xml")
        at = self.find(srdf, "<\n") + 1
        self.assertIn("end_effector", self.labels(srdf, at))
        self.assertNotIn("inertial", self.labels(srdf, at))
        robot = ('<robot name="arm">\n  <link name="a"/>\n  <ros2_control name="b" type="system">\n    <joint name="c">\n'
                 '      <command_interface name="position"/>\n    </joint>\n    <\n  </ros2_control>\n</robot>\n')
        urdf = self.write("arm/urdf/other.urdf", robot)
        self.client.open(urdf, language="xml")
        self.assertIn("sensor", self.labels(urdf, robot.index("<\n") + 1))
        self.assertIn("velocity", self.labels(urdf, robot.index("position")))

    def test_srdf(self):
        """Open alone in the editor: definition, references and rename."""
        srdf = self.write("arm/srdf/arm.srdf", '<robot name="arm">\n  <group name="all"><joint name="joint1_waist"/>'
                          '</group>\n  <disable_collisions link1="turret" link2="upper_arm" reason="Adjacent"/>\n'
                          '</robot>\n')
        self.client.close(self.motors)
        self.client.open(srdf, language="xml")
        at = self.find(srdf, "joint1_waist") + 3
        places = self.client.at("textDocument/definition", srdf, at)
        self.assertEqual([(path_of(one["uri"]), text_in(self.urdf.read_text(), one["range"])) for one in places],
                         [(str(self.urdf), "joint1_waist")])
        places = self.client.at("textDocument/references", srdf, self.find(srdf, "turret") + 3,
                                context={"includeDeclaration": True})
        self.assertLessEqual({srdf.name, "arm.urdf", "arm_collision.yml"},
                             {pathlib.Path(path_of(one["uri"])).name for one in places})
        for attribute in ("link1", "link2"):
            self.assertLessEqual({"turret", "upper_arm"}, set(self.labels(srdf, self.find(srdf, attribute) + 7)))
        edit = self.client.at("textDocument/rename", srdf, at, newName="waist")
        self.assertEqual(self.applied(srdf, edit), self.client.texts[str(srdf)].replace("joint1_waist", "waist"))
        changed = {pathlib.Path(path_of(one["textDocument"]["uri"])).name for one in edit["documentChanges"]}
        self.assertLessEqual({srdf.name, "arm.urdf", "arm_motors.yml", "arm_sensors.yml"}, changed)
        # The names in the URDF are renamed as well.
        self.client.close(srdf)
        self.open(self.urdf)
        at = self.find(self.urdf, '<joint name="joint1_waist') + len('<joint name="')
        edit = self.client.at("textDocument/rename", self.urdf, at, newName="waist")
        self.assertIn(srdf.name, [pathlib.Path(path_of(one["textDocument"]["uri"])).name
                                  for one in edit["documentChanges"]])

    def test_rename_in_a_scene(self):
        scene = self.folder / "nested/outer.smurfs"
        self.open(scene)
        text = self.client.texts[str(scene)]
        name = next(line.split("name:")[1].split(",")[0].strip() for line in text.split("\n") if "name:" in line)
        edit = self.client.at("textDocument/rename", scene, text.index(name) + 1, newName="other_name")
        self.assertIn("other_name", self.applied(scene, edit))

    def test_rename_a_file(self):
        for new, main in (("arm/smurf/drives.yml", "- drives.yml"), ("arm/other/drives.yml", "- ../other/drives.yml")):
            edit = self.client.request("workspace/willRenameFiles", {"files": [{
                "oldUri": uri(self.motors), "newUri": uri(self.folder / new)}]})
            self.open(self.main)
            self.assertEqual(self.applied(self.main, edit),
                             self.main.read_text().replace("- arm_motors.yml", main))
        edit = self.client.request("workspace/willRenameFiles", {"files": [{
            "oldUri": uri(self.folder / "arm/meshes/forearm.obj"), "newUri": uri(self.folder / "arm/meshes/new.obj")}]})
        self.open(self.urdf)
        self.assertIn("meshes/new.obj", self.applied(self.urdf, edit))
        self.assertIsNone(self.client.request("workspace/willRenameFiles", {"files": [{
            "oldUri": uri(self.folder / "nothing"), "newUri": uri(self.folder / "new")}]}))

    @staticmethod
    def lines_of(found):
        return sorted((pathlib.Path(path_of(one["uri"])).name, one["range"]["start"]["line"]) for one in found)

    def test_names_of_files(self):
        """All places that name a mesh."""
        self.open(self.urdf)
        text = self.urdf.read_text()
        at = self.find(self.urdf, "forearm.obj")
        lines = [i for i, line in enumerate(text.split("\n")) if "forearm.obj" in line]
        found = self.client.at("textDocument/references", self.urdf, at, context={"includeDeclaration": True})
        self.assertEqual(self.lines_of(found), [("arm.urdf", line) for line in lines])
        self.assertEqual(len(self.client.at("textDocument/documentHighlight", self.urdf, at)), len(lines))
        self.open(self.main)
        at = self.find(self.main, "arm_motors.yml") + 2
        found = self.client.at("textDocument/references", self.main, at, context={"includeDeclaration": True})
        self.assertEqual([name for name, _ in self.lines_of(found)], ["arm.smurf"])

    def test_rename_a_file_by_its_name(self):
        self.open(self.main)
        at = self.find(self.main, "arm_motors.yml") + 2
        prepared = self.client.at("textDocument/prepareRename", self.main, at)
        self.assertEqual(prepared["placeholder"], "arm_motors.yml")
        self.assertEqual(text_in(self.client.texts[str(self.main)], prepared["range"]), "arm_motors.yml")
        edit = self.client.at("textDocument/rename", self.main, at, newName="drives.yml")
        self.assertEqual(edit["documentChanges"].pop(), {
            "kind": "rename", "oldUri": uri(self.motors), "newUri": uri(self.motors.with_name("drives.yml"))})
        self.assertEqual(self.applied(self.main, edit), self.main.read_text().replace("arm_motors", "drives"))
        for name in ("arm_sensors.yml", "../x.yml", "", ".."):
            with self.assertRaises(client.RequestError):
                self.client.at("textDocument/rename", self.main, at, newName=name)

    def test_rename_a_folder(self):
        self.open(self.urdf)
        edit = self.client.request("workspace/willRenameFiles", {"files": [{
            "oldUri": uri(self.folder / "arm/meshes"), "newUri": uri(self.folder / "arm/shapes")}]})
        self.assertEqual(self.applied(self.urdf, edit), self.urdf.read_text().replace("../meshes/", "../shapes/"))
        # A file that moves still finds its meshes.
        edit = self.client.request("workspace/willRenameFiles", {"files": [{
            "oldUri": uri(self.urdf), "newUri": uri(self.folder / "arm/a/b/arm.urdf")}]})
        self.assertEqual(self.applied(self.urdf, edit), self.urdf.read_text().replace("../meshes/", "../../meshes/"))
        # The whole folder of a model moves, so no path in it changes.
        self.assertIsNone(self.client.request("workspace/willRenameFiles", {"files": [{
            "oldUri": uri(self.folder / "arm"), "newUri": uri(self.folder / "robot")}]}))

    @staticmethod
    def said(scalar):
        """By a scalar of YAML in a list with brackets."""
        if scalar.startswith('"'):
            return json.loads(scalar)
        if scalar.startswith("'"):
            assert "'" not in scalar[1:-1].replace("''", ""), scalar
            return scalar[1:-1].replace("''", "'")
        assert re.fullmatch(r"[\w.][\w./-]*", scalar), scalar
        return scalar

    def test_rename_a_file_to_a_name_of_many_signs(self):
        model = self.folder / "r.smurf"
        names = {"a.yml": "a.yml", "b.yml": '"b.yml"', "c.yml": "'c.yml'", "r.urdf": "r.urdf"}
        model.write_text("modelname: r\nfiles: [" + ", ".join(names.values()) + "]\n")
        for name in "abc":
            (self.folder / f"{name}.yml").write_text("motors: []\n")
        robot = self.folder / "r.urdf"
        robot.write_text('<robot name="r"><link name="b"><visual><geometry><mesh filename="m&amp;n.stl"/></geometry>'
                         "</visual></link></robot>")
        (self.folder / "m&n.stl").write_text("solid\nendsolid\n")
        self.open(model)
        self.open(robot)
        for new in ("x, y: z #\"'&<]\\", "- x", "x'y", 'x"y'):
            for folder in ("", f"{new}/"):
                for old in names:
                    edit = self.client.request("workspace/willRenameFiles", {"files": [{
                        "oldUri": uri(self.folder / old), "newUri": uri(self.folder / f"{folder}{new}.yml")}]})
                    text, = {one["newText"] for one in edit["documentChanges"][0]["edits"]}
                    self.assertEqual(self.said(text), f"{folder}{new}.yml")
                edit = self.client.request("workspace/willRenameFiles", {"files": [{
                    "oldUri": uri(self.folder / "m&n.stl"), "newUri": uri(self.folder / f"{folder}{new}.stl")}]})
                mesh = xml.etree.ElementTree.fromstring(self.applied(robot, edit)).find(".//mesh")
                self.assertEqual(mesh.get("filename"), f"{folder}{new}.stl")
        self.assertIsNone(self.client.request("workspace/willRenameFiles", {"files": [{
            "oldUri": uri(self.folder / "a.yml"), "newUri": uri(self.folder / "x\nmotors: []\n/a.yml")}]}))

    def test_a_new_folder_is_in_the_project_around_it(self):
        """The folder of a new file does not exist yet. Files outside of the repository are not read."""
        self.write("v/secret.yml", "motors:\n- {name: TOPSECRET, joint: j}\n")
        (self.folder / "p/.git").mkdir(parents=True)
        self.write("p/r.smurf", "modelname: r\nfiles: [r.urdf, ../v/secret.yml]\n")
        self.write("p/r.urdf", '<robot name="r"><link name="b"/></robot>')
        other = self.another([self.folder / "p"], capabilities=self.capabilities, cwd=self.folder / "p")
        other.open(self.folder / "p/q/r.urdf", '<robot name="r"><link name="visible"/></robot>')
        found = other.request("workspace/symbol", {"query": ""})
        self.assertEqual({one["name"] for one in found} & {"visible", "TOPSECRET"}, {"visible"})
        self.assertEqual(other.stop(), 0)

    def test_no_name_becomes_markup(self):
        self.write("m.smurf", "modelname: m\nfiles: [m.urdf, m.yml]\n")
        self.write("m.urdf", '<robot name="m"><link name="a"/></robot>')
        text = "motors:\n- {name: \"a`` ``` b\", joint: j, type: \"![i](https://example.org/x.png)\"}\n"
        motors = self.write("m.yml", text)
        self.open(motors)
        said = self.client.at("textDocument/hover", motors, text.index("a``"))["contents"]["value"]
        self.assertIn("\\!\\[i", said)

    def test_rename_to_a_name_that_is_taken(self):
        with self.assertRaisesRegex(client.RequestError, "there is a joint `joint2_shoulder` already"):
            self.client.at("textDocument/rename", self.motors, self.at, newName="joint2_shoulder")
        self.assertEqual(self.client.at("textDocument/hover", self.motors, self.at)["contents"]["kind"], "markdown")

    def test_no_name(self):
        at = self.find(self.motors, "# motors")
        self.assertIsNone(self.client.at("textDocument/prepareRename", self.motors, at))
        self.assertEqual(self.client.at("textDocument/definition", self.motors, at), [])
        with self.assertRaises(client.RequestError):
            self.client.at("textDocument/rename", self.motors, at, newName="x")

    def test_workspace_symbols(self):
        found = self.client.request("workspace/symbol", {"query": "jelbow"})
        self.assertIn(("joint3_elbow", "joint"), {(one["name"], one["containerName"]) for one in found})
        self.client.close(self.motors)  # the text is still in the folder
        found = self.client.request("workspace/symbol", {"query": "joint3_elbow"})
        self.assertEqual(len({json.dumps(one) for one in found}), len(found))
        self.assertEqual({one["containerName"] for one in found}, {"joint", "motor"})


class Hover(LspTest):
    def hover(self, path, at):
        answer = self.client.at("textDocument/hover", path, at)
        return answer and answer["contents"]["value"]

    def test_names(self):
        self.open(self.motors)
        text = self.hover(self.motors, self.find(self.motors, "joint: joint2_shoulder", behind=True) - 2)
        for part in ("joint `joint2_shoulder`: revolute", "deg", "N m", "driven by", "arm.urdf:"):
            self.assertIn(part, text)
        self.open(self.urdf)
        text = self.hover(self.urdf, self.find(self.urdf, '<link name="turret"', behind=True) - 2)
        for part in ("link `turret`: 1.2 kg", "carried by link `pedestal`", "seen from `base_link`"):
            self.assertIn(part, text)

    def test_keys(self):
        self.open(self.motors)
        text = self.hover(self.motors, self.find(self.motors, "maxEffort") + 2)
        self.assertIn("`maxEffort` (motor)", text)
        self.assertIn("N m", text)
        self.assertIn("Read by MARS", text)
        self.open(self.urdf)
        self.assertIn("Largest torque or force", self.hover(self.urdf, self.find(self.urdf, "effort=") + 1))
        self.assertIn("Limits of the joint", self.hover(self.urdf, self.find(self.urdf, "<limit") + 2))

    def test_pose(self):
        self.open(self.urdf)
        self.assertIn("seen from", self.hover(self.urdf, self.find(self.urdf, "<origin") + 2))
        scene = self.folder / "nested/outer.smurfs"
        self.open(scene)
        self.assertIn("in the world: xyz", self.hover(scene, self.find(scene, "position:") + 2))

    def test_pose_of_a_shape(self):
        """The origin of a visual is in the frame of its link."""
        robot = self.write("r.urdf", """<robot name="r"><link name="a"/>
            <joint name="j" type="fixed"><origin xyz="1 0 0"/><parent link="a"/><child link="b"/></joint>
            <link name="b"><visual><origin xyz="0 2 0"/><geometry><box size="1 1 1"/></geometry></visual></link></robot>""")
        self.open(robot)
        self.assertIn("seen from `a`, all joints at 0: xyz 1 2 0 ", self.hover(robot, self.find(robot, '"0 2 0"') + 1))
        self.assertIn("seen from `a`, all joints at 0: xyz 1 0 0 ", self.hover(robot, self.find(robot, '"1 0 0"') + 1))

    def test_file(self):
        self.open(self.main)
        self.assertIn(str(self.motors), self.hover(self.main, self.find(self.main, "arm_motors.yml") + 1))

    def test_mesh(self):
        self.open(self.urdf)
        text = self.hover(self.urdf, self.find(self.urdf, "upper_arm.obj"))
        self.assertIn("triangles", text)
        self.assertIn(" m\n", text + "\n")
        self.assertIn("no unit", text)

    def test_unit_of_a_mesh(self):
        """The size is in metres, independently of the unit of the file."""
        self.write("m.dae", """<COLLADA version="1.4.1"><asset><unit meter="0.001"/><up_axis>Z_UP</up_axis></asset>
            <library_geometries><geometry id="g"><mesh><source id="p"><float_array id="f" count="9">0 0 0 500 0 0 0 250 0</float_array>
            <technique_common><accessor source="#f" count="3" stride="3"/></technique_common></source>
            <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
            <triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry></library_geometries>
            <library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
            <scene><instance_visual_scene url="#s"/></scene></COLLADA>""")
        robot = self.write("r.urdf", '<robot name="r"><link name="l"><visual><geometry><mesh filename="m.dae"/></geometry></visual>'
                           "</link></robot>")
        self.open(robot)
        text = self.hover(robot, self.find(robot, "m.dae"))
        self.assertIn("0.5 x 0.25 x 0 m", text)
        self.assertIn("unit 0.001 m", text)

    def test_gltf(self):
        """The mesh is rotated to z and is 1 m wide; its points are in another file, which is then deleted."""
        folder = self.folder / "glass"
        folder.mkdir()
        (folder / "m.bin").write_bytes(struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 2, 0))
        (folder / "m.gltf").write_text(json.dumps({
            "asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
            "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36, "uri": "m.bin"}]}))
        robot = folder / "r.urdf"
        robot.write_text('<robot name="r"><link name="l"><visual><geometry><mesh filename="m.gltf"/></geometry></visual></link>'
                         "</robot>")
        self.open(robot)
        text = self.hover(robot, self.find(robot, "m.gltf"))
        self.assertIn("glTF, 1 triangle", text)
        self.assertIn("1 x 0 x 2 m", text)
        (folder / "m.bin").unlink()
        self.assertIn("which does not exist", self.hover(robot, self.find(robot, "m.gltf")))

    def test_nothing(self):
        self.open(self.motors)
        self.assertIsNone(self.hover(self.motors, 3))


class Completion(LspTest):
    def test_keys(self):
        self.open(self.motors)
        at = self.find(self.motors, "  maxSpeed: 3.0\n", behind=True)
        self.client.edit(self.motors, at, at, "  ")
        labels = self.labels(self.motors, at + 2)
        self.assertIn("mimic_motor", labels)
        self.assertNotIn("maxSpeed", labels)
        self.assertNotIn("motors", labels)

    def test_a_new_entry(self):
        path = self.folder / "arm/smurf/arm_motors.yml"
        self.open(path, "motors:\n- ")
        items = self.client.at("textDocument/completion", path, len("motors:\n- "))["items"]
        entry = next(one for one in items if one["label"] == "new motor")
        self.assertEqual(entry["insertTextFormat"], 2)
        self.assertIn("name: $1\n  ", entry["textEdit"]["newText"])

    def test_sections(self):
        self.open(self.motors, "")
        self.assertIn("sensors", self.labels(self.motors, 0))

    def test_names(self):
        self.open(self.motors)
        at = self.find(self.motors, "joint: joint1_waist") + len("joint: ")
        self.client.edit(self.motors, at, at + len("joint1_waist"), "")
        items = self.client.at("textDocument/completion", self.motors, at)["items"]
        self.assertIn("joint3_elbow", [one["label"] for one in items])
        self.assertNotIn("turret", [one["label"] for one in items])
        self.assertEqual({one["detail"] for one in items}, {"joint"})

    def test_names_in_flow(self):
        self.open(self.motors, "motors:\n- {name: a, joint: ")
        self.assertIn("joint3_elbow", self.labels(self.motors, len("motors:\n- {name: a, joint: ")))

    def completed(self, path, before, label, after=""):
        """The text of a document after a choice of the menu at the end of `before`."""
        if str(path) in self.client.texts:
            self.client.replace(path, before + after)
        else:
            self.open(path, before + after)
        items = self.client.at("textDocument/completion", path, len(before))["items"]
        item = next((one for one in items if one["label"] == label), None)
        self.assertIsNotNone(item, [one["label"] for one in items])
        return apply(before + after, [item["textEdit"]])

    def test_items_of_lists_in_brackets(self):
        """Only the item is replaced, and lists may span lines."""
        sensors = self.folder / "arm/smurf/arm_sensors.yml"
        start = "sensors:\n- name: a\n  type: JointPosition\n"
        for before, after in (("  id: [joint1_waist, ", "]\n"), ("  id: [joint1_waist,\n    joint2", "\n  ]\n"),
                              ("  id:\n  - ", "\n")):
            self.assertEqual(self.completed(sensors, start + before, "joint3_elbow", after),
                             start + before.removesuffix("joint2") + "joint3_elbow" + after)
        # An unclosed bracket ends with its entry.
        self.assertEqual(self.completed(sensors, start + "  id: [a, b\n  link: ", "turret"),
                         start + "  id: [a, b\n  link: turret")

    def test_json(self):
        """Phobos writes models as JSON."""
        before = '{\n "modelname": "arm",\n "files": ["../urdf/arm.urdf",\n  "arm_m'
        self.assertEqual(self.completed(self.main, before, "arm_motors.yml", '"]}'),
                         '{\n "modelname": "arm",\n "files": ["../urdf/arm.urdf",\n  "arm_motors.yml"]}')
        self.assertEqual(self.completed(self.main, '{"modelname": "arm", "', "files", '"}'), '{"modelname": "arm", "files": }')
        labels = self.labels(self.main, len('{"modelname": "arm", "'))
        self.assertNotIn("modelname", labels)
        self.client.replace(self.main, self.main.read_text())
        self.assertEqual(self.completed(self.motors, '{"motors": [{"name": "a", "joint":"', "joint3_elbow", '"}]}'),
                         '{"motors": [{"name": "a", "joint":"joint3_elbow"}]}')

    def test_quotes(self):
        for before, after in (('"', '"'), ("'", "'"), ('"joi', '"'), ("'", "")):
            start = f"motors:\n- name: a\n  joint: {before[0]}"
            self.assertEqual(self.completed(self.motors, start + before[1:], "joint3_elbow", after),
                             f"{start}joint3_elbow{before[0]}")

    def test_types(self):
        """The types that readers know."""
        self.assertIn("PID", self.completed(self.motors, "motors:\n- name: a\n  type: ", "PID"))
        sensors = self.folder / "arm/smurf/arm_sensors.yml"
        self.assertIn("NodeIMU", self.completed(sensors, "sensors:\n- name: a\n  type: Node", "NodeIMU"))
        scene = self.folder / "nested/outer.smurfs"
        self.assertIn("smurfs", self.completed(scene, "entities:\n- name: a\n  type: ", "smurfs"))
        self.assertIn("world", self.completed(scene, "entities:\n- name: a\n  anchor: ", "world"))

    def test_not_in_comments(self):
        self.open(self.motors)
        self.assertEqual(self.labels(self.motors, self.find(self.motors, "every motor")), [])

    def test_booleans(self):
        text = "motors:\n- name: a\n  noDataPackage: "
        self.open(self.motors, text)
        self.assertEqual(self.labels(self.motors, len(text)), ["true", "false"])

    def test_files(self):
        self.open(self.main)
        at = self.find(self.main, "- arm_motors.yml") + 2
        labels = self.labels(self.main, at)
        self.assertIn("arm_motors.yml", labels)
        self.client.edit(self.main, at, at, "../urdf/")
        self.assertIn("../urdf/arm.urdf", self.labels(self.main, at + len("../urdf/")))
        self.assertEqual(self.completed(self.main, "files:\n- ../", "../urdf/"), "files:\n- ../urdf/")

    def test_configuration(self):
        config = self.write("arm/.smurf-lint.yaml", "")
        self.open(config, "severity:\n  unknown-joint: ")
        self.assertEqual(self.labels(config, len("severity:\n  unknown-joint: ")), ["error", "warning", "info"])
        self.client.replace(config, "targets:\n- ")
        self.assertIn("mujoco", self.labels(config, len("targets:\n- ")))

    def test_elements(self):
        self.open(self.urdf)
        at = self.find(self.urdf, "</joint>")
        self.client.edit(self.urdf, at, at, "<")
        labels = self.labels(self.urdf, at + 1)
        self.assertIn("dynamics", labels)
        self.assertNotIn("inertial", labels)

    def test_what_an_element_needs(self):
        self.open(self.urdf)
        at = self.find(self.urdf, "  <joint")
        self.client.edit(self.urdf, at, at, "<")
        items = self.client.at("textDocument/completion", self.urdf, at + 1)["items"]
        joint = next(one for one in items if one["label"] == "joint")
        self.assertEqual(joint["textEdit"]["newText"],
                         'joint name="$1" type="$2">\n\t<parent link="$3"/>\n\t<child link="$4"/>\n</joint>')
        at = self.find(self.urdf, "<visual")
        self.client.edit(self.urdf, at, at, "<")
        items = self.client.at("textDocument/completion", self.urdf, at + 1)["items"]
        collision = next(one for one in items if one["label"] == "collision")
        self.assertEqual(collision["textEdit"]["newText"],
                         "collision>\n\t<geometry>\n\t\t$1\n\t</geometry>\n</collision>")

    def test_attributes(self):
        self.open(self.urdf)
        at = self.find(self.urdf, "<limit ", behind=True)
        self.client.edit(self.urdf, at, self.find(self.urdf, "/>", after=at), "")
        items = self.client.at("textDocument/completion", self.urdf, at)["items"]
        self.assertEqual([one["label"] for one in items][:2], ["lower", "upper"])
        self.assertIn("rad or m", items[0]["detail"])

    def test_values(self):
        self.open(self.urdf)
        at = self.find(self.urdf, 'type="') + len('type="')
        self.assertIn("prismatic", self.labels(self.urdf, at))

    def test_names_while_the_tag_is_broken(self):
        self.open(self.urdf)
        at = self.find(self.urdf, '<parent link="', behind=True)
        self.client.edit(self.urdf, at, self.find(self.urdf, "\n", after=at), "")
        self.assertIn("turret", self.labels(self.urdf, at))
        self.assertGreater(len(self.client.published(self.urdf)), 0)

    def test_names_in_unclosed_elements(self):
        """The elements around the cursor are not closed yet."""
        whole = self.urdf.read_text().removesuffix("</robot>\n")
        self.open(self.urdf)
        for added in ('<joint name="new" type="fixed">\n<parent link="', '<joint name="new">\n<parent link="turret"/><child link="tu'):
            self.assertIn("turret", self.completed(self.urdf, whole + added, "turret", '"\n</robot>\n'))

    def test_names_in_extensions(self):
        whole = self.urdf.read_text().removesuffix("</robot>\n")
        self.open(self.urdf)
        self.assertIn("turret", self.completed(self.urdf, whole + '<gazebo reference="', "turret", '"/></robot>\n'))
        text = whole + '<transmission name="t"><joint name="'
        self.client.replace(self.urdf, text + '"/></transmission></robot>\n')
        labels = self.labels(self.urdf, len(text))
        self.assertIn("joint3_elbow", labels)
        self.assertNotIn("turret", labels)


class Structure(LspTest):
    def test_robot(self):
        self.open(self.urdf)
        roots = self.client.of("textDocument/documentSymbol", self.urdf)
        self.assertEqual([one["name"] for one in roots], ["base_link"])
        below = roots[0]["children"][0]
        self.assertIn("joint", below["detail"])
        self.assertEqual(below["children"][0]["name"], "pedestal")

    def test_sections(self):
        self.open(self.motors)
        section = self.client.of("textDocument/documentSymbol", self.motors)[0]
        self.assertEqual(section["name"], "motors")
        self.assertEqual(section["children"][0]["name"], "joint1_waist")

    def test_folding(self):
        self.open(self.urdf)
        text = self.client.texts[str(self.urdf)].split("\n")
        folds = self.client.of("textDocument/foldingRange", self.urdf)
        link = text.index('  <link name="turret">')
        end = text.index("  </link>", link)
        self.assertIn({"startLine": link, "endLine": end}, folds)

    def test_selection(self):
        self.open(self.urdf)
        at = self.find(self.urdf, "0.12 0.08 0.06") + 2
        place = client.position(self.client.texts[str(self.urdf)], at)
        selection = self.client.of("textDocument/selectionRange", self.urdf, positions=[place])[0]
        texts = []
        while selection:
            texts.append(text_in(self.client.texts[str(self.urdf)], selection["range"]))
            selection = selection.get("parent")
        self.assertEqual(texts[:3], ["0.12 0.08 0.06", 'size="0.12 0.08 0.06"', '<box size="0.12 0.08 0.06"/>'])
        self.assertTrue(texts[-1].startswith("<robot"))

    def test_links(self):
        self.open(self.main)
        targets = [path_of(one["target"]) for one in self.client.of("textDocument/documentLink", self.main)]
        self.assertEqual(targets[:2], [str(self.urdf), str(self.motors)])
        self.open(self.urdf)
        targets = [path_of(one["target"]) for one in self.client.of("textDocument/documentLink", self.urdf)]
        self.assertIn(str(self.folder / "arm/meshes/upper_arm.obj"), targets)

    def test_colors(self):
        self.open(self.urdf)
        boxes = self.client.of("textDocument/documentColor", self.urdf)
        self.assertEqual(boxes[0]["color"], {"red": 0.1, "green": 0.3, "blue": 0.7, "alpha": 1})
        written = self.client.of("textDocument/colorPresentation", self.urdf, color=boxes[0]["color"],
                                 range=boxes[0]["range"])
        self.assertEqual(written[0]["textEdit"]["newText"], "0.1 0.3 0.7 1")
        materials = self.folder / "arm/smurf/arm_materials.yml"
        self.open(materials)
        self.assertGreater(len(self.client.of("textDocument/documentColor", materials)), 0)

    def test_tokens(self):
        self.open(self.motors)
        legend = self.client.initialized["capabilities"]["semanticTokensProvider"]["legend"]
        data = self.client.of("textDocument/semanticTokens/full", self.motors)["data"]
        lines = self.client.texts[str(self.motors)].split("\n")
        line = column = 0
        tokens = []
        for i in range(0, len(data), 5):
            down, right, length, kind, modifiers = data[i:i + 5]
            line, column = line + down, right if down else column + right
            tokens.append((lines[line][column:column + length], legend["tokenTypes"][kind], modifiers))
        self.assertIn(("joint1_waist", "function", 0), tokens)
        self.assertIn(("joint1_waist", "event", 1), tokens)
        part = self.client.of("textDocument/semanticTokens/range", self.motors, range={
            "start": {"line": 0, "character": 0}, "end": {"line": 8, "character": 0}})["data"]
        self.assertEqual(part, data[:len(part)])
        self.assertLess(len(part), len(data))

    def test_hints(self):
        self.open(self.urdf)
        everything = {"start": {"line": 0, "character": 0}, "end": {"line": 9999, "character": 0}}
        hints = self.client.of("textDocument/inlayHint", self.urdf, range=everything)
        self.assertTrue(all(one["label"].endswith(("deg", "deg/s")) for one in hints), hints)
        self.assertGreater(len(hints), 3)
        few = self.client.of("textDocument/inlayHint", self.urdf, range={
            "start": {"line": 0, "character": 0}, "end": {"line": 3, "character": 0}})
        self.assertEqual(few, [])
        self.client.notify("workspace/didChangeConfiguration", {"settings": {"smurf": {"inlayHints": {
            "degrees": False, "defaults": True}}}})
        self.assertEqual(self.client.of("textDocument/inlayHint", self.urdf, range=everything), [])
        self.open(self.motors)
        hints = self.client.of("textDocument/inlayHint", self.motors, range=everything)
        self.assertTrue(all(one["label"].startswith("default: ") for one in hints), hints)


class Pictures(LspTest):
    def picture(self, path):
        return self.client.of("smurf/picture", path)

    def scene(self, path):
        picture = self.picture(path)
        self.assertIsNone(picture["problem"])
        return json.loads(re.search(r'id="scene" [^>]*>([^<]*)', picture["page"])[1])

    def setUp(self):
        super().setUp()
        self.open(self.urdf)
        try:
            self.picture(self.urdf)
        except client.RequestError as error:
            self.skipTest(str(error))  # a build without the viewer

    def test_text_that_is_not_saved(self):
        before = self.scene(self.urdf)
        links = [link["name"] for link in before["models"][0]["links"]]
        at = self.find(self.urdf, '<link name="forearm"') + len('<link name="')
        self.client.edit(self.urdf, at, at + len("forearm"), "lower_arm")
        at = self.find(self.urdf, 'link="forearm"') + len('link="')
        self.client.edit(self.urdf, at, at + len("forearm"), "lower_arm")
        after = [link["name"] for link in self.scene(self.urdf)["models"][0]["links"]]
        self.assertEqual([name for name in links if name not in after], ["forearm"])
        self.assertIn("lower_arm", after)

    def test_an_annotation_file_shows_its_model(self):
        self.open(self.motors)
        scene = self.scene(self.motors)
        kinds = {device["kind"] for device in scene["models"][0]["devices"]}
        self.assertEqual(kinds, {"motor", "sensor"})

    def test_a_file_that_breaks_off(self):
        at = self.find(self.urdf, "</robot>")
        self.client.edit(self.urdf, at, at + len("</robot>"), "")
        picture = self.picture(self.urdf)
        self.assertIsNone(picture["page"])
        self.assertEqual(picture["problem"]["code"], "SML1001")
        self.assertEqual(path_of(picture["problem"]["uri"]), str(self.urdf))

    def test_an_error_that_leaves_a_robot(self):
        at = self.find(self.urdf, "<mass value=") + len('<mass value="')
        self.client.edit(self.urdf, at, at, "x")
        picture = self.picture(self.urdf)
        self.assertIsNotNone(picture["page"])
        text = text_in(self.client.texts[str(self.urdf)], picture["problem"]["range"])
        self.assertTrue(text.startswith("x"), text)


class Protocol(LspTest):
    def raw(self, *parts):
        for part in parts:
            self.client.send_bytes(part)

    def message(self, text):
        data = text if isinstance(text, bytes) else text.encode()
        return b"Content-Length: %d\r\n\r\n%b" % (len(data), data)

    def test_nonsense(self):
        self.raw(self.message("{"), self.message("[]"), self.message("[[[[[["), self.message("1"),
                 self.message('{"jsonrpc":"2.0","id":null,"method":5}'), self.message(b"\xff\xfe"),
                 b"Content-Type: x\r\nContent-Length:   2\r\nX: y\r\n\r\n{}")
        self.raw(self.message("[" * 100000))
        for params in (None, [], 5, "x", {"textDocument": 5}, {"textDocument": {"uri": 5}, "position": []},
                       {"textDocument": {"uri": "file:///nowhere"}, "position": {"line": -1, "character": 1e99}}):
            for method in ("textDocument/hover", "textDocument/completion", "textDocument/rename",
                           "textDocument/codeAction", "textDocument/semanticTokens/full", "workspace/symbol",
                           "textDocument/selectionRange", "textDocument/inlayHint", "workspace/executeCommand"):
                try:
                    self.client.request(method, params)
                except client.RequestError:
                    pass
            self.client.notify("textDocument/didOpen", params)
            self.client.notify("textDocument/didChange", params)
            self.client.notify("textDocument/didClose", params)
        with self.assertRaises(client.RequestError) as caught:
            self.client.request("textDocument/unknown", {})
        self.assertEqual(caught.exception.code, -32601)
        self.assertEqual(self.open(self.motors), [])

    def test_edits_out_of_range(self):
        self.open(self.motors, "motors:\n- name: a\n")
        self.client.change(self.motors, [
            {"range": {"start": {"line": 99, "character": 99}, "end": {"line": 0, "character": 0}}, "text": "#"},
            {"range": {"start": {"line": 0, "character": 500}, "end": {"line": 0, "character": 900}}, "text": " # c"},
            {"range": {"start": {"line": 1, "character": 2}, "end": {"line": 99, "character": 99}}, "text": ""}, 5, {}])
        self.client.published(self.motors)
        symbols = self.client.of("textDocument/documentSymbol", self.motors)
        self.assertEqual(symbols, [])  # {} replaces the whole text by an empty text

    def test_cancelled(self):
        self.open(self.urdf)
        requests = [self.client.begin("workspace/diagnostic", {"previousResultIds": []})]
        for _ in range(20):
            requests.append(self.client.begin("textDocument/documentSymbol", {"textDocument": {"uri": uri(self.urdf)}}))
        self.client.notify("$/cancelRequest", {"id": requests[-1]})
        for request in requests[:-1]:
            self.client.answer(request)
        try:
            self.client.answer(requests[-1])
        except client.RequestError as error:
            self.assertEqual(error.code, -32800)

    def test_cancelled_by_a_request(self):
        """It should be a notification, but every request gets an answer."""
        with self.assertRaises(client.RequestError) as caught:
            self.client.request("$/cancelRequest", {"id": 1}, timeout=600)
        self.assertEqual(caught.exception.code, -32601)

    def test_characters(self):
        """Columns in the negotiated units."""
        text = '<robot name="r"><!-- \N{ROBOT FACE}\N{LATIN SMALL LETTER U WITH DIAERESIS} --><link name="a"/><link name="a"/></robot>\n'
        path = self.write("r.urdf", "")
        columns = {}
        for encoding, units in (("utf-8", lambda s: len(s.encode())), ("utf-32", len),
                                ("utf-16", lambda s: len(s.encode("utf-16-le")) // 2)):
            other = self.another([self.folder], {"general": {"positionEncodings": [encoding]}})
            self.assertEqual(other.initialized["capabilities"]["positionEncoding"], encoding)
            other.open(path, text)
            found = max(other.published(path), key=lambda one: one["range"]["start"]["character"])
            columns[encoding] = found["range"]["start"]["character"]
            self.assertEqual(columns[encoding], units(text[:text.rindex('"a"') + 1]))
            self.assertEqual(other.stop(), 0)
        self.assertEqual(len(set(columns.values())), 3)

    def test_halves_of_characters(self):
        """An editor may send one half of a character, then the other: the server keeps the text that the editor has."""
        text = self.open(self.motors) or self.client.texts[str(self.motors)]
        start = {"line": 0, "character": 0}
        self.client.change(self.motors, [{"range": {"start": start, "end": start}, "text": "# \\ud83d \ud83d\n"}])
        middle = {"line": 0, "character": 10}
        self.client.change(self.motors, [{"range": {"start": middle, "end": middle}, "text": "\ude00"}])
        self.client.texts[str(self.motors)] = "# \\ud83d \ufffd\ufffd\n" + text
        self.assertEqual(self.client.published(self.motors), [])
        self.client.edit(self.motors, *[self.find(self.motors, "joint: joint1_waist", behind=end) for end in (False, True)], "joint: no")
        found, = [one for one in self.client.published(self.motors) if one["code"] == "SML3101"]
        self.assertEqual(text_in(self.client.texts[str(self.motors)], found["range"]), "no")

    def test_crlf(self):
        path = self.write("r.urdf", "")
        self.open(path, '<robot name="r">\r\n<link name="a"/>\r\n</robot>\r\n')
        self.client.change(path, [{"range": {"start": {"line": 1, "character": 99}, "end": {"line": 1, "character": 99}},
                                   "text": '<link name="a"/>'}])
        found = self.client.published(path)
        self.assertEqual(found[0]["range"]["start"], {"line": 1, "character": 28})

    def test_shut_down(self):
        other = self.another()
        other.request("shutdown", None)
        with self.assertRaises(client.RequestError) as caught:
            other.request("textDocument/hover", {})
        self.assertEqual(caught.exception.code, -32600)
        other.notify("exit", None)
        self.assertEqual(other.process.wait(timeout=600), 0)
        other = self.another()
        other.notify("exit", None)
        self.assertEqual(other.process.wait(timeout=600), 1)
        other = self.another()
        other.process.stdin.close()
        self.assertEqual(other.process.wait(timeout=600), 2)

    def test_log(self):
        log = self.folder / "log"
        other = self.another(arguments=["--log", str(log), "--stdio"])
        self.assertEqual(other.stop(), 0)
        self.assertIn("request initialize", log.read_text())

    def test_large_document(self):
        path = self.write("r.urdf", "")
        self.open(path, '<robot name="r">' + "<link/>" * 200000 + "</robot>")
        self.assertGreater(len(self.client.published(path)), 0)

    def test_many_changes_at_once(self):
        """The cost of an edit does not depend on its place: thousands of edits need no longer than reading the text a few times."""
        seconds = lambda: sum(int(one) for one in pathlib.Path(  # noqa: E731
            f"/proc/{self.client.process.pid}/stat").read_text().rsplit(")", 1)[1].split()[11:13]) / 100
        texts = {"lines": "".join(f'<link name="l{i}"/>\n' for i in range(45000)), "line": '<link name="l"/>' * 60000}
        for name, links in texts.items():
            path = self.write(f"{name}.urdf", "")
            start = {"line": 44000, "character": 12} if name == "lines" else {"line": 1, "character": 900_012}
            end = {**start, "character": start["character"] + 1}
            before = seconds()
            self.open(path, f'<robot name="r">\n{links}</robot>\n')
            self.client.published(path)
            opened = seconds()
            self.client.change(path, [{"range": {"start": start, "end": end}, "text": "x"}] * 10000)
            self.client.published(path)
            self.assertLess(seconds() - opened, (10 if cli.is_sanitized(TOOL) else 4) * (opened - before))

    def test_folders(self):
        more = self.folder / "more"
        shutil.copytree(FIXTURES / "rules/SML3101-unknown-joint/bad", more)
        self.client.notify("workspace/didChangeWorkspaceFolders", {"event": {
            "added": [{"uri": uri(more), "name": "more"}], "removed": [{"uri": uri(self.folder), "name": "x"}]}})
        report = self.client.request("workspace/diagnostic", {"previousResultIds": []})
        self.assertEqual({pathlib.Path(path_of(one["uri"])).parent for one in report["items"]}, {more})


if __name__ == "__main__":
    TOOL = sys.argv.pop(1)
    unittest.main()
