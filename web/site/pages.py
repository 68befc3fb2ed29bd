# SPDX-License-Identifier: BSD-3-Clause
"""Lays out the Markdown of the repository as the pages of the web site. usage: pages.py OUTPUT

`docs/` becomes the root, README.md a page, and every rule a page. The first page is pages/index.md, which lists tasks. A link to a file that is no page leads to the
repository. Writes OUTPUT/pages, which MkDocs reads.
"""
import pathlib
import posixpath
import re
import shutil
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))
from backend import project  # noqa: E402

BESIDE_DOCS = ("README.md", "CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md")
FOLDERS = ("schemas",)  # what pages link to, as it is
LINK = re.compile(r"(\]\(|<a href=\"|<img src=\")([^)\"\s]+)")
RULE = re.compile(r"^### (SML\d{4}) ([a-z0-9-]+)$", re.M)
MADE = re.compile(r" ?(Made|They are made|This page is made) from [^\n]*?; do not edit\.")  # for who edits, not for who reads
FAMILY = re.compile(r"docs/rules/sml\d+\.md")


def main(output):
    pages = output / "pages"
    shutil.rmtree(pages, ignore_errors=True)
    pages.mkdir(parents=True)
    for name in FOLDERS:
        shutil.copytree(ROOT / name, pages / name)
    for source in sorted((ROOT / "docs").rglob("*")):
        if source.is_file() and source.suffix in (".md", ".png", ".gif"):
            add(pages, source.relative_to(ROOT).as_posix())
    for name in BESIDE_DOCS:
        add(pages, name)
    (pages / "licence.md").write_text(f"# Licence\n\n```text\n{(ROOT / 'LICENSE').read_text(encoding='utf-8')}```\n", encoding="utf-8")
    for source in (pathlib.Path(__file__).parent / "pages").iterdir():
        shutil.copy(source, pages / source.name)
    shutil.copy(ROOT / "web/playground/icon.svg", pages / "icon.svg")


def add(pages, name):
    """Writes the page of a file of the repository, or copies it."""
    source = ROOT / name
    target = pages / page_of(name)
    target.parent.mkdir(parents=True, exist_ok=True)
    if source.suffix != ".md":
        shutil.copy(source, target)
        return
    text = MADE.sub("", with_links(source.read_text(encoding="utf-8"), name))
    if FAMILY.fullmatch(name):
        text = split_rules(pages, text)
    target.write_text(text, encoding="utf-8")


def split_rules(pages, text):
    """Writes a page for each rule of a family; returns the page of the family, which lists them."""
    starts = [*RULE.finditer(text)]
    ends = [*(match.start() for match in starts[1:]), len(text)]
    items = []
    for match, end in zip(starts, ends):
        rule, name = match.groups()
        body = text[match.end() : end].strip()
        summary = body.split("\n", 1)[0]
        page = f"---\ntitle: {rule} {name}\ndescription: {yaml_text(summary)}\n---\n# {rule} {name}\n\n{body}\n"
        (pages / f"rules/{rule}.md").write_text(page, encoding="utf-8")
        items.append(f"- [{rule} {name}]({rule}.md): {summary}\n")
    head = text[: starts[0].start()] if starts else text
    return head + "".join(items)


def yaml_text(text):
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def with_links(text, name):
    """The links of the file `name` as those of its page; code stays."""
    parts = re.split(r"(^```.*?^```$)", text, flags=re.M | re.S)
    return "".join(part if part.startswith("```") else LINK.sub(lambda match: match[1] + link_of(match[2], name), part) for part in parts)


def link_of(link, name):
    if re.match(r"[a-z]+:|#", link):
        return link
    path, _, anchor = link.partition("#")
    target = posixpath.normpath(posixpath.join(posixpath.dirname(name), path))
    here = posixpath.dirname(page_of(name))
    rule = re.fullmatch(r"(sml\d{4})-.*", anchor)
    if FAMILY.fullmatch(target) and rule:
        return posixpath.relpath(f"rules/{rule[1].upper()}.md", here or ".")
    if not is_page(target):
        return f"{project.homepage()}/blob/v{project.version()}/{target}"
    return posixpath.relpath(page_of(target), here or ".") + ("#" + anchor if anchor else "")


def is_page(name):
    return name in BESIDE_DOCS or name.split("/")[0] in ("docs", *FOLDERS)


def page_of(name):
    if name == "README.md":
        return "about.md"
    return name.removeprefix("docs/")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve())
