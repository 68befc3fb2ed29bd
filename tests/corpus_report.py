# SPDX-License-Identifier: BSD-3-Clause
"""What the linter finds in a folder of models from public repositories: the table of docs/corpus.md.

usage: corpus_report.py CASES CORPUS PAGE    with SMURF_UPDATE_SNAPSHOTS=1: writes the counts into the page

Without, it fails when a rule fires that nobody has read samples of: a row of the table without a conclusion.
"""
import collections
import json
import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "support"))
import cases  # noqa: E402

SUFFIXES = {".smurf", ".smurfs", ".smurfa", ".urdf"}
SKIPPED = 77
BEGIN = "| rule | severity | findings | files | conclusion |\n|---|---|---:|---:|---|\n"
SEVERITIES = ("error", "warning", "info")


def findings(tools, path):
    result = tools.run("smurf-lint", "--format", "json", path)
    if result.returncode not in (0, 1):
        sys.exit(f"smurf-lint ended with {result.returncode} on {path}:\n{result.stderr}")
    return json.loads(result.stdout)["diagnostics"]


def count(program, corpus):
    """By rule: its severities, its findings and the files they are in. What is seen from several entries counts once."""
    paths = sorted(path for path in corpus.rglob("*") if path.suffix in SUFFIXES)
    with cases.Cases(program) as tools:
        found = [one for path in paths for one in findings(tools, path)]
    places = {(d["id"], d["severity"], d["file"], d["line"], d["column"], d["message"]) for d in found}
    rules = collections.defaultdict(lambda: (collections.Counter(), set()))
    for rule, severity, file, *_ in places:
        rules[rule][0][severity] += 1
        rules[rule][1].add(file)
    return len(paths), dict(sorted(rules.items()))


def conclusions(table):
    """By rule: the last cell of its row."""
    rows = (line.strip("|").split("|") for line in table.splitlines())
    return {cells[0].strip(): cells[-1].strip() for cells in rows if len(cells) == 5}


def main(program, corpus, page):
    corpus, page = pathlib.Path(corpus), pathlib.Path(page)
    if not corpus.is_dir():
        print("skipped: there is no folder of shared test data beside the project")
        return SKIPPED
    text = page.read_text(encoding="utf-8")
    before, table = text.split(BEGIN)
    table, after = (table + "\n").split("\n\n", 1)
    known = conclusions(table)
    files, rules = count(program, corpus)
    rows = []
    for rule, (severities, where) in rules.items():
        words = ", ".join(word for word in SEVERITIES if severities[word])
        rows.append(f"| {rule} | {words} | {sum(severities.values())} | {len(where)} | {known.get(rule, '')} |")
    print(f"{files} files, {len(rules)} rules")
    if os.environ.get("SMURF_UPDATE_SNAPSHOTS") == "1":
        page.write_text(before + BEGIN + "\n".join(rows) + "\n\n" + after.rstrip("\n") + "\n", encoding="utf-8")
    unread = [rule for rule in rules if not known.get(rule)]
    if unread:
        print("nobody has read samples of:", *unread)
    return 1 if unread else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
