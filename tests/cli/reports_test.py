# SPDX-License-Identifier: BSD-3-Clause
"""Reports for code hosts, over the findings of all rules' fixtures: SARIF, GitHub, GitLab, JUnit.

SARIF is also judged by its JSON Schema (in ../shared, when that is there) and by Microsoft's SARIF Multitool with the
rules of GitHub code scanning (when scripts/setup --readers has installed it).
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
import urllib.parse
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import cli  # noqa: E402

ROOT = cli.ROOT
SCHEMA = ROOT.parent / "shared/sarif/sarif-schema-2.1.0.json"
MULTITOOL = ROOT / "build/readers/node_modules/@microsoft/sarif-multitool-linux/Sarif.Multitool"
URDF = '<robot name="a">\n  <link name="ä😀" vaule="1"/>\n</robot>\n'


def entries(root):
    """The files to check in the fixtures of the rules, one path per rule."""
    for folder in sorted((root / "rules").glob("SML*/bad")):
        yield next(folder / name for name in ("scene.smurfs", "scene.svg", "model.smurf", "robot.urdf", "robot.urdf.xacro", "robot.srdf", "robot.mjcf", "robot.sdf") if (folder / name).exists())


def line_hashes(text):
    """As in fingerprints.ts of github/codeql-action, with an explicit window of 100 units."""
    units = []
    for unit in memoryview(text.replace("\r\n", "\r").encode("utf-16-le")).cast("H"):
        if unit not in (0x20, 0x09):
            units.append(0x0A if unit == 0x0D else unit)
    units.append(0xFFFF)
    starts = [0] + [i + 1 for i, unit in enumerate(units[:-1]) if unit == 0x0A]
    seen, hashes = {}, []
    for start in starts:
        value = 0
        for unit in (units[start:start + 100] + [0] * 100)[:100]:
            value = (value * 37 + unit) % 2**64
        key = f"{value:x}"
        seen[key] = seen.get(key, 0) + 1
        hashes.append(f"{key}:{seen[key]}")
    return hashes


def copy_fixtures():
    """A repository with the fixtures of the rules, nearly 2,000 files."""
    folder = pathlib.Path(tempfile.mkdtemp(prefix="smurf-reports-"))
    shutil.copytree(cli.FIXTURES / "rules", folder / "rules")
    (folder / ".git").mkdir()
    return folder


class ReportTest(cli.CliTest):
    """The tests of a class share one copy of the fixtures as their current folder, and do not change it."""

    @classmethod
    def setUpClass(cls):
        cls.repository = copy_fixtures()
        cls.addClassCleanup(shutil.rmtree, cls.repository, ignore_errors=True)

    def setUp(self):
        self.folder = self.repository

    def report(self, form, *paths, folder=None, code=1, infos=True):
        """With infos, as reports for programs have them; those for code hosts only on request."""
        arguments = ["--format", form, *(["--min-severity", "info"] if infos else []), *(paths or (p.relative_to(self.folder) for p in entries(self.folder)))]
        return self.expect(code, *arguments, cwd=folder or self.folder).stdout

    def sarif(self, *paths, **keywords):
        return json.loads(self.report("sarif", *paths, **keywords))["runs"][0]

    def diagnostics(self, *paths, **keywords):
        return json.loads(self.report("json", *paths, **keywords))["diagnostics"]


def offset(lines, line, column):
    return sum(map(len, lines[:line - 1])) + column - 1


def apply_fixes(folder, results):
    """Applies all fixes like a viewer of SARIF: of two that touch, the first is applied. True if a file changed."""
    edits, texts = {}, {}
    for fix in (f for result in results for f in result.get("fixes", [])):
        wanted = []
        for change in fix["artifactChanges"]:
            path = folder / urllib.parse.unquote(change["artifactLocation"]["uri"])
            text = texts.setdefault(path, path.read_bytes().decode(errors="surrogateescape"))
            lines = [line + "\n" for line in text.split("\n")]
            for replacement in change["replacements"]:
                region = replacement["deletedRegion"]
                begin = offset(lines, region["startLine"], region["startColumn"])
                end = offset(lines, region["endLine"], region["endColumn"])
                wanted.append((path, (begin, end, replacement.get("insertedContent", {"text": ""})["text"])))
        if all(edit in edits.get(path, []) for path, edit in wanted):
            continue
        if any(begin <= edit[1] and end >= edit[0] for path, edit in wanted for begin, end, _ in edits.get(path, [])):
            continue
        for path, edit in wanted:
            edits.setdefault(path, []).append(edit)
    for path, list_of_edits in edits.items():
        text = texts[path]
        for begin, end, new in sorted(list_of_edits, reverse=True):
            text = text[:begin] + new + text[end:]
        path.write_bytes(text.encode(errors="surrogateescape"))
    return bool(edits)


class Sarif(ReportTest):
    def test_line_hashes_of_this_test(self):
        self.assertEqual(line_hashes(" a\nb\n  \t\tc\n d"),
                         ["271789c17abda88f:1", "54703d4cd895b18:1", "180aee12dab6264:1", "a23a3dc5e078b07b:1"])

    def test_says_what_the_json_report_says(self):
        run = self.sarif()
        results, diagnostics = run["results"], self.diagnostics()
        self.assertGreater(len(results), 100)
        self.assertEqual([r["ruleId"] for r in results], [d["id"] for d in diagnostics])
        rules = run["tool"]["driver"]["rules"]
        self.assertEqual([r["id"] for r in rules], sorted(r["id"] for r in rules))
        for result, diagnostic in zip(results, diagnostics):
            self.assertEqual(rules[result["ruleIndex"]]["id"], result["ruleId"])
            place = result["locations"][0]["physicalLocation"]
            self.assertEqual(place["artifactLocation"]["uri"].replace("%20", " "), diagnostic["file"])
            self.assertEqual([place["region"][k] for k in ("startLine", "startColumn", "endLine", "endColumn")],
                             [diagnostic[k] for k in ("line", "column", "end_line", "end_column")])
            self.assertEqual(len(result.get("relatedLocations", [])), len(diagnostic.get("labels", [])))
            self.assertEqual(len(result.get("fixes", [])), 1 if "fix" in diagnostic else 0)

    def test_regions_and_fingerprints(self):
        for result in self.sarif()["results"]:
            place = result["locations"][0]["physicalLocation"]
            path = self.folder / place["artifactLocation"]["uri"].replace("%20", " ")
            if not path.exists():
                continue
            try:
                text = path.read_bytes().decode()
            except UnicodeDecodeError:
                continue
            region = place["region"]
            self.assertEqual(result["partialFingerprints"]["primaryLocationLineHash"],
                             line_hashes(text)[region["startLine"] - 1] if "\r" not in text.replace("\r\n", "")
                             else result["partialFingerprints"]["primaryLocationLineHash"])
            if "snippet" in region:
                lines = text.splitlines(keepends=True) if "\x0b" not in text else text.split("\n")
                begin = offset(lines, region["startLine"], region["startColumn"])
                end = offset(lines, region["endLine"], region["endColumn"])
                self.assertEqual(text[begin:end], region["snippet"]["text"], path)

    def test_columns_are_code_points_and_paths_start_at_the_repository(self):
        self.write("robots/my arm/a.urdf", URDF)
        run = self.sarif("a.urdf", folder=self.folder / "robots/my arm", code=0)
        self.assertEqual(run["columnKind"], "unicodeCodePoints")
        place = next(r for r in run["results"] if r["ruleId"] == "SML1107")["locations"][0]["physicalLocation"]
        self.assertEqual(place["artifactLocation"]["uri"], "robots/my%20arm/a.urdf")
        self.assertEqual(place["region"]["startColumn"], 19)

    def test_clean_run(self):
        model = cli.FIXTURES / "models/arm/smurf/arm.smurf"
        self.assertEqual(self.sarif(model, code=0)["results"], [])

    def test_fixes_are_those_of_fix(self):
        """Applying the fixes of SARIF in rounds gives the same bytes as --fix."""
        self.folder = copy_fixtures()
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        compared = 0
        for entry in entries(self.folder):
            here = entry.parent
            files = {path: path.read_bytes() for path in here.rglob("*") if path.is_file()}
            for _ in range(10):
                log = json.loads(self.expect(None, "--format", "sarif", "--min-severity", "info", entry).stdout)["runs"][0]
                if not apply_fixes(self.folder, log["results"]):
                    break
            by_sarif = {path: path.read_bytes() for path in files}
            for path, data in files.items():
                path.write_bytes(data)
            self.expect(0, "--fix-only", "--unsafe-fixes", "--min-severity", "info", entry)
            self.assertEqual(by_sarif, {path: path.read_bytes() for path in files}, entry)
            compared += by_sarif != files
        self.assertGreater(compared, 60)

    def test_schema(self):
        if not SCHEMA.exists():
            self.skipTest("there is no shared data beside the project")
        import jsonschema
        schema = json.loads(SCHEMA.read_text())
        log = json.loads(self.report("sarif"))
        jsonschema.Draft4Validator(schema).validate(log)
        del log["runs"][0]["results"][0]["message"]
        self.assertFalse(jsonschema.Draft4Validator(schema).is_valid(log))

    def test_multitool(self):
        if not MULTITOOL.exists():
            self.skipTest("SARIF Multitool is not installed (scripts/setup --readers)")
        MULTITOOL.chmod(0o755)
        log = json.loads(self.report("sarif"))
        self.assertEqual(self.multitool(log), [])
        del log["runs"][0]["results"][0]["partialFingerprints"]
        log["runs"][0]["results"][1]["locations"][0]["physicalLocation"]["region"]["startLine"] = 0
        self.assertNotEqual(self.multitool(log), [])

    def multitool(self, log):
        """The errors and warnings; the exit code does not depend on them."""
        self.write("in.sarif", json.dumps(log))
        subprocess.run([MULTITOOL, "validate", "in.sarif", "--output", "out.sarif", "--log", "ForceOverwrite",
                        "--rule-kind", "Sarif;Ghas"], cwd=self.folder, check=True, stdout=subprocess.DEVNULL,
                       env=os.environ | {"DOTNET_SYSTEM_GLOBALIZATION_INVARIANT": "1"})
        judged = json.loads((self.folder / "out.sarif").read_text(encoding="utf-8-sig"))["runs"][0]
        return [r["ruleId"] for r in judged["results"] if r.get("level", "warning") in ("error", "warning")]


class CodeHosts(ReportTest):
    def test_github(self):
        lines = self.report("github").splitlines()
        diagnostics = self.diagnostics()
        self.assertEqual(len(lines), len(diagnostics))
        for line, diagnostic in zip(lines, diagnostics):
            command = {"error": "error", "warning": "warning", "info": "notice"}[diagnostic["severity"]]
            self.assertTrue(line.startswith(f"::{command} file="), line)
            self.assertIn(f",line={diagnostic['line']},", line)
            self.assertIn(f",title={diagnostic['id']} {diagnostic['name']}::", line)

    def test_code_hosts_get_what_people_see(self):
        """Infos, which only --min-severity shows, are not put beside a pull request."""
        shown = [d["id"] for d in self.diagnostics() if d["severity"] != "info"]
        self.assertLess(len(shown), len(self.diagnostics()))
        self.assertEqual(len(self.report("github", infos=False).splitlines()), len(shown))
        self.assertEqual([i["check_name"] for i in json.loads(self.report("gitlab", infos=False))], shown)
        self.assertEqual([r["ruleId"] for r in self.sarif(infos=False)["results"]], shown)
        self.assertEqual(len(self.diagnostics(infos=False)), len(self.diagnostics()))  # JSON is for programs

    def test_github_escapes(self):
        self.write("a:b,c/a%b.urdf", URDF)
        line = self.report("github", "a:b,c/a%b.urdf", code=0)
        self.assertIn("::warning file=a%3Ab%2Cc/a%25b.urdf,line=2,endLine=2,col=19,", line)
        self.assertIn("%0Anote: ", line)

    def test_automatic(self):
        self.write("a.urdf", URDF)
        for value, start in (("true", "::warning"), ("false", "warning[")):
            for arguments in ((), ("--format", "auto")):
                done = self.expect(0, *arguments, "a.urdf", environment={"GITHUB_ACTIONS": value})
                self.assertTrue(done.stdout.startswith(start), done.stdout)

    def test_gitlab(self):
        issues = json.loads(self.report("gitlab"))
        self.assertEqual([i["check_name"] for i in issues], [d["id"] for d in self.diagnostics()])
        self.assertEqual(len({i["fingerprint"] for i in issues}), len(issues))
        self.assertLessEqual({i["severity"] for i in issues}, {"info", "minor", "major"})

    def test_gitlab_fingerprints_survive_new_lines(self):
        self.write("a.urdf", URDF)
        before = json.loads(self.report("gitlab", "a.urdf", code=0))
        self.write("a.urdf", URDF.replace("\n", "\n  <!-- new -->\n", 1))
        after = json.loads(self.report("gitlab", "a.urdf", code=0))
        self.assertNotEqual(before[0]["location"], after[0]["location"])
        self.assertEqual(before[0]["fingerprint"], after[0]["fingerprint"])

    def test_junit(self):
        suites = ElementTree.fromstring(self.report("junit"))
        cases = suites.findall("testsuite/testcase")
        self.assertEqual(int(suites.get("tests")), len(cases))
        failures = [case for case in cases if case.find("failure") is not None]
        self.assertEqual(int(suites.get("failures")), len(failures))
        wrong = {d["file"] for d in self.diagnostics() if d["severity"] == "error"}
        self.assertEqual({case.get("name") for case in failures}, wrong)
        self.assertGreater(len(cases), len(failures))


class Robots(cli.CliTest):
    """Which of several robots load where."""

    def test_a_table_with_the_worst_first(self):
        self.write("b/good.urdf", cli.ARM_URDF)
        self.write("b/bad.urdf", cli.ARM_URDF.replace('<mass value="1"/>', '<mass value="-1"/>'))
        self.write("c.smurf", "modelname: c\nfiles: [b/good.urdf]\n")
        text = self.run_tool("--target", "ros,gazebo,mujoco", ".").stdout
        table = text.split("\n\n")[-3].splitlines()
        self.assertEqual(table[0].split(), ["ros", "gazebo", "mujoco"])
        self.assertEqual([line.split()[0] for line in table[1:]][0], "b/bad.urdf")
        self.assertEqual(table[1].split()[1:], ["loads", "fails", "fails"])
        self.assertIn("ros: 2 of 2 robots load\ngazebo: 0 of 2 robots load\nmujoco: 1 of 2 robots loads\n", text)
        # One robot, and robots that load everywhere, need no table.
        self.assertNotIn(" of 1 robots", self.run_tool("--target", "ros,gazebo", "b/bad.urdf").stdout)
        self.assertNotIn("robots load", self.run_tool("--target", "ros", ".").stdout)
        self.assertNotIn("robots load", self.run_tool(".").stdout)

    def test_long_paths_lose_their_first_folders(self):
        folder = "/".join(["a_folder_with_a_long_name"] * 4)
        for name in ("x", "y"):
            self.write(f"{folder}/{name}.urdf", cli.ARM_URDF.replace('<mass value="1"/>', '<mass value="-1"/>'))
        text = self.run_tool("--target", "ros,gazebo", ".").stdout
        self.assertIn("\n.../a_folder_with_a_long_name/x.urdf  loads      fails\n", text)

    def test_the_page_has_the_robots(self):
        for name in ("one", "two"):
            self.write(f"{name}.urdf", cli.ARM_URDF)
        self.run_tool("--target", "ros", "--format", "html=page.html", ".")
        block = re.compile(r'<script id="report" type="application/json">(.*?)</script>', re.S)
        data = json.loads(block.search(self.read("page.html"))[1])
        self.assertEqual(data["robots"], [{"file": "one.urdf", "answers": ["takes"]}, {"file": "two.urdf", "answers": ["takes"]}])
        self.run_tool("--format", "html=page.html", "one.urdf")
        self.assertNotIn("robots", json.loads(block.search(self.read("page.html"))[1]))


if __name__ == "__main__":
    cli.main()
