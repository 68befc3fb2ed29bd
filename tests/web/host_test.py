# SPDX-License-Identifier: BSD-3-Clause
"""The page of a scene inside of a program that sends it newer versions: what is selected, moved and seen stays.

Usage: host_test.py TOOL BUILD
"""
import json
import pathlib
import re
import shutil
import subprocess

import viewer
from viewer import cli, reader  # noqa: F401

ARM = cli.FIXTURES / "models/arm/urdf/arm.urdf"
HOST = """<!doctype html><meta charset="utf-8"><iframe name="smurf-view" style="width: 1200px; height: 700px"></iframe>
<script id="pages" type="application/json">@PAGES@</script>
<script>
const pages = JSON.parse(document.getElementById("pages").textContent);
const said = [];
const frame = document.querySelector("iframe");
const ready = new Promise((done) => addEventListener("message", ({ data }) => (data.isReady ? done() : said.push(data))));
frame.srcdoc = pages[0];
const viewer = () => frame.contentWindow.smurfViewer;
const sceneIn = (page) => page.match(/id="scene" [^>]*>([^<]*)/)[1];
const send = (message) => new Promise((done) => {
  frame.contentWindow.postMessage(message, "*");
  setTimeout(done, 300);
});
document.documentElement.dataset.ready = "true";
</script>"""
STATE = """({ selected: viewer().selected && viewer().scene.entities[viewer().selected.entity].model.links[viewer().selected.link].name,
  elbow: viewer().motion.positions[0].get("joint3_elbow"), view: viewer().stage.view(), solids: viewer().shapes.solids.length,
  rows: frame.contentDocument.querySelectorAll("[role=treeitem]").length, layers: frame.contentDocument.querySelectorAll("canvas, .labels").length,
  sliders: frame.contentDocument.querySelectorAll("input[type=range]").length,
  axes: frame.contentDocument.getElementById("axes").getAttribute("aria-pressed"),
  objects: viewer().stage.scene.children.length, problem: frame.contentDocument.getElementById("problem").textContent,
  aside: getComputedStyle(frame.contentDocument.querySelector("aside")).display, said: said.splice(0) })"""


class HostTest(viewer.ViewerTest):
    def test_a_newer_version(self):
        text = ARM.read_text()
        self.write("old.urdf", text)
        # One visual less, and another place of the elbow.
        shorter = re.sub(r"(?s)<visual.*?</visual>", "", text, count=1).replace('lower="-0.4"', 'lower="-0.3"')
        self.assertNotEqual(shorter, text)
        self.write("new.urdf", shorter)
        pages = [self.page("old.urdf", "old.html").read_text(), self.page("new.urdf", "new.html").read_text()]
        host = self.folder / "host.html"
        host.write_text(HOST.replace("@PAGES@", json.dumps(pages).replace("<", "\\u003c")))
        answers = self.browse({"page": host, "steps": [
            "ready.then(() => 0)",
            "(viewer().joints.set(0, new Map([['joint3_elbow', 0.25]])), viewer().stage.turn(0.5, 0.1), "
            "frame.contentDocument.getElementById('axes').click(), 0)",
            "send({ select: 'forearm' })", STATE,
            "send({ scene: sceneIn(pages[1]) })", STATE,
            "send({ problem: 'Line 3: broken' })", STATE,
            "(frame.contentDocument.getElementById('problem').click(), send({ problem: '' }))", STATE,
            "send({ scene: sceneIn(pages[0]) })", STATE]})[0]["results"]
        before, after, broken, repaired, again = (answers[index] for index in (3, 5, 7, 9, 11))
        self.assertEqual((before["selected"], before["elbow"], before["axes"], before["aside"]), ("forearm", 0.25, "true", "flex"))
        for state in (after, again):
            self.assertEqual((state["selected"], state["elbow"], state["axes"]), ("forearm", 0.25, "true"))
            self.assertEqual(len(state["view"]), 6)
            for one, other in zip(state["view"], before["view"]):
                self.assertAlmostEqual(one, other, delta=1e-4)
            self.assertEqual([state[key] for key in ("rows", "sliders", "layers", "objects")],
                             [before[key] for key in ("rows", "sliders", "layers", "objects")])
        self.assertEqual((after["solids"], again["solids"]), (before["solids"] - 1, before["solids"]))
        self.assertEqual((before["problem"], broken["problem"], repaired["problem"]), ("", "Line 3: broken", ""))
        self.assertEqual(repaired["said"], [{"problem": True}])

    def test_the_page_alone_listens_to_nobody(self):
        page = self.page(ARM)
        results = self.browse({"page": page, "steps": [
            "(window.postMessage({ problem: 'x', select: 'forearm' }, '*'), new Promise((done) => setTimeout(done, 300)).then(() => 0))",
            "[document.getElementById('problem').hidden, smurfViewer.selected === undefined]"]})[0]["results"]
        self.assertEqual(results[1], [True, True])


# VS Code removes window.parent, and sends messages from a frame that the page does not know.
EDITOR = """
const elements = {};
const element = (id) => (elements[id] ??= { addEventListener() {} });
const sent = [];
let listen;
globalThis.document = { getElementById: element };
globalThis.window = { name: "", addEventListener: (type, action) => (listen = action), @EDITOR@ };
const { Host } = await import("@HOST@");
const host = new Host();
const selected = [];
host.connect({ scene: { entities: [{ model: { links: [{ name: "arm" }] } }] }, select: (...thing) => selected.push(thing) });
listen?.({ data: { problem: "Line 3", select: "arm" }, source: {} });
console.log(JSON.stringify({ sent, selected, problem: elements.problem?.textContent }));
"""


class EditorTest(viewer.cli.CliTest):
    def answer(self, editor):
        host = (pathlib.Path(__file__).resolve().parents[2] / "web/viewer/host.js").as_uri()
        self.write("editor.mjs", EDITOR.replace("@EDITOR@", editor).replace("@HOST@", host))
        done = subprocess.run(["node", self.folder / "editor.mjs"], capture_output=True, text=True, timeout=600, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_messages_of_an_editor(self):
        if shutil.which("node") is None:
            self.skipTest("node is not installed")
        answer = self.answer("acquireVsCodeApi: () => ({ postMessage: (message) => sent.push(message) })")
        self.assertEqual(answer, {"sent": [{"isReady": True}], "selected": [[0, 0]], "problem": "Line 3"})
        self.assertEqual(self.answer("parent: {}")["selected"], [])  # a frame of another page


if __name__ == "__main__":
    viewer.main()
