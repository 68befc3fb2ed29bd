# SPDX-License-Identifier: BSD-3-Clause
"""The schemas in an editor: completion, hover and squiggles of the YAML language server, as docs/integrations.md sets it up.

usage: editor_test.py [unittest option]...; skips without yaml-language-server (scripts/setup --readers).
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import threading
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SERVER = ROOT / "build/readers/node_modules/yaml-language-server/bin/yaml-language-server"
SCHEMAS = ROOT / "schemas"
PATIENCE = 120  # seconds for all answers in a test, on a busy machine


class Server:
    """A client of the language server that behaves like an editor."""

    def __init__(self, folder):
        self.process = subprocess.Popen(["node", SERVER, "--stdio"], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=subprocess.DEVNULL, cwd=folder)
        self.patience = threading.Timer(PATIENCE, self.process.kill)
        self.patience.start()
        self.count = 0
        self.settings = {}

    def close(self):
        self.patience.cancel()
        self.process.kill()
        self.process.wait()
        self.process.stdin.close()
        self.process.stdout.close()

    def send(self, **message):
        body = json.dumps({"jsonrpc": "2.0", **message}).encode()
        self.process.stdin.write(b"Content-Length: %d\r\n\r\n" % len(body) + body)
        self.process.stdin.flush()

    def receive(self):
        size = 0
        while line := self.process.stdout.readline().strip():
            name, _, value = line.decode().partition(":")
            if name.lower() == "content-length":
                size = int(value)
        return json.loads(self.process.stdout.read(size)) if size else None

    def wait(self, is_wanted):
        """The first message that is accepted; requests of the server are answered before it."""
        while message := self.receive():
            if is_wanted(message):
                return message
            self.answer(message)
        raise AssertionError("the language server ended or did not answer")

    def answer(self, message):
        if message.get("method") == "workspace/configuration":
            items = message["params"]["items"]
            self.send(id=message["id"], result=[self.settings.get(i.get("section")) for i in items])
        elif "id" in message and "method" in message:
            self.send(id=message["id"], result=None)

    def ask(self, method, **params):
        self.count += 1
        number = self.count
        self.send(id=number, method=method, params=params)
        answer = self.wait(lambda message: message.get("id") == number and "method" not in message)
        if "error" in answer:
            raise AssertionError(answer["error"])
        return answer["result"]

    def tell(self, method, **params):
        self.send(method=method, params=params)

    def start(self, settings):
        self.settings = {"yaml": settings}
        self.ask("initialize", processId=None, rootUri=None, initializationOptions={}, capabilities={
            "workspace": {"configuration": True, "didChangeConfiguration": {"dynamicRegistration": True}},
            "textDocument": {"completion": {"completionItem": {"documentationFormat": ["plaintext"]}},
                             "hover": {"contentFormat": ["plaintext"]}}})
        self.tell("initialized")
        self.tell("workspace/didChangeConfiguration", settings=self.settings)
        # If a text is opened before the server has requested its settings, it is checked without them.
        self.answer(self.wait(lambda message: message.get("method") == "workspace/configuration"))

    def open(self, uri, text):
        """The diagnostics in the text."""
        self.tell("textDocument/didOpen", textDocument={"uri": uri, "languageId": "yaml", "version": 1, "text": text})
        shown = self.wait(lambda message: message.get("method") == "textDocument/publishDiagnostics"
                          and message["params"]["uri"] == uri)
        return shown["params"]["diagnostics"]


MODELINE = "# yaml-language-server: $schema="
MOTORS = """motors:
- name: elbow
  joint: elbow
  type: PID
  maxEffort: 1
- name: wrist
  jont: wrist
  maxSpeed: high
"""


class EditorTest(unittest.TestCase):
    def setUp(self):
        if shutil.which("node") is None or not SERVER.exists():
            self.skipTest("yaml-language-server is not installed (scripts/setup --readers)")
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="smurf-editor-"))
        self.addCleanup(shutil.rmtree, self.folder)
        self.server = Server(self.folder)
        self.addCleanup(self.server.close)

    def start(self, schemas=None):
        self.server.start({"validate": True, "hover": True, "completion": True,
                           "schemaStore": {"enable": False}, "schemas": schemas or {}})

    def open(self, name, text):
        """(line, column, message) of each diagnostic; lines and columns from 1."""
        self.uri = (self.folder / name).as_uri()
        marks = self.server.open(self.uri, text)
        return sorted((m["range"]["start"]["line"] + 1, m["range"]["start"]["character"] + 1, m["message"])
                      for m in marks)

    def at(self, line, column):
        return {"textDocument": {"uri": self.uri}, "position": {"line": line - 1, "character": column - 1}}

    def words(self, line, column):
        return [item["label"] for item in self.server.ask("textDocument/completion", **self.at(line, column))["items"]]

    def hover(self, line, column):
        return self.server.ask("textDocument/hover", **self.at(line, column))["contents"]["value"]

    def test_annotations_with_a_modeline(self):
        self.start()
        marks = self.open("arm_motors.yml", f"{MODELINE}{SCHEMAS.as_uri()}/annotations.schema.json\n{MOTORS}")
        self.assertEqual(marks, [(7, 3, 'Missing property "joint".'),
                                 (9, 13, "Incorrect type. Expected one of number, null.")])
        self.assertIn("Largest torque or force", self.hover(6, 5))
        self.assertIn("maxEffort", self.words(9, 3))

    def test_model_by_its_name(self):
        self.start({f"{SCHEMAS.as_uri()}/smurf.schema.json": ["*.smurf"]})
        marks = self.open("arm.smurf", "modelname: arm\nfiles: {urdf: arm.urdf}\n")
        self.assertEqual([mark[:2] for mark in marks], [(2, 8)])
        self.assertIn("Name of the model", self.hover(1, 3))
        self.assertIn("motors", self.words(3, 1))

    def test_scene_by_its_name(self):
        self.start({f"{SCHEMAS.as_uri()}/smurfs.schema.json": ["*.smurfs", "*.smurfa"]})
        self.assertEqual(self.open("cell.smurfs", "entities:\n- name: a\n  file: a.smurf\n  position: here\n"),
                         [(4, 13, "Incorrect type. Expected one of array, object, null.")])
        self.assertIn("parent", self.words(4, 3))

    def test_configuration(self):
        self.start({f"{SCHEMAS.as_uri()}/config.schema.json": [".smurf-lint.yaml"]})
        marks = self.open(".smurf-lint.yaml", "ingore: [SML3101]\nselect: [unknown-jiont]\ntargets: ros\nfail-on: \n")
        self.assertEqual(marks[0], (1, 1, "Property ingore is not allowed."))
        self.assertEqual(marks[1][:2], (2, 10))
        self.assertEqual(len(marks), 2)
        self.assertIn("readers that the files are meant for", self.hover(3, 3))
        self.assertIn("mujoco", self.words(3, 10))
        self.assertIn("unknown-joint", self.words(2, 10))
        self.assertEqual(set(self.words(4, 10)) - {"null"}, {"error", "warning", "info", "never"})

    def test_parameter_files_of_robots(self):
        self.start({f"{SCHEMAS.as_uri()}/ros2-controllers.schema.json": ["controllers.yaml"],
                    f"{SCHEMAS.as_uri()}/moveit-joint-limits.schema.json": ["joint_limits.yaml"]})
        marks = self.open("controllers.yaml", "controller_manager:\n  ros__parameters:\n    update_rate: 0\n"
                                              "    arm: {type: joint_trajectory_controller/JointTrajectoryController}\n"
                                              "arm:\n  ros__parameters:\n    joints: [a]\n    open_loop_control: maybe\n")
        self.assertEqual([mark[0] for mark in marks], [3, 8], marks)
        self.assertIn("in Hz", self.hover(3, 6))
        self.assertIn("constraints", self.words(8, 5))
        marks = self.open("joint_limits.yaml", "joint_limits:\n  a:\n    has_velocity_limits: 1\n    max_velocity: fast\n")
        self.assertEqual([mark[0] for mark in marks], [3, 4], marks)
        self.assertIn("max_acceleration", self.words(4, 5))


if __name__ == "__main__":
    result = unittest.main(exit=False).result
    sys.exit(0 if result.wasSuccessful() and not result.skipped else 77 if result.wasSuccessful() else 1)
