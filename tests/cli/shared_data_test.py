# SPDX-License-Identifier: BSD-3-Clause
"""Real models, scenes and URDFs of other authors, and one-defect URDFs with a scorer.

usage: shared_data_test.py SMURF-LINT SHARED-FOLDER; exits with 77 (skipped) without that folder.
"""
import json
import pathlib
import re
import resource
import subprocess
import sys
import tempfile

SLOWEST = 10.0  # seconds of processor time for one file: ten times what the slowest takes
MUTANTS_EXPECTED = 40  # of 41: a fixed joint called like its link is a hint, because sdformat merges both away


def processor_time():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def lint(tool, path):
    begin = processor_time()
    done = subprocess.run([tool, "--format", "json", path.name], cwd=path.parent,
                          capture_output=True, text=True, check=False)
    return done, processor_time() - begin


def is_refused(done):
    """YAML of other programs, which is a mistake of the command line."""
    return done.returncode == 2 and "it has no section of SMURF" in done.stderr


def check_corpus(tool, corpus):
    """Every file gets a result: exit code 0 or 1 and a report, or a refusal with its reason."""
    failures, count, refused, slowest = [], 0, 0, 0.0
    for path in sorted(corpus.rglob("*")):
        if path.suffix not in (".smurf", ".smurfs", ".smurfa", ".urdf", ".URDF", ".yml"):
            continue
        done, seconds = lint(tool, path)
        count, slowest = count + 1, max(slowest, seconds)
        if path.suffix == ".yml" and is_refused(done):
            refused += 1
            continue
        try:
            report = json.loads(done.stdout)
        except ValueError:
            report = None
        if done.returncode not in (0, 1) or report is None or seconds > SLOWEST:
            failures.append(f"{path}: exit {done.returncode}, {seconds:.1f} s")
    print(f"corpus: {count} files answered, {refused} of other programs, slowest {slowest:.2f} s, "
          f"{len(failures)} failures")
    return failures


def check_mutants(tool, scorer):
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([sys.executable, scorer, folder, tool], capture_output=True,
                              text=True, check=False)
    print("mutants found:", done.stdout.strip().splitlines()[-1] if done.stdout else done.stderr)
    if "NOISE" in done.stdout:
        return ["the clean base raises something: " + done.stdout]
    found = re.search(r"(\d+) of \d+$", done.stdout.strip())
    if not found or int(found[1]) < MUTANTS_EXPECTED:
        return [done.stdout]
    return []


def main():
    tool, shared = pathlib.Path(sys.argv[1]).absolute(), pathlib.Path(sys.argv[2])
    if not (shared / "corpus").is_dir():
        print("skipped: there is no folder of shared test data beside the project")
        sys.exit(77)
    failures = check_mutants(str(tool), shared / "mutants" / "mutants.py")
    failures += check_corpus(str(tool), shared / "corpus")
    sys.exit("\n".join(failures) or 0)


if __name__ == "__main__":
    main()
