# SPDX-License-Identifier: BSD-3-Clause
"""The pages from which scripts/site makes the web site; MkDocs itself, which checks their links, is not run here."""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
LINT = sys.argv.pop(1)
BUILD = sys.argv.pop(1)


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = tempfile.TemporaryDirectory(dir=BUILD)
        cls.addClassCleanup(cls.work.cleanup)
        subprocess.run([sys.executable, ROOT / "web/site/pages.py", cls.work.name], check=True)
        cls.pages = pathlib.Path(cls.work.name, "pages")

    def test_every_rule_has_the_page_to_which_messages_lead(self):
        listed = subprocess.run([LINT, "--list-rules"], capture_output=True, text=True, check=True)
        rules = re.findall(r"^(SML\d{4}) ", listed.stdout, re.M)
        self.assertGreater(len(rules), 390)
        for rule in rules:
            page = (self.pages / f"rules/{rule}.md").read_text(encoding="utf-8")
            self.assertRegex(page, rf"\n# {rule} [a-z0-9-]+\n\n\S")

    def test_the_navigation_names_pages(self):
        text = (ROOT / "web/site/mkdocs.yml").read_text(encoding="utf-8")
        named = re.findall(r"^ *- .*: (\S+\.md)$", text, re.M)
        self.assertGreater(len(named), 20)
        self.assertEqual([name for name in named if not (self.pages / name).is_file()], [])
        in_docs = {path.relative_to(ROOT / "docs").as_posix() for path in (ROOT / "docs").rglob("*.md")}
        families = {name for name in in_docs if name.startswith("rules/")}
        self.assertEqual(in_docs - families - set(named), set(), "pages that nobody finds")

    def test_relative_links_lead_to_pages(self):
        for page in self.pages.rglob("*.md"):
            text = re.sub(r"^```.*?^```$", "", page.read_text(encoding="utf-8"), flags=re.M | re.S)
            for link in re.findall(r"\]\(([^)\s]+)\)", text):
                if re.match(r"[a-z]+:|#", link) or link.startswith("robots/"):
                    continue
                self.assertTrue((page.parent / link.partition("#")[0]).exists(), f"{page.name}: {link}")


if __name__ == "__main__":
    unittest.main()
