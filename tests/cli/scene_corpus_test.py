# SPDX-License-Identifier: BSD-3-Clause
"""Every scene of the corpus flattens, or the report says at the token why not.

Called as scene_corpus_test.py TOOL CORPUS; ends with 77, which CTest shows as skipped, when there is
no corpus.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

SUFFIXES = {".smurfs", ".smurfa"}


def run(tool, *arguments):
    return subprocess.run([tool, *map(str, arguments)], capture_output=True, encoding="utf-8",
                          errors="replace", timeout=120, check=False)


def judge(tool, scene, report):
    """What is wrong with the tool's answer; none when nothing is."""
    done = run(tool, scene, "--report", f"json={report}", "--links")
    if done.returncode == 0:
        instances = json.loads(done.stdout)["instances"]
        unnormal = [i["path"] for i in instances
                    if abs(sum(c * c for c in i["orientation"].values()) - 1) > 1e-12]
        if unnormal:
            return f"orientations are not of unit length: {unnormal}"
        return compare(tool, scene)
    if done.returncode != 1 or done.stdout:
        return f"exit code {done.returncode}: {done.stderr[:300]}"
    errors = [d for d in json.loads(report.read_text())["diagnostics"] if d["severity"] == "error"]
    if not errors:
        return "refused without an error"
    vague = [d["id"] for d in errors if not d["file"] or d["column"] < 1]
    return f"errors without a place: {vague}" if vague else None


def compare(tool, scene):
    """All readers have an answer, and a table that fits."""
    table = run(tool, scene, "--compare-dialects", "--quiet")
    if table.returncode != 0 or max(map(len, table.stdout.splitlines())) > 80:
        return f"--compare-dialects: exit code {table.returncode}\n{table.stdout}"
    return None


def main():
    tool, corpus = sys.argv[1], pathlib.Path(sys.argv[2])
    scenes = sorted(p for p in corpus.rglob("*") if p.suffix in SUFFIXES) if corpus.is_dir() else []
    if not scenes:
        print(f"skipped: there are no scenes in {corpus}")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder) / "report.json"
        failures = [(scene, reason) for scene in scenes if (reason := judge(tool, scene, report))]
    for scene, reason in failures:
        print(f"{scene}: {reason}")
    print(f"{len(scenes)} scenes, {len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
