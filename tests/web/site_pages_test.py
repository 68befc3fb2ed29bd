#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The pages of the web site in Chromium: site_pages_test.py SITE, the folder that scripts/site has made.

axe finds nothing on any page, and the filter of tables leaves the rows that it should.
"""
import contextlib
import functools
import http.server
import pathlib
import sys
import threading
import unittest

import browser

SITE = None
SHOWN = """[...document.querySelectorAll("article table tbody tr")].filter((row) => row.offsetParent !== null).length"""
HEADINGS = """[...document.querySelectorAll("article h2")].filter((one) => one.offsetParent !== null).length"""


@contextlib.contextmanager
def served(folder):
    class Quiet(http.server.SimpleHTTPRequestHandler):
        def log_message(self, *_):
            pass

        def copyfile(self, *files):
            with contextlib.suppress(ConnectionError):  # a page that is left reads no more
                super().copyfile(*files)
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=folder)) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}/"
        server.shutdown()


class SitePages(browser.BrowserTest):
    def setUp(self):
        self.root = self.enterContext(served(SITE))

    def page(self, name, steps, **options):
        return self.browse({"page": self.root, "hash": name, "ready": "article", "steps": steps, **options})[0]["results"]

    def names(self):
        folders = [path.parent.relative_to(SITE).as_posix() + "/" for path in sorted(SITE.glob("*/**/index.html"))]
        return [name for name in folders if not name.split("/")[1:2] == ["playground"]]

    def test_axe(self):
        names = self.names()
        self.assertGreater(len(names), 600)
        for number, name in enumerate(names):
            # Pages of rules are alike: each is looked at in one way.
            ways = [(scheme, width) for scheme in ("light", "dark") for width in (1400, 390)]
            for scheme, width in ways[number % 4:][:1] if "/rules/SML" in name else ways:
                with self.subTest(name=name, scheme=scheme, width=width):
                    self.assertEqual(self.page(name, [{"axe": True}], scheme=scheme, width=width), [[]])

    def test_filter(self):
        version, = (path.name for path in SITE.iterdir() if path.is_dir())
        steps = [SHOWN, HEADINGS, "document.querySelector('.table-filter input').focus()", {"type": "mimic"}, SHOWN, HEADINGS,
                 "document.querySelector('.table-filter [role=status]').textContent"]
        before, headings, _, _, after, left, count = self.page(f"{version}/rules/", steps)
        self.assertGreater(before, 500)
        self.assertTrue(1 < after < 40 and 1 <= left < headings, (after, left, headings))
        self.assertEqual(count, f"{after} of {before}")


if __name__ == "__main__":
    SITE = pathlib.Path(sys.argv.pop()).resolve()
    if not SITE.is_dir():
        print("SKIPPED: there is no site; scripts/site makes it")
        sys.exit(77)
    unittest.main()
