# SPDX-License-Identifier: BSD-3-Clause
"""Real models and scenes that nobody here wrote: a verdict for each, in time, and always the same.

usage: corpus_test.py SMURF-LOAD-CHECK CORPUS; exits with 77 (skipped) without that folder.
"""
import collections
import json
import pathlib
import subprocess
import sys
import time

SUFFIXES = (".smurf", ".smurfs", ".smurfa", ".urdf")


def check(tool, path):
    begin = time.monotonic()
    done = subprocess.run([tool, "--format", "json", path.name], cwd=path.parent,
                          capture_output=True, timeout=120, check=False)
    return done, time.monotonic() - begin


def main(tool, folder):
    corpus = pathlib.Path(folder)
    if not corpus.is_dir():
        print(f"skipped: there is no corpus in {corpus}")
        return 77
    failures, slowest, unsure = [], 0.0, []
    verdicts, rules = collections.Counter(), collections.Counter()
    for path in sorted(p for p in corpus.rglob("*") if p.suffix in SUFFIXES):
        done, seconds = check(tool, path)
        slowest = max(slowest, seconds)
        try:
            report = json.loads(done.stdout)
        except ValueError:
            report = None
        if done.returncode not in (0, 1) or report is None:
            failures.append(f"{path}: exit {done.returncode}, {seconds:.1f} s, {done.stderr[:200]}")
            continue
        if check(tool, path)[0].stdout != done.stdout:
            failures.append(f"{path}: two runs differ")
        found = {d["id"] for d in report["diagnostics"]}
        rules.update(found)
        if found & {"SML6001", "SML6002"}:
            unsure.append(f"{path.relative_to(corpus)}: {sorted(found)}")
        verdicts.update(c["verdict"] if c["stages"] else "not run" for c in report["checks"])
    print(f"verdicts {dict(verdicts)}, slowest {slowest:.1f} s")
    print("files by rule:", dict(sorted(rules.items())))
    for line in unsure:
        print("no figures:", line)
    print("\n".join(failures))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
