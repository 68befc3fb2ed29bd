# SPDX-License-Identifier: BSD-3-Clause
"""Pages that tools write, opened in Chromium by pages.mjs.

A test program is called with the tool and the scratch build folder: NAME_test.py TOOL BUILD.
It ends with 77, which CTest shows as skipped, when Chromium or a package is absent.
"""
import functools
import json
import pathlib
import shutil
import socket
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "readers"))
import reader  # noqa: E402
from reader import cli, main  # noqa: E402, F401

PAGES = pathlib.Path(__file__).resolve().parent / "pages.mjs"


@functools.cache
def running_browser():
    """One for all tests of a program: its start takes seconds. It ends with the program, whose end is its end of input."""
    return subprocess.Popen(["node", PAGES, reader.NODE_MODULES, shutil.which("chromium")], stdin=subprocess.PIPE,
                            stdout=subprocess.PIPE, encoding="utf-8")


class BrowserTest(reader.ReaderTest):
    @classmethod
    def setUpClass(cls):
        for what, is_there in (("chromium", shutil.which("chromium")), ("node", shutil.which("node")),
                               ("the npm package puppeteer-core", (reader.NODE_MODULES / "puppeteer-core").is_dir()),
                               ("the npm package axe-core", (reader.NODE_MODULES / "axe-core").is_dir())):
            if not is_there:
                cls.skipTest(cls, f"{what} is not installed")

    def browse(self, *jobs):
        """The results of the steps of the jobs. The pages must log nothing and request nothing."""
        jobs = [{**job, "page": str(job["page"])} for job in jobs]
        browser = running_browser()
        browser.stdin.write(json.dumps(jobs) + "\n")
        browser.stdin.flush()
        line = browser.stdout.readline()
        self.assertTrue(line, "the browser failed; its messages are above")
        answers = json.loads(line)
        for job, answer in zip(jobs, answers):
            if not job.get("is_hostile"):
                self.assertEqual((answer["addresses"], answer["errors"]), ([], []), job["page"])
        return answers

    def data_in(self, page, name):
        """The data in the page, and the bytes of the page around them."""
        text = page.read_text()
        block = f'<script id="{name}" type="application/json">'
        self.assertEqual(text.count(block), 1)
        head, rest = text.split(block)
        data, tail = rest.split("</script>", 1)
        return json.loads(data), len(head) + len(tail)

    def check_nothing_else_runs(self, page):
        """Markup in names neither runs in the page nor requests anything."""
        server = socket.create_server(("127.0.0.1", 0))
        server.settimeout(1)
        self.addCleanup(server.close)
        attempts = """(async () => {
          const script = document.createElement("script");
          script.textContent = "window.hacked = 1";
          document.body.append(script);
          const image = document.createElement("img");
          image.setAttribute("onerror", "window.hacked = 2");
          image.src = "http://127.0.0.1:9/x.png";
          document.body.append(image);
          let evaluated;
          try { evaluated = await new Promise((done, failed) => setTimeout(() => {
            try { done(window["ev" + "al"]("1 + 1")); } catch (error) { failed(error); } })); } catch (error) { evaluated = error.name; }
          const fetched = await fetch("http://127.0.0.1:9/").then(() => "yes", (error) => error.name);
          return [window.hacked, evaluated, fetched];
        })()""".replace("127.0.0.1:9", "{}:{}".format(*server.getsockname()))
        answer = self.browse({"page": page, "steps": [attempts], "is_hostile": True})[0]
        self.assertEqual(answer["results"][0], [None, "EvalError", "TypeError"])
        with self.assertRaises(TimeoutError):
            server.accept()
        self.assertTrue(all("Content Security Policy" in error for error in answer["errors"]), answer["errors"])
