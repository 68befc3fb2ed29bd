# SPDX-License-Identifier: BSD-3-Clause
"""The page of `smurf-view --watch` while its file changes: what is selected, moved and seen stays.

Usage: view_test.py TOOL BUILD
"""
import re
import subprocess

from browser import BrowserTest, cli, main

ARM = cli.FIXTURES / "models/arm/urdf/arm.urdf"
VIEWER = "document.getElementById('viewer').contentWindow.smurfViewer"
STATE = f"""(() => {{ const viewer = {VIEWER}; const page = document.getElementById("viewer").contentDocument; return {{
  version: Number(document.documentElement.dataset.version),
  selected: viewer.selected && viewer.scene.entities[viewer.selected.entity].model.links[viewer.selected.link].name,
  elbow: viewer.motion.positions[0].get("joint3_elbow"), view: viewer.stage.view(), solids: viewer.shapes.solids.length,
  problem: page.getElementById("problem").textContent, aside: getComputedStyle(page.querySelector("aside")).display }}; }})()"""


def version(number):
    return {"until": f"document.documentElement.dataset.version >= {number}"}


class ViewTest(BrowserTest):
    def setUp(self):
        super().setUp()
        self.write("arm.urdf", ARM.read_text())
        self.running = subprocess.Popen([cli.TOOL, "--watch", "--no-open", "--quiet", "arm.urdf"], cwd=self.folder,
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8")
        self.address = self.running.stdout.readline().strip()
        if not self.address:
            self.assertIn("this build has no viewer", self.running.stderr.read())
            self.skipTest("this build has no viewer")

    def tearDown(self):
        self.running.terminate()
        self.running.communicate()
        super().tearDown()

    def test_changes(self):
        text = ARM.read_text()
        shorter = re.sub(r"(?s)<visual.*?</visual>", "", text, count=1)
        self.assertNotEqual(shorter, text)
        path = str(self.folder / "arm.urdf")
        results = self.browse({"page": self.address, "steps": [
            {"until": f"{VIEWER}?.stage && document.title.includes('arm')"},
            f"({VIEWER}.joints.set(0, new Map([['joint3_elbow', 0.25]])), {VIEWER}.stage.turn(0.5, 0.1), "
            f"{VIEWER}.select(0, {VIEWER}.scene.entities[0].model.links.findIndex(({{ name }}) => name === 'forearm')), 0)",
            STATE,
            {"write": path, "text": shorter}, version(2), {"until": f"{VIEWER}.shapes.solids.length > 0"}, STATE,
            {"write": path, "text": text[:300]}, version(3), STATE,
            {"write": path, "text": text}, version(4), STATE]})[0]["results"]
        before, after, broken, again = (results[index] for index in (2, 6, 9, 12))
        self.assertEqual((before["selected"], before["elbow"], before["problem"], before["aside"]), ("forearm", 0.25, "", "flex"))
        for state in (after, broken, again):
            self.assertEqual((state["selected"], state["elbow"]), ("forearm", 0.25))
            for one, other in zip(state["view"], before["view"], strict=True):
                self.assertAlmostEqual(one, other, delta=1e-4)
        self.assertEqual([state["solids"] - before["solids"] for state in (after, broken, again)], [-1, -1, 0])
        self.assertEqual((after["problem"], again["problem"]), ("", ""))
        self.assertRegex(broken["problem"], r"^arm\.urdf, line [0-9]+: ")


if __name__ == "__main__":
    main()
