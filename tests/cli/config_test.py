# SPDX-License-Identifier: BSD-3-Clause
"""The configuration of smurf-lint: which file is read, its settings, and its schema."""
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import cli  # noqa: E402

SCHEMAS = cli.ROOT / "schemas"
SCENE = "entities:\n- {file: box.urdf}\n- {name: bow, type: rainbow, radius: wide}\n"
URDF = '<?xml version="1.0"?>\n<robot name="box"><link name="box"/></robot>\n'
RAINBOW = '{"properties": {"radius": {"type": "number", "description": "In metres."}}}\n'


class ConfigTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.write("robots/scene.smurfs", SCENE)
        self.write("robots/box.urdf", URDF)

    def findings(self, *arguments, code=None, **keywords):
        """(file, id, severity) of each finding in the JSON report."""
        report = json.loads(self.expect(code, "--format", "json", *arguments, **keywords).stdout)
        return [(d["file"], d["id"], d["severity"]) for d in report["diagnostics"]]


class Search(ConfigTest):
    UNNAMED = ("robots/scene.smurfs", "SML5012", "warning")

    def test_without_configuration(self):
        self.assertEqual(self.findings("robots"), [self.UNNAMED])

    def test_nearest_upward(self):
        self.write(".smurf-lint.yaml", "ignore: [SML5012]\n")
        self.assertEqual(self.findings("robots"), [])
        self.assertEqual(self.findings("robots/scene.smurfs"), [])
        self.assertEqual(self.findings("scene.smurfs", cwd=self.folder / "robots"), [])
        self.assertEqual(self.findings("-", "--stdin-filename", "robots/scene.smurfs", stdin=SCENE), [])
        self.write("robots/.smurf-lint.yaml", "severity: {unnamed-entity: error}\n")
        self.assertEqual(self.findings("robots"), [(*self.UNNAMED[:2], "error")])

    def test_a_rule_that_is_switched_off_as_in_other_linters(self):
        self.write(".smurf-lint.yaml", "severity: {SML5012: off}\n")
        found = self.expect(1, "robots").stdout
        self.assertIn("`SML5012` must be error, warning or info, not the text `off`", found)
        self.assertIn("= help: to switch a rule off: `ignore: [SML5012]`\n", found)

    def test_named_and_isolated(self):
        self.write(".smurf-lint.yaml", "ignore: SML5012\n")
        self.write("other.yaml", "severity: {SML5: info}\n")
        self.assertEqual(self.findings("--config", "other.yaml", "robots"),
                         [(*self.UNNAMED[:2], "info")])
        self.assertEqual(self.findings("--isolated", "robots"), [self.UNNAMED])
        self.expect_complaint("--isolated and --config exclude each other",
                              "--isolated", "--config", "other.yaml", "robots")

    def test_missing(self):
        done = self.run_tool("--config", "absent.yaml", "robots")
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr, "smurf-lint: cannot read 'absent.yaml': "
                                      "No such file or directory\n")

    def test_command_line_wins(self):
        self.write(".smurf-lint.yaml", "select: [SML1]\nseverity: {SML5012: info}\n")
        self.assertEqual(self.findings("robots"), [])
        self.assertEqual(self.findings("--select", "SML5", "robots"), [(*self.UNNAMED[:2], "info")])
        self.assertEqual(
            self.findings("--select", "SML5", "--severity", "SML5012=error", "robots"),
            [(*self.UNNAMED[:2], "error")])


    def test_nearest_for_each_file(self):
        """The configuration nearest to a file applies, independently of the first path."""
        for name, level in (("a", "error"), ("b", "info")):
            self.write(f"{name}/scene.smurfs", SCENE.replace("box.urdf", "../robots/box.urdf"))
            self.write(f"{name}/.smurf-lint.yaml", f"severity: {{SML5012: {level}}}\n")
        expected = [("a/scene.smurfs", "SML5012", "error"), ("b/scene.smurfs", "SML5012", "info")]
        self.assertEqual(self.findings("a", "b"), expected)
        self.assertEqual(self.findings("b/scene.smurfs", "a/scene.smurfs"), expected)
        self.assertEqual(self.findings("."), [*expected, self.UNNAMED])


class Extends(ConfigTest):
    def test_own_settings_win(self):
        self.write("base/strict.yaml", "select: [SML1]\nignore: [SML19]\nseverity: {SML5012: error, SML3: info}\n")
        self.write(".smurf-lint.yaml", "severity: {SML5012: info}\nselect: SML5\nextends: base/strict.yaml\n")
        self.assertEqual(self.findings("robots"), [("robots/scene.smurfs", "SML5012", "info")])
        self.write(".smurf-lint.yaml", "extends: [base/strict.yaml]\n")
        self.assertEqual(self.findings("robots"), [])
        self.assertEqual(self.findings("--select", "SML5", "robots"), [("robots/scene.smurfs", "SML5012", "error")])

    def test_chains(self):
        self.write(".smurf-lint.yaml", "extends: [one.yaml, two.yaml]\n")
        self.write("one.yaml", "extends: two.yaml\nseverity: {SML5012: info}\n")
        self.write("two.yaml", "severity: {SML5012: error}\n")
        self.assertEqual(self.findings("robots"), [("robots/scene.smurfs", "SML5012", "info")])

    def test_mistakes(self):
        self.write(".smurf-lint.yaml", "extends: [a/b.yaml, absent.yaml, {}]\n")
        self.write("a/b.yaml", "extends: ../.smurf-lint.yaml\nselct: SML1\n")
        done = self.expect(1, "--format", "concise", "robots")
        self.assertEqual([line.split(" (")[0] for line in done.stdout.splitlines() if "SML90" in line], [
            ".smurf-lint.yaml:1:21: error[SML9002] cannot read `absent.yaml`: No such file or directory",
            ".smurf-lint.yaml:1:34: error[SML9002] an item must be a text, not a mapping",
            "a/b.yaml:1:10: error[SML9002] the configuration extends itself through other configurations",
            "a/b.yaml:2:1: error[SML9001] there is no setting `selct`"])
        self.write(".smurf-lint.yaml", "extends: .smurf-lint.yaml\n")
        self.assertIn("the configuration extends itself\n", self.expect(1, "--format", "concise", "robots").stdout)
        for i in range(30):
            self.write(f"c{i}.yaml", f"extends: [c{i + 1}.yaml, c{i + 2}.yaml]\n")
        done = self.expect(1, "--format", "concise", "--config", "c0.yaml", "robots")
        self.assertIn("16 configurations extend each other already", done.stdout)


class Content(ConfigTest):
    def test_paths(self):
        self.write("robots/old/scene.smurfs", SCENE.replace("box", "../box"))
        self.write(".smurf-lint.yaml", "paths:\n  robots/*.smurfs: {severity: {SML50: error}}\n"
                                       "  old/: {ignore: [unnamed-entity]}\n")
        found = [("robots/scene.smurfs", "SML5012", "error")]
        self.assertEqual(self.findings("robots"), found)
        self.assertEqual(self.findings(".", cwd=self.folder / "robots"), [("scene.smurfs", *found[0][1:])])
        self.write(".smurf-lint.yaml", "paths: {'*': {ignore: SML5}, old: {select: SML1}, x: 3}\n")
        self.assertEqual([f[:2] for f in self.findings("robots") if f[0].startswith(".")],
                         [(".smurf-lint.yaml", "SML9001"), (".smurf-lint.yaml", "SML9002")])

    def test_a_comment_for_a_rule_that_its_path_ignores_is_not_unused(self):
        self.write("robots/scene.smurfs", SCENE.replace("urdf}", "urdf}  # smurf-lint: ignore[SML5012] known"))
        self.assertEqual(self.findings("robots"), [])
        self.write(".smurf-lint.yaml", "paths: {robots: {ignore: SML5012}}\n")
        self.assertEqual(self.findings("robots"), [])

    def test_targets(self):
        self.write("arm.urdf", URDF)
        self.write(".smurf-lint.yaml", "targets: [ros, mujoco]\n")
        report = json.loads(self.expect(None, "--format", "json", "arm.urdf").stdout)
        self.assertEqual(list(report["targets"]), ["ros", "mujoco"])
        report = json.loads(self.expect(None, "--format", "json", "--target", "dart", "arm.urdf").stdout)
        self.assertEqual(list(report["targets"]), ["dart"])
        self.write(".smurf-lint.yaml", "targets: mujuco\n")
        self.assertIn(".smurf-lint.yaml:1:10: error[SML9002] there is no target `mujuco` (did you mean `mujoco`?)\n",
                      self.expect(1, "--format", "concise", "arm.urdf").stdout)

    def test_tolerances(self):
        scene = SCENE.replace("urdf}", "urdf, name: a, position: [0, 0, 0], rotation: [1.01, 0, 0, 0]}")
        self.write("robots/scene.smurfs", scene)
        self.assertIn("SML5004", [f[1] for f in self.findings("robots")])
        self.write(".smurf-lint.yaml", "tolerances: {quaternion-not-unit: 0.02}\n")
        self.assertNotIn("SML5004", [f[1] for f in self.findings("robots")])
        self.write(".smurf-lint.yaml", "tolerances: {SML3101: 1, SML50: 1, SML5004: -1, x: 1}\n")
        done = self.expect(1, "--format", "concise", "--select", "SML9", "robots")
        self.assertEqual([line.split("] ")[1] for line in done.stdout.splitlines()], [
            "`SML3101` has no tolerance (`--list-rules=json` shows which have one)",
            "`SML50` has no tolerance (name one rule)", "`SML5004` must be a number from 0, not `-1`",
            "there is no rule `x`"])
        self.assertIn("Tolerance\n  0.001: how far", self.expect(0, "--explain", "SML5004").stdout)

    def test_packages(self):
        self.write("robots/box.urdf", '<robot name="box"><link name="box"><visual><geometry>'
                                      '<mesh filename="package://shapes/cube.stl"/></geometry></visual></link></robot>')
        self.write("shared/cube.stl", "solid cube\nendsolid cube\n")
        self.assertIn("SML1604", [f[1] for f in self.findings("robots/box.urdf")])
        self.write("robots/.smurf-lint.yaml", "packages: {shapes: ../shared}\n")
        self.assertNotIn("SML1604", [f[1] for f in self.findings("robots/box.urdf")])
        self.assertIn("SML1604", [f[1] for f in self.findings("--package", "shapes=robots", "robots/box.urdf")])

    def test_a_mesh_below_find_has_an_address(self):
        self.write("shapes/package.xml", cli.package("shapes"))
        self.write("shapes/cube.stl", "solid cube\nendsolid cube\n")
        self.write("shapes/urdf/box.xacro", '<robot name="box" xmlns:xacro="x"><link name="box"><visual><geometry>'
                                            '<mesh filename="$(find shapes)/cube.stl"/></geometry></visual></link></robot>')
        for path in ("shapes/urdf/box.xacro", self.folder / "shapes/urdf/box.xacro"):
            done = self.expect(0, "--select", "SML1607", path)
            self.assertIn("RViz and MoveIt do not open `/", done.stdout)
            self.assertIn("help: write `package://shapes/cube.stl`\n", done.stdout)

    def xacro_findings(self, *arguments):
        report = json.loads(self.expect(None, "--format", "json", "--select", "SML15,SML33,SML9", *arguments).stdout)
        return [(d["id"], d.get("line"), sorted(note for note in d.get("notes", []) if note.startswith("with ")))
                for d in report["diagnostics"]]

    def test_xacro(self):
        self.write("arm/arm.urdf.xacro", """<robot name="$(arg name)" xmlns:xacro="http://www.ros.org/wiki/xacro">
<link name="a"><inertial><mass value="$(arg mass)"/>
<inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="${0.01 if '$(arg size)' == 'small' else 0.05}"/></inertial></link>
</robot>""")
        self.write("arm/.smurf-lint.yaml", "xacro:\n- file: arm.urdf.xacro\n  arguments: {name: arm, mass: [1, -1], size: [small, large]}\n")
        of_all = [("SML1509", 2, ["with mass:=-1 size:=small"]), ("SML1512", 3, ["with mass:=1 size:=large"])]
        self.assertEqual(sorted(self.xacro_findings("arm"))[:1], of_all[:1])
        self.assertEqual([one[0] for one in self.xacro_findings("arm")].count("SML1509"), 1)
        self.assertIn("with mass:=1 size:=large", str(self.xacro_findings("arm/arm.urdf.xacro")))
        # The command line overrides the configuration.
        self.assertEqual(self.xacro_findings("arm/arm.urdf.xacro", "mass:=1", "size:=small"), [])
        self.assertEqual([one[0] for one in self.xacro_findings("arm", "--limit", "xacro-variants=2")].count("SML9002"), 1)
        self.write("arm/.smurf-lint.yaml", "xacro: [{file: gone.xacro}]\n")
        self.assertIn("SML9002", [one[0] for one in self.xacro_findings("arm")])

    def test_format_and_verdict(self):
        self.write("robots/.smurf-lint.yaml", "format: [concise, json=report.json]\nfail-on: warning\n")
        done = self.expect(1, "--config", "robots/.smurf-lint.yaml", "robots")
        self.assertTrue(done.stdout.startswith("robots/scene.smurfs:2:4: warning[SML5012] "), done.stdout)
        self.assertEqual(json.loads(self.read("robots/report.json"))["summary"]["warning"], 1)
        self.assertIn("robots/.smurf-lint.yaml:1:19: error[SML9002] a configuration that was found beside the files "
                      "must not name a file to write (name it on the command line, `--format json=FILE`, or name the "
                      "configuration with `--config`)\n", self.expect(1, "robots").stdout)
        self.write("robots/.smurf-lint.yaml", "format: concise\nfail-on: warning\n")
        self.assertTrue(self.expect(1, "robots").stdout.startswith("robots/scene.smurfs:2:4: warning[SML5012] "))
        self.expect(0, "--fail-on", "error", "--format", "concise", "robots")
        self.write("robots/.smurf-lint.yaml", "max-warnings: 0\n")
        self.expect(1, "robots")
        self.expect(0, "--max-warnings", "1", "robots")
        self.write("robots/.smurf-lint.yaml", "fail-on: never\nselct: 3\n")
        self.expect(0, "robots")
        self.write(".smurf-lint.yaml", "fail-on: fatal\nmax-warnings: many\nformat: [full, jsn, json]\n"
                                       "force-exclude: maybe\n")
        done = self.expect(1, "--format", "concise", "--config", ".smurf-lint.yaml", "--select", "SML9", "robots")
        self.assertEqual([line.split("] ")[1] for line in done.stdout.splitlines()], [
            "`fail-on` must be error, warning, info or never, not the text `fatal`",
            "`max-warnings` must be a whole number from 0, not the text `many`",
            "there is no format `jsn` (did you mean `json`?)",
            "two reports go to standard output (write `json=FILE`)",
            "`force-exclude` must be true or false, not the text `maybe`"])

    def test_baseline(self):
        self.write("robots/.smurf-lint.yaml", "baseline: known.yaml\n")
        self.assertEqual([f[1] for f in self.findings("robots")], ["SML9002", "SML5012"])
        self.expect_complaint("a configuration that was found beside the files cannot choose the file to write; to "
                              "write its baseline, add --baseline 'robots/known.yaml'", "--generate-baseline", "robots")
        self.assertEqual(self.expect(0, "--config", "robots/.smurf-lint.yaml", "--generate-baseline", "robots").stdout,
                         "wrote 1 finding to robots/known.yaml\n")
        self.assertEqual(self.findings("robots"), [])
        self.assertEqual(self.findings(".", cwd=self.folder / "robots"), [])

    def test_schemas_are_relative_to_the_configuration(self):
        self.write(".smurf-lint.yaml", "schemas: {entities: {rainbow: schemas/rainbow.json}}\n")
        self.write("schemas/rainbow.json", RAINBOW)
        done = self.expect(1, "--select", "SML54", "scene.smurfs", cwd=self.folder / "robots")
        self.assertIn("error[SML5401]: `radius` must be a number, not the text `wide`\n"
                      " --> scene.smurfs:3:38\n", done.stdout)
        self.assertIn("note: required here by the schema\n --> ../schemas/rainbow.json:1:28\n",
                      done.stdout)
        self.assertIn("  = help: In metres.\n", done.stdout)

    def test_mistakes_are_findings(self):
        self.write(".smurf-lint.yaml", "ingore: [SML5012]\nselect: [SML9, unamed-entity]\n"
                                       "schemas: {sections: {a: absent.json}}\n")
        done = self.expect(1, "--format", "concise", "robots")
        self.assertIn(".smurf-lint.yaml:1:1: error[SML9001] there is no setting `ingore` "
                      "(did you mean `ignore`?)\n", done.stdout)
        self.assertIn(".smurf-lint.yaml:2:16: error[SML9002] there is no rule `unamed-entity` "
                      "(did you mean `unnamed-entity`?)\n", done.stdout)
        self.assertIn(".smurf-lint.yaml:3:25: error[SML9002] cannot read `absent.json`: ",
                      done.stdout)

    def test_hostile(self):
        for text in ["[1, 2]", "select: {a: [", "\0", "severity: 3", "schemas: [x]", "a: &a [*a]",
                     "ignore: " + "[" * 200, "schemas: {sections: {x: /dev/zero}}", ""]:
            with self.subTest(text=text):
                self.write(".smurf-lint.yaml", text)
                self.expect(None, "robots")

    def test_schema_of_the_configuration(self):
        try:
            import jsonschema
        except ImportError:
            self.skipTest("python3-jsonschema is not installed (scripts/setup)")
        schema = json.loads((SCHEMAS / "config.schema.json").read_text())
        jsonschema.Draft7Validator.check_schema(schema)
        validator = jsonschema.Draft7Validator(schema)
        good = [{"select": ["SML5"], "ignore": "SML5012", "severity": {"SML5012": "info"}},
                {"schemas": {"sections": {"rainbow": "rainbow.json"}, "entities": None}},
                {"targets": ["mars"]}, {}, None, {"extends": "rainbow.json"}, {"tolerances": {"SML5004": 0.1}},
                {"paths": {"*.urdf": {"ignore": "SML1", "severity": {"unknown-joint": "info"}}}},
                {"xacro": [{"file": "a.xacro", "arguments": {"side": ["left", "right"], "n": 1}}]},
                {"xacro": [{"file": "a.xacro"}]},
                {"companions": [{"robot": "a.xacro", "files": ["rainbow.json"]}, {"robot": "a.xacro", "files": "rainbow.json"}]},
                {"exclude": ["old", "/a/**"], "force-exclude": True, "packages": {"a": "b"}},
                {"format": ["full", "json=x.json"], "fail-on": "never", "max-warnings": 3, "baseline": None}]
        bad = [{"ingore": []}, {"select": {}}, {"severity": {"SML5012": "fatal"}},
               {"schemas": {"entites": {}}}, {"schemas": {"sections": {"a": []}}}, {"targets": {}}, [],
               {"xacro": [{"arguments": {"a": 1}}]}, {"xacro": [{"file": "a.xacro", "args": {}}]},
               {"xacro": [{"file": "a.xacro", "arguments": ["a"]}]},
               {"companions": [{"files": ["rainbow.json"]}]}, {"companions": [{"robot": "a.xacro", "file": "rainbow.json"}]},
               {"companions": 1}, {"companions": [{"robot": "a.xacro", "files": {"a": 1}}]},
               {"select": "unknown-jiont"}, {"severity": {"SML50012": "info"}}, {"targets": "mujuco"},
               {"tolerances": {"SML3101": 1}}, {"tolerances": {"SML5004": -1}}, {"tolerances": {"SML5004": "x"}},
               {"paths": {"*.urdf": {"select": "SML1"}}}, {"paths": ["a"]}, {"extends": {}},
               {"exclude": {"a": 1}}, {"force-exclude": "maybe"}, {"packages": ["a"]}, {"format": {}},
               {"fail-on": "fatal"}, {"max-warnings": -1}, {"max-warnings": 1.5}, {"baseline": []}]
        self.write("rainbow.json", "{}")
        self.write("a.xacro", "<robot/>")
        for verdict, configs in ((True, good), (False, bad)):
            for config in configs:
                with self.subTest(config=config):
                    self.assertEqual(validator.is_valid(config), verdict)
                    self.write("c.yaml", json.dumps(config))
                    ids = [f[1] for f in self.findings("--config", "c.yaml", "robots")]
                    self.assertEqual([i for i in ids if i.startswith("SML9")] == [], verdict, ids)


class Show(ConfigTest):
    def show(self, *arguments, code=0, **keywords):
        done = self.run_tool("--show-config", *arguments, **keywords)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def test_origins(self):
        self.write("base.yaml", "select: [SML3, SML5]\nignore: SML19\nseverity: {SML3: info, SML5: info}\n")
        self.write("robots/.smurf-lint.yaml", "extends: ../base.yaml\nseverity: {SML5: error}\nignore:\n- SML5013\n"
                                              "packages: {a: ../b}\npaths:\n  old/: {ignore: [SML5]}\n"
                                              "tolerances: {axis-not-unit: 0.1}\nmax-warnings: 3\n")
        shown = self.show("robots/scene.smurfs", "--ignore", "SML51", "--severity", "SML3=warning", "--fail-on", "never",
                          "--target", "ros").stdout
        self.assertEqual(shown, """# for robots/scene.smurfs: robots/.smurf-lint.yaml
select:
- SML3                        # base.yaml:1
- SML5                        # base.yaml:1
ignore:
- SML51                       # --ignore
- SML19                       # base.yaml:2
- SML5013                     # robots/.smurf-lint.yaml:4
severity:
  SML3: warning               # --severity
  SML5: error                 # robots/.smurf-lint.yaml:2
tolerances:
  SML1422: 0.1                # robots/.smurf-lint.yaml:8
targets:
- ros                         # --target
paths:
  old/:                       # robots/.smurf-lint.yaml:7
    ignore:
    - SML5                    # robots/.smurf-lint.yaml:7
exclude: []                   # default
force-exclude: false          # default
packages:
  a: b                        # robots/.smurf-lint.yaml:5
schemas: {}                   # default
xacro: []                     # default
companions: []                # default
format: auto                  # default
fail-on: never                # --fail-on
max-warnings: 3               # robots/.smurf-lint.yaml:9
baseline: null                # default
""")

    def test_what_is_shown_can_be_read(self):
        self.write(".smurf-lint.yaml", "select: SML5\nexclude: ['*.old', '!a']\nschemas: {entities: {rainbow: r.json}}\n"
                                       "xacro: [{file: a.xacro, arguments: {side: [left, right], n: '1 2'}}]\n"
                                       "format: [full, json=a b.json]\nbaseline: known.yaml\n")
        self.write("r.json", RAINBOW)
        self.write("a.xacro", "<robot/>")
        first = self.show("robots", "--config", ".smurf-lint.yaml").stdout
        self.write("shown.yaml", first)
        again = self.show("robots", "--config", "shown.yaml").stdout

        def values(text):
            return [line.split("  #")[0] for line in text.splitlines()[1:]]

        self.assertEqual(values(first), values(again))
        self.assertIn("exclude:\n- \"*.old\"", first)

    def test_without_configuration(self):
        shown = self.show("robots").stdout
        self.assertTrue(shown.startswith("# for robots: no configuration\nselect: []  "), shown)
        self.assertEqual(set(line.split("# ")[1].split(":")[0] for line in shown.splitlines()[1:]), {"default"})

    def test_mistakes(self):
        self.expect_complaint("there is no 'robts'", "--show-config", "robts")
        self.write("robots/.smurf-lint.yaml", "selct: SML5\n")
        self.assertEqual(self.show("robots", code=1).stderr,
                         "robots/.smurf-lint.yaml:1:1: error[SML9001] there is no setting `selct` "
                         "(did you mean `select`?)\n")


if __name__ == "__main__":
    cli.main()
