# SPDX-License-Identifier: BSD-3-Clause
"""The configuration of smurf-lint: which file is read, what it says, and its schema."""
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import cli  # noqa: E402

SCHEMAS = cli.FIXTURES.parent / "schemas"
SCENE = "entities:\n- {file: box.urdf}\n- {name: bow, type: rainbow, radius: wide}\n"
URDF = '<?xml version="1.0"?>\n<robot name="box"><link name="box"/></robot>\n'
RAINBOW = '{"properties": {"radius": {"type": "number", "description": "In metres."}}}\n'


class ConfigTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.write("robots/scene.smurfs", SCENE)
        self.write("robots/box.urdf", URDF)

    def findings(self, *arguments, code=None, **keywords):
        """(file, id, severity) of what the JSON report lists."""
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

    def test_named_and_isolated(self):
        self.write(".smurf-lint.yaml", "ignore: SML5012\n")
        self.write("other.yaml", "severity: {SML5: info}\n")
        self.assertEqual(self.findings("--config", "other.yaml", "robots"),
                         [(*self.UNNAMED[:2], "info")])
        self.assertEqual(self.findings("--isolated", "robots"), [self.UNNAMED])
        self.expect_complaint("--isolated reads no configuration, --config names one",
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


class Content(ConfigTest):
    def test_schemas_are_relative_to_the_configuration(self):
        self.write(".smurf-lint.yaml", "schemas: {entities: {rainbow: schemas/rainbow.json}}\n")
        self.write("schemas/rainbow.json", RAINBOW)
        done = self.expect(1, "--select", "SML54", "scene.smurfs", cwd=self.folder / "robots")
        self.assertIn("error[SML5401]: `radius` takes a number, not the text `wide`\n"
                      " --> scene.smurfs:3:38\n", done.stdout)
        self.assertIn("note: the schema asks for it here\n --> ../schemas/rainbow.json:1:28\n",
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
                {"targets": ["mars"]}, {}, None]
        bad = [{"ingore": []}, {"select": {}}, {"severity": {"SML5012": "fatal"}},
               {"schemas": {"entites": {}}}, {"schemas": {"sections": {"a": []}}}, {"targets": {}}, []]
        self.write("rainbow.json", "{}")
        for verdict, configs in ((True, good), (False, bad)):
            for config in configs:
                with self.subTest(config=config):
                    self.assertEqual(validator.is_valid(config), verdict)
                    self.write("c.yaml", json.dumps(config))
                    ids = [f[1] for f in self.findings("--config", "c.yaml", "robots")]
                    self.assertEqual([i for i in ids if i.startswith("SML9")] == [], verdict, ids)


if __name__ == "__main__":
    cli.main()
