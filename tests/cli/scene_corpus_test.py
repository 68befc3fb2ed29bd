# SPDX-License-Identifier: BSD-3-Clause
"""Every scene of the corpus is flattened, or the report gives the reason at its place. Models of the
corpus, as scenes of one model, are written in every format, and losses are reported.

Usage: scene_corpus_test.py CASES CORPUS; the exit code is 77, which CTest shows as skipped, if there
is no corpus.
"""
import json
import pathlib
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import cases  # noqa: E402
import formats  # noqa: E402

SUFFIXES = {".smurfs", ".smurfa"}
XML_FORMATS = ("svg", "sdf", "sdf1.6", "mjcf", "urdf")


def run(tools, *arguments):
    return tools.run("smurfs-flatten", *arguments)


def judge(tools, scene, report):
    """Faults in the output of the tool; none if there are none."""
    done = run(tools, scene, "--report", f"json={report}", "--links")
    if done.returncode == 0:
        instances = json.loads(done.stdout)["instances"]
        unnormal = [i["path"] for i in instances
                    if abs(sum(c * c for c in i["orientation"].values()) - 1) > 1e-12]
        if unnormal:
            return f"orientations are not of unit length: {unnormal}"
        return compare(tools, scene)
    if done.returncode != 1 or done.stdout:
        return f"exit code {done.returncode}: {done.stderr[:300]}"
    errors = [d for d in json.loads(report.read_text())["diagnostics"] if d["severity"] == "error"]
    if not errors:
        return "refused without an error"
    vague = [d["id"] for d in errors if not d["file"] or d["column"] < 1]
    return f"errors without a place: {vague}" if vague else None


def compare(tools, scene):
    """All readers have a result, and the table fits."""
    table = run(tools, scene, "--compare-dialects", "--quiet")
    if table.returncode != 0 or max(map(len, table.stdout.splitlines())) > 80:
        return f"--compare-dialects: exit code {table.returncode}\n{table.stdout}"
    return None


def write_all(tools, model, report):
    """Faults of a model in any of the formats. Ignores faults of the model itself."""
    for form in formats.listed(run(tools, "--format", "help").stdout):
        done = run(tools, model, "--format", form, "--force", "--allow-outside", "--report",
                   f"json={report}")
        found = json.loads(report.read_text())["diagnostics"]
        if done.returncode != 0:
            # A scene is refused only if something in it cannot be understood.
            if done.returncode == 1 and not done.stdout and any(
                    d["severity"] == "error" for d in found):
                return None
            return f"{form}: exit code {done.returncode}: {done.stderr[:300]}"
        if form in XML_FORMATS:
            ElementTree.fromstring(done.stdout)
        elif form == "gltf":
            json.loads(done.stdout)
        unnamed = [d["message"] for d in found
                   if d["id"].startswith("SML82") and (not d["file"] or "`" not in d["message"])]
        if unnamed:
            return f"{form}: losses without a name or place: {unnamed}"
    return None


def main():
    program, corpus = sys.argv[1], pathlib.Path(sys.argv[2])
    scenes = sorted(p for p in corpus.rglob("*") if p.suffix in SUFFIXES) if corpus.is_dir() else []
    if not scenes:
        print(f"skipped: there are no scenes in {corpus}")
        return 77
    with tempfile.TemporaryDirectory() as folder, cases.Cases(program) as tools:
        report = pathlib.Path(folder) / "report.json"
        failures = [(scene, reason) for scene in scenes if (reason := judge(tools, scene, report))]
        models = [*sorted(corpus.rglob("*.smurf")), *sorted(corpus.rglob("*.urdf"))[::40]]
        failures += [(m, reason) for m in models if (reason := write_all(tools, m, report))]
    for scene, reason in failures:
        print(f"{scene}: {reason}")
    print(f"{len(scenes)} scenes, {len(models)} models, {len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
