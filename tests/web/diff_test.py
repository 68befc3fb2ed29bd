# SPDX-License-Identifier: BSD-3-Clause
"""The page of `smurf-diff --format html`: it lists what the JSON report has, shows both versions where smurfs-flatten puts
them, runs no foreign code, and is accessible.

Usage: diff_test.py TOOL BUILD; smurfs-flatten is beside the tool.
"""
import json
import pathlib
import re
import shutil
import subprocess
import xml.sax.saxutils

import viewer
from browser import cli

ARM = cli.FIXTURES / "models/arm"
HOSTILE = """<img src=x onerror="window.hacked=1"> </script><script>window.hacked=2</script> <!-- <script> javascript:alert(1)"""
HIDDEN = "\x1b[31m\x7f\u202e\u2028"
CARDS = "[...document.querySelectorAll('.difference')]"
STATUS = "document.getElementById('status').textContent"
SELECTED = """(async () => {
  const viewer = await smurfDiff.picture.loaded;
  if (!viewer.selected) return null;
  const { entity, link, shape } = viewer.selected;
  const { path, old, model } = viewer.scene.entities[entity];
  return [old ? "old" : "new", path, model?.links[link]?.name ?? null, shape?.name ?? null];
})()"""
# The versions that are drawn, and the opacity of each.
DRAWN = """smurfDiff.picture.loaded.then(({ shapes }) => Object.fromEntries([...shapes.batches.values()]
  .filter(({ mesh, layer }) => mesh.visible && layer === "visuals")
  .map(({ old, mesh }) => [old ? "old" : "new", mesh.material.uniforms.opacity.value])))"""
NEW_CAMERA = """  <link name="camera"><visual><geometry><box size="0.03 0.09 0.03"/></geometry></visual></link>
  <joint name="camera_mount" type="fixed"><parent link="hand"/><child link="camera"/><origin xyz="0.05 0 0.02"/></joint>
</robot>"""


def in_frame(script):
    return f"smurfDiff.picture.loaded.then((smurfViewer) => {script})"


def without(text, begin, end):
    first = text.index(begin)
    return text[:first] + text[text.index(end, first) + len(end):]


def edited_arm(urdf):
    """The arm with a difference of each kind."""
    for old, new in (('upper="2.4"', 'upper="2.2"'), ('mass value="0.6"', 'mass value="0.66"'), ('"turret"', '"head"'),
                     ('"joint4_wrist"', '"wrist"'), ('<cylinder radius="0.03" length="0.24"/>', '<cylinder radius="0.045" length="0.24"/>'),
                     ('<origin xyz="0 0 0.24" rpy="0 0 0"/>\n    <axis', '<origin xyz="0 0 0.28" rpy="0 0.1 0"/>\n    <axis'),
                     ("</robot>", NEW_CAMERA)):
        assert old in urdf, old
        urdf = urdf.replace(old, new)
    urdf = without(urdf, '<link name="lidar">', "</link>")
    return without(urdf, '<joint name="lidar_mount"', "</joint>")


class DiffTest(viewer.ViewerTest):
    @classmethod
    def setUpClass(cls):
        super(viewer.ViewerTest, cls).setUpClass()  # the page has a list without a viewer, too

    def flat(self, scene):
        flatten = pathlib.Path(cli.TOOL).parent / "smurfs-flatten"
        done = subprocess.run([flatten, scene, "--links", "--quiet", "--allow-outside", "--force"], capture_output=True,
                              encoding="utf-8", cwd=self.folder, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def page(self, old, new, name="diff.html"):
        """The page, its data, and the JSON report."""
        report = self.run_tool("--format", "json", "--allow-outside", old, new)
        done = self.run_tool("--format", "html", "-o", name, "--allow-outside", old, new)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (report.returncode, "", ""))
        page = self.folder / name
        return page, self.data_in(page, "report")[0], json.loads(report.stdout)

    def pictured(self, old, new, name="diff.html"):
        """The page, and the contents of its picture."""
        page, data, _ = self.page(old, new, name)
        if "picture" not in data:
            self.skipTest("this build has no viewer")
        return page, json.loads(re.search(r'id="scene" [^>]*>([^<]*)', data["picture"])[1])

    def arms(self):
        """The arm and an edited one, each with its meshes."""
        for version in ("old", "new"):
            shutil.copytree(ARM, self.folder / version)
        urdf = self.folder / "new/urdf/arm.urdf"
        urdf.write_text(edited_arm(urdf.read_text()))
        return "old/urdf/arm.urdf", "new/urdf/arm.urdf"

    def scenes(self):
        """Two scenes with two models each, one entity of which is on a link of another."""
        shutil.copytree(ARM, self.folder / "old/arm")
        self.write("old/box.urdf", '<robot name="box"><link name="body"><visual><geometry><box size="0.2 0.2 0.1"/></geometry></visual>'
                                   '</link></robot>')
        self.write("old/cell.smurfs", """entities:
- {name: A, type: smurf, file: arm/smurf/arm.smurf, position: [0, 0, 0]}
- {name: B, type: urdf, file: box.urdf, parent: "A::hand", anchor: parent, position: [0, 0, 0.2]}
- {name: C, type: urdf, file: box.urdf, position: [1, 0, 0]}
""")
        self.write("old/s.smurfs", "entities: [{name: Cell, file: cell.smurfs, position: [0, 1, 0]}]\n")
        shutil.copytree(self.folder / "old", self.folder / "new")
        for file, old, new in (("arm/urdf/arm.urdf", '"joint4_wrist"', '"wrist"'), ("box.urdf", "0.2 0.2", "0.2 0.3"),
                               ("cell.smurfs", "name: C", "name: D"), ("s.smurfs", "Cell", "Hall")):
            path = self.folder / "new" / file
            self.assertIn(old, path.read_text())
            path.write_text(path.read_text().replace(old, new))
        for path in (self.folder / "new/arm/smurf").iterdir():
            path.write_text(path.read_text().replace("joint4_wrist", "wrist"))
        return "old/s.smurfs", "new/s.smurfs"


class ListTest(DiffTest):
    def check_list(self, old, new):
        page, data, report = self.page(old, new)
        found = report["differences"]
        self.assertEqual([{key: one[key] for key in wanted} for one, wanted in zip(data["differences"], found)], found)
        self.assertEqual({key: data[key] for key in report}, {**report, "differences": data["differences"]})
        steps = ["while (smurfDiff.addMore(200));",
                 f"{CARDS}.map((card) => [card.querySelector('.badge').textContent, card.querySelector('h3').textContent,"
                 " [...card.querySelectorAll('.version')].map((row) => [...row.querySelectorAll('b, .value, .place')]"
                 ".map((part) => part.textContent))])",
                 "document.getElementById('title').textContent", "[...document.querySelectorAll('.toggle')].map((one) => one.textContent)",
                 "[...document.querySelectorAll('.group h2')].map((one) => one.textContent)"]
        cards, title, counts, groups = self.browse({"page": page, "steps": steps})[0]["results"][1:]
        expected = []
        text = " ".join(self.run_tool("--allow-outside", old, new).stdout.split())
        for one in found:
            places = {version: f"{one[f'{version}_source']['file']}:{one[f'{version}_source']['line']}"
                      for version in ("old", "new") if f"{version}_source" in one}
            expected.append((one["change"], one["kind"], sorted(places.items())))
        self.assertEqual(sorted((change, next(kind for kind in {one["kind"] for one in found} if subject.startswith(f"{change} {kind} ")
                                              or subject == f"{change} {kind}" or subject.startswith(f"{change} {kind}:")),
                                 sorted((row[0], row[2]) for row in rows))
                                for change, subject, rows in cards), sorted(expected))
        for change, subject, rows in cards:
            subject = subject.removeprefix(f"{change} ")
            self.assertIn(subject, text)
            values = [row[1] for row in rows]
            self.assertTrue(change in ("added", "removed") or values[0] != values[1], values)
        self.assertEqual(title, f"{len(found)} differences")
        self.assertEqual(counts, [f"{count} {change}" for change, count in report["summary"].items() if count > 0])
        self.assertEqual(groups, list(dict.fromkeys(one["kind"] for one in found)))
        return cards

    def test_the_page_lists_what_the_json_report_has(self):
        cards = self.check_list(*self.arms())
        values = {subject: [row[1] for row in rows] for _, subject, rows in cards}
        self.assertEqual(values["changed joint joint3_elbow: upper limit"], ["2.4 rad", "2.2 rad"])
        self.assertEqual(values["changed link forearm: mass"], ["0.6 kg", "0.66 kg"])
        self.assertEqual(values["renamed link turret"], ["turret", "head"])
        self.assertEqual(values["changed joint joint3_elbow: pose"],
                         ["xyz 0 0 0.24 m rpy 0 0 0 rad", "xyz 0 0 0.28 m rpy 0 0.1 0 rad"])

    def test_scenes_and_annotations(self):
        self.check_list(*self.scenes())
        self.write("a/motors.yml", "motors:\n- {name: m, joint: j, maxSpeed: 2.5, type: PID}\n- {name: n, joint: k}\n")
        self.write("b/motors.yml", "motors:\n- {name: m, joint: j, maxSpeed: 2.500000004, type: DC}\n- {name: o, joint: l}\n")
        cards = self.check_list("a/motors.yml", "b/motors.yml")
        self.assertIn(["2.5 rad/s or m/s", "2.500000004 rad/s or m/s"], [[row[1] for row in rows] for _, _, rows in cards])

    def test_a_list_without_picture(self):
        self.write("a/motors.yml", "motors:\n- {name: m, joint: j, maxSpeed: 2.5}\n")
        self.write("b/motors.yml", "motors:\n- {name: m, joint: j, maxSpeed: 2}\n")
        page, data, _ = self.page("a/motors.yml", "b/motors.yml")
        self.assertNotIn("picture", data)
        steps = ["document.getElementById('picture').hidden", "document.querySelectorAll('.pictured').length", {"key": "j"}, {"key": "1"},
                 "document.activeElement.id", {"axe": True}]
        results = self.browse({"page": page, "steps": steps})[0]["results"]
        self.assertEqual([results[0], results[1], *results[4:]], [True, 0, "difference-0", []])

    def test_equal_robots(self):
        page, data, _ = self.page(ARM / "urdf/arm.urdf", ARM / "urdf/arm.urdf")
        self.assertNotIn("picture", data)
        steps = ["document.getElementById('title').textContent", "document.getElementById('list').textContent", {"key": "j"}, {"axe": True}]
        results = self.browse({"page": page, "steps": steps})[0]["results"]
        self.assertEqual(results[0], "No differences")
        self.assertIn("Nothing differs for the robot", results[1])
        self.assertEqual(results[3], [])

    def test_search_and_filters(self):
        page, _, report = self.page(*self.arms())
        found = report["differences"]
        joints = sum(one["kind"] == "joint" for one in found)
        kind = "(() => { const list = document.getElementById('kind'); list.value = %s; list.dispatchEvent(new Event('change')); })()"
        steps = ["document.querySelector('.toggle.changed').click()", STATUS, {"key": "Escape"}, STATUS, kind % "'joint'", STATUS,
                 {"key": "Escape"}, "(() => { const words = document.getElementById('words'); words.value = 'elbow LIMIT';"
                                    " words.dispatchEvent(new Event('input')); })()", STATUS]
        results = self.browse({"page": page, "steps": steps})[0]["results"]
        self.assertEqual(results[1], f"{len(found) - report['summary']['changed']} of {len(found)} differences")
        self.assertEqual(results[3], "")
        self.assertEqual(results[5], f"{joints} of {len(found)} differences")
        self.assertEqual(results[8], f"1 of {len(found)} differences")


    def test_thousands_of_differences_are_laid_out_when_they_are_in_sight(self):
        for name, speed in (("a", 1), ("b", 2)):
            self.write(f"{name}/motors.yml", "motors:\n" + "".join(
                f"- {{name: m{i}, joint: j{i}, maxSpeed: {speed}}}\n" for i in range(9000)))
        page, _, report = self.page("a/motors.yml", "b/motors.yml")
        self.assertEqual(len(report["differences"]), 9000)
        laid_out = f"{CARDS}.filter((card) => card.firstElementChild.checkVisibility({{ contentVisibilityAuto: true }})).length"
        drawn = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done())))"
        at = "[document.activeElement.id, document.activeElement.getBoundingClientRect().bottom <= innerHeight]"
        steps = ["while (smurfDiff.addMore(200));", f"{CARDS}.length", drawn, laid_out, f"{CARDS}[8990].focus()", *[{"key": "j"}] * 3, drawn, at,
                 laid_out, {"key": "k"}, drawn, at, {"key": "/"}, {"type": "m8123"}, STATUS,
                 f"{CARDS}.map((card) => card.querySelector('h3').textContent)", {"axe": True}]
        results = self.browse({"page": page, "steps": steps})[0]["results"]
        self.assertEqual(results[1], 9000)
        self.assertLess(results[3], 200)
        self.assertEqual(results[9], ["difference-8993", True])
        self.assertLess(results[10], 400)
        self.assertEqual(results[13], ["difference-8992", True])
        self.assertEqual(results[16], "1 of 9,000 differences")
        self.assertIn("m8123", results[17][0])
        self.assertEqual(results[18], [])


class PictureTest(DiffTest):
    def check_poses(self, old, new):
        page, scene = self.pictured(old, new)
        instances = [*self.flat(new)["instances"], *self.flat(old)["instances"]]
        self.assertEqual([bool(entity.get("old")) for entity in scene["entities"]],
                         [False] * len(self.flat(new)["instances"]) + [True] * len(self.flat(old)["instances"]))
        read = self.browse({"page": page, "steps": [in_frame(viewer.READ)]})[0]["results"][0]
        return page, scene, self.assert_poses(read, scene, instances, new)

    def test_both_versions_stand_where_the_flat_json_says(self):
        _, scene, count = self.check_poses(*self.arms())
        self.assertGreater(count, 15)
        self.assertEqual(len(scene["meshes"]), 2, "the copies of a mesh are in the page once")
        shutil.rmtree(self.folder / "old")
        shutil.rmtree(self.folder / "new")
        _, _, count = self.check_poses(*self.scenes())
        self.assertGreater(count, 15)

    def test_joints_move_together_by_their_names(self):
        old, new = self.arms()
        page, scene = self.pictured(old, new)
        names = {"joint1_waist": 0.3, "joint3_elbow": -0.5, "wrist": 0.7, "joint5_finger_left": 0.01}
        set_slider = """(([name, value]) => {
          const slider = [...smurfViewer.joints.rows].find(({ line }) => line.querySelector(".name").textContent === name).slider;
          slider.value = value; slider.dispatchEvent(new Event("input")); })(%s)"""
        steps = [in_frame(set_slider % json.dumps(one)) for one in names.items()]
        steps += ["new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))", in_frame(viewer.READ),
                  in_frame("smurfViewer.motion.positions.map((one) => [...one])"), in_frame("smurfViewer.joints.takePose('zero')"),
                  in_frame("smurfViewer.motion.positions.map((one) => [...one])")]
        results = self.browse({"page": page, "steps": steps})[0]["results"]
        old_names = {"joint4_wrist" if name == "wrist" else name: value for name, value in names.items()}
        instances = [*self.posed((self.folder / new).read_text(), [names]), *self.posed((self.folder / old).read_text(), [old_names])]
        self.assert_poses(results[5], scene, instances, "moved")
        self.assertEqual([dict(one) for one in results[6]], [names, old_names])
        self.assertEqual(results[8], [[], []])

    def test_entities_of_renamed_scenes_move_together(self):
        page, scene = self.pictured(*self.scenes())
        paths = [entity["path"] for entity in scene["entities"]]
        together = "smurfViewer.scene.entities.map((_, index) => smurfViewer.motion.together(index)[1])"
        joints = "[...smurfViewer.motion.twins.get(%d).joints]" % paths.index("Hall/A")
        results = self.browse({"page": page, "steps": [in_frame(together), in_frame(joints)]})[0]["results"]
        pairs = {paths[index]: paths[other] for index, other in enumerate(results[0])}
        for old, new in (("Cell/A", "Hall/A"), ("Cell/B", "Hall/B"), ("Cell/C", "Hall/D")):
            self.assertEqual((pairs[old], pairs[new]), (new, old))
        self.assertIn(["wrist", "joint4_wrist"], results[1])

    def chosen(self, page, differences):
        """The selection after choosing each of the differences."""
        steps = []
        for number in range(len(differences)):
            steps += [f"smurfDiff.showPicture(smurfDiff.items[{number}])", SELECTED]
        return self.browse({"page": page, "steps": steps})[0]["results"][1::2]

    def test_links_joints_and_shapes_are_selected(self):
        old, new = self.arms()
        page, data, report = self.page(old, new)
        if "picture" not in data:
            self.skipTest("this build has no viewer")
        found = report["differences"]
        selected = self.chosen(page, found)
        by_name = {(one["kind"], one["name"], one.get("property")): thing for one, thing in zip(found, selected)}
        self.assertEqual(by_name["link", "head", None], ["new", "arm", "head", None])
        self.assertEqual(by_name["link", "lidar", None], ["old", "arm", "lidar", None])
        self.assertEqual(by_name["link", "camera", None], ["new", "arm", "camera", None])
        self.assertEqual(by_name["joint", "lidar_mount", None], ["old", "arm", "lidar", None])
        self.assertEqual(by_name["joint", "wrist", None], ["new", "arm", "hand", None])
        self.assertEqual(by_name["joint", "joint3_elbow", "pose"], ["new", "arm", "forearm", None])
        self.assertEqual(by_name["collision", "upper_arm_collision", "cylinder.radius"], ["new", "arm", "upper_arm", "upper_arm_collision"])

    def test_selected_things_are_in_view_and_marked(self):
        old, new = self.arms()
        page, data, report = self.page(old, new)
        if "picture" not in data:
            self.skipTest("this build has no viewer")
        numbers = {(one["kind"], one["name"]): number for number, one in enumerate(report["differences"])}
        seen = in_frame("""smurfViewer.shapes.solids.filter((solid) => smurfViewer.isSelected(solid)).map((solid) => {
          const { x, y, z } = smurfViewer.shapes.boxAround([solid]).getCenter(smurfViewer.stage.camera.position.clone());
          const at = smurfViewer.stage.toPage(smurfViewer.stage.camera.position.clone().set(x, y, z));
          const { clientWidth, clientHeight } = smurfViewer.stage.host;
          return [solid.layer, at[0] > 0 && at[0] < clientWidth && at[1] > 0 && at[1] < clientHeight]; })""")
        steps = [f"document.querySelector('#difference-{numbers['link', 'camera']}').click()", SELECTED, seen,
                 f"document.querySelector('#difference-{numbers['collision', 'upper_arm_collision']} button').click()", SELECTED, seen,
                 in_frame("smurfViewer.shapes.hidden.size"), "document.querySelector('[aria-current]').id",
                 "document.getElementById('pictured').textContent"]
        results = self.browse({"page": page, "steps": steps})[0]["results"]
        self.assertEqual(results[2], [["visuals", True]])
        self.assertEqual(results[5], [["collisions", True]])
        self.assertEqual(results[6], 0, "the collisions are shown when one of them is chosen")
        self.assertEqual(results[7], f"difference-{numbers['collision', 'upper_arm_collision']}")
        self.assertEqual(results[8], "collision upper_arm_collision of link upper_arm")

    def test_things_of_scenes_are_selected(self):
        page, data, report = self.page(*self.scenes())
        if "picture" not in data:
            self.skipTest("this build has no viewer")
        found = report["differences"]
        selected = self.chosen(page, found)
        by_kind = {(one["kind"], one["name"], one["change"]): thing for one, thing in zip(found, selected)}
        self.assertEqual(by_kind["joint", "wrist", "renamed"], ["new", "Hall/A", "hand", None])
        self.assertEqual(by_kind["entity", "Hall/D", "renamed"][:2], ["new", "Hall/D"])
        self.assertEqual(by_kind["visual", "", "changed"][:3], ["new", "Hall/B", "body"])

    def test_versions_are_shown_together_or_alone(self):
        page, _ = self.pictured(*self.arms())
        pressed = "[...document.querySelectorAll('#versions button')].map((one) => one.getAttribute('aria-pressed')).indexOf('true')"
        legend = "document.getElementById('legend').textContent"
        steps = [DRAWN, pressed, legend, {"key": "2"}, DRAWN, pressed, legend, {"key": "3"}, DRAWN,
                 in_frame("smurfViewer.overlays.frames.map(({ entity }) => [entity, smurfViewer.overlays.sizeOf(entity) > 0])"
                          ".filter(([entity, isShown]) => isShown !== (entity === 0)).length"),
                 "document.querySelector('#versions button').click()", DRAWN,
                 in_frame("smurfViewer.stage.host.dispatchEvent(new KeyboardEvent('keydown', { key: '2', bubbles: true }))"), pressed]
        results = self.browse({"page": page, "steps": steps})[0]["results"]
        both = {"new": 1, "old": 0.55}
        self.assertEqual(results[0:3], [both, 0, "new, solidold, translucentselected"])
        self.assertEqual(results[4:7], [{"old": 1}, 1, "in its own coloursselected"])
        self.assertEqual(results[8:10], [{"new": 1}, 0])
        self.assertEqual(results[11], both)
        self.assertEqual(results[13], 1, "a key that is pressed in the frame")

    def test_a_removed_thing_is_shown_in_both_versions(self):
        old, new = self.arms()
        page, data, report = self.page(old, new)
        if "picture" not in data:
            self.skipTest("this build has no viewer")
        lidar = next(number for number, one in enumerate(report["differences"]) if one["name"] == "lidar")
        steps = [{"key": "3"}, f"smurfDiff.showPicture(smurfDiff.items[{lidar}])", DRAWN, "document.getElementById('pictured').textContent"]
        results = self.browse({"page": page, "steps": steps})[0]["results"]
        self.assertEqual(set(results[2]), {"old", "new"})
        self.assertEqual(results[3], "link lidar, in the old version")

    def test_everything_has_a_name_and_fits(self):
        page, _ = self.pictured(*self.arms())
        fits = """(() => {
          const { left, top } = document.getElementById("picture").getBoundingClientRect();
          const isWide = left > 0;
          const card = document.activeElement.getBoundingClientRect();
          return [document.documentElement.scrollWidth, isWide ? card.right <= left : card.bottom <= top + 1]; })()"""
        ready = in_frame("new Promise((done) => setTimeout(done, 200))")
        jobs = [{"page": page, "width": width, "height": 800, "scheme": scheme,
                 "steps": [ready, {"key": "j"}, {"key": "j"}, ready, {"axe": True}, fits, {"key": "2"}, {"axe": True}]}
                for width in (1280, 400) for scheme in ("light", "dark")]
        for job, answer in zip(jobs, self.browse(*jobs)):
            with self.subTest(width=job["width"], scheme=job["scheme"]):
                self.assertEqual(answer["results"][4:6], [[], [job["width"], True]])
                self.assertEqual(answer["results"][7], [])


class SafetyTest(DiffTest):
    def test_names_are_text_wherever_they_are(self):
        name = xml.sax.saxutils.escape(HOSTILE, {'"': "&quot;"})
        robot = ('<robot name="r"><link name="{0}"><visual name="{0}"><geometry><box size="1 1 1"/></geometry></visual></link>'
                 '<link name="{1}"/><joint name="constructor" type="revolute"><parent link="{0}"/><child link="{1}"/>'
                 '<limit lower="0" upper="{2}" effort="1" velocity="1"/></joint></robot>')
        self.write("old.urdf", robot.format("base", "hand", 1))
        self.write("new.urdf", robot.format(name, "__proto__", 2))
        self.write("old.smurf", json.dumps({"modelname": "a", "files": ["old.urdf"], HOSTILE: {HOSTILE: 1, HIDDEN: 1}}))
        self.write("new.smurf", json.dumps({"modelname": HOSTILE, "files": ["new.urdf"], HOSTILE: {HOSTILE: HIDDEN, HIDDEN: 2}, HIDDEN: 1}))
        page, data, _ = self.page("old.smurf", "new.smurf")
        text = page.read_text()
        self.assertEqual((text.count("<script"), text.count("</script")), (2, 2))
        steps = ["smurfDiff.picture.loaded?.then(() => 1)"]
        steps += [f"smurfDiff.showPicture(smurfDiff.items[{number}])" for number in range(len(data["differences"]))]
        steps += ["[window.hacked, document.images.length, document.scripts.length, document.links.length]",
                  f"{CARDS}.map((card) => card.textContent).join(' ') + document.getElementById('pictured').textContent"]
        if "picture" in data:
            steps.append(in_frame("[window.hacked, document.getElementById('viewer').contentWindow.hacked]"))
        results = self.browse({"page": page, "steps": steps})[0]["results"][1 + len(data["differences"]):]
        self.assertEqual(results[0], [None, 0, 2, 0])
        self.assertIn('onerror="window.hacked=1"', results[1])
        self.assertNotRegex(results[1], "[\x00-\x08\x0b-\x1f\x7f-\x9f\u202e\u2028]")
        self.assertEqual(results[2:], [[None, None]] if "picture" in data else [])

    def test_nothing_else_runs_and_nothing_is_fetched(self):
        self.check_nothing_else_runs(self.page(*self.arms())[0])

    def test_pages_are_always_the_same(self):
        old, new = self.arms()
        self.assertEqual(self.page(old, new)[0].read_bytes(), self.page(old, new, "again.html")[0].read_bytes())


if __name__ == "__main__":
    viewer.main()
