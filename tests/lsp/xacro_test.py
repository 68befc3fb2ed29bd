# SPDX-License-Identifier: BSD-3-Clause
"""smurf-lsp on xacro files: a robot in two files, opened as its root and as its part. xacro_test.py SMURF-LSP"""
import os
import pathlib
import re
import shutil
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import client  # noqa: E402
from client import apply, offset, path_of, text_in, uri  # noqa: E402

TOOL = None
CAPABILITIES = {"textDocument": {"completion": {"completionItem": {"snippetSupport": True}},
                                 "documentSymbol": {"hierarchicalDocumentSymbolSupport": True}}}
ROBOT = """<?xml version="1.0"?>
<robot name="cart" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="$(find cart_description)/urdf/wheel.xacro"/>
  <xacro:arg name="heavy" default="1"/>
  <xacro:property name="size" value="0.3"/>
  <link name="base"/>
  <link name="tool"/>
  <joint name="tool_joint" type="fixed"><parent link="base"/><child link="tool"/></joint>
  <xacro:wheel prefix="first" radius="${size * 2}"/>
  <xacro:wheel prefix="second"/>
</robot>
"""
WHEEL = """<?xml version="1.0"?>
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="wheel" params="prefix radius:=0.1">
    <xacro:property name="mass" value="$(arg heavy)"/>
    <xacro:property name="tensor" value="${0.4 * radius * radius}"/>
    <link name="${prefix}_wheel">
      <inertial><mass value="${mass}"/><inertia ixx="${tensor}" iyy="${tensor}" izz="${tensor}" ixy="0" ixz="0" iyz="0"/></inertial>
      <collision><geometry><sphere radius="${radius}"/></geometry></collision>
    </link>
    <joint name="${prefix}_joint" type="fixed"><parent link="base"/><child link="${prefix}_wheel"/></joint>
  </xacro:macro>
</robot>
"""
PACKAGE = '<package format="3"><name>cart_description</name></package>\n'


class Xacro(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="smurf-xacro-")).resolve()
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        package = self.folder / "src/cart_description"
        (package / "urdf").mkdir(parents=True)
        (self.folder / ".git").mkdir()
        self.root, self.part = package / "urdf/cart.urdf.xacro", package / "urdf/wheel.xacro"
        self.root.write_text(ROBOT)
        self.part.write_text(WHEEL)
        (package / "package.xml").write_text(PACKAGE)
        self.client = client.Client(TOOL, [self.folder], CAPABILITIES)
        self.addCleanup(self.client.end)

    def tearDown(self):
        self.assertEqual(self.client.stop(), 0)
        self.assertEqual(self.client.stderr, b"")

    def open(self, path, text=None):
        self.client.open(path, text, "xacro")
        return self.client.published(path)

    def at(self, method, path, text, into=0, **more):
        """A request at a place in a text that occurs once, `into` characters behind its beginning."""
        whole = self.client.texts[str(path)]
        self.assertEqual(whole.count(text), 1, text)
        return self.client.at(f"textDocument/{method}", path, whole.index(text) + into, **more)

    def places(self, found):
        """(file, text) of each place in an answer."""
        texts = {str(path): self.client.texts.get(str(path), path.read_text()) for path in (self.root, self.part)}
        return sorted((pathlib.Path(path_of(one["uri"])).name, text_in(texts[path_of(one["uri"])], one["range"]))
                      for one in found)

    def soon(self, path, codes):
        """Waits for the findings of a file that is not open."""
        end = time.monotonic() + 300
        while True:
            self.client.of("textDocument/foldingRange", self.root)
            found = self.client.diagnostics.get(str(path), {}).get("diagnostics", [])
            if [one["code"] for one in found] == codes or time.monotonic() > end:
                break
            time.sleep(0.02)
        self.assertEqual([one["code"] for one in found], codes)
        return found

    # --- cost

    def test_a_name_of_thousands_of_uses(self):
        """Once, each use was compared with all others, and with all tags of the file: more than 40 s."""
        def seconds():
            words = pathlib.Path(f"/proc/{self.client.process.pid}/stat").read_text().rsplit(")", 1)[1].split()
            return (int(words[11]) + int(words[12])) / os.sysconf("SC_CLK_TCK")

        if not pathlib.Path("/proc/self/stat").exists():
            self.skipTest("the system does not count the time of a running process here")
        uses = "".join(f'  <link name="l{i}_${{size}}"/>\n' for i in range(30_000))
        text = f'<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">\n  <xacro:property name="size" value="1"/>\n{uses}</robot>\n'
        self.open(self.root, text)
        before = seconds()
        self.client.of("textDocument/documentSymbol", self.root)
        peer = max(seconds() - before, 0.05)
        before = seconds()
        found = self.at("references", self.root, 'name="size"', len('name="'), context={"includeDeclaration": True})
        self.assertGreater(len(found), 1000)
        self.assertLess(seconds() - before, 20 * peer)

    # --- findings

    def test_no_findings(self):
        self.assertEqual(self.open(self.root), [])
        self.assertEqual(self.open(self.part), [])

    def test_a_finding_in_an_included_file_while_its_root_is_edited(self):
        found = self.open(self.root, ROBOT.replace('"${size * 2}"', '"-1"'))
        found = [one for one in found if one["code"] != "SML3413"]  # `size` is no longer used
        self.assertEqual(len(found), 1)
        self.assertEqual(text_in(self.client.texts[str(self.root)], found[0]["range"]), "-1")
        self.part.write_text(WHEEL.replace('value="${mass}"', 'value="-1"'))
        self.client.notify("workspace/didChangeWatchedFiles", {"changes": [{"uri": uri(self.part), "type": 2}]})
        inner = self.soon(self.part, ["SML1509"])[0]
        self.assertEqual(text_in(self.part.read_text(), inner["range"]), "-1")
        said = [(pathlib.Path(path_of(one["location"]["uri"])).name, one["message"])
                for one in inner["relatedInformation"]]
        self.assertIn(("cart.urdf.xacro", "in `wheel`, called here with prefix=first radius=-1"), said)

    def test_a_part_is_judged_in_the_robots_that_include_it(self):
        found = self.open(self.part, WHEEL.replace('value="${mass}"', 'value="-1"'))
        self.assertEqual([one["code"] for one in found], ["SML1509"])
        self.assertEqual(text_in(self.client.texts[str(self.part)], found[0]["range"]), "-1")
        at = self.client.texts[str(self.part)].index('value="-1"') + len('value="')
        self.client.edit(self.part, at, at + 1, "")
        self.assertEqual(self.client.published(self.part), [])

    def test_an_error_of_xacro_in_a_part(self):
        found = self.open(self.part, WHEEL.replace("${mass}", "${mas}"))
        self.assertEqual([one["code"] for one in found], ["SML3301"])
        self.assertEqual(text_in(self.client.texts[str(self.part)], found[0]["range"]), "mas")

    def test_a_new_include_is_followed(self):
        self.root.write_text(ROBOT.replace("wheel.xacro", "other.xacro"))
        self.assertEqual(self.open(self.part, WHEEL.replace('value="${mass}"', 'value="-1"')), [])
        found = self.open(self.root, self.root.read_text())
        self.assertEqual([one["code"] for one in found], ["SML3310"])
        at = self.client.texts[str(self.root)].index("other.xacro")
        self.client.edit(self.root, at, at + len("other"), "wheel")
        self.assertEqual(self.client.published(self.root), [])
        self.assertEqual([one["code"] for one in self.soon(self.part, ["SML1509"])], ["SML1509"])

    # --- names

    def test_definition(self):
        self.open(self.root)
        self.open(self.part)
        for path, text, into, expected in [
                (self.root, '<xacro:wheel prefix="first"', 8, [("wheel.xacro", "wheel")]),
                (self.root, 'radius="${size', 2, [("wheel.xacro", "radius")]),
                (self.root, "${size * 2}", 3, [("cart.urdf.xacro", "size")]),
                (self.part, "$(arg heavy)", 7, [("cart.urdf.xacro", "heavy")]),
                (self.part, "${mass}", 3, [("wheel.xacro", "mass")]),
                (self.part, "${radius}", 3, [("wheel.xacro", "radius")]),
                (self.root, "urdf/wheel.xacro", 7, [("wheel.xacro", "")]),
                (self.root, '<child link="tool"', 13, [("cart.urdf.xacro", "tool")])]:
            with self.subTest(text=text):
                self.assertEqual(self.places(self.at("definition", path, text, into)), expected)
        found = self.at("definition", self.root, "find cart_description", 8)
        self.assertEqual([pathlib.Path(path_of(one["uri"])).name for one in found], ["package.xml"])

    def test_references(self):
        self.open(self.root)
        self.open(self.part)

        def references(path, text, into):
            return self.places(self.at("references", path, text, into, context={"includeDeclaration": True}))
        self.assertEqual(references(self.part, 'name="wheel"', 7),
                         [("cart.urdf.xacro", "wheel")] * 2 + [("wheel.xacro", "wheel")])
        self.assertEqual(references(self.part, "prefix radius", 2),
                         [("cart.urdf.xacro", "prefix")] * 2 + [("wheel.xacro", "prefix")] * 4)
        self.assertEqual(references(self.root, 'name="heavy"', 8),
                         [("cart.urdf.xacro", "heavy"), ("wheel.xacro", "heavy")])
        self.assertEqual(references(self.root, '<link name="base"', 13),
                         [("cart.urdf.xacro", "base")] * 2 + [("wheel.xacro", "base")])

    def test_rename_of_a_link_in_both_files(self):
        self.open(self.root)
        self.open(self.part)
        edit = self.at("rename", self.root, '<link name="base"', 13, newName="chassis")
        texts = {path_of(one): apply(self.client.texts[path_of(one)], edits) for one, edits in edit["changes"].items()}
        self.assertEqual(texts[str(self.root)], ROBOT.replace('"base"', '"chassis"'))
        self.assertEqual(texts[str(self.part)], WHEEL.replace('"base"', '"chassis"'))
        with self.assertRaisesRegex(client.RequestError, "made by an expression at .*wheel.xacro:6"):
            self.at("rename", self.part, '<link name="${prefix}_wheel"', 22, newName="round")

    def test_hover(self):
        self.open(self.root)
        self.open(self.part)

        def said(path, text, into):
            return self.at("hover", path, text, into)["contents"]["value"]
        radius = said(self.part, "${radius}", 4)
        self.assertIn("`0.6` in `wheel`, called at cart.urdf.xacro:9 with `prefix=first radius=0.6`", radius)
        self.assertIn("`0.1` in `wheel`, called at cart.urdf.xacro:10", radius)
        self.assertIn("parameter `radius`, by default `0.1`, defined in wheel.xacro:3", radius)
        self.assertIn("property `size` = `0.3`, defined in cart.urdf.xacro:5", said(self.root, "${size", 3))
        self.assertIn("argument `heavy`, by default `1`", said(self.part, "arg heavy", 6))
        self.assertIn("macro `wheel`: `prefix radius:=0.1`", said(self.root, 'wheel prefix="first"', 2))
        self.assertIn("link `tool`", said(self.root, '<link name="tool"', 13))

    def test_symbols(self):
        self.open(self.part)
        macro = self.client.of("textDocument/documentSymbol", self.part)[0]
        self.assertEqual((macro["name"], macro["detail"]), ("wheel", "prefix radius:=0.1"))
        self.assertEqual([one["name"] for one in macro["children"]],
                         ["mass", "tensor", "${prefix}_wheel", "${prefix}_joint"])
        self.open(self.root)
        self.assertEqual([one["name"] for one in self.client.of("textDocument/documentSymbol", self.root)],
                         ["$(find cart_description)/urdf/wheel.xacro", "heavy", "size", "base", "tool", "tool_joint",
                          "wheel", "wheel"])

    def complete(self, path, text, typed):
        """The labels offered after a text was typed before the end of the file."""
        whole = self.client.texts[str(path)]
        at = whole.index(text)
        self.client.edit(path, at, at, typed)
        items = self.client.at("textDocument/completion", path, at + len(typed))["items"]
        self.client.edit(path, at, at + len(typed), "")
        return {one["label"]: one for one in items}

    def test_completion(self):
        self.open(self.root)
        self.open(self.part)
        elements = self.complete(self.root, "</robot>", "<xacro:")
        self.assertIn("xacro:property", elements)
        self.assertEqual(elements["xacro:wheel"]["textEdit"]["newText"], 'xacro:wheel prefix="$1"/>')
        self.assertIn("link", self.complete(self.root, "</robot>", "<"))
        self.assertEqual(list(self.complete(self.root, "</robot>", "<xacro:wheel prefix='a' ")), ["radius"])
        self.assertIn("size", self.complete(self.root, "</robot>", '<a b="${si'))
        inner = self.complete(self.part, "  </xacro:macro>", '<a b="${')
        self.assertLessEqual({"prefix", "radius", "size", "mass", "pi"}, set(inner))
        self.assertEqual(set(self.complete(self.part, "  </xacro:macro>", '<a b="$(arg ')), {"heavy"})
        self.assertIn("find", self.complete(self.part, "  </xacro:macro>", '<a b="$('))
        self.assertEqual(set(self.complete(self.root, "</robot>", '<a b="$(find ')), {"cart_description"})
        self.assertIn("wheel.xacro", self.complete(self.root, "</robot>", '<xacro:include filename="'))

    # --- the expanded robot

    def test_expansion(self):
        self.open(self.root)
        made = self.client.of("smurf/expansion", self.root)
        self.assertEqual(path_of(made["root"]), str(self.root))
        text = made["text"]
        self.assertIn('<sphere radius="0.6"/>', text)
        at = client.position(text, text.index('"0.6"') + 1)
        origin = self.client.request("smurf/expansionOrigin", {"textDocument": {"uri": uri(self.root)}, "position": at})
        self.assertEqual(self.places([origin]), [("cart.urdf.xacro", "${size * 2}")])
        self.open(self.part)
        made = self.client.of("smurf/expansion", self.part)
        self.assertEqual(made["text"], text)
        place = client.position(WHEEL, WHEEL.index("${radius}") + 3)
        found = self.client.request("smurf/expansionPlaces",
                                    {"textDocument": {"uri": uri(self.part)}, "position": place})
        self.assertEqual([text_in(text, one) for one in found], ["0.6", "0.1"])

    def test_a_broken_robot_has_no_expansion(self):
        self.open(self.root, ROBOT.replace("${size", "${sise"))
        self.assertIsNone(self.client.of("smurf/expansion", self.root)["text"])
        # What its files define is still known.
        self.assertEqual(self.places(self.at("definition", self.root, "wheel prefix=\"second\"", 2)),
                         [("wheel.xacro", "wheel")])

    def test_rename(self):
        """Names of xacro, at a definition, a use and a call; the robots stay as they are."""
        self.client.open(self.root, language="xml")
        self.client.open(self.part, language="xml")
        before = dict(self.client.texts)
        for path, text, to, changed in ((self.part, "wheel\" params", "tyre", 2), (self.root, "wheel prefix", "tyre", 2),
                                        (self.part, "radius}", "r", 2), (self.part, "tensor}", "moment", 1),
                                        (self.root, "size * 2", "width", 1), (self.part, "heavy)", "kilograms", 2)):
            with self.subTest(text):
                at = self.client.texts[str(path)].index(text)
                place = self.client.at("textDocument/prepareRename", path, at)
                self.assertEqual(place["placeholder"], text.split(" ")[0].strip('"})'))
                self.assertEqual(self.apply_rename(path, at, to), changed)
                # Asked for: what was published may be from before the edit of the second file.
                found = self.client.of("textDocument/diagnostic", self.root)["items"]
                self.assertEqual([one for one in found if one["severity"] == 1], [])
                at = re.search(rf"\b{to}\b", self.client.texts[str(path)]).start()
                self.assertEqual(self.apply_rename(path, at, place["placeholder"]), changed)
                self.assertEqual(self.client.texts, before)

    def apply_rename(self, path, at, to):
        """The number of files that change; the documents have the new texts."""
        edit = self.client.at("textDocument/rename", path, at, newName=to)
        changes = edit.get("changes") or {one["textDocument"]["uri"]: one["edits"] for one in edit["documentChanges"]}
        for address, edits in changes.items():
            file = path_of(address)
            self.client.replace(file, apply(self.client.texts[str(file)], edits))
        return len(changes)

    def test_rename_is_refused(self):
        self.client.open(self.root, language="xml")
        for text, to, reason in (("size * 2", "1st", "cannot be a name"), ("wheel prefix", "if", "is an element of xacro")):
            with self.assertRaises(client.RequestError) as failed:
                self.client.at("textDocument/rename", self.root, self.client.texts[str(self.root)].index(text), newName=to)
            self.assertIn(reason, str(failed.exception))


if __name__ == "__main__":
    TOOL = sys.argv.pop(1)
    unittest.main()
