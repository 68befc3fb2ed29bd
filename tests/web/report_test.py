# SPDX-License-Identifier: BSD-3-Clause
"""The page of `smurf-lint --format html`: it shows what the JSON report has, runs no foreign code, and is accessible.

Usage: report_test.py TOOL BUILD
"""
import json
import xml.sax.saxutils

import browser
from browser import cli

HOSTILE = """<img src=x onerror="window.hacked=1"> </script><script>window.hacked=2</script> <!-- <script> javascript:alert(1)"""
HIDDEN = "\x1b[31m\x7f\u202e\u2028"
ROBOT = """<robot name="r">
  <link name="base"/>
  <link name="{name}"><inertial><mass value="-1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <joint name="j" type="fixd"><parent link="base"/><child link="{name}"/></joint>
</robot>
"""
# Its inertia is in kg mm2.
HEAVY = """<robot name="r"><link name="arm"><inertial><mass value="0.5"/>
<inertia ixx="130" ixy="0" ixz="0" iyy="6700" iyz="0" izz="6700"/></inertial>
<collision><geometry><box size="0.4 0.04 0.04"/></geometry></collision></link></robot>"""
CARDS = "[...document.querySelectorAll('.finding')]"
STATUS = "document.getElementById('status').textContent"


def choose(select, value):
    return f"(() => {{ const list = document.getElementById('{select}'); list.value = {json.dumps(value)};" \
           " list.dispatchEvent(new Event('change')); })()"


def search(words):
    return f"(() => {{ const input = document.getElementById('words'); input.value = {json.dumps(words)};" \
           " input.dispatchEvent(new Event('input')); })()"


class ReportTest(browser.BrowserTest):
    def page(self, *arguments, name="report.html", cwd=None):
        done = self.run_tool(*arguments, "--exit-zero", "--format", f"html={self.folder / name}", "--format", "json",
                             "--allow-outside", cwd=cwd)
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.folder / name, json.loads(done.stdout)

    def of_fixtures(self, *arguments):
        """A report with each kind of finding."""
        return self.page("rules", "--target", "mujoco,gazebo", *arguments, cwd=cli.FIXTURES)

    def robot(self, name="arm"):
        self.write("r.urdf", ROBOT.format(name=name))
        return "r.urdf"


class SafetyTest(ReportTest):
    def test_names_are_text_wherever_they_are(self):
        name = xml.sax.saxutils.escape(HOSTILE, {'"': "&quot;"})
        self.write(f"{HOSTILE[:20].replace('/', '_')}.urdf", ROBOT.format(name=name))
        self.write("s.smurfs", json.dumps({"entities": [{"name": HOSTILE, "file": HOSTILE, HOSTILE: HIDDEN}]}, ensure_ascii=False))
        page, report = self.page(".", "--target", "mujoco")
        self.assertTrue(any("onerror" in one["message"] for one in report["diagnostics"]), report)
        text = page.read_text()
        self.assertEqual((text.count("<script"), text.count("</script")), (2, 2))
        steps = ["document.querySelectorAll('.why').forEach((part) => (part.open = true))",
                 "[window.hacked, document.images.length, document.scripts.length, document.links.length]",
                 f"{CARDS}.map((card) => card.textContent).join(' ')"]
        results = self.browse({"page": page, "steps": steps})[0]["results"]
        self.assertEqual(results[1], [None, 0, 2, 0])
        self.assertIn('onerror="window.hacked=1"', results[2])
        self.assertNotRegex(results[2], "[\x00-\x08\x0b-\x1f\x7f-\x9f\u202e\u2028]")

    def test_nothing_else_runs_and_nothing_is_fetched(self):
        self.check_nothing_else_runs(self.page(self.robot())[0])


class ContentTest(ReportTest):
    def test_the_page_has_every_finding_of_the_json_report(self):
        page, report = self.of_fixtures()
        found, size = self.data_in(page, "report")
        self.assertLess(size, 100_000)
        self.assertGreater(len(found["diagnostics"]), 200)
        keys = ("id", "severity", "line", "column", "end_line", "end_column")
        self.assertEqual([[one[key] for key in keys] for one in found["diagnostics"]],
                         [[one[key] for key in keys] for one in report["diagnostics"]])
        self.assertEqual(set(found["rules"]) - {one["id"] for one in report["diagnostics"]}, set())
        shown = f"(() => {{ while (smurfReport.addMore(200)); document.querySelectorAll('.fold').forEach((one) => one.click());" \
                f" return {CARDS}.map((card) => [card.querySelector('h3').textContent, card.querySelector('.place')?.textContent]); }})()"
        cards = self.browse({"page": page, "steps": [shown]})[0]["results"][0]
        places = sorted(f"{one['file']}:{one['line']}:{one['column']}" for one in report["diagnostics"] if one["file"])
        self.assertEqual(sorted(place for _, place in cards if place), places)
        self.assertEqual(len(cards), len(report["diagnostics"]))

    def test_marks_are_the_bytes_of_the_findings(self):
        page, report = self.of_fixtures()
        marked = """smurfReport.report.diagnostics.map((finding) => {
          const card = smurfReport.card(finding);
          return [...card.querySelectorAll("figure:first-of-type code mark:not(.other)")].map((mark) => mark.textContent).join(""); })"""
        marks = self.browse({"page": page, "steps": [marked]})[0]["results"][0]
        compared = 0
        for one, mark in zip(report["diagnostics"], marks):
            if not one["file"] or one["line"] != one["end_line"]:
                continue
            try:
                lines = (cli.FIXTURES / one["file"]).read_bytes().decode().split("\n")
            except (UnicodeDecodeError, OSError):  # such as a file of an archive
                continue
            token = lines[one["line"] - 1][one["column"] - 1:one["end_column"] - 1]
            if token.isprintable() and 1 < len(token) < 200 and not any(label["file"] == one["file"] for label in one.get("labels", [])):
                self.assertEqual(mark, token, one)
                compared += 1
        self.assertGreater(compared, 150)

    def test_a_fix_is_shown_as_the_lines_that_change(self):
        page, report = self.page(self.robot())
        rows = f"{CARDS}.flatMap((card) => [...card.querySelectorAll('.fix del, .fix ins')].map((row) => row.textContent))"
        kinds = f"{CARDS}.flatMap((card) => [...card.querySelectorAll('.fix summary b')].map((kind) => kind.textContent))"
        results = self.browse({"page": page, "steps": [rows, kinds]})[0]["results"]
        line = ROBOT.format(name="arm").splitlines()[3]
        self.assertEqual(results[0], [line, line.replace("fixd", "fixed")])
        self.assertEqual(results[1], ["Unsafe fix"])
        self.assertEqual([one["fix"]["applicability"] for one in report["diagnostics"] if "fix" in one], ["unsafe"])

    def test_another_inertia_is_shown_and_its_command_copied(self):
        self.write("i.urdf", HEAVY)
        page, _ = self.page("i.urdf", "--select", "SML1518")
        steps = [f"{CARDS}[0].textContent", f"{CARDS}[0].querySelector('.fix ins').textContent",
                 "navigator.clipboard = undefined; window.copied = null;"
                 "Object.defineProperty(navigator, 'clipboard', {value: {writeText: async (text) => { window.copied = text; }}})",
                 f"{CARDS}[0].querySelector('.copy').click()", "window.copied", f"{CARDS}[0].querySelector('.copy').textContent"]
        results = self.browse({"page": page, "steps": steps})[0]["results"]
        self.assertIn("principal moments 130, 6700, 6700 become 0.000133, 0.00673, 0.00673: its shapes", results[0])
        self.assertIn('iyy="0.006733333"', results[1])
        self.assertEqual(results[4:], ["smurf-lint --fix-inertia 'i.urdf'", "Copied"])

    def test_rules_are_explained(self):
        page, _ = self.page(self.robot(), "--select", "SML1401")
        steps = ["document.querySelector('.why').open = true", "new Promise((done) => setTimeout(done, 50))",
                 "document.querySelector('.why').textContent"]
        text = self.browse({"page": page, "steps": steps})[0]["results"][2]
        explained = self.run_tool("--explain", "SML1401").stdout
        for heading in ("Why it matters", "What to do"):
            sentence = explained.split(heading)[1].strip().split("\n")[0].strip()
            self.assertIn(sentence.replace("`", ""), text)
        self.assertIn("MuJoCo", text)


class PictureTest(ReportTest):
    """The picture beside the list, in builds that have the viewer."""
    SELECTED = """(async () => {
      const card = %s.find((card) => card.textContent.includes(%s));
      const button = card.querySelector(".pictured");
      if (!button) return null;
      button.click();
      const viewer = await smurfReport.picture.loaded;
      await new Promise((done) => setTimeout(done, 100));
      const { entity, link } = viewer.selected;
      const { path, model } = viewer.scene.entities[entity];
      return [path, model?.links[link]?.name ?? null, document.getElementById("pictured").textContent];
    })()"""

    def pictured(self, *arguments):
        page, report = self.page(*arguments)
        if "picture" not in self.data_in(page, "report")[0]:
            self.skipTest("this build has no viewer")
        return page, report

    def selected(self, text):
        return self.SELECTED % (CARDS, json.dumps(text))

    def test_links_joints_meshes_and_entities_are_selected(self):
        robot, _ = self.pictured(self.robot(), "--target", "mujoco")
        self.write("m/a.urdf", '<robot name="a"><link name="base"><visual><geometry><mesh filename="x.stl"/></geometry></visual></link>'
                               '<link name="hand"/><joint name="wrist" type="revolute"><parent link="base"/><child link="hand"/>'
                               '<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint></robot>')
        self.write("m/x.stl", "solid s\nfacet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet\n"
                              "facet normal 0 0 1 outer loop vertex 0 0 0 vertex 0 0 0 vertex 0 1 0 endloop endfacet\nendsolid s\n")
        self.write("m/motors.yml", "motors:\n- {name: turner, joint: wrist, type: PID, maxEffort: -1}\n")
        self.write("m/a.smurf", "modelname: a\nfiles: [a.urdf, motors.yml]\n")
        self.write("m/s.smurfs", "smurfs:\n- {name: One, type: smurf, file: a.smurf, position: [0, 0, 0]}\n"
                                 "- {name: Two, type: smurf, file: a.smurf, position: [2, 0, 0], anchr: world}\n")
        scene, report = self.page("m/s.smurfs", name="scene.html")
        places = [one["file"] for one in report["diagnostics"]]
        jobs = [{"page": robot, "steps": [self.selected("SML1401"), self.selected("SML1509")]},
                {"page": scene, "steps": [self.selected("m/s.smurfs"), self.selected("m/motors.yml")]}]
        answers = self.browse(*jobs)
        self.assertEqual(answers[0]["results"], [["r", "arm", "joint j"], ["r", "arm", "link arm"]])
        self.assertIn("m/motors.yml", places)
        self.assertEqual(answers[1]["results"][0][::2], ["Two", "entity Two"])
        self.assertEqual(answers[1]["results"][1], ["One", "hand", "motor turner"])

    def test_both_inertias_are_shown_for_a_finding_about_them(self):
        self.write("i.urdf", HEAVY)
        page, _ = self.pictured("i.urdf", "--select", "SML1518")
        sizes = """(() => {
          const { inertias, solids, parts } = document.getElementById("viewer").contentWindow.smurfViewer.overlays;
          const lengthOf = ([{ local }]) => Math.max(...[0, 4, 8].map((at) => Math.hypot(...local.elements.slice(at, at + 3))));
          return [parts.inertias.drawn.visible, parts.solids.drawn.visible, lengthOf(inertias), lengthOf(solids)];
        })()"""
        inertias, solids, written, full = self.browse({"page": page, "steps": [self.selected("SML1518"), sizes]})[0]["results"][1]
        self.assertEqual((inertias, solids), (True, True))
        self.assertAlmostEqual(written, (2.5 / 0.5 * (2 * 6700 - 130)) ** 0.5, 1)
        self.assertAlmostEqual(full, (5 / 12) ** 0.5 * 0.4, 3)  # half of an axis

    def test_the_picture_covers_nothing_and_is_closed_again(self):
        page, _ = self.pictured(self.robot(), "--target", "mujoco")
        covered = """(() => {
          const picture = document.getElementById("picture").getBoundingClientRect();
          const { right, bottom } = document.activeElement.getBoundingClientRect();
          return [document.documentElement.scrollWidth, right > picture.left && bottom > picture.top + 1];
        })()"""
        steps = [{"key": "j"}, {"key": "v"}, "smurfReport.picture.loaded.then(() => new Promise((done) => setTimeout(done, 300)))",
                 covered, {"axe": True}, {"key": "Escape"}, "document.getElementById('picture').hidden",
                 "document.activeElement.className"]
        jobs = [{"page": page, "width": width, "height": 800, "scheme": scheme, "steps": steps}
                for width, scheme in ((1280, "light"), (400, "dark"))]
        for job, answer in zip(jobs, self.browse(*jobs)):
            self.assertEqual(answer["results"][3], [job["width"], False])
            self.assertEqual(answer["results"][4:7], [[], None, True])
            self.assertIn("finding", answer["results"][7])

    def test_what_has_no_place_is_not_shown(self):
        page, report = self.pictured(cli.FIXTURES / "rules/SML1205-no-root/bad/robot.urdf")
        self.assertIn("SML1205", [one["id"] for one in report["diagnostics"]])
        self.assertEqual(self.browse({"page": page, "steps": ["document.querySelectorAll('.pictured').length"]})[0]["results"], [0])

    def test_several_robots_have_no_picture(self):
        self.write("other.urdf", ROBOT.format(name="other"))
        page, _ = self.page(self.robot(), "other.urdf")
        self.assertNotIn("picture", self.data_in(page, "report")[0])
        self.assertEqual(self.browse({"page": page, "steps": ["document.querySelectorAll('.pictured').length"]})[0]["results"], [0])


class UseTest(ReportTest):
    def test_search_and_filters(self):
        page, report = self.of_fixtures()
        found = report["diagnostics"]
        errors = sum(one["severity"] == "error" for one in found)
        rule = found[0]["id"]
        file = found[-1]["file"]
        steps = [STATUS, "document.querySelector('.toggle.error').click()", STATUS, {"key": "Escape"}, STATUS,
                 choose("rule", rule), STATUS, choose("rule", ""), choose("file", file), STATUS, choose("file", ""),
                 search("inertia MASS"), STATUS, search("no finding has these words"), STATUS,
                 "document.querySelector('.nothing').textContent", "document.querySelector('.nothing button').click()", STATUS,
                 "document.querySelector('#target-list button').click()",
                 "[document.getElementById('target').value, document.getElementById('clear').hidden]", STATUS]
        results = self.browse({"page": page, "steps": steps})[0]["results"]

        def shown(count):
            return f"{count:,} of {len(found):,} findings"
        self.assertEqual([results[0], results[2], results[4]], ["", shown(len(found) - errors), ""])
        self.assertEqual(results[6], shown(sum(one["id"] == rule for one in found)))
        self.assertEqual(results[9], shown(sum(one["file"] == file for one in found)))
        count = int(results[12].split(" ")[0].replace(",", ""))
        self.assertTrue(0 < count < len(found), results[12])
        self.assertEqual(results[14], shown(0))
        self.assertIn("Show all findings", results[15])
        self.assertEqual(results[17], "")
        self.assertEqual(results[19], ["mujoco", False])
        self.assertRegex(results[20], r"^\d+ of ")

    def test_keys(self):
        page, _ = self.page(self.robot())
        here = "document.activeElement.id"
        steps = [{"key": "j"}, here, {"key": "j"}, here, {"key": "k"}, here, {"key": "/"}, here, {"key": "j"},
                 "document.getElementById('words').value", {"key": "Escape"}, "document.getElementById('words').value"]
        results = self.browse({"page": page, "steps": steps})[0]["results"]
        self.assertRegex(results[1], r"^finding-\d+$")
        self.assertNotEqual(results[1], results[3])
        self.assertEqual(results[5], results[1])
        self.assertEqual([results[7], results[9], results[11]], ["words", "j", ""])

    def test_many_findings_are_folded_and_laid_out_when_asked_for(self):
        self.write("r.urdf", '<robot name="r"><link name="base"/>\n' + "".join(
            f'<link name="l{i}"/><joint name="j{i}" type="fixd"><parent link="base"/><child link="l{i}"/></joint>\n'
            for i in range(9000)) + "</robot>\n")
        page, report = self.page("r.urdf", "--limit", "findings=100000")
        self.assertGreaterEqual(len(report["diagnostics"]), 9000)
        fold = "document.querySelector('.fold').textContent"
        more = "document.getElementById('more')"
        steps = [f"{CARDS}.length", fold, "document.querySelector('.fold').click()", f"{CARDS}.length", choose("rule", "SML1401"),
                 f"[{CARDS}.length, {more}.hidden]", f"{more}.click()", f"[{CARDS}.length, {more}.textContent]"]
        results = self.browse({"page": page, "steps": steps})[0]["results"]
        self.assertLess(results[0], 50)
        self.assertIn("more of SML", results[1])
        self.assertLessEqual(results[3], results[0] + 200)
        self.assertEqual(results[5], [200, False])
        self.assertEqual(results[7], [400, "Show more (8,600 findings left)"])

    def test_empty_reports_say_so(self):
        page, report = self.page(cli.FIXTURES / "models/arm/smurf/arm.smurf")
        self.assertEqual(report["diagnostics"], [])
        steps = ["document.getElementById('title').textContent", "document.getElementById('list').textContent",
                 "document.getElementById('filters').hidden", {"key": "j"}, {"axe": True}]
        results = self.browse({"page": page, "steps": steps})[0]["results"]
        self.assertEqual(results[0], "No findings")
        self.assertIn("--target", results[1])
        self.assertEqual(results[2:], [True, None, []])

    def test_links_that_were_not_followed_are_counted(self):
        self.write("robots/arm.urdf", ROBOT.format(name="arm"))
        self.write("other/hand.urdf", ROBOT.format(name="hand"))
        (self.folder / "robots/hand").symlink_to("../other")
        page, report = self.page("robots", cwd=self.folder)
        self.assertEqual(report["summary"]["links"], 1)
        steps = ["document.getElementById('counts').textContent"]
        [text] = self.browse({"page": page, "steps": steps})[0]["results"]
        self.assertIn("1 symbolic link that leads out of the folder was not followed.", text)

    def test_everything_has_a_name_and_is_readable(self):
        page, _ = self.page("rules/SML1401-type-missing-or-unknown/bad", "rules/SML3101-unknown-joint/bad",
                            "rules/SML0011-duplicate-key/bad", "--target", "mujoco,gazebo", cwd=cli.FIXTURES)
        fits = "[document.documentElement.scrollWidth, [...document.querySelectorAll('body *')]" \
               ".filter((part) => part.getBoundingClientRect().right > innerWidth + 1).map((part) => part.outerHTML)]"
        steps = ["document.querySelectorAll('.why').forEach((part) => (part.open = true))", {"axe": True}, fits]
        jobs = [{"page": page, "width": width, "height": 800, "scheme": scheme, "steps": steps}
                for width in (1280, 400) for scheme in ("light", "dark")]
        for job, answer in zip(jobs, self.browse(*jobs)):
            self.assertEqual(answer["results"][1], [], (job["width"], job["scheme"]))
            self.assertEqual(answer["results"][2], [job["width"], []])


if __name__ == "__main__":
    browser.main()
