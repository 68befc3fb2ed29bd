# SPDX-License-Identifier: BSD-3-Clause
"""smurf-view: which page is written and opened, and what its server answers to whom.

Usage: smurf_view_test.py TOOL
"""
import http.client
import json
import os
import pathlib
import re
import signal
import socket
import stat
import subprocess
import time
import urllib.request

import cli

OPENER = """#!/bin/sh
echo "$# $1" >> "$OPENED"
exit $OPENER_ENDS
"""
BROKEN = cli.ARM_URDF.replace("</robot>", "<link name=")


class ViewTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.running = None
        self.write("bin/xdg-open", OPENER)
        (self.folder / "bin/xdg-open").chmod(0o755)
        (self.folder / "tmp").mkdir()
        self.variables = {**os.environ, "PATH": f"{self.folder}/bin:/usr/bin:/bin", "OPENED": str(self.folder / "opened"),
                          "OPENER_ENDS": "0", "TMPDIR": str(self.folder / "tmp")}
        self.write("arm.urdf", cli.ARM_URDF)
        done = self.view("arm.urdf", "--no-open")
        if done.returncode == 2 and "this build has no viewer" in done.stderr:
            self.skipTest("this build has no viewer")

    def tearDown(self):
        if self.running:
            self.running.kill()
            self.running.communicate()
        super().tearDown()

    def view(self, *arguments, **variables):
        return subprocess.run([cli.TOOL, *arguments], cwd=self.folder, env={**self.variables, **variables},
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8", check=False)

    def opened(self):
        path = self.folder / "opened"
        return path.read_text().splitlines() if path.exists() else []

    def test_the_page_is_opened(self):
        done = self.view("arm.urdf")
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)
        [line] = self.opened()
        count, path = line.split(" ", 1)
        self.assertEqual(count, "1")
        self.assertRegex(path, rf"^{re.escape(str(self.folder))}/tmp/arm-[a-z0-9]{{10}}\.html$")
        self.assertEqual(stat.S_IMODE(os.stat(path).st_mode), 0o600)
        with open(path, encoding="utf-8") as page:
            self.assertIn('<script id="scene"', page.read())
        self.assertIn(f"smurf-view: wrote {path}\n", done.stderr)

    def test_names_are_no_options_and_no_commands(self):
        self.write("a; touch hacked $(touch hacked).urdf", cli.ARM_URDF)
        done = self.view("a; touch hacked $(touch hacked).urdf")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(len(self.opened()), 1)
        self.assertFalse((self.folder / "hacked").exists())

    def test_a_page_of_the_users_choice(self):
        done = self.view("arm.urdf", "-o", "page.html", "--no-open")
        self.assertEqual((done.returncode, done.stdout), (0, "page.html\n"), done.stderr)
        self.assertIn('<script id="scene"', self.read("page.html"))
        self.assertEqual(self.opened(), [])
        done = self.view("arm.urdf", "-o", "page.html")
        self.assertEqual(done.returncode, 0)
        self.assertEqual(self.opened(), [f"1 {self.folder}/page.html"])

    def test_an_input_is_not_replaced(self):
        done = self.view("arm.urdf", "-o", "arm.urdf")
        self.assertEqual(done.returncode, 2)
        self.assertEqual(self.read("arm.urdf"), cli.ARM_URDF)

    def test_no_browser(self):
        done = self.view("arm.urdf", OPENER_ENDS="3")
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, r"xdg-open found no browser; open this in a browser: /.*\.html\n")
        done = self.view("arm.urdf", PATH="/nowhere")
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, r"there is no xdg-open here, which starts the browser; open this in a browser: /.*\.html\n")

    def test_a_broken_file_is_not_shown(self):
        self.write("broken.urdf", BROKEN)
        done = self.view("broken.urdf")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("broken.urdf", done.stderr)
        self.assertIn("nothing was written", done.stderr)
        self.assertEqual(self.opened(), [])
        self.assertEqual(len(list((self.folder / "tmp").iterdir())), 1)  # that of setUp()

    def test_what_is_no_robot(self):
        self.assertEqual(self.view("nosuch.urdf").returncode, 2)
        self.assertEqual(self.view().returncode, 2)
        self.assertEqual(self.view("--watch", "nosuch.urdf").returncode, 2)
        for words in (["--watch", "arm.urdf", "-o", "page.html"], ["--watch", "-"]):
            done = self.view(*words)
            self.assertEqual(done.returncode, 2)
            self.assertIn("--watch", done.stderr)

    def test_other_tools_open_their_pages(self):
        self.write("other.urdf", cli.ARM_URDF.replace('<mass value="1"/>', '<mass value="-1"/>'))
        folder = pathlib.Path(cli.TOOL).parent
        for tool, words, code, block in (("smurf-lint", ["other.urdf"], 1, "report"), ("smurfs-flatten", ["arm.urdf"], 0, "scene"),
                                         ("smurf-diff", ["arm.urdf", "other.urdf"], 1, "report")):
            with self.subTest(tool):
                (self.folder / "opened").unlink(missing_ok=True)
                command = [folder / tool, "--open", *words]
                done = subprocess.run(command, cwd=self.folder, env=self.variables, capture_output=True, text=True, check=False)
                self.assertEqual(done.returncode, code, done.stderr)
                path = self.opened()[0].split(" ", 1)[1]
                self.assertTrue(path.startswith(f"{self.folder}/tmp/"), path)
                with open(path, encoding="utf-8") as page:
                    self.assertIn(f'<script id="{block}"', page.read())
                self.assertEqual("SML1509" in done.stdout, tool == "smurf-lint")
                (self.folder / "opened").unlink()
                option = "html=page.html" if tool == "smurf-lint" else "html"
                named = [] if tool == "smurf-lint" else ["-o", "page.html"]
                subprocess.run([*command, "--format", option, *named], cwd=self.folder, env=self.variables, capture_output=True,
                               check=False)
                self.assertEqual(self.opened(), [f"1 {self.folder}/page.html"])

    def start(self, *arguments):
        with open(self.folder / "err.log", "w", encoding="utf-8") as log:
            self.running = subprocess.Popen([cli.TOOL, "--watch", *arguments], cwd=self.folder, env=self.variables,
                                            stdout=subprocess.PIPE, stderr=log, encoding="utf-8")
        if "--no-open" in arguments:
            self.address = self.running.stdout.readline().strip()
        else:
            for _ in range(600):
                if self.opened():
                    break
                time.sleep(0.05)
            self.address = self.opened()[0].split(" ", 1)[1]
        self.assertRegex(self.address, r"^http://127\.0\.0\.1:[0-9]+/[a-z0-9]{24}/$")

    def get(self, name=""):
        with urllib.request.urlopen(self.address + name, timeout=600) as answer:
            return answer.read().decode(), answer.headers

    def changes(self, after):
        return json.loads(self.get(f"changes?after={after}")[0])

    def test_the_page_follows_the_file(self):
        self.start("arm.urdf")
        page, headers = self.get()
        self.assertIn('name="smurf-view"', page)
        self.assertEqual(headers["X-Content-Type-Options"], "nosniff")
        self.assertIn('<script id="scene"', self.get("page")[0])
        first = self.changes(0)
        self.assertEqual((first["version"], first["problem"]), (1, ""))
        self.assertIn("entities", json.loads(first["scene"]))
        self.write("arm.urdf", cli.ARM_URDF.replace('name="base"', 'name="bottom"').replace('"base"', '"bottom"'))
        second = self.changes(first["version"])  # waits for it
        self.assertIn('"bottom"', second["scene"])
        self.write("arm.urdf", BROKEN)
        third = self.changes(second["version"])
        self.assertEqual(third["scene"], second["scene"])
        self.assertRegex(third["problem"], r"^arm\.urdf, line [0-9]+: ")
        (self.folder / "arm.urdf").unlink()
        fourth = self.changes(third["version"])
        self.assertEqual((fourth["scene"], fourth["problem"]), (second["scene"], "the file cannot be read"))
        self.write("arm.urdf", cli.ARM_URDF)
        fifth = self.changes(fourth["version"])
        self.assertEqual((fifth["scene"], fifth["problem"]), (first["scene"], ""))
        self.running.send_signal(signal.SIGINT)
        self.assertEqual(self.running.wait(timeout=600), 0)
        said = self.read("err.log")
        self.assertIn("arm.urdf has changed\n", said)

    def test_a_broken_file_at_first(self):
        self.write("arm.urdf", BROKEN)
        self.start("arm.urdf", "--no-open")
        state = self.changes(0)
        self.assertEqual(state["scene"], "")
        self.assertRegex(state["problem"], r"^arm\.urdf, line [0-9]+: ")
        self.write("arm.urdf", cli.ARM_URDF)
        self.assertEqual(self.changes(state["version"])["problem"], "")

    def test_strangers_get_nothing(self):
        self.start("arm.urdf", "--no-open")
        port, folder = re.fullmatch(r"http://127\.0\.0\.1:([0-9]+)(/.*)", self.address).groups()
        def status(method, target, host=f"127.0.0.1:{port}", **headers):
            connection = http.client.HTTPConnection("127.0.0.1", int(port), timeout=600)
            connection.putrequest(method, target, skip_host=True)
            if host:
                connection.putheader("Host", host)
            for name, value in headers.items():
                connection.putheader(name, value)
            connection.endheaders()
            answer = connection.getresponse()
            return answer.status, "scene" in answer.read().decode()

        self.assertEqual(status("GET", folder + "page"), (200, True))
        self.assertEqual(status("GET", "/"), (404, False))
        self.assertEqual(status("GET", "/page"), (404, False))
        self.assertEqual(status("GET", folder + "../arm.urdf"), (404, False))
        self.assertEqual(status("GET", folder + "arm.urdf"), (404, False))
        self.assertEqual(status("POST", folder + "page"), (405, False))
        self.assertEqual(status("GET", folder + "page", host="evil.example"), (421, False))
        self.assertEqual(status("GET", folder + "page", host=f"localhost:{port}"), (421, False))
        self.assertEqual(status("GET", folder + "page", host=""), (421, False))
        # Clients that say nothing, too much, or nonsense keep nobody waiting. More than the server takes at once
        # make room for those that ask.
        silent = [socket.create_connection(("127.0.0.1", int(port))) for _ in range(150)]
        noisy = socket.create_connection(("127.0.0.1", int(port)))
        try:
            noisy.sendall(b"x" * 100_000)
        except OSError:
            pass
        odd = socket.create_connection(("127.0.0.1", int(port)))
        odd.sendall(b"\r\n\r\n")
        self.assertTrue(odd.recv(100).startswith(b"HTTP/1.1 400 "))
        self.assertEqual(status("GET", folder + "page"), (200, True))
        for one in [*silent, noisy, odd]:
            one.close()
        self.assertIsNone(self.running.poll())


if __name__ == "__main__":
    cli.main()
