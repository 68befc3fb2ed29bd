# SPDX-License-Identifier: BSD-3-Clause
"""With any names, text for people contains no terminal sequences and workflow commands, and other formats stay valid.

Usage: plain_output_test.py FOLDER_OF_TOOLS [unittest option]...
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import formats  # noqa: E402

TOOLS = None
# Terminal sequences, line ends, marks that change the text direction, ends of XML parts, invalid characters.
NASTY = "x\x01\x1b[31m\x07\b\r\n\t]]>-->\x7f\u0085\u009b2J\u202e\u2028\ufeff\ufffe\uffff<&\"'\\"
# GitHub's runner skips white space of all kinds before a command.
COMMANDS = ["::error file=a::b", "a ::error::b", "##[error]c", "##vso[task]d", "\u00a0::error::b", "\u3000::stop-commands::b",
            "a\u2003::error::b", "##teamcity[e]"]
FORMULA = "=HYPERLINK(1)"
LINK = "[click](http://evil.example)"
# Only characters that XML allows; text that is copied unchanged then contains no control characters.
IN_XML = "x&#9;&#10;&#13;]]&gt;-->&#127;&#x85;&#x9b;2J\u202e\u2028&lt;&amp;&quot;'"
FORBIDDEN = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f]")
LAYOUT = re.compile("[\u200e\u200f\u061c\u2028-\u202e\u2066-\u2069\ufeff]")


def yaml_text(text):
    return json.dumps(text)


def urdf(name):
    return f"""<?xml version="1.0" encoding="UTF-8"?>
<robot name="{name}">
  <link name="{name}"><visual><geometry><box size="1 1 1"/></geometry></visual></link>
  <link name="b{name}"><visual><geometry><mesh filename="none{name}.stl"/></geometry></visual>
    <inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="j{name}" type="revolute"><parent link="{name}"/><child link="b{name}"/>
    <axis xyz="0 0 1"/><limit lower="0" upper="1" effort="1" velocity="1"/></joint>
  <!-- \u202e --><joint name="f{name}" type="fixed"><parent link="b{name}"/><child link="c"/><dynamics/></joint>
  <link name="c"/>
</robot>
"""


class PlainOutputTest(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="smurf-plain-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def write(self, name, text):
        """`name` may be bytes."""
        path = os.path.join(os.fsencode(self.folder), os.fsencode(name))
        with open(path, "wb") as file:
            file.write(text.encode())

    def scene(self, stem="r"):
        """A model and a scene of it in which all names are hostile. YAML cannot name files that are not UTF-8: these
        exist, but have other names in the scene."""
        is_text = "\udcff" not in stem
        inner = stem if is_text else "r"
        for name in {stem, inner}:
            self.write(name + ".urdf", urdf(IN_XML))
            self.write(name + ".smurf", f"modelname: {yaml_text(NASTY)}\n"
                                        f"files: [{yaml_text(inner + '.urdf')}, r.yml]\n")
        self.write("r.yml", f"motors:\n- {{name: {yaml_text(NASTY)}, joint: {yaml_text(NASTY)}, type: PID}}\n"
                            f"materials:\n- {{name: {yaml_text(LINK)}, {yaml_text(NASTY)}: 1}}\n{yaml_text(NASTY)}: []\n")
        lines = [f"- {{name: {yaml_text(name)}, type: smurf, file: {yaml_text(inner + '.smurf')}, "
                 f"position: [{i}, 0, 0], {yaml_text(NASTY)}: {yaml_text(NASTY)}}}\n"
                 for i, name in enumerate([NASTY, *COMMANDS, FORMULA, LINK])]
        lines += [f"- {{name: {yaml_text('box' + NASTY)}, type: {yaml_text(NASTY)}, position: [1, 0, 0]}}\n"]
        self.write(stem + ".smurfs", "smurfs:\n" + "".join(lines) + f"lights:\n- {{name: {yaml_text(NASTY)}}}\n")

    def run_tool(self, tool, *arguments):
        variables = {k: v for k, v in os.environ.items() if k not in ("FORCE_COLOR", "GITHUB_ACTIONS")}
        done = subprocess.run([os.fsencode(TOOLS / tool), *map(os.fsencode, arguments)], cwd=self.folder, env=variables,
                              stdin=subprocess.DEVNULL, capture_output=True, timeout=600, check=False)
        self.assertIn(done.returncode, (0, 1, 2), (tool, arguments, done.stderr))
        return done

    def check_people(self, text, what, is_github=False):
        text = text.decode()  # valid UTF-8
        self.assertIsNone(FORBIDDEN.search(text), (what, text))
        self.assertIsNone(LAYOUT.search(text), (what, text))
        if is_github:
            return
        for line in text.splitlines():
            self.assertFalse(line.lstrip().startswith("::"), (what, line))
            self.assertNotRegex(line, r"##(vso|teamcity)?\[", what)

    def people(self, tool, *arguments):
        done = self.run_tool(tool, *arguments)
        with self.subTest(tool, arguments=arguments):
            self.check_people(done.stdout, arguments)
            self.check_people(done.stderr, arguments)
        return done

    def data(self, tool, *arguments):
        """The result is not text for people; only the messages are checked."""
        done = self.run_tool(tool, *arguments)
        self.check_people(done.stderr, arguments)
        text = done.stdout.decode()
        self.assertTrue(text, (tool, arguments, done.stderr))
        self.assertIsNone(FORBIDDEN.search(text), (arguments, text))
        return text


def page_data(text):
    """Only people read a page: it contains no hidden characters, except for the data of the viewer."""
    data = json.loads(text.split('type="application/json">')[1].split("</script>")[0])
    data.pop("picture", None)
    assert LAYOUT.search(json.dumps(data, ensure_ascii=False)) is None


PARSERS = {"json": json.loads, "gltf": json.loads, "sarif": json.loads, "gitlab": json.loads}
for form in ("sdf", "sdf1.6", "mjcf", "urdf", "svg", "junit"):
    PARSERS[form] = lambda text: xml.etree.ElementTree.fromstring(text.encode())
REPORT_PARSERS = {**PARSERS, "html": page_data}


class Names(PlainOutputTest):
    def formats(self):
        return formats.listed(self.run_tool("smurfs-flatten", "--format", "help").stdout.decode(), without=())

    def check_all(self, stem):
        self.scene(stem)
        scene, model, robot = stem + ".smurfs", stem + ".smurf", stem + ".urdf"
        for name in self.formats():
            for form in ("expand", "reference"):
                with self.subTest(name, form=form):
                    arguments = ["--format", name, "--force", "--quiet", "--form", form, "--links", "--", scene]
                    refusal = self.run_tool("smurfs-flatten", *arguments).stderr
                    if b"has no form" not in refusal and b"this build has no viewer" not in refusal:
                        text = self.data("smurfs-flatten", *arguments)
                        PARSERS.get(name, str)(text)
                        if name in ("tsv", "dot", "usda", "obj"):
                            self.check_people(text.encode(), arguments)
        with self.subTest("comparison"):
            json.loads(self.data("smurfs-flatten", "--compare-dialects", "--format", "json", "--force", "--", scene))
        self.people("smurfs-flatten", "--compare-dialects", "--force", "--", scene)
        for name in (NASTY.replace("\0", ""), COMMANDS[0]):
            self.people("smurfs-flatten", "--force", "--explain-pose=" + name, "--", scene)
        for name in ("json", "sarif", "gitlab", "junit", "html"):
            for tool, option in (("smurf-lint", "--format"), ("smurf-load-check", "--report")):
                with self.subTest(name, tool=tool):
                    self.run_tool(tool, f"{option}={name}=report", "--", scene)
                    text = (self.folder / "report").read_bytes().decode()
                    REPORT_PARSERS[name](text)
                    self.assertIsNone(FORBIDDEN.search(text))
        for name in ("full", "concise", "auto"):
            self.people("smurf-lint", "--format", name, "--target", "ros,mujoco,mars", "--", scene, model, robot)
        self.check_people(self.run_tool("smurf-lint", "--format", "github", "--", scene).stdout, "github", True)
        self.people("smurf-lint", "--diff", "--unsafe-fixes", "--", robot)
        for option in ("--list-files", "--statistics"):
            self.people("smurf-lint", option, "--", scene, model, robot)
        self.people("smurf-load-check", "--time", "0.01", "--", scene)
        with self.subTest("load check"):
            json.loads(self.data("smurf-load-check", "--time", "0.01", "--format", "json", "--", scene))
            self.run_tool("smurf-load-check", "--time", "0.01", "--stages", "still", "--trace", "trace", "--", robot)
            if (self.folder / "trace").exists():
                self.check_people((self.folder / "trace").read_bytes().replace(b"\r\n", b"\n"), "trace")
        self.check_differences(scene, model, robot)
        self.people("urdf2smurf", "--force", "--dry-run", "-o", "out", "--", robot)
        for options in ([], ["--canonical"], ["--prefix", "p_"], ["--apply", "all", "--sensors", "gazebo"]):
            with self.subTest(options=options):
                text = self.run_tool("smurf2urdf", "--force", *options, "--", model)
                self.check_people(text.stderr, options)
                if text.stdout:
                    xml.etree.ElementTree.fromstring(text.stdout)
        with self.subTest("losses"):
            self.run_tool("smurf2urdf", "--force", "--loss-report", "lost", "--", model)
            if (self.folder / "lost").exists():
                json.loads((self.folder / "lost").read_bytes().decode())

    def check_differences(self, *names):
        """Compares each file with a copy in which all names differ, in both directions."""
        self.write("other.urdf", urdf("y " + IN_XML))
        self.write("other.smurf", f"modelname: {yaml_text('y' + NASTY)}\nfiles: [other.urdf]\n")
        self.write("other.smurfs", f"entities:\n- {{name: {yaml_text('y ::error::b ' * 20)}, type: smurf, file: other.smurf}}\n")
        for name in names:
            for pair in ((name, "other" + pathlib.PurePath(name).suffix), ("other" + pathlib.PurePath(name).suffix, name)):
                done = self.people("smurf-diff", "--color", "never", "--", *pair)
                self.assertEqual(done.returncode, 1, done.stderr)
                json.loads(self.data("smurf-diff", "--format", "json", "--", *pair))
                self.people("smurf-diff", "--git", "--", name, pair[0], "0", "100644", pair[1], "0", "100644")

    def test_content(self):
        self.check_all("r")

    def test_names_of_files(self):
        self.check_all("r" + NASTY.replace("\\", ""))

    def test_a_name_that_is_a_command(self):
        self.check_all(COMMANDS[0])

    def test_names_that_are_not_utf_8(self):
        self.check_all(b"r\xff\xc2".decode("utf-8", "surrogateescape"))

    def test_new_models_can_be_read(self):
        self.write("r.urdf", urdf(IN_XML).replace(f'<mesh filename="none{IN_XML}.stl"/>', '<sphere radius="1"/>'))
        done = self.run_tool("urdf2smurf", "--force", "r.urdf", "-o", "out", "--motors", "all")
        self.assertEqual(done.returncode, 0, done.stderr)
        for path in (self.folder / "out").rglob("*.*"):
            self.assertIsNone(FORBIDDEN.search(path.read_bytes().decode()), path)


class Configuration(PlainOutputTest):
    def test_show_config(self):
        self.write("r.urdf", '<robot name="r"><link name="a"/></robot>')
        (self.folder / NASTY).mkdir()
        self.write(NASTY + "/base.yaml", "select: [SML5]\n")
        self.write(".smurf-lint.yaml", f"extends: {yaml_text(NASTY + '/base.yaml')}\nexclude: {yaml_text(NASTY)}\n"
                                       "format: concise\n"
                                       f"packages: {{{yaml_text(NASTY)}: {yaml_text(COMMANDS[0])}}}\n"
                                       f"schemas: {{sections: {{{yaml_text(NASTY)}: {yaml_text(NASTY)}}}}}\n")
        first = self.people("smurf-lint", "--show-config", ".").stdout.decode()
        self.write("shown.yaml", first)
        again = self.people("smurf-lint", "--config", "shown.yaml", "--show-config", ".").stdout.decode()
        self.assertEqual([line.split("  #")[0] for line in first.splitlines()[1:]],
                         [line.split("  #")[0] for line in again.splitlines()[1:]])


class Meanings(PlainOutputTest):
    def test_a_formula_is_a_name_in_a_spreadsheet(self):
        self.scene()
        text = self.data("smurfs-flatten", "--format", "tsv", "--force", "--quiet", "r.smurfs")
        self.assertIn("\n\\" + FORMULA + "\t", text)
        for row in text.strip("\n").split("\n"):
            self.assertEqual(row.count("\t"), 12, row)

    def test_what_is_escaped_in_a_table_can_be_read_back(self):
        self.scene()
        text = self.data("smurfs-flatten", "--format", "tsv", "--force", "--quiet", "r.smurfs")
        names = [row.split("\t")[0] for row in text.strip("\n").split("\n")[1:]]
        self.assertIn("\\u0023#[error]c", names)
        self.assertIn("\\u003a:error file=a::b", names)
        read = [re.sub(r"\\(u[0-9a-f]{4}|.)", lambda found: {"t": "\t", "n": "\n", "r": "\r"}.get(
            found[1], chr(int(found[1][1:], 16)) if len(found[1]) > 1 else found[1]), name) for name in names]
        for name in COMMANDS:
            self.assertIn(name, read)
        self.assertIn(NASTY, read)

    def test_a_link_is_a_name_in_sarif(self):
        self.scene()
        report = self.data("smurf-lint", "--format", "sarif", "r.smurf")
        messages = [result["message"]["text"] for result in json.loads(report)["runs"][0]["results"]]
        self.assertTrue(any("evil.example" in message for message in messages), messages)
        for message in messages:
            self.assertNotRegex(message, r"[^\\]\]\(")

    def test_the_largest_angles_are_numbers_in_other_units(self):
        self.write("a.urdf", '<robot name="a"><link name="b"><inertial><origin rpy="1.7e308 0 0"/><mass value="1"/><inertia '
                             'ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link></robot>')
        report = self.run_tool("smurf-lint", "--all", "a.urdf").stdout.decode()
        self.assertIn("[SML1441]", report)
        self.assertNotRegex(report, r"\b(inf|nan)\b")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(f"usage: {sys.argv[0]} FOLDER_OF_TOOLS [unittest option]...")
    TOOLS = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
